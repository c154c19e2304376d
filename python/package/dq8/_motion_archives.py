"""Many clips on a robot: a file of the motion of each, and a table of measures."""

from __future__ import annotations

import contextlib
import dataclasses
import glob
import hashlib
import json
import math
import os
import threading
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from pathlib import Path
from typing import Any

import numpy as np

from . import _core
from ._extras import needed
from ._motion_files import SUFFIXES, chosen, save, whole
from ._motions import UNITS, Humanoid, retargeted, settings
from ._people import BODY, Table, array_of, opened, toml
from ._progress import tell

Row = dict[str, Any]
"""What an archive says of a clip."""


def archive(
    files: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    robot: Any,
    out: str | os.PathLike[str],
    *,
    workers: int | None = None,
    format: str = "npz",
    progress: Callable[[float], object] | None = None,
    model: Any = None,
    table: Table | None = None,
    joints: Sequence[str] | None = None,
    bodies: Sequence[str] | None = None,
    **options: Any,
) -> Any:
    """Brings many clips on a robot: a file of the motion of each in `out`, and ``measures.parquet`` with a row for each.

    A call that was ended, or killed, goes on where it was: clips whose files and keywords are the same are not computed again.
    A file of a motion is whole or not there. Clips that fail are named by a warning, and have their error in their rows; the
    next call tries them again, and has no file of their motion. The parts of `files` that differ, folders and names without
    suffixes, are the names in `out`, so a folder `out` belongs to one pattern.

    Parameters
    ----------
    files : str, or iterable of str and os.PathLike
        The clips, as of `load`; or one of them, or a pattern, ``"clips/**/*.bvh"``.
    robot : Humanoid, or what it is made of
        The robot.
    out : str or os.PathLike
        A folder, which is made.
    workers : int, optional
        Threads, each with a clip of its own; by default as many as processors.
    format, joints, bodies
        As of `save`.
    progress : callable, optional
        Told which part of the clips is done, in the thread of the call, and 1 at last.
    model, table
        As of `load`, for all clips.
    **options
        Those of `settings`.

    Returns
    -------
    pyarrow.Table
        A row for each clip: ``file``, ``motion``, ``frames``, ``fps``, the measures of a `Report` and its ``edges``, ``warnings``,
        ``error``, and what tells whether a clip has changed. ``measures.parquet`` also has the rows of calls before whose motions are there.
    """
    needed("pyarrow.parquet", "retarget")
    if workers is None:
        workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    elif isinstance(workers, bool) or not isinstance(workers, (int, np.integer)) or workers < 1:
        raise ValueError(f"Expected `workers` to be a number of threads, 1 or more, got {workers!r}.")
    job, paths = job_of(files, robot, out, format=format, model=model, table=table, joints=joints, bodies=bodies, **options)
    rows = {row["file"]: row for row in _known(job.out)}
    left = [path for path in paths if not job.has(rows.get(job.name(path)), path)]
    # What `dq8.progress` has set listens to the main thread alone.
    told = progress or (tell if threading.current_thread() is threading.main_thread() else lambda _: None)
    with open(job.out / _JOURNAL, "a", encoding="utf-8") as journal:
        for done, row in enumerate(_shared(job, left, workers), 1):
            rows[row["file"]] = row
            # The line before may be a part, of a process that was killed.
            journal.write("\n" + json.dumps(row))
            journal.flush()
            told((len(paths) - len(left) + done) / len(paths))
    mine = [rows.pop(job.name(path)) for path in paths]
    others = [row for row in rows.values() if row["motion"] and (job.out / row["motion"]).is_file()]
    made = write(job.out, [*mine, *others]).slice(0, len(mine))
    if progress:
        progress(1.0)
    failed = [f"{row['file']}: {row['error']}" for row in mine if row["error"] is not None]
    if failed:
        more = [f"and {len(failed) - 10} more"] if len(failed) > 10 else []
        warnings.warn("\n".join([f"{len(failed)} of {len(mine)} clips failed", *failed[:10], *more]), stacklevel=2)
    return made


