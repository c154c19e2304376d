//! Conversions from and to types of nalgebra 0.35. Its quaternions lie in memory as `[x, y, z, w]`,
//! and its dual quaternions as the real part, then the dual part. Both orders are those of dq8.
//!
//! ```
//! use dq8::DualQuat;
//! use nalgebra::{Isometry3, Vector3};
//! let isometry = Isometry3::new(Vector3::new(1.0, 2.0, 3.0), Vector3::x() * 0.5_f64);
//! let motion = DualQuat::from(isometry);
//! assert!((motion.translation()[2] - 3.0).abs() < 1e-15);
//! assert!((Isometry3::from(motion).to_homogeneous() - isometry.to_homogeneous()).norm() < 1e-15);
//! ```

use crate::macros::conversions;
use crate::number::Real;
use crate::scalar::{DualQuat, MatrixError, Quat};
use bytemuck::Pod;
use nalgebra::{
    DualQuaternion, Isometry3, Matrix4, Quaternion, RealField, Rotation3, UnitDualQuaternion,
    UnitQuaternion,
};

conversions! {
    [R: Real + nalgebra::Scalar] Quaternion<R> => Quat<R>: |quaternion| Self::from_array(quaternion.coords.into());
    [R: Real + nalgebra::Scalar] Quat<R> => Quaternion<R>: |rotation| Self { coords: rotation.to_array().into() };
    [R: Real + RealField] UnitQuaternion<R> => Quat<R>: |rotation| rotation.into_inner().into();
    /// The quaternion must be unit.
    [R: Real + RealField] Quat<R> => UnitQuaternion<R>: |rotation| Self::new_unchecked(rotation.into());
    /// The quaternion must be unit.
    [R: Real + RealField] Quat<R> => Rotation3<R>: |rotation| UnitQuaternion::from(rotation).into();
    [R: Real + nalgebra::Scalar] DualQuaternion<R> => DualQuat<R>: |sigma| Self::new(sigma.real.into(), sigma.dual.into());
    [R: Real + nalgebra::Scalar] DualQuat<R> => DualQuaternion<R>:
        |sigma| Self { real: sigma.real().into(), dual: sigma.dual().into() };
    [R: Real + RealField] UnitDualQuaternion<R> => DualQuat<R>: |motion| motion.into_inner().into();
    /// The motion must be unit.
    [R: Real + RealField] DualQuat<R> => UnitDualQuaternion<R>: |motion| Self::new_unchecked(motion.into());
    [R: Real + RealField] Isometry3<R> => DualQuat<R>:
        |isometry| Self::from_rotation_translation(isometry.rotation.into(), isometry.translation.vector.into());
    /// The motion must be unit.
    [R: Real + RealField] DualQuat<R> => Isometry3<R>:
        |motion| Self::from_parts(motion.translation().into(), motion.rotation().into());
    /// The motion must be unit.
    [R: Real + RealField] DualQuat<R> => Matrix4<R>: |motion| motion.to_cols_array_2d().into();
}

impl<R: Real + RealField> TryFrom<Matrix4<R>> for DualQuat<R> {
    type Error = MatrixError;
    fn try_from(matrix: Matrix4<R>) -> Result<Self, MatrixError> {
        Self::try_from_cols_array_2d(matrix.into(), Real::sqrt(R::EPSILON))
    }
}

/// Views nalgebra's quaternions as quaternions of dq8, without a copy.
#[must_use]
pub fn quats<R: Real + nalgebra::Scalar + Pod>(quaternions: &[Quaternion<R>]) -> &[Quat<R>] {
    bytemuck::must_cast_slice(quaternions)
}

/// Views quaternions of dq8 as nalgebra's quaternions, without a copy.
#[must_use]
pub fn quaternions<R: Real + nalgebra::Scalar + Pod>(quats: &[Quat<R>]) -> &[Quaternion<R>] {
    bytemuck::must_cast_slice(quats)
}

/// Views nalgebra's dual quaternions as dual quaternions of dq8, without a copy.
#[must_use]
pub fn motions<R: Real + nalgebra::Scalar + Pod>(sigmas: &[DualQuaternion<R>]) -> &[DualQuat<R>] {
    bytemuck::must_cast_slice(sigmas)
}

/// Views dual quaternions of dq8 as nalgebra's dual quaternions, without a copy.
#[must_use]
pub fn dual_quaternions<R: Real + nalgebra::Scalar + Pod>(
    motions: &[DualQuat<R>],
) -> &[DualQuaternion<R>] {
    bytemuck::must_cast_slice(motions)
}
