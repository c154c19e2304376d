"""Rows of quaternions: the 2×2 matrices of `matrices`, and rotation matrices where vectors turn."""

from mpmath import mp, mpf

from .inputs import CLOSE, FEW, axis, each, near_0, parameter, rng, sign, single, vector
from .maps import flat, quat_of, rigid
from .matrices import pauli
from .rotations import matrix, numbers, of_numbers, turn
from .space import add, beside, cross, direction, exact, length, rounded, scale, sub, unit

def raw(q):
    return pauli(mpf(q[0]), exact(q[1:]))


def general(kind):
    size = 10 ** rng.uniform(-12, 12) if kind == "scaled" else 3
    return [single(size * rng.uniform(-1, 1)) for _ in range(4)]


def angle(kind, i):
    near = {"near0": near_0(i), "nearpi": mp.pi - CLOSE[i]}
    return near.get(kind) or mpf(rng.uniform(-3, 3))


def unit_quat(kind, i):
    """One that is nearly unit, either sign."""
    return rounded(numbers(sign() * turn(axis(), angle(kind, i))))


def pair(kind, i):
    a = unit_quat("near0" if kind == "near0" else "plain", i)
    if kind == "near0":
        return a, unit_quat(kind, (i + 1) % FEW)
    by = {"close": CLOSE[i], "nearpi": mp.pi - CLOSE[i]}.get(kind) or mpf(rng.uniform(0.1, 2.9))
    return a, rounded(numbers(sign() * raw(a) * turn(axis(), by)))


def of_two(combine):
    def rows():
        for kind, _ in each("general", "scaled"):
            a, b = general(kind), general(kind)
            yield kind, {"a": a, "b": b}, combine(raw(a), raw(b))

    return rows


def of_one(answer, *kinds):
    def rows():
        for kind, _ in each(*kinds):
            a = general(kind)
            yield kind, {"a": a}, answer(raw(a))

    return rows


def norm(a):
    return mp.sqrt(mp.det(a).real)


def rotate():
    for kind, i in each("plain", "near0", "nearpi"):
        a, p = unit_quat(kind, i), vector(10.0 ** (i - 2))
        yield kind, {"a": a, "p": p}, list(matrix(of_numbers(a)) * mp.matrix(exact(p)))


def way(a, b):
    """a*b or −a*b, of which the scalar part is positive, and its half angle."""
    way = a.H * b
    way = way if numbers(way)[0] > 0 else -way
    w, *xyz = numbers(way)
    assert w > mpf("1e-6"), "half a turn apart"
    return way, xyz, mp.atan2(length(xyz), w)


def angle_to():
    for kind, i in each("plain", "near0", "close", "nearpi"):
        a, b = pair(kind, i)
        yield kind, {"a": a, "b": b}, [2 * way(of_numbers(a), of_numbers(b))[2]]


def slerp(a, b, t):
    _, xyz, half = way(a, b)
    return a * turn(unit(xyz), 2 * half * t)


def nlerp(a, b, t):
    b = b if numbers(a.H * b)[0] > 0 else -b
    mean = (1 - t) * a + t * b
    return mean / norm(mean)


def between(blend):
    def rows():
        for kind, i in each("plain", "near0", "close", "nearpi"):
            (a, b), t = pair(kind, i), parameter()
            yield kind, {"a": a, "b": b, "t": t}, numbers(blend(of_numbers(a), of_numbers(b), mpf(t)))

    return rows


def from_axis_angle():
    for kind, i in each("plain", "near0", "nearpi", "turns"):
        n, by = axis(), single(100 * rng.uniform(-1, 1) if kind == "turns" else angle(kind, i))
        yield kind, {"l": n, "angle": by}, numbers(turn(n, mpf(by)))


def about(index):
    n = [mpf(c == index) for c in range(3)]

    def rows():
        for kind, i in each("plain", "near0", "turns"):
            by = single(100 * rng.uniform(-1, 1) if kind == "turns" else angle(kind, i))
            yield kind, {"angle": by}, numbers(turn(n, mpf(by)))

    return rows


def axis_and_angle(a):
    w, *xyz = numbers(of_numbers(a))
    xyz = xyz if w > 0 else scale(-1, xyz)
    return unit(xyz), 2 * mp.atan2(length(xyz), abs(w))


