//! Motions from and to rotations, translations and matrices.

use super::core_shape::{EIGHT, FOUR, MATRIX, VECTOR};
use super::motion;
use crate::argument::{Argument, common_dtype};
use crate::call::{Answer, call};
use crate::law::Law;
use dq8::{Lanes, batch};
use pyo3::prelude::*;

#[derive(Clone, Copy)]
struct FromTranslation;
impl Law<3, 0, 0, 8> for FromTranslation {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 3], _: [L; 0], _: [L; 0]) -> [L; 8] {
        batch::DualQuat::from_translation(a).to_array()
    }
}

/// Translations as unit dual quaternions: ``1 + ½εt``.
///
/// Parameters
/// ----------
/// translations : array_like, shape (..., 3)
///     Lengths.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (translations, /, *, out=None))]
pub(crate) fn from_translation<'py>(
    translations: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [Argument::new("translation", VECTOR, translations), None, None];
    call(translations.py(), FromTranslation, arguments, EIGHT, out)
}

#[derive(Clone, Copy)]
struct FromRotationTranslation;
impl Law<4, 3, 0, 8> for FromRotationTranslation {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 4], b: [L; 3], _: [L; 0]) -> [L; 8] {
        batch::DualQuat::from_rotation_translation(batch::Quat::from_array(a), b).to_array()
    }
}

/// Rotate, then translate: ``r + ½εtr``.
///
/// Parameters
/// ----------
/// rotations : array_like, shape (..., 4)
///     Unit quaternions ``[x, y, z, w]``.
/// translations : array_like, shape (..., 3)
///     Lengths; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (rotations, translations, /, *, out=None))]
pub(crate) fn from_rotation_translation<'py>(
    rotations: &Bound<'py, PyAny>,
    translations: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [
        Argument::new("rotations", FOUR, rotations),
        Argument::new("translation", VECTOR, translations),
        None,
    ];
    call(rotations.py(), FromRotationTranslation, arguments, EIGHT, out)
}

#[derive(Clone, Copy)]
struct Translation;
impl Law<8, 0, 0, 3> for Translation {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 3] {
        motion(a).translation()
    }
}

/// Translations ``t = 2qp*`` of unit dual quaternions, lengths.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 3)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn translation<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(
        motions.py(),
        Translation,
        [Argument::new("motions", EIGHT, motions), None, None],
        VECTOR,
        out,
    )
}

#[derive(Clone, Copy)]
struct ToMatrix;
impl Law<8, 0, 0, 16> for ToMatrix {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 16] {
        let [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]] = motion(a).to_matrix4();
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p]
    }
}

/// Matrices ``[R t; 0 1]`` of unit dual quaternions, for column vectors, t in lengths.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 4, 4)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn to_matrix<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(
        motions.py(),
        ToMatrix,
        [Argument::new("motions", EIGHT, motions), None, None],
        MATRIX,
        out,
    )
}

#[derive(Clone, Copy)]
struct FromMatrix;
impl Law<16, 0, 0, 8> for FromMatrix {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 16], _: [L; 0], _: [L; 0]) -> [L; 8] {
        let [a, b, c, d, e, f, g, h, i, j, k, l, ..] = a;
        batch::DualQuat::from_matrix3x4([[a, b, c, d], [e, f, g, h], [i, j, k, l]]).to_array()
    }
}

/// Unit dual quaternions of rigid matrices ``[R t; 0 1]``, with p_w ≥ 0: ``r + ½εtr`` with r the quaternion of R.
///
/// R must be a rotation; it is not made one here (`RigidTransform.from_matrix` does that), and the last
/// row is not read.
///
/// Parameters
/// ----------
/// matrices : array_like, shape (..., 4, 4)
///     Rigid matrices for column vectors, t in lengths.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///
/// References
/// ----------
/// S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1 (1978).
#[pyfunction]
#[pyo3(signature = (matrices, /, *, out=None))]
pub(crate) fn from_matrix<'py>(
    matrices: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [Argument::new("matrix", MATRIX, matrices), None, None];
    call(matrices.py(), FromMatrix, arguments, EIGHT, out)
}

#[derive(Clone, Copy)]
struct Rigidity;
impl Law<16, 0, 0, 3> for Rigidity {
    #[inline(always)]
    fn of<L: Lanes>(self, m: [L; 16], _: [L; 0], _: [L; 0]) -> [L; 3] {
        let one = m[0].constant(1.0);
        let rows = [[m[0], m[1], m[2]], [m[4], m[5], m[6]], [m[8], m[9], m[10]]];
        let [a, b, c] = rows;
        let mut defect = one.constant(0.0);
        for off in
            [dot(a, a) - one, dot(b, b) - one, dot(c, c) - one, dot(a, b), dot(a, c), dot(b, c)]
        {
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

/// How far matrices are from rigid ones: the largest component of ``|RRᵀ − 1|``, the determinant of R, and
/// the largest difference of the last row from 0 0 0 1.
///
/// Parameters
/// ----------
/// matrices : array_like, shape (..., 4, 4)
///     Matrices, of which pure numbers are read.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 3)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (matrices, /, *, out=None))]
pub(crate) fn rigidity<'py>(
    matrices: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [Argument::new("matrix", MATRIX, matrices), None, None];
    call(matrices.py(), Rigidity, arguments, VECTOR, out)
}
