//! Rotation and translation, in and out.

use super::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// r + ε0; `rotation` must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_rotation(rotation: Quat<L>) -> Self {
        Self::new(rotation, Quat::from_array([rotation.w().constant(0.0); 4]))
    }

    /// 1 + ½εt
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_translation(translation: [L; 3]) -> Self {
        let zero = translation[0].constant(0.0);
        let half = vector::scale(translation, zero.constant(0.5));
        Self::new(Quat::identity(zero.level()), Quat::from_parts(half, zero))
    }

    /// Rotate, then translate: r + ½εtr; `rotation` must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_rotation_translation(rotation: Quat<L>, translation: [L; 3]) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (r, w) = (rotation.xyz(), rotation.w());
        // ½tr for a pure quaternion t: (t × r + w t, −t·r)
        let dual = vector::cross_onto(half, r, vector::scale(half, w));
        Self::new(rotation, Quat::from_parts(dual, -vector::dot(half, r)))
    }

    /// Translate, then rotate: r + ½εrt; `rotation` must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_translation_rotation(translation: [L; 3], rotation: Quat<L>) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (r, w) = (rotation.xyz(), rotation.w());
        let dual = vector::cross_onto(r, half, vector::scale(half, w));
        Self::new(rotation, Quat::from_parts(dual, -vector::dot(half, r)))
    }

    /// σ(r + ½εtr) = (p + ε(q + ½pt))r, in 47 operations. Joining r and t first takes 15, and a product 48
    /// more.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
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
    #[must_use]
    pub fn rotation(self) -> Quat<L> {
        self.real()
    }

    /// t = 2qp* of unit σ
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn translation(self) -> [L; 3] {
        let zero = self.real().w().constant(0.0);
        self.translation_onto_half([zero; 3], zero.constant(2.0))
    }

    /// t + 2·half: the factor 2 is shared with a caller that adds something to the translation. It is
    /// 2/|p|² if σ is not unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn translation_onto_half(self, half: [L; 3], two: L) -> [L; 3] {
        let (p, q) = (self.real(), self.dual());
        // The vector part of qp*: w_p q − w_q p + p × q
        let onto = vector::scale_onto(q.xyz(), p.w(), half);
        let onto = vector::scale_onto(p.xyz(), -q.w(), onto);
        let sum = vector::cross_onto(p.xyz(), q.xyz(), onto);
        vector::scale(sum, two)
    }
}
