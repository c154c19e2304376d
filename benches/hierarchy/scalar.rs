//! The scalar reference, one product after the other.

use crate::representation::{Product, Representation, Rows};
use dq8::DualQuat;

impl Product for DualQuat<f32> {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        *self * *first
    }
}

impl Representation for DualQuat<f32> {
    fn from_motion(motion: &Self) -> Self {
        *motion
    }
    fn rows(&self) -> Rows {
        self.to_matrix3x4().map(|row| row.map(f64::from))
    }
}
