//! The search: steps until the target is reached, and other beginnings where it got stuck.

use super::least_squares::epsilon;
use super::miss::{Miss, Weights, distance, is_finite, splat};
use super::step::{Stride, clamp};
use super::{Arm, Options, Outcomes, Report};
use crate::batch::{DualQuat, vector};
use crate::geometry::Twist;
use crate::real::Real;
use dq8_simd::{Float, Lanes, Mask};

/// The squared error must fall to this part of itself ...
const PROGRESS: f64 = 0.4;
/// ... or, where there is no other beginning, to this part ...
const LAST_PROGRESS: f64 = 0.999;
/// ... in this many steps. Patience costs iterations that a restart could use: with 3, fewer of the
/// random targets in the tests are reached. Where there is no restart, nothing is lost by it.
const PATIENCE: f64 = 2.0;
const LAST_PATIENCE: f64 = 6.0;
/// Below this squared error (radians²) a limit in the way is no reason to give up at once.
const NEAR: f64 = 1e-4;

/// What all lanes seek.
struct Goal<L> {
    target: DualQuat<L>,
    weights: Weights<L>,
    angular_tolerance: L,
    linear_tolerance: L,
    stride: Stride<L>,
}

/// Where each lane is.
#[derive(Clone, Copy)]
struct State<L: Lanes, const N: usize> {
    values: [L; N],
    columns: [Twist<L>; N],
    miss: Miss<L>,
}

/// The nearest that each lane has been.
struct Best<L: Lanes, const N: usize> {
    values: [L; N],
    square: L,
    angular: L,
    linear: L,
}

impl<R: Real + Float, const N: usize> Arm<R, N> {
    /// [`reach`](Self::reach) for a target a lane, as [`Backend::reach`](crate::Backend::reach) does
    /// it: what a lane has arrived at is kept while its neighbours go on, and neither the
    /// values nor the report of a lane depend on the others.
    #[inline(always)]
    pub fn reach_lanes<L: Lanes<Real = R>>(
        &self,
        target: DualQuat<L>,
        values: &mut [L; N],
        options: &Options<R>,
    ) -> Report<L, Outcomes<L::Mask>> {
        let level = target.real().w().level();
        let (zero, one) = (L::splat(level, R::ZERO), L::splat(level, R::ONE));
        let started = *values;
        let (target, valid) = self.seen(target, &started);
        let (pulled, beyond) = self.pulled(target, L::splat(level, options.linear_tolerance));
        let goal = self.goal(pulled, options);

        let mut start = started;
        for (value, joint) in start.iter_mut().zip(&self.joints) {
            *value = clamp(joint, L::select(valid, *value, zero));
        }
        let mut state = self.state(level, start, &goal);
        let mut best = Best::of(&state);
        let mut mark = best.square;
        let (mut patience, mut nearest_seed) = (zero, -one);
        let (mut iterations, mut restarts) = (zero, zero);
        let never = one.lt(zero);
        let (mut stuck, mut ever_stuck) = (never, never);
        let mut converged = goal.is_reached(&state.miss) & !beyond;
        let mut running = valid & !converged;
        let again = if options.restarts { !beyond } else { never };

        for _ in 0..options.max_iterations {
            if !running.any() {
                break;
            }
            iterations = iterations + L::select(running, one, zero);
            let step = self.halley_step(
                &state.values,
                &state.columns,
                &state.miss,
                goal.weights,
                goal.stride,
            );
            let mut next = self.moved(&state.values, &step.changes);
            let left = state.miss.left_after(&step.changes, &state.columns, goal.weights);
            let hopeless = step.limited
                & (state.miss.square * one.constant(PROGRESS)).lt(left)
                & one.constant(NEAR).lt(state.miss.square);
            let restarting = running & stuck;
            if restarting.any() {
                let (seed, square) = self.next_seed(&goal, nearest_seed, state.values);
                next = vector::select(restarting, seed, next);
                nearest_seed = L::select(restarting, square, nearest_seed);
                // All have been tried.
                running = running & !(restarting & one.constant(f64::INFINITY).le(square));
                restarts = restarts + L::select(restarting, one, zero);
            }
            state = self.state(level, next, &goal);

            let arrived = running & goal.is_reached(&state.miss) & !beyond;
            best.keep(&state, running & (state.miss.square.lt(best.square) | arrived));
            converged = converged | arrived;
            running = running & !arrived;

            let most = L::select(again, one.constant(PATIENCE), one.constant(LAST_PATIENCE));
            let needed = L::select(again, one.constant(PROGRESS), one.constant(LAST_PROGRESS));
            let nearer = state.miss.square.lt(mark * needed) | restarting;
            mark = L::select(nearer, state.miss.square, mark);
            patience = L::select(nearer, zero, patience + one);
            stuck = most.le(patience) | hopeless & again & !restarting;
            ever_stuck = ever_stuck | running & stuck;
            running = running & (again | !stuck);
        }

        *values = vector::select(valid, best.values, started);
        let nan = one.constant(f64::NAN);
        let linear = L::select(beyond, self.distance_to(level, target, &best.values), best.linear);
        Report {
            iterations,
            restarts,
            angular_error: L::select(valid, best.angular, nan),
            linear_error: L::select(valid, linear, nan),
            outcome: Outcomes {
                invalid: !valid,
                converged,
                out_of_reach: beyond,
                at_limits: ever_stuck & self.is_at_limits(level, &best.values),
                stalled: ever_stuck,
            },
        }
    }

