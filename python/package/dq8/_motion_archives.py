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
from ._people import Table, opened, toml
from ._progress import progress as _progress
from ._progress import tell

Row = dict[str, Any]
"""What an archive says of a clip."""


def archive(
    files: str | Iterable[str | os.PathLike[str]],
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
    next call tries them again. The parts of `files` that differ, folders and names without suffixes, are the names in `out`.

    Parameters
    ----------
    files : str, or iterable of str and os.PathLike
        The clips, as of `load`; or a pattern, ``"clips/**/*.bvh"``.
    robot : Humanoid, or what it is made of
        The robot.
    out : str or os.PathLike
        A folder, which is made.
    workers : int, optional
        Threads, each with a clip of its own; by default as many as processors.
    format, joints, bodies
        As of `save`.
    progress : callable, optional
        Told which part of the clips is done, as by `dq8.progress`.
    model, table
        As of `load`, for all clips.
    **options
        Those of `settings`.

    Returns
    -------
    pyarrow.Table
        The rows of ``measures.parquet``: ``file``, ``motion``, ``frames``, ``fps``, the measures of a `Report`, ``warnings``,
        ``error``, and what tells whether a clip has changed.
    """
    job, paths = job_of(files, robot, out, format=format, model=model, table=table, joints=joints, bodies=bodies, **options)
    needed("pyarrow.parquet", "retarget")
    if workers is None:
        workers = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    rows = {row["file"]: row for row in _known(job.out)}
    left = [path for path in paths if not job.has(rows.get(job.name(path)), path)]
    main = threading.current_thread() is threading.main_thread()
    with contextlib.nullcontext() if progress is None else _progress(progress), open(job.out / _JOURNAL, "a", encoding="utf-8") as journal:
        for done, row in enumerate(_shared(job, left, workers), 1):
            rows[row["file"]] = row
            # The line before may be a part, of a process that was killed.
            journal.write("\n" + json.dumps(row))
            journal.flush()
            if main:
                tell((len(paths) - len(left) + done) / len(paths))
    mine = [rows[job.name(path)] for path in paths]
    made = write(job.out, mine)
    failed = [f"{row['file']}: {row['error']}" for row in mine if row["error"] is not None]
    if failed:
        more = [f"and {len(failed) - 10} more"] if len(failed) > 10 else []
        warnings.warn("\n".join([f"{len(failed)} of {len(mine)} clips failed", *failed[:10], *more]), stacklevel=2)
    return made


def job_of(files: Any, robot: Any, out: Any, *, format: str, model: Any, table: Any, joints: Any, bodies: Any, **options: Any) -> tuple[Job, list[Path]]:
    """What is done with each clip, and the clips. What is wrong for all of them is an error here."""
    from . import __version__

    if isinstance(files, str):
        found: list[Path] = [Path(path) for path in sorted(glob.glob(files, recursive=True))] if glob.has_magic(files) else [Path(files)]
        if not found:
            raise ValueError(f"There is no file {files!r}.")
    else:
        found = [Path(path) for path in files]
    if format not in SUFFIXES:
        raise ValueError(f"Expected `format` to be one of {', '.join(map(repr, SUFFIXES))}, got {format!r}.")
    humanoid = robot if isinstance(robot, Humanoid) else Humanoid(robot)
    chosen(humanoid, joints, bodies)
    # Both may be iterators.
    joints, bodies = (None if names is None else list(names) for names in (joints, bodies))
    wishes, text = settings(**options), toml(table)
    root = Path(os.path.commonpath([path.absolute().parent for path in found])) if found else Path()
    said = [__version__, humanoid.__reduce__()[1], wishes, format, joints, bodies, text, _said(model)]
    key = hashlib.sha256(repr(said).encode()).hexdigest()[:16]
    job = Job(humanoid, root, Path(out), format, joints, bodies, model, text, wishes, key)
    names: dict[Path, Path] = {}
    for path in found:
        other = names.setdefault(job.motion(path), path)
        if other != path:
            raise ValueError(f"{other} and {path} have one name without their suffixes, {job.motion(path)}.")
    job.out.mkdir(parents=True, exist_ok=True)
    return job, list(names.values())


def _said(model: Any) -> Any:
    """What tells one body model from another."""
    if model is None or isinstance(model, Mapping):
        return None if model is None else hashlib.sha256(np.asarray(model["v_template"]).tobytes()).hexdigest()
    return os.fspath(model), os.stat(model).st_mtime_ns


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
        return path.absolute().relative_to(self.root).as_posix()

    def motion(self, path: Path) -> Path:
        """The file of the motion, in `out`."""
        return Path(self.name(path)).with_suffix(SUFFIXES[self.format])

    def _state(self, path: Path) -> Row:
        """What tells whether a clip has changed."""
        try:
            stamp = path.stat()
        except OSError:
            return {"size": None, "modified": None, "key": self.key}
        return {"size": stamp.st_size, "modified": stamp.st_mtime_ns, "key": self.key}

    def has(self, row: Row | None, path: Path) -> bool:
        """Whether a row is that of the clip as it is, and its motion is there."""
        if row is None or row["error"] is not None or not (self.out / self.motion(path)).is_file():
            return False
        return self._state(path).items() <= row.items()

    def __call__(self, path: Path, stop: _core.Stop | None = None) -> Row:
        """Computes a clip, and says what became of it."""
        row: Row = {"file": self.name(path), "motion": None, "frames": None, "fps": None, "warnings": "", "error": None}
        row |= self._state(path)
        try:
            person = opened(path, self.model, self.table)
            motion = retargeted(person, self.humanoid, self.wishes, stop)
            target = self.out / self.motion(path)
            target.parent.mkdir(parents=True, exist_ok=True)
            save(motion, target, self.format, joints=self.joints, bodies=self.bodies)
        except Exception as error:  # noqa: BLE001: whatever is wrong with a clip, the others are computed
            return row | {"error": f"{type(error).__name__}: {error}"}
        said = "\n".join([*([person._warning] if person._warning else []), *motion.told, *motion.report.warnings])
        measures = {name: None if math.isnan(number) else number for name, number in motion.report.items()}
        return row | {"motion": self.motion(path).as_posix(), "frames": len(motion), "fps": motion.fps, "warnings": said} | measures


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


def _known(out: Path) -> Iterator[Row]:
    """The rows that calls before have written."""
    if (out / _TABLE).is_file():
        yield from needed("pyarrow.parquet", "retarget").read_table(out / _TABLE).to_pylist()
    if (out / _JOURNAL).is_file():
        for line in (out / _JOURNAL).read_text(encoding="utf-8").splitlines():
            # Empty ones, and parts.
            with contextlib.suppress(ValueError):
                yield json.loads(line)


def write(out: str | os.PathLike[str], rows: Iterable[Row]) -> Any:
    """Writes the table of an archive, and returns it."""
    pa, parquet = needed("pyarrow", "retarget"), needed("pyarrow.parquet", "retarget")
    kinds = {name: pa.string() for name in ("file", "motion", "key", "warnings", "error")}
    kinds |= {name: pa.int64() for name in ("frames", "size", "modified")}
    names = ["file", "motion", "frames", "fps", *UNITS, "warnings", "error", "size", "modified", "key"]
    schema = pa.schema([(name, kinds.get(name, pa.float64())) for name in names])
    made = pa.Table.from_pylist([{name: row.get(name) for name in names} for row in rows], schema)
    whole(Path(out) / _TABLE, lambda file: parquet.write_table(made, file))
    (Path(out) / _JOURNAL).unlink(missing_ok=True)
    return made
