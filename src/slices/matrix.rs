use super::sweep::{SliceKernel, motions, part, sweep};
use crate::dispatch::Backend;
use crate::palette_entry::{MatrixOrder, PaletteEntry};
use crate::shape::{ShapeError, same_length};
use crate::storage::{Element, Register, Tile};
use core::ops::Range;
use dq8_simd::Level;

impl Backend {
    /// `matrices[i]` = [R | t] of unit σᵢ: 3×4 matrices for twelve numbers per element, 4×4 matrices,
    /// with the row 0 0 0 1, for sixteen.
    ///
    /// # Errors
    /// If the slices differ in length; `matrices` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, hierarchy::MatrixOrder};
    /// let motions = [DualQuat::from_translation([7.0_f32, 8.0, 9.0]); 3];
    /// let mut rows = [[[0.0; 4]; 3]; 3];
    /// Backend::best().matrices(&motions, MatrixOrder::Rows, &mut rows)?;
    /// assert_eq!(rows[2], [[1.0, 0.0, 0.0, 7.0], [0.0, 1.0, 0.0, 8.0], [0.0, 0.0, 1.0, 9.0]]);
    /// let mut gpu = [[[0.0; 4]; 4]; 3];
    /// Backend::best().matrices(&motions, MatrixOrder::Columns, &mut gpu)?;
    /// assert_eq!(gpu[2][3], [7.0, 8.0, 9.0, 1.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn matrices<E, M, const C: usize>(
        self,
        motions: &[E],
        order: MatrixOrder,
        matrices: &mut [M],
    ) -> Result<(), ShapeError>
    where
        E: Element<8>,
        M: PaletteEntry<C, Layout = E::Layout>,
    {
        same_length("matrices", matrices.len(), motions.len())?;
        sweep(self, matrices, Matrices { motions, order });
        Ok(())
    }
}

struct Matrices<'s, E> {
    motions: &'s [E],
    order: MatrixOrder,
}

impl<E, M, const C: usize> SliceKernel<M, C> for Matrices<'_, E>
where
    E: Element<8>,
    M: PaletteEntry<C, Layout = E::Layout>,
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[M], tile: Tile) -> Option<[Register<M, V, C>; C]> {
        Some(M::of(motions(level, self.motions, tile)?, self.order))
    }
    fn part(&self, elements: Range<usize>) -> Self {
        Self { motions: part(self.motions, elements), order: self.order }
    }
}
