"""Humanoids, and motions that they do."""

from __future__ import annotations

import dataclasses
import functools
import html
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._core import Person
from ._notebooks import table as shown
from ._people import Table, toml
from ._rotations import from_rotation

if TYPE_CHECKING:
    from numpy.typing import NDArray

UNITS = {
    "residual": "mm, the mean distance of links from their targets",
    "residual_high": "mm, the distance that a twentieth exceed",
    "feet": "mm, the mean distance of feet from their targets",
    "slide": "mm/s, the speed of soles while the person's feet stand",
    "ground": "mm, the height of standing soles",
    "unevenness": "mm, the standard deviation of that height",
    "sink": "mm, the depth of the lowest sole under that height",
    "sunk": "% of frames in which a sole is more than 10 mm under it",
    "speed": "rad/s, the speed of joints that a twentieth exceed",
    "speed_most": "rad/s, the greatest speed of a joint",
    "jerk": "rad/s³, the mean third derivative of joints",
    "at_limits": "% of values at a limit",
    "beyond": "rad, the largest distance of a value beyond its limits",
    "self_hits": "% of frames in which the robot is more than 10 mm deep in itself; NaN if shapes are meshes or there are none",
}


class Report(Mapping[str, float]):
    """The measures of a motion, by their names. `warnings` are sentences about those that a good motion does not have.

    `edges` is False if no edges of a sole are known, as where its shape is a mesh, but one point: edges may sink deeper than
    ``sink`` and ``sunk`` tell.
    """

    def __init__(self, numbers: Mapping[str, float], warnings: Sequence[str] = (), edges: bool = True) -> None:
        self._numbers, self.warnings, self.edges = dict(numbers), tuple(warnings), edges

    def __getitem__(self, name: str) -> float:
        return self._numbers[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._numbers)

    def __len__(self) -> int:
        return len(self._numbers)

    def _rows(self) -> list[list[str]]:
        units = UNITS if self.edges else UNITS | {name: f"{UNITS[name]}; edges of soles are not known" for name in ("sink", "sunk")}
        return [[name, f"{number:.4g}", units[name]] for name, number in self._numbers.items()]

    def __repr__(self) -> str:
        lines = [f"{name:<14}{number:>10} {unit}" for name, number, unit in self._rows()]
        return "\n".join([*lines, *(f"warning: {sentence}" for sentence in self.warnings)])

    def _repr_html_(self) -> str:
        said = "".join(f"<p>{html.escape(sentence)}</p>" for sentence in self.warnings)
        return shown("Measures", ["measure", "number", "unit"], self._rows()) + said


class Humanoid(_core.Humanoid):
    """A humanoid robot on a base that floats, with the roles that its links have; ``print`` lists them.

    Roles are found by names, and by the shape where names fail: two mirrored chains of hinges that reach lowest are legs. A
    robot without two legs is refused.

    Parameters
    ----------
    source : str, bytes or os.PathLike
        A URDF file; or its bytes; or its text, if the first thing in it is ``<``.
    table : mapping, str or os.PathLike, optional
        Roles that names do not tell, ``{"links": {"left_foot": "ankle_l_2"}}``, or the same as TOML, as `table()` gives it.
    """

    def __new__(cls, source: str | bytes | os.PathLike[str], table: Table | None = None) -> Humanoid:
        return super().__new__(cls, source, toml(table))

    @functools.cached_property
    def _offset(self) -> NDArray[np.float64]:
        """The pose of the link that floats where the values of the base are no motion."""
        values = np.zeros(7 + len(self.joints))
        values[3] = 1.0
        pose: NDArray[np.float64] = self._mechanism.poses(values, self._base)
        return pose

    def _repr_html_(self) -> str:
        return shown(repr(self).strip("<>"), ["role", "link"], [list(role) for role in self.roles])


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Motion:
    """The motion of a robot, as `retarget` makes it."""

    humanoid: Humanoid
    values: NDArray[np.float64]
    """Joint values, shape (frames, joints), in the order of `joints`: radians and metres."""
    root: NDArray[np.float64]
    """The poses of the link that floats, shape (frames, 8)."""
    contacts: NDArray[np.bool_]
    """Whether the left and the right foot of the person stand, shape (frames, 2)."""
    fps: float
    report: Report
    """How well the robot does what the person did."""
    told: tuple[str, ...] = ()
    """Sentences about what was found in the clip, and about what had to be assumed."""

    @property
    def joints(self) -> list[str]:
        """The names of the joints."""
        return self.humanoid.joints

    def __len__(self) -> int:
        return len(self.values)

    def configurations(self) -> NDArray[np.float64]:
        """The values of the base, rotation (x, y, z, w) and place, and then those of joints: shape (frames, 7 + joints)."""
        base = _core.mul(_core.inverse(self.humanoid._offset), self.root)
        return np.concatenate([base[:, :4], _core.translation(base), self.values], axis=1)

    def poses(self, links: Sequence[str | int] | None = None) -> NDArray[np.float64]:
        """The poses of links in the world, shape (frames, links, 8): of all links, or of those that are named."""
        if isinstance(links, (str, int)):
            raise TypeError(f"Expected `links` to be a sequence of links, got one: {links!r}.")
        poses: NDArray[np.float64] = self.humanoid._mechanism.poses(self.configurations(), links)
        return poses

    def __repr__(self) -> str:
        return f"<dq8.retarget.Motion of {self.humanoid.name!r}: {len(self)} frames, {len(self.joints)} joints, {self.fps:.6g} fps>"

    def _repr_html_(self) -> str:
        return f"<p>{html.escape(repr(self))}</p>{self.report._repr_html_()}"


