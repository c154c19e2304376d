//! Velocity: σ̇ from twists and back, and integration of a constant twist.

use super::{Dual, DualQuat, Quat, vector};
use crate::geometry::{DualVector, Twist};
use crate::number::Real;

impl<R: Real> DualQuat<R> {
    /// σ̇ = ½ξσ for the *spatial* twist ξ = ω + εv: fixed axes, v = ṫ − ω × t is the
    /// velocity of the point of the body that is at the fixed origin. Jia has no twist: put into
    /// his eq. 45, which is [`derivative_from_velocity`](Self::derivative_from_velocity), this v
    /// makes the product. ω is in radians per unit of time, v in lengths per unit of time. Linear
    /// in both, so σ need not be unit.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let pose = DualQuat::from_translation([2.0_f32, 0.0, 0.0]);
    /// let turning = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// let (angular, linear) = pose.velocity(pose.derivative_spatial(turning));
    /// assert_eq!((angular, linear), ([0.0, 0.0, 1.0], [0.0, 2.0, 0.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn derivative_spatial(self, twist: Twist<R>) -> Self {
        (pure(twist) * self).scale(R::HALF)
    }

    /// σ̇ = ½σξ for the *body* twist ξ = ω + εv: the axes and the origin of the moving
    /// frame, v is ṫ in those axes. Units as for
    /// [`derivative_spatial`](Self::derivative_spatial), whose twist is Ad_σ of this one (Murray,
    /// Li, Sastry 1994, §2.4).
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let pose = DualQuat::from_translation([2.0_f32, 0.0, 0.0]);
    /// let turning = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// let (angular, linear) = pose.velocity(pose.derivative_body(turning));
    /// assert_eq!((angular, linear), ([0.0, 0.0, 1.0], [0.0; 3]));
    /// ```
    #[inline]
    #[must_use]
    pub fn derivative_body(self, twist: Twist<R>) -> Self {
        (self * pure(twist)).scale(R::HALF)
    }

    /// The spatial twist 2σ̇σ* of a unit σ that changes by σ̇ per unit of time; undoes
    /// [`derivative_spatial`](Self::derivative_spatial), whose formula times 2σ* it is. Scalar
    /// parts, zero where σ̇ keeps σ unit, are dropped. Jia's eq. 45 solved for the twist.
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn spatial_twist(self, derivative: Self) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::spatial_twist", [self]);
        of_pure((derivative * self.conjugate()).scale(R::TWO))
    }

    /// The body twist 2σ*σ̇ of a unit σ that changes by σ̇ per unit of time; undoes
    /// [`derivative_body`](Self::derivative_body), as [`spatial_twist`](Self::spatial_twist) does.
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn body_twist(self, derivative: Self) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::body_twist", [self]);
        of_pure((self.conjugate() * derivative).scale(R::TWO))
    }

    /// σ̇ = ½ωr + ½ε(ṫr + ½tωr) (Jia §9, after eq. 45): `angular` is ω in *fixed* axes,
    /// radians per unit of time; `linear` is **ṫ**, the velocity of the body's own origin in
    /// fixed axes, and not the linear part of a spatial twist, which is ṫ − ω × t. σ must be
    /// unit.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let pose = DualQuat::from_translation([2.0_f32, 0.0, 0.0]);
    /// let rate = pose.derivative_from_velocity([0.0, 0.0, 1.0], [0.0, 5.0, 0.0]);
    /// let twist = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0, 3.0, 0.0] };
    /// assert_eq!(pose.spatial_twist(rate), twist);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn derivative_from_velocity(self, angular: [R; 3], linear: [R; 3]) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::derivative_from_velocity", [self]);
        let r = self.rotation();
        let t = Quat::from_parts(self.translation(), R::ZERO);
        let rotating = (Quat::from_parts(angular, R::ZERO) * r).scale(R::HALF);
        let moving = Quat::from_parts(linear, R::ZERO) * r;
        Self::new(rotating, (moving + t * rotating).scale(R::HALF))
    }

    /// (ω, ṫ) of a unit σ that changes by σ̇ per unit of time: the angular velocity, and the
    /// velocity of the body's own origin, both in fixed axes; undoes
    /// [`derivative_from_velocity`](Self::derivative_from_velocity).
    ///
    /// ω = 2ṙr* (Jia §9), and by the product rule on t = 2qp* (his eq. 24), ṫ = 2(q̇p* +
    /// qṗ*).
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn velocity(self, derivative: Self) -> ([R; 3], [R; 3]) {
        crate::scalar::must_be_unit::motions("DualQuat::velocity", [self]);
        let back = self.real().conjugate();
        let angular = (derivative.real() * back).scale(R::TWO);
        let moving = derivative.dual() * back + self.dual() * derivative.real().conjugate();
        (angular.xyz(), moving.scale(R::TWO).xyz())
    }

    /// The motion that a constant twist makes in unit time, exp(½ξ) (the half as in Jia eq. 43).
    /// Any twist, radians and lengths per unit of time; undoes [`to_twist`](Self::to_twist).
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let twist = Twist { angular: [0.0_f32; 3], linear: [1.0, 2.0, 3.0] };
    /// assert_eq!(DualQuat::from_twist(twist).translation(), [1.0, 2.0, 3.0]);
    /// ```
    #[inline]
    #[must_use]
    #[doc(alias("exp6"))]
    pub fn from_twist(twist: Twist<R>) -> Self {
        Self::exp(half(twist))
    }

    /// The constant twist that makes the motion in unit time, 2 log σ, |ω| ≤ π; spatial and
    /// body are the same here. In other words, the logarithm of SE(3) in the usual units:
    /// [`log`](Self::log) is that of the dual quaternion, half of it. σ must be unit.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let twist = DualQuat::from_translation([1.0_f32, 2.0, 3.0]).to_twist();
    /// assert_eq!((twist.angular, twist.linear), ([0.0; 3], [1.0, 2.0, 3.0]));
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("log6"))]
    pub fn to_twist(self) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::to_twist", [self]);
        let log = self.log();
        Twist { angular: vector::scale(log.real, R::TWO), linear: vector::scale(log.dual, R::TWO) }
    }

    /// The constant *body* twist that takes σ to `other` in unit time, 2 log(σ* other), by the
    /// shorter way: |ω| ≤ π (the logarithm of X⁻¹Y in Lynch and Park 2017, section 9.2.1).
    /// Radians and lengths per unit of time, in the axes of σ;
    /// [`integrate_body`](Self::integrate_body) for unit time gives ±`other`. What a controller
    /// feeds back as error of pose. Both must be unit; exactly half a turn apart either way is as
    /// short.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], core::f64::consts::FRAC_PI_2);
    /// let pose = DualQuat::from_rotation_translation(turn, [5.0, 0.0, 0.0]);
    /// let goal = DualQuat::from_rotation_translation(turn, [5.0, 2.0, 0.0]);
    /// // What is left in space is ahead of the body.
    /// let [x, y, _] = pose.twist_to(goal).linear;
    /// assert!((x - 2.0).abs() < 1e-15 && y.abs() < 1e-15);
    /// ```
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("inv_mul", "relative_pose", "log6", "pose_error"))]
    pub fn twist_to(self, other: Self) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::twist_to", [self, other]);
        (self.conjugate() * other).to_twist()
    }

    /// The pose of a body at σ after `dt` of a constant *spatial* twist: exp(½ξ dt) σ, exact
    /// for any step, `dt` of either sign (the solution of σ̇ = ½ξσ; Brockett 1984). Over many
    /// steps the norm drifts by rounding alone; [`normalize`](Self::normalize) now and then.
    ///
    /// ```
    /// use dq8::{DualQuat, Twist};
    /// let pose = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let turning = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0; 3] };
    /// let [x, y, _] = pose.integrate_spatial(turning, core::f64::consts::PI).translation();
    /// assert!((x + 1.0).abs() < 1e-15 && y.abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn integrate_spatial(self, twist: Twist<R>, dt: R) -> Self {
        Self::from_twist(twist.scale(dt)) * self
    }

    /// The pose of a body at σ after `dt` of a constant *body* twist: σ exp(½ξ dt), exact for
    /// any step; as [`integrate_spatial`](Self::integrate_spatial), but for the side.
    #[inline]
    #[must_use]
    pub fn integrate_body(self, twist: Twist<R>, dt: R) -> Self {
        self * Self::from_twist(twist.scale(dt))
    }
}

/// ω + εv as a dual quaternion without scalar parts.
#[inline]
fn pure<R: Real>(twist: Twist<R>) -> DualQuat<R> {
    let vector = DualVector { real: twist.angular, dual: twist.linear };
    DualQuat::from_dual_parts(Dual::ZERO, vector)
}

/// Returns the vector parts as a twist. The scalar parts of σ̇σ* are zero for unit σ.
#[inline]
fn of_pure<R: Real>(sigma: DualQuat<R>) -> Twist<R> {
    Twist { angular: sigma.real().xyz(), linear: sigma.dual().xyz() }
}

/// Returns half the twist, because quaternions carry half the angle.
#[inline]
fn half<R: Real>(twist: Twist<R>) -> DualVector<R> {
    DualVector {
        real: vector::scale(twist.angular, R::HALF),
        dual: vector::scale(twist.linear, R::HALF),
    }
}
