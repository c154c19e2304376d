//! Conversions from rotations and translations to motions, and back.

use super::{DualQuat, Quat, vector};
use crate::number::Real;
use crate::quick;

impl<R: Real> DualQuat<R> {
    /// The pure rotation r + ε0 (Kenwright §7.1). `rotation` must be unit.
    #[inline]
    #[must_use]
    pub const fn from_rotation(rotation: Quat<R>) -> Self {
        Self::new(rotation, Quat::ZERO)
    }

    /// The pure translation 1 + ½εt (Kenwright §7.1).
    #[inline]
    #[must_use]
    pub fn from_translation(translation: [R; 3]) -> Self {
        let half = vector::scale(translation, R::HALF);
        Self::new(Quat::IDENTITY, Quat::from_parts(half, R::ZERO))
    }

    /// The motion that rotates by `rotation`, then translates by `translation`: r + ½ε t r (Jia
    /// eq. 22). `rotation` must be unit.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let r = Quat::from_xyzw(0.5_f32, 0.5, 0.5, 0.5);
    /// let motion = DualQuat::from_rotation_translation(r, [1.0, 2.0, 3.0]);
    /// assert_eq!((motion.rotation(), motion.translation()), (r, [1.0, 2.0, 3.0]));
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("from_parts", "from_components"))]
    pub fn from_rotation_translation(rotation: Quat<R>, translation: [R; 3]) -> Self {
        crate::scalar::must_be_unit::rotations("DualQuat::from_rotation_translation", [rotation]);
        let half = vector::scale(translation, R::HALF);
        Self::new(rotation, Quat::from_parts(half, R::ZERO) * rotation)
    }

    /// The motion that translates by `translation`, then rotates by `rotation`: r + ½ε r t (Jia
    /// eq. 26; Tarini's "translo-rotation"). `rotation` must be unit.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn from_translation_rotation(translation: [R; 3], rotation: Quat<R>) -> Self {
        crate::scalar::must_be_unit::rotations("DualQuat::from_translation_rotation", [rotation]);
        let half = vector::scale(translation, R::HALF);
        Self::new(rotation, rotation * Quat::from_parts(half, R::ZERO))
    }

    /// Returns σ(r + ½εtr), the product of σ with the motion r + ½εtr of a rotation r and a
    /// translation t; this motion acts before σ. It follows from Jia's eqs. 14 and 22. `rotation`
    /// must be unit.
    ///
    /// In [`batch`](crate::batch) this takes fewer operations than making a motion of r and t and
    /// multiplying, because σ(r + ½εtr) = (p + ε(q + ½pt))r.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let up = DualQuat::from_translation([0.0_f32, 0.0, 1.0]);
    /// let half_turn = Quat::from_xyzw(0.0, 0.0, 1.0, 0.0);
    /// let moved = up.mul_rotation_translation(half_turn, [5.0, 0.0, 0.0]);
    /// assert_eq!(moved.transform_point([1.0, 0.0, 0.0]), [4.0, 0.0, 1.0]);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn mul_rotation_translation(self, rotation: Quat<R>, translation: [R; 3]) -> Self {
        crate::scalar::must_be_unit::rotations("DualQuat::mul_rotation_translation", [rotation]);
        self * Self::from_rotation_translation(rotation, translation)
    }

    /// The rotation r = p of a unit σ (Jia eq. 23).
    #[inline]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn rotation(self) -> Quat<R> {
        crate::scalar::must_be_unit::motions("DualQuat::rotation", [self]);
        self.real()
    }

    /// The translation t = 2qp* of a unit σ (Jia eq. 24).
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn translation(self) -> [R; 3] {
        crate::scalar::must_be_unit::motions("DualQuat::translation", [self]);
        if let Some(translation) = R::quick(quick::Translation(self.to_array())) {
            return translation;
        }
        (self.dual() * self.real().conjugate()).scale(R::TWO).xyz()
    }
}
