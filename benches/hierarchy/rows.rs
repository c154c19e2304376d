//! Matrices as plain rows: the contender that needs no crate. 3×4 in `f64` is what all are checked
//! against, another algebra than that of dual quaternions.

use crate::representation::{Representation, Rows};
use dq8::{DualQuat, Real};

/// [R | t], rows.
#[derive(Clone, Copy)]
pub(crate) struct Rows3x4<T>([[T; 4]; 3]);

/// [R | t] and 0 0 0 1, rows.
#[derive(Clone, Copy)]
pub(crate) struct Rows4x4<T>([[T; 4]; 4]);

impl<T: Real> Representation for Rows3x4<T> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        let motion = DualQuat::from_array(motion.to_array().map(f64::from));
        Self(motion.to_matrix3x4().map(|row| row.map(T::from_f64)))
    }
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        Self(self.0.map(|row| {
            let mut sum = combination(&row, &first.0);
            sum[3] += row[3];
            sum
        }))
    }
    fn rows(&self) -> Rows {
        self.0.map(|row| row.map(Into::into))
    }
}

impl<T: Real> Representation for Rows4x4<T> {
    fn from_motion(motion: &DualQuat<f32>) -> Self {
        let [a, b, c] = Rows3x4::from_motion(motion).0;
        Self([a, b, c, [T::ZERO, T::ZERO, T::ZERO, T::ONE]])
    }
    #[inline(always)]
    fn product(&self, first: &Self) -> Self {
        Self(self.0.map(|row| combination(&row, &first.0)))
    }
    fn rows(&self) -> Rows {
        [0, 1, 2].map(|row| self.0[row].map(Into::into))
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