    /// The target, and where there is one and a start: the identity elsewhere.
    #[inline(always)]
    fn seen<L: Lanes<Real = R>>(
        &self,
        target: DualQuat<L>,
        start: &[L; N],
    ) -> (DualQuat<L>, L::Mask) {
        let level = target.real().w().level();
        let zero = L::splat(level, R::ZERO);
        let at = target.translation();
        let far = distance(at, splat(level, self.centre));
        let mut valid = target.is_unit(zero.constant(UNIT)) & is_finite(far);
        for value in *start {
            valid = valid & is_finite(value);
        }
        let identity = DualQuat::identity(level).to_array();
        (DualQuat::from_array(vector::select(valid, target.to_array(), identity)), valid)
    }

    /// Targets beyond the arm's length, drawn to its edge; and which they are. From beyond they would
    /// pull the harder the farther they are.
    #[inline(always)]
    fn pulled<L: Lanes<Real = R>>(
        &self,
        target: DualQuat<L>,
        tolerance: L,
    ) -> (DualQuat<L>, L::Mask) {
        let level = tolerance.level();
        let centre: [L; 3] = splat(level, self.centre);
        let length = L::splat(level, self.length);
        let at = target.translation();
        let far = distance(at, centre);
        // Both have been rounded.
        let rounding = length.constant(1.0 + 64.0 * epsilon::<L>());
        let beyond = (length * rounding + tolerance).lt(far);
        let share = length / far;
        let mut edge = centre;
        for ((edge, at), centre) in edge.iter_mut().zip(at).zip(centre) {
            *edge = (at - centre).mul_add(share, centre);
        }
        let edge = DualQuat::from_rotation_translation(target.real(), edge);
        let pulled = vector::select(beyond, edge.to_array(), target.to_array());
        (DualQuat::from_array(pulled), beyond)
    }

    #[inline(always)]
    fn goal<L: Lanes<Real = R>>(&self, target: DualQuat<L>, options: &Options<R>) -> Goal<L> {
        let level = target.real().w().level();
        let zero = L::splat(level, R::ZERO);
        let eighth = L::splat(level, self.length) * zero.constant(0.125);
        let length = match options.length_per_radian {
            Some(length) => L::splat(level, length),
            None => L::select(zero.lt(eighth), eighth, zero.constant(1.0)),
        };
        let damping = L::splat(level, options.damping);
        Goal {
            target,
            weights: Weights { length, radians_per_length: zero.constant(1.0) / length },
            angular_tolerance: L::splat(level, options.angular_tolerance),
            linear_tolerance: L::splat(level, options.linear_tolerance),
            stride: Stride {
                longest: L::splat(level, options.max_step),
                least_damping: damping * damping,
            },
        }
    }

    #[inline(always)]
    fn state<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: [L; N],
        goal: &Goal<L>,
    ) -> State<L, N> {
        let (pose, columns) = self.forward_jacobian(level, &values);
        State { values, columns, miss: Miss::of(goal.target, pose, goal.weights) }
    }

    /// Of the seeds that are farther from the target than `than`, squared, the nearest; and its square.
    /// `none` and infinity where there is none.
    #[inline(always)]
    fn next_seed<L: Lanes<Real = R>>(&self, goal: &Goal<L>, than: L, none: [L; N]) -> ([L; N], L) {
        let level = than.level();
        let mut nearest = than.constant(f64::INFINITY);
        let mut values = none;
        for seed in &self.seeds {
            let pose = DualQuat::splat(level, seed.pose.to_array());
            let square = Miss::of(goal.target, pose, goal.weights).square;
            let nearer = than.lt(square) & square.lt(nearest);
            nearest = L::select(nearer, square, nearest);
            values = vector::select(nearer, splat(level, seed.values), values);
        }
        (values, nearest)
    }

    #[inline(always)]
    fn distance_to<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        target: DualQuat<L>,
        values: &[L; N],
    ) -> L {
        distance(target.translation(), self.forward_lanes(level, values).translation())
    }

    /// Where a joint is at a limit that stops it.
    #[inline(always)]
    fn is_at_limits<L: Lanes<Real = R>>(&self, level: L::Level, values: &[L; N]) -> L::Mask {
        let zero = L::splat(level, R::ZERO);
        let mut is_at_limits = zero.lt(zero);
        for (joint, &value) in self.joints.iter().zip(values) {
            let [low, high] = splat(level, joint.limits);
            if !joint.wraps() {
                is_at_limits = is_at_limits | value.le(low) | high.le(value);
            }
        }
        is_at_limits
    }
}

/// How far the norm of a target may be from 1.
const UNIT: f64 = 1e-3;

impl<L: Lanes> Goal<L> {
    #[inline(always)]
    fn is_reached(&self, miss: &Miss<L>) -> L::Mask {
        miss.angular.le(self.angular_tolerance) & miss.linear.le(self.linear_tolerance)
    }
}

impl<L: Lanes, const N: usize> Best<L, N> {
    #[inline(always)]
    fn of(state: &State<L, N>) -> Self {
        let State { values, miss, .. } = *state;
        Self { values, square: miss.square, angular: miss.angular, linear: miss.linear }
    }

    #[inline(always)]
    fn keep(&mut self, state: &State<L, N>, better: L::Mask) {
        self.values = vector::select(better, state.values, self.values);
        self.square = L::select(better, state.miss.square, self.square);
        self.angular = L::select(better, state.miss.angular, self.angular);
        self.linear = L::select(better, state.miss.linear, self.linear);
    }
}
