//! 3×3, 3×4 and 4×4 matrices as arrays of rows, which act on column vectors.

use super::error::MatrixError;
use super::{DualQuat, Quat, vector};
use crate::number::Real;
use crate::quick;

impl<R: Real> Quat<R> {
    /// Returns the rows of the rotation matrix of a unit quaternion r. Its columns are r e r* for
    /// the coordinate axes e.
    ///
    /// ```
    /// use dq8::Quat;
    /// let third_turn = Quat::from_xyzw(0.5_f32, 0.5, 0.5, 0.5);
    /// assert_eq!(third_turn.to_matrix3(), [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("to_rotation_matrix", "to_mat3", "as_matrix"))]
    pub fn to_matrix3(self) -> [[R; 3]; 3] {
        crate::scalar::must_be_unit::rotations("Quat::to_matrix3", [self]);
        let [x, y, z, w] = self.to_array();
        let (one, two) = (R::ONE, R::TWO);
        [
            [one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)],
            [two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x)],
            [two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)],
        ]
    }

    /// Returns the unit quaternion, with w ≥ 0, of a matrix that the caller knows to be a
    /// rotation. Nothing is checked here: [`try_from_matrix3`](Self::try_from_matrix3) checks, and
    /// [`Polar`](crate::representation::Polar) finds the nearest rotation to any matrix.
    ///
    /// In Shepperd's method (1978) one component of the quaternion is the divisor, which must not
    /// be small. It is w where the trace is not negative, so that w ≥ ½, and otherwise the
    /// largest of x, y and z.
    #[inline]
    #[doc(alias("from_mat3", "from_rotation_matrix"))]
    pub fn from_matrix3(rows: [[R; 3]; 3]) -> Self {
        let [[m00, m01, m02], [m10, m11, m12], [m20, m21, m22]] = rows;
        let one = R::ONE;
        // Each of these values is four times the square of a component of the quaternion.
        let x2 = one + m00 - m11 - m22;
        let y2 = one - m00 + m11 - m22;
        let z2 = one - m00 - m11 + m22;
        let w2 = one + m00 + m11 + m22;
        let [x, y, z, w] = if w2 >= one {
            [m21 - m12, m02 - m20, m10 - m01, w2]
        } else {
            let turned = if x2 >= y2 && x2 >= z2 {
                [x2, m01 + m10, m02 + m20, m21 - m12]
            } else if y2 >= z2 {
                [m01 + m10, y2, m12 + m21, m02 - m20]
            } else {
                [m02 + m20, m12 + m21, z2, m10 - m01]
            };
            let [.., w] = turned;
            if w < R::ZERO { turned.map(|c| -c) } else { turned }
        };
        // The component that serves as divisor is at least 1 here, and all components are at
        // most 4. So no square overflows, and a square that underflows is too small to change the
        // sum.
        let factor = one / (x * x + y * y + z * z + w * w).sqrt();
        Self::from_xyzw(x * factor, y * factor, z * factor, w * factor)
    }

    /// Returns the unit quaternion of a rotation matrix, with w ≥ 0.
    ///
    /// # Errors
    /// If the matrix differs from a rotation by more than `tolerance` in a product of its rows (it
    /// scales, shears or mirrors), or an element is not finite.
    #[inline]
    pub fn try_from_matrix3(rows: [[R; 3]; 3], tolerance: R) -> Result<Self, MatrixError> {
        for row in 0..3 {
            for column in row..3 {
                let value = vector::dot(rows[row], rows[column]);
                let wanted = if row == column { R::ONE } else { R::ZERO };
                // An infinite tolerance accepts every finite value.
                let close = value.is_finite() && (value - wanted).abs() <= tolerance;
                if !close {
                    return Err(uniform_scale(rows, tolerance).map_or(
                        MatrixError::NotOrthonormal { row, column, value: value.into() },
                        |factor| MatrixError::Scales { factor: factor.into() },
                    ));
                }
            }
        }
        let determinant = vector::dot(rows[0], vector::cross(rows[1], rows[2]));
        if determinant < R::ZERO {
            return Err(MatrixError::Mirrors { determinant: determinant.into() });
        }
        Ok(Self::from_matrix3(rows))
    }

    /// Returns the columns of the rotation matrix, `[column][row]`, as in glam, nalgebra and
    /// OpenGL. [`to_matrix3`](Self::to_matrix3) returns the rows in the same type. A caller who
    /// takes columns for rows gets the inverse rotation.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_cols_array_2d(self) -> [[R; 3]; 3] {
        crate::scalar::must_be_unit::rotations("Quat::to_cols_array_2d", [self]);
        transpose(self.to_matrix3())
    }

    /// Makes the rotation of a matrix from its columns, `[column][row]`, as
    /// [`try_from_matrix3`](Self::try_from_matrix3) does from its rows.
    ///
    /// # Errors
    /// The errors of [`try_from_matrix3`](Self::try_from_matrix3). The rows in an error are rows of
    /// the matrix, not of the array.
    #[inline]
    pub fn try_from_cols_array_2d(cols: [[R; 3]; 3], tolerance: R) -> Result<Self, MatrixError> {
        Self::try_from_matrix3(transpose(cols), tolerance)
    }
}

