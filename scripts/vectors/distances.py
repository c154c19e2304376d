"""Rows of distances between motions, from their rotation matrices and translations alone."""

from mpmath import mp, mpf

from .inputs import BETWEEN, clusters, reach, rng, shared, single, singles, vector
from .matrices import homogeneous, unit


@shared
def pairs():
    """Kind, place among its kind, inputs and their matrices."""
    for kind in BETWEEN:
        for i, pair in enumerate(clusters(kind, 2)):
            inputs = dict(zip("ab", map(singles, pair)))
            yield kind, i, inputs, [mp.matrix(homogeneous(unit(c))) for c in inputs.values()]


def chord(a, b):
    """2 sin(θ/2): a turn by θ has two singular values of R − 1 of that size, and one of zero."""
    difference = a[:3, :3] - b[:3, :3]
    return mp.sqrt(sum(c**2 for c in difference) / 2)


def angle(a, b):
    return 2 * mp.asin(chord(a, b) / 2)


def distance(a, b):
    return mp.norm(a[:3, 3] - b[:3, 3])


def between(measure, more=lambda kind, i: {}):
    """`measure` of two matrices and of the other inputs, which `more` draws."""

    def rows():
        for kind, i, motions, matrices in pairs():
            others = more(kind, i)
            yield kind, {**motions, **others}, measure(*matrices, *others.values())

    return rows


def weighted(a, b, length_per_radian):
    return mp.hypot(mpf(length_per_radian) * angle(a, b), distance(a, b))


def of_point(a, b, v):
    return mp.norm((a - b) * mp.matrix([*map(mpf, v), 1]))


def of_shell(a, b, radius):
    """No point of the ball moves farther by the turn than the chord on its surface."""
    return distance(a, b) + mpf(radius) * chord(a, b)


def length(kind, i):
    return single(10.0 ** (i % 3 - 1) * rng.random())


OPERATIONS = {
    "angle_to": between(angle),
    "distance_to": between(distance),
    "distance_weighted": between(weighted, lambda kind, i: {"length_per_radian": length(kind, i)}),
    "point_error": between(of_point, lambda kind, i: {"v": vector(reach(kind, i + 1))}),
    "shell_error": between(of_shell, lambda kind, i: {"radius": length(kind, i)}),
}
