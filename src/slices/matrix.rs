//! Kernels that turn motions into matrices and matrices into motions.

use super::sweep::{SliceKernel, Things, sweep};
use crate::backend::{Backend, Kernel};
use crate::batch;
use crate::macros::errors;
use crate::number::Real;
use crate::scalar::{DualQuat, MatrixError};
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{self, Element, Layout, Number, Register, Tile};
use crate::storage::{MatrixOrder, PaletteEntry, motions};
use core::ops::Range;
use dq8_simd::{Lanes, Level, Mask};

errors! {
    /// The error of matrices that are no rigid motions, or of slices whose lengths differ. Nothing
    /// has been written.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    MatricesError {
        /// The slices differ in length.
        Shape(error: ShapeError) => "{error}";
        /// A matrix is not that of a rigid motion.
        NotRigid {
            /// The index of the first such matrix; in blocks, the lanes of each block are counted
            /// before those of the next.
            index: usize,
            /// The reason why the matrix is not rigid.
            error: MatrixError,
        } => "matrix {index}: {error}";
    }
}

impl Backend {
    /// Computes the matrix [R | t] of each unit motion. Elements of twelve components become 3×4
    /// matrices; elements of sixteen become 4×4 matrices, whose last row is 0 0 0 1. See
    /// [`DualQuat::to_matrix3x4`](crate::DualQuat::to_matrix3x4) and
    /// [`DualQuat::to_matrix4`](crate::DualQuat::to_matrix4).
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

    /// Computes the motion whose quaternion has w ≥ 0, for each matrix that is known to be rigid
    /// ([`DualQuat::from_matrix3x4`](crate::DualQuat::from_matrix3x4)). Matrices that are not rigid
    /// give motions without a meaning. Elements of twelve components are 3×4 matrices; elements of
    /// sixteen are 4×4 matrices, whose last row is not read.
    ///
    /// # Errors
    /// If the slices differ in length; `motions` is untouched.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, hierarchy::MatrixOrder};
    /// let rows = [[[1.0_f32, 0.0, 0.0, 7.0], [0.0, 1.0, 0.0, 8.0], [0.0, 0.0, 1.0, 9.0]]; 3];
    /// let mut motions = [DualQuat::IDENTITY; 3];
    /// Backend::best().from_matrices(&rows, MatrixOrder::Rows, &mut motions)?;
    /// assert_eq!(motions[2].translation(), [7.0, 8.0, 9.0]);
    /// # Ok::<(), dq8::ShapeError>(())
    /// ```
    #[inline]
    pub fn from_matrices<M, E, const C: usize>(
        self,
        matrices: &[M],
        order: MatrixOrder,
        motions: &mut [E],
    ) -> Result<(), ShapeError>
    where
        M: RigidMatrix<C>,
        E: Element<8, Layout = M::Layout>,
    {
        same_length("motions", motions.len(), matrices.len())?;
        sweep(self, motions, FromMatrices::<M, C> { matrices, order });
        Ok(())
    }

    /// Computes the motion whose quaternion has w ≥ 0, for each matrix, and checks that the
    /// matrix is rigid, as [`DualQuat::try_from_matrix3x4`](crate::DualQuat::try_from_matrix3x4)
    /// and [`DualQuat::try_from_matrix4`](crate::DualQuat::try_from_matrix4) do.
    ///
    /// # Errors
    /// If the slices differ in length, or a matrix is further than `tolerance` from a rigid one;
    /// the error has the index of the first such matrix. All matrices are checked before any motion
    /// is written.
    ///
    /// ```
    /// use dq8::{Backend, DualQuat, hierarchy::MatrixOrder};
    /// let one = DualQuat::<f32>::IDENTITY.to_cols_array_2d();
    /// let mut doubled = one;
    /// doubled[0][0] = 2.0;
    /// let mut motions = [DualQuat::IDENTITY; 2];
    /// let (columns, matrices) = (MatrixOrder::Columns, [one, doubled]);
    /// let answer = Backend::best().try_from_matrices(&matrices, columns, 1e-5, &mut motions);
    /// assert!(answer.unwrap_err().to_string().starts_with("matrix 1: not a rotation"));
    /// ```
    #[inline]
    pub fn try_from_matrices<M, E, const C: usize>(
        self,
        matrices: &[M],
        order: MatrixOrder,
        tolerance: Number<M, C>,
        motions: &mut [E],
    ) -> Result<(), MatricesError>
    where
        M: RigidMatrix<C>,
        E: Element<8, Layout = M::Layout>,
    {
        same_length("motions", motions.len(), matrices.len())?;
        match self.run(Check { matrices, order, tolerance }) {
            Some((index, error)) => Err(MatricesError::NotRigid { index, error }),
            None => Ok(self.from_matrices(matrices, order, motions)?),
        }
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
    fn compute<V: Level>(&self, level: V, _: &[M], tile: Tile) -> Things<M, V, C> {
        Some(M::of(motions(level, self.motions, tile)?, self.order))
    }
    fn part(&self, elements: Range<usize>) -> Option<Self> {
        Some(Self { motions: self.motions.get(elements)?, order: self.order })
    }
}

struct FromMatrices<'s, M, const C: usize> {
    matrices: &'s [M],
    order: MatrixOrder,
}