impl<R: Real> DualQuat<R> {
    /// Returns the rows of the matrix [R | t] of a unit σ, so that `row · (v, 1)` is a coordinate
    /// of the moved point. The columns of R are r e r* for the coordinate axes e, and t = 2qp* (Jia
    /// eq. 24).
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let matrix = DualQuat::from_translation([1.0_f32, 2.0, 3.0]).to_matrix3x4();
    /// assert_eq!(matrix[2], [0.0, 0.0, 1.0, 3.0]);
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_matrix3x4(self) -> [[R; 4]; 3] {
        crate::scalar::must_be_unit::motions("DualQuat::to_matrix3x4", [self]);
        if let Some(rows) = R::quick(quick::Matrix3x4(self.to_array())) {
            return rows;
        }
        let [[a, b, c], [d, e, f], [g, h, i]] = self.real().to_matrix3();
        let [x, y, z] = self.translation();
        [[a, b, c, x], [d, e, f, y], [g, h, i, z]]
    }

    /// Returns the rows of the 4×4 matrix: those of [`to_matrix3x4`](Self::to_matrix3x4) with the
    /// row 0 0 0 1 below. glam, nalgebra, OpenGL and glTF need the columns, which
    /// [`to_cols_array_2d`](Self::to_cols_array_2d) returns.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("to_homogeneous", "to_mat4", "homogeneous"))]
    pub fn to_matrix4(self) -> [[R; 4]; 4] {
        crate::scalar::must_be_unit::motions("DualQuat::to_matrix4", [self]);
        let [a, b, c] = self.to_matrix3x4();
        [a, b, c, [R::ZERO, R::ZERO, R::ZERO, R::ONE]]
    }

    /// Returns the motion, with p_w ≥ 0, of a matrix that the caller knows to be rigid. Nothing
    /// is checked here: [`try_from_matrix3x4`](Self::try_from_matrix3x4) checks. The rotation is
    /// computed by [`Quat::from_matrix3`].
    #[inline]
    #[must_use]
    pub fn from_matrix3x4(rows: [[R; 4]; 3]) -> Self {
        let (rotation, translation) = rotation_and_translation(rows);
        Self::from_rotation_translation(Quat::from_matrix3(rotation), translation)
    }

    /// Returns the motion of a 3×4 matrix, with p_w ≥ 0.
    ///
    /// # Errors
    /// If the left 3×3 part differs from a rotation by more than `tolerance` in a product of its
    /// rows (it scales, shears or mirrors), or an element is not finite.
    ///
    /// ```
    /// use dq8::{DualQuat, scalar::MatrixError};
    /// let doubled = [[2.0_f32, 0.0, 0.0, 0.0], [0.0, 2.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0]];
    /// assert_eq!(
    ///     DualQuat::try_from_matrix3x4(doubled, 1e-4),
    ///     Err(MatrixError::Scales { factor: 2.0 })
    /// );
    /// ```
    #[inline]
    pub fn try_from_matrix3x4(rows: [[R; 4]; 3], tolerance: R) -> Result<Self, MatrixError> {
        let (rotation, translation) = rotation_and_translation(rows);
        let rotation = Quat::try_from_matrix3(rotation, tolerance)?;
        for (row, value) in translation.into_iter().enumerate() {
            if !value.is_finite() {
                return Err(MatrixError::NotFinite { row, value: value.into() });
            }
        }
        Ok(Self::from_rotation_translation(rotation, translation))
    }

    /// Makes the motion of a 4×4 matrix from its rows, as
    /// [`try_from_matrix3x4`](Self::try_from_matrix3x4) does from three rows. Use
    /// [`try_from_cols_array_2d`](Self::try_from_cols_array_2d) for the columns of glam, nalgebra,
    /// OpenGL and glTF. If columns are passed as rows, a pure rotation becomes its inverse, and no
    /// check can notice this.
    ///
    /// # Errors
    /// The errors of [`try_from_matrix3x4`](Self::try_from_matrix3x4), and an error if the last row
    /// is not 0 0 0 1.
    #[inline]
    #[doc(alias("from_mat4", "from_homogeneous"))]
    pub fn try_from_matrix4(rows: [[R; 4]; 4], tolerance: R) -> Result<Self, MatrixError> {
        let [a, b, c, last] = rows;
        for (column, value) in last.into_iter().enumerate() {
            let wanted = if column == 3 { R::ONE } else { R::ZERO };
            if value != wanted {
                return Err(MatrixError::NotAffine { column, value: value.into() });
            }
        }
        Self::try_from_matrix3x4([a, b, c], tolerance)
    }

