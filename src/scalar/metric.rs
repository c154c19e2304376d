//! Distances between motions.

use super::{DualQuat, Quat, vector};
use crate::number::Real;

impl<R: Real> Quat<R> {
    /// The angle of the turn between two rotations by the shorter way, radians in [0, π]; of unit
    /// quaternions of either sign. As [`DualQuat::angle_to`], which says how.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("angle_between"))]
    pub fn angle_to(self, other: Self) -> R {
        crate::scalar::must_be_unit::rotations("Quat::angle_to", [self, other]);
        let between = self.conjugate() * other;
        if !between.norm().is_finite() {
            return R::NAN;
        }
        R::TWO * vector::norm(between.xyz()).atan2(between.w().abs())
    }
}

impl<R: Real> DualQuat<R> {
    /// The angle between two orientations, radians in [0, π]: of the turn from one to the other,
    /// by the shorter way, so the signs of both σ do not matter. Kenwright §11 names it an
    /// advantage of dual quaternions: from matrices it takes a conversion.
    ///
    /// θ = 2 atan2(|v|, |w|) with w + v = p_a*p_b. An arccosine of p_a·p_b has lost small angles
    /// (below 5·10⁻⁴ in `f32`); this keeps them, down to subnormal ones next to the identity,
    /// and is as good near π. Elsewhere the rounding of the components themselves is what limits
    /// it.
    ///
    /// Both must be unit. NaN if a real part is not finite.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let turn = |angle: f32| DualQuat::from_rotation(Quat::from_rotation_x(angle));
    /// assert_eq!(turn(0.0).angle_to(turn(1e-20)), 1e-20);
    /// assert_eq!(turn(0.0).angle_to(-turn(1e-20)), 1e-20);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("angle_between"))]
    pub fn angle_to(self, other: Self) -> R {
        crate::scalar::must_be_unit::motions("DualQuat::angle_to", [self, other]);
        self.real().angle_to(other.real())
    }

    /// The distance between two positions, |t_a − t_b|, in the user's unit of length. It does not
    /// overflow or underflow on the way, and the signs of both σ do not matter. Both must be unit.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let at = |x: f32, y: f32| DualQuat::from_translation([x, y, 0.0]);
    /// assert_eq!(at(1.0, 1.0).distance_to(-at(4.0, 5.0)), 5.0);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn distance_to(self, other: Self) -> R {
        crate::scalar::must_be_unit::motions("DualQuat::distance_to", [self, other]);
        vector::norm(vector::sub(self.translation(), other.translation()))
    }

    /// √((λθ)² + d²): angle and distance in one number, a length. λ = `length_per_radian`
    /// says what a radian is worth; the radius of the body is a good choice, for then λθ is how
    /// far its outermost points turn (Park 1995 has why some such length must be chosen).
    ///
    /// For λ > 0 it is a metric on motions (on ±σ, not on σ): zero only for equal motions,
    /// symmetric, and d(a, c) ≤ d(a, b) + d(b, c), because angles of rotation and distances of
    /// points keep the triangle inequality and so does the root of the sum of their squares. It is
    /// the same after a common motion of the world, d(ca, cb) = d(a, b), but not after one of the
    /// body, which moves its origin. Both must be unit.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let (a, b) = (DualQuat::IDENTITY, DualQuat::from_translation([3.0_f32, 0.0, 4.0]));
    /// assert_eq!(a.distance_weighted(b, 0.5), 5.0);
    /// assert_eq!(a.distance_weighted(-a, 0.5), 0.0);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn distance_weighted(self, other: Self, length_per_radian: R) -> R {
        crate::scalar::must_be_unit::motions("DualQuat::distance_weighted", [self, other]);
        vector::norm([length_per_radian * self.angle_to(other), self.distance_to(other)])
    }

    /// The distance to which the two carry one point of the body: |a v − b v|. Both must be unit.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let (a, b) = (DualQuat::IDENTITY, DualQuat::from_translation([3.0_f32, 0.0, 4.0]));
    /// assert_eq!(a.point_error(b, [7.0, 8.0, 9.0]), 5.0);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn point_error(self, other: Self, point: [R; 3]) -> R {
        crate::scalar::must_be_unit::motions("DualQuat::point_error", [self, other]);
        vector::norm(vector::sub(self.transform_point(point), other.transform_point(point)))
    }

    /// The largest distance to which the two carry a point within `radius` of the body's origin:
    /// d + 2 r sin(θ/2), an upper bound of [`point_error`](Self::point_error). What compressors of
    /// animation measure with a shell of points about each bone, without choosing any. In none of
    /// the sources of dq8.
    ///
    /// By the triangle inequality |av − bv| ≤ |t_a − t_b| + |(R_a − R_b)v|, and a turn by
    /// θ moves a point at most by the chord 2|v| sin(θ/2). The bound is reached where the
    /// translation between the two is across the axis of the turn between them, or zero. Both must
    /// be unit.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let half_turn = DualQuat::from_rotation(Quat::from_xyzw(0.0_f32, 0.0, 1.0, 0.0));
    /// assert_eq!(DualQuat::IDENTITY.shell_error(half_turn, 3.0), 6.0);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn shell_error(self, other: Self, radius: R) -> R {
        crate::scalar::must_be_unit::motions("DualQuat::shell_error", [self, other]);
        let chord = R::TWO * (self.angle_to(other) * R::HALF).sin();
        self.distance_to(other) + radius * chord
    }

    /// `true` if σ has drifted from the unit ones by more than `tolerance`, or is not finite: not
    /// [`is_unit`](Self::is_unit). A product adds about one [`EPSILON`](Real::EPSILON).
    ///
    /// [`normalize`](Self::normalize) then puts it back; it does not bring back the lost accuracy
    /// of the rotation, so a chain need not be normalized at every product.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let motion = DualQuat::from_translation([1.0_f32, 2.0, 3.0]);
    /// assert!(!motion.needs_renormalization(1e-6));
    /// assert!(motion.scale(1.001).needs_renormalization(1e-6));
    /// ```
    #[inline]
    #[must_use]
    pub fn needs_renormalization(self, tolerance: R) -> bool {
        !self.is_unit(tolerance)
    }
}
