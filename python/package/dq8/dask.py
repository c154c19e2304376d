"""The functions of dq8 on Dask's arrays: lazy, a task for each chunk of leading dimensions.

``dq8.dask.mul(a, b)`` is ``dq8.mul`` of arrays of which at least one is a ``dask.array.Array``, and so are all functions
that compute each result from one element of each argument. `poses`, `jacobian`, `reach` and `skin` take the robot or the
mesh as well, `deskew` and `skew` the trajectory. Nothing is computed to learn shapes and dtypes: a result is float32 where all arrays are, otherwise
float64. Dimensions of one element become one chunk each; leading ones broadcast and keep their chunks. Data frames of Dask are
taken by the names of their columns.

    >>> import dask.array as da
    >>> import dq8.dask
    >>> a = da.from_array(dq8.random(1000, rng=1), chunks=(250, 8))
    >>> b = dq8.dask.mul(a, dq8.dask.inverse(a))
    >>> b.numblocks, dq8.allclose(b.compute(), dq8.identity())
    ((4, 1), True)
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Sequence
from typing import Any

import dask.array
import numpy as np

from . import __all__ as _public
from . import _core, _names, _trajectories
from ._core import Mechanism
from ._signatures import CHECKED, SIGNATURES, Shape

# It has no types.
da: Any = dask.array


def _dtype(arguments: Sequence[Any]) -> np.dtype[Any]:
    """That of the result, as the functions decide it."""
    given = [np.dtype(argument.dtype) for argument in arguments if hasattr(argument, "dtype")]
    lists = any(not hasattr(argument, "dtype") and not isinstance(argument, (int, float)) for argument in arguments)
    single = bool(given) and not lists and all(dtype.kind == "f" and dtype.itemsize <= 4 for dtype in given)
    return np.dtype(np.float32 if single else np.float64)


class _Task:
    """A call that Dask hands from process to process, with the name that people find among its tasks."""

    def __init__(self, name: str, compute: Callable[..., Any], *after: Any, **options: Any) -> None:
        self.__name__, self.compute, self.after, self.options = name, compute, after, options

    def __call__(self, *arrays: Any) -> Any:
        return self.compute(*arrays, *self.after, **self.options)


def _lazy(
    task: _Task,
    arguments: Sequence[Any],
    cores: Sequence[Shape],
    result: Shape,
    also: Sequence[Any] = (),
    by: Sequence[Any] | None = None,
) -> Any:
    """A task for each chunk of leading dimensions, which are numbered from the first; then come those of elements.

    The dtype is decided by the arguments and what is there `also`, or `by` others.
    """
    arrays: list[Any] = [it if isinstance(it, (int, float)) else _array(it) for it in arguments]
    leading = max((it.ndim - len(core) for it, core in zip(arrays, cores) if hasattr(it, "ndim")), default=0)
    number, given = itertools.count(leading), []
    for array, core in zip(arrays, cores):
        if not hasattr(array, "ndim"):
            given += [array, None]
            continue
        own = array.ndim - len(core)
        if own < 0 or array.shape[own:] != core:
            raise ValueError(f"{task.__name__}: expected shape (..., {', '.join(map(str, core))}), got {array.shape}.")
        given += [array, (*range(leading - own, leading), *itertools.islice(number, len(core)))]
    made = {next(number): size for size in result}
    dtype = _dtype([*arrays, *also] if by is None else by)
    return da.blockwise(
        task,
        (*range(leading), *made),
        *given,
        new_axes=made,
        concatenate=True,
        token=f"dq8-{task.__name__}",
        dtype=dtype,
        meta=np.empty((0,) * (leading + len(result)), dtype),
    )


def _array(value: Any) -> Any:
    """An array of Dask; of a data frame, with its columns in the order of arrays where their names tell it."""
    if hasattr(value, "to_dask_array"):
        found = _names.order(list(getattr(value, "columns", [])))
        return value.to_dask_array() if found is None else value.to_dask_array()[:, found]
    return da.asanyarray(value)


def _values(mechanism: Mechanism, values: Any) -> Any:
    """Configurations, of a data frame in the order of the mechanism."""
    if not hasattr(values, "to_dask_array"):
        return values
    found = _names.places("values", list(values.columns), mechanism.values)
    array = values.to_dask_array()
    return array if found is None or found == sorted(found) else array[:, found]


def _function(name: str) -> Callable[..., Any]:
    compute, (parameters, result) = getattr(_core, name), SIGNATURES[name]

    def function(*positional: Any, **keywords: Any) -> Any:
        options = {"check": keywords.pop("check")} if name in CHECKED and "check" in keywords else {}
        arguments = {**dict(zip(parameters, positional)), **keywords}
        if set(arguments) != set(parameters) or len(arguments) < len(positional) + len(keywords):
            raise TypeError(f"Expected {name}({', '.join(parameters)}).")
        return _lazy(_Task(name, compute, **options), [arguments[it] for it in parameters], list(parameters.values()), result)

    function.__name__ = function.__qualname__ = name
    function.__doc__ = f"Lazy `dq8.{name}`. " + compute.__doc__.split("out : ndarray", 1)[0]
    return function


__all__ = [name for name in SIGNATURES if name in _public]
globals().update({name: _function(name) for name in __all__})
__all__ += ["deskew", "jacobian", "poses", "reach", "skew", "skin"]


def poses(mechanism: Mechanism, values: Any, links: Any = None) -> Any:
    """Lazy `Mechanism.poses`: ``pose(j) = pose(parent(j)) · placement(j) · motion(j)`` of values (..., values)."""
    one = isinstance(links, (str, int))
    result = (8,) if one else (len(mechanism if links is None else links), 8)
    return _lazy(_Task("poses", mechanism.poses, links), [_values(mechanism, values)], [(len(mechanism.values),)], result)


def jacobian(mechanism: Mechanism, values: Any, link: str | int, frame: str = "aligned") -> Any:
    """Lazy `Mechanism.jacobian`: ``twist = J · rates``, shape (..., 6, rates)."""
    task = _Task("jacobian", mechanism.jacobian, link, frame)
    return _lazy(task, [_values(mechanism, values)], [(len(mechanism.values),)], (6, len(mechanism.rates)))


def _values_and_converged(mechanism: Mechanism, targets: Any, values: Any, link: str | int, **options: Any) -> Any:
    found, report = mechanism.reach(targets, values, link, **options)
    return np.concatenate([found, np.asarray(report.converged, found.dtype)[..., np.newaxis]], axis=-1)


def reach(mechanism: Mechanism, targets: Any, values: Any, link: str | int, **options: Any) -> tuple[Any, Any]:
    """Lazy `Mechanism.reach` of one link: the values, shape (..., values), and whether they converged, shape (...)."""
    compute = functools.partial(_values_and_converged, mechanism)
    count = len(mechanism.values)
    both = _lazy(_Task("reach", compute, link, **options), [targets, _values(mechanism, values)], [(8,), (count,)], (count + 1,))
    return both[..., :-1], both[..., -1] != 0


def _moved(compute: Callable[..., Any], points: Any, times: Any, stamps: Any, poses: Any, options: dict[str, Any]) -> Any:
    points = da.asanyarray(points)
    task = _Task(compute.__name__, compute, np.asarray(stamps), np.asarray(poses), **options)
    record = points.shape[-1:]
    return _lazy(task, [points, times], [record, ()], record, by=[points])


def deskew(points: Any, times: Any, stamps: Any, poses: Any, **options: Any) -> Any:
    """Lazy `dq8.deskew` of points (..., c), each moved by the pose at its own time; stamps and poses are arrays of NumPy."""
    return _moved(_trajectories.deskew, points, times, stamps, poses, options)


def skew(points: Any, times: Any, stamps: Any, poses: Any, **options: Any) -> Any:
    """Lazy `dq8.skew`, the inverse of `deskew`."""
    return _moved(_trajectories.skew, points, times, stamps, poses, options)


def _skin(palette: Any, points: Any, joints: Any, weights: Any, **options: Any) -> Any:
    return _core.skin(points, joints, weights, palette, **options)


def skin(points: Any, joints: Any, weights: Any, palette: Any, **options: Any) -> Any:
    """Lazy `dq8.skin` of one mesh in poses of Dask, palettes (..., joints, 8): points, shape (..., vertices, 3)."""
    mesh = [np.asarray(part) for part in (points, joints, weights)]
    count = da.asanyarray(palette).shape[-2]
    task = _Task("skin", _skin, *mesh, **options)
    return _lazy(task, [palette], [(count, 8)], (len(mesh[0]), 3), also=[points, weights])
