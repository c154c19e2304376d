//! Interpolation of rotations by slerp; interpolation of rotation and translation independently;
//! squad, a smooth motion through key poses.

use super::{DualQuat, Quat, vector};
use crate::geometry::DualVector;
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// Interpolates from `self` to ±`other` by a turn about one axis at constant speed, by the
    /// shorter way; `t` may differ from lane to lane. The result is NaN where that of
    /// [`sclerp`](DualQuat::sclerp) is NaN.
    ///
    /// It is computed as [`sclerp`](DualQuat::sclerp) of pure rotations, and the dual part is
    /// discarded.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn slerp(self, other: Self, t: L) -> Self {
        DualQuat::from_rotation(self).sclerp(DualQuat::from_rotation(other), t).real()
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Interpolates the rotation by slerp and the translation linearly; `t` may differ from lane to
    /// lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn slerp_lerp(self, other: Self, t: L) -> Self {
        let rotation = self.rotation().slerp(other.rotation(), t);
        let start = vector::scale(self.translation(), t.constant(1.0) - t);
        let translation = vector::scale_onto(other.translation(), t, start);
        Self::from_rotation_translation(rotation, translation)
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Returns sclerp(sclerp(σ₀, σ₁, t), sclerp(s₀, s₁, t), 2t(1−t)) from σ₀ =
    /// `self` to σ₁ = `end`, with the control poses s₀ and s₁; `t` may differ from lane to
    /// lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn squad(self, control_start: Self, control_end: Self, end: Self, t: L) -> Self {
        let along_keys = self.sclerp(end, t);
        let along_controls = control_start.sclerp(control_end, t);
        along_keys.sclerp(along_controls, (t + t) * (t.constant(1.0) - t))
    }

    /// Returns the control pose σ exp(−(log(σ*σ₊) + log(σ*σ₋))/4) of the key σ =
    /// `current` between the keys σ₋ = `previous` and σ₊ = `next`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn squad_control(previous: Self, current: Self, next: Self) -> Self {
        let inverse = current.conjugate();
        let (ahead, back) = ((inverse * next).log(), (inverse * previous).log());
        let minus_quarter = current.real().w().constant(-0.25);
        let log = DualVector {
            real: vector::scale(vector::add(ahead.real, back.real), minus_quarter),
            dual: vector::scale(vector::add(ahead.dual, back.dual), minus_quarter),
        };
        current * Self::exp(log)
    }
}
