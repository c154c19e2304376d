//! The search: steps until the target is reached, and other beginnings where it got stuck.
//!
//! Every lane walks alone, all in step:
//!
//! ```text
//! until nothing runs, or the iterations are used up:
//!     next = here + a step of second order within the limits        step
//!     if stuck: next = the nearest pose of the arm not yet tried     restart
//!     here = next; keep it if it is the best so far                  keep_best
//!     stop if it is reached                                          stop
//!     stuck = no progress for some steps, or no hope of any          judge
//! ```
//!
//! *Progress* is a fall of the squared error to a part of what it was ([`PROGRESS`]) within a few
//! steps ([`PATIENCE`]). Steps near a solution converge quadratically, so a search that falls slowly is
//! on its way to a local minimum, and an iteration spent there is one that a restart cannot use. *Hope*
//! is what the columns promise: where a limit cuts a step so short that even its own linear model leaves
//! most of the error, the way is blocked, and waiting would not help.
//!
//! *Restarts* take the arm's own poses, [`SEEDS`](super::seed::SEEDS) of them, in the order of their
//! distance from the target. Instead of a sorted list, which no lane could have for itself without
//! memory, each lane remembers how far its last seed was, and looks for the nearest beyond it.
//!
//! A lane that is done goes on computing and keeps nothing: every update is masked, so what a lane
//! returns depends on no other.

use super::goal::Goal;
use super::residual::{Residual, distance};
use super::{Arm, Options, Outcomes, Report};
use crate::batch::{DualQuat, vector};
use crate::geometry::Twist;
use crate::real::Scalar;
use dq8_simd::{Lanes, Mask};

/// The squared error must fall to this part of itself ...
pub(crate) const PROGRESS: f64 = 0.4;
/// ... or, where there is no other beginning, to this part ...
pub(crate) const LAST_PROGRESS: f64 = 0.999;
/// ... in this many steps. Patience costs iterations that a restart could use: with 3, fewer of the
/// random targets in the tests are reached. Without restarts, patience costs nothing.
const PATIENCE: f64 = 2.0;
const LAST_PATIENCE: f64 = 6.0;
/// Below this squared error (radians²) a limit in the way is not a reason to give up at once.
pub(crate) const NEAR: f64 = 1e-4;

/// A search in each lane.
struct Search<'a, R: Scalar, L: Lanes<Real = R>, const N: usize> {
    arm: &'a Arm<R, N>,
    goal: Goal<L>,
    here: State<L, N>,
    best: Best<L, N>,
    /// The squared error that progress is measured from, and the steps without progress since.
    mark: L,
    idle_steps: L,
    /// The squared error of the seed of the last restart; −1 before the first.
    last_seed: L,
    iterations: L,
    restarts: L,
    running: L::Mask,
    converged: L::Mask,
    stuck: L::Mask,
    ever_stuck: L::Mask,
    may_restart: L::Mask,
    out_of_reach: L::Mask,
}

/// Where each lane is.
#[derive(Clone, Copy)]
struct State<L: Lanes, const N: usize> {
    values: [L; N],
    columns: [Twist<L>; N],
    residual: Residual<L>,
}

/// The nearest that each lane has been.
struct Best<L: Lanes, const N: usize> {
    values: [L; N],
    square: L,
    angular: L,
    linear: L,
}

impl<R: Scalar, const N: usize> Arm<R, N> {
    /// [`reach`](Self::reach) for one target per lane, as [`Backend::reach`](crate::Backend::reach) does
    /// it: what a lane has arrived at is kept while its neighbours go on, and neither the
    /// values nor the report of a lane depend on the others.
    #[inline(always)]
    pub fn reach_lanes<L: Lanes<Real = R>>(
        &self,
        target: DualQuat<L>,
        values: &mut [L; N],
        options: &Options<R>,
    ) -> Report<L, Outcomes<L::Mask>> {
        let zero = target.real().w().constant(0.0);
        let started = *values;
        let (target, valid) = self.validated(target, &started);
        let valid = if options.is_valid() { valid } else { zero.lt(zero) };
        let mut start = started;
        for (value, range) in start.iter_mut().zip(&self.ranges) {
            *value = range.enter(L::select(valid, *value, zero));
        }
        let mut search = Search::new(self, target, start, valid, options);
        for _ in 0..options.max_iterations {
            if !search.running.any() {
                break;
            }
            search.iterate();
        }
        *values = vector::select(valid, search.best.values, started);
        search.report(target, valid)
    }
}