impl<E, M, const C: usize> SliceKernel<E, 8> for FromMatrices<'_, M, C>
where
    M: RigidMatrix<C>,
    E: Element<8, Layout = M::Layout>,
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn compute<V: Level>(&self, level: V, _: &[E], tile: Tile) -> Things<E, V, 8> {
        let numbers = M::load(level, self.matrices, tile, &storage::identity())?;
        Some(M::motion(numbers, self.order).to_array())
    }
    fn part(&self, elements: Range<usize>) -> Option<Self> {
        Some(Self { matrices: self.matrices.get(elements)?, order: self.order })
    }
}

/// The search for the first matrix that is not rigid. Lanes find the tile that has such a matrix;
/// [`one_by_one`] then checks the matrices of that tile again, and returns the index and the
/// reason.
struct Check<'s, M: RigidMatrix<C>, const C: usize> {
    matrices: &'s [M],
    order: MatrixOrder,
    tolerance: Number<M, C>,
}

impl<M: RigidMatrix<C>, const C: usize> Kernel for Check<'_, M, C> {
    type Output = Option<(usize, MatrixError)>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) -> Self::Output {
        let Self { matrices, order, tolerance } = self;
        let lanes = Register::<M, V, C>::LANES;
        for tile in storage::tiles::<M, V, C>(matrices.len()) {
            let numbers = M::load(level, matrices, tile, &storage::identity())?;
            if M::fails(numbers, order, Lanes::splat(level, tolerance)).any() {
                let first = tile.element * M::Layout::THINGS + tile.register * lanes;
                let found = one_by_one(matrices, order, tolerance, first..first + lanes);
                if found.is_some() {
                    return found;
                }
            }
        }
        None
    }
}

#[cold]
#[inline(never)]
fn one_by_one<M: RigidMatrix<C>, const C: usize>(
    matrices: &[M],
    order: MatrixOrder,
    tolerance: Number<M, C>,
    things: Range<usize>,
) -> Option<(usize, MatrixError)> {
    let wrong = |index| Some((index, M::wrong(M::get(matrices, index)?, order, tolerance)?));
    things.into_iter().find_map(wrong)
}

/// A rigid matrix that a kernel reads: 3×4 (`C` = 12) or 4×4 (`C` = 16), in the forms of a
/// [`PaletteEntry`]. Sealed.
pub trait RigidMatrix<const C: usize>: PaletteEntry<C> {
    /// Computes the motions of rigid matrices, one in each lane.
    #[doc(hidden)]
    fn motion<L: Lanes>(numbers: [L; C], order: MatrixOrder) -> batch::DualQuat<L>;
    /// Returns a mask that is true in lanes whose matrix is further than `tolerance` from a rigid
    /// one.
    #[doc(hidden)]
    fn fails<L: Lanes>(numbers: [L; C], order: MatrixOrder, tolerance: L) -> L::Mask;
    /// Returns the reason why a matrix is not rigid, `None` if it is rigid.
    #[doc(hidden)]
    fn wrong<R: Real>(numbers: [R; C], order: MatrixOrder, tolerance: R) -> Option<MatrixError>;
}

impl<E: Element<12>> RigidMatrix<12> for E {
    #[inline(always)]
    fn motion<L: Lanes>(numbers: [L; 12], order: MatrixOrder) -> batch::DualQuat<L> {
        batch::DualQuat::from_matrix3x4(three_rows(numbers, order))
    }
    #[inline(always)]
    fn fails<L: Lanes>(numbers: [L; 12], order: MatrixOrder, tolerance: L) -> L::Mask {
        batch::DualQuat::from_matrix3x4_checked(three_rows(numbers, order), tolerance).1
    }
    fn wrong<R: Real>(numbers: [R; 12], order: MatrixOrder, tolerance: R) -> Option<MatrixError> {
        DualQuat::try_from_matrix3x4(three_rows(numbers, order), tolerance).err()
    }
}

impl<E: Element<16>> RigidMatrix<16> for E {
    #[inline(always)]
    fn motion<L: Lanes>(numbers: [L; 16], order: MatrixOrder) -> batch::DualQuat<L> {
        let [a, b, c, _] = four_rows(numbers, order);
        batch::DualQuat::from_matrix3x4([a, b, c])
    }
    #[inline(always)]
    fn fails<L: Lanes>(numbers: [L; 16], order: MatrixOrder, tolerance: L) -> L::Mask {
        batch::DualQuat::from_matrix4_checked(four_rows(numbers, order), tolerance).1
    }
    fn wrong<R: Real>(numbers: [R; 16], order: MatrixOrder, tolerance: R) -> Option<MatrixError> {
        DualQuat::try_from_matrix4(four_rows(numbers, order), tolerance).err()
    }
}

#[inline(always)]
fn three_rows<L>(numbers: [L; 12], order: MatrixOrder) -> [[L; 4]; 3] {
    let [a, b, c, d, e, f, g, h, i, j, k, l] = numbers;
    match order {
        MatrixOrder::Rows => [[a, b, c, d], [e, f, g, h], [i, j, k, l]],
        MatrixOrder::Columns => [[a, d, g, j], [b, e, h, k], [c, f, i, l]],
    }
}

#[inline(always)]
fn four_rows<L>(numbers: [L; 16], order: MatrixOrder) -> [[L; 4]; 4] {
    let [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = numbers;
    match order {
        MatrixOrder::Rows => [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]],
        MatrixOrder::Columns => [[a, e, i, m], [b, f, j, n], [c, g, k, o], [d, h, l, p]],
    }
}
