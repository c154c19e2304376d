"""Names of numbers: which one of a motion, a rotation, a point or a twist is in which column."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

# In the order of the arrays.
ORDERS = [names.split() for names in ("px py pz pw qx qy qz qw", "qx qy qz qw", "x y z w", "x y z", "tx ty tz", "wx wy wz vx vy vz")]


def order(names: Sequence[Any]) -> list[int] | None:
    """Where the columns of arrays are among columns of these names; None where names do not say it, or they are in order."""
    if len(names) not in (3, 4, 6, 8):
        return None
    given = [str(name) for name in names]
    for known in ORDERS:
        if given != known and sorted(given) == sorted(known):
            return [given.index(name) for name in known]
    return None


def places(argument: str, names: Sequence[Any], wanted: Sequence[str]) -> list[int] | None:
    """Where the columns `wanted` are among those of a frame; None where its columns are numbered in order.

    ValueError names a column that is not wanted, there twice, or missing.
    """
    given = list(names)
    if given == list(range(len(wanted))):
        return None
    for index, name in enumerate(given):
        if name not in wanted or name in given[:index]:
            wrong = "is not a value of this mechanism" if name not in wanted else "is there twice"
            raise ValueError(f"`{argument}`: the column {name!r} {wrong}; the values are {', '.join(wanted)}.")
    for name in wanted:
        if name not in given:
            raise ValueError(f'`{argument}`: there is no column "{name}"; the values are {", ".join(wanted)}.')
    return [given.index(name) for name in wanted]
