"""Writes motions of robots as trainers read them."""

from __future__ import annotations

import os
import pickle
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

from . import _core
from ._rotations import to_rotation_vector

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._motions import Humanoid, Motion

SUFFIXES = {"gmr": ".pkl", "unitree": ".csv", "npz": ".npz"}


def save(
    motion: Motion,
    path: str | os.PathLike[str],
    format: str | None = None,
    *,
    joints: Sequence[str] | None = None,
    bodies: Sequence[str] | None = None,
) -> None:
    """Writes a motion. The file appears when it is whole.

    Parameters
    ----------
    motion : Motion
        What `retarget` has made.
    path : str or os.PathLike
        The file.
    format : {'npz', 'gmr', 'unitree'}, optional
        By default what the suffix says.

        - ``'npz'`` (.npz) is what BeyondMimic and mjlab read, in float32: ``fps``, ``joint_pos``, ``joint_vel``,
          ``body_pos_w``, ``body_quat_w`` (w, x, y, z), ``body_lin_vel_w``, ``body_ang_vel_w``. Velocities are central
          differences, of the origins of links and in the axes of the world.
        - ``'gmr'`` (.pkl) is GMR's pickle: ``fps``, ``root_pos``, ``root_rot`` (x, y, z, w), ``dof_pos``, ``local_body_pos``
          in the frame of the root, ``link_body_list``.
        - ``'unitree'`` (.csv) is a row a frame, without a heading: x y z, qx qy qz qw, joints. It does not say the frames per
          second, which are 30 in Unitree's own files.
    joints, bodies : sequence of str, optional
        Names in the order of the simulator, all or some; by default all joints that move, and all links, in the order of the
        robot's file.
    """
    if format is None:
        format = next((name for name, suffix in SUFFIXES.items() if suffix == Path(path).suffix.lower()), None)
    if format not in _WRITERS:
        raise ValueError(f"Expected `format` to be one of {', '.join(map(repr, SUFFIXES))}, got {format!r} for {os.fspath(path)!r}.")
    order, links = chosen(motion.humanoid, joints, bodies)
    whole(path, lambda file: _WRITERS[format](motion, file, order, links))


def chosen(humanoid: Humanoid, joints: Sequence[str] | None, bodies: Sequence[str] | None) -> tuple[list[int], list[str]]:
    """The places of joints among the values of a motion, and the names of links."""
    own, links = humanoid.joints, humanoid.links
    found = []
    for kind, names, known in (("joints", joints, own), ("bodies", bodies, links)):
        if isinstance(names, str):
            raise TypeError(f"Expected `{kind}` to be a sequence of names, got one: {names!r}.")
        wanted = known if names is None else list(names)
        unknown = [name for name in wanted if name not in known]
        if unknown:
            raise ValueError(f"`{kind}`: the robot has no {', '.join(map(repr, unknown))}; it has {', '.join(known)}.")
        if len(set(wanted)) < len(wanted):
            raise ValueError(f"`{kind}`: a name is there twice: {', '.join(wanted)}.")
        found.append(wanted)
    return [own.index(name) for name in found[0]], found[1]


def whole(path: str | os.PathLike[str], write: Callable[[BinaryIO], object]) -> None:
    """Writes a file beside its place, and moves it there when it is whole."""
    part = os.fspath(path) + ".part"
    try:
        with open(part, "wb") as file:
            write(file)
        os.replace(part, path)
    except BaseException:
        Path(part).unlink(missing_ok=True)
        raise


def _slopes(of: NDArray[Any], fps: float) -> NDArray[Any]:
    """Velocities of what follows each other: central differences, one-sided at the ends."""
    if len(of) < 2:
        return np.zeros_like(of)
    slopes: NDArray[Any] = np.gradient(of, axis=0)
    slopes *= of.dtype.type(fps)
    return slopes


def _turning(poses: NDArray[Any], fps: float) -> NDArray[Any]:
    """Angular velocities in the axes of the world, as `_slopes`."""
    turning = np.zeros((*poses.shape[:-1], 3), poses.dtype)

    def between(later: NDArray[Any], earlier: NDArray[Any], scale: float) -> NDArray[Any]:
        vector: NDArray[Any] = to_rotation_vector(_core.mul(later, _core.conjugate(earlier)))
        vector *= poses.dtype.type(scale)
        return vector

    if len(poses) > 1:
        turning[1:-1] = between(poses[2:], poses[:-2], fps / 2)
        turning[0], turning[-1] = between(poses[[1, -1]], poses[[0, -2]], fps)
    return turning


def _npz(motion: Motion, file: BinaryIO, joints: list[int], bodies: list[str]) -> None:
    values = motion.values[:, joints].astype(np.float32)
    poses = motion.humanoid._mechanism.poses(motion.configurations().astype(np.float32), bodies)
    places = _core.translation(poses)
    np.savez(
        file,
        fps=np.array([motion.fps]),
        joint_pos=values,
        joint_vel=_slopes(values, motion.fps),
        body_pos_w=places,
        body_quat_w=poses[..., [3, 0, 1, 2]],
        body_lin_vel_w=_slopes(places, motion.fps),
        body_ang_vel_w=_turning(poses, motion.fps),
    )


def _gmr(motion: Motion, file: BinaryIO, joints: list[int], bodies: list[str]) -> None:
    places = _core.translation(motion.poses(bodies))
    contents = {
        "fps": motion.fps,
        "root_pos": _core.translation(motion.root),
        "root_rot": motion.root[:, :4].copy(),
        "dof_pos": motion.values[:, joints],
        "local_body_pos": _core.transform_points(_core.inverse(motion.root)[:, np.newaxis], places),
        "link_body_list": bodies,
    }
    pickle.dump(contents, file, protocol=4)


def _unitree(motion: Motion, file: BinaryIO, joints: list[int], bodies: list[str]) -> None:
    rows = [_core.translation(motion.root), motion.root[:, :4], motion.values[:, joints]]
    np.savetxt(file, np.concatenate(rows, axis=1), fmt="%.6f", delimiter=",")


_WRITERS: dict[str, Callable[[Any, BinaryIO, list[int], list[str]], None]] = {"npz": _npz, "gmr": _gmr, "unitree": _unitree}
