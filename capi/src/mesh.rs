//! Meshes in C's memory: arrays of vectors, or vertices that are records of several fields.

use crate::memory::{Input, Output};
use crate::skin::{Palettes, Posing};
use crate::span::{Span, apart};
use crate::status::{Done, Status};
use dq8::Scalar;
use dq8::skinning::{self, Blender, SkinningError, Surface, SurfaceMut, Weight};

/// A mesh at rest and where it goes when posed.
pub(crate) trait Mesh<R: Scalar + Weight> {
    /// How many vertices C says it has.
    fn vertices(&self) -> usize;

    /// Poses it, if nothing that is written lies in anything that is read, or twice.
    ///
    /// # Safety
    /// As for [`Posing::borrow`], [`Input::slice`] and [`Output::slice`].
    unsafe fn pose<'p, B: Blender<R>>(
        self,
        by: &Posing<R>,
        blend: impl FnOnce(Palettes<'p, R>) -> Result<B, SkinningError>,
    ) -> Done;
}

/// Positions, normals, tangents, three numbers each.
pub(crate) struct Arrays<R> {
    pub(crate) rest: [*const R; 3],
    pub(crate) posed: [*mut R; 3],
    pub(crate) vertices: usize,
}

/// Vectors at rest and posed.
type Field<R> = (Input<[R; 3]>, Output<[R; 3]>);

impl<R: Copy> Arrays<R> {
    fn field(&self, from: *const R, to: *mut R) -> Result<Field<R>, Status> {
        Ok((Input::new(from, self.vertices)?, Output::new(to, self.vertices)?))
    }

    /// None where C passes null for both.
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
        // Only positions must be there.
        let ([from, from_normals, from_tangents], [to, to_normals, to_tangents]) =
            (self.rest, self.posed);
        let positions = self.field(from, to)?;
        let normals = self.optional(from_normals, to_normals)?;
        let tangents = self.optional(from_tangents, to_tangents)?;
        let fields = [Some(&positions), normals.as_ref(), tangents.as_ref()];
        let from = fields.map(|field| field.map_or(Span::NOWHERE, |(from, _)| from.span));
        let to = fields.map(|field| field.map_or(Span::NOWHERE, |(_, to)| to.span));
        apart(&to, &from)?;
        apart(&to, &by.spans)?;
        // SAFETY: promised, and all that is written is apart.
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

/// Where the fields of a vertex lie in a buffer that holds one vertex after the other, all counted
/// in numbers. A field is three numbers.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct VertexFields {
    /// From a vertex to the next.
    pub stride: usize,
    /// Where in a vertex its position begins.
    pub position: i32,
    /// Where its normal begins; -1 if none is posed.
    pub normal: i32,
    /// Where its tangent begins, without the sign of the bitangent; -1 if none is posed.
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

/// Two buffers of vertices.
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
        apart(&[posed.span], &[rest.span])?;
        apart(&[posed.span], &by.spans)?;
        // SAFETY: promised, and what is written is apart.
        unsafe {
            let (skin, palettes) = by.borrow();
            let (rest, posed) = ((rest.slice(), from), (posed.slice(), to));
            Ok(skin.job().pose_interleaved(blend(palettes)?, rest, posed)?)
        }
    }
}
