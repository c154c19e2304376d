//! Motions from and to rotations, translations and matrices.

use super::function::*;
use super::motion;
use dq8::batch;

function! {
    /// Translations as unit dual quaternions: ``1 + ½εt``.
    fn from_translation(
        /// Lengths.
        translations as "translation": [3],
    ) -> [8] {
        batch::DualQuat::from_translation(translations).to_array()
    }
}

function! {
    /// Rotate, then translate: ``r + ½εtr``.
    fn from_rotation_translation(
        /// Unit quaternions ``[x, y, z, w]``.
        rotations: [4],
        /// Lengths; leading dimensions broadcast.
        translations as "translation": [3],
    ) -> [8] {
        let rotation = batch::Quat::from_array(rotations);
        batch::DualQuat::from_rotation_translation(rotation, translations).to_array()
    }
}

function! {
    /// Translations ``t = 2qp*`` of unit dual quaternions, lengths.
    fn translation(
        /// Unit dual quaternions.
        motions: [8],
    ) -> [3] {
        motion(motions).translation()
    }
}

function! {
    /// Matrices ``[R t; 0 1]`` of unit dual quaternions, for column vectors, t in lengths.
    fn to_matrix(
        /// Unit dual quaternions.
        motions: [8],
    ) -> [4, 4] {
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = motion(motions).to_matrix4();
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p]
    }
}

function! {
    /// Unit dual quaternions of rigid matrices ``[R t; 0 1]``, with p_w ≥ 0: ``r + ½εtr`` with r the quaternion of R.
    ///
    /// R must be a rotation; it is not made one here (`RigidTransform.from_matrix` does that), and the last
    /// row is not read.
    fn from_matrix(
        /// Rigid matrices for column vectors, t in lengths.
        matrices as "matrix": [4, 4],
    ) -> [8]
    ///
    /// References
    /// ----------
    /// S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1 (1978).
    {
        let [a, b, c, d, e, f, g, h, i, j, k, l, ..] = matrices;
        batch::DualQuat::from_matrix3x4([[a, b, c, d], [e, f, g, h], [i, j, k, l]]).to_array()
    }
}

function! {
    /// How far matrices are from rigid ones: the largest component of ``|RRᵀ − 1|``, the determinant of R, and
    /// the largest difference of the last row from 0 0 0 1.
    fn rigidity(
        /// Matrices, of which pure numbers are read.
        matrices as "matrix": [4, 4],
    ) -> [3] {
        let m = matrices;
        let one = m[0].constant(1.0);
        let rows = [[m[0], m[1], m[2]], [m[4], m[5], m[6]], [m[8], m[9], m[10]]];
        let [a, b, c] = rows;
        let mut defect = one.constant(0.0);
        for off in [dot(a, a) - one, dot(b, b) - one, dot(c, c) - one, dot(a, b), dot(a, c), dot(b, c)] {
            defect = larger(defect, off.abs());
        }
        let [x, y, z] = a;
        let determinant = x * (b[1] * c[2] - b[2] * c[1])
            + y * (b[2] * c[0] - b[0] * c[2])
            + z * (b[0] * c[1] - b[1] * c[0]);
        let mut last_row = one.constant(0.0);
        for off in [m[12], m[13], m[14], m[15] - one] {
            last_row = larger(last_row, off.abs());
        }
        [defect, determinant, last_row]
    }
}

#[inline(always)]
fn dot<L: Lanes>(a: [L; 3], b: [L; 3]) -> L {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The larger one; NaN where `b` is, and from then on.
#[inline(always)]
fn larger<L: Lanes>(a: L, b: L) -> L {
    L::select(b.le(a), a, a * a.constant(0.0) + b)
}
