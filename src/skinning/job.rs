use super::SkinningError;
use super::blender::Blender;
use super::interleaved::{self, Interleaved, VertexFields};
use super::mesh::Separate;
use super::run::{check, pose};
use super::skin::Skin;
use super::surface::{Surface, SurfaceMut};
use super::weight::Weight;
#[cfg(doc)]
use super::{DualBlend, Linear, Mixed, StretchedDualBlend};
use crate::backend::Choice;
use crate::brief::brief;
use crate::number::Scalar;
use crate::storage::{Element, Number};
use dq8_simd::internal::Index;

/// A run that poses the mesh of a [`Skin`], with options that all have a default.
///
/// ```
/// use dq8::skinning::{DualBlend, Skin, Surface, SurfaceMut};
/// use dq8::{Backend, DualQuat};
/// let skin = Skin::new(2, 2, &[0_u8, 1, 0, 1], &[1.0_f32, 0.0, 0.25, 0.75])?;
/// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
/// let (rest, mut posed) = ([[1.0, 2.0, 3.0]; 2], [[0.0; 3]; 2]);
/// let (from, to) = (Surface::positions(&rest), SurfaceMut::positions(&mut posed));
/// skin.job().backend(Backend::PORTABLE).pose(DualBlend::new(&palette), from, to)?;
/// assert_eq!(posed, [[1.0, 2.0, 3.0], [1.0, 2.0, 6.0]]);
/// # Ok::<(), dq8::skinning::SkinningError>(())
/// ```
#[derive(Clone, Copy)]
#[must_use]
pub struct Job<'s, J, W> {
    skin: Skin<'s, J, W>,
    choice: Choice,
}

brief!([J: Index, W: Weight] Job<'_, J, W>: Job |it| { skin: it.skin, choice: it.choice });

impl<'s, J: Index, W: Weight> Skin<'s, J, W> {
    /// Poses a mesh: each vertex moves by the blend of the motions of its joints, [`Linear`],
    /// [`DualBlend`], [`StretchedDualBlend`] or a mix of those ([`Mixed`]). Positions, and normals
    /// and tangents where `rest` has them, in plain slices or blocks; see
    /// [`skinning`](crate::skinning).
    ///
    /// # Errors
    /// If the slices, the palette and the skin do not fit each other; `posed` is untouched.
    #[inline]
    pub fn pose<B: Blender<Number<P, 3>>, P: Element<3>>(
        &self,
        blend: B,
        rest: Surface<'_, P>,
        posed: SurfaceMut<'_, P>,
    ) -> Result<(), SkinningError> {
        self.job().pose(blend, rest, posed)
    }

    /// A run with options.
    pub fn job(&self) -> Job<'s, J, W> {
        Job { skin: *self, choice: Choice::default() }
    }
}

impl<J: Index, W: Weight> Job<'_, J, W> {
    crate::backend::options!();

    /// Poses a mesh: [`Skin::pose`].
    ///
    /// # Errors
    /// If the slices, the palette and the skin do not fit each other; `posed` is untouched.
    #[inline]
    pub fn pose<B: Blender<Number<P, 3>>, P: Element<3>>(
        &self,
        blend: B,
        rest: Surface<'_, P>,
        posed: SurfaceMut<'_, P>,
    ) -> Result<(), SkinningError> {
        check(&self.skin, &blend, &rest, &posed)?;
        pose::<J, W, B, P, _>(
            self.choice.instructions(),
            &self.skin,
            blend,
            Separate { rest, posed },
        );
        Ok(())
    }

    /// [`pose`](Self::pose) of vertices that are records of several fields, such as the vertex
    /// buffer of a GPU: `rest` and `posed` hold the numbers of one vertex after those of another,
    /// and the two [`VertexFields`] say where its position is, and its normal and tangent.
    /// Everything else in `posed` is left alone.
    ///
    /// A slice of a user's own vertices is one of numbers by `bytemuck::cast_slice`, whatever
    /// fields of other types of the same size it has.
    ///
    /// # Errors
    /// If a field lies beyond its vertex or in another one, not both buffers have the same fields,
    /// or the buffers, the palette and the skin do not fit each other; `posed` is untouched.
    ///
    /// ```
    /// use dq8::skinning::{DualBlend, Skin, VertexFields};
    /// use dq8::DualQuat;
    /// let skin = Skin::new(2, 1, &[0_u8, 1], &[1.0_f32, 1.0])?;
    /// let palette = [DualQuat::IDENTITY, DualQuat::from_translation([0.0_f32, 0.0, 4.0])];
    /// // Positions and texture coordinates.
    /// let rest = [1.0, 2.0, 3.0, 0.5, 0.5, 1.0, 2.0, 3.0, 0.1, 0.9];
    /// let (fields, mut posed) = (VertexFields::positions(5), rest);
    /// skin.job().pose_interleaved(DualBlend::new(&palette), (&rest, fields), (&mut posed, fields))?;
    /// assert_eq!(posed, [1.0, 2.0, 3.0, 0.5, 0.5, 1.0, 2.0, 7.0, 0.1, 0.9]);
    /// # Ok::<(), dq8::skinning::SkinningError>(())
    /// ```
    pub fn pose_interleaved<B: Blender<R>, R: Scalar>(
        &self,
        blend: B,
        (rest, from): (&[R], VertexFields),
        (posed, to): (&mut [R], VertexFields),
    ) -> Result<(), SkinningError> {
        let mesh = Interleaved { rest, from, posed, to };
        interleaved::check(&self.skin, &blend, &mesh)?;
        pose::<J, W, B, [R; 3], _>(self.choice.instructions(), &self.skin, blend, mesh);
        Ok(())
    }
}
