//! Logarithm, exponential, powers, twists and screws.

use super::core_shape::{EIGHT, NUMBER, SIX};
use super::{halves, joined, motion};
use crate::argument::{Argument, common_dtype};
use crate::call::{Answer, call};
use crate::law::Law;
use dq8::{
    Lanes, Line, Twist, batch,
    geometry::{DualVector, Screw},
};
use pyo3::prelude::*;

#[derive(Clone, Copy)]
struct Log;
impl Law<8, 0, 0, 6> for Log {
    const WIDE: bool = true;

    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 6] {
        let log = motion(a).log();
        joined(log.real, log.dual)
    }
}

/// Logarithms of unit dual quaternions: ``(θ̂/2)(l + εm)``, half the twist that makes the motion.
///
/// Of ±σ, which are the same motion, that of the one with p_w ≥ 0. `to_twist` is twice this.
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
/// ndarray, shape (..., 6)
#[doc = common_dtype!()]
///     Real part (half the rotation vector, radians) and dual part (lengths).
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn log<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), Log, [Argument::new("motions", EIGHT, motions), None, None], SIX, out)
}

#[derive(Clone, Copy)]
struct Exp;
impl Law<6, 0, 0, 8> for Exp {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 6], _: [L; 0], _: [L; 0]) -> [L; 8] {
        let (real, dual) = halves(a);
        batch::DualQuat::exp(DualVector { real, dual }).to_array()
    }
}

/// Exponentials of dual vectors, ``cos ĥ + sin ĥ (l + εm)`` of ``ĥ(l + εm)``: what `log` undoes.
///
/// Parameters
/// ----------
/// logs : array_like, shape (..., 6)
///     Real part (half the rotation vector, radians) and dual part (lengths).
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///     NaN where the real part is beyond 2⁴⁵ radians (float32: 2¹⁶).
#[pyfunction]
#[pyo3(signature = (logs, /, *, out=None))]
pub(crate) fn exp<'py>(logs: &Bound<'py, PyAny>, out: Option<&Bound<'py, PyAny>>) -> Answer<'py> {
    call(logs.py(), Exp, [Argument::new("logs", SIX, logs), None, None], EIGHT, out)
}

#[derive(Clone, Copy)]
struct ToTwist;
impl Law<8, 0, 0, 6> for ToTwist {
    const WIDE: bool = true;

    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 6] {
        let twist = motion(a).to_twist();
        joined(twist.angular, twist.linear)
    }
}

/// The constant twists that make the motions in unit time: ``2 log σ``, the exponential coordinates.
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
/// ndarray, shape (..., 6)
#[doc = common_dtype!()]
///     ``[ωx, ωy, ωz, vx, vy, vz]``: the rotation vector in radians, of at most π, and the velocity of
///     the point at the origin, in lengths.
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn to_twist<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), ToTwist, [Argument::new("motions", EIGHT, motions), None, None], SIX, out)
}

#[derive(Clone, Copy)]
struct FromTwist;
impl Law<6, 0, 0, 8> for FromTwist {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 6], _: [L; 0], _: [L; 0]) -> [L; 8] {
        batch::DualQuat::from_twist(Twist::from_array(a)).to_array()
    }
}

/// The motions that constant twists make in unit time: ``exp(½ξ)`` of exponential coordinates ξ.
///
/// Parameters
/// ----------
/// twists : array_like, shape (..., 6)
///     ``[ωx, ωy, ωz, vx, vy, vz]``, radians and lengths.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///     NaN where ω is beyond 2⁴⁶ radians (float32: 2¹⁷).
#[pyfunction]
#[pyo3(signature = (twists, /, *, out=None))]
pub(crate) fn from_twist<'py>(
    twists: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(twists.py(), FromTwist, [Argument::new("twists", SIX, twists), None, None], EIGHT, out)
}

#[derive(Clone, Copy)]
struct Pow;
impl Law<8, 1, 0, 8> for Pow {
    const WIDE: bool = true;

    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], [t]: [L; 1], _: [L; 0]) -> [L; 8] {
        motion(a).pow(t).to_array()
    }
}

/// Powers ``σᵗ = exp(t log σ)`` of unit dual quaternions: the part t of each screw motion.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions.
/// t : array_like, shape (...)
///     Exponents; leading dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, t, /, *, out=None))]
pub(crate) fn pow<'py>(
    motions: &Bound<'py, PyAny>,
    t: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let arguments = [Argument::new("motions", EIGHT, motions), Argument::new("t", NUMBER, t), None];
    call(motions.py(), Pow, arguments, EIGHT, out)
}

#[derive(Clone, Copy)]
struct ToScrew;
impl Law<8, 0, 0, 8> for ToScrew {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 8] {
        let Screw { axis, angle, slide } = motion(a).to_screw();
        let [a, b, c, d, e, f] = joined(axis.direction, axis.moment);
        [a, b, c, d, e, f, angle, slide]
    }
}

