//! What a change of frame does to twists and wrenches.

use super::DualQuat;
use crate::geometry::{Twist, Wrench};
use crate::number::Real;

impl<R: Real> Twist<R> {
    /// The twist of a body at rest.
    pub const ZERO: Self = Self::from_array([R::ZERO; 6]);
}

impl<R: Real> DualQuat<R> {
    /// Ad_σ ξ = σ(ω + εv)σ*: ω′ = Rω, v′ = Rv + t × ω′ (Murray, Li, Sastry 1994,
    /// eq. 2.58), as lines move. Takes a twist in the body's frame to the fixed frame;
    /// `conjugate().adjoint()` takes it back. Ad_{ab} = Ad_a Ad_b. σ must be unit.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let pose = DualQuat::from_translation([2.0_f32, 0.0, 0.0]);
    /// let turning = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// // At the fixed origin, what turns with a body at x = 2 moves down.
    /// assert_eq!(pose.adjoint(turning).linear, [0.0, -2.0, 0.0]);
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("action_matrix", "Ad"))]
    pub fn adjoint(self, twist: Twist<R>) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::adjoint", [self]);
        let (angular, linear) = self.carry(twist.angular, twist.linear);
        Twist { angular, linear }
    }

    /// The co-adjoint action on wrenches: f′ = Rf, τ′ = Rτ + t × f′, so that the power of
    /// a wrench on a twist is the same in both frames. Takes a wrench in the body's frame to the
    /// fixed frame. σ must be unit.
    ///
    /// This is (Ad_σ⁻¹)ᵀ, a left action: coadjoint of ab is that of b, then that of a
    /// (Murray, Li and Sastry 1994, §2.5).
    ///
    /// ```
    /// use dq8::{DualQuat, geometry::Wrench};
    /// let pose = DualQuat::from_translation([2.0_f32, 0.0, 0.0]);
    /// let weight = Wrench { force: [0.0, 0.0, -9.0], torque: [0.0; 3] };
    /// assert_eq!(pose.coadjoint(weight).torque, [0.0, 18.0, 0.0]);
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn coadjoint(self, wrench: Wrench<R>) -> Wrench<R> {
        crate::scalar::must_be_unit::motions("DualQuat::coadjoint", [self]);
        let (force, torque) = self.carry(wrench.force, wrench.torque);
        Wrench { force, torque }
    }
}
