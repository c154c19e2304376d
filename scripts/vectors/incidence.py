"""Rows of lines and planes: what they are made of, their distances, and where they meet.

The truth solves for points: linear equations for where things meet, projections for what is nearest.
"""

from mpmath import mp, mpf

from .inputs import CLOSE, FEW, each, rng, single, size, vector
from .space import (
    add, beside, cross, direction, dot, exact, length, line, plane, pluecker, rounded, scale, solve, sub, unit, whole,
)


def lines(kind, i):
    """Numbers of a line: moments across the direction but for their rounding."""
    l = direction(10 ** rng.uniform(-3, 3) if kind == "scaled" else 1)
    return l + rounded(cross(exact(vector(size(kind, i))), exact(l)))


def planes(kind, i):
    n = direction(10 ** rng.uniform(-3, 3) if kind == "scaled" else 1)
    return n + [single(length(exact(n)) * size(kind, i) * rng.uniform(-2, 2))]


def points(kind, i, count):
    """Points, and those near the first at distances of a kind."""
    first = vector(size(kind, i))
    near = CLOSE[i % 5] if kind == "near" else None
    others = [rounded(add(exact(first), exact(vector(near)))) if near else vector(size(kind, i)) for _ in range(count - 1)]
    return [first, *others]


def from_point_direction():
    for kind, i in each("plain", "far"):
        p, l = vector(size(kind, i)), direction()
        yield kind, {"p": p, "l": l}, pluecker(exact(l), exact(p))


def from_points():
    for kind, i in each("plain", "near", "far", "tiny", "huge"):
        p, q = points(kind, i, 2)
        yield kind, {"p": p, "q": q}, pluecker(unit(sub(exact(q), exact(p))), exact(p))


def normalize_line():
    for kind, i in each("plain", "far", "scaled", "pitch"):
        a = direction() + vector(10) if kind == "pitch" else lines(kind, i)
        yield kind, {"a": a}, pluecker(*line(a))


def is_line():
    for i in range(FEW):
        a = lines("plain", i) if i % 2 else direction() + vector(10)
        l, m = exact(a[:3]), exact(a[3:])
        pitch = abs(dot(l, m)) / (length(l) * max(length(l), length(m)))
        tolerance = single(1e-5)
        assert pitch < tolerance / 10 or pitch > 10 * tolerance
        yield "plain", {"a": a, "tolerance": tolerance}, [mpf(pitch < tolerance)]


def closest_point_to_origin():
    for kind, i in each("plain", "far"):
        a = lines(kind, i)
        yield kind, {"a": a}, cross(exact(a[:3]), exact(a[3:]))


def closest_point():
    for kind, i in each("plain", "far"):
        a, p = lines(kind, i), vector(size(kind, i + 1))
        l, m, x = exact(a[:3]), exact(a[3:]), exact(p)
        yield kind, {"a": a, "p": p}, add(cross(l, m), scale(dot(l, x), l))


def distance_to_point():
    for kind, i in each("plain", "near", "far", "scaled"):
        a, p = lines(kind, i), vector(size(kind, i + 1))
        l, foot = line(a)
        if kind == "near":
            p = rounded(add(add(foot, scale(rng.uniform(-2, 2), l)), exact(vector(CLOSE[i % 5]))))
        way = sub(exact(p), foot)
        yield kind, {"a": a, "p": p}, [length(sub(way, scale(dot(way, l), l)))]


def reciprocal_product():
    for kind, i in each("plain", "far"):
        a, b = lines(kind, i), lines(kind, i + 1)
        yield kind, {"a": a, "b": b}, [dot(exact(a[:3]), exact(b[3:])) + dot(exact(a[3:]), exact(b[:3]))]


def from_point_normal():
    for kind, i in each("plain", "far"):
        p, n = vector(size(kind, i)), direction()
        yield kind, {"p": p, "n": n}, exact(n) + [dot(exact(n), exact(p))]


def plane_from_points():
    for kind, i in each("plain", "near", "slender", "far", "tiny", "huge"):
        p, q, r = points(kind, i, 3)
        if kind == "slender":
            way = rounded(sub(exact(q), exact(p)))
            r = rounded(add(exact(p), exact(beside(way, CLOSE[i % 5]))))
        a, b, c = exact(p), exact(q), exact(r)
        # All points x with n·x = d through the three, of either size.
        n = unit(cross(sub(b, a), sub(c, a)))
        yield kind, {"p": p, "q": q, "r": r}, n + [dot(n, b)]


def plane_from_line_point():
    for kind, i in each("plain", "near", "far", "scaled"):
        a, p = lines(kind, i), vector(size(kind, i + 1))
        l, foot = line(a)
        if kind == "near":
            p = rounded(add(add(foot, scale(rng.uniform(-2, 2), l)), exact(vector(CLOSE[i % 4]))))
        n = unit(cross(l, sub(exact(p), foot)))
        yield kind, {"a": a, "p": p}, n + [dot(n, foot)]


def normalize_plane():
    for kind, i in each("plain", "far", "scaled"):
        a = planes(kind, i)
        n, d = plane(a)
        yield kind, {"a": a}, n + [d]


def signed_distance():
    for kind, i in each("plain", "far"):
        a, p = planes(kind, i), vector(size(kind, i + 1))
        yield kind, {"a": a, "p": p}, [dot(exact(a[:3]), exact(p)) - mpf(a[3])]


