"""Robots that follow clips of targets."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from . import _core
from ._goals import Goal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def track(
    self: _core.Mechanism,
    targets: ArrayLike,
    values: Any,
    links: str | int | Goal | Sequence[str | int | Goal],
    *,
    weights: ArrayLike | None = None,
    posture: Any = None,
    angular_tolerance: float = 1e-4,
    linear_tolerance: float = 1e-4,
    max_iterations: int = 3,
    length_per_radian: float | None = None,
    max_step: float = 1.5,
    damping: float = 0.1,
    least_gain: float = 0.01,
    posture_weight: float = 0.0,
    start_weight: float = 0.0,
    floating_weight: float = 0.0,
    steady: bool = False,
    out: NDArray[Any] | None = None,
) -> tuple[NDArray[Any], _core.ReachReport]:
    """Follows a clip of targets: the values of each frame begin from those of the frame before it.

    A few steps δ for each frame, which make ``|Jδ − e|² + λ²|δ|²`` least of the errors e and the Jacobian J, plus the
    weights below. Where more is asked than the joints can do, the weighted errors are small together; `reach` suits a target
    that stands alone. Many clips of one length, in leading dimensions, are computed on SIMD lanes, and by all threads; clips of
    several lengths by `sequence`. A frame whose target is not unit, or not finite, keeps the values of the frame before it, and
    its outcome is ``Outcome.INVALID``.

    Parameters
    ----------
    targets : array_like, shape (..., frames, 8), or (..., frames, links, 8) for a sequence of links
        Unit dual quaternions in the frame of the base, in the order of time. Or positions alone, 3 in place of 8.
    values : array_like, shape (..., values), or columns by name
        The configuration from which the first frame of each clip begins. Leading dimensions broadcast.
    links : str, int, Goal, or sequence of these
        Which links. A `Goal` also says which point of its link is meant, and has weights of its own.
    weights : array_like, shape (6,), or (links, 6) for a sequence of links, optional
        As of `reach`: rotation, then position, in the axes of the target; zero leaves one free.
    posture : array_like, shape (values,), or numbers by name, optional
        A configuration to be near to.
    angular_tolerance, linear_tolerance : float
        The errors that may be left: radians, and the robot's unit of length.
    max_iterations : int
        The most steps of a frame.
    length_per_radian : float, optional
        The length that weighs as much as a radian; by default an eighth of the robot's reach.
    max_step : float
        The most that a joint turns in one step, radians, more than 0.
    damping : float
        λ at the target, radians.
    least_gain : float
        The part of the squared error, from 0 to 1, by which a step must reduce it; a frame ends with one that gains less.
    posture_weight : float
        The weight of a radian from the posture against one from a target, in each step. Zero: the posture has the freedom that
        the targets leave.
    start_weight : float
        The weight of a radian from the frame before it, against shaking; joints lag by ``start_weight**2`` frames.
    floating_weight : float
        The same of floating joints, of a radian and of `length_per_radian`.
    steady : bool
        Whether a frame keeps the values from which it begins where no step gains `least_gain`: a target beyond reach that
        stands still is then answered by values that stand still.
    out : ndarray, optional
        Where to write the values.

    Returns
    -------
    values : ndarray, shape (..., frames, values)
        float32 if `targets` and `values` are, otherwise float64.
    report : ReachReport
        What was reached: arrays of shape (..., frames).

    Examples
    --------
    >>> import dq8, numpy as np
    >>> meter = dq8.from_translation([1.0, 0.0, 0.0])
    >>> arm = dq8.Mechanism([-1, 0, 1], "revolute", [0, 0, 1], meter)
    >>> line = np.linspace([2.5, 0.5, 0], [2, 1.5, 0], 100)
    >>> values, report = arm.track(line, [0.1, 0.2, 0.3], dq8.Goal.position(2))
    >>> values.shape, bool(report.linear_error.max() < 0.01)
    ((100, 3), True)
    """
    return _core.track(
        self, None, targets, values, links, weights, posture, angular_tolerance, linear_tolerance, max_iterations,
        length_per_radian, max_step, damping, least_gain, posture_weight, start_weight, floating_weight, steady, out,
    )  # fmt: skip


def sequence(
    self: _core.Mechanism,
    clips: ArrayLike,
    targets: ArrayLike,
    values: Any,
    links: str | int | Goal | Sequence[str | int | Goal],
    *,
    weights: ArrayLike | None = None,
    posture: Any = None,
    angular_tolerance: float = 1e-4,
    linear_tolerance: float = 1e-4,
    max_iterations: int = 3,
    length_per_radian: float | None = None,
    max_step: float = 1.5,
    damping: float = 0.1,
    least_gain: float = 0.01,
    posture_weight: float = 0.0,
    start_weight: float = 0.0,
    floating_weight: float = 0.0,
    steady: bool = False,
    out: NDArray[Any] | None = None,
) -> tuple[NDArray[Any], _core.ReachReport]:
    """Follows clips of any lengths as `track` follows one: on SIMD lanes, a clip in each, and by all threads.

    Steps are those of `track`, which make ``|Jδ − e|² + λ²|δ|²`` least. What a clip gets does not depend on the others.

    Parameters
    ----------
    clips : array_like of whole numbers, shape (clips,)
        How many frames each clip has.
    targets : array_like, shape (frames, 8), or (frames, links, 8) for a sequence of links
        The targets of the frames of all clips, one clip after the other, as of `track`. Or positions alone, 3 in place of 8.
    values : array_like, shape (clips, values) or (values,), or columns by name
        The configurations, radians and lengths, from which the first frames begin.
    links : str, int, Goal, or sequence of these
        Which links.
    weights, posture, angular_tolerance, linear_tolerance, max_iterations, length_per_radian : optional
        As of `track`.
    max_step, damping, least_gain, posture_weight, start_weight, floating_weight, steady : optional
        As of `track`.
    out : ndarray, optional
        Where to write the values.

    Returns
    -------
    values : ndarray, shape (frames, values)
        float32 if `targets` and `values` are, otherwise float64.
    report : ReachReport
        What was reached: arrays of shape (frames,).

    Examples
    --------
    >>> import dq8, numpy as np
    >>> meter = dq8.from_translation([1.0, 0.0, 0.0])
    >>> arm = dq8.Mechanism([-1, 0, 1], "revolute", [0, 0, 1], meter)
    >>> line = np.linspace([2.5, 0.5, 0], [2, 1.5, 0], 100)
    >>> both = np.concatenate([line, line[:30]])
    >>> values, report = arm.sequence([100, 30], both, [0.1, 0.2, 0.3], dq8.Goal.position(2))
    >>> bool((values[:30] == values[100:]).all())
    True
    """
    return _core.track(
        self, clips, targets, values, links, weights, posture, angular_tolerance, linear_tolerance, max_iterations,
        length_per_radian, max_step, damping, least_gain, posture_weight, start_weight, floating_weight, steady, out,
    )  # fmt: skip
