"""People whose motion robots copy: from files, from body models and from places of joints."""

from __future__ import annotations

import functools
import json
import os
import threading
import warnings
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ._core import Person

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

Table = str | os.PathLike[str] | Mapping[str, Mapping[str, Any]]
"""Roles by names, under ``links`` and ``joints``: a mapping, the path of a file of TOML, a str that ends on ``.toml``, or its text."""

BODY = ("v_template", "shapedirs", "J_regressor")
"""The arrays of a body model."""

def toml(table: Table | None) -> str | None:
    """The text of a table."""
    if table is None or isinstance(table, str):
        return Path(table).read_text(encoding="utf-8") if table and table.endswith(".toml") else table
    if not isinstance(table, Mapping):
        return Path(table).read_text(encoding="utf-8")

    def written(value: Any) -> str:
        if isinstance(value, Mapping):
            return "{ " + ", ".join(f"{json.dumps(name)} = {written(one)}" for name, one in value.items()) + " }"
        if not isinstance(value, str):
            raise TypeError(f"Expected `table` to hold names, got {value!r}.")
        return json.dumps(value, ensure_ascii=False)

    sections = []
    for section, entries in table.items():
        if not isinstance(entries, Mapping):
            raise TypeError(f"Expected `table` to have mappings of roles, got {entries!r} for {section!r}.")
        sections += [f"[{json.dumps(section)}]", *(f"{json.dumps(role)} = {written(value)}" for role, value in entries.items())]
    return "\n".join(sections)


def load(source: Any, model: Any = None, *, table: Table | None = None) -> Person:
    """The motion of a person, of a BVH file or of arrays of AMASS and SMPL-X.

    Parameters
    ----------
    source : str, os.PathLike or mapping
        A file that ends on ``.bvh``; or one of AMASS that ends on ``.npz``, or its arrays: ``trans`` and ``poses``, or
        ``root_orient`` and ``pose_body``; ``betas`` and ``mocap_frame_rate``.
    model : mapping, str or os.PathLike, optional
        The body model of such arrays: ``v_template``, ``shapedirs`` and ``J_regressor``, or the ``.npz`` that has them. None
        comes with dq8, because their licences forbid it.
    table : mapping, str or os.PathLike, optional
        Roles that names do not tell, ``{"joints": {"left_foot": "LAnkle"}}``, or the same as TOML.

    Returns
    -------
    Person
    """
    person = opened(source, model, toml(table))
    if person._warning:
        warnings.warn(f"{os.fspath(source)}: {person._warning}", stacklevel=2)
    return person


def opened(source: Any, model: Any, table: str | None) -> Person:
    """What `load` returns, which may have a warning of its own."""
    if not isinstance(source, Mapping) and Path(source).suffix.lower() != ".npz":
        path = Path(source)
        with _named(path):
            return Person._from_bvh(path.stem, path.read_bytes(), table)
    if model is None:
        raise ValueError("Expected `model`, the arrays of the body that the poses of AMASS and SMPL-X belong to.")
    title = "arrays" if isinstance(source, Mapping) else Path(source).stem
    arrays = source if isinstance(source, Mapping) else _read(Path(source))
    with _named(source):
        rate = next((arrays[name] for name in ("mocap_frame_rate", "mocap_framerate", "fps") if name in arrays), None)
        if rate is None:
            raise ValueError("there is no 'mocap_frame_rate' among the arrays")
        if "poses" in arrays:
            turns = np.asarray(arrays["poses"])
        else:
            turns = np.concatenate([array_of(arrays, "root_orient"), array_of(arrays, "pose_body")], axis=-1)
        betas = arrays["betas"] if "betas" in arrays else np.zeros(0)
        return body_model(model, turns, array_of(arrays, "trans"), float(np.asarray(rate).item()), betas=betas, table=table, title=title)


