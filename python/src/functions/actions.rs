//! What motions do to points, vectors, lines, planes, twists and wrenches.

use super::core_shape::{EIGHT, FOUR, SIX, VECTOR};
use super::{halves, joined, motion};
use crate::argument::{Argument, common_dtype};
use crate::call::{Answer, call};
use crate::law::Law;
use dq8::{Backend, DualQuat, Lanes, Line, Plane, Scalar, Twist, geometry::Wrench};
use pyo3::prelude::*;

#[derive(Clone, Copy)]
struct Point;
impl Law<8, 3, 0, 3> for Point {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 3], _: [L; 0]) -> [L; 3] {
        motion(a).transform_point(b)
    }
    fn of_one<R: Scalar>(
        self,
        backend: Backend,
        a: &[R; 8],
        b: &[[R; 3]],
        to: &mut [[R; 3]],
    ) -> bool {
        backend.transform_points(DualQuat::from_array(*a), b, to).is_ok()
    }
}

/// Points moved by unit dual quaternions: ``Rv + t``.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// points : array_like, shape (..., 3)
///     Points, lengths; leading dimensions broadcast. One motion of many points is a matrix once.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 3)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, points, /, *, out=None))]
pub(crate) fn transform_points<'py>(
    motions: &Bound<'py, PyAny>,
    points: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(
        motions.py(),
        Point,
        arguments(motions, Argument::new("points", VECTOR, points)),
        VECTOR,
        out,
    )
}

#[derive(Clone, Copy)]
struct Vector;
impl Law<8, 3, 0, 3> for Vector {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 3], _: [L; 0]) -> [L; 3] {
        motion(a).transform_vector(b)
    }
    fn of_one<R: Scalar>(
        self,
        backend: Backend,
        a: &[R; 8],
        b: &[[R; 3]],
        to: &mut [[R; 3]],
    ) -> bool {
        backend.transform_vectors(DualQuat::from_array(*a), b, to).is_ok()
    }
}

/// Directions and differences turned by unit dual quaternions: ``v′ = Rv``.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// vectors : array_like, shape (..., 3)
///     Vectors of any unit; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 3)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, vectors, /, *, out=None))]
pub(crate) fn transform_vectors<'py>(
    motions: &Bound<'py, PyAny>,
    vectors: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = arguments(motions, Argument::new("vectors", VECTOR, vectors));
    call(motions.py(), Vector, arguments, VECTOR, out)
}

#[derive(Clone, Copy)]
struct OfLine;
impl Law<8, 6, 0, 6> for OfLine {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 6], _: [L; 0]) -> [L; 6] {
        let (direction, moment) = halves(b);
        let line = motion(a).transform_line(Line { direction, moment });
        joined(line.direction, line.moment)
    }
}

/// Lines moved by unit dual quaternions: ``l′ = Rl, m′ = Rm + t × l′``, lengths in m alone.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// lines : array_like, shape (..., 6)
///     Plücker coordinates ``[l, m]``, direction and moment ``m = x × l`` of any point x of the line;
///     leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 6)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, lines, /, *, out=None))]
pub(crate) fn transform_lines<'py>(
    motions: &Bound<'py, PyAny>,
    lines: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), OfLine, arguments(motions, Argument::new("lines", SIX, lines)), SIX, out)
}

#[derive(Clone, Copy)]
struct OfPlane;
impl Law<8, 4, 0, 4> for OfPlane {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], [x, y, z, offset]: [L; 4], _: [L; 0]) -> [L; 4] {
        let plane = motion(a).transform_plane(Plane { normal: [x, y, z], offset });
        let [x, y, z] = plane.normal;
        [x, y, z, plane.offset]
    }
}

/// Planes moved by unit dual quaternions: ``n′ = Rn, d′ = d + n′·t``.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// planes : array_like, shape (..., 4)
///     ``[nx, ny, nz, d]`` of the plane ``n·x = d``, d a length where n has none; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 4)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, planes, /, *, out=None))]
pub(crate) fn transform_planes<'py>(
    motions: &Bound<'py, PyAny>,
    planes: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(
        motions.py(),
        OfPlane,
        arguments(motions, Argument::new("planes", FOUR, planes)),
        FOUR,
        out,
    )
}

#[derive(Clone, Copy)]
struct Adjoint;
impl Law<8, 6, 0, 6> for Adjoint {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 6], _: [L; 0]) -> [L; 6] {
        let twist = motion(a).adjoint(Twist::from_array(b));
        joined(twist.angular, twist.linear)
    }
}

/// Twists in the fixed frame from twists in the moving one: ``ω′ = Rω, v′ = Rv + t × ω′``.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// twists : array_like, shape (..., 6)
///     ``[ω, v]``: radians per unit of time, and the velocity of the point at the frame's origin;
///     leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 6)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, twists, /, *, out=None))]
pub(crate) fn adjoint<'py>(
    motions: &Bound<'py, PyAny>,
    twists: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), Adjoint, arguments(motions, Argument::new("twists", SIX, twists)), SIX, out)
}

#[derive(Clone, Copy)]
struct Coadjoint;
impl Law<8, 6, 0, 6> for Coadjoint {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 6], _: [L; 0]) -> [L; 6] {
        let (force, torque) = halves(b);
        let wrench = motion(a).coadjoint(Wrench { force, torque });
        joined(wrench.force, wrench.torque)
    }
}

/// Wrenches in the fixed frame from wrenches in the moving one: ``f′ = Rf, τ′ = Rτ + t × f′``.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// wrenches : array_like, shape (..., 6)
///     ``[f, τ]``: force, and torque about the frame's origin, in forces times lengths; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 6)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, wrenches, /, *, out=None))]
pub(crate) fn coadjoint<'py>(
    motions: &Bound<'py, PyAny>,
    wrenches: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = arguments(motions, Argument::new("wrenches", SIX, wrenches));
    call(motions.py(), Coadjoint, arguments, SIX, out)
}

fn arguments<'a, 'py>(
    motions: &'a Bound<'py, PyAny>,
    acted_on: Option<Argument<'a, 'py>>,
) -> [Option<Argument<'a, 'py>>; 3] {
    [Argument::new("motions", EIGHT, motions), acted_on, None]
}
