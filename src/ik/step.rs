//! One step of an arm toward its target, within its limits.
//!
//! A step is damped least squares, solved for all joints that are free. If that takes a joint beyond
//! a limit, the joint goes to the limit and is *held* there; what its way contributes is taken off
//! the error, its column leaves the system, and the others are solved again for the rest. So the
//! others make up for it, where clipping the result would point the arm elsewhere. Each round holds
//! at least one joint more, in some lane: N + 1 rounds are enough, and one where no limit is near.
//!
//! Slides and hinges share the system because everything in it is in radians: rows by
//! [`Weights::row`], and the column of a slide by the length that weighs as much as a radian.

use super::limits::Range;
use super::residual::{Residual, Weights, dot};
use super::{Arm, Joint, least_squares};
use crate::batch::{lie_bracket, vector};
use crate::geometry::Twist;
use crate::real::Scalar;
use dq8_simd::{Lanes, Mask};

/// λ² of the damped least squares, as a part of the squared error: λ² = μ|e|², Sugihara's choice
/// (*Solvability-Unconcerned Inverse Kinematics by the Levenberg–Marquardt Method*, 2011), which
/// damps far from the target, where the columns promise too much, and in front of a target out of
/// reach, where nothing limits what they promise, but not at the end. His μ is ½; with second-order
/// steps anything from 0.01 to 0.05 is as good, and better than ½.
pub(crate) const DAMPING: f64 = 0.02;

/// What keeps a step short.
#[derive(Clone, Copy)]
pub(super) struct StepLimits<L> {
    /// The most that a hinge turns.
    pub(super) longest: L,
    /// λ² where the target is.
    pub(super) least_damping: L,
}

/// Where a step leads.
pub(super) struct Step<L: Lanes, const N: usize> {
    /// The changes of the joints.
    pub(super) changes: [L; N],
    /// Where a limit stopped a joint.
    pub(super) limited: L::Mask,
}

impl<R: Scalar, const N: usize> Arm<R, N> {
    /// Halley's step: Newton's, and then another along columns that are bent by half of it.
    ///
    /// The end moves by a product of exponentials, of which the logarithm is (Baker, Campbell, Hausdorff)
    ///
    /// ```text
    /// 2 log(target · pose*) = Σ δⱼ (cⱼ + ½ [Σₖ₍ₖ₍ⱼ₎ δₖcₖ, cⱼ]) + third order
    /// ```
    ///
    /// so the bent columns cost a bracket each. That the second order is right is what gets an arm out
    /// of singular poses and near them to its target: see Lloyd, Irani & Ahmadi (*Fast and Robust
    /// Inverse Kinematics of Serial Robots Using Halley's Method*, 2022).
    #[inline(always)]
    pub(super) fn halley_step<L: Lanes<Real = R>>(
        &self,
        values: &[L; N],
        columns: &[Twist<L>; N],
        residual: &Residual<L>,
        weights: Weights<L>,
        limits: StepLimits<L>,
    ) -> Step<L, N> {
        let newton = self.limited_step(values, columns, residual, weights, limits);
        let (zero, half) = (limits.longest.constant(0.0), limits.longest.constant(0.5));
        let mut moved = Twist::from_array([zero; 6]);
        let mut bent = *columns;
        for ((bent, &column), &change) in bent.iter_mut().zip(columns).zip(&newton.changes) {
            *bent = column + lie_bracket(moved, column).scale(half);
            moved = moved + column.scale(change);
        }
        self.limited_step(values, &bent, residual, weights, limits)
    }

    /// A damped step that no limit forbids: a joint that would leave them goes to its limit and stays
    /// there, and the others step again toward what is left (Baerlocher & Boulic 2004).
    #[inline(always)]
    fn limited_step<L: Lanes<Real = R>>(
        &self,
        values: &[L; N],
        columns: &[Twist<L>; N],
        residual: &Residual<L>,
        weights: Weights<L>,
        limits: StepLimits<L>,
    ) -> Step<L, N> {
        let mut system = System::new(&self.joints, columns, residual, weights);
        let square = residual.square;
        let damping = square.mul_add(square.constant(DAMPING), limits.least_damping);
        // Nowhere yet.
        let mut limited = square.lt(square);
        for _ in 0..=N {
            let (radians, shrink) = system.solve(damping, limits.longest);
            let stopped = system.take(&self.joints, &self.ranges, values, &radians, shrink);
            limited = limited | stopped;
            if !stopped.any() {
                break;
            }
        }
        Step { changes: system.changes, limited }
    }

