//! Distances between motions.

use super::{DualQuat, Quat, vector};
use crate::number::Real;

impl<R: Real> Quat<R> {
    /// Returns the angle of the turn between two rotations by the shorter way, in radians in [0,
    /// π]. The quaternions are unit and of either sign. [`DualQuat::angle_to`] has the formula.
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
    /// Returns the angle of the turn from one orientation to the other by the shorter way, in
    /// radians in [0, π]. The signs of both σ do not matter. Kenwright §11 names this angle as
    /// an advantage of dual quaternions: with matrices, a conversion is needed first.
    ///
    /// θ = 2 atan2(|v|, |w|) with w + v = p_a*p_b. An arccosine of p_a·p_b loses small angles
    /// (below 5·10⁻⁴ in `f32`). The arctangent keeps them, down to subnormal angles next to
    /// the identity, and it is as accurate near π. For other pairs of poses, the rounding of the
    /// components limits the accuracy.
    ///
    /// Both motions must be unit. The result is NaN if a real part is not finite.
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

    /// Returns the distance between two positions, |t_a − t_b|, in the user's unit of length. No
    /// intermediate result overflows or underflows, and the signs of both σ do not matter. Both
    /// motions must be unit.
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

    /// Returns √((λθ)² + d²), which combines the angle θ and the distance d in one length.
    /// λ = `length_per_radian` is the length that counts as much as one radian. The radius of the
    /// body is a good choice, because λθ is then the distance by which its outermost points turn
    /// (Park 1995 explains why such a length must be chosen).
    ///
    /// For λ > 0 it is a metric on motions (on ±σ, not on σ): it is zero only for equal
    /// motions, symmetric, and d(a, c) ≤ d(a, b) + d(b, c). Angles of rotations and distances of
    /// points obey the triangle inequality, and so does the root of the sum of their squares. The
    /// metric does not change if both motions are multiplied by c on the left (a motion of the
    /// world), d(ca, cb) = d(a, b). It does change if both are multiplied on the right, which moves
    /// the body's origin. Both motions must be unit.
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

    /// Returns |a v − b v|, the distance between the places to which the motions a and b carry
    /// one point v of the body. Both motions must be unit.
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

    /// Returns d + 2 r sin(θ/2), an upper bound of [`point_error`](Self::point_error) for all
    /// points within the distance r = `radius` of the body's origin. Compressors of animation
    /// measure the same error with a shell of points about each bone; this bound needs no choice of
    /// points. None of the sources of dq8 has it.
    ///
    /// By the triangle inequality |av − bv| ≤ |t_a − t_b| + |(R_a − R_b)v|, and a turn by
    /// θ moves a point at most by the chord 2|v| sin(θ/2). The bound is reached if the
    /// translation between the motions is zero or orthogonal to the axis of the turn between them.
    /// Both motions must be unit.
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

    /// Returns `true` if σ has drifted from unit length by more than `tolerance`, or is not
    /// finite; this is the negation of [`is_unit`](Self::is_unit). Each product adds about one
    /// [`EPSILON`](Real::EPSILON) to the drift.
    ///
    /// [`normalize`](Self::normalize) makes σ unit again. It does not restore the lost accuracy of
    /// the rotation, so a chain need not be normalized at every product.
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
