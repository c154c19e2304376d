"""What a search asks of one link."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

ONES, ZEROS = (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Goal:
    """A link, the point of it that should be at its target, and how much each component of the error weighs.

    In place of a link in `Mechanism.reach`, `track` and `sequence`. A weight is zero, which leaves its component free, or from
    1e-6 to 1e6; weights decide where not all errors can vanish.

    Parameters
    ----------
    link : str or int
        Which link, by name or number.
    angular : sequence of float, length 3
        Weights of the rotation about x, y and z of the target.
    linear : sequence of float, length 3
        Weights of the distances along x, y and z of the target.
    point : sequence of float, length 3
        What should be at the target's origin, in the frame of the link, a length: a fingertip, a heel. Zero is the link's own
        origin.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> meter = dq8.from_translation([1.0, 0.0, 0.0])
    >>> arm = dq8.Mechanism([-1, 0, 1], "revolute", [0, 0, 1], meter)
    >>> tip = dq8.Goal.position(2).at([0.5, 0.0, 0.0])
    >>> values, report = arm.reach([2.0, 1.0, 0.0], [0.1, 0.2, 0.3], tip)
    >>> bool(report.converged), dq8.transform_points(arm.poses(values, 2), [0.5, 0, 0]).round(4) + 0.0
    (True, array([2., 1., 0.]))
    """

    link: str | int
    angular: Sequence[float] = ONES
    linear: Sequence[float] = ONES
    point: Sequence[float] = ZEROS

    def __post_init__(self) -> None:
        for name in ("angular", "linear", "point"):
            numbers = np.asarray(getattr(self, name), np.float64)
            if numbers.shape != (3,):
                raise ValueError(f"Expected `{name}` to be three numbers, got shape {numbers.shape}.")
            object.__setattr__(self, name, tuple(numbers.tolist()))

    @classmethod
    def pose(cls, link: str | int) -> Goal:
        """A goal for the rotation and the position of a link."""
        return cls(link)

    @classmethod
    def position(cls, link: str | int) -> Goal:
        """A goal for the position of a link, whose rotation is free."""
        return cls(link, angular=ZEROS)

    @classmethod
    def orientation(cls, link: str | int) -> Goal:
        """A goal for the rotation of a link, whose position is free."""
        return cls(link, linear=ZEROS)

    def at(self, point: Sequence[float]) -> Goal:
        """This goal for a point of the link, in the frame of the link."""
        return replace(self, point=point)

    def weighing(self, rotation: float, position: float) -> Goal:
        """This goal with one weight for the whole rotation, and one for the whole position."""
        return replace(self, angular=(rotation,) * 3, linear=(position,) * 3)

    def with_angular(self, angular: Sequence[float]) -> Goal:
        """This goal with other weights of the rotation."""
        return replace(self, angular=angular)

    def with_linear(self, linear: Sequence[float]) -> Goal:
        """This goal with other weights of the position."""
        return replace(self, linear=linear)
