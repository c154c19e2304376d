//! Axis and angle of a rotation (Kenwright §3.4), as a pair and as their product.

use crate::number::Real;
use crate::scalar::{Quat, vector};

impl<R: Real> Quat<R> {
    /// The axis, of length 1, and the angle in [0, π] radians of a unit quaternion, n and θ of
    /// ±q = cos(θ/2) + n sin(θ/2). Of ±q the [canonical](crate::DualQuat::canonical) one is
    /// taken: w ≥ 0, and at half a turn, where both n and −n are axes, the first component of n
    /// that is not zero is positive. No turn has the axis (1, 0, 0).
    ///
    /// The angle is twice the arctangent of |n sin(θ/2)| and w, accurate for all angles, where
    /// 2 arccos w loses half of the digits of a small one.
    ///
    /// ```
    /// use dq8::Quat;
    /// let (axis, angle) = Quat::from_axis_angle([0.0, 0.6, 0.8], 1e-30_f64).to_axis_angle();
    /// assert_eq!((axis, angle), ([0.0, 0.6, 0.8], 1e-30));
    /// ```
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_axis_angle(self) -> ([R; 3], R) {
        crate::scalar::must_be_unit::rotations("Quat::to_axis_angle", [self]);
        let short = if self.points_back() { -self } else { self };
        let sine = vector::norm(short.xyz());
        if sine == R::ZERO {
            // Zero, but for a w that is no number.
            return ([R::ONE, R::ZERO, R::ZERO], R::ZERO * short.w());
        }
        (vector::direction(short.xyz(), sine), R::TWO * sine.atan2(short.w()))
    }

    /// The turn by |v| radians about the direction of v, the exponential of v/2. Any v; the error
    /// of a large angle is that of its rounding.
    ///
    /// ```
    /// use dq8::Quat;
    /// assert_eq!(Quat::from_scaled_axis([0.0_f32; 3]), Quat::IDENTITY);
    /// ```
    #[doc(alias("from_rotvec", "rotvec", "rotation_vector", "exp3"))]
    pub fn from_scaled_axis(v: [R; 3]) -> Self {
        // cos(θ/2) and sin(θ/2)/θ are 1 and ½ to the last place, and their derivatives finite.
        if vector::dot(v, v) < R::EPSILON {
            return Self::from_parts(vector::scale(v, R::HALF), R::ONE);
        }
        let angle = vector::norm(v);
        let half = angle * R::HALF;
        Self::from_parts(vector::scale(v, half.sin() / angle), half.cos())
    }

    /// The axis of a unit quaternion times the angle, of length [0, π], as
    /// [`to_axis_angle`](Self::to_axis_angle) has them; zero for no turn.
    ///
    /// ```
    /// use dq8::Quat;
    /// let half_turn = Quat::from_xyzw(0.0_f64, 1.0, 0.0, 0.0);
    /// assert_eq!(half_turn.to_scaled_axis(), [0.0, core::f64::consts::PI, 0.0]);
    /// ```
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("as_rotvec", "rotvec", "rotation_vector", "log3"))]
    pub fn to_scaled_axis(self) -> [R; 3] {
        crate::scalar::must_be_unit::rotations("Quat::to_scaled_axis", [self]);
        let short = if self.points_back() { -self } else { self };
        let squared = vector::dot(short.xyz(), short.xyz());
        // θ/sin(θ/2) is 2/cos(θ/2) to the last place, and its derivative finite.
        let scale = if squared < R::EPSILON {
            R::TWO / short.w()
        } else {
            let sine = squared.sqrt();
            R::TWO * sine.atan2(short.w()) / sine
        };
        vector::scale(short.xyz(), scale)
    }
}
