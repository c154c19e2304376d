//! Damped least squares of a size that is known at run time.

use super::model::Model;
use crate::real::Scalar;
use dq8_simd::{Float, Lanes};

/// The distance from 1 to the next larger number.
#[cfg_attr(not(opt_level_0), inline(always))]
fn epsilon<L: Lanes>() -> f64 {
    if L::Real::SINGLE { f64::from(f32::EPSILON) } else { f64::EPSILON }
}

/// A λ² that is none, but not zero.
const FLOOR: f64 = 1e-30;

impl<L: Lanes<Real: Scalar>> Model<'_, L> {
    /// y with (JJᵀ + λ²1) y = e, so that Jᵀy is the x that makes |Jx − e|² + λ²|x|² least (Nakamura & Hanafusa
    /// 1986; Wampler 1986; Buss 2004, eq. 11); held columns are zero. y takes the place of e in `solution`.
    ///
    /// By Cholesky's factorisation in place, as for arms: to λ² is added what rounding makes of JJᵀ, and
    /// each pivot is at least λ².
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve_normal(&mut self, damping: L) {
        let (level, rows) = (self.level, self.reach.rows);
        let scratch = &mut self.scratch;
        let (columns, a) = (&scratch.columns, &mut scratch.triangle);
        let zero = damping.constant(0.0);
        // Made once: it divides.
        let runs = columns.runs(rows);
        let (mut trace, mut at) = (zero, 0);
        for i in 0..rows {
            for j in 0..=i {
                let mut sum = zero;
                for column in runs.clone() {
                    if let (Some(x), Some(y)) = (column.get(i), column.get(j)) {
                        sum = L::load(level, x).mul_add(L::load(level, y), sum);
                    }
                }
                a.set(at, sum);
                at += 1;
                if i == j {
                    trace = trace + sum;
                }
            }
        }
        // Where nothing moves anything, nothing is asked of it.
        let floor = damping + damping.constant(FLOOR);
        let least = trace.mul_add(damping.constant(0.25 * epsilon::<L>()), floor);
        let (reciprocals, y) = (&mut scratch.reciprocals, &mut scratch.solution);
        for i in 0..rows {
            let of_i = i * (i + 1) / 2;
            let mut pivot = a.get(level, of_i + i) + least;
            let mut solved = y.get(level, i);
            for j in 0..i {
                let of_j = j * (j + 1) / 2;
                let mut sum = a.get(level, of_i + j);
                for k in 0..j {
                    sum = a.get(level, of_i + k).neg_mul_add(a.get(level, of_j + k), sum);
                }
                let factor = sum * reciprocals.get(level, j);
                a.set(of_i + j, factor);
                pivot = factor.neg_mul_add(factor, pivot);
                solved = factor.neg_mul_add(y.get(level, j), solved);
            }
            let pivot = L::select(pivot.lt(least), least, pivot);
            let reciprocal = zero.constant(1.0) / pivot.sqrt();
            reciprocals.set(i, reciprocal);
            y.set(i, solved * reciprocal);
        }
        for i in (0..rows).rev() {
            let mut solved = y.get(level, i);
            for k in i + 1..rows {
                solved = a.get(level, k * (k + 1) / 2 + i).neg_mul_add(y.get(level, k), solved);
            }
            y.set(i, solved * reciprocals.get(level, i));
        }
    }
}