/// Screws: the axis l + εm that each motion turns about by θ and slides along by d.
///
/// ``±σ = cos(θ̂/2) + sin(θ̂/2)(l + εm)`` with ``θ̂ = θ + εd``
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
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///     ``[lx, ly, lz, mx, my, mz, θ, d]``: direction of length one and moment of the axis (Plücker), the
///     angle in [0, π] radians, the length of the slide. A pure translation has angle and moment 0 and
///     its own direction; the identity has the direction (1, 0, 0).
///
/// References
/// ----------
/// Y.-B. Jia, "Dual Quaternions", Iowa State University, eq. 36–43.
#[pyfunction]
#[pyo3(signature = (motions, /, *, out=None))]
pub(crate) fn to_screw<'py>(
    motions: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), ToScrew, [Argument::new("motions", EIGHT, motions), None, None], EIGHT, out)
}

#[derive(Clone, Copy)]
struct FromScrew;
impl Law<8, 0, 0, 8> for FromScrew {
    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], _: [L; 0], _: [L; 0]) -> [L; 8] {
        let [a, b, c, d, e, f, angle, slide] = a;
        let axis = Line { direction: [a, b, c], moment: [d, e, f] };
        batch::DualQuat::from_screw(Screw { axis, angle, slide }).to_array()
    }
}

/// Motions from screws: ``σ = cos(θ̂/2) + sin(θ̂/2)(l + εm)`` with ``θ̂ = θ + εd``.
///
/// Parameters
/// ----------
/// screws : array_like, shape (..., 8)
///     ``[lx, ly, lz, mx, my, mz, θ, d]`` as `to_screw` returns them: radians and lengths; l has length one.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (screws, /, *, out=None))]
pub(crate) fn from_screw<'py>(
    screws: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(screws.py(), FromScrew, [Argument::new("screws", EIGHT, screws), None, None], EIGHT, out)
}

#[derive(Clone, Copy)]
struct IntegrateBody;
impl Law<8, 6, 1, 8> for IntegrateBody {
    const WIDE: bool = true;

    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 6], [dt]: [L; 1]) -> [L; 8] {
        motion(a).integrate_body(Twist::from_array(b), dt).to_array()
    }
}

/// Where constant body twists ξ take motions in the time `dt`: ``σ exp(½ξ dt)``.
///
/// With the screw axis of a joint as twist and its angle as time, this is the pose of a link in its parent:
/// ``integrate_body(offset, [axis, 0], angle)`` of a hinge.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions at time 0.
/// twists : array_like, shape (..., 6)
///     ``[ω, v]`` in the moving frame, radians and lengths per unit of time.
/// dt : array_like, shape (...)
///     Time, or the angle of a joint. Leading dimensions of all three broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, twists, dt, /, *, out=None))]
pub(crate) fn integrate_body<'py>(
    motions: &Bound<'py, PyAny>,
    twists: &Bound<'py, PyAny>,
    dt: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), IntegrateBody, arguments(motions, twists, dt), EIGHT, out)
}

#[derive(Clone, Copy)]
struct IntegrateSpatial;
impl Law<8, 6, 1, 8> for IntegrateSpatial {
    const WIDE: bool = true;

    #[inline(always)]
    fn of<L: Lanes>(self, a: [L; 8], b: [L; 6], [dt]: [L; 1]) -> [L; 8] {
        motion(a).integrate_spatial(Twist::from_array(b), dt).to_array()
    }
}

/// Where constant spatial twists ξ take motions in the time `dt`: ``exp(½ξ dt) σ``.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., 8)
///     Unit dual quaternions at time 0.
/// twists : array_like, shape (..., 6)
///     ``[ω, v]`` in the fixed frame, radians and lengths per unit of time.
/// dt : array_like, shape (...)
///     Time. Leading dimensions of all three broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
#[pyfunction]
#[pyo3(signature = (motions, twists, dt, /, *, out=None))]
pub(crate) fn integrate_spatial<'py>(
    motions: &Bound<'py, PyAny>,
    twists: &Bound<'py, PyAny>,
    dt: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    call(motions.py(), IntegrateSpatial, arguments(motions, twists, dt), EIGHT, out)
}

fn arguments<'a, 'py>(
    motions: &'a Bound<'py, PyAny>,
    twists: &'a Bound<'py, PyAny>,
    dt: &'a Bound<'py, PyAny>,
) -> [Option<Argument<'a, 'py>>; 3] {
    [
        Argument::new("motions", EIGHT, motions),
        Argument::new("twists", SIX, twists),
        Argument::new("dt", NUMBER, dt),
    ]
}
