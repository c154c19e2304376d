//! Matrices as plain rows, which need no crate. In `f64` they are what all contenders are checked
//! against: another algebra than that of dual quaternions.

use super::{Product, Representation, Rows};
use dq8::{DualQuat, Real};

/// [R | t], rows.
#[derive(Clone, Copy)]
pub struct Rows3x4<T>(pub [[T; 4]; 3]);

impl<T: Real> Product for Rows3x4<T> {
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        Self(self.0.map(|row| {
            let mut sum = combination(&row, &first.0);
            sum[3] += row[3];
            sum
        }))
    }
}

impl<T: Real> Representation for Rows3x4<T> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        Self(motion.cast::<f64>().to_matrix3x4().map(|row| row.map(T::from_f64)))
    }
    fn rows(&self) -> Rows {
        self.0.map(|row| row.map(Into::into))
    }
}

/// Σ factor · row: whole rows, which the compiler turns into vectors without shuffles.
#[inline(always)]
fn combination<T: Real>(factors: &[T; 4], rows: &[[T; 4]]) -> [T; 4] {
    let mut sum = [T::ZERO; 4];
    for (&factor, row) in factors.iter().zip(rows) {
        for (component, &term) in sum.iter_mut().zip(row) {
            *component += factor * term;
        }
    }
    sum
}
