//! A step toward the targets, within the limits of the joints.
//!
//! Damped least squares give the change of all freedoms at once. A freedom that would pass its
//! limit goes to the limit and is *held* there: its contribution is subtracted from the errors, its
//! column becomes zero, and the system is solved again for the other freedoms (Baerlocher & Boulic
//! 2004). So the other freedoms make up for the limit, whereas clipping the result would move the
//! link in a wrong direction. Each round holds at least one more freedom in some lane:
//!
//! ```text
//! residual = e
//! repeat
//!     d = Jᵀ (J Jᵀ + λ²)⁻¹ residual          # of the freedoms that are not held
//!     for each freedom i that passes its limit
//!         d[i] = the way to the limit;  residual −= J[i] d[i];  J[i] = 0;  hold i
//! until no freedom passed its limit
//! ```
//!
//! Slides and hinges share the system, because everything in it is in radians: rows that are
//! lengths are divided by the length that weighs as much as a radian, and columns of slides are
//! multiplied by it.
//!
//! A posture uses the freedom that the goals leave. If z is the step toward the posture, the change
//! is z + J⁺(e − Jz), where J⁺ is the damped inverse Jᵀ (J Jᵀ + λ²)⁻¹.
//!
//! The solver of the dense normal equations, whose size is known only at run time, is at the end of
//! the file.

use super::freedom::{Freedom, Kind};
use super::model::{Decisions, Model, PoseErrors, StepResult};
use super::scratch::{Registers, Scratch};
use crate::mechanism::values::checked_cos_sin;
use dq8::Scalar;
use dq8::batch::vector::epsilon;
use dq8::batch::{Quat, vector};
use dq8_simd::{Lanes, Mask};

