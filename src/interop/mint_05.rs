//! Conversions from and to mint 0.5, whose types many libraries share.

use crate::macros::conversions;
use crate::number::Real;
use crate::scalar::{DualQuat, MatrixError, Quat};
use mint::{ColumnMatrix3, ColumnMatrix4, Quaternion, RowMatrix3, RowMatrix3x4, RowMatrix4};

impl<R: Real> mint::IntoMint for Quat<R> {
    type MintType = Quaternion<R>;
}

conversions! {
    [R: Real] Quaternion<R> => Quat<R>: |quaternion| Self::from_parts(quaternion.v.into(), quaternion.s);
    [R: Real] Quat<R> => Quaternion<R>: |rotation| Self { s: rotation.w(), v: rotation.xyz().into() };
    [R: Real] Quat<R> => ColumnMatrix3<R>: |rotation| rotation.to_cols_array_2d().into();
    [R: Real] Quat<R> => RowMatrix3<R>: |rotation| rotation.to_matrix3().into();
    [R: Real] DualQuat<R> => ColumnMatrix4<R>: |motion| motion.to_cols_array_2d().into();
    [R: Real] DualQuat<R> => RowMatrix4<R>: |motion| motion.to_matrix4().into();
    [R: Real] DualQuat<R> => RowMatrix3x4<R>: |motion| motion.to_matrix3x4().into();
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
