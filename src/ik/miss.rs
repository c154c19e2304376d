//! Where the end of an arm is, how it moves with each joint, and what separates it from its target.

use super::Arm;
use crate::batch::{DualQuat, Quat, vector};
use crate::geometry::Twist;
use crate::real::Real;
use dq8_simd::{Float, Lanes};

impl<R: Real + Float, const N: usize> Arm<R, N> {
    /// [`forward`](Self::forward) on lanes.
    #[inline(always)]
    #[must_use]
    pub fn forward_lanes<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: &[L; N],
    ) -> DualQuat<L> {
        self.forward_jacobian(level, values).0
    }

    /// The pose of the end, and the spatial Jacobian: column j is the screw of joint j where the
    /// joints before it have moved it, Ad(exp(½ξ₁q₁) … exp(½ξⱼ₋₁qⱼ₋₁)) ξⱼ, so that the spatial twist of
    /// the end is Σ q̇ⱼ column(j) (Lynch & Park 2017, eq. 5.11); the same as
    /// [`Job::jacobian`](crate::Job::jacobian).
    #[inline(always)]
    #[must_use]
    pub fn forward_jacobian<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: &[L; N],
    ) -> (DualQuat<L>, [Twist<L>; N]) {
        let mut pose = DualQuat::identity(level);
        let zero = L::splat(level, R::ZERO);
        let mut columns = [Twist::from_array([zero; 6]); N];
        for ((column, joint), &value) in columns.iter_mut().zip(&self.joints).zip(values) {
            let screw = splat_twist(level, joint.screw);
            *column = pose.adjoint(screw);
            pose = pose * DualQuat::from_twist(screw.scale(value));
        }
        (pose * DualQuat::splat(level, self.home.to_array()), columns)
    }
}

#[inline(always)]
fn splat_twist<L: Lanes>(level: L::Level, twist: Twist<L::Real>) -> Twist<L> {
    let [wx, wy, wz] = splat(level, twist.angular);
    let [vx, vy, vz] = splat(level, twist.linear);
    Twist::from_array([wx, wy, wz, vx, vy, vz])
}

#[inline(always)]
pub(super) fn splat<L: Lanes, const C: usize>(level: L::Level, numbers: [L::Real; C]) -> [L; C] {
    let mut lanes = [L::splat(level, L::Real::default()); C];
    for (lane, number) in lanes.iter_mut().zip(numbers) {
        *lane = L::splat(level, number);
    }
    lanes
}

/// What separates a pose from a target.
#[derive(Clone, Copy)]
pub(super) struct Miss<L> {
    /// The twist 2 log(target · pose*) with its linear part taken at the end instead of the origin and
    /// in radians: what [`Weights::row`] makes of it.
    pub(super) error: [L; 6],
    /// Its square.
    pub(super) square: L,
    /// Where the end is.
    pub(super) at: [L; 3],
    /// The turn and the distance that are left.
    pub(super) angular: L,
    pub(super) linear: L,
}

impl<L: Lanes> Miss<L> {
    #[inline(always)]
    pub(super) fn of(target: DualQuat<L>, pose: DualQuat<L>, weights: Weights<L>) -> Self {
        let at = pose.translation();
        let twist = (target * pose.conjugate()).to_twist();
        let error = weights.row(twist, at);
        let square = dot(&error, &error);
        let angular = vector::dot(twist.angular, twist.angular).sqrt();
        Self { error, square, at, angular, linear: distance(target.translation(), at) }
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
            for (left, component) in left.iter_mut().zip(weights.row(column, self.at)) {
                *left = component.neg_mul_add(change, *left);
            }
        }
        dot(&left, &left)
    }
}

/// Neither infinite nor NaN.
#[inline(always)]
pub(super) fn is_finite<L: Lanes>(number: L) -> L::Mask {
    let zero = number.constant(0.0);
    (number * zero).eq(zero)
}

/// |a − b|, which does not overflow before it must.
#[inline(always)]
pub(super) fn distance<L: Lanes>([ax, ay, az]: [L; 3], [bx, by, bz]: [L; 3]) -> L {
    Quat::from_xyzw(ax - bx, ay - by, az - bz, ax.constant(0.0)).norm()
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

#[inline(always)]
pub(super) fn dot<L: Lanes>(a: &[L; 6], b: &[L; 6]) -> L {
    let [au, av, aw, ax, ay, az] = *a;
    let [bu, bv, bw, bx, by, bz] = *b;
    vector::dot([au, av, aw], [bu, bv, bw]) + vector::dot([ax, ay, az], [bx, by, bz])
}
