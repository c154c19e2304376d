//! Matrices of 3×3, 3×4 and 4×4 elements, stored as rows, which act on column vectors.

use super::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// Returns the rows of the rotation matrices of unit quaternions.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_matrix3(self) -> [[L; 3]; 3] {
        let [x, y, z, w] = self.to_array();
        let one = w.constant(1.0);
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        [
            [z.neg_mul_add(z2, y.neg_mul_add(y2, one)), x.mul_add(y2, -wz), x.mul_add(z2, wy)],
            [x.mul_add(y2, wz), z.neg_mul_add(z2, x.neg_mul_add(x2, one)), y.mul_add(z2, -wx)],
            [x.mul_add(z2, -wy), y.mul_add(z2, wx), y.neg_mul_add(y2, x.neg_mul_add(x2, one))],
        ]
    }

    /// Returns the unit quaternions of rotation matrices, with w ≥ 0 (Shepperd 1978). There are
    /// four formulas, each with a division by another component of the quaternion. Each lane uses
    /// the formula of its largest component.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_matrix3(rows: [[L; 3]; 3]) -> Self {
        let rotation = Self::some_of_matrix3(rows).normalize();
        let one = rotation.w().constant(1.0);
        let turned_over = rotation.w().lt(one.constant(0.0));
        rotation.scale(L::select(turned_over, -one, one))
    }

    /// Returns the quaternion of a rotation matrix, multiplied by a positive or negative factor of
    /// size 2 to 4.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn some_of_matrix3(rows: [[L; 3]; 3]) -> Self {
        let [[m00, m01, m02], [m10, m11, m12], [m20, m21, m22]] = rows;
        let one = m00.constant(1.0);
        let (x2, y2) = (one + m00 - m11 - m22, one - m00 + m11 - m22);
        let (z2, w2) = (one - m00 - m11 + m22, one + m00 + m11 + m22);
        let (sum_xy, sum_xz, sum_yz) = (m01 + m10, m02 + m20, m12 + m21);
        let (wx, wy, wz) = (m21 - m12, m02 - m20, m10 - m01);

        let w_largest = x2.le(w2) & y2.le(w2) & z2.le(w2);
        let x_largest = y2.le(x2) & z2.le(x2);
        let y_or_z = vector::select(z2.le(y2), [sum_xy, y2, sum_yz, wy], [sum_xz, sum_yz, z2, wz]);
        let not_w = vector::select(x_largest, [x2, sum_xy, sum_xz, wx], y_or_z);
        Self::from_array(vector::select(w_largest, [wx, wy, wz, w2], not_w))
    }

    /// Returns [`from_matrix3`](Self::from_matrix3), and the mask of the lanes whose matrix is no
    /// rotation. In such a lane an element is not finite, the determinant is negative, or a scalar
    /// product of two rows differs from its value for a rotation, 0 or 1, by more than `tolerance`.
    /// In the last two cases the matrix scales, shears or mirrors. In lanes of the mask the result
    /// is NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_matrix3_checked(rows: [[L; 3]; 3], tolerance: L) -> (Self, L::Mask) {
        let [a, b, c] = rows;
        let (zero, one) = (tolerance.constant(0.0), tolerance.constant(1.0));
        let determinant = vector::dot(a, vector::cross(b, c));
        let failed = !(is_close(vector::dot(a, a) - one, tolerance)
            & is_close(vector::dot(b, b) - one, tolerance)
            & is_close(vector::dot(c, c) - one, tolerance)
            & is_close(vector::dot(a, b), tolerance)
            & is_close(vector::dot(a, c), tolerance)
            & is_close(vector::dot(b, c), tolerance))
            | determinant.lt(zero);
        let nan = [one.constant(f64::NAN); 4];
        let rotation = vector::select(failed, nan, Self::from_matrix3(rows).to_array());
        (Self::from_array(rotation), failed)
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Returns the rows of the matrix [R | t] of unit σ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_matrix3x4(self) -> [[L; 4]; 3] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.real().to_matrix3();
        let [x, y, z] = self.translation();
        [[a, b, c, x], [d, e, f, y], [g, h, i, z]]
    }

    /// Returns the rows of [`to_matrix3x4`](Self::to_matrix3x4), and the row 0 0 0 1 below.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn to_matrix4(self) -> [[L; 4]; 4] {
        let [a, b, c] = self.to_matrix3x4();
        let zero = a[0].constant(0.0);
        [a, b, c, [zero, zero, zero, zero.constant(1.0)]]
    }

    /// Returns the motions of rigid matrices, with p_w ≥ 0.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_matrix3x4(rows: [[L; 4]; 3]) -> Self {
        let rotation = Quat::from_matrix3(rows.map(|[x, y, z, _]| [x, y, z]));
        Self::from_rotation_translation(rotation, rows.map(|[.., t]| t))
    }

    /// Returns [`from_matrix3x4`](Self::from_matrix3x4), and the mask of the lanes whose matrix is
    /// no rigid motion: [`Quat::from_matrix3_checked`] rejects its left 3×3 part, or its
    /// translation is not finite. In these lanes the result is NaN.
    ///
    /// ```
    /// use dq8::{batch::DualQuat, simd::{Mask, f32x4}};
    /// let [zero, one] = [0.0, 1.0].map(f32x4::splat);
    /// let scale = f32x4::new([1.0, 1.0001, 2.0, -1.0]);
    /// let rows = [[one, zero, zero, one], [zero, one, zero, one], [zero, zero, scale, one]];
    /// let (motion, failed) = DualQuat::from_matrix3x4_checked(rows, f32x4::splat(1e-3));
    /// assert_eq!(failed.to_bitmask(), 0b1100);
    /// assert_eq!(motion.translation()[0].to_array()[..2], [1.0; 2]);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_matrix3x4_checked(rows: [[L; 4]; 3], tolerance: L) -> (Self, L::Mask) {
        let [[a, b, c, x], [d, e, f, y], [g, h, i, z]] = rows;
        let (rotation, failed) =
            Quat::from_matrix3_checked([[a, b, c], [d, e, f], [g, h, i]], tolerance);
        let failed = failed | !vector::are_finite([x, y, z]);
        let motion = Self::from_rotation_translation(rotation, [x, y, z]).to_array();
        let nan = [tolerance.constant(f64::NAN); 8];
        (Self::from_array(vector::select(failed, nan, motion)), failed)
    }

    /// Returns the same as [`from_matrix3x4_checked`](Self::from_matrix3x4_checked) for the first
    /// three rows, but also rejects lanes whose last row is not 0 0 0 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_matrix4_checked(rows: [[L; 4]; 4], tolerance: L) -> (Self, L::Mask) {
        let [a, b, c, [x, y, z, w]] = rows;
        let (zero, one) = (tolerance.constant(0.0), tolerance.constant(1.0));
        let affine = x.eq(zero) & y.eq(zero) & z.eq(zero) & w.eq(one);
        let (motion, failed) = Self::from_matrix3x4_checked([a, b, c], tolerance);
        let failed = failed | !affine;
        let nan = [one.constant(f64::NAN); 8];
        (Self::from_array(vector::select(failed, nan, motion.to_array())), failed)
    }
}

/// Returns `true` in the lanes where a difference is within a tolerance. An infinite tolerance
/// accepts every finite difference.
#[cfg_attr(not(opt_level_0), inline(always))]
fn is_close<L: Lanes>(difference: L, tolerance: L) -> L::Mask {
    vector::is_finite(difference) & difference.abs().le(tolerance)
}
