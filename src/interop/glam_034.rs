//! Conversions from and to types of glam 0.34. Its quaternions are `[x, y, z, w]` as in dq8, and
//! its matrices are stored as columns.
//!
//! ```
//! use dq8::{DualQuat, Quat};
//! let turn = glam::Quat::from_rotation_x(0.5);
//! let map = glam::Affine3A::from_rotation_translation(turn, [1.0, 2.0, 3.0].into());
//! let motion = DualQuat::try_from(map)?;
//! let expected = DualQuat::from((Quat::from_rotation_x(0.5), [1.0, 2.0, 3.0]));
//! assert!(motion.abs_diff_eq(expected, 1e-6));
//! assert!(map.abs_diff_eq(motion.into(), 1e-6));
//! assert_eq!(glam::Quat::from(Quat::IDENTITY), glam::Quat::IDENTITY);
//! # Ok::<(), dq8::scalar::MatrixError>(())
//! ```

use crate::macros::conversions;
use crate::number::Real;
use crate::scalar::{DualQuat, MatrixError, Quat};

/// Writes the conversions for one precision. The types of glam in the two precisions share no
/// trait, so a generic implementation is not possible.
macro_rules! precision {
    ($real:ident, $quat:ident, $vec:ident, $mat3:ident, $mat4:ident, $affine:ident) => {
        conversions! {
            [] glam::$quat => Quat<$real>: |quaternion| Self::from_array(quaternion.to_array());
            [] Quat<$real> => glam::$quat: |quaternion| Self::from_array(quaternion.to_array());
            /// Makes the motion that rotates, then translates. The rotation must be unit.
            [] (glam::$quat, glam::$vec) => DualQuat<$real>:
                |(r, t)| Self::from_rotation_translation(r.into(), t.to_array());
            /// Returns the rotation and the translation of a unit σ.
            [] DualQuat<$real> => (glam::$quat, glam::$vec):
                |motion| (motion.rotation().into(), motion.translation().into());
            [] Quat<$real> => glam::$mat3: |rotation| Self::from_cols_array_2d(&rotation.to_cols_array_2d());
            [] DualQuat<$real> => glam::$mat4: |motion| Self::from_cols_array_2d(&motion.to_cols_array_2d());
            [] DualQuat<$real> => glam::$affine: |motion| {
                let (rotation, translation) = motion.into();
                Self::from_rotation_translation(rotation, translation)
            };
        }
        impl TryFrom<glam::$mat4> for DualQuat<$real> {
            type Error = MatrixError;
            fn try_from(matrix: glam::$mat4) -> Result<Self, MatrixError> {
                Self::try_from_cols_array_2d(matrix.to_cols_array_2d(), Real::sqrt($real::EPSILON))
            }
        }
        impl TryFrom<glam::$affine> for DualQuat<$real> {
            type Error = MatrixError;
            fn try_from(map: glam::$affine) -> Result<Self, MatrixError> {
                glam::$mat4::from(map).try_into()
            }
        }
    };
}
precision! { f32, Quat, Vec3, Mat3, Mat4, Affine3A }
precision! { f64, DQuat, DVec3, DMat3, DMat4, DAffine3 }

/// Writes two functions for each pair of types with the same memory layout. They view a slice of
/// glam's type as a slice of the other type, to read it or to write to it, without a copy.
macro_rules! casts {
    ($($from:ty => $to:ty: $what:literal $read:ident $write:ident;)*) => {$(
        #[doc = concat!("glam's ", $what, ", where they lie.")]
        #[must_use]
        pub fn $read(theirs: &[$from]) -> &[$to] {
            bytemuck::must_cast_slice(theirs)
        }
        #[doc = concat!("glam's ", $what, ", to be written.")]
        #[must_use]
        pub fn $write(theirs: &mut [$from]) -> &mut [$to] {
            bytemuck::must_cast_slice_mut(theirs)
        }
    )*};
}
casts! {
    glam::Quat => Quat<f32>: "quaternions as ours" quats quats_mut;
    glam::DQuat => Quat<f64>: "quaternions of `f64` as ours" dquats dquats_mut;
    glam::Vec3 => [f32; 3]: "vectors as points" points points_mut;
    glam::DVec3 => [f64; 3]: "vectors of `f64` as points" dpoints dpoints_mut;
}

/// Views glam's matrices as arrays of columns, to write to them: for example a palette with
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
