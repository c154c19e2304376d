use super::sweep::{Operation, motions, same_length, sweep};
use crate::dispatch::Backend;
use crate::error::ShapeError;
use crate::place::{Place, Register, Step};
use dq8_simd::Level;

/// In which order the numbers of a matrix lie in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatrixOrder {
    /// Row after row: HLSL `row_major`, C arrays, `[[R; 4]; 3]` as used everywhere in this crate.
    Rows,
    /// Column after column: GLSL, WGSL, glam and nalgebra.
    Columns,
}

impl Backend {
    /// `matrices[i]` = [R | t] of unit σᵢ: 3×4 matrices for twelve numbers an element, 4×4 matrices,
    /// with the row 0 0 0 1, for sixteen.
    ///
    /// # Errors
    /// If the slices differ in length; `matrices` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, slices::MatrixOrder};
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
    pub fn matrices<P, M, const C: usize>(
        self,
        motions: &[P],
        order: MatrixOrder,
        matrices: &mut [M],
    ) -> Result<(), ShapeError>
    where
        P: Place<8>,
        M: Matrix<C, Layout = P::Layout>,
    {
        same_length("matrices", matrices.len(), motions.len())?;
        sweep(self, matrices, Matrices { motions, order });
        Ok(())
    }
}

/// A place of twelve or sixteen numbers.
pub trait Matrix<const C: usize>: Place<C> {}
impl<P: Place<12>> Matrix<12> for P {}
impl<P: Place<16>> Matrix<16> for P {}

struct Matrices<'s, P> {
    motions: &'s [P],
    order: MatrixOrder,
}

impl<P, M, const C: usize> Operation<M, C> for Matrices<'_, P>
where
    P: Place<8>,
    M: Matrix<C, Layout = P::Layout>,
{
    #[inline(always)]
    fn compute<V: Level>(&self, level: V, _: &[M], step: Step) -> Option<[Register<M, V, C>; C]> {
        let rows = motions(level, self.motions, step)?.to_matrix4();
        let mut numbers = [rows[3][0]; C];
        for (i, number) in numbers.iter_mut().enumerate() {
            let (row, column) = match self.order {
                MatrixOrder::Rows => (i / 4, i % 4),
                MatrixOrder::Columns => (i % (C / 4), i / (C / 4)),
            };
            *number = rows[row % 4][column % 4];
        }
        Some(numbers)
    }
}
