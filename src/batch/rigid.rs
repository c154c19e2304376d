//! Conversions between motions and pairs of a rotation and a translation.

use super::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// Returns the motion r + ε0, a rotation about the origin; `rotation` must be unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation(rotation: Quat<L>) -> Self {
        Self::new(rotation, Quat::from_array([rotation.w().constant(0.0); 4]))
    }

    /// Returns the motion 1 + ½εt, a translation.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_translation(translation: [L; 3]) -> Self {
        let zero = translation[0].constant(0.0);
        let half = vector::scale(translation, zero.constant(0.5));
        Self::new(Quat::identity(zero.level()), Quat::from_parts(half, zero))
    }

    /// Returns r + ½εtr, the motion that rotates by r, then translates by t; `rotation` must be
    /// unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_rotation_translation(rotation: Quat<L>, translation: [L; 3]) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (r, w) = (rotation.xyz(), rotation.w());
        // Let v and w be the vector part and the scalar part of r. For a pure quaternion t, the
        // product tr has the vector part t × v + w t and the scalar part −t·v. Here t is
        // `half`.
        let dual = vector::cross_onto(half, r, vector::scale(half, w));
        Self::new(rotation, Quat::from_parts(dual, -vector::dot(half, r)))
    }

    /// Returns r + ½εrt, the motion that translates by t, then rotates by r; `rotation` must be
    /// unit.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_translation_rotation(translation: [L; 3], rotation: Quat<L>) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (r, w) = (rotation.xyz(), rotation.w());
        let dual = vector::cross_onto(r, half, vector::scale(half, w));
        Self::new(rotation, Quat::from_parts(dual, -vector::dot(half, r)))
    }

    /// Returns σ(r + ½εtr) = (p + ε(q + ½pt))r, in 47 operations. Making a motion of r and t
    /// first would take 15 operations, and the product of motions 48 more.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn mul_rotation_translation(self, rotation: Quat<L>, translation: [L; 3]) -> Self {
        let half = vector::scale(translation, rotation.w().constant(0.5));
        let (p, w, q) = (self.real().xyz(), self.real().w(), self.dual());
        // Let v and w be the vector part and the scalar part of p. For a pure quaternion t, the
        // product pt has the vector part v × t + w t and the scalar part −v·t. Here t is
        // `half`.
        let moved = vector::cross_onto(p, half, vector::scale_onto(half, w, q.xyz()));
        let [tx, ty, tz] = half;
        let moved_w = p[2].neg_mul_add(tz, p[1].neg_mul_add(ty, p[0].neg_mul_add(tx, q.w())));
        Self::new(self.real() * rotation, Quat::from_parts(moved, moved_w) * rotation)
    }

    /// Returns the rotation r = p of unit σ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn rotation(self) -> Quat<L> {
        self.real()
    }

    /// Returns the translation t = 2qp* of unit σ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn translation(self) -> [L; 3] {
        let half = self.half_translation();
        vector::add(half, half)
    }

    /// Returns the vector part of qp*, which is half the translation of a unit σ. It is w_p q −
    /// w_q p + p × q, where p and q stand for the vector parts.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn half_translation(self) -> [L; 3] {
        let (p, q) = (self.real(), self.dual());
        let onto = vector::scale_onto(p.xyz(), -q.w(), vector::scale(q.xyz(), p.w()));
        vector::cross_onto(p.xyz(), q.xyz(), onto)
    }
}
