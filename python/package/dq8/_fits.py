"""Motions from measurements, many problems at once."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import floats

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Rule = Literal["huber", "tukey"]
Fault = tuple[tuple[int, ...], str]


class Fit(NamedTuple):
    """The answers of `fit`, and how well the points determine them."""

    motions: NDArray[Any]
    """Unit dual quaternions, shape (..., 8); NaN where many rotations fit equally well, or a number is not finite."""
    scales: NDArray[Any]
    """Pure numbers, shape (...), with which points are multiplied before they are moved; 1 unless `scale` asked for them."""
    rms: NDArray[Any]
    """``√(Σ wᵢ|yᵢ − σ(xᵢ)|²/Σ wᵢ)``, shape (...): lengths. With a `robust` rule the wᵢ are those that it left."""
    ranks: NDArray[Any]
    """Shape (...): 3 of points in space, 2 in a plane, 1 on a line, 0 in a point."""
    conditions: NDArray[Any]
    """How many times more stiffly the points hold against the turn that they hold against most than against the one that they
    hold against least, shape (...)."""
    residuals: NDArray[Any]
    """``|yᵢ − σ(xᵢ)|`` of each pair, shape (..., n): lengths."""
    factors: NDArray[Any]
    """The factors, shape (..., n), by which the `robust` rule multiplied the weights; 1 without a rule. Outliers have small ones."""
    mirrored: NDArray[np.bool]
    """Whether the points are mirrored, shape (...): a reflection, which no motion is, would leave less than a hundredth."""
    faults: list[Fault]
    """The problems that have no answer to rely on: index, and why."""


class HandEye(NamedTuple):
    """The answers of `hand_eye`, and how well the motions determine them."""

    motions: NDArray[np.float64]
    """Unit dual quaternions X, shape (..., 8); NaN where the motions do not determine them, or a number is not finite."""
    angles: NDArray[np.float64]
    """The angle between ``A X`` and ``X B`` of each pair, shape (..., n): radians."""
    distances: NDArray[np.float64]
    """How far apart ``A X`` and ``X B`` are of each pair, shape (..., n): lengths."""
    ranks: NDArray[np.uint8]
    """How many of the 6 numbers of X the motions tell by more than their noise, shape (...)."""
    conditions: NDArray[np.float64]
    """The largest singular value of the equations over the sixth, shape (...); infinite where this one is noise."""
    factors: NDArray[np.float64]
    """The factors, shape (..., n), by which the `robust` rule multiplied the weights; 1 without a rule."""
    faults: list[Fault]
    """The problems that have no answer to rely on: index, and why."""


def _answers(name: str, motions: NDArray[Any], faults: list[Fault]) -> NDArray[Any]:
    """The motions alone: a single problem must have an answer, one of many has NaN in its row and is named in a warning."""
    said = [fault for fault in faults if fault[1] != NOT_FINITE]
    if said and motions.ndim == 1:
        raise ValueError(f"{said[0][1]}. `full=True` returns what there is all the same.")
    if said:
        motions = motions.copy()
        motions[tuple(np.transpose([index for index, _ in said]))] = np.nan
        rows = ", ".join(str(index) for index, _ in said[:8]) + (", …" if len(said) > 8 else "")
        problems = motions.size // 8
        warnings.warn(
            f"dq8.{name}: {len(said)} of {problems} problems have no answer, which is NaN: {rows}. The first: {said[0][1]}. "
            "`full=True` lists them with the reasons.",
            stacklevel=3,
        )
    return np.ascontiguousarray(motions)


NOT_FINITE = "A number is not finite"
TOO_LARGE = "Expected lengths whose squares can be summed, but the sums overflow: choose a larger unit"
NOT_TOGETHER = (
    "Expected `hands` and `eyes` to move together, but `A X` and `X B` are turned against each other by more than 0.1 radians in "
    "half of the pairs, whatever X is: pass how each moved from one place to another, such as "
    "`dq8.mul(dq8.inverse(poses[:-1]), poses[1:])`, not where it was"
)
PARALLEL = (
    "Expected two of the motions at least to turn about axes that are not parallel, by more than the noise: "
    "how far along its axes the eye sits is in none of them"
)
MIRRORED = (
    "Expected `moved` to be `points` moved, but they are mirrored: one of the two has left-handed coordinates, so turn the sign of "
    "one of its axes"
)


def _faults(*kinds: tuple[NDArray[np.bool], str | list[str]]) -> list[Fault]:
    """Those problems where a mask is set, in their order, with the first reason."""
    made: dict[tuple[int, ...], str] = {}
    for mask, reason in kinds:
        for at, index in enumerate(np.argwhere(mask)):
            made.setdefault(tuple(int(i) for i in index), reason if isinstance(reason, str) else reason[at])
    return sorted(made.items())


def _finite(*arrays: NDArray[Any]) -> NDArray[np.bool]:
    """Which problems have finite numbers alone."""
    masks = [np.isfinite(array).all(axis=(-2, -1)) for array in arrays]
    return np.asarray(np.logical_and.reduce(masks))


def _weights(weights: ArrayLike | None, count: int) -> NDArray[Any] | None:
    if weights is None:
        return None
    w = floats("weights", weights, (count,))
    if (w < 0).any():
        raise ValueError(f"Expected `weights` not to be negative, got {w.min()}.")
    if (w.sum(axis=-1) == 0).any():
        raise ValueError("Expected `weights` not to be all zero.")
    return w


def _rule(robust: str | None) -> str | None:
    if robust not in (None, "huber", "tukey"):
        raise ValueError(f"Expected `robust` to be 'huber', 'tukey' or None, got {robust!r}.")
    return robust


def _in_full(*arrays: tuple[NDArray[Any] | None, int]) -> list[NDArray[Any] | None]:
    """Arrays with so many dimensions of their own, whose leading ones are broadcast."""
    leading = np.broadcast_shapes(*(it.shape[: it.ndim - own] for it, own in arrays if it is not None))
    return [None if it is None else np.broadcast_to(it, (*leading, *it.shape[it.ndim - own :])) for it, own in arrays]


@overload
def fit(
    points: ArrayLike,
    moved: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    about: ArrayLike | None = None,
    scale: bool = False,
    robust: Rule | None = None,
    full: Literal[False] = False,
) -> NDArray[Any]: ...
@overload
def fit(
    points: ArrayLike,
    moved: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    about: ArrayLike | None = None,
    scale: bool = False,
    robust: Rule | None = None,
    full: Literal[True],
) -> Fit: ...
def fit(
    points: ArrayLike,
    moved: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    about: ArrayLike | None = None,
    scale: bool = False,
    robust: Rule | None = None,
    full: bool = False,
) -> NDArray[Any] | Fit:
    """The motions σ that bring points to points best: ``Σ wᵢ|σ(xᵢ) − yᵢ|²`` is least.

    Parameters
    ----------
    points, moved : array_like, shape (..., n, 3)
        Points xᵢ, and where they went, yᵢ: lengths. Leading dimensions broadcast.
    weights : array_like, shape (..., n) or (n,), optional
        Not negative; equal ones by default. A problem with a number that is not finite is answered with NaN.
    about : array_like, shape (3,), optional
        Of the rotations only those about this direction, such as ``[0, 0, 1]`` for the yaw.
    scale : bool, optional
        Points are multiplied by the best scale before they are moved, which only `full` gives.
    robust : {'huber', 'tukey'}, optional
        Pairs that fit badly count less. It fits again with the weights ``wᵢ·f(rᵢ/s)`` of the residuals rᵢ until they settle,
        at most 100 times, with s = (median of rᵢ)/1.538, the standard deviation of a coordinate. For 'huber' f(u) = min(1, k/u),
        k = 1.628; 'tukey' goes on from there, with that s, and f(u) = (1 − (u/c)²)² for u < c = 5.490, otherwise 0: outliers
        do not count at all. Both k and c lose 5 percent of what normal errors leave. Fewer than half of the pairs may be outliers.
    full : bool, optional
        Returns how well it fits and how well the points determine it, too. Without, a problem that many rotations fit
        equally well, as of points on one line, or whose points are mirrored, is a ValueError if it is the only one; of many
        it is answered with NaN, and a warning names it.

    Returns
    -------
    ndarray, shape (..., 8), or Fit
        Unit dual quaternions; float32 if all arrays are.

    References
    ----------
    S. Umeyama, "Least-squares estimation of transformation parameters between two point patterns", IEEE Trans. Pattern
    Analysis and Machine Intelligence 13 (1991). P. Holland, R. Welsch, "Robust regression using iteratively reweighted
    least-squares", Communications in Statistics 6 (1977).

    Examples
    --------
    >>> import dq8, numpy as np
    >>> points, motion = np.eye(3), dq8.random(rng=1)
    >>> dq8.allclose(dq8.fit(points, dq8.transform_points(motion, points)), motion)
    True
    >>> found = dq8.fit(points, 2.5 * points, scale=True, full=True)
    >>> float(found.scales.round(9)), int(found.ranks), bool(found.rms < 1e-15)
    (2.5, 2, True)
    """
    x, y = floats("points", points, (3,)), floats("moved", moved, (3,))
    if x.ndim < 2 or y.ndim < 2 or x.shape[-2] != y.shape[-2] or not x.shape[-2]:
        raise ValueError(f"Expected `points` and `moved` to have shapes (..., n, 3) with n > 0, got {x.shape} and {y.shape}.")
    w = _weights(weights, x.shape[-2])
    axis = None if about is None else [float(it) for it in floats("about", about, (3,))]
    if axis is not None and (scale or not np.isfinite(axis).all() or not any(axis)):
        raise ValueError(f"Expected `about` to be a direction, and no `scale` with it, got {axis}.")
    x, y, w = _in_full((x, 2), (y, 2), (w, 1))  # type: ignore[assignment]
    numbers = _core.fit_pairs(x, y, w, axis, scale, _rule(robust))
    motions, ranks, conditions = numbers[..., :8], numbers[..., 10], numbers[..., 11]
    mirrored = numbers[..., 12] != 0
    if mirrored.any() or not np.isfinite(conditions).all():
        ambiguous = [
            "Expected `points` and `moved` to determine how they turned, but many rotations fit equally well: their rank is "
            f"{int(rank)}"
            for rank in ranks[np.isinf(conditions)]
        ]
        unknown, known = np.isnan(conditions), _finite(x, y)
        faults = _faults(
            (np.isinf(conditions), ambiguous), (mirrored, MIRRORED), (unknown & known, TOO_LARGE), (unknown & ~known, NOT_FINITE)
        )
    else:
        faults = []
    if not full:
        return _answers("fit", motions, faults)
    there = _core.transform_points(motions[..., np.newaxis, :], numbers[..., 8, np.newaxis, np.newaxis] * x)
    factors = numbers[..., 13:] if robust else np.ones(there.shape[:-1], there.dtype)
    residuals = np.linalg.norm(there - y, axis=-1)
    return Fit(motions, numbers[..., 8], numbers[..., 9], ranks, conditions, residuals, factors, mirrored, faults)


@overload
def hand_eye(
    hands: ArrayLike,
    eyes: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    robust: Rule | None = None,
    full: Literal[False] = False,
) -> NDArray[np.float64]: ...
@overload
def hand_eye(
    hands: ArrayLike,
    eyes: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    robust: Rule | None = None,
    full: Literal[True],
) -> HandEye: ...
def hand_eye(
    hands: ArrayLike,
    eyes: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    robust: Rule | None = None,
    full: bool = False,
) -> NDArray[np.float64] | HandEye:
    """The X of ``A X = X B``: where a camera (eye) sits on a hand, from how both moved.

    Parameters
    ----------
    hands, eyes : array_like, shape (..., n, 8)
        Unit dual quaternions A, how the hand moved from one place to another in its first frame, and B, how the camera
        did; leading dimensions broadcast. At least two must turn, about axes that are not parallel, by more than
        their noise. A problem with a number that is not finite is answered with NaN. Lengths and angles weigh the same, so
        choose a unit in which their errors are about as large.
    weights : array_like, shape (..., n) or (n,), optional
        Not negative, of the squares of each pair; equal ones by default.
    robust : {'huber', 'tukey'}, optional
        Pairs that fit badly count less, as in `fit`, with ``r² = angle² + distance²`` between A X and X B, six components in
        the place of three: s = (median of rᵢ)/2.313, k = 1.869, c = 6.356.
    full : bool, optional
        Returns what is left of each pair and how well the motions determine X, too. Without, it is a ValueError if the axes of
        a single problem are parallel, or if A X and X B differ by more than 0.1 radians in half of its pairs, as absolute poses
        do; of many problems, such a one is answered with NaN, and a warning names it.

    Returns
    -------
    ndarray, shape (..., 8), or HandEye
        Unit dual quaternions, float64.

    References
    ----------
    K. Daniilidis, "Hand-eye calibration using dual quaternions", Int. J. Robotics Research 18 (1999).

    Examples
    --------
    >>> import dq8
    >>> eyes, x = dq8.random(3, rng=1), dq8.random(rng=2)
    >>> hands = dq8.mul(dq8.mul(x, eyes), dq8.inverse(x))
    >>> dq8.allclose(dq8.hand_eye(hands, eyes), x)
    True
    """
    a, b = floats("hands", hands, (8,)), floats("eyes", eyes, (8,))
    if a.ndim < 2 or b.ndim < 2 or a.shape[-2] != b.shape[-2] or not a.shape[-2]:
        raise ValueError(f"Expected `hands` and `eyes` to have shapes (..., n, 8) with n > 0, got {a.shape} and {b.shape}.")
    w = _weights(weights, a.shape[-2])
    a, b, w = _in_full((a, 2), (b, 2), (w, 1))  # type: ignore[assignment]
    numbers = _core.hand_eye_pairs(a, b, w, _rule(robust))
    motions, sizes, angles = numbers[..., :8], numbers[..., 8:16], numbers[..., 16]
    # The sixth is of axes that are not parallel, the seventh of noise: in a plane they are 1.3 to 1.6 times apart.
    noise = np.maximum(1e-6 * sizes[..., :1], 3 * sizes[..., 6:7])
    ranks = np.asarray((sizes[..., :6] > noise).sum(axis=-1), np.uint8)
    # Where no hand turns by more than rounding, there are no axes, and what looks like them is rounding as well.
    ranks[~(np.abs(a[..., :3]) > 1e-12).any(axis=(-2, -1))] = 0
    tells = ranks == 6
    # Finite motions that do not turn have no finite answer either, and are told apart from those that are not finite.
    known = _finite(a, b)
    good = known & tells & (angles <= 0.1)
    large = np.asarray(~np.isfinite(sizes).all(axis=-1))
    faults = [] if good.all() else _faults(
        (~known, NOT_FINITE), (large, TOO_LARGE), (angles > 0.1, NOT_TOGETHER), (known & ~tells, PARALLEL)
    )
    if not full:
        return _answers("hand_eye", motions, faults)
    motions = np.where((known & tells)[..., np.newaxis], motions, np.nan)
    own = motions[..., np.newaxis, :]
    by_hand, by_eye = _core.mul(a, own), _core.mul(own, b)
    with np.errstate(divide="ignore", invalid="ignore"):
        conditions = np.where(tells, sizes[..., 0] / sizes[..., 5], np.where(known, np.inf, np.nan))
    factors = numbers[..., 17:] if robust else np.ones(a.shape[:-1])
    angles, distances = (np.asarray(far(by_hand, by_eye)) for far in (_core.angle_to, _core.distance_to))
    return HandEye(motions, angles, distances, ranks, conditions, factors, faults)
