use crate::batch::{DualQuat, Quat, vector};
use core::ops::Mul;
use dq8_simd::Lanes;

/// Rotations and translations side by side, v ↦ r v r* + t:
/// [`RotationTranslation`](crate::representation::RotationTranslation) on lanes.
#[derive(Clone, Copy, Debug)]
pub struct RotationTranslation<L> {
    /// r, unit.
    pub rotation: Quat<L>,
    /// t
    pub translation: [L; 3],
}

impl<L: Lanes> RotationTranslation<L> {
    /// 1 and 0 in every lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn identity(level: L::Level) -> Self {
        let rotation = Quat::identity(level);
        Self { rotation, translation: [rotation.x(); 3] }
    }

    /// From `[x, y, z, w, tx, ty, tz]`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_array([x, y, z, w, tx, ty, tz]: [L; 7]) -> Self {
        Self { rotation: Quat::from_xyzw(x, y, z, w), translation: [tx, ty, tz] }
    }

    /// `[x, y, z, w, tx, ty, tz]`
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_array(self) -> [L; 7] {
        let ([x, y, z, w], [tx, ty, tz]) = (self.rotation.to_array(), self.translation);
        [x, y, z, w, tx, ty, tz]
    }

    /// The inverse motions, r* and −r*tr.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn inverse(self) -> Self {
        let rotation = self.rotation.conjugate();
        let [x, y, z] = rotation.rotate(self.translation);
        Self { rotation, translation: [-x, -y, -z] }
    }

    /// The points rvr* + t.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_point(self, point: [L; 3]) -> [L; 3] {
        vector::add(self.rotation.rotate(point), self.translation)
    }

    /// The directions rvr*.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn transform_vector(self, vector: [L; 3]) -> [L; 3] {
        self.rotation.rotate(vector)
    }
}

/// `other`, then `self`: r_a r_b and r_a t_b r_a* + t_a.
impl<L: Lanes> Mul for RotationTranslation<L> {
    type Output = Self;
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mul(self, other: Self) -> Self {
        Self {
            rotation: self.rotation * other.rotation,
            translation: self.transform_point(other.translation),
        }
    }
}

/// r + ½εtr
impl<L: Lanes> From<RotationTranslation<L>> for DualQuat<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn from(pose: RotationTranslation<L>) -> Self {
        Self::from_rotation_translation(pose.rotation, pose.translation)
    }
}

/// r = p, t = 2qp* of unit σ.
impl<L: Lanes> From<DualQuat<L>> for RotationTranslation<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn from(motion: DualQuat<L>) -> Self {
        Self { rotation: motion.rotation(), translation: motion.translation() }
    }
}
