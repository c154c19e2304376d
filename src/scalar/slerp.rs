//! Spherical linear interpolation of rotations; interpolation of rotation and translation
//! independently; squad, a smooth motion through key poses.

use super::{DualQuat, Quat, vector};
use crate::number::Real;
use crate::quick;

impl<R: Real> Quat<R> {
    /// Spherical linear interpolation of unit quaternions by the shorter way: the result turns from
    /// `self` (a) to ±`other` (b) about one axis at constant speed. `t` = 0 gives `self`, and 1
    /// gives ±`other`; values outside [0, 1] continue the turn. The result is unit for every `t`.
    /// It is NaN in every component if `t` times half the angle is beyond 2¹⁶ rad (`f32`) or
    /// 2⁴⁵ rad (`f64`).
    ///
    /// The classical formula is sin((1−t)Θ)/sin Θ a ± sin(tΘ)/sin Θ b (Shoemake 1985; Arends
    /// ch. 3 §3, where the angle is given; his ch. 6 notes that sin Θ may vanish). It equals cos
    /// φ m + sin φ h with φ = (t−½)Θ, where m and h are the unit vectors along b + a and b
    /// − a: a turn by φ from the middle m of the way in the direction h. The second form is
    /// computed here, because it has one angle with one sine and one cosine. In the first form
    /// (1−t)Θ and tΘ are rounded independently, by more than a radian where t is large, so the
    /// result could have any length. The angle is Θ = 2 atan2(|b − a|, |b + a|) (Kahan 2006),
    /// because the arccosine of a·b loses small angles. There is no singularity: quaternions by
    /// the shorter way are at most 90° apart, and the sines of small angles are proportional to
    /// the angles.
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
        // The part of the difference along the middle is removed. It is not zero if the lengths of
        // the two quaternions differ. It is small, but if the quaternions are close to each other,
        // it may be a large part of their difference.
        let across = difference - middle.scale(difference.dot(middle));
        let length = across.norm();
        let angle = R::TWO * length.atan2(sum_length);
        let part = t - R::HALF;
        let reach = angle * (R::ONE + part.abs());
        if reach * reach < R::EPSILON {
            // The angles are so small that each equals its sine. Θ itself may be subnormal, and a
            // quotient of subnormal values has few correct digits.
            return middle + across.scale(part);
        }
        let turned = part * angle;
        // An angle whose rounding error may exceed 2⁻⁸ rad gives NaN, as in `DualQuat::exp`.
        let known = (turned * R::EPSILON).abs() * R::from(128.0) <= R::ONE;
        let turned = if known { turned } else { R::NAN };
        middle.scale(turned.cos()) + across.scale(turned.sin() / length)
    }
}

impl<R: Real> DualQuat<R> {
    /// Interpolates the rotation by [`slerp`](Quat::slerp) and the translation linearly, each
    /// independently, as engines without dual quaternions do (quaternion and vector, Kenwright
    /// §3). It serves for comparison. `t` = 0 gives `self`, and 1 gives ±`other`. Outside [0, 1]
    /// both parts extrapolate, the rotation up to the largest angle of `slerp`.
    ///
    /// The origin of the body moves on a straight line at constant speed while the body turns about
    /// it. So this is not a screw motion, and it depends on the choice of the body's origin: in
    /// general slerp_lerp(ac, bc, t) ≠ slerp_lerp(a, b, t)c, but slerp_lerp(ca, cb, t) = c
    /// slerp_lerp(a, b, t). For [`sclerp`](Self::sclerp) both equations hold.
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
    /// Cubic motion from the key pose `self` (σ₀) to the key pose `end` (σ₁). Two control
    /// poses s₀ and s₁ attract the motion, which does not pass through them:
    ///
    /// squad(σ₀, s₀, s₁, σ₁, t) = sclerp(sclerp(σ₀, σ₁, t), sclerp(s₀, s₁, t),
    /// 2t(1−t))
    ///
    /// This is Shoemake's "squad" for rotations (1987, *Quaternion calculus and fast animation*)
    /// with [`sclerp`](Self::sclerp) in place of slerp, by the transfer principle. `t` = 0 gives
    /// `self`, and 1 gives ±`end`. With controls from [`squad_control`](Self::squad_control),
    /// linear and angular velocity are continuous across evenly timed keys. Signs do not matter:
    /// each of the three interpolations takes the shorter way, so consecutive keys should be less
    /// than half a turn apart.
    ///
    /// All poses must be unit. `t` is meant for [0, 1]. Outside this range the outer interpolation
    /// extrapolates, because 2t(1−t) is negative, and the deviation of its two ends from unit
    /// length grows with t³.
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

    /// Returns the control pose s of the key pose σ = `current`, between the keys σ₋ and σ₊,
    /// for [`squad`](Self::squad):
    ///
    /// s = σ exp(−(log(σ*σ₊) + log(σ*σ₋))/4) (Shoemake 1987, with dual quaternions)
    ///
    /// With this control the velocity at σ is the mean of two screws: from the previous key to σ,
    /// and from σ to the next key. At an end of a path, pass the key itself in place of the
    /// neighbour that is missing, or use the key as its own control. Keys evenly spaced along a
    /// screw are their own controls.
    ///
    /// All poses must be unit.
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