def to_axis_angle():
    for kind, i in each("plain", "near0", "nearpi"):
        a = unit_quat(kind, i)
        n, by = axis_and_angle(a)
        yield kind, {"a": a}, [*n, by]


def to_scaled_axis():
    for kind, i in each("plain", "near0", "nearpi"):
        a = unit_quat(kind, i)
        n, by = axis_and_angle(a)
        yield kind, {"a": a}, scale(by, n)


def from_scaled_axis():
    for kind, i in each("plain", "near0", "nearpi", "turns"):
        by = 100 * rng.uniform(0, 1) if kind == "turns" else angle(kind, i)
        p = rounded(scale(by, axis()))
        yield kind, {"p": p}, numbers(turn(unit(exact(p)), length(exact(p))))


def from_rotation_arc():
    for kind, i in each("plain", "close", "nearpi", "tiny"):
        p = direction(1e-30 if kind == "tiny" else 10 ** rng.uniform(-3, 3))
        if kind in ("plain", "tiny"):
            q = direction()
        else:
            q = beside(p, CLOSE[i] if kind == "close" else mp.pi - CLOSE[i])
        a, b = unit(exact(p)), unit(exact(q))
        half = unit(add(a, b))
        # Half of the turn takes a to the middle of a and b.
        yield kind, {"p": p, "q": q}, [mp.fdot(a, half), *cross(a, half)]


def looking(forward, up):
    """Forward is z, and up lies in the plane of y and z."""
    z = unit(exact(forward))
    x = unit(cross(exact(up), z))
    y = cross(z, x)
    return mp.matrix([x, y, z]).T


def look(count):
    def rows():
        for kind, i in each("plain", "close", "far"):
            while True:
                eye = vector({"far": 1e4}.get(kind, 1))
                forward = direction(10.0 ** (i - 2))
                target = rounded(add(exact(eye), exact(forward)))
                ahead = sub(exact(target), exact(eye)) if count == 3 else exact(forward)
                up = beside(rounded(ahead), CLOSE[i % 4]) if kind == "close" else direction()
                if length(ahead) > 0:
                    r = looking(ahead, up)
                    if 1 + r[0, 0] + r[1, 1] + r[2, 2] > mpf("0.01") and length(cross(unit(ahead), unit(exact(up)))) > CLOSE[3] / 2:
                        break
            q = quat_of(r)
            if count == 3:
                half = numbers(pauli(0, [mpf(c) / 2 for c in eye]) * pauli(q[0], q[1:]))
                yield kind, {"p": eye, "q": target, "r": up}, q + half
            else:
                yield kind, {"p": forward, "q": up}, q

    return rows


def from_matrix3():
    for kind, r, p, _ in rigid():
        yield kind, {"rows": flat(r)}, numbers(p)


def to_matrix3():
    for kind, i in each("plain", "near0", "nearpi"):
        a = unit_quat(kind, i)
        yield kind, {"a": a}, flat(matrix(of_numbers(a)))


OPERATIONS = {
    "Quat::mul": of_two(lambda a, b: numbers(a * b)),
    "Quat::dot": of_two(lambda a, b: [mp.fdot(numbers(a), numbers(b))]),
    "Quat::norm": of_one(lambda a: [norm(a)], "general", "scaled"),
    "Quat::normalize": of_one(lambda a: numbers(a / norm(a)), "general", "scaled"),
    "Quat::try_normalize": of_one(lambda a: numbers(a / norm(a)), "general", "scaled"),
    "Quat::inverse": of_one(lambda a: numbers(mp.inverse(a)), "general", "scaled"),
    "Quat::rotate": rotate,
    "Quat::angle_to": angle_to,
    "Quat::slerp": between(slerp),
    "Quat::nlerp": between(nlerp),
    "Quat::from_axis_angle": from_axis_angle,
    "Quat::from_rotation_x": about(0),
    "Quat::from_rotation_y": about(1),
    "Quat::from_rotation_z": about(2),
    "Quat::to_axis_angle": to_axis_angle,
    "Quat::to_scaled_axis": to_scaled_axis,
    "Quat::from_scaled_axis": from_scaled_axis,
    "Quat::from_rotation_arc": from_rotation_arc,
    "Quat::look_to": look(2),
    "DualQuat::look_at": look(3),
    "Quat::from_matrix3": from_matrix3,
    "Quat::to_matrix3": to_matrix3,
}
