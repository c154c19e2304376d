//! Where the end of an arm is on lanes, and how it moves with each joint.

use super::Arm;
use crate::batch::DualQuat;
use crate::geometry::Twist;
use crate::real::Scalar;
use dq8_simd::Lanes;

impl<R: Scalar, const N: usize> Arm<R, N> {
    /// [`forward`](Self::forward) on lanes.
    #[cfg_attr(not(opt_level_0), inline(always))]
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
    /// [`Job::jacobians`](crate::mechanism::Job::jacobians).
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn forward_jacobian<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: &[L; N],
    ) -> (DualQuat<L>, [Twist<L>; N]) {
        self.chain.pose_and_screws(level, values)
    }
}
