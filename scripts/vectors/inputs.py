"""Inputs that are exactly binary32 numbers, by kinds."""

import functools
import random
import struct

from mpmath import mp, mpf

from .matrices import move, numbers, turn

NEAR_0 = [mpf(10) ** -e for e in (1, 2, 3, 4, 6, 8, 12, 16, 20, 26, 32, 38)]
NEAR_PI = [mp.pi - mpf(10) ** -e for e in range(1, 10)]
CLOSE = [10.0**-e for e in (1, 2, 3, 4, 5)]
FAR = (1e3, 1e4, 1e6)
COUNT = 10  # rows of a kind that has no list of its own
FEW = 5  # the same in geometry.jsonl
UNIT = ("plain", "near0", "nearpi", "far", "translation")
BETWEEN = (*UNIT, "close")
ALGEBRA = ("general", "far")
rng = random.Random()


def single(x):
    return struct.unpack("f", struct.pack("f", float(x)))[0]


def singles(m):
    return [single(c) for c in numbers(m)]


def uniform(low, high):
    return mpf(rng.uniform(low, high))


def vector(size=1):
    return [single(size * rng.uniform(-1, 1)) for _ in range(3)]


def axis():
    while True:
        v = [uniform(-1, 1) for _ in range(3)]
        length = mp.norm(v)
        if mpf("0.3") < length:
            return [c / length for c in v]


def angles(kind):
    lists = {"near0": NEAR_0, "nearpi": NEAR_PI, "translation": [mpf(0)] * COUNT}
    return lists.get(kind) or [uniform(-3, 3) for _ in range(COUNT)]


def reach(kind, i):
    """Lengths of a kind."""
    return {"far": 1e4, "translation": 10.0 ** (i % 7 - 3)}.get(kind, 10.0 ** (i % 3 - 1))


def sign():
    return rng.choice([-1, 1])


def poses(kind):
    for i, angle in enumerate(angles(kind)):
        yield sign() * move(vector(reach(kind, i))) * turn(axis(), angle)


def clusters(kind, count):
    """Poses to interpolate between: no two of them half a turn apart, signs at random."""
    most = 2.8 if count == 2 else 1.3
    for i, first in enumerate(poses("plain" if kind == "close" else kind)):
        others = []
        for _ in range(count - 1):
            if kind in ("near0", "translation"):
                angle = angles(kind)[i] * (1 + sign() * mpf("0.5"))
                other = move(vector(reach(kind, i))) * turn(axis(), angle)
            elif kind == "close":
                tiny = 10.0 ** -(i % 7 + 1)
                other = first * move(vector(tiny)) * turn(axis(), tiny)
            else:
                other = move(vector(reach(kind, i))) * first * turn(axis(), uniform(-most, most))
            others.append(sign() * other)
        yield [first, *others]


def general(size=1):
    return [single(size * rng.uniform(-3, 3)) for _ in range(8)]


def any_motions(kind, count):
    for _ in range(COUNT) if kind in ("general", "scaled") else ():
        yield [general(10 ** rng.uniform(-12, 12) if kind == "scaled" else 1) for _ in range(count)]
    for cluster in clusters(kind, count) if kind not in ("general", "scaled") else ():
        yield [singles(m) for m in cluster]


def shared(draw):
    """What several operations start from, drawn once; it does not disturb the numbers of whoever asks first."""

    @functools.cache
    def once():
        state = rng.getstate()
        rng.seed(draw.__qualname__)
        drawn = list(draw())
        rng.setstate(state)
        return drawn

    return once


def each(*kinds):
    """Kinds with the places among them."""
    return [(kind, i) for kind in kinds for i in range(FEW)]


def near_0(i):
    """A few of them, the largest and the smallest among them."""
    return NEAR_0[(len(NEAR_0) - 1) * i // (FEW - 1)]


def size(kind, i):
    """Lengths of a kind, where there are few."""
    return {"far": FAR[i % 3], "tiny": 10.0 ** -(12 + 3 * i), "huge": 10.0 ** (6 + i)}.get(kind, 10.0 ** (i % 3 - 1))


def parameter():
    return single(rng.random())
