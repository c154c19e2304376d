use crate::batch;
use crate::number::Real;
use crate::scalar::{DualQuat, MatrixError};
use crate::storage::{Element, MatrixOrder, PaletteEntry};
use dq8_simd::Lanes;

/// A rigid matrix that is read: 3×4 (`C` = 12) or 4×4 (16), in the forms of a [`PaletteEntry`].
/// Sealed.
pub trait RigidMatrix<const C: usize>: PaletteEntry<C> {
    /// The motions of rigid matrices.
    #[doc(hidden)]
    fn motion<L: Lanes>(numbers: [L; C], order: MatrixOrder) -> batch::DualQuat<L>;
    /// The lanes whose matrix is no rigid motion.
    #[doc(hidden)]
    fn fails<L: Lanes>(numbers: [L; C], order: MatrixOrder, tolerance: L) -> L::Mask;
    /// The fault of one.
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
