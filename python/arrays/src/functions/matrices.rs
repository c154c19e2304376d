//! Motions from matrices, checked.

use super::faults::{Fault, TOLERANCE, refuse};
use super::function::*;
use crate::argument::is_single;
use crate::number::Number;
use crate::shape::EIGHT;
use dq8::scalar::MatrixError;
use dq8::{Real, batch};
use std::ops::{Add, Mul, Sub};

/// Unit dual quaternions of rigid matrices ``[R t; 0 1]``, with p_w ≥ 0: ``r + ½εtr`` with r
/// the quaternion of R.
///
/// ValueError names the first matrix whose last row is not 0 0 0 1 (columns given as rows look like
/// this), whose R mirrors or has no volume, or, with `check`, whose R is farther than 0.001 from a
/// rotation in ``RRᵀ`` or whose t is infinite. Nearer ones are not made rotations first;
/// `RigidTransform.from_matrix` makes them so, and takes any R of positive determinant. A matrix
/// with NaN is answered with NaN.
///
/// Parameters
/// ----------
/// matrices : array_like, shape (..., 4, 4) or (..., 3, 4)
///     Rigid matrices for column vectors, t in lengths; the last row may be left out.
/// check : bool, optional
///     False takes every R of positive determinant for a rotation.
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
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> dq8.from_matrix(np.eye(4))
/// array([0., 0., 0., 1., 0., 0., 0., 0.])
#[pyfunction]
#[pyo3(signature = (matrices, *, check=true, out=None))]
pub fn from_matrix<'py>(
    py: Python<'py>,
    matrices: &Bound<'py, PyAny>,
    check: bool,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let whole = Argument::new("matrices", &[4, 4], matrices)?;
    if whole.shape().ends_with(&[3, 4]) {
        of_rows::<12>(py, whole.of_elements(&[3, 4]), check, out)
    } else {
        of_rows::<16>(py, whole, check, out)
    }
}

/// Of matrices of `C` numbers.
fn of_rows<'py, const C: usize>(
    py: Python<'py>,
    matrices: Argument<'py>,
    check: bool,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    if is_single([&matrices]) {
        refuse::<f32, _, C>(&matrices, NotRigid { check })?;
    } else {
        refuse::<f64, _, C>(&matrices, NotRigid { check })?;
    }
    call::<_, C, 0, 0, 8>(py, Motions, &[matrices], EIGHT, out)
}

#[derive(Clone, Copy)]
struct Motions;

impl<const C: usize> Law<C, 0, 0, 8> for Motions {
    #[inline(always)]
    fn of<L: Lanes>(self, matrix: [L; C], _: [L; 0], _: [L; 0]) -> [L; 8] {
        let motion = batch::DualQuat::from_matrix3x4(rows(matrix)).to_array();
        // NaN of any number in the place of all of them, and zero otherwise.
        let nothing = matrix[0].constant(0.0);
        let sum = matrix.into_iter().fold(
            nothing,
            #[inline(always)]
            |sum, number| sum + number,
        );
        motion.map(
            #[inline(always)]
            |number| number + sum * nothing,
        )
    }
}

/// The first three rows.
#[inline(always)]
fn rows<T: Copy, const C: usize>(matrix: [T; C]) -> [[T; 4]; 3] {
    [0, 4, 8].map(|row| [matrix[row], matrix[row + 1], matrix[row + 2], matrix[row + 3]])
}

/// Why a matrix is not rigid.
fn reason<R: Number, const C: usize>(matrix: [R; C]) -> String {
    let last = matrix.get(12..).unwrap_or_default().iter().zip([R::ZERO, R::ZERO, R::ZERO, R::ONE]);
    for (column, (&value, wanted)) in last.enumerate() {
        if value != wanted {
            return format!(
                "element {column} of the last row is {value}, which must be 0 0 0 1 (columns given as rows?)"
            );
        }
    }
    let rows = rows(matrix);
    let determinant = determinant(rows.map(|[x, y, z, _]| [x, y, z]));
    if determinant <= R::ZERO {
        return format!(
            "the determinant of its rotation is {determinant}, which must be 1 (it mirrors, or has no volume)"
        );
    }
    match DualQuat::try_from_matrix3x4(rows, <R as Real>::from_f64(TOLERANCE)) {
        Err(MatrixError::NotOrthonormal { row, column, value }) => format!(
            "the product of rows {row} and {column} of its rotation is {value}, which must be {} (it scales or shears)",
            u8::from(row == column)
        ),
        Err(MatrixError::Scales { factor }) => {
            format!("it scales by {factor}, which no motion does")
        }
        Err(error) => error.to_string(),
        Ok(_) => "it is not rigid".to_owned(),
    }
}

/// A matrix that is not rigid; with `check`, also one that scales, shears, or whose translation is
/// not finite.
#[derive(Clone, Copy)]
struct NotRigid {
    check: bool,
}

impl<const C: usize> Fault<C> for NotRigid {
    #[inline(always)]
    fn is_in<L: Lanes>(self, matrix: [L; C]) -> L::Mask {
        let zero = matrix[0].constant(0.0);
        let mut whole = [zero; 16];
        whole[15] = zero.constant(1.0);
        whole[..C].copy_from_slice(&matrix);
        let [defect, determinant, last_row] = rigidity_of(whole);
        let mut wrong = !last_row.le(zero) | determinant.le(zero);
        if self.check {
            // What is not finite is NaN then, also a translation.
            let finite = (matrix[3] + matrix[7] + matrix[11]) * zero;
            wrong = wrong | !(defect + finite).le(zero.constant(TOLERANCE));
        }
        let mut known = zero.eq(zero);
        for number in matrix {
            known = known & number.eq(number);
        }
        wrong & known
    }
    fn reason<R: Number>(self, matrix: [R; C]) -> String {
        reason(matrix)
    }
}

/// How far matrices are from rigid ones, see `rigidity`.
#[inline(always)]
pub(super) fn rigidity_of<L: Lanes>(m: [L; 16]) -> [L; 3] {
    let one = m[0].constant(1.0);
    let rows = [[m[0], m[1], m[2]], [m[4], m[5], m[6]], [m[8], m[9], m[10]]];
    let [a, b, c] = rows;
    let mut defect = one.constant(0.0);
    for off in [dot(a, a) - one, dot(b, b) - one, dot(c, c) - one, dot(a, b), dot(a, c), dot(b, c)]
    {
        defect = larger(defect, off.abs());
    }
    let mut last_row = one.constant(0.0);
    for off in [m[12], m[13], m[14], m[15] - one] {
        last_row = larger(last_row, off.abs());
    }
    [defect, determinant(rows), last_row]
}

#[inline(always)]
fn determinant<T>([[x, y, z], b, c]: [[T; 3]; 3]) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    x * (b[1] * c[2] - b[2] * c[1])
        + y * (b[2] * c[0] - b[0] * c[2])
        + z * (b[0] * c[1] - b[1] * c[0])
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
