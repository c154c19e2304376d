//! How far motions are apart.

use super::core_shape::{EIGHT, NUMBER, VECTOR};
use super::motion;
use crate::argument::{Argument, common_dtype};
use crate::call::{Answer, call};
use crate::law::Law;
use dq8::Lanes;
use pyo3::prelude::*;

#[derive(Clone, Copy)]
struct Angle;
impl Law<8, 8, 0, 1> for Angle {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 8], _: [L; 0]) -> [L; 1] {
        [motion(a).angle_to(motion(b))]
    }
}

/// The angle of the rotation from `a` to `b`, radians in [0, π]: ``2 atan2(|v|, |w|)`` of ``v + w = p_a* p_b``.
///
/// Parameters
/// ----------
/// a, b : array_like, shape (..., 8)
///     Unit dual quaternions; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (...)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (a, b, /, *, out=None))]
pub(crate) fn angle_to<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(a.py(), Angle, arguments(a, b, None), NUMBER, out)
}

#[derive(Clone, Copy)]
struct Distance;
impl Law<8, 8, 0, 1> for Distance {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 8], _: [L; 0]) -> [L; 1] {
        [motion(a).distance_to(motion(b))]
    }
}

/// The distance of the translations, ``|t_a − t_b|``, a length.
///
/// Parameters
/// ----------
/// a, b : array_like, shape (..., 8)
///     Unit dual quaternions; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (...)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (a, b, /, *, out=None))]
pub(crate) fn distance_to<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(a.py(), Distance, arguments(a, b, None), NUMBER, out)
}

#[derive(Clone, Copy)]
struct Weighted;
impl Law<8, 8, 1, 1> for Weighted {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 8], [length]: [L; 1]) -> [L; 1] {
        [motion(a).distance_weighted(motion(b), length)]
    }
}

/// A distance of motions, ``√((λθ)² + d²)``, of `angle_to` θ and `distance_to` d; a length.
///
/// Parameters
/// ----------
/// a, b : array_like, shape (..., 8)
///     Unit dual quaternions.
/// length_per_radian : array_like, shape (...)
///     λ, the length that counts as much as a radian. Leading dimensions of all three broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (...)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (a, b, length_per_radian, /, *, out=None))]
pub(crate) fn distance_weighted<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
    length_per_radian: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let length = Argument::new("length_per_radian", NUMBER, length_per_radian);
    call(a.py(), Weighted, arguments(a, b, length), NUMBER, out)
}

#[derive(Clone, Copy)]
struct PointError;
impl Law<8, 8, 3, 1> for PointError {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 8], point: [L; 3]) -> [L; 1] {
        [motion(a).point_error(motion(b), point)]
    }
}

/// How far apart `a` and `b` move a point: ``|av − bv|``, a length.
///
/// Parameters
/// ----------
/// a, b : array_like, shape (..., 8)
///     Unit dual quaternions.
/// points : array_like, shape (..., 3)
///     The points v. Leading dimensions of all three broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (...)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (a, b, points, /, *, out=None))]
pub(crate) fn point_error<'py>(
    a: &Bound<'py, PyAny>,
    b: &Bound<'py, PyAny>,
    points: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = arguments(a, b, Argument::new("points", VECTOR, points));
    call(a.py(), PointError, arguments, NUMBER, out)
}

fn arguments<'a, 'py>(
    a: &'a Bound<'py, PyAny>,
    b: &'a Bound<'py, PyAny>,
    third: Option<Argument<'a, 'py>>,
) -> [Option<Argument<'a, 'py>>; 3] {
    [Argument::new("a", EIGHT, a), Argument::new("b", EIGHT, b), third]
}
