//! Spherical linear interpolation of rotations, and rotation and translation interpolated apart.

use super::{DualQuat, Quat, vector};
use crate::everyday;
use crate::real::Real;

impl<R: Real> Quat<R> {
    /// Spherical linear interpolation of unit quaternions by the shorter way: turns from `self` to
    /// ±`other` about one axis at constant speed. `t` = 0 gives `self`, 1 gives ±`other`; values
    /// outside [0, 1] go on turning.
    ///
    /// sin((1−t)Θ)/sin Θ a ± sin(tΘ)/sin Θ b (Shoemake 1985; Arends ch. 3 §3, whose angle is given and whose
    /// sines vanish in his ch. 6). The angle is
    /// Θ = 2 atan2(|b − a|, |b + a|) (Kahan 2006), not the arccosine of a·b, which has lost a small
    /// one. No singularity: quaternions by the shorter way are at most 90° apart, and close ones
    /// have both sines in proportion to their arguments.
    ///
    /// ```
    /// use dq8::Quat;
    /// let tiny = Quat::from_xyzw(0.0_f32, 1e-30, 0.0, 1.0);
    /// assert_eq!(Quat::IDENTITY.slerp(tiny, 0.25).y(), 0.25e-30);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn slerp(self, other: Self, t: R) -> Self {
        crate::must_be_unit::rotations("Quat::slerp", [self, other]);
        if let Some(turned) = R::quick(everyday::Slerp(self.to_array(), other.to_array(), t)) {
            return Self::from_array(turned);
        }
        self.apart().slerp_by_the_book(other.apart(), t).apart()
    }

    #[inline(never)]
    fn slerp_by_the_book(self, other: Self, t: R) -> Self {
        let near = if self.dot(other) < R::ZERO { -other } else { other };
        let angle = R::TWO * (near - self).norm().atan2((near + self).norm());
        let reach = angle * (R::ONE + t.abs());
        if reach * reach < R::EPSILON {
            // Every angle here is its own sine, and Θ itself may be subnormal, with no ratio left.
            return self.scale(R::ONE - t) + near.scale(t);
        }
        let sine = angle.sin();
        self.scale(((R::ONE - t) * angle).sin() / sine) + near.scale((t * angle).sin() / sine)
    }
}

impl<R: Real> DualQuat<R> {
    /// Rotation by [`slerp`](Quat::slerp) and translation by LERP, each for itself: what engines
    /// without dual quaternions do (quaternion and vector, Kenwright §3), here to compare with. `t` = 0 gives `self`, 1 gives ±`other`.
    ///
    /// The origin of the body moves on a straight line at constant speed and the body turns about
    /// it, so this is not a screw motion, and it depends on which point of the body is the origin: for
    /// a motion c on the right, slerp_lerp(ac, bc, t) ≠ slerp_lerp(a, b, t)c, where
    /// [`sclerp`](Self::sclerp) has equality on both sides. A common motion on the left, of the
    /// world, it does keep.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// // A quarter of a turn about the z axis carries (1,0,0) to (0,1,0) on a circle.
    /// let start = DualQuat::from_translation([1.0_f64, 0.0, 0.0]);
    /// let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], core::f64::consts::FRAC_PI_2);
    /// let end = DualQuat::from_rotation(turn) * start;
    /// let distance = |motion: DualQuat<f64>| {
    ///     let [x, y, _] = motion.translation();
    ///     x.hypot(y)
    /// };
    /// assert!((distance(start.sclerp(end, 0.5)) - 1.0).abs() < 1e-15);
    /// assert!((distance(start.slerp_lerp(end, 0.5)) - 0.5_f64.sqrt()).abs() < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn slerp_lerp(self, other: Self, t: R) -> Self {
        crate::must_be_unit::motions("DualQuat::slerp_lerp", [self, other]);
        let rotation = self.rotation().slerp(other.rotation(), t);
        let start = vector::scale(self.translation(), R::ONE - t);
        let end = vector::scale(other.translation(), t);
        Self::from_rotation_translation(rotation, vector::add(start, end))
    }
}
