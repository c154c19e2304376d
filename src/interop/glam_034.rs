//! glam 0.34. Its quaternions are `[x, y, z, w]` too; its matrices are columns.
//!
//! ```
//! use dq8::{DualQuat, Quat};
//! let map = glam::Affine3A::from_rotation_translation(glam::Quat::from_rotation_x(0.5), [1.0, 2.0, 3.0].into());
//! let motion = DualQuat::try_from(map)?;
//! assert!(motion.abs_diff_eq(DualQuat::from((Quat::from_rotation_x(0.5), [1.0, 2.0, 3.0])), 1e-6));
//! assert!(map.abs_diff_eq(motion.into(), 1e-6));
//! assert_eq!(glam::Quat::from(Quat::IDENTITY), glam::Quat::IDENTITY);
//! # Ok::<(), dq8::scalar::MatrixError>(())
//! ```

use crate::number::Real;
use crate::scalar::MatrixError;
use crate::scalar::{DualQuat, Quat};

/// One line for each precision: glam's types have nothing in common that a generic could name.
macro_rules! precision {
    ($real:ident, $quat:ident, $vec:ident, $mat3:ident, $mat4:ident) => {
        impl From<glam::$quat> for Quat<$real> {
            fn from(quaternion: glam::$quat) -> Self {
                Self::from_array(quaternion.to_array())
            }
        }
        impl From<Quat<$real>> for glam::$quat {
            fn from(quaternion: Quat<$real>) -> Self {
                Self::from_array(quaternion.to_array())
            }
        }
        /// The rotation must be unit.
        impl From<(glam::$quat, glam::$vec)> for DualQuat<$real> {
            fn from((rotation, translation): (glam::$quat, glam::$vec)) -> Self {
                Self::from_rotation_translation(rotation.into(), translation.to_array())
            }
        }
        /// The rotation and the translation of a unit σ.
        impl From<DualQuat<$real>> for (glam::$quat, glam::$vec) {
            fn from(motion: DualQuat<$real>) -> Self {
                (motion.rotation().into(), motion.translation().into())
            }
        }
        impl From<Quat<$real>> for glam::$mat3 {
            fn from(rotation: Quat<$real>) -> Self {
                Self::from_cols_array_2d(&rotation.to_cols_array_2d())
            }
        }
        impl From<DualQuat<$real>> for glam::$mat4 {
            fn from(motion: DualQuat<$real>) -> Self {
                Self::from_cols_array_2d(&motion.to_cols_array_2d())
            }
        }
        impl TryFrom<glam::$mat4> for DualQuat<$real> {
            type Error = MatrixError;
            fn try_from(matrix: glam::$mat4) -> Result<Self, MatrixError> {
                Self::try_from_cols_array_2d(matrix.to_cols_array_2d(), Real::sqrt($real::EPSILON))
            }
        }
    };
}
precision! { f32, Quat, Vec3, Mat3, Mat4 }
precision! { f64, DQuat, DVec3, DMat3, DMat4 }

macro_rules! affine {
    ($($real:ident $affine:ident $mat4:ident;)*) => {$(
        impl From<DualQuat<$real>> for glam::$affine {
            fn from(motion: DualQuat<$real>) -> Self {
                let (rotation, translation) = motion.into();
                Self::from_rotation_translation(rotation, translation)
            }
        }
        impl TryFrom<glam::$affine> for DualQuat<$real> {
            type Error = MatrixError;
            fn try_from(map: glam::$affine) -> Result<Self, MatrixError> {
                glam::$mat4::from(map).try_into()
            }
        }
    )*};
}
affine! {
    f32 Affine3A Mat4;
    f64 DAffine3 DMat4;
}

/// glam's quaternions as ours, where they lie.
#[must_use]
pub fn quats(quaternions: &[glam::Quat]) -> &[Quat<f32>] {
    bytemuck::must_cast_slice(quaternions)
}

/// glam's quaternions as ours, to be written.
#[must_use]
pub fn quats_mut(quaternions: &mut [glam::Quat]) -> &mut [Quat<f32>] {
    bytemuck::must_cast_slice_mut(quaternions)
}

/// glam's quaternions of `f64` as ours, where they lie.
#[must_use]
pub fn dquats(quaternions: &[glam::DQuat]) -> &[Quat<f64>] {
    bytemuck::must_cast_slice(quaternions)
}

/// glam's quaternions of `f64` as ours, to be written.
#[must_use]
pub fn dquats_mut(quaternions: &mut [glam::DQuat]) -> &mut [Quat<f64>] {
    bytemuck::must_cast_slice_mut(quaternions)
}

/// glam's matrices as the columns that they are, to be written: a palette by
/// [`MatrixOrder::Columns`](crate::hierarchy::MatrixOrder).
///
/// ```
/// use dq8::hierarchy::{MatrixOrder, Poses};
/// use dq8::interop::glam_034::mat4s_mut;
/// use dq8::{DualQuat, Hierarchy};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// let locals = [DualQuat::from_translation([1.0_f32, 0.0, 0.0]); 2];
/// let (mut scratch, mut palette) = ([DualQuat::IDENTITY; 2], [glam::Mat4::ZERO; 2]);
/// let job = arm.job().matrix_order(MatrixOrder::Columns);
/// let binds = [DualQuat::IDENTITY; 2];
/// job.palette(Poses(&locals), &mut scratch, &binds, mat4s_mut(&mut palette))?;
/// assert_eq!(palette[1], glam::Mat4::from_translation(glam::Vec3::new(2.0, 0.0, 0.0)));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[must_use]
pub fn mat4s_mut(matrices: &mut [glam::Mat4]) -> &mut [[[f32; 4]; 4]] {
    bytemuck::must_cast_slice_mut(matrices)
}

/// glam's vectors as points, where they lie.
#[must_use]
pub fn points(vectors: &[glam::Vec3]) -> &[[f32; 3]] {
    bytemuck::must_cast_slice(vectors)
}

/// glam's vectors as points, to be written.
#[must_use]
pub fn points_mut(vectors: &mut [glam::Vec3]) -> &mut [[f32; 3]] {
    bytemuck::must_cast_slice_mut(vectors)
}

/// glam's vectors of `f64` as points, where they lie.
#[must_use]
pub fn dpoints(vectors: &[glam::DVec3]) -> &[[f64; 3]] {
    bytemuck::must_cast_slice(vectors)
}

/// glam's vectors of `f64` as points, to be written.
#[must_use]
pub fn dpoints_mut(vectors: &mut [glam::DVec3]) -> &mut [[f64; 3]] {
    bytemuck::must_cast_slice_mut(vectors)
}
