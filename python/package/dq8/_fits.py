"""Motions from measurements, many problems at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import floats

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Fit(NamedTuple):
    """What `fit` found of each problem, and how well the points tell it."""

    motions: NDArray[Any]
    """Unit dual quaternions, shape (..., 8); NaN where many rotations fit equally well, or a number is not finite."""
    scales: NDArray[Any]
    """Pure numbers, shape (...), with which points are multiplied before they are moved; 1 unless `scale` asked for them."""
    rms: NDArray[Any]
    """``√(Σ wᵢ|yᵢ − σ(xᵢ)|²/Σ wᵢ)``, shape (...): lengths."""
    ranks: NDArray[Any]
    """Shape (...): 3 of points in space, 2 in a plane, 1 on a line, 0 in a point."""
    conditions: NDArray[Any]
    """How many times more stiffly the points hold against the turn that they hold against most than against the one that they
    hold against least, shape (...)."""


@overload
def fit(
    points: ArrayLike,
    moved: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    about: ArrayLike | None = None,
    scale: bool = False,
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
    full: Literal[True],
) -> Fit: ...
def fit(
    points: ArrayLike,
    moved: ArrayLike,
    weights: ArrayLike | None = None,
    *,
    about: ArrayLike | None = None,
    scale: bool = False,
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
    full : bool, optional
        How well it fits and how well the points tell it, too. Without, it is a ValueError where many rotations fit equally
        well, as of points on one line; with it, NaN.

    Returns
    -------
    ndarray, shape (..., 8), or Fit
        Unit dual quaternions; float32 if all arrays are.

    References
    ----------
    S. Umeyama, "Least-squares estimation of transformation parameters between two point patterns", IEEE Trans. Pattern
    Analysis and Machine Intelligence 13 (1991).

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
    w = np.ones(x.shape[-2], np.result_type(x, y)) if weights is None else floats("weights", weights, x.shape[-2:-1])
    if (w < 0).any():
        raise ValueError(f"Expected `weights` not to be negative, got {w.min()}.")
    if (w.sum(axis=-1) == 0).any():
        raise ValueError("Expected `weights` not to be all zero.")
    axis = None if about is None else [float(it) for it in floats("about", about, (3,))]
    if axis is not None and (scale or not np.isfinite(axis).all() or not any(axis)):
        raise ValueError(f"Expected `about` to be a direction, and no `scale` with it, got {axis}.")
    leading = np.broadcast_shapes(x.shape[:-2], y.shape[:-2], w.shape[:-1])
    x, y = (np.broadcast_to(it, (*leading, *it.shape[-2:])) for it in (x, y))
    w = np.broadcast_to(w, (*leading, w.shape[-1]))
    numbers = _core.fit_pairs(x, y, w, axis, scale)
    found = Fit(numbers[..., :8], numbers[..., 8], numbers[..., 9], numbers[..., 10], numbers[..., 11])
    if full:
        return found
    if np.isinf(found.conditions).any():
        index = tuple(int(i) for i in np.argwhere(np.isinf(found.conditions))[0])
        where = f" in problem {index}" if index else ""
        raise ValueError(
            f"Expected `points` and `moved` to say how they turned{where}, but many rotations fit equally well: their rank is "
            f"{int(found.ranks[index])}."
        )
    return np.ascontiguousarray(found.motions)


def hand_eye(hands: ArrayLike, eyes: ArrayLike) -> NDArray[Any]:
    """The X of ``A X = X B``: where a camera (eye) sits on a hand, from how both moved.

    Parameters
    ----------
    hands, eyes : array_like, shape (..., n, 8)
        Unit dual quaternions A, how the hand moved from one place to another in its first frame, and B, how the camera
        did; leading dimensions broadcast. At least two must turn, about axes that are not parallel, by more than
        their noise; otherwise ValueError. A problem with a number that is not finite is answered with NaN. Lengths and
        angles weigh the same, so choose a unit in which their errors are about as large.

    Returns
    -------
    ndarray, shape (..., 8)
        Unit dual quaternions.

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
    a, b = (_canonical(name, value) for name, value in (("hands", hands), ("eyes", eyes)))
    if a.ndim < 2 or b.ndim < 2 or a.shape[-2] != b.shape[-2]:
        raise ValueError(f"Expected `hands` and `eyes` to have shapes (..., n, 8), got {a.shape} and {b.shape}.")
    a, b = np.broadcast_arrays(a, b)
    real, dual = _commutator(a[..., :3], b[..., :3]), _commutator(a[..., 4:7], b[..., 4:7])
    equations = np.concatenate(
        [np.concatenate([real, np.zeros_like(real)], axis=-1), np.concatenate([dual, real], axis=-1)], axis=-2
    )
    equations = equations.reshape(*equations.shape[:-3], -1, 8)
    # Rows of zeros, so that there are eight vectors with few motions as well.
    equations = np.concatenate([equations, np.zeros((*equations.shape[:-2], 8, 8))], axis=-2)
    known = np.isfinite(equations).all(axis=(-1, -2))
    sizes, vt = np.linalg.svd(np.where(known[..., np.newaxis, np.newaxis], equations, 0), full_matrices=False)[1:]
    # The sixth is of axes that are not parallel, the seventh of noise: in a plane they are 1.3 to 1.6 times apart.
    tells = (sizes[..., 5] > 1e-6 * sizes[..., 0]) & (sizes[..., 5] > 3 * sizes[..., 6])
    if not (tells | ~known).all():
        index = tuple(int(i) for i in np.argwhere(known & ~tells)[0])
        where = f" in problem {index}" if index else ""
        raise ValueError(
            f"Expected two of the motions at least to turn about axes that are not parallel{where}, by more than the noise: "
            "how far along its axes the eye sits is in none of them."
        )
    # X is that sum of the two vectors that is unit: λ²u₁·v₁ + λ(u₁·v₂ + u₂·v₁) + u₂·v₂ = 0 has two solutions, the other
    # one without a real part.
    (u1, v1), (u2, v2) = ((vt[..., row, :4], vt[..., row, 4:]) for row in (6, 7))
    first, mixed, last = ((u * v).sum(axis=-1) for u, v in ((u1, v1), (u1, v2), (u2, v2)))
    mixed = mixed + (u2 * v1).sum(axis=-1)
    half = -0.5 * (mixed + np.copysign(np.sqrt(np.maximum(mixed**2 - 4 * first * last, 0)), mixed))
    sums = [x[..., np.newaxis] * vt[..., 6, :] + y[..., np.newaxis] * vt[..., 7, :] for x, y in ((half, first), (last, half))]
    sums = [made / np.maximum(np.linalg.norm(made, axis=-1, keepdims=True), 1e-300) for made in sums]
    larger = np.linalg.norm(sums[0][..., :4], axis=-1) > np.linalg.norm(sums[1][..., :4], axis=-1)
    return _core.normalize(np.where(known[..., np.newaxis], np.where(larger[..., np.newaxis], *sums), np.nan))


def _canonical(name: str, value: ArrayLike) -> NDArray[Any]:
    """With p_w ≥ 0: A and B turn by the same angle, and their scalars agree."""
    motions = floats(name, value, (8,)).astype(np.float64, copy=False)
    return np.where(motions[..., 3:4] < 0, -motions, motions)


def _commutator(a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
    """The matrices of the vector parts of ``a x − x b``, linear in x = [x, y, z, w]: ``(a + b) × x + (a − b)w``."""
    x, y, z = np.moveaxis(a + b, -1, 0)
    zero = np.zeros_like(x)
    cross = np.stack([np.stack(row, axis=-1) for row in ([zero, -z, y], [z, zero, -x], [-y, x, zero])], axis=-2)
    return np.concatenate([cross, (a - b)[..., np.newaxis]], axis=-1)
