//! Rotation and translation, in and out.

use super::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// r + ε0; `rotation` must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation(rotation: Quat<L>) -> Self {
        Self::new(rotation, Quat::from_array([rotation.w().constant(0.0); 4]))
    }

    /// 1 + ½εt
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_translation(translation: [L; 3]) -> Self {
        let zero = translation[0].constant(0.0);
        let half = vector::scale(translation, zero.constant(0.5));
        Self::new(Quat::identity(zero.level()), Quat::from_parts(half, zero))
    }

    /// Rotate, then translate: r + ½εtr; `rotation` must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_translation(rotation: Quat<L>, translation: [L; 3]) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (r, w) = (rotation.xyz(), rotation.w());
        // ½tr for a pure quaternion t: (t × r + w t, −t·r)
        let dual = vector::cross_onto(half, r, vector::scale(half, w));
        Self::new(rotation, Quat::from_parts(dual, -vector::dot(half, r)))
    }

    /// Translate, then rotate: r + ½εrt; `rotation` must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_translation_rotation(translation: [L; 3], rotation: Quat<L>) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (r, w) = (rotation.xyz(), rotation.w());
        let dual = vector::cross_onto(r, half, vector::scale(half, w));
        Self::new(rotation, Quat::from_parts(dual, -vector::dot(half, r)))
    }

    /// σ(r + ½εtr) = (p + ε(q + ½pt))r, in 47 operations. Joining r and t first takes 15, and
    /// a product 48 more.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn mul_rotation_translation(self, rotation: Quat<L>, translation: [L; 3]) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (p, w, q) = (self.real().xyz(), self.real().w(), self.dual());
        // pt for a pure quaternion t: (p × t + w t, −p·t)
        let moved = vector::cross_onto(p, half, vector::scale_onto(half, w, q.xyz()));
        let [tx, ty, tz] = half;
        let moved_w = p[2].neg_mul_add(tz, p[1].neg_mul_add(ty, p[0].neg_mul_add(tx, q.w())));
        Self::new(self.real() * rotation, Quat::from_parts(moved, moved_w) * rotation)
    }

    /// r = p of unit σ
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn rotation(self) -> Quat<L> {
        self.real()
    }

    /// t = 2qp* of unit σ
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn translation(self) -> [L; 3] {
        let half = self.half_translation();
        vector::add(half, half)
    }

    /// The vector part of qp*: w_p q − w_q p + p × q
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn half_translation(self) -> [L; 3] {
        let (p, q) = (self.real(), self.dual());
        let onto = vector::scale_onto(p.xyz(), -q.w(), vector::scale(q.xyz(), p.w()));
        vector::cross_onto(p.xyz(), q.xyz(), onto)
    }
}
