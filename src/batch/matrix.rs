//! 3×3, 3×4 and 4×4 matrices, rows, acting on column vectors.

use super::{DualQuat, Quat, vector};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// The rows of the rotation matrices of unit quaternions.
    #[inline(always)]
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

    /// The unit quaternions of rotation matrices, w ≥ 0 (Shepperd 1978): all four forms, one of which
    /// divides by the largest component.
    #[inline(always)]
    #[must_use]
    pub fn from_matrix3(rows: [[L; 3]; 3]) -> Self {
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
        let rotation = Self::from_array(vector::select(w_largest, [wx, wy, wz, w2], not_w));
        let rotation = rotation.normalize();
        let turned_over = rotation.w().lt(one.constant(0.0));
        rotation.scale(L::select(turned_over, -one, one))
    }
}

impl<L: Lanes> DualQuat<L> {
    /// The rows of [R | t] of unit σ.
    #[inline(always)]
    #[must_use]
    pub fn to_matrix3x4(self) -> [[L; 4]; 3] {
        let [[a, b, c], [d, e, f], [g, h, i]] = self.real().to_matrix3();
        let [x, y, z] = self.translation();
        [[a, b, c, x], [d, e, f, y], [g, h, i, z]]
    }

    /// [`to_matrix3x4`](Self::to_matrix3x4) with the row 0 0 0 1 below.
    #[inline(always)]
    #[must_use]
    pub fn to_matrix4(self) -> [[L; 4]; 4] {
        let [a, b, c] = self.to_matrix3x4();
        let zero = a[0].constant(0.0);
        [a, b, c, [zero, zero, zero, zero.constant(1.0)]]
    }

    /// The motions of rigid matrices, p_w ≥ 0.
    #[inline(always)]
    #[must_use]
    pub fn from_matrix3x4(rows: [[L; 4]; 3]) -> Self {
        let rotation = Quat::from_matrix3(rows.map(|[x, y, z, _]| [x, y, z]));
        Self::from_rotation_translation(rotation, rows.map(|[.., t]| t))
    }
}
