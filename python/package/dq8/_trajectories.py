"""Clouds of points moved by the poses at their own times, and trajectories compared."""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from . import _core

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    Frame: TypeAlias = Literal["world", "start", "end"] | float | ArrayLike
    Outside: TypeAlias = Literal["hold", "continue", "refuse"]


def deskew(
    points: ArrayLike,
    times: ArrayLike,
    stamps: ArrayLike,
    poses: ArrayLike,
    *,
    frame: Frame = "world",
    clock: tuple[float, float] = (0.0, 1.0),
    outside: Outside = "hold",
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """Points that a moving body measured, each at its own time, in one frame F: ``F⁻¹σ(t)p``.

    The body is at ``poses[k]`` at ``stamps[k]``, and on one screw from each to the next. It is
    ``Trajectory(stamps, poses).deskew(points, times, …)``, which is for many clouds of one trajectory.

    Parameters
    ----------
    points : array_like, shape (..., c)
        Lengths, and c − 3 ≥ 0 numbers more, which are copied.
    times : array_like, shape (...)
        When each point was measured, in any order; rising times are quickest. Dimensions broadcast, so ``times[column]``
        serves all rows of a scan ``points[row, column]``.
    stamps : array_like, shape (n,)
        Seconds, finite and rising.
    poses : array_like, shape (n, 8)
        Unit dual quaternions that carry the body into the world.
    frame : str, float or array_like, shape (8,), optional
        The frame F: ``'world'``, the body at the first stamp (``'start'``), at the last one (``'end'``) or at a time in
        seconds, or a pose in the world.
    clock : tuple of float, optional
        ``(origin, unit)``: the time t is the stamp ``origin + unit·t``, so ``(start, 1e-9)`` for nanoseconds since `start`.
    outside : str, optional
        What is before the first stamp and after the last one: the body stands (``'hold'``), goes on as it moved there
        (``'continue'``), or such a time is a ValueError (``'refuse'``).
    out : ndarray, optional
        Where to write the result; it may be `points`.

    Returns
    -------
    ndarray, shape (..., c)
        float32 if `points` are float32 or float16, otherwise float64.

    Examples
    --------
    A scanner goes two metres ahead and sees one wall, each time nearer:

    >>> import dq8, numpy as np
    >>> poses = dq8.from_translation([[0.0, 0, 0], [2, 0, 0]])
    >>> scan = np.array([[10.0, 0, 0], [9, 0, 0], [8, 0, 0]])
    >>> dq8.deskew(scan, [0.0, 0.05, 0.1], [0.0, 0.1], poses, frame="end")[:, 0]
    array([8., 8., 8.])
    """
    path = _core.Trajectory(stamps, poses)
    return path.deskew(points, times, clock=clock, frame=frame, outside=outside, out=out)


def skew(
    points: ArrayLike,
    times: ArrayLike,
    stamps: ArrayLike,
    poses: ArrayLike,
    *,
    frame: Frame = "world",
    clock: tuple[float, float] = (0.0, 1.0),
    outside: Outside = "hold",
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """The inverse of `deskew`: points of one frame F as the moving body would have measured them, ``σ(t)⁻¹Fp``.

    Parameters and result are those of `deskew`.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> poses = dq8.random(2, rng=1)
    >>> points, times = np.eye(3), [0.0, 0.3, 1.0]
    >>> moved = dq8.deskew(points, times, [0, 1], poses)
    >>> np.allclose(dq8.skew(moved, times, [0, 1], poses), points)
    True
    """
    path = _core.Trajectory(stamps, poses)
    return path.skew(points, times, clock=clock, frame=frame, outside=outside, out=out)


class Statistics(NamedTuple):
    """The figures of errors e₁ … eₙ, under the names of evo."""

    rmse: float
    """``√(Σeᵢ²/n)``"""
    mean: float
    median: float
    std: float
    """``√(Σ(eᵢ − mean)²/n)``"""
    min: float
    max: float
    sse: float
    """``Σeᵢ²``"""


class Comparison(NamedTuple):
    """What `compare` found."""

    translation: Statistics
    """The figures of the translations: lengths."""
    rotation: Statistics
    """The figures of the rotations: radians."""
    stamps: NDArray[np.float64]
    """The stamps of the reference in seconds, shape (n,); of motions, where they end."""
    translations: NDArray[np.float64]
    """The errors themselves, shape (n,): lengths."""
    rotations: NDArray[np.float64]
    """Angles from 0 to π, shape (n,)."""
    alignment: NDArray[np.float64]
    """The motion by which the estimate was laid over the reference, shape (8,), after the scale."""
    scale: float
    """1 but for ``align='similarity'``."""


def compare(
    reference: _core.Trajectory | str | PathLike[str],
    estimate: _core.Trajectory | str | PathLike[str],
    *,
    align: Literal["origin", "yaw", "rigid", "similarity"] | None = None,
    tolerance: float = 0.01,
    interpolated: bool = False,
    frames: int | None = None,
    metres: float | None = None,
    seconds: float | None = None,
) -> Comparison:
    """The errors of an estimate: of its poses (APE, ATE), ``|t − u|`` and the angle of ``p*q``; or of motions (RPE).

    Definitions and figures are those of the package evo (1.38), but that stamps rise here.

    Parameters
    ----------
    reference, estimate : Trajectory, or the path of a file
        Files as `Trajectory.from_file` reads them.
    align : str, optional
        How the estimate is laid over the reference first: not at all; the first pose onto the first one (``'origin'``); with
        least squares of the positions by a shift and a turn about z (``'yaw'``), any rotation (``'rigid'``), or with a scale
        too (``'similarity'``).
    tolerance : float, optional
        Seconds by which stamps of a pair may differ.
    interpolated : bool, optional
        Pairs are poses of the reference and the estimate at their stamps, along screws; there is no tolerance then.
    frames, metres, seconds : int or float, optional
        One of them, for the errors of motions: steps of so many pairs, or so long on the estimate, or of so much time, each
        from where the last one ended.

    Returns
    -------
    Comparison
        Figures of translations (lengths) and rotations (radians), and the errors themselves.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> stamps, turns = np.arange(5.0), dq8.from_twist(np.outer(np.arange(5), [0, 0, 0.2, 1, 0, 0.1]))
    >>> reference = dq8.Trajectory(stamps, turns)
    >>> estimate = dq8.Trajectory(stamps + 0.003, dq8.mul(dq8.random(rng=1), turns))
    >>> found = dq8.compare(reference, estimate, align="rigid")
    >>> len(found.stamps), bool(found.translation.rmse < 1e-12), bool(found.rotation.max < 1e-12)
    (5, True, True)
    >>> bool(dq8.compare(reference, estimate, frames=1).translation.max < 1e-12)
    True
    """
    known, guess = (it if isinstance(it, _core.Trajectory) else _core.Trajectory.from_file(it) for it in (reference, estimate))
    arrays, figures, alignment, scale = _core.compare(known, guess, align, tolerance, interpolated, frames, metres, seconds)
    translation, rotation = (Statistics(*of) for of in figures)
    stamps, translations, rotations = arrays
    return Comparison(translation, rotation, stamps, translations, rotations, alignment, scale)


def _spline(control: NDArray[np.float64], every: float, start: float, basis: Literal["smooth", "through"]) -> _core.Spline:
    """How a spline is pickled."""
    return _core.Spline(control, every, start, basis=basis)
