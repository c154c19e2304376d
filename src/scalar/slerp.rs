//! Spherical linear interpolation of rotations, and rotation and translation interpolated apart;
//! squad, smooth motion through key poses.

use super::{DualQuat, Quat, vector};
use crate::number::Real;
use crate::quick;

impl<R: Real> Quat<R> {
    /// Spherical linear interpolation of unit quaternions by the shorter way: turns from `self` to
    /// ±`other` about one axis at constant speed. `t` = 0 gives `self`, 1 gives ±`other`; values
    /// outside [0, 1] go on turning: the result is unit for every `t`, or, where `t` times half the
    /// angle is beyond 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`), NaN in every component.
    ///
    /// sin((1−t)Θ)/sin Θ a ± sin(tΘ)/sin Θ b (Shoemake 1985; Arends ch. 3 §3, whose angle
    /// is given and whose sines vanish in his ch. 6) is the same as cos φ m + sin φ h: the turn
    /// by φ = (t−½)Θ away from the middle m of the way in the direction h, the unit vectors
    /// along b + a and b − a. This is how it is computed: one angle has one sine and one cosine,
    /// but (1−t)Θ and tΘ are rounded apart, by more than a radian where t is large, and the
    /// length would be anything. The angle is Θ = 2 atan2(|b − a|, |b + a|) (Kahan 2006), not
    /// the arccosine of a·b, which has lost a small one. No singularity: quaternions by the
    /// shorter way are at most 90° apart, and close ones have sines in proportion to their
    /// arguments.
    ///
    /// ```
    /// use dq8::Quat;
    /// let tiny = Quat::from_xyzw(0.0_f32, 1e-30, 0.0, 1.0);
    /// assert_eq!(Quat::IDENTITY.slerp(tiny, 0.25).y(), 0.25e-30);
    /// ```
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn slerp(self, other: Self, t: R) -> Self {
        crate::scalar::must_be_unit::rotations("Quat::slerp", [self, other]);
        if let Some(turned) = R::quick(quick::Slerp(self.to_array(), other.to_array(), t)) {
            return Self::from_array(turned);
        }
        self.spilled_copy().slerp_by_the_book(other.spilled_copy(), t).spilled_copy()
    }

    #[inline(never)]
    fn slerp_by_the_book(self, other: Self, t: R) -> Self {
        let near = if self.dot(other) < R::ZERO { -other } else { other };
        let (sum, difference) = (near + self, near - self);
        let sum_length = sum.norm();
        let middle = sum.scale(R::ONE / sum_length);
        // The part of the difference along the middle is removed. It comes from ends of unequal
        // length; it is small, but for close ends it is a large part of the difference.
        let across = difference - middle.scale(difference.dot(middle));
        let length = across.norm();
        let angle = R::TWO * length.atan2(sum_length);
        let part = t - R::HALF;
        let reach = angle * (R::ONE + part.abs());
        if reach * reach < R::EPSILON {
            // Every angle here equals its sine, and Θ itself may be subnormal, so that ratios of
            // it have lost their digits.
            return middle + across.scale(part);
        }
        let turned = part * angle;
        // An angle that is known to no more than 2⁻⁸ rad gives NaN, as in `DualQuat::exp`.
        let known = (turned * R::EPSILON).abs() * R::from(128.0) <= R::ONE;
        let turned = if known { turned } else { R::NAN };
        middle.scale(turned.cos()) + across.scale(turned.sin() / length)
    }
}

impl<R: Real> DualQuat<R> {
    /// Rotation by [`slerp`](Quat::slerp) and translation by LERP, each for itself: what engines
    /// without dual quaternions do (quaternion and vector, Kenwright §3), here to compare with.
    /// `t` = 0 gives `self`, 1 gives ±`other`; beyond, both go on, the rotation as far as `slerp`
    /// does.
    ///
    /// The origin of the body moves on a straight line at constant speed and the body turns about
    /// it, so this is not a screw motion, and it depends on which point of the body is the origin:
    /// for a motion c on the right, slerp_lerp(ac, bc, t) ≠ slerp_lerp(a, b, t)c, where
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
    #[doc(alias("lerp_slerp", "interpolate"))]
    pub fn slerp_lerp(self, other: Self, t: R) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::slerp_lerp", [self, other]);
        let rotation = self.rotation().slerp(other.rotation(), t);
        let start = vector::scale(self.translation(), R::ONE - t);
        let end = vector::scale(other.translation(), t);
        Self::from_rotation_translation(rotation, vector::add(start, end))
    }
}

impl<R: Real> DualQuat<R> {
    /// Cubic motion from the key pose `self` to the key pose `end`, drawn toward two control poses
    /// that it does not pass through:
    ///
    /// squad(σ₀, s₀, s₁, σ₁, t) = sclerp(sclerp(σ₀, σ₁, t), sclerp(s₀, s₁, t),
    /// 2t(1−t))
    ///
    /// It is Shoemake's "squad" for rotations (1987, *Quaternion calculus and fast animation*) with
    /// [`sclerp`](Self::sclerp) for slerp, by the transfer principle. `t` = 0 gives `self`, 1 gives
    /// ±`end`. With controls from [`squad_control`](Self::squad_control), the velocity of point
    /// and angle is continuous across evenly timed keys. Signs do not matter: each of the three
    /// goes the shorter way, so consecutive keys should be less than half a turn apart.
    ///
    /// All must be unit. `t` is meant for [0, 1]: beyond, the last of the three goes on by
    /// 2t(1−t), and what its ends lack of unit length grows with t³.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let at = |x: f64, y: f64| DualQuat::from_translation([x, y, 0.0]);
    /// let keys = [at(0.0, 0.0), at(1.0, 1.0), at(2.0, 0.0), at(3.0, 1.0)];
    /// let s1 = DualQuat::squad_control(keys[0], keys[1], keys[2]);
    /// let s2 = DualQuat::squad_control(keys[1], keys[2], keys[3]);
    /// let middle = keys[1].squad(s1, s2, keys[2], 0.5);
    /// assert_eq!(middle.translation(), [1.5, 0.5, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn squad(self, control_start: Self, control_end: Self, end: Self, t: R) -> Self {
        crate::scalar::must_be_unit::motions(
            "DualQuat::squad",
            [self, control_start, control_end, end],
        );
        let along_keys = self.sclerp(end, t);
        let along_controls = control_start.sclerp(control_end, t);
        along_keys.sclerp(along_controls, R::TWO * t * (R::ONE - t))
    }

    /// The control pose of the key pose `current` for [`squad`](Self::squad):
    ///
    /// s = σ exp(−(log(σ*σ₊) + log(σ*σ₋))/4) (Shoemake 1987, with dual quaternions)
    ///
    /// so that the motion passes through σ with the mean of the screws from the key before and to
    /// the key after. At the ends of a path, give the key itself for the neighbour it has not, or
    /// take the key as its own control. Keys evenly spaced along a screw are their own controls.
    ///
    /// All must be unit.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let at = |x: f32| DualQuat::from_translation([x, 0.0, 0.0]);
    /// assert_eq!(DualQuat::squad_control(at(0.0), at(1.0), at(2.0)), at(1.0));
    /// assert_eq!(DualQuat::squad_control(at(0.0), at(1.0), at(4.0)), at(0.5));
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn squad_control(previous: Self, current: Self, next: Self) -> Self {
        crate::scalar::must_be_unit::motions("DualQuat::squad_control", [previous, current, next]);
        let inverse = current.conjugate();
        let (ahead, back) = ((inverse * next).log(), (inverse * previous).log());
        current * Self::exp((ahead + back).scale(-R::HALF * R::HALF))
    }
}
