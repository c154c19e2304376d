//! Products, inverses, norms.

use super::core_shape::EIGHT;
use super::motion;
use crate::argument::{Argument, common_dtype};
use crate::call::{Answer, call};
use crate::law::Law;
use dq8::Lanes;
use pyo3::prelude::*;

#[derive(Clone, Copy)]
struct Mul;
impl Law<8, 8, 0, 8> for Mul {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 8], _: [L; 0]) -> [L; 8] {
        (motion(a) * motion(b)).to_array()
    }
}

/// Products ``a b``: `b` acts first.
///
/// ``(p + εq)(r + εs) = pr + ε(ps + qr)``
///
/// Parameters
/// ----------
/// a, b : array_like, shape (..., 8)
///     Dual quaternions ``[px, py, pz, pw, qx, qy, qz, qw]``; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result: its shape and dtype. May be an argument.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///
/// Examples
/// --------
/// >>> import dq8
/// >>> step = dq8.from_translation([1.0, 0.0, 0.0])
/// >>> dq8.translation(dq8.mul(step, step))
/// array([2., 0., 0.])
#[pyfunction]
#[pyo3(signature = (a, b, /, *, out=None))]
pub(crate) fn mul<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [Argument::new("a", EIGHT, a), Argument::new("b", EIGHT, b), None];
    call(a.py(), Mul, arguments, EIGHT, out)
}

#[derive(Clone, Copy)]
struct Compose;
impl Law<8, 8, 0, 8> for Compose {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 8], _: [L; 0]) -> [L; 8] {
        (motion(a) * motion(b)).normalize().to_array()
    }
}

/// Normalized products: ``normalize(mul(a, b))`` in one pass.
///
/// The norm of a chain of products drifts; this keeps it at one.
///
/// Parameters
/// ----------
/// a, b : array_like, shape (..., 8)
///     Dual quaternions; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (a, b, /, *, out=None))]
pub(crate) fn compose<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [Argument::new("a", EIGHT, a), Argument::new("b", EIGHT, b), None];
    call(a.py(), Compose, arguments, EIGHT, out)
}

#[derive(Clone, Copy)]
struct Inverse;
impl Law<8, 0, 0, 8> for Inverse {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 8] {
        motion(a).inverse().to_array()
    }
}

/// Inverses ``σ⁻¹ = p⁻¹ − ε p⁻¹ q p⁻¹`` of any σ = p + εq with p ≠ 0.
///
/// Of unit dual quaternions `conjugate` is the same, and faster.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Dual quaternions.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///     Some component is NaN or infinite where there is no inverse.
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn inverse<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), Inverse, [Argument::new("motions", EIGHT, motions), None, None], EIGHT, out)
}

#[derive(Clone, Copy)]
struct Conjugate;
impl Law<8, 0, 0, 8> for Conjugate {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 8] {
        motion(a).conjugate().to_array()
    }
}

/// Conjugates ``σ* = p* + εq*``, the inverses of unit dual quaternions.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Dual quaternions.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn conjugate<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(
        motions.py(),
        Conjugate,
        [Argument::new("motions", EIGHT, motions), None, None],
        EIGHT,
        out,
    )
}

#[derive(Clone, Copy)]
struct Normalize;
impl Law<8, 0, 0, 8> for Normalize {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 8] {
        motion(a).normalize().to_array()
    }
}

/// Unit dual quaternions ``σ/√(σσ*)``: p of length one, and q orthogonal to it.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Dual quaternions with p ≠ 0.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///     Some component is NaN where p = 0 or a component is not finite.
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn normalize<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(
        motions.py(),
        Normalize,
        [Argument::new("motions", EIGHT, motions), None, None],
        EIGHT,
        out,
    )
}

#[derive(Clone, Copy)]
struct UnitOrIdentity;
impl Law<8, 0, 0, 8> for UnitOrIdentity {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 8] {
        let [x, y, z, w, ..] = a;
        let zero = w.constant(0.0);
        let nothing = x.eq(zero) & y.eq(zero) & z.eq(zero) & w.eq(zero);
        let mut made = a;
        made[3] = L::select(nothing, w.constant(1.0), w);
        motion(made).normalize().to_array()
    }
}

/// `normalize`, ``σ/√(σσ*)``, with p = 1 where p = 0: what SciPy takes dual quaternions for.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Dual quaternions.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn unit_or_identity<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [Argument::new("dual_quat", EIGHT, motions), None, None];
    call(motions.py(), UnitOrIdentity, arguments, EIGHT, out)
}
