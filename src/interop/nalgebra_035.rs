//! nalgebra 0.35. Its quaternions lie as `[x, y, z, w]` too, and its dual quaternions as ours.
//!
//! ```
//! use dq8::DualQuat;
//! use nalgebra::{Isometry3, Vector3};
//! let isometry = Isometry3::new(Vector3::new(1.0, 2.0, 3.0), Vector3::x() * 0.5_f64);
//! let motion = DualQuat::from(isometry);
//! assert!((motion.translation()[2] - 3.0).abs() < 1e-15);
//! assert!((Isometry3::from(motion).to_homogeneous() - isometry.to_homogeneous()).norm() < 1e-15);
//! ```

use crate::number::Real;
use crate::scalar::MatrixError;
use crate::scalar::{DualQuat, Quat};
use bytemuck::Pod;
use nalgebra::{
    DualQuaternion, Isometry3, Matrix4, Quaternion, RealField, Rotation3, UnitDualQuaternion,
    UnitQuaternion, Vector4,
};

impl<R: Real + nalgebra::Scalar> From<Quaternion<R>> for Quat<R> {
    fn from(quaternion: Quaternion<R>) -> Self {
        Self::from_array(quaternion.coords.into())
    }
}

impl<R: Real + nalgebra::Scalar> From<Quat<R>> for Quaternion<R> {
    fn from(quaternion: Quat<R>) -> Self {
        Self { coords: Vector4::from(quaternion.to_array()) }
    }
}

impl<R: Real + RealField> From<UnitQuaternion<R>> for Quat<R> {
    fn from(rotation: UnitQuaternion<R>) -> Self {
        rotation.into_inner().into()
    }
}

/// The quaternion must be unit.
impl<R: Real + RealField> From<Quat<R>> for UnitQuaternion<R> {
    fn from(rotation: Quat<R>) -> Self {
        Self::new_unchecked(rotation.into())
    }
}

/// The quaternion must be unit.
impl<R: Real + RealField> From<Quat<R>> for Rotation3<R> {
    fn from(rotation: Quat<R>) -> Self {
        UnitQuaternion::from(rotation).into()
    }
}

impl<R: Real + nalgebra::Scalar> From<DualQuaternion<R>> for DualQuat<R> {
    fn from(sigma: DualQuaternion<R>) -> Self {
        Self::new(sigma.real.into(), sigma.dual.into())
    }
}

impl<R: Real + nalgebra::Scalar> From<DualQuat<R>> for DualQuaternion<R> {
    fn from(sigma: DualQuat<R>) -> Self {
        Self { real: sigma.real().into(), dual: sigma.dual().into() }
    }
}

impl<R: Real + RealField> From<UnitDualQuaternion<R>> for DualQuat<R> {
    fn from(motion: UnitDualQuaternion<R>) -> Self {
        motion.into_inner().into()
    }
}

/// σ must be unit.
impl<R: Real + RealField> From<DualQuat<R>> for UnitDualQuaternion<R> {
    fn from(motion: DualQuat<R>) -> Self {
        Self::new_unchecked(motion.into())
    }
}

impl<R: Real + RealField> From<Isometry3<R>> for DualQuat<R> {
    fn from(isometry: Isometry3<R>) -> Self {
        Self::from_rotation_translation(
            isometry.rotation.into(),
            isometry.translation.vector.into(),
        )
    }
}

/// σ must be unit.
impl<R: Real + RealField> From<DualQuat<R>> for Isometry3<R> {
    fn from(motion: DualQuat<R>) -> Self {
        Self::from_parts(motion.translation().into(), motion.rotation().into())
    }
}

/// σ must be unit.
impl<R: Real + RealField> From<DualQuat<R>> for Matrix4<R> {
    fn from(motion: DualQuat<R>) -> Self {
        motion.to_cols_array_2d().into()
    }
}

impl<R: Real + RealField> TryFrom<Matrix4<R>> for DualQuat<R> {
    type Error = MatrixError;
    fn try_from(matrix: Matrix4<R>) -> Result<Self, MatrixError> {
        Self::try_from_cols_array_2d(matrix.into(), Real::sqrt(R::EPSILON))
    }
}

/// nalgebra's quaternions as ours, where they lie.
#[must_use]
pub fn quats<R: Real + nalgebra::Scalar + Pod>(quaternions: &[Quaternion<R>]) -> &[Quat<R>] {
    bytemuck::must_cast_slice(quaternions)
}

/// Our quaternions as nalgebra's, where they lie.
#[must_use]
pub fn quaternions<R: Real + nalgebra::Scalar + Pod>(quats: &[Quat<R>]) -> &[Quaternion<R>] {
    bytemuck::must_cast_slice(quats)
}

/// nalgebra's dual quaternions as ours, where they lie.
#[must_use]
pub fn motions<R: Real + nalgebra::Scalar + Pod>(sigmas: &[DualQuaternion<R>]) -> &[DualQuat<R>] {
    bytemuck::must_cast_slice(sigmas)
}

/// Our dual quaternions as nalgebra's, where they lie.
#[must_use]
pub fn dual_quaternions<R: Real + nalgebra::Scalar + Pod>(
    motions: &[DualQuat<R>],
) -> &[DualQuaternion<R>] {
    bytemuck::must_cast_slice(motions)
}
