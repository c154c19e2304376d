//! Smooth motion through key poses.

use super::DualQuat;
use crate::number::Real;

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
