"""What a `Mechanism` does that needs no kernel of its own."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from . import _core
from ._extras import needed
from ._solutions import solutions
from ._tracking import sequence, track

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Frame = Literal["world", "body", "aligned"]


def sample(self: _core.Mechanism, shape: int | tuple[int, ...] = (), *, rng: Any = None) -> NDArray[np.float64]:
    """Random configurations, shape ``(*shape, values)``, float64: each value alike within its limits.

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
    rates: Any,
    link: str | int,
    frame: Frame = "aligned",
    *,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """How a link moves: the twist ``J · rates``, shape (..., 6), angular first, in a frame as of `jacobian`.

    Parameters
    ----------
    values : array_like, shape (..., values), or columns by name
        Configurations: radians and lengths.
    rates : array_like, shape (..., rates), or columns by name
        Radians and lengths per unit of time, in the order of `Mechanism.rates`. Leading dimensions broadcast.
    link : str or int
        Which link.
    frame : {'aligned', 'body', 'world'}
        As of `jacobian`.
    out : ndarray, optional
        Where to write the result.

    Returns
    -------
    ndarray, shape (..., 6)
        float32 if all arrays are float32 or float16, otherwise float64.

    Examples
    --------
    >>> import dq8
    >>> wheel = dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.identity())
    >>> wheel.velocity([0.3], [2.0], 0)
    array([0., 0., 2., 0., 0., 0.])
    """
    return _core.velocity(self, values, rates, link, frame, out)


def rates_for(
    self: _core.Mechanism,
    values: Any,
    twists: ArrayLike,
    link: str | int,
    frame: Frame = "aligned",
    *,
    damping: float = 0.0,
    out: NDArray[Any] | None = None,
) -> NDArray[Any]:
    """The rates that move a link best as twists say: ``|J · rates − twist|² + λ²|rates|²`` is least.

    The other way of `velocity`. Without damping, rates that move nothing are zero. Rotations weigh as much as lengths.

    Parameters
    ----------
    values : array_like, shape (..., values), or columns by name
        Configurations: radians and lengths.
    twists : array_like, shape (..., 6)
        ``[ωx, ωy, ωz, vx, vy, vz]`` per unit of time. Leading dimensions broadcast.
    link : str or int
        Which link.
    frame : {'aligned', 'body', 'world'}
        That of the twists, as of `jacobian`.
    damping : float
        λ, which keeps rates small near singular configurations.
    out : ndarray, optional
        Where to write the result.

    Returns
    -------
    ndarray, shape (..., rates)
        float32 if all arrays are float32 or float16, otherwise float64.

    Examples
    --------
    >>> import dq8
    >>> wheel = dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.identity())
    >>> wheel.rates_for([0.3], [0.0, 0, 2, 0, 0, 0], 0).round(12)
    array([2.])
    """
    return _core.rates_for(self, values, twists, link, frame, damping, out)


def manipulability(
    self: _core.Mechanism, values: Any, link: str | int, *, out: NDArray[Any] | None = None
) -> NDArray[Any] | np.float32 | np.float64:
    """How far a link is from singular: ``w = √det(J Jᵀ)`` of its Jacobian, the volume of the twists of all rates of length one.

    The same in all frames. Zero where the link cannot turn or move in some direction, and with fewer than six rates.

    Parameters
    ----------
    values : array_like, shape (..., values), or columns by name
        Configurations: radians and lengths.
    link : str or int
        Which link.
    out : ndarray, optional
        Where to write the result.

    Returns
    -------
    ndarray, shape (...)
        float32 if all arrays are float32 or float16, otherwise float64. Lengths cubed, where six joints turn.

    References
    ----------
    T. Yoshikawa, "Manipulability of robotic mechanisms", Int. J. Robotics Research 4 (1985), eq. 9.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> axes = np.eye(3)[[0, 1, 2, 2, 1, 2]]
    >>> wrist = dq8.Mechanism(range(-1, 5), ["prismatic"] * 3 + ["revolute"] * 3, axes, dq8.identity())
    >>> wrist.manipulability([[0, 0, 0, 0, np.pi / 2, 0], [0, 0, 0, 0, 0, 0]], 5).round(12)
    array([1., 0.])
    """
    return _core.manipulability(self, values, link, out)


def plot(self: _core.Mechanism, values: Any, axes: Any = None) -> Any:
    """Draws the robot in one configuration (values,), a line from each link to its parent, and returns the axes of matplotlib.

    Without `axes` a figure of pyplot is made, which a notebook shows. ``dq8.plot`` has more: frames, screws, other styles.

    Examples
    --------
    >>> import dq8, matplotlib.figure
    >>> arm = dq8.Mechanism([-1, 0], "revolute", [0, 0, 1], dq8.from_translation([1.0, 0, 0]))
    >>> len(arm.plot([0.3, 0.5], matplotlib.figure.Figure().add_subplot(projection="3d")).lines)
    2
    """
    if axes is None:
        axes = needed("matplotlib.pyplot", "plot").figure().add_subplot(projection="3d")
    pictures = importlib.import_module("dq8.plot")
    return pictures.fitted(pictures.skeleton(axes, self, self.poses(values)))


def __eq__(self: _core.Mechanism, other: object) -> bool:
    """Whether both are made of the same arrays, or of the same text."""
    return isinstance(other, _core.Mechanism) and self.__reduce__() == other.__reduce__()


def __hash__(self: _core.Mechanism) -> int:
    return hash(tuple(self.links))


for _method in (sample, velocity, rates_for, manipulability, solutions, track, sequence, plot, __eq__, __hash__):
    setattr(_core.Mechanism, _method.__name__, _method)
