//! The 4×4 matrix as plain rows.

use crate::representation::{Product, Representation, Rows};
use crate::rows::{Rows3x4, combination};
use dq8::{DualQuat, Real};

/// [R | t] and 0 0 0 1, rows.
#[derive(Clone, Copy)]
pub(crate) struct Rows4x4<T>([[T; 4]; 4]);

impl<T: Real> Product for Rows4x4<T> {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        Self(self.0.map(|row| combination(&row, &first.0)))
    }
}

impl<T: Real> Representation for Rows4x4<T> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        let [a, b, c] = Rows3x4::from_motion(motion).0;
        Self([a, b, c, [T::ZERO, T::ZERO, T::ZERO, T::ONE]])
    }
    fn rows(&self) -> Rows {
        [0, 1, 2].map(|row| self.0[row].map(Into::into))
    }
}