def body_model(
    model: Any,
    turns: ArrayLike,
    places: ArrayLike,
    fps: float,
    *,
    betas: ArrayLike = (),
    table: Table | None = None,
    title: str = "arrays",
) -> Person:
    """A person of the turns of SMPL's joints: joints = regressor · (template + shapes · betas), without torch.

    Parameters
    ----------
    model : mapping, str or os.PathLike
        The body: ``v_template``, ``shapedirs`` and ``J_regressor``, or the ``.npz`` that has them.
    turns : array_like, shape (frames, joints, 3) or (frames, 3 * joints)
        Rotation vectors of SMPL, SMPL-H or SMPL-X, the root first; 22 joints of each frame are read.
    places : array_like, shape (frames, 3)
        The ways of the root, metres.
    fps : float
        Frames per second.
    betas : array_like, shape (shapes,)
        The numbers of the shape; those that are missing are zero.
    table, title
        As of `load` and `Person.title`.
    """
    arrays = model if isinstance(model, Mapping) else _body(model)
    vertices, shapes, regressor = (array_of(arrays, name) for name in BODY)
    count = len(vertices) if vertices.ndim else 0
    _shaped("v_template", vertices, (count, 3))
    _shaped("shapedirs", shapes, (count, 3, None))
    _shaped("J_regressor", regressor, (None, count))
    given = np.ravel(np.asarray(betas))
    # No more of the shapes than is asked for: all of them are a hundred megabytes.
    shapes = np.ascontiguousarray(shapes[..., : max(1, len(given))])
    turned, places = np.asarray(turns), np.asarray(places)
    if turned.ndim == 2 and turned.shape[1] % 3 == 0:
        turned = turned.reshape(len(turned), turned.shape[1] // 3, 3)
    _shaped("places", places, (None, 3))
    _shaped("turns", turned, (len(places), None, 3))
    return Person._from_body_model(title, vertices, shapes, regressor, given, turned, places, fps, toml(table))


def positions(
    names: Sequence[str], parents: Sequence[int], array: ArrayLike, fps: float, *, table: Table | None = None, title: str = "positions"
) -> Person:
    """A person of the places of joints alone, metres in any axes; turns are those that bring bones to where they are.

    Parameters
    ----------
    names : sequence of str
        The names of the joints.
    parents : sequence of int
        The joint that carries each joint and stands before it, −1 for the root.
    array : array_like, shape (frames, joints, 3)
        The places.
    fps : float
        Frames per second.
    table, title
        As of `load` and `Person.title`.

    Examples
    --------
    >>> import numpy as np
    >>> from dq8 import retarget as rt
    >>> rt.positions(["pelvis", "spine", "head"], [-1, 0, 1], np.zeros((4, 3, 3)), 30)
    <dq8.retarget.Person "positions": 3 joints, 4 frames, 30 fps>
    """
    return Person._from_positions(title, list(names), parents, array, fps, toml(table))


class _named:  # noqa: N801
    """Puts the name of a file before what is said about its contents."""

    def __init__(self, source: Any) -> None:
        self.source = source

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: BaseException | None, trace: Any) -> None:
        if isinstance(self.source, Mapping):
            return
        if isinstance(error, (ValueError, zipfile.BadZipFile, EOFError)):
            raise ValueError(f"{os.fspath(self.source)}: {error}") from None


_CLIP = {"poses", "root_orient", "pose_body", "trans", "betas", "mocap_frame_rate", "mocap_framerate", "fps"}


def _read(path: Path) -> Mapping[str, Any]:
    """The arrays of a file that are known here."""
    with _named(path):
        try:
            file = np.load(path)
        except ValueError:
            raise ValueError("not an .npz file") from None
        if not isinstance(file, np.lib.npyio.NpzFile):
            raise ValueError("not an .npz file, but one array")
        with file:
            return {name: file[name] for name in file if name in _CLIP or name in BODY}


def _body(model: str | os.PathLike[str]) -> Mapping[str, Any]:
    """The arrays of a file that has not changed: many clips, of many threads, have one body model."""
    stamp = os.stat(model)
    with _reading:
        return _read_body(Path(model), stamp.st_mtime_ns, stamp.st_size)


_reading = threading.Lock()


@functools.lru_cache(maxsize=1)
def _read_body(path: Path, *stamp: int) -> Mapping[str, Any]:
    return _read(path)


def _shaped(name: str, array: NDArray[Any], shape: tuple[int | None, ...]) -> None:
    """Refuses an array of another shape; None stands for any length."""
    if array.ndim != len(shape) or any(want not in (None, have) for want, have in zip(shape, array.shape)):
        wanted = ", ".join("n" if want is None else str(want) for want in shape)
        raise ValueError(f"Expected `{name}` to have shape ({wanted}), got {array.shape}.")


def array_of(arrays: Mapping[str, Any], name: str) -> NDArray[Any]:
    if name not in arrays:
        raise ValueError(f"there is no {name!r} among the arrays: {', '.join(map(str, arrays)) or 'none that is known'}")
    array = arrays[name]
    # Regressors of SMPL are sparse in some files.
    dense: NDArray[Any] = np.asarray(array.toarray() if hasattr(array, "toarray") else array)
    return dense
