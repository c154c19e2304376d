//! One step of an arm toward its target, within its limits.

use super::miss::{Miss, Weights, dot, is_finite, splat};
use super::{Arm, Joint, least_squares};
use crate::batch::lie_bracket;
use crate::geometry::Twist;
use crate::real::Real;
use dq8_simd::{Float, Lanes, Mask};

/// What keeps a step short.
#[derive(Clone, Copy)]
pub(super) struct Stride<L> {
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

impl<R: Real + Float, const N: usize> Arm<R, N> {
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
        miss: &Miss<L>,
        weights: Weights<L>,
        stride: Stride<L>,
    ) -> Step<L, N> {
        let newton = self.limited_step(values, columns, miss, weights, stride);
        let (zero, half) = (stride.longest.constant(0.0), stride.longest.constant(0.5));
        let mut moved = Twist::from_array([zero; 6]);
        let mut bent = *columns;
        for ((bent, &column), &change) in bent.iter_mut().zip(columns).zip(&newton.changes) {
            *bent = column + lie_bracket(moved, column).scale(half);
            moved = moved + column.scale(change);
        }
        self.limited_step(values, &bent, miss, weights, stride)
    }

    /// A damped step that no limit forbids: a joint that would leave them goes to its limit and stays
    /// there, and the others step again toward what is left (Baerlocher & Boulic 2004).
    #[inline(always)]
    fn limited_step<L: Lanes<Real = R>>(
        &self,
        values: &[L; N],
        columns: &[Twist<L>; N],
        miss: &Miss<L>,
        weights: Weights<L>,
        stride: Stride<L>,
    ) -> Step<L, N> {
        let (zero, one) = (stride.longest.constant(0.0), stride.longest.constant(1.0));
        // Slides in radians as well.
        let mut rows = [[zero; 6]; N];
        for ((row, &column), joint) in rows.iter_mut().zip(columns).zip(&self.joints) {
            let unit = if joint.is_slide() { weights.length } else { one };
            *row = weights.row(column.scale(unit), miss.at);
        }
        let never = one.lt(zero);
        let mut held = [never; N];
        let mut changes = [zero; N];
        let mut limited = never;
        let mut left = miss.error;
        let damping = miss.square.mul_add(one.constant(DAMPING), stride.least_damping);
        // Each turn holds a joint more, in some lane.
        for _ in 0..=N {
            let y = least_squares::damped(&rows, &held, left, damping);
            let mut longest = stride.longest;
            let mut radians = [zero; N];
            for (radians, row) in radians.iter_mut().zip(&rows) {
                *radians = dot(row, &y);
            }
            for (&radians, &held) in radians.iter().zip(&held) {
                let length = L::select(held, zero, radians.abs());
                longest = L::select(longest.lt(length), length, longest);
            }
            let shrink = stride.longest / longest;
            let mut stopped = never;
            for (j, joint) in self.joints.iter().enumerate() {
                let unit = if joint.is_slide() { weights.length } else { one };
                let change = radians[j] * shrink * unit;
                changes[j] = L::select(held[j], changes[j], change);
                if joint.wraps() {
                    continue;
                }
                let value = values[j] + changes[j];
                let inside = clamp(joint, value);
                let stops = !held[j] & !value.eq(inside);
                changes[j] = L::select(stops, inside - values[j], changes[j]);
                let taken = L::select(stops, changes[j] / unit, zero);
                for (left, &component) in left.iter_mut().zip(&rows[j]) {
                    *left = component.neg_mul_add(taken, *left);
                }
                held[j] = held[j] | stops;
                stopped = stopped | stops;
            }
            limited = limited | stopped;
            if !stopped.any() {
                break;
            }
        }
        Step { changes, limited }
    }

    /// The joints moved, each within its limits; a joint that wraps goes on a turn less. What is not
    /// finite moves nothing.
    #[inline(always)]
    pub(super) fn moved<L: Lanes<Real = R>>(&self, values: &[L; N], changes: &[L; N]) -> [L; N] {
        let mut moved = *values;
        for ((value, &change), joint) in moved.iter_mut().zip(changes).zip(&self.joints) {
            let next = *value + change;
            let next = if joint.wraps() { wrap(joint, next) } else { next };
            let next = clamp(joint, next);
            *value = L::select(is_finite(next), next, *value);
        }
        moved
    }
}

/// λ² of the damped least squares, as a part of the squared error: λ² = μ|e|², Sugihara's choice
/// (*Solvability-Unconcerned Inverse Kinematics by the Levenberg–Marquardt Method*, 2011), which
/// damps far from the target, where the columns promise too much, and in front of a target out of
/// reach, where there is no limit to what they promise, but not at the end. His μ is ½; with second-order
/// steps anything from 0.01 to 0.05 is as good, and better than ½.
const DAMPING: f64 = 0.02;

/// To the nearest value within the limits.
#[inline(always)]
pub(super) fn clamp<L: Lanes<Real: Real>>(joint: &Joint<L::Real>, value: L) -> L {
    let [low, high] = splat(value.level(), joint.limits);
    let value = L::select(value.lt(low), low, value);
    L::select(high.lt(value), high, value)
}

/// A turn less, beyond the limits.
#[inline(always)]
fn wrap<L: Lanes<Real: Real>>(joint: &Joint<L::Real>, value: L) -> L {
    let [low, high] = splat(value.level(), joint.limits);
    let turn = value.constant(core::f64::consts::TAU);
    let value = L::select(value.lt(low), value + turn, value);
    L::select(high.lt(value), value - turn, value)
}
