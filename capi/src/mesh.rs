//! Meshes in memory of the caller: arrays of vectors, or vertex buffers.

use crate::memory::{Input, Output};
use crate::skin::{Palettes, Posing};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use dq8::Scalar;
use dq8::skinning::{self, Blender, SkinningError, Surface, SurfaceMut, Weight};

/// A mesh at rest, with the memory for the posed mesh.
pub(crate) trait Mesh<R: Scalar + Weight> {
    /// Returns the number of vertices, as C has passed it.
    fn vertices(&self) -> usize;

    /// Poses the mesh by the skin and the palettes of `by`, which `blend` combines. Returns an
    /// error if an output overlaps another array.
    ///
    /// # Safety
    /// The arrays of the mesh must have the elements of all its vertices, the skin must be made and
    /// its arrays unchanged, and each palette must have as many elements as its count says. No
    /// other thread may use the outputs or write the inputs during the call.
    unsafe fn pose<'p, B: Blender<R>>(
        self,
        by: &Posing<R>,
        blend: impl FnOnce(Palettes<'p, R>) -> Result<B, SkinningError>,
    ) -> Done;
}

/// A mesh at rest and a posed mesh. Each is three arrays: positions, normals and tangents, with
/// three components for each vertex.
pub(crate) struct Arrays<R> {
    pub(crate) rest: [*const R; 3],
    pub(crate) posed: [*mut R; 3],
    pub(crate) vertices: usize,
}

/// The array of positions, normals or tangents at rest, and the array to which the posed vectors
/// are written.
type Field<R> = (Input<[R; 3]>, Output<[R; 3]>);

impl<R: Copy> Arrays<R> {
    fn field(&self, from: *const R, to: *mut R) -> Result<Field<R>, Status> {
        Ok((Input::new(from, self.vertices)?, Output::new(to, self.vertices)?))
    }

    /// Checks the two arrays of normals or tangents. Returns `None` if C passes null for both.
    fn optional(&self, from: *const R, to: *mut R) -> Result<Option<Field<R>>, Status> {
        if from.is_null() && to.is_null() {
            return Ok(None);
        }
        self.field(from, to).map(Some)
    }
}

impl<R: Scalar + Weight> Mesh<R> for Arrays<R> {
    fn vertices(&self) -> usize {
        self.vertices
    }

    unsafe fn pose<'p, B: Blender<R>>(
        self,
        by: &Posing<R>,
        blend: impl FnOnce(Palettes<'p, R>) -> Result<B, SkinningError>,
    ) -> Done {
        // C must pass positions, and may pass normals and tangents.
        let ([from, from_normals, from_tangents], [to, to_normals, to_tangents]) =
            (self.rest, self.posed);
        let positions = self.field(from, to)?;
        let normals = self.optional(from_normals, to_normals)?;
        let tangents = self.optional(from_tangents, to_tangents)?;
        let fields = [Some(&positions), normals.as_ref(), tangents.as_ref()];
        let from = fields.map(|field| field.map_or(Span::NOWHERE, |(from, _)| from.span));
        let to = fields.map(|field| field.map_or(Span::NOWHERE, |(_, to)| to.span));
        disjoint(&to, &from)?;
        disjoint(&to, &by.spans)?;
        // SAFETY: the caller guarantees that each array has the elements of all vertices, that the
        // arrays of the skin are unchanged, and that the palettes have their counts of elements.
        // `disjoint` has checked that no output overlaps another array.
        unsafe {
            let (skin, palettes) = by.borrow();
            let rest = Surface {
                positions: positions.0.slice(),
                normals: normals.as_ref().map(|(from, _)| from.slice()),
                tangents: tangents.as_ref().map(|(from, _)| from.slice()),
            };
            let posed = SurfaceMut {
                positions: positions.1.slice(),
                normals: normals.as_ref().map(|(_, to)| to.slice()),
                tangents: tangents.as_ref().map(|(_, to)| to.slice()),
            };
            Ok(skin.pose(blend(palettes)?, rest, posed)?)
        }
    }
}

/// The layout of a vertex buffer, which holds one vertex after the other. All fields of this struct
/// count elements, that is, floats or doubles, and not bytes. A position, a normal or a tangent has
/// three components.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct VertexFields {
    /// The distance from the beginning of a vertex to the beginning of the next vertex.
    pub stride: usize,
    /// The offset of the position in a vertex.
    pub position: i32,
    /// The offset of the normal in a vertex, or -1 to pose no normals.
    pub normal: i32,
    /// The offset of the tangent in a vertex, or -1 to pose no tangents. A fourth component, the
    /// sign of the bitangent, does not belong to the tangent and is not written.
    pub tangent: i32,
}

impl VertexFields {
    fn known(self) -> Result<skinning::VertexFields, Status> {
        let at = |first: i32| usize::try_from(first).map_err(|_| Status::Field);
        let optional = |first| if first == -1 { Ok(None) } else { at(first).map(Some) };
        let Self { stride, position, normal, tangent } = self;
        let (normal, tangent) = (optional(normal)?, optional(tangent)?);
        Ok(skinning::VertexFields { stride, position: at(position)?, normal, tangent })
    }
}

/// A mesh as a vertex buffer (`rest`, with the layout `from`), and the buffer for the posed mesh
/// (`posed`, with the layout `to`).
pub(crate) struct Records<R> {
    pub(crate) rest: *const R,
    pub(crate) from: VertexFields,
    pub(crate) posed: *mut R,
    pub(crate) to: VertexFields,
    pub(crate) vertices: usize,
}

impl<R: Scalar + Weight> Mesh<R> for Records<R> {
    fn vertices(&self) -> usize {
        self.vertices
    }

    unsafe fn pose<'p, B: Blender<R>>(
        self,
        by: &Posing<R>,
        blend: impl FnOnce(Palettes<'p, R>) -> Result<B, SkinningError>,
    ) -> Done {
        let (from, to) = (self.from.known()?, self.to.known()?);
        let numbers = |stride| self.vertices.checked_mul(stride).ok_or(Status::TooLarge);
        let rest = Input::<R>::new(self.rest, numbers(from.stride)?)?;
        let posed = Output::<R>::new(self.posed, numbers(to.stride)?)?;
        disjoint(&[posed.span], &[rest.span])?;
        disjoint(&[posed.span], &by.spans)?;
        // SAFETY: the caller guarantees that each buffer has `stride` elements per vertex, that the
        // arrays of the skin are unchanged, and that the palettes have their counts of elements.
        // `disjoint` has checked that the output overlaps no input.
        unsafe {
            let (skin, palettes) = by.borrow();
            let (rest, posed) = ((rest.slice(), from), (posed.slice(), to));
            Ok(skin.job().pose_interleaved(blend(palettes)?, rest, posed)?)
        }
    }
}