impl<'a, R: Scalar, L: Lanes<Real = R>, const N: usize> Search<'a, R, L, N> {
    #[inline(always)]
    fn new(
        arm: &'a Arm<R, N>,
        target: DualQuat<L>,
        start: [L; N],
        valid: L::Mask,
        options: &Options<R>,
    ) -> Self {
        let level = target.real().w().level();
        let (zero, one) = (L::splat(level, R::ZERO), L::splat(level, R::ONE));
        let never = one.lt(zero);
        let tolerance = L::splat(level, options.linear_tolerance);
        let (clamped, out_of_reach) = arm.clamp_to_reach(target, tolerance);
        let goal = arm.goal(clamped, options);
        let here = State::of(arm, level, start, &goal);
        let converged = goal.is_reached(&here.residual) & !out_of_reach;
        Self {
            arm,
            goal,
            here,
            best: Best::of(&here),
            mark: here.residual.square,
            idle_steps: zero,
            last_seed: -one,
            iterations: zero,
            restarts: zero,
            running: valid & !converged,
            converged,
            stuck: never,
            ever_stuck: never,
            // No other beginning brings an arm beyond its length.
            may_restart: if options.restarts { !out_of_reach } else { never },
            out_of_reach,
        }
    }

    /// A step, or another beginning where the last steps led nowhere.
    #[inline(always)]
    fn iterate(&mut self) {
        let one = self.mark.constant(1.0);
        self.iterations = self.iterations + L::select(self.running, one, one.constant(0.0));
        let (mut next, hopeless) = self.step();
        let restarting = self.running & self.stuck;
        if restarting.any() {
            next = self.restart(restarting, next);
        }
        self.here = State::of(self.arm, one.level(), next, &self.goal);
        let arrived = self.running & self.goal.is_reached(&self.here.residual) & !self.out_of_reach;
        self.keep_best(arrived);
        self.stop(arrived);
        self.judge(restarting, hopeless);
    }

    /// Where a step leads, and in which lanes going on like that is hopeless.
    #[inline(always)]
    fn step(&self) -> ([L; N], L::Mask) {
        let State { values, columns, residual } = &self.here;
        let Goal { weights, step_limits, .. } = self.goal;
        let step = self.arm.halley_step(values, columns, residual, weights, step_limits);
        let next = self.arm.moved(values, &step.changes);
        let left = residual.left_after(&step.changes, columns, weights);
        let hopeless = step.limited
            & (residual.square * left.constant(PROGRESS)).lt(left)
            & left.constant(NEAR).lt(residual.square);
        (next, hopeless)
    }

    /// `next`, but the next seed where a lane begins again; lanes that have tried all of them end.
    #[inline(always)]
    fn restart(&mut self, restarting: L::Mask, next: [L; N]) -> [L; N] {
        let one = self.mark.constant(1.0);
        let (seed, square) = self.next_seed();
        self.last_seed = L::select(restarting, square, self.last_seed);
        let is_seed = square.lt(one.constant(f64::INFINITY));
        self.running = self.running & (is_seed | !restarting);
        self.restarts = self.restarts + L::select(restarting & is_seed, one, one.constant(0.0));
        vector::select(restarting, seed, next)
    }

    /// Of the seeds that are farther from the target than the last one, the nearest; and its squared
    /// error. The present values and infinity where there is none.
    #[inline(always)]
    fn next_seed(&self) -> ([L; N], L) {
        let level = self.mark.level();
        let mut nearest = self.mark.constant(f64::INFINITY);
        let mut values = self.here.values;
        for seed in &self.arm.seeds {
            let pose = DualQuat::splat(level, seed.pose.to_array());
            let square = Residual::between(self.goal.target, pose, self.goal.weights).square;
            let nearer = self.last_seed.lt(square) & square.lt(nearest);
            nearest = L::select(nearer, square, nearest);
            values = vector::select(nearer, vector::splat(level, seed.values), values);
        }
        (values, nearest)
    }

