//! One step toward the targets, within the limits of the joints.
//!
//! Damped least squares for all freedoms at once; where that takes one beyond a limit, it goes to
//! the limit and is *held* there, what its way contributes is taken off the errors, its column
//! leaves the system, and the others are solved again for the rest (Baerlocher & Boulic 2004). So
//! the others make up for it, where clipping the result would point the link elsewhere. Each round
//! holds at least one more, in some lane.
//!
//! Slides and hinges share the system because everything in it is in radians: rows by the length
//! that weighs as much as a radian, and the column of a slide by the same.
//!
//! A posture adds what the goals leave free: with the way z to the posture, the change is z +
//! J⁺(e − Jz).
//!
//! At the end of the file the normal equations, of a size that is known at run time.

use super::freedom::{Freedom, Kind};
use super::model::{Apart, Model, Stepped};
use super::scratch::{Rows, Scratch};
use crate::mechanism::values::half_turn;
use dq8::Scalar;
use dq8::batch::vector::epsilon;
use dq8::batch::{Quat, vector};
use dq8_simd::{Lanes, Mask};

/// λ² of the damped least squares, as a part of the squared error: λ² = μ|e|², Sugihara's
/// choice (*Solvability-Unconcerned Inverse Kinematics by the Levenberg–Marquardt Method*, 2011),
/// which damps far from the target, where the columns promise too much, and in front of a target
/// out of reach, where nothing limits what they promise, but not at the end. His μ is ½; with
/// second-order steps anything from 0.01 to 0.05 is as good, and better than ½.
const DAMPING: f64 = 0.02;
/// In searches that track and in which nothing else weighs, of the mean over the goals: Sugihara's.
/// Their few steps must be right also where nothing reaches the target.
const TRACK_DAMPING: f64 = 0.5;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Moves the lanes that run, damped `caution` times as much as usual; those that have arrived,
    /// toward the posture too.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn step(
        &mut self,
        apart: Apart<L>,
        caution: L,
        running: L::Mask,
        arrived: L::Mask,
        again: bool,
    ) -> Stepped<L> {
        let weighs = self.weighs();
        let mut square = apart.square;
        let mut part = caution.constant(DAMPING);
        if TRACK && !weighs {
            // To the target itself, and not to the nearest place that may be reached; of many goals
            // the mean.
            let way = apart.linear * self.scales.radians_per_length;
            let whole = way * way;
            square = L::select(square.lt(whole), whole, square);
            part = caution.constant(TRACK_DAMPING / self.reach.goals.len() as f64);
        }
        let damping = caution * part;
        let damping = square.mul_add(damping, self.scales.least_damping);
        let damping =
            if weighs { damping + (self.follows.posture + self.follows.start) } else { damping };
        self.keep_wishes(arrived, damping);
        // The first solution says how far everything moves. Where that pays, the step is solved
        // again along columns that are bent by half of it: a step of second order, Halley's.
        let zero = damping.constant(0.0);
        let mut limited = zero.lt(zero);
        // A loop, so that machine code has it once.
        let bends = !TRACK && self.reach.bends();
        for order in 0..=usize::from(bends) {
            if self.is_by_tree() {
                self.assemble();
            } else {
                self.linearize(order == 1);
            }
            limited = self.limited_step(damping, running);
        }
        // Nobody asks where a search cannot begin again.
        let left =
            if again && limited.any() { L::select(limited, self.left_after(), zero) } else { zero };
        let moved = if self.reach.posture.is_some() { self.moved() } else { zero };
        self.advance(running);
        Stepped { left, moved }
    }

    /// How many errors the system has rows for.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn rows(&self) -> usize {
        if self.is_by_tree() { 0 } else { self.reach.facts.rows }
    }

    /// Changes that no limit forbids, and where a limit stopped one.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn limited_step(&mut self, damping: L, running: L::Mask) -> L::Mask {
        let zero = damping.constant(0.0);
        self.begin_step();
        // Nowhere yet.
        let mut limited = zero.lt(zero);
        // Each round but the last holds one freedom more, in some lane, so there are no more rounds
        // than freedoms and one. Lanes that no limit stops find the same changes again.
        for _ in 0..=self.reach.freedoms.len() {
            let shrink = self.solve(damping);
            let stopped = self.take(shrink) & running;
            limited = limited | stopped;
            if !stopped.any() {
                break;
            }
        }
        limited
    }

    /// Nothing is held, and nothing changed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn begin_step(&mut self) {
        let zero = self.scales.length.constant(0.0);
        // `left` is what the free ones must still make up for. It begins as the whole error; each
        // joint that is held takes off what it does on its way to the limit.
        self.scratch.held.fill(zero);
        self.scratch.changes.fill(zero);
        for row in 0..self.rows() {
            self.scratch.left.set(row, self.scratch.error.get(self.level, row));
        }
    }

    /// What the free ones should change, in radians, and the factor that makes the longest of it no
    /// longer than allowed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn solve(&mut self, damping: L) -> L {
        let (level, rows, zero) = (self.level, self.reach.facts.rows, damping.constant(0.0));
        let wishes = self.reach.posture.is_some() || self.weighs();
        if self.is_by_tree() {
            self.solve_tree(damping, wishes);
            return self.shrink();
        }
        // y of (JJᵀ + λ²)y = e. Its size is that of the goals, six rows for a pose, however
        // many joints there are.
        self.ask();
        self.solve_normal(damping);
        let scratch = &mut self.scratch;
        for (index, column) in scratch.columns.runs(rows).enumerate() {
            // z + Jᵀy; a held column is zero, so that only z must be taken out of it.
            let mut radians = if wishes {
                let is_held = scratch.held.get(level, index).eq(zero.constant(1.0));
                L::select(is_held, zero, scratch.wishes.get(level, index))
            } else {
                zero
            };
            for (row, component) in column.iter().enumerate() {
                let y = scratch.solution.get(level, row);
                radians = L::load(level, component).mul_add(y, radians);
            }
            scratch.radians.set(index, radians);
        }
        self.shrink()
    }

    /// The factor that makes the longest turn no longer than allowed.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn shrink(&self) -> L {
        let (zero, mut most) = (self.scales.longest.constant(0.0), self.scales.longest);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            // What slides without end may have a long way to go.
            let radians = self.scratch.radians.get(self.level, index);
            let length = if freedom.is_slide() { zero } else { radians.abs() };
            most = L::select(most.lt(length), length, most);
        }
        // All by the same factor: a step cut joint by joint would point elsewhere.
        self.scales.longest / most
    }

    /// Puts what the free ones should make up for where the solution will be: the errors that are
    /// left, without what the way to the posture contributes.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn ask(&mut self) {
        let wishes = self.reach.posture.is_some() || self.weighs();
        let (level, rows, scratch) = (self.level, self.reach.facts.rows, &mut self.scratch);
        for row in 0..rows {
            scratch.solution.set(row, scratch.left.get(level, row));
        }
        if !wishes {
            return;
        }
        for (index, column) in scratch.columns.runs(rows).enumerate() {
            let wish = scratch.wishes.get(level, index);
            for (row, component) in column.iter().enumerate() {
                let asked = scratch.solution.get(level, row);
                scratch.solution.set(row, L::load(level, component).neg_mul_add(wish, asked));
            }
        }
    }

    /// Changes the free ones. Those that a limit stops go as far as it and are held from now on;
    /// says where there was one.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn take(&mut self, shrink: L) -> L::Mask {
        let (level, rows, zero) = (self.level, self.rows(), shrink.constant(0.0));
        let one = zero.constant(1.0);
        let mut stopped = one.lt(zero);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            let unit = if freedom.is_slide() { self.scales.length } else { one };
            let scratch = &mut self.scratch;
            let is_held = scratch.held.get(level, index).eq(one);
            let change = scratch.radians.get(level, index) * shrink * unit;
            // What is held keeps the change with which it reached its limit in an earlier round.
            let change = L::select(is_held, scratch.changes.get(level, index), change);
            scratch.changes.set(index, change);
            if freedom.range.wraps() || !freedom.is_single() {
                continue;
            }
            // Compared as values: a joint that stands at its limit and is asked no farther is not
            // stopped. Nor is one that a turn less takes back between its limits.
            let value = scratch.values.get(level, freedom.value as usize);
            let next = value + change;
            let inside = freedom.range.clamp(next);
            let stops = !is_held & freedom.range.stops(next);
            if !stops.any() {
                continue;
            }
            // It goes to the limit and no farther, what that does is taken off the errors, and its
            // column becomes zero.
            stopped = stopped | stops;
            scratch.changes.set(index, L::select(stops, inside - value, change));
            let taken = L::select(stops, (inside - value) / unit, zero);
            scratch.held.set(index, L::select(stops, one, scratch.held.get(level, index)));
            for row in 0..rows {
                let at = index * rows + row;
                let component = scratch.columns.get(level, at);
                let left = scratch.left.get(level, row);
                scratch.left.set(row, component.neg_mul_add(taken, left));
                scratch.columns.set(at, L::select(stops, zero, component));
            }
        }
        stopped
    }

    /// The square of the errors that the changes would leave if everything moved along the columns
    /// of the last step.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn left_after(&mut self) -> L {
        let (level, rows) = (self.level, self.reach.facts.rows);
        let mut square = self.scales.length.constant(0.0);
        for row in 0..rows {
            let mut left = self.scratch.left.get(level, row);
            for (index, freedom) in self.reach.freedoms.iter().enumerate() {
                // Zero where it is held, whose part has been taken off.
                let component = self.scratch.columns.get(level, index * rows + row);
                left = component.neg_mul_add(self.radians(index, freedom), left);
            }
            square = left.mul_add(left, square);
        }
        square
    }

    /// The square of all changes, in radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn moved(&self) -> L {
        let mut square = self.scales.length.constant(0.0);
        for (index, freedom) in self.reach.freedoms.iter().enumerate() {
            let radians = self.radians(index, freedom);
            square = radians.mul_add(radians, square);
        }
        square
    }

    /// The change of a value, in radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn radians(&self, index: usize, freedom: &Freedom<L::Real>) -> L {
        let change = self.scratch.changes.get(self.level, index);
        if freedom.is_slide() { change * self.scales.radians_per_length } else { change }
    }

    /// The values moved. What is not finite moves nothing.
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
                    // On the right, about an axis of the body. Products drift from unit, so each is
                    // normalized.
                    let old: [L; 4] = values.record(level, first);
                    let half = change * change.constant(0.5);
                    let [cos, sin] = half_turn(half);
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