    /// The joints moved, each within its limits. What is not finite moves nothing.
    #[inline(always)]
    pub(super) fn moved<L: Lanes<Real = R>>(&self, values: &[L; N], changes: &[L; N]) -> [L; N] {
        let mut moved = *values;
        for ((value, &change), range) in moved.iter_mut().zip(changes).zip(&self.ranges) {
            let next = range.go_on(*value + change);
            *value = L::select(vector::is_finite(next), next, *value);
        }
        moved
    }
}

/// The least squares of a step, and which joints have left it.
struct System<L: Lanes, const N: usize> {
    /// How the end moves with each joint, in radians.
    rows: [[L; 6]; N],
    /// Where a joint stands at a limit.
    held: [L::Mask; N],
    /// What each joint moves, in its own unit; final where it is held.
    changes: [L; N],
    /// The error without what the held joints contribute.
    left: [L; 6],
    /// A radian of a slide.
    length: L,
}

impl<L: Lanes<Real: Scalar>, const N: usize> System<L, N> {
    #[inline(always)]
    fn new(
        joints: &[Joint<L::Real>; N],
        columns: &[Twist<L>; N],
        residual: &Residual<L>,
        weights: Weights<L>,
    ) -> Self {
        let zero = weights.length.constant(0.0);
        let mut system = Self {
            rows: [[zero; 6]; N],
            held: [zero.lt(zero); N],
            changes: [zero; N],
            left: residual.error,
            length: weights.length,
        };
        for ((row, &column), joint) in system.rows.iter_mut().zip(columns).zip(joints) {
            let unit = if joint.is_slide() { weights.length } else { zero.constant(1.0) };
            *row = weights.row(column.scale(unit), residual.end);
        }
        system
    }

    /// What the free joints should move, in radians, and the factor that makes the longest of it no
    /// longer than allowed: all are shortened alike, to keep the direction.
    #[inline(always)]
    fn solve(&self, damping: L, longest: L) -> ([L; N], L) {
        let zero = damping.constant(0.0);
        let y = least_squares::damped(&self.rows, &self.held, self.left, damping);
        let mut radians = [zero; N];
        for (radians, row) in radians.iter_mut().zip(&self.rows) {
            *radians = dot(row, &y);
        }
        let mut most = longest;
        for (&radians, &held) in radians.iter().zip(&self.held) {
            let length = L::select(held, zero, radians.abs());
            most = L::select(most.lt(length), length, most);
        }
        (radians, longest / most)
    }

    /// Moves the free joints. Those that a limit stops go as far as it and are held from now on;
    /// says where there was one.
    #[inline(always)]
    fn take(
        &mut self,
        joints: &[Joint<L::Real>; N],
        ranges: &[Range<L::Real>; N],
        values: &[L; N],
        radians: &[L; N],
        shrink: L,
    ) -> L::Mask {
        let (zero, one) = (shrink.constant(0.0), shrink.constant(1.0));
        let mut stopped = one.lt(zero);
        for (j, (joint, range)) in joints.iter().zip(ranges).enumerate() {
            let unit = if joint.is_slide() { self.length } else { one };
            let change = radians[j] * shrink * unit;
            self.changes[j] = L::select(self.held[j], self.changes[j], change);
            if range.wraps {
                continue;
            }
            let value = values[j] + self.changes[j];
            let inside = range.clamp(value);
            let stops = !self.held[j] & !value.eq(inside);
            self.changes[j] = L::select(stops, inside - values[j], self.changes[j]);
            let taken = L::select(stops, self.changes[j] / unit, zero);
            for (left, &component) in self.left.iter_mut().zip(&self.rows[j]) {
                *left = component.neg_mul_add(taken, *left);
            }
            self.held[j] = self.held[j] | stops;
            stopped = stopped | stops;
        }
        stopped
    }
}
