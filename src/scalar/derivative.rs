//! Velocity: σ̇ from twists, twists from σ̇, and integration of a constant twist.

use super::{Dual, DualQuat, Quat, vector};
use crate::geometry::{DualVector, Twist};
use crate::number::Real;

impl<R: Real> DualQuat<R> {
    /// Returns the derivative by time σ̇ = ½ξσ for the *spatial* twist ξ = ω + εv, which is
    /// given in fixed axes. Its linear part v = ṫ − ω × t is the velocity of the body's point
    /// that is now at the fixed origin. Jia has no twist; with this v his eq. 45, which is
    /// [`derivative_from_velocity`](Self::derivative_from_velocity), becomes this product. ω is in
    /// radians per unit of time, v in lengths per unit of time. The formula is linear in σ and ξ,
    /// so σ need not be unit.
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

    /// Returns the derivative by time σ̇ = ½σξ for the *body* twist ξ = ω + εv, which is
    /// given in the axes and about the origin of the moving frame: v is ṫ in these axes. ω is in
    /// radians per unit of time, v in lengths per unit of time. The spatial twist of the same
    /// velocity is Ad_σ ξ (Murray, Li, Sastry 1994, §2.4).
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

    /// Returns the spatial twist 2σ̇σ* of a unit σ that changes by σ̇ per unit of time (Jia's
    /// eq. 45 solved for the twist). It undoes [`derivative_spatial`](Self::derivative_spatial).
    /// The scalar parts of the product are dropped; they are zero if σ̇ keeps σ unit.
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn spatial_twist(self, derivative: Self) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::spatial_twist", [self]);
        of_pure((derivative * self.conjugate()).scale(R::TWO))
    }

    /// Returns the body twist 2σ*σ̇ of a unit σ that changes by σ̇ per unit of time. It
    /// undoes [`derivative_body`](Self::derivative_body). The scalar parts of the product are
    /// dropped; they are zero if σ̇ keeps σ unit.
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn body_twist(self, derivative: Self) -> Twist<R> {
        crate::scalar::must_be_unit::motions("DualQuat::body_twist", [self]);
        of_pure((self.conjugate() * derivative).scale(R::TWO))
    }

    /// Returns the derivative by time σ̇ = ½ωr + ½ε(ṫr + ½tωr) (Jia §9, after eq. 45).
    /// `angular` is ω in *fixed* axes, in radians per unit of time. `linear` is **ṫ**, the
    /// velocity of the body's own origin in fixed axes; the linear part of a spatial twist is ṫ
    /// − ω × t instead. σ must be unit.
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

    /// Returns (ω, ṫ) of a unit σ that changes by σ̇ per unit of time: the angular velocity,
    /// and the velocity of the body's own origin, both in fixed axes. It undoes
    /// [`derivative_from_velocity`](Self::derivative_from_velocity).
    ///
    /// The formulas are ω = 2ṙr* (Jia §9) and ṫ = 2(q̇p* + qṗ*), which follows from t =
    /// 2qp* (Jia's eq. 24) by the product rule.
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

    /// Returns the motion that a constant twist makes in unit time, exp(½ξ) (with the half of
    /// Jia's eq. 43). Any twist is allowed; it is in radians and lengths per unit of time. This
    /// function is the inverse of [`to_twist`](Self::to_twist).
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

    /// Returns the constant twist that makes the motion in unit time, 2 log σ, with |ω| ≤ π.
    /// The spatial and the body twist of this motion are the same. This is the logarithm of SE(3)
    /// in the usual units; [`log`](Self::log) is the logarithm of the dual quaternion, half as
    /// large. σ must be unit.
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

    /// Returns the constant *body* twist that takes σ to `other` in unit time by the shorter way,
    /// 2 log(σ* other), with |ω| ≤ π (the logarithm of X⁻¹Y in Lynch and Park 2017, section
    /// 9.2.1). It is in radians and lengths per unit of time, in the axes of σ;
    /// [`integrate_body`](Self::integrate_body) of σ with this twist for unit time gives
    /// ±`other`. Controllers use this twist as the error of a pose. Both motions must be unit. If
    /// they are exactly half a turn apart, both ways are equally short.
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

    /// Returns the pose of a body at σ after the time `dt` with a constant *spatial* twist:
    /// exp(½ξ dt) σ, the exact solution of σ̇ = ½ξσ for steps of any length and either sign
    /// (Brockett 1984). Over many steps the norm drifts by rounding alone, so
    /// [`normalize`](Self::normalize) the pose now and then.
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

    /// Returns the pose of a body at σ after the time `dt` with a constant *body* twist: σ
    /// exp(½ξ dt), the exact solution of σ̇ = ½σξ for steps of any length and either sign.
    #[inline]
    #[must_use]
    pub fn integrate_body(self, twist: Twist<R>, dt: R) -> Self {
        self * Self::from_twist(twist.scale(dt))
    }
}

/// Returns ω + εv as a dual quaternion without scalar parts.
#[inline]
fn pure<R: Real>(twist: Twist<R>) -> DualQuat<R> {
    let vector = DualVector { real: twist.angular, dual: twist.linear };
    DualQuat::from_dual_parts(Dual::ZERO, vector)
}

/// Returns the vector parts of a dual quaternion as a twist, and drops the scalar parts.
#[inline]
fn of_pure<R: Real>(sigma: DualQuat<R>) -> Twist<R> {
    Twist { angular: sigma.real().xyz(), linear: sigma.dual().xyz() }
}

/// Returns half the twist, because the logarithm of a motion has half the angle and half the slide.
#[inline]
fn half<R: Real>(twist: Twist<R>) -> DualVector<R> {
    DualVector {
        real: vector::scale(twist.angular, R::HALF),
        dual: vector::scale(twist.linear, R::HALF),
    }
}
