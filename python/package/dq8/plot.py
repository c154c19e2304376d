"""Pictures of motions, on axes of matplotlib with ``projection="3d"``: frames, skeletons and robots, screws.

Each function draws on `axes`, in the unit of the caller, and returns it. `fitted` at the end shows all that was drawn, with
one scale for all directions.

    >>> import dq8, dq8.plot
    >>> import matplotlib.figure
    >>> axes = matplotlib.figure.Figure().add_subplot(projection="3d")
    >>> len(dq8.plot.fitted(dq8.plot.frames(axes, dq8.identity(4))).lines)
    12
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import floats
from ._core import Hierarchy, Mechanism

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_COLORS = ("tab:red", "tab:green", "tab:blue")
"""Of the x, y and z axes."""


def frames(axes: Any, motions: ArrayLike, *, length: float = 0.1, every: int = 1, path: bool = False) -> Any:
    """The axes ``R eᵢ`` of frames at ``t``, motions (..., 8): x red, y green, z blue, each `length` long.

    Of motions that follow each other `every` says which are drawn, and `path` joins their origins.
    """
    matrices = _core.to_matrix(floats("motions", motions, (8,)).reshape(-1, 8))
    origins = matrices[:, :3, 3]
    if path:
        axes.plot(*origins.T, color="0.5", linewidth=1)
    for matrix in matrices[::every]:
        for axis, color in enumerate(_COLORS):
            axes.plot(*np.stack([matrix[:3, 3], matrix[:3, 3] + length * matrix[:3, axis]], axis=-1), color=color)
    return axes


def skeleton(axes: Any, tree: Hierarchy | Mechanism, poses: ArrayLike, **style: Any) -> Any:
    """The bones of a skeleton or robot in one pose: a line from each joint to its parent, poses (joints, 8) in model space.

    `style` is what matplotlib's `plot` takes.
    """
    places = _core.translation(poses)
    if places.shape != (len(tree), 3):
        raise ValueError(f"Expected `poses` to have shape ({len(tree)}, 8), got {(*places.shape[:-1], 8)}.")
    style = {"color": "0.2", "marker": "o", "markersize": 3, **style}
    for joint, parent in enumerate(tree.parents):
        ends = places[[joint, joint if parent < 0 else parent]]
        axes.plot(*ends.T, **style)
    return axes


def screw(axes: Any, motion: ArrayLike, *, length: float = 1.0, start: ArrayLike | None = None) -> Any:
    """The axis l + εm that a motion turns about and slides along, ``θ̂ = θ + εd``, as an arrow with its pitch ``d/θ`` written.

    `length` of it is drawn about the point ``l × m`` that is nearest to the origin. From a point `start` the helix on which
    it moves is drawn as well.
    """
    screw = _core.to_screw(floats("motion", motion, (8,)))
    if screw.shape != (8,):
        raise ValueError(f"Expected `motion` to have shape (8,), got {screw.shape}.")
    direction, moment, (angle, slide) = screw[:3], screw[3:6], screw[6:]
    foot: NDArray[Any] = np.cross(direction, moment)
    low = foot - length / 2 * direction
    axes.quiver(*low, *(length * direction), color="tab:purple", arrow_length_ratio=0.1)
    pitch = f"pitch {slide / angle:.3g} per radian" if angle else "a translation"
    axes.text(*low, pitch, color="tab:purple", verticalalignment="top")
    if start is not None:
        t = np.linspace(0, 1, 50)
        axes.plot(*_core.transform_points(_core.pow(motion, t), start).T, color="tab:orange")
    return axes


def fitted(axes: Any) -> Any:
    """`axes` with all that is drawn in it, and one scale for x, y and z: otherwise frames look skew."""
    bounds = np.array([axes.get_xlim3d(), axes.get_ylim3d(), axes.get_zlim3d()])
    middle, half = bounds.mean(axis=1), np.ptp(bounds, axis=1).max() / 2
    for set_limits, place in zip((axes.set_xlim3d, axes.set_ylim3d, axes.set_zlim3d), middle):
        set_limits(place - half, place + half)
    axes.set_box_aspect((1, 1, 1))
    axes.set(xlabel="x", ylabel="y", zlabel="z")
    return axes