def from_planes():
    for kind, i in each("plain", "close", "far", "scaled"):
        a, b = planes(kind, i), planes(kind, i + 1)
        if kind == "close":
            b[:3] = beside(a[:3], CLOSE[i % 5])
        (n, d), (k, e) = plane(a), plane(b)
        l = unit(cross(n, k))
        # The point of both planes nearest to the origin.
        point = list(mp.lu_solve(mp.matrix([n, k, l]), mp.matrix([d, e, 0])))
        yield kind, {"a": a, "b": b}, pluecker(l, point)


def intersection_with_plane():
    for kind, i in each("plain", "grazing", "far", "scaled"):
        a, b = lines(kind, i), planes(kind, i + 1)
        if kind == "grazing":
            n = unit(exact(b[:3]))
            l = exact(direction())
            l = add(sub(l, scale(dot(l, n), n)), scale(CLOSE[i % 4], n))
            a = rounded(l)
            a += rounded(cross(exact(vector()), exact(a)))
        (l, foot), (n, d) = line(a), plane(b)
        yield kind, {"a": a, "b": b}, add(foot, scale((d - dot(n, foot)) / dot(n, l), l))


def distance_to_plane():
    for kind, i in each("parallel", "crossing"):
        a, b = lines("plain", i), planes("plain", i)
        if kind == "parallel":
            n, other = whole(9), whole(9)
            a, b[:3] = rounded(cross(exact(n), exact(other))), n
            if not any(a):
                a = [n[1], -n[0], 0.0] if n[0] or n[1] else [1.0, 0.0, 0.0]
            a += rounded(cross(exact(vector()), exact(a)))
        (l, foot), (n, d) = line(a), plane(b)
        assert (kind == "parallel") == (abs(dot(l, n)) < mpf(10) ** -60)
        yield kind, {"a": a, "b": b}, [abs(dot(n, foot) - d) if kind == "parallel" else mpf(0)]


KINDS = ("plain", "close", "antiparallel", "parallel", "far", "meeting", "scaled")


def pairs(*kinds):
    """Kind, numbers of two lines; `same` is one line twice."""
    for kind, i in each(*kinds):
        a, b = lines(kind, i), lines(kind, i + 1)
        if kind in ("close", "antiparallel"):
            b = beside(a[:3], CLOSE[i % 5])
            b = [-c for c in b] if kind == "antiparallel" else b
            b += rounded(cross(exact(vector()), exact(b)))
        elif kind in ("parallel", "same"):
            l, factor = whole(9), (1.0, -1.0, 3.0, -0.5, 7.0, -5.0)[i]
            p, q = whole(99), whole(99)
            other = [factor * c for c in l]
            a = l + rounded(cross(exact(p), exact(l)))
            b = other + rounded(cross(exact(p if kind == "same" else q), exact(other)))
        elif kind == "meeting":
            # Whole numbers: the lines meet in p to the last bit.
            p = whole(99)
            a, b = ([*l, *rounded(cross(exact(p), exact(l)))] for l in (whole(9), whole(9)))
        yield kind, a, b


def perpendicular(a, b):
    """Axis, feet and dual angle of two lines."""
    (l, p), (k, q) = line(a), line(b)
    across = cross(l, k)
    theta = mp.atan2(length(across), dot(l, k))
    if length(across) < mpf(10) ** -60:
        way = sub(q, p)
        d = length(way)
        n = unit(way) if d > mpf(10) ** -60 else None
        return n and pluecker(n, p), [p, q], [theta, d], mpf(1)
    n = unit(across)
    # p + s l + d n = q + t k
    s, t, d = solve([l, scale(-1, k), n], sub(q, p))
    first = add(p, scale(s, l))
    return pluecker(n, first), [first, add(q, scale(t, k))], [theta, d], mpf(0)


def dual_angle():
    for kind, a, b in pairs(*KINDS, "same"):
        yield kind, {"a": a, "b": b}, perpendicular(a, b)[2]


def distance_to_line():
    for kind, a, b in pairs("plain", "close", "parallel", "far"):
        yield kind, {"a": a, "b": b}, [abs(perpendicular(a, b)[2][1])]


def common_perpendicular():
    for kind, a, b in pairs(*KINDS):
        axis, (first, second), angle, parallel = perpendicular(a, b)
        yield kind, {"a": a, "b": b}, axis + first + second + angle + [parallel]


def intersection():
    for kind, a, b in pairs("meeting", "plain", "close"):
        first, second = perpendicular(a, b)[1]
        # Lines that pass each other have a middle as well.
        yield kind, {"a": a, "b": b, "tolerance": 1e6}, scale(mpf(1) / 2, add(first, second))


OPERATIONS = {
    "Line::from_point_direction": from_point_direction,
    "Line::from_points": from_points,
    "Line::try_normalize": normalize_line,
    "Line::is_line": is_line,
    "Line::closest_point_to_origin": closest_point_to_origin,
    "Line::closest_point": closest_point,
    "Line::distance_to_point": distance_to_point,
    "Line::reciprocal_product": reciprocal_product,
    "Plane::from_point_normal": from_point_normal,
    "Plane::from_points": plane_from_points,
    "Plane::from_line_point": plane_from_line_point,
    "Plane::try_normalize": normalize_plane,
    "Plane::signed_distance": signed_distance,
    "Line::from_planes": from_planes,
    "Line::intersection_with_plane": intersection_with_plane,
    "Line::distance_to_plane": distance_to_plane,
    "Line::dual_angle": dual_angle,
    "Line::distance_to_line": distance_to_line,
    "Line::common_perpendicular": common_perpendicular,
    "Line::intersection": intersection,
}
