"""The functions of dq8 on Dask's arrays: lazy, a task for each chunk of leading dimensions.

``dq8.dask.mul(a, b)`` is ``dq8.mul`` of arrays of which at least one is a ``dask.array.Array``, and so are all functions
that compute each result from one element of each argument. `poses`, `jacobian`, `velocity`, `reach`, `solutions` and `skin`
take the robot or the mesh as well, `deskew` and `skew` the trajectory; `dlb`, `mean` and `fit` go along a dimension that is in
one chunk. Names of links and options are tried when the graph is made. Nothing is computed to learn shapes and dtypes: a result is float32 where all arrays are, otherwise
float64. Dimensions of one element become one chunk each; leading ones broadcast and keep their chunks. Data frames of Dask are
taken by the names of their columns; ``dask.dataframe.from_dask_array(result, columns=..., index=frame.index)`` is a frame of the
same rows again, whatever identifies them.

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
import operator
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from . import __all__ as _public
from . import _comparisons, _core, _fits, _motion_archives, _names, _rotations, _trajectories
from ._core import Mechanism
from ._extras import needed
from ._signatures import CHECKED, SIGNATURES, Shape
from ._solutions import Solutions

# It has no types.
da: Any = needed("dask.array", "dask")


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
        return self.compute(*map(_alone, arrays), *self.after, **self.options)


def _alone(chunk: Any) -> Any:
    """The chunk of an argument, which comes in a list for each dimension of its elements."""
    while isinstance(chunk, list):
        (chunk,) = chunk
    return chunk


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
        # One chunk of whole elements is passed on as it is, where Dask would copy it to concatenate it.
        array = array.rechunk(dict.fromkeys(range(own, array.ndim), -1))
        given += [array, (*range(leading - own, leading), *itertools.islice(number, len(core)))]
    made = {next(number): size for size in result}
    dtype = _dtype([*arrays, *also] if by is None else by)
    return da.blockwise(
        task,
        (*range(leading), *made),
        *given,
        new_axes=made,
        concatenate=False,
        token=f"dq8-{task.__name__}",
        dtype=dtype,
        meta=np.empty((0,) * (leading + len(result)), dtype),
    )


def _array(value: Any) -> Any:
    """An array of Dask; of a data frame, with its columns in the order of arrays where their names tell it."""
    if hasattr(value, "to_dask_array"):
        return _columns(value, _names.order(list(getattr(value, "columns", []))))
    return da.asanyarray(value)


def _columns(frame: Any, found: list[int] | None) -> Any:
    """An array of the columns at these places. They are chosen in the data frame, so that files are read in that order."""
    if found is not None and found != list(range(len(frame.columns))):
        frame = frame[[frame.columns[place] for place in found]]
    return frame.to_dask_array()


def _values(mechanism: Mechanism, values: Any, name: str = "values", order: list[str] | None = None) -> Any:
    """Configurations, or rates, of a data frame in the order of the mechanism."""
    if not hasattr(values, "to_dask_array"):
        return values
    return _columns(values, _names.places(name, list(values.columns), mechanism.values if order is None else order))


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

# What people write rotations as, and what is written in Python: shapes of an argument and of the result.
_PLAIN: dict[str, tuple[Callable[..., Any], Shape, Shape]] = {
    "from_rotation": (_rotations.from_rotation, (4,), (8,)),
    "from_rotation_vector": (_rotations.from_rotation_vector, (3,), (8,)),
    "from_wxyz": (_rotations.from_wxyz, (8,), (8,)),
    "is_unit": (_comparisons.is_unit, (8,), ()),
    "rotation": (_rotations.rotation, (8,), (4,)),
    "to_rotation_vector": (_rotations.to_rotation_vector, (8,), (3,)),
    "to_wxyz": (_rotations.to_wxyz, (8,), (8,)),
}


def _plain(name: str) -> Callable[..., Any]:
    compute, own, result = _PLAIN[name]

    def function(argument: Any, **options: Any) -> Any:
        made = _lazy(_Task(name, compute, **options), [argument], [own], result)
        return made.astype(bool) if name == "is_unit" else made

    function.__name__ = function.__qualname__ = name
    function.__doc__ = f"Lazy `dq8.{name}`. {compute.__doc__}"
    return function


globals().update({name: _plain(name) for name in _PLAIN})
__all__ += [*_PLAIN, "deskew", "dlb", "fit", "from_euler", "from_matrix", "jacobian", "mean", "poses", "reach", "skew", "skin"]
__all__ += ["archive", "solutions", "to_euler", "velocity"]


def from_matrix(matrices: Any, *, check: bool = True) -> Any:
    """Lazy `dq8.from_matrix`: motions ``r + ½εtr``, shape (..., 8), of matrices (..., 4, 4) or (..., 3, 4)."""
    matrices = _array(matrices)
    rows = (3, 4) if matrices.shape[-2:] == (3, 4) else (4, 4)
    return _lazy(_Task("from_matrix", _core.from_matrix, check=check), [matrices], [rows], (8,))


def _angles(angles: Any, order: str) -> Any:
    return _rotations.from_euler(order, angles)


def from_euler(order: str, angles: Any) -> Any:
    """Lazy `dq8.from_euler`: rotations, shape (..., 8), of angles (..., 3) in radians."""
    _rotations.from_euler(order, np.zeros(3))
    return _lazy(_Task("from_euler", _angles, order), [angles], [(3,)], (8,))


def to_euler(motions: Any, order: str) -> Any:
    """Lazy `dq8.to_euler`: angles, shape (..., 3), in radians."""
    _rotations.from_euler(order, np.zeros(3))
    return _lazy(_Task("to_euler", _rotations.to_euler, order), [motions], [(8,)], (3,))


def _along(compute: Callable[..., Any], motions: Any, weights: Any, axis: int, options: dict[str, Any]) -> Any:
    """A blend of each row: `axis` comes last, where all of its elements are in one chunk."""
    motions, name = _array(motions), compute.__name__
    leading = motions.ndim - 1
    place = operator.index(axis) + (motions.ndim if axis < 0 else 0)
    if not 0 <= place < leading:
        raise ValueError(f"{name}: expected `axis` to be one of the {leading} dimensions before the last one, got {axis}.")
    if len(motions.chunks[place]) > 1:
        raise ValueError(
            f"{name}: expected dimension {axis} to be in one chunk, got {len(motions.chunks[place])}: "
            f"pass `motions.rechunk({{{place}: -1}})`, or compute it with the arrays in memory."
        )
    count = motions.shape[place]
    task, last = _Task(name, compute, **options), da.moveaxis(motions, place, -2)
    if weights is None:
        return _lazy(task, [last], [(count, 8)], (8,))
    if getattr(weights, "ndim", None) != 1 and np.ndim(weights) != 1:
        weights = da.moveaxis(da.asanyarray(weights), place, -1)
    return _lazy(task, [last, weights], [(count, 8), (count,)], (8,))


def dlb(motions: Any, weights: Any = None, *, axis: int = -2) -> Any:
    """Lazy `dq8.dlb`, ``normalize(Σ ±wᵢσᵢ)``, along a dimension that is in one chunk."""
    return _along(_core.dlb, motions, weights, axis, {})


def mean(motions: Any, weights: Any = None, *, axis: int = -2, **options: Any) -> Any:
    """Lazy `dq8.mean`, the b with ``Σ wᵢ log(b*σᵢ) = 0``, along a dimension that is in one chunk."""
    return _along(_core.mean, motions, weights, axis, options)


def fit(points: Any, moved: Any, weights: Any = None, **options: Any) -> Any:
    """Lazy `dq8.fit`: motions, shape (..., 8), of problems (..., n, 3), the pairs of each of which are put together.

    Problems without an answer are NaN, and a warning of the worker names them by their places in the chunk; a single problem,
    without leading dimensions, is an error. There is no `full`.
    """
    if options.get("full"):
        raise ValueError("fit: expected no `full`, whose answers are several arrays: pass chunks to `dq8.fit` by `map_blocks`.")
    points, moved = _array(points), _array(moved)
    if min(points.ndim, moved.ndim) < 2 or points.shape[-2] != moved.shape[-2]:
        raise ValueError(f"fit: expected shapes (..., n, 3), got {points.shape} and {moved.shape}.")
    count = points.shape[-2]
    arguments: list[Any] = [points, moved]
    cores: list[Shape] = [(count, 3), (count, 3)]
    if weights is not None:
        arguments, cores = [*arguments, weights], [*cores, (count,)]
    three = np.eye(3)
    _fits.fit(three, three, **options)
    return _lazy(_Task("fit", _fits.fit, **options), arguments, cores, (8,))


def _one(mechanism: Mechanism) -> Any:
    """A configuration, with which what is wrong is found when the graph is made, not by the workers."""
    return mechanism.sample(rng=0)


def poses(mechanism: Mechanism, values: Any, links: Any = None) -> Any:
    """Lazy `Mechanism.poses`: ``pose(j) = pose(parent(j)) · placement(j) · motion(j)`` of values (..., values)."""
    result = mechanism.poses(_one(mechanism), links).shape
    return _lazy(_Task("poses", mechanism.poses, links), [_values(mechanism, values)], [(len(mechanism.values),)], result)


def jacobian(mechanism: Mechanism, values: Any, link: str | int, frame: str = "aligned") -> Any:
    """Lazy `Mechanism.jacobian`: ``twist = J · rates``, shape (..., 6, rates)."""
    task = _Task("jacobian", mechanism.jacobian, link, frame)
    result = task(_one(mechanism)).shape
    return _lazy(task, [_values(mechanism, values)], [(len(mechanism.values),)], result)


def velocity(mechanism: Mechanism, values: Any, rates: Any, link: str | int, frame: str = "aligned") -> Any:
    """Lazy `Mechanism.velocity`: the twists ``J · rates``, shape (..., 6)."""
    task, count = _Task("velocity", mechanism.velocity, link, frame), len(mechanism.rates)
    task(_one(mechanism), np.zeros(count))
    arguments = [_values(mechanism, values), _values(mechanism, rates, "rates", mechanism.rates)]
    return _lazy(task, arguments, [(len(mechanism.values),), (count,)], (6,))


def _packed(mechanism: Mechanism, targets: Any, values: Any, link: str | int) -> Any:
    """What `solutions` found, in one array: a row for each place, and one for counts and completeness."""
    found = mechanism.solutions(targets, values, link)
    kind = found.values.dtype
    rows = np.concatenate([found.values, found.distances[..., np.newaxis], found.singular.astype(kind)], axis=-1)
    last = np.zeros((*rows.shape[:-2], 1, rows.shape[-1]), kind)
    last[..., 0, 0], last[..., 0, 1] = found.counts, found.complete
    return np.concatenate([rows, last], axis=-2)


def solutions(mechanism: Mechanism, targets: Any, values: Any, link: str | int = -1) -> Solutions:
    """Lazy `Mechanism.solutions`: all of its arrays, ``poses(found.values, link) = target``."""
    one, count = _one(mechanism), len(mechanism.values)
    mechanism.solutions(mechanism.poses(one, link), one, link)
    task = _Task("solutions", functools.partial(_packed, mechanism), link)
    packed = _lazy(task, [targets, _values(mechanism, values)], [(8,), (count,)], (9, count + 4))
    places, last = packed[..., :8, :], packed[..., 8, :]
    return Solutions(
        places[..., :count], last[..., 0].astype(np.uint8), places[..., count], places[..., count + 1 :] != 0, last[..., 1] != 0
    )


def _values_and_converged(mechanism: Mechanism, targets: Any, values: Any, link: str | int, **options: Any) -> Any:
    found, report = mechanism.reach(targets, values, link, **options)
    return np.concatenate([found, np.asarray(report.converged, found.dtype)[..., np.newaxis]], axis=-1)


def reach(mechanism: Mechanism, targets: Any, values: Any, link: str | int, **options: Any) -> tuple[Any, Any]:
    """Lazy `Mechanism.reach` of one link: the values, shape (..., values), and whether they converged, shape (...)."""
    compute, one = functools.partial(_values_and_converged, mechanism), _one(mechanism)
    compute(mechanism.poses(one, link), one, link, **options)
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


def archive(files: Any, robot: Any, out: Any, *, partitions: int | None = None, **options: Any) -> Any:
    """Lazy `dq8.retarget.archive`: a ``dask.bag.Bag`` of its rows, a task for each clip or for as many as make so many `partitions`.

    Each task writes the file of its motion into `out`, a folder that all workers have. Nothing is kept of calls before, and the
    table of measures is the caller's: ``pandas.DataFrame(archive(...).compute()).to_parquet("measures.parquet")``.
    """
    paths: list[Any]
    keywords = {"format": "npz", "model": None, "table": None, "joints": None, "bodies": None}
    job, paths = _motion_archives.job_of(files, robot, out, **{**keywords, **options})
    bag: Any = needed("dask.bag", "dask")
    return bag.from_sequence(paths, npartitions=partitions, partition_size=None if partitions else 1).map(job)
