use crate::number::Real;
use crate::scalar::{Quat, vector};
use core::ops::Mul;

crate::macros::pod! {
    /// A rotation r and a translation t side by side, v ↦ r v r* + t (Kenwright §3), the form of
    /// poses in many files and physics engines. It has seven components, one less than a
    /// [`DualQuat`](crate::DualQuat), and describes the same motions.
    ///
    /// [`RotationsTranslations`](crate::hierarchy::RotationsTranslations) takes slices of this
    /// type.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat, representation::RotationTranslation};
    /// let quarter = Quat::from_axis_angle([0.0, 0.0, 1.0], core::f64::consts::FRAC_PI_2);
    /// let pose = RotationTranslation { rotation: quarter, translation: [1.0, 2.0, 3.0] };
    /// let same = DualQuat::from(pose);
    /// let point = [4.0, 0.0, 0.0];
    /// let off = same.transform_point(point)[1] - pose.transform_point(point)[1];
    /// assert!(off.abs() < 1e-14);
    /// ```
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "rkyv_08", derive(rkyv::Archive, rkyv::Serialize, rkyv::Deserialize))]
    #[must_use]
    pub struct RotationTranslation<R> {
        /// The rotation r, which must be unit.
        pub rotation: Quat<R>,
        /// The translation t.
        pub translation: [R; 3],
    }
}

/// The default is the identity.
impl<R: Real> Default for RotationTranslation<R> {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl<R: Real> RotationTranslation<R> {
    /// The identity: the rotation 1 and the translation 0.
    pub const IDENTITY: Self = Self { rotation: Quat::IDENTITY, translation: [R::ZERO; 3] };

    /// Makes a pose from `[x, y, z, w, tx, ty, tz]`.
    pub const fn from_array([x, y, z, w, tx, ty, tz]: [R; 7]) -> Self {
        Self { rotation: Quat::from_xyzw(x, y, z, w), translation: [tx, ty, tz] }
    }

    /// Returns `[x, y, z, w, tx, ty, tz]`.
    #[must_use]
    pub const fn to_array(self) -> [R; 7] {
        let ([x, y, z, w], [tx, ty, tz]) = (self.rotation.to_array(), self.translation);
        [x, y, z, w, tx, ty, tz]
    }

    /// Returns the inverse motion, with the rotation r* and the translation −r*tr.
    pub fn inverse(self) -> Self {
        let rotation = self.rotation.conjugate();
        Self { rotation, translation: rotation.rotate(self.translation).map(|c| -c) }
    }

    /// Returns the point rvr* + t.
    #[must_use]
    pub fn transform_point(self, point: [R; 3]) -> [R; 3] {
        vector::add(self.rotation.rotate(point), self.translation)
    }

    /// Returns the direction rvr*.
    #[must_use]
    pub fn transform_vector(self, vector: [R; 3]) -> [R; 3] {
        self.rotation.rotate(vector)
    }
}

/// The product applies `other` (b) first, then `self` (a). Its rotation is r_a r_b and its
/// translation r_a t_b r_a* + t_a.
impl<R: Real> Mul for RotationTranslation<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            rotation: self.rotation * other.rotation,
            translation: self.transform_point(other.translation),
        }
    }
}