    /// Calls [`try_from_matrix4`](Self::try_from_matrix4). This name states the order of the
    /// elements, `[row][column]`, as in mathematics and NumPy.
    ///
    /// # Errors
    /// The errors of [`try_from_matrix4`](Self::try_from_matrix4).
    #[inline]
    pub fn try_from_rows_array_2d(rows: [[R; 4]; 4], tolerance: R) -> Result<Self, MatrixError> {
        Self::try_from_matrix4(rows, tolerance)
    }

    /// Makes the motion of a 4×4 matrix from its columns, `[column][row]`, as glam, nalgebra,
    /// OpenGL and glTF hold them. The last column is the translation followed by 1. The checks are
    /// those of [`try_from_matrix4`](Self::try_from_matrix4).
    ///
    /// # Errors
    /// The errors of [`try_from_matrix4`](Self::try_from_matrix4). The rows and columns in an error
    /// are those of the matrix, not of the array.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let columns = [
    ///     [1.0_f32, 0.0, 0.0, 0.0],
    ///     [0.0, 1.0, 0.0, 0.0],
    ///     [0.0, 0.0, 1.0, 0.0],
    ///     [5.0, 6.0, 7.0, 1.0],
    /// ];
    /// let moved = DualQuat::try_from_cols_array_2d(columns, 1e-6)?;
    /// assert_eq!(moved.translation(), [5.0, 6.0, 7.0]);
    /// assert_eq!(moved.to_cols_array_2d(), columns);
    /// # Ok::<(), dq8::scalar::MatrixError>(())
    /// ```
    #[inline]
    pub fn try_from_cols_array_2d(cols: [[R; 4]; 4], tolerance: R) -> Result<Self, MatrixError> {
        Self::try_from_matrix4(transpose(cols), tolerance)
    }

    /// Returns the rows of the 4×4 matrix like [`to_matrix4`](Self::to_matrix4). This name states
    /// the order of the elements, `[row][column]`.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_rows_array_2d(self) -> [[R; 4]; 4] {
        crate::scalar::must_be_unit::motions("DualQuat::to_rows_array_2d", [self]);
        self.to_matrix4()
    }

    /// The columns of the 4×4 matrix, `[column][row]`, as in glam, nalgebra, OpenGL and glTF.
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    pub fn to_cols_array_2d(self) -> [[R; 4]; 4] {
        crate::scalar::must_be_unit::motions("DualQuat::to_cols_array_2d", [self]);
        transpose(self.to_matrix4())
    }
}

/// Returns the factor s of a matrix that is s times a rotation, or `None` if there is no such
/// factor or if it is 1 within `tolerance`. A negative s means that the matrix mirrors.
#[cold]
fn uniform_scale<R: Real>(rows: [[R; 3]; 3], tolerance: R) -> Option<R> {
    let size = rows.map(vector::norm);
    let close = |a: R, b: R| (a - b).abs() <= tolerance * b;
    let same = size[0] > R::ZERO && close(size[1], size[0]) && close(size[2], size[0]);
    if !same || !size[0].is_finite() || close(size[0], R::ONE) {
        return None;
    }
    let unit = [0, 1, 2].map(|row| rows[row].map(|c| c / size[row]));
    let across = |a: usize, b: usize| vector::dot(unit[a], unit[b]).abs() <= tolerance;
    if !(across(0, 1) && across(0, 2) && across(1, 2)) {
        return None;
    }
    let mirrors = vector::dot(unit[0], vector::cross(unit[1], unit[2])) < R::ZERO;
    Some(if mirrors { -size[0] } else { size[0] })
}

/// Transposes a matrix.
#[inline]
fn transpose<R: Real, const N: usize>(matrix: [[R; N]; N]) -> [[R; N]; N] {
    let mut other = matrix;
    for (i, line) in matrix.into_iter().enumerate() {
        for (j, value) in line.into_iter().enumerate() {
            other[j][i] = value;
        }
    }
    other
}

/// Splits a 3×4 matrix into its left 3×3 part and its last column.
#[inline]
fn rotation_and_translation<R: Real>(rows: [[R; 4]; 3]) -> ([[R; 3]; 3], [R; 3]) {
    (rows.map(|[x, y, z, _]| [x, y, z]), rows.map(|[.., t]| t))
}
