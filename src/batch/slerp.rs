//! Spherical linear interpolation of rotations, and rotation and translation interpolated apart.

use super::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// Turns from `self` to ±`other` about one axis at constant speed, by the shorter way; `t` may
    /// differ from lane to lane. As far as [`sclerp`](DualQuat::sclerp), and NaN beyond.
    ///
    /// The screw motion of pure rotations: the dual part that it computes is discarded.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn slerp(self, other: Self, t: L) -> Self {
        DualQuat::from_rotation(self).sclerp(DualQuat::from_rotation(other), t).real()
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Rotation by SLERP, translation by LERP; `t` may differ from lane to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn slerp_lerp(self, other: Self, t: L) -> Self {
        let rotation = self.rotation().slerp(other.rotation(), t);
        let start = vector::scale(self.translation(), t.constant(1.0) - t);
        let translation = vector::scale_onto(other.translation(), t, start);
        Self::from_rotation_translation(rotation, translation)
    }
}