def job_of(files: Any, robot: Any, out: Any, *, format: str, model: Any, table: Any, joints: Any, bodies: Any, **options: Any) -> tuple[Job, list[Path]]:
    """What is done with each clip, and the clips. What is wrong for all of them is an error here."""
    from . import __version__

    if isinstance(files, (str, os.PathLike)):
        given = os.fspath(files)
        is_pattern = glob.has_magic(given) and not os.path.lexists(given)
        matching = sorted(glob.glob(given, recursive=True)) if is_pattern else [given]
        found = [Path(path) for path in matching if not (is_pattern and os.path.isdir(path))]
        if not found:
            raise ValueError(f"There is no file {given!r}.")
    else:
        found = [Path(path) for path in files]
        if not found:
            raise ValueError("Expected `files` to be clips, got none.")
    if format not in SUFFIXES:
        raise ValueError(f"Expected `format` to be one of {', '.join(map(repr, SUFFIXES))}, got {format!r}.")
    humanoid = robot if isinstance(robot, Humanoid) else Humanoid(robot)
    # Both may be iterators; one name alone is an error.
    joints, bodies = (names if names is None or isinstance(names, str) else list(names) for names in (joints, bodies))
    chosen(humanoid, joints, bodies)
    wishes, text = settings(**options), toml(table)
    # A clip that is given twice, by other paths to it as well, is one.
    paths = {Path(os.path.abspath(path)): path for path in reversed(found)}
    root = Path(os.path.commonpath([path.parent for path in paths]))
    said = [__version__, humanoid.__reduce__()[1], wishes, format, joints, bodies, text, _said(model)]
    key = hashlib.sha256(repr(said).encode()).hexdigest()[:16]
    job = Job(humanoid, root, Path(out), format, joints, bodies, model, text, wishes, key)
    names: dict[Path, Path] = {}
    sources = {path.resolve() for path in paths}
    for path in reversed(paths.values()):
        motion = job.motion(path)
        other = names.setdefault(motion, path)
        if other != path:
            raise ValueError(f"{other} and {path} have one name without their suffixes, {motion}.")
        if (job.out / motion).resolve() in sources:
            raise ValueError(f"The motion of {path} would replace a clip, {job.out / motion}: choose another `out`.")
        try:
            os.path.abspath(path).encode()
        except UnicodeEncodeError:
            raise ValueError(f"The name of {os.fsencode(path)!r} is not UTF-8, as names in tables are.") from None
    job.out.mkdir(parents=True, exist_ok=True)
    return job, list(names.values())


def _said(model: Any) -> Any:
    """What tells one body model from another."""
    if isinstance(model, Mapping):
        arrays = [np.ascontiguousarray(array_of(model, name)) for name in BODY]
        return [(array.shape, str(array.dtype), hashlib.sha256(array.tobytes()).hexdigest()) for array in arrays]
    return None if model is None else (os.fspath(model), os.stat(model).st_mtime_ns)


