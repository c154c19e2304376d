"""Vectors of space, lines and planes, as lists of mpf."""

from mpmath import mp, mpf

from .inputs import rng, single, vector


def exact(numbers):
    return [mpf(c) for c in numbers]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def scale(s, a):
    return [s * c for c in a]


def dot(a, b):
    return mp.fdot(a, b)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return mp.sqrt(dot(a, a))


def unit(a):
    return scale(1 / length(a), a)


def solve(columns, right):
    """The coefficients of the columns whose sum is `right`."""
    return list(mp.lu_solve(mp.matrix(columns).T, mp.matrix(right)))


def line(numbers):
    """Direction, and the point nearest to the origin: the moment times the direction is what the part along it leaves."""
    l, m = exact(numbers[:3]), exact(numbers[3:])
    n = unit(l)
    return n, scale(1 / length(l), cross(n, m))


def pluecker(direction, point):
    return direction + cross(point, direction)


def plane(numbers):
    """Unit normal and distance."""
    n = exact(numbers[:3])
    return unit(n), mpf(numbers[3]) / length(n)


def rounded(numbers):
    return [single(c) for c in numbers]


def direction(size=1):
    """Any direction, of a length up to that."""
    while True:
        v = vector()
        if length(exact(v)) > 0.3:
            return [single(size * c) for c in v]


def beside(v, angle):
    """Another vector, turned away by about that angle, as far as binary32 has one."""
    other = cross(unit(exact(v)), unit(exact(direction())))
    size = length(exact(v)) * 2 ** rng.choice([-1, 0, 1])
    return rounded(add(scale(size * mp.cos(angle), unit(exact(v))), scale(size * mp.sin(angle), unit(other))))


def whole(most):
    """Small whole numbers: products and sums of them are exact."""
    while True:
        v = [float(rng.randint(-most, most)) for _ in range(3)]
        if any(v):
            return v
