//! Damped least squares of a size that is known at run time.

use super::model::Model;
use super::scratch::{Rows, Scratch};
use dq8::Scalar;
use dq8::batch::vector::epsilon;
use dq8_simd::Lanes;

/// A λ² that is none, but not zero.
pub(super) const FLOOR: f64 = 1e-30;

/// Those of a pose, for which the compiler lays all of it out.
const POSE: usize = 6;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// y with (JJᵀ + λ²1) y = e, so that Jᵀy is the x that makes |Jx − e|² + λ²|x|²
    /// least (Nakamura & Hanafusa 1986; Wampler 1986; Buss 2004, eq. 11); held columns are zero. y
    /// takes the place of e in `solution`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve_normal(&mut self, damping: L) {
        let (level, rows, scratch) = (self.level, self.reach.facts.rows, &mut self.scratch);
        let none = damping.constant(0.0).to_array();
        // One pose is what most ask for: its triangle has 21 numbers, which stay on the stack, and
        // loops of known length. Machine code for one lane would be as long, to gain little:
        // without std, where memory is short, it is left out.
        if (L::LANES > 1 || cfg!(feature = "std")) && rows == POSE {
            let (mut a, mut b, mut c) = ([none; POSE * (POSE + 1) / 2], [none; POSE], [none; POSE]);
            let (mut triangle, mut reciprocals, mut y) = (Rows(&mut a), Rows(&mut b), Rows(&mut c));
            for row in 0..POSE {
                y.set(row, scratch.solution.get(level, row));
            }
            multiply(&scratch.columns, &mut triangle, level, POSE);
            solve(&mut triangle, &mut reciprocals, &mut y, damping, POSE);
            for row in 0..POSE {
                scratch.solution.set(row, y.get(level, row));
            }
        } else {
            let Scratch { columns, triangle, reciprocals, solution, .. } = scratch;
            multiply(columns, triangle, level, rows);
            solve(triangle, reciprocals, solution, damping, rows);
        }
    }
}

/// JJᵀ
#[cfg_attr(not(opt_level_0), inline(always))]
fn multiply<L: Lanes<Real: Scalar>>(
    columns: &Rows<'_, L>,
    a: &mut Rows<'_, L>,
    level: L::Level,
    rows: usize,
) {
    a.fill(L::splat(level, L::Real::default()));
    for column in columns.runs(rows) {
        let mut at = 0;
        for i in 0..rows {
            for j in 0..=i {
                if let (Some(x), Some(y)) = (column.get(i), column.get(j)) {
                    let (x, y) = (L::load(level, x), L::load(level, y));
                    a.set(at, x.mul_add(y, a.get(level, at)));
                }
                at += 1;
            }
        }
    }
}

/// By Cholesky's factorisation in place: to λ² is added what rounding makes of JJᵀ, so that a
/// singular J is not a special case; and each pivot is at least λ², as it would be without
/// rounding.
#[cfg_attr(not(opt_level_0), inline(always))]
fn solve<L: Lanes<Real: Scalar>>(
    a: &mut Rows<'_, L>,
    reciprocals: &mut Rows<'_, L>,
    y: &mut Rows<'_, L>,
    damping: L,
    rows: usize,
) {
    let level = damping.level();
    let mut trace = damping.constant(0.0);
    for i in 0..rows {
        trace = trace + a.get(level, i * (i + 1) / 2 + i);
    }
    // Where nothing moves anything, nothing is asked of it.
    let floor = damping + damping.constant(FLOOR);
    let least = trace.mul_add(damping.constant(0.25 * epsilon::<L>()), floor);
    // Row by row: A = LLᵀ and Lz = y at once, z in the place of y. Pivots are kept as reciprocals
    // of their roots.
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
        let reciprocal = damping.constant(1.0) / pivot.sqrt();
        reciprocals.set(i, reciprocal);
        y.set(i, solved * reciprocal);
    }
    // Lᵀy = z, from the last row up.
    for i in (0..rows).rev() {
        let mut solved = y.get(level, i);
        for k in i + 1..rows {
            solved = a.get(level, k * (k + 1) / 2 + i).neg_mul_add(y.get(level, k), solved);
        }
        y.set(i, solved * reciprocals.get(level, i));
    }
}