/// λ² of the damped least squares, as a part of the squared error: λ² = μ|e|² (Sugihara,
/// *Solvability-Unconcerned Inverse Kinematics by the Levenberg–Marquardt Method*, 2011). So
/// steps are damped far from the target, where the linear model is wrong, and if the target is out
/// of reach, but not near the solution. Sugihara's μ is ½; with steps of second order, all values
/// from 0.01 to 0.05 are equally good, and better than ½.
const DAMPING: f64 = 0.02;
/// The factor μ in searches that track without weights for posture or start. It multiplies the
/// mean squared error over the goals, and has Sugihara's value ½, with which the few steps of such
/// a search converge also if a target is out of reach.
const TRACK_DAMPING: f64 = 0.5;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Computes a step, and applies it in the lanes that are `running`. Lanes at their targets also
    /// move toward the posture.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn step(&mut self, errors: PoseErrors<L>, decisions: Decisions<L>) -> StepResult<L> {
        let Decisions { damping_factor, running, arrived, may_restart } = decisions;
        let has_weights = self.has_weights();
        let mut square = errors.square;
        let mut part = damping_factor.constant(DAMPING);
        if TRACK && !has_weights {
            // The damping uses the error to the target itself, even if a nearer point replaces a
            // target that is out of reach. For several goals it uses the mean of the squared
            // errors.
            let way = errors.linear * self.scales.radians_per_length;
            let whole = way * way;
            square = L::select(square.lt(whole), whole, square);
            part = damping_factor.constant(TRACK_DAMPING / self.reach.goals.len() as f64);
        }
        let damping = damping_factor * part;
        let damping = square.mul_add(damping, self.scales.least_damping);
        let damping = if has_weights {
            damping + (self.weights.posture + self.weights.start)
        } else {
            damping
        };
        self.finish_posture_step(arrived, damping);
        // The first solution is of first order. If a goal asks for a whole pose, the step is solved
        // again, with columns that take half of the first solution into account. This is a step of
        // second order (Halley).
        let zero = damping.constant(0.0);
        let mut limited = zero.lt(zero);
        // This is a loop and not two calls, so that the compiler inlines the body only once.
        let needs_second_order = !TRACK && self.reach.needs_second_order();
        for order in 0..=usize::from(needs_second_order) {
            if self.uses_tree() {
                self.assemble();
                if self.weighs_floating() {
                    self.weigh_floating();
                }
            } else {
                self.linearize(order == 1);
                if self.weighs_floating() {
                    self.scale_floating(damping);
                }
            }
            limited = self.limited_step(damping, running);
        }
        // Only a search that may restart uses the residual, to find out if a lane is hopeless.
        let residual = if may_restart && limited.any() {
            L::select(limited, self.squared_residual(), zero)
        } else {
            zero
        };
        let change = if self.reach.posture.is_some() { self.squared_change() } else { zero };
        self.advance(running);
        StepResult { residual, change }
    }

    /// Returns the number of rows of the Jacobian, which is the size of the normal equations.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn rows(&self) -> usize {
        if self.uses_tree() { 0 } else { self.reach.facts.rows }
    }

    /// Computes changes within the limits, and returns the lanes in which a limit stopped a
    /// freedom.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn limited_step(&mut self, damping: L, running: L::Mask) -> L::Mask {
        let zero = damping.constant(0.0);
        self.release_all();
        // This mask starts with no lane set.
        let mut limited = zero.lt(zero);
        // Each round but the final one holds at least one more freedom in some lane, so the number
        // of rounds is at most the number of freedoms plus one. Lanes that no limit stops compute
        // the same changes again.
        for _ in 0..=self.reach.freedoms.len() {
            let shrink = self.solve(damping);
            let stopped = self.apply_limits(shrink) & running;
            limited = limited | stopped;
            if !stopped.any() {
                break;
            }
        }
        limited
    }

    /// Releases all freedoms, and sets their changes to zero.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn release_all(&mut self) {
        let zero = self.scales.length.constant(0.0);
        // The residual begins as the whole error. Later the contribution of each held freedom is
        // subtracted.
        self.scratch.held.fill(zero);
        self.scratch.changes.fill(zero);
        for row in 0..self.rows() {
            self.scratch.residual.set(row, self.scratch.error.get(self.level, row));
        }
    }

    /// Solves for the changes of the freedoms that are not held, in radians. Returns the factor
    /// that scales the largest change of an angle to the largest allowed change.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve(&mut self, damping: L) -> L {
        let (level, rows, zero) = (self.level, self.reach.facts.rows, damping.constant(0.0));
        let posture_step = self.reach.posture.is_some() || self.has_weights();
        if self.uses_tree() {
            self.solve_tree(damping, posture_step);
            return self.shrink();
        }
        // This solves (JJᵀ + λ²)y = e for y. The number of these equations is the number of
        // weighted components of the goals (six for a pose) and does not depend on the number of
        // joints.
        self.set_right_hand_side();
        self.solve_normal(damping);
        let scratch = &mut self.scratch;
        for (index, column) in scratch.columns.runs(rows).enumerate() {
            // The change is z + Jᵀy. The columns of held freedoms are zero, so only z must be set
            // to zero for these freedoms.
            let mut radians = if posture_step {
                let is_held = scratch.held.get(level, index).eq(zero.constant(1.0));
                L::select(is_held, zero, scratch.posture_step.get(level, index))
            } else {
                zero
            };
            for (row, component) in column.iter().enumerate() {
                let y = scratch.solution.get(level, row);
                radians = L::load(level, component).mul_add(y, radians);
            }
            scratch.radians.set(index, radians);
        }
        if self.weighs_floating() {
            self.unscale_floating();
        }
        self.shrink()
    }

    /// Returns the factor that scales the largest change of an angle to the largest allowed change.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn shrink(&self) -> L {
        let (zero, mut most) = (self.scales.longest.constant(0.0), self.scales.longest);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            // A slide may have a long way to go, so its step is not limited.
            let radians = self.scratch.radians.get(self.level, index);
            let length = if freedom.is_slide() { zero } else { radians.abs() };
            most = L::select(most.lt(length), length, most);
        }
        // All changes are scaled by the same factor. If each joint were limited by itself, the link
        // would move in another direction.
        self.scales.longest / most
    }

    /// Sets the right-hand side, in the memory of the solution, to the residual minus the
    /// contribution of the step toward the posture.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set_right_hand_side(&mut self) {
        let posture_step = self.reach.posture.is_some() || self.has_weights();
        let (level, rows, scratch) = (self.level, self.reach.facts.rows, &mut self.scratch);
        for row in 0..rows {
            scratch.solution.set(row, scratch.residual.get(level, row));
        }
        if !posture_step {
            return;
        }
        for (index, column) in scratch.columns.runs(rows).enumerate() {
            let posture_step = scratch.posture_step.get(level, index);
            for (row, component) in column.iter().enumerate() {
                let rhs = scratch.solution.get(level, row);
                scratch.solution.set(row, L::load(level, component).neg_mul_add(posture_step, rhs));
            }
        }
    }

    /// Changes the freedoms that are not held. A freedom that a limit stops goes to the limit and
    /// is held there. Returns the lanes in which a freedom was stopped.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn apply_limits(&mut self, shrink: L) -> L::Mask {
        let (level, rows, zero) = (self.level, self.rows(), shrink.constant(0.0));
        let one = zero.constant(1.0);
        let mut stopped = one.lt(zero);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            let unit = if freedom.is_slide() { self.scales.length } else { one };
            let scratch = &mut self.scratch;
            let is_held = scratch.held.get(level, index).eq(one);
            let change = scratch.radians.get(level, index) * shrink * unit;
            // A held freedom keeps the change with which it reached its limit in an earlier round.
            let change = L::select(is_held, scratch.changes.get(level, index), change);
            scratch.changes.set(index, change);
            if freedom.range.wraps() || !freedom.is_single() {
                continue;
            }
            // The new value is compared with the limits. So a joint that is at its limit and does
            // not move is not stopped, and neither is a joint that a whole turn brings back within
            // its limits.
            let value = scratch.values.get(level, freedom.value as usize);
            let next = value + change;
            let inside = freedom.range.clamp(next);
            let stops = !is_held & freedom.range.stops(next);
            if !stops.any() {
                continue;
            }
            // The freedom goes to its limit and no farther. Its contribution is subtracted from the
            // residual, and its column becomes zero.
            stopped = stopped | stops;
            scratch.changes.set(index, L::select(stops, inside - value, change));
            let taken = L::select(stops, (inside - value) / unit, zero);
            scratch.held.set(index, L::select(stops, one, scratch.held.get(level, index)));
            for row in 0..rows {
                let at = index * rows + row;
                let component = scratch.columns.get(level, at);
                let residual = scratch.residual.get(level, row);
                scratch.residual.set(row, component.neg_mul_add(taken, residual));
                scratch.columns.set(at, L::select(stops, zero, component));
            }
        }
        stopped
    }

    /// Returns the squared error that the changes would leave if the links moved exactly as the
    /// linear model of this step says.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn squared_residual(&mut self) -> L {
        let (level, rows) = (self.level, self.reach.facts.rows);
        let mut square = self.scales.length.constant(0.0);
        for row in 0..rows {
            let mut residual = self.scratch.residual.get(level, row);
            for (index, freedom) in self.reach.freedoms.iter().enumerate() {
                // Columns of held freedoms are zero. Their contribution has already been subtracted
                // from the residual.
                let component = self.scratch.columns.get(level, index * rows + row);
                residual = component.neg_mul_add(self.radians(index, freedom), residual);
            }
            square = residual.mul_add(residual, square);
        }
        square
    }

    /// Returns the sum of the squares of all changes, in radians².
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn squared_change(&self) -> L {
        let mut square = self.scales.length.constant(0.0);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            let radians = self.radians(index, freedom);
            square = radians.mul_add(radians, square);
        }
        square
    }

    /// Returns the change of a freedom, in radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn radians(&self, index: usize, freedom: &Freedom<L::Real>) -> L {
        let change = self.scratch.changes.get(self.level, index);
        if freedom.is_slide() { change * self.scales.radians_per_length } else { change }
    }

    /// Adds the changes to the values. A change that is not finite is ignored.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn advance(&mut self, running: L::Mask) {
        let (level, values) = (self.level, &mut self.scratch.values);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            let change = self.scratch.changes.get(level, index);
            let runs = running & vector::is_finite(change);
            let first = freedom.value as usize;
            match freedom.kind {
                Kind::Turn | Kind::Slide => {
                    let value = values.get(level, first);
                    values.set(first, L::select(runs, value + change, value));
                }
                Kind::FloatingTurn(axis) => {
                    // Multiplying from the right turns about an axis of the link. Each product is
                    // normalized, because repeated products drift away from unit length.
                    let old: [L; 4] = values.record(level, first);
                    let half = change * change.constant(0.5);
                    let [cos, sin] = checked_cos_sin(half);
                    let mut turn = [change.constant(0.0); 3];
                    if let Some(slot) = turn.get_mut(axis as usize) {
                        *slot = sin;
                    }
                    let turned = Quat::from_array(old) * Quat::from_parts(turn, cos);
                    let next = turned.normalize().to_array();
                    values.set_record(first, vector::select(runs, next, old));
                }
                Kind::FloatingSlide(axis) => {
                    let turn = Quat::from_array(values.record(level, first)).normalize();
                    let mut way = [change.constant(0.0); 3];
                    if let Some(slot) = way.get_mut(axis as usize) {
                        *slot = change;
                    }
                    let old: [L; 3] = values.record(level, first + 4);
                    let next = vector::add(old, turn.rotate(way));
                    values.set_record(first + 4, vector::select(runs, next, old));
                }
            }
        }
    }
}

