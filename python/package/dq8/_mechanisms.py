"""What a `Mechanism` does that needs no kernel of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from . import _core
from ._arrays import floats
from ._solutions import solutions

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def sample(self: _core.Mechanism, shape: int | tuple[int, ...] = (), *, rng: Any = None) -> NDArray[np.float64]:
    """Random configurations, shape (*shape, values), float64: each value alike within its limits.

    Without limits angles are drawn from half a turn either way, lengths from −1 to 1, rotations of floating joints from
    all. `rng` is a generator of NumPy, or a seed for one.

    Examples
    --------
    >>> import dq8
    >>> arm = dq8.Mechanism([-1], "prismatic", [0, 0, 1], dq8.identity(), limits=[0.2, 0.3])
    >>> bool((abs(arm.sample(100, rng=1) - 0.25) <= 0.05).all())
    True
    """
    rng = np.random.default_rng(rng)
    leading = (shape,) if isinstance(shape, int) else tuple(shape)
    spans = np.array(self._spans).reshape(-1, 2)
    rotations = np.isnan(spans[:, 0])
    values: NDArray[np.float64] = rng.uniform(*np.where(rotations[:, np.newaxis], 0, spans).T, size=(*leading, len(spans)))
    drawn = rng.normal(size=(*leading, int(rotations.sum()) // 4, 4))
    values[..., rotations] = (drawn / np.linalg.norm(drawn, axis=-1, keepdims=True)).reshape(*leading, -1)
    return values


def velocity(
    self: _core.Mechanism,
    values: Any,
    rates: ArrayLike,
    link: str | int,
    frame: Literal["world", "body", "aligned"] = "world",
) -> NDArray[Any]:
    """How a link moves: the twist ``J · rates``, shape (..., 6), angular first, in a frame as of `jacobian`.

    `values` are configurations (..., values), or columns by name; `rates`, shape (..., rates), are radians and lengths
    per unit of time. Leading dimensions broadcast.

    Examples
    --------
    >>> import dq8
    >>> wheel = dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.identity())
    >>> wheel.velocity([0.3], [2.0], 0)
    array([0., 0., 2., 0., 0., 0.])
    """
    moved: NDArray[Any] = self.jacobian(values, link, frame) @ _core.real_array("rates", rates)[..., np.newaxis]
    return moved[..., 0]


def rates_for(
    self: _core.Mechanism,
    values: Any,
    twists: ArrayLike,
    link: str | int,
    frame: Literal["world", "body", "aligned"] = "world",
    *,
    damping: float = 0.0,
) -> NDArray[Any]:
    """The rates, shape (..., rates), that move a link best as twists say: ``|J · rates − twist|² + λ²|rates|²`` is least.

    The other way of `velocity`. `damping` λ keeps rates small near singular configurations; without it those that
    move nothing are zero, and rotations weigh as much as lengths.

    Examples
    --------
    >>> import dq8
    >>> wheel = dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.identity())
    >>> wheel.rates_for([0.3], [0.0, 0, 2, 0, 0, 0], 0).round(12)
    array([2.])
    """
    jacobian, wanted = self.jacobian(values, link, frame), floats("twists", twists, (6,))[..., np.newaxis]
    if damping:
        square = jacobian @ np.swapaxes(jacobian, -1, -2) + damping**2 * np.eye(6, dtype=jacobian.dtype)
        rates: NDArray[Any] = np.swapaxes(jacobian, -1, -2) @ np.linalg.solve(square, wanted)
    else:
        rates = np.linalg.pinv(jacobian) @ wanted
    return rates[..., 0]


def __eq__(self: _core.Mechanism, other: object) -> bool:
    """Whether both are made of the same arrays, or of the same text."""
    return isinstance(other, _core.Mechanism) and self.__reduce__() == other.__reduce__()


def __hash__(self: _core.Mechanism) -> int:
    return hash(tuple(self.links))


for _method in (sample, velocity, rates_for, solutions, __eq__, __hash__):
    setattr(_core.Mechanism, _method.__name__, _method)
