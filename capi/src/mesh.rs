//! Meshes in C's memory: arrays of vectors, or vertex buffers.

use crate::memory::{Input, Output};
use crate::skin::{Palettes, Posing};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use dq8::Scalar;
use dq8::skinning::{self, Blender, SkinningError, Surface, SurfaceMut, Weight};

/// A mesh at rest, and the memory for the posed mesh.
pub(crate) trait Mesh<R: Scalar + Weight> {
    /// The number of vertices that C passes.
    fn vertices(&self) -> usize;

    /// Poses the mesh. It is an error if an output overlaps anything.
    ///
    /// # Safety
    /// The caller must keep the conditions of [`Posing::borrow`], [`Input::slice`] and
    /// [`Output::slice`].
    unsafe fn pose<'p, B: Blender<R>>(
        self,
        by: &Posing<R>,
        blend: impl FnOnce(Palettes<'p, R>) -> Result<B, SkinningError>,
    ) -> Done;
}

/// A mesh as arrays of positions, normals and tangents, of three numbers each.
pub(crate) struct Arrays<R> {
    pub(crate) rest: [*const R; 3],
    pub(crate) posed: [*mut R; 3],
    pub(crate) vertices: usize,
}

/// The vectors of a field at rest, and the memory for the posed ones.
type Field<R> = (Input<[R; 3]>, Output<[R; 3]>);

impl<R: Copy> Arrays<R> {
    fn field(&self, from: *const R, to: *mut R) -> Result<Field<R>, Status> {
        Ok((Input::new(from, self.vertices)?, Output::new(to, self.vertices)?))
    }

    /// A field, or `None` if C passes null for both pointers.
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
        // Positions are required, normals and tangents are not.
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
        // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked
        // to overlap nothing.
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
/// count numbers. A position, a normal or a tangent is three numbers.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct VertexFields {
    /// The distance from the beginning of a vertex to that of the next.
    pub stride: usize,
    /// The offset of the position in a vertex.
    pub position: i32,
    /// The offset of the normal in a vertex, or -1 to pose no normals.
    pub normal: i32,
    /// The offset of the tangent in a vertex, or -1 to pose no tangents. A fourth number, the sign
    /// of the bitangent, is no part of it.
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

/// A mesh as a vertex buffer, and the buffer for the posed mesh.
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
        // SAFETY: the caller guarantees that the memory is valid, and the output has been checked
        // to overlap nothing.
        unsafe {
            let (skin, palettes) = by.borrow();
            let (rest, posed) = ((rest.slice(), from), (posed.slice(), to));
            Ok(skin.job().pose_interleaved(blend(palettes)?, rest, posed)?)
        }
    }
}