    /// What has arrived is kept even where an earlier pose had the smaller sum of errors: that one had
    /// one of the two beyond its tolerance.
    #[inline(always)]
    fn keep_best(&mut self, arrived: L::Mask) {
        let State { values, residual, .. } = &self.here;
        let better = self.running & (residual.square.lt(self.best.square) | arrived);
        let best = &mut self.best;
        best.values = vector::select(better, *values, best.values);
        best.square = L::select(better, residual.square, best.square);
        best.angular = L::select(better, residual.angular, best.angular);
        best.linear = L::select(better, residual.linear, best.linear);
    }

    #[inline(always)]
    fn stop(&mut self, arrived: L::Mask) {
        self.converged = self.converged | arrived;
        self.running = self.running & !arrived;
    }

    /// Which lanes are stuck. They begin again if they may, and end if not.
    #[inline(always)]
    fn judge(&mut self, restarting: L::Mask, hopeless: L::Mask) {
        let (again, square) = (self.may_restart, self.here.residual.square);
        let one = square.constant(1.0);
        let patience = L::select(again, one.constant(PATIENCE), one.constant(LAST_PATIENCE));
        let needed = L::select(again, one.constant(PROGRESS), one.constant(LAST_PROGRESS));
        // A new beginning is measured from where it is.
        let nearer = square.lt(self.mark * needed) | restarting;
        self.mark = L::select(nearer, square, self.mark);
        self.idle_steps = L::select(nearer, one.constant(0.0), self.idle_steps + one);
        self.stuck = patience.le(self.idle_steps) | hopeless & again & !restarting;
        self.ever_stuck = self.ever_stuck | self.running & self.stuck;
        self.running = self.running & (again | !self.stuck);
    }

    /// Where the best values have a joint at a limit that stops it.
    #[inline(always)]
    fn is_at_limits(&self) -> L::Mask {
        // Nowhere yet.
        let mut is_at_limits = self.mark.lt(self.mark);
        for (range, &value) in self.arm.ranges.iter().zip(&self.best.values) {
            let [low, high] = range.ends(value.level());
            if !range.wraps {
                is_at_limits = is_at_limits | value.le(low) | high.le(value);
            }
        }
        is_at_limits
    }

    /// Of a target that has been clamped to the reach, the report tells the distance to itself.
    #[inline(always)]
    fn report(&self, target: DualQuat<L>, valid: L::Mask) -> Report<L, Outcomes<L::Mask>> {
        let (arm, best, level) = (self.arm, &self.best, self.mark.level());
        let nan = self.mark.constant(f64::NAN);
        let end = arm.forward_lanes(level, &best.values).translation();
        let linear = L::select(self.out_of_reach, distance(target.translation(), end), best.linear);
        Report {
            iterations: self.iterations,
            restarts: self.restarts,
            angular_error: L::select(valid, best.angular, nan),
            linear_error: L::select(valid, linear, nan),
            outcome: Outcomes {
                invalid: !valid,
                converged: self.converged,
                out_of_reach: self.out_of_reach,
                at_limits: self.ever_stuck & self.is_at_limits(),
                stalled: self.ever_stuck,
            },
        }
    }
}

impl<L: Lanes, const N: usize> State<L, N> {
    #[inline(always)]
    fn of<R: Scalar>(arm: &Arm<R, N>, level: L::Level, values: [L; N], goal: &Goal<L>) -> Self
    where
        L: Lanes<Real = R>,
    {
        let (pose, columns) = arm.forward_jacobian(level, &values);
        Self { values, columns, residual: Residual::between(goal.target, pose, goal.weights) }
    }
}

impl<L: Lanes, const N: usize> Best<L, N> {
    #[inline(always)]
    fn of(state: &State<L, N>) -> Self {
        let State { values, residual, .. } = *state;
        let Residual { square, angular, linear, .. } = residual;
        Self { values, square, angular, linear }
    }
}
