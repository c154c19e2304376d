"""All solutions of arms of six hinges."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core


class Solutions(NamedTuple):
    """What `Mechanism.solutions` found: for each target places for eight solutions, the nearest to the start first.

    Places that are left over hold NaN, and False. ``found.values[np.arange(8) < found.counts[..., np.newaxis]]`` are all there are.
    """

    values: NDArray[Any]
    """Configurations, shape (..., 8, values): the start, with the values of the six hinges."""
    counts: NDArray[np.uint8] | np.uint8
    """How many there are, shape (...); uint8."""
    distances: NDArray[Any]
    """How far from the start each is, shape (..., 8): the root of the sum of squares, radians."""
    singular: NDArray[np.bool]
    """At which joints each is singular, shape (..., 8, 3): the first, the second with the third, the fifth. It is two that meet,
    or one of infinitely many."""
    complete: NDArray[np.bool] | np.bool
    """Whether there are no others, shape (...). False where they were searched for."""


def solutions(self: _core.Mechanism, targets: ArrayLike, values: Any, link: str | int = -1) -> Solutions:
    """All ways in which an arm of six hinges brings a link to targets: of up to eight all, ``poses(found.values, link) = target``.

    By formula where the last three axes meet in a point, and the second and third are parallel or the first two meet (PUMA,
    and most of what welds, paints and lifts), or where the second, third and fourth are parallel and the last two meet (UR, and
    others that work beside people): one to four microseconds each, on SIMD lanes. Other arms search from 64 starts, half a
    millisecond, and find some 99 of 100; those that are nearly of a family, as where 1.5708 was typed for a quarter turn, in a
    tenth of that. Within the limits; of turns more or less those nearest to the start. With threads,
    large calls are computed by all of them.

    Parameters
    ----------
    targets : array_like, shape (..., 8)
        Unit dual quaternions: the poses that the link should have, in the frame of the base.
    values : array_like, shape (..., values), or columns by name
        Configurations to start from, which order the solutions. Leading dimensions broadcast with those of `targets`.
    link : str or int
        Which link: one that six hinges and no other joints carry.

    Returns
    -------
    Solutions
        Arrays: `values`, shape (..., 8, values), float32 if `targets` and `values` are, otherwise float64; `counts`,
        `distances`, `singular`, `complete`.

    Raises
    ------
    ValueError
        If it is no such arm, or a target is farther than 10⁻³ from unit. One that is not finite, or begins at what is not,
        has no solutions.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> offsets = [[0, 0, 0.1], [0, 0.1, 0], [0.4, 0, 0], [0.4, 0, 0], [0, 0.1, 0], [0, 0, -0.1]]
    >>> axes = np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 0, -1], [0, 1, 0]])
    >>> arm = dq8.Mechanism(range(-1, 5), "revolute", axes, dq8.from_translation(offsets))
    >>> start = [0.4, -1.2, 1.5, -0.8, 1.1, 0.2]
    >>> found = arm.solutions(arm.poses(start, 5), start)
    >>> int(found.counts), bool(found.complete), found.values[0].round(9).tolist() == start
    (8, True, True)
    """
    return Solutions(*_core.solutions(self, targets, values, link))
