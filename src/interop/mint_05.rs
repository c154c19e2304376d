//! mint 0.5, the types that other libraries agree on.

use crate::number::Real;
use crate::scalar::MatrixError;
use crate::scalar::{DualQuat, Quat};
use mint::{ColumnMatrix3, ColumnMatrix4, Quaternion, RowMatrix3, RowMatrix3x4, RowMatrix4};

impl<R: Real> From<Quaternion<R>> for Quat<R> {
    fn from(quaternion: Quaternion<R>) -> Self {
        Self::from_parts(quaternion.v.into(), quaternion.s)
    }
}

impl<R: Real> From<Quat<R>> for Quaternion<R> {
    fn from(quaternion: Quat<R>) -> Self {
        Self { s: quaternion.w(), v: quaternion.xyz().into() }
    }
}

impl<R: Real> mint::IntoMint for Quat<R> {
    type MintType = Quaternion<R>;
}

impl<R: Real> From<Quat<R>> for ColumnMatrix3<R> {
    fn from(rotation: Quat<R>) -> Self {
        rotation.to_cols_array_2d().into()
    }
}

impl<R: Real> From<Quat<R>> for RowMatrix3<R> {
    fn from(rotation: Quat<R>) -> Self {
        rotation.to_matrix3().into()
    }
}

impl<R: Real> From<DualQuat<R>> for ColumnMatrix4<R> {
    fn from(motion: DualQuat<R>) -> Self {
        motion.to_cols_array_2d().into()
    }
}

impl<R: Real> From<DualQuat<R>> for RowMatrix4<R> {
    fn from(motion: DualQuat<R>) -> Self {
        motion.to_matrix4().into()
    }
}

impl<R: Real> From<DualQuat<R>> for RowMatrix3x4<R> {
    fn from(motion: DualQuat<R>) -> Self {
        motion.to_matrix3x4().into()
    }
}

impl<R: Real> TryFrom<ColumnMatrix4<R>> for DualQuat<R> {
    type Error = MatrixError;
    fn try_from(matrix: ColumnMatrix4<R>) -> Result<Self, MatrixError> {
        Self::try_from_cols_array_2d(matrix.into(), R::EPSILON.sqrt())
    }
}

impl<R: Real> TryFrom<RowMatrix4<R>> for DualQuat<R> {
    type Error = MatrixError;
    fn try_from(matrix: RowMatrix4<R>) -> Result<Self, MatrixError> {
        Self::try_from_matrix4(matrix.into(), R::EPSILON.sqrt())
    }
}
