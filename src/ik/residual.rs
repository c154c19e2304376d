//! What separates the end of an arm from its target.

use crate::batch::{DualQuat, Quat, vector};
use crate::geometry::Twist;
use dq8_simd::Lanes;

/// What separates a pose from a target.
#[derive(Clone, Copy)]
pub(super) struct Residual<L> {
    /// The twist 2 log(target · pose*) with its linear part taken at the end instead of the origin and
    /// in radians: what [`Weights::row`] makes of it.
    pub(super) error: [L; 6],
    /// Its square.
    pub(super) square: L,
    /// Where the end is.
    pub(super) end: [L; 3],
    /// The turn and the distance that are left.
    pub(super) angular: L,
    pub(super) linear: L,
}

impl<L: Lanes> Residual<L> {
    #[inline(always)]
    pub(super) fn between(target: DualQuat<L>, pose: DualQuat<L>, weights: Weights<L>) -> Self {
        let end = pose.translation();
        let twist = (target * pose.conjugate()).to_twist();
        let error = weights.row(twist, end);
        let square = dot(&error, &error);
        let angular = vector::dot(twist.angular, twist.angular).sqrt();
        Self { error, square, end, angular, linear: distance(target.translation(), end) }
    }

    /// The square of the error that `changes` would leave if the end moved on as it begins to.
    #[inline(always)]
    pub(super) fn left_after<const N: usize>(
        &self,
        changes: &[L; N],
        columns: &[Twist<L>; N],
        weights: Weights<L>,
    ) -> L {
        let mut left = self.error;
        for (&change, &column) in changes.iter().zip(columns) {
            for (left, component) in left.iter_mut().zip(weights.row(column, self.end)) {
                *left = component.neg_mul_add(change, *left);
            }
        }
        dot(&left, &left)
    }
}

/// What makes lengths and radians comparable.
#[derive(Clone, Copy)]
pub(super) struct Weights<L> {
    /// The length that weighs as much as a radian.
    pub(super) length: L,
    pub(super) radians_per_length: L,
}

impl<L: Lanes> Weights<L> {
    /// Angular part, and linear part at the point `at` in radians: about the origin of the base a twist
    /// of the end has a linear part that depends on where the base is.
    #[inline(always)]
    pub(super) fn row(self, twist: Twist<L>, at: [L; 3]) -> [L; 6] {
        let [wx, wy, wz] = twist.angular;
        let there = vector::cross_onto(twist.angular, at, twist.linear);
        let [vx, vy, vz] = vector::scale(there, self.radians_per_length);
        [wx, wy, wz, vx, vy, vz]
    }
}

/// |a − b|, which does not overflow before it must.
#[inline(always)]
pub(super) fn distance<L: Lanes>([ax, ay, az]: [L; 3], [bx, by, bz]: [L; 3]) -> L {
    Quat::from_xyzw(ax - bx, ay - by, az - bz, ax.constant(0.0)).norm()
}

#[inline(always)]
pub(super) fn dot<L: Lanes>(a: &[L; 6], b: &[L; 6]) -> L {
    let [au, av, aw, ax, ay, az] = *a;
    let [bu, bv, bw, bx, by, bz] = *b;
    vector::dot([au, av, aw], [bu, bv, bw]) + vector::dot([ax, ay, az], [bx, by, bz])
}