/// The smallest λ². It prevents a division by zero where the Jacobian is zero.
pub(super) const FLOOR: f64 = 1e-30;

/// The number of rows of the Jacobian for one pose. The compiler unrolls loops over this number of
/// rows.
const POSE: usize = 6;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Solves (JJᵀ + λ²1) y = e. Then x = Jᵀy minimises |Jx − e|² + λ²|x|²
    /// (Nakamura & Hanafusa 1986; Wampler 1986; Buss 2004, eq. 11). Columns of held freedoms are
    /// zero. `solution` holds e before the call and y after it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve_normal(&mut self, damping: L) {
        let (level, rows, scratch) = (self.level, self.reach.facts.rows, &mut self.scratch);
        let none = damping.constant(0.0).to_array();
        // Most problems have one pose as their goal. The triangle of its equations has 21 entries,
        // so it is copied to the stack, and the compiler knows the length of all loops. For one
        // lane this saves little time, so builds without std leave this branch out to save code.
        if (L::LANES > 1 || cfg!(feature = "std")) && rows == POSE {
            let (mut a, mut b, mut c) = ([none; POSE * (POSE + 1) / 2], [none; POSE], [none; POSE]);
            let (mut triangle, mut reciprocals, mut y) =
                (Registers(&mut a), Registers(&mut b), Registers(&mut c));
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

/// Computes the lower triangle of JJᵀ, row by row.
#[cfg_attr(not(opt_level_0), inline(always))]
fn multiply<L: Lanes<Real: Scalar>>(
    columns: &Registers<'_, L>,
    a: &mut Registers<'_, L>,
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

/// Solves by a Cholesky factorisation in place. The bound of the rounding error of JJᵀ is added
/// to λ², so that a singular J is not a special case; and each pivot is at least λ², as it
/// would be without rounding.
#[cfg_attr(not(opt_level_0), inline(always))]
fn solve<L: Lanes<Real: Scalar>>(
    a: &mut Registers<'_, L>,
    reciprocals: &mut Registers<'_, L>,
    y: &mut Registers<'_, L>,
    damping: L,
    rows: usize,
) {
    let level = damping.level();
    let mut trace = damping.constant(0.0);
    for i in 0..rows {
        trace = trace + a.get(level, i * (i + 1) / 2 + i);
    }
    // If the matrix is zero, the right-hand side is zero too, so any divisor greater than zero
    // gives zero.
    let floor = damping + damping.constant(FLOOR);
    let least = trace.mul_add(damping.constant(0.25 * epsilon::<L>()), floor);
    // Row by row, this loop factorises A = LLᵀ and also solves Lz = e; z overwrites e in `y`. The
    // loop stores the reciprocals of the diagonal of L.
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
    // This loop solves Lᵀy = z from the last row up.
    for i in (0..rows).rev() {
        let mut solved = y.get(level, i);
        for k in i + 1..rows {
            solved = a.get(level, k * (k + 1) / 2 + i).neg_mul_add(y.get(level, k), solved);
        }
        y.set(i, solved * reciprocals.get(level, i));
    }
}