@dataclasses.dataclass(frozen=True)
class Job:
    """What is done with each clip. Processes hand it to each other."""

    humanoid: Humanoid
    root: Path
    out: Path
    format: str
    joints: list[str] | None
    bodies: list[str] | None
    model: Any
    table: str | None
    wishes: dict[str, Any]
    key: str
    """Of all that a motion depends on but the clip."""

    def name(self, path: Path) -> str:
        """The clip in rows."""
        return Path(os.path.abspath(path)).relative_to(self.root).as_posix()

    def motion(self, path: Path) -> Path:
        """The file of the motion, in `out`."""
        return Path(self.name(path)).with_suffix(SUFFIXES[self.format])

    def _state(self, path: Path) -> Row:
        """What tells whether a clip has changed."""
        own: Row = {"source": os.path.abspath(path), "size": None, "modified": None, "key": self.key}
        with contextlib.suppress(OSError):
            stamp = path.stat()
            own |= {"size": stamp.st_size, "modified": stamp.st_mtime_ns}
        return own

    def has(self, row: Row | None, path: Path) -> bool:
        """Whether a row is that of the clip as it is, and its motion is there."""
        if row is None or row["error"] is not None or not (self.out / self.motion(path)).is_file():
            return False
        return self._state(path).items() <= row.items()

    def __call__(self, path: Path, stop: _core.Stop | None = None) -> Row:
        """Computes a clip, and says what became of it."""
        row: Row = dict.fromkeys(_COLUMNS) | {"file": self.name(path), "warnings": ""} | self._state(path)
        target = self.out / self.motion(path)
        try:
            # That of another call is not the motion of this one.
            target.unlink(missing_ok=True)
            person = opened(path, self.model, self.table)
            motion = retargeted(person, self.humanoid, self.wishes, stop)
            target.parent.mkdir(parents=True, exist_ok=True)
            save(motion, target, self.format, joints=self.joints, bodies=self.bodies)
        except Exception as error:  # noqa: BLE001: whatever is wrong with a clip, the others are computed
            return row | {"error": f"{type(error).__name__}: {error}"}
        said = "\n".join([*([person._warning] if person._warning else []), *motion.told, *motion.report.warnings])
        measures = {name: None if math.isnan(number) else number for name, number in motion.report.items()}
        made = {"motion": self.motion(path).as_posix(), "frames": len(motion), "fps": motion.fps, "edges": motion.report.edges, "warnings": said}
        return row | made | measures


def _shared(job: Job, paths: list[Path], workers: int) -> Iterator[Row]:
    """The rows of clips as they are done, by so many threads. Where the caller ends it, so do the calls of the others."""
    stop, pool = _core.Stop(), ThreadPoolExecutor(workers, "dq8")
    try:
        pending: set[Future[Row]] = {pool.submit(job, path, stop) for path in paths}
        while pending:
            # Awake now and then: signals are handled between.
            done, pending = wait(pending, 0.05, FIRST_COMPLETED)
            for future in done:
                yield future.result()
    finally:
        stop.set()
        pool.shutdown(wait=False, cancel_futures=True)


_JOURNAL, _TABLE = "measures.jsonl", "measures.parquet"
"""Rows as they come, and the table of all."""

_COLUMNS = ["file", "motion", "frames", "fps", *UNITS, "edges", "warnings", "error", "source", "size", "modified", "key"]


def _known(out: Path) -> Iterator[Row]:
    """The rows that calls before have written."""
    rows: list[Any] = []
    if (out / _TABLE).is_file():
        try:
            rows += needed("pyarrow.parquet", "retarget").read_table(out / _TABLE).to_pylist()
        except (OSError, ValueError) as error:
            raise ValueError(f"{out / _TABLE} is no table of an archive; remove it: {error}") from None
    if (out / _JOURNAL).is_file():
        for line in (out / _JOURNAL).read_text(encoding="utf-8", errors="replace").split("\n"):
            # Empty ones, and parts.
            with contextlib.suppress(ValueError):
                rows.append(json.loads(line))
    yield from (row for row in rows if isinstance(row, dict) and row.keys() >= set(_COLUMNS))


def write(out: str | os.PathLike[str], rows: Iterable[Row]) -> Any:
    """Writes the table of an archive, and returns it."""
    pa, parquet = needed("pyarrow", "retarget"), needed("pyarrow.parquet", "retarget")
    kinds = {name: pa.string() for name in ("file", "motion", "source", "key", "warnings", "error")}
    kinds |= {name: pa.int64() for name in ("frames", "size", "modified")}
    kinds |= {"edges": pa.bool_()}
    schema = pa.schema([(name, kinds.get(name, pa.float64())) for name in _COLUMNS])
    made = pa.Table.from_pylist(list(rows), schema)
    whole(Path(out) / _TABLE, lambda file: parquet.write_table(made, file))
    (Path(out) / _JOURNAL).unlink(missing_ok=True)
    return made
