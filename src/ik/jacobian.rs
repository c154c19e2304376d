//! Where the end of an arm is on lanes, and how it moves with each joint.

use super::Arm;
use crate::batch::{DualQuat, vector};
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
    /// [`Hierarchy::jacobian`](crate::Hierarchy::jacobian).
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
            let screw = Twist::from_array(vector::splat(level, joint.screw.to_array()));
            *column = pose.adjoint(screw);
            pose = pose * DualQuat::from_twist(screw.scale(value));
        }
        (pose * DualQuat::splat(level, self.home.to_array()), columns)
    }
}