_NONE = type(None)
_KINDS: dict[str, tuple[str, tuple[type, ...]]] = {
    "fps": ("a number", (float, int)),
    "rest": ("a number of a frame or None", (int, _NONE)),
    "ankle": ("a number or None", (float, int, _NONE)),
    "feet": ("True or False", (bool,)),
    "smooth": ("a number or None", (float, int, _NONE)),
    "speeds": ("a number, 'file' or None", (float, int, str, _NONE)),
    "collide": ("True or False", (bool,)),
}


def settings(
    *,
    fps: float = 30.0,
    rest: int | None = None,
    ankle: float | None = None,
    feet: bool = True,
    smooth: float | None = 4.0,
    speeds: float | str | None = None,
    collide: bool = True,
) -> dict[str, Any]:
    """The keywords of `retarget`, `report` and `archive`, with those that are not given.

    Parameters
    ----------
    fps : float
        Frames per second of the motion; those between the frames of the clip are interpolated.
    rest : int, optional
        The frame in which the person stands as the robot does at rest; by default it is found.
    ankle : float, optional
        The height of ankles above soles, metres; by default that of the collision shapes of the feet.
    feet : bool
        Whether feet are held flat on the ground while the person's feet stand.
    smooth : float, optional
        The frequency in Hz that is halved; None smooths nothing.
    speeds : float or 'file', optional
        The greatest speed of all joints, rad/s, or those of the robot's file.
    collide : bool
        Whether the collision shapes of the robot are pushed apart where they meet.
    """
    given = {"fps": fps, "rest": rest, "ankle": ankle, "feet": feet, "smooth": smooth, "speeds": speeds, "collide": collide}
    wishes = {name: value.item() if isinstance(value, np.generic) else value for name, value in given.items()}
    for name, (what, kinds) in _KINDS.items():
        # A flag is a number to Python.
        if not isinstance(wishes[name], kinds) or (isinstance(wishes[name], bool) and bool not in kinds):
            raise TypeError(f"Expected `{name}` to be {what}, got {wishes[name]!r}.")
    _core.check_settings(wishes)
    return wishes


def retarget(person: Person, humanoid: Humanoid, **options: Any) -> Motion:
    """Brings the motion of a person on a robot. Other threads of Python run meanwhile.

    Parameters
    ----------
    person : Person
        The clip.
    humanoid : Humanoid
        The robot.
    **options
        Those of `settings`.

    Returns
    -------
    Motion
    """
    return retargeted(person, humanoid, settings(**options), None)


def retargeted(person: Person, humanoid: Humanoid, wishes: dict[str, Any], stop: _core.Stop | None) -> Motion:
    found, contacts, measures, told = _core.retarget_motion(person, humanoid, wishes, stop)
    # Of single floats, so their length is not quite one.
    base = _core.normalize(from_rotation(found[:, :4], check=False))
    root = _core.mul(humanoid._offset, _core.mul(_core.from_translation(found[:, 4:7]), base))
    return Motion(humanoid, found[:, 7:], root, contacts, wishes["fps"], Report(*measures), tuple(told))


def report(motion: Motion, person: Person, **options: Any) -> Report:
    """Measures a motion, made here or elsewhere, by what a person does: the keywords say what is asked for, as of `settings`.

    The frames per second are those of the motion if `fps` does not say others. ``dataclasses.replace(motion, values=...)`` is a motion with other values.
    """
    if not isinstance(motion, Motion):
        raise TypeError(f"Expected `motion` to be a Motion, got {type(motion).__name__}.")
    wishes = settings(**{"fps": motion.fps, **options})
    configurations = motion.configurations()
    if not np.isfinite(configurations).all():
        frame, column = np.argwhere(~np.isfinite(configurations))[0]
        raise ValueError(f"Expected finite numbers, got {configurations[frame, column]} in frame {frame}, column {column} of the configurations.")
    return Report(*_core.retarget_report(person, motion.humanoid, configurations, wishes))
