"""Rows of rotations in other forms: Euler angles.

The truth is in matrices: products of turns about coordinate axes, and the angles of such a product from where it takes the
axes, held to the product of the turns by them.
"""

from mpmath import mp, mpf

from .inputs import NEAR_0, axis, rng, sign, single
from .matrices import PAULI, pauli
from .space import cross, dot, exact, scale

AXES = ["XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX", "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ"]
E = {"X": [1, 0, 0], "Y": [0, 1, 0], "Z": [0, 0, 1]}
ORDERS = [(axes, extrinsic) for extrinsic in (False, True) for axes in AXES]  # as EulerOrder::ALL


def intrinsic(order, values):
    """Axes and values of the turns, each about axes that the ones before have moved."""
    axes, extrinsic = ORDERS[order]
    pairs = list(zip([E[name] for name in axes], values))
    return pairs[::-1] if extrinsic else pairs


def turn(n, angle):
    """cos(θ/2) + n sin(θ/2) as a matrix."""
    return pauli(mp.cos(angle / 2), [mp.sin(angle / 2) * c for c in n])


def product(order, angles):
    first, second, third = (turn(n, mpf(angle)) for n, angle in intrinsic(order, angles))
    return first * second * third


def numbers(p):
    return [p[0, 0].real, -p[1, 0].imag, p[1, 0].real, -p[0, 0].imag]


def of_numbers(q):
    """Of any length but zero."""
    w, *xyz = scale(1 / mp.norm(exact(q)), exact(q))
    return pauli(w, xyz)


def matrix(p):
    """Where conjugation by p takes x, y and z."""
    trace = lambda a: (a[0, 0] + a[1, 1]).real / 2
    return mp.matrix([[trace(r * p * c * p.H) for c in PAULI] for r in PAULI])


def times(r, v):
    return list(r * mp.matrix(v))


def to_quat():
    for order in range(24):
        for kind in ("plain", "near0", "turns"):
            for i in range(2):
                tiny = NEAR_0[(5 * order + i) % 12]
                size = {"plain": 3, "near0": tiny, "turns": 100}[kind]
                angles = [single(size * rng.uniform(-1, 1)) for _ in range(3)]
                yield kind, {"angles": angles, "order": float(order)}, numbers(product(order, angles))


def first_of(r, first, second, third):
    """The angle of the first turn of three, the middle one within its range, from where the third axis goes."""
    moved = times(r, third)
    if first == third:
        return mp.atan2(dot(second, moved), dot(cross(second, first), moved))
    return mp.atan2(dot(cross(first, third), moved), dot(third, moved))


def angles_of(r, order, locked):
    """Angles of a rotation matrix; locked ones have no last turn."""
    (first, _), (second, _), (third, _) = intrinsic(order, [None] * 3)
    proper = first == third
    moved = times(r, third)
    along, across = dot(first, moved), mp.hypot(*(c for c, n in zip(moved, first) if n == 0))
    middle = mp.atan2(across, along) if proper else mp.atan2(dot(first, cross(second, third)) * along, across)
    extrinsic = ORDERS[order][1]
    if locked:
        middle = mp.nint(middle / (mp.pi / 2)) * mp.pi / 2
        turned = matrix(turn(second, middle))
        # What is left is a turn about one axis, the first or the last.
        rest, about = (turned.T * r, third) if extrinsic else (r * turned.T, first)
        i = about.index(1)
        j, k = (i + 1) % 3, (i + 2) % 3
        only = mp.atan2(rest[k, j], rest[j, j])
        return [only, middle, mpf(0)]
    last = first_of(r.T, third, second, first)
    last = mp.atan2(mp.sin(last - mp.pi), mp.cos(last - mp.pi)) if proper else last
    outer = [first_of(r, first, second, third), -last]
    return [outer[1], middle, outer[0]] if extrinsic else [outer[0], middle, outer[1]]


def locked_quat(order, i, tiny):
    """Whole numbers whose first and last axis fall together to the last bit, or but for something tiny."""
    axes, extrinsic = ORDERS[order]
    first, j, last = ("XYZ".index(name) for name in axes)
    w, x = rng.randint(1, 9), rng.choice([-1, 1]) * rng.randint(1, 9)
    q = [0.0] * 4
    if first == last:
        k = 3 - first - j
        q[0], q[1 + first] = (float(w), float(x)) if i % 2 == 0 else (tiny, -tiny)
        q[1 + j], q[1 + k] = (tiny, -tiny) if i % 2 == 0 else (float(w), float(x))
        return q
    # A quarter of a turn about j, and any turn about the first axis.
    quarter = [1.0, 0.0, 0.0, 0.0]
    quarter[1 + j] = 1.0 if i % 2 == 0 else -1.0
    about = [float(w), 0.0, 0.0, 0.0]
    about[1 + first] = float(x)
    a, b = (quarter, about) if extrinsic else (about, quarter)
    xyz = [a[0] * b[1 + c] + b[0] * a[1 + c] + d for c, d in enumerate(cross(a[1:], b[1:]))]
    return [a[0] * b[0] - sum(p * q for p, q in zip(a[1:], b[1:])), *xyz]


def to_euler():
    for order in range(24):
        proper = ORDERS[order][0][0] == ORDERS[order][0][2]
        for kind in ("plain", "plain", "near lock", "near lock", "near lock", "locked", "locked", "nearly locked"):
            i = rng.randint(0, 99)
            if kind in ("locked", "nearly locked"):
                tiny = 10.0 ** -rng.randint(20, 38) if kind == "nearly locked" and proper else 0.0
                a = [single(c) for c in locked_quat(order, i, tiny)]
            elif kind == "near lock":
                delta = sign() * mpf(10) ** -rng.choice([1, 2, 3, 4])
                middle = (mp.pi * (i % 2) - delta * (-1) ** (i % 2) if proper else mp.pi / 2 * (-1) ** i) + (0 if proper else delta)
                angles = [mpf(rng.uniform(-3, 3)), abs(middle) if proper else middle, mpf(rng.uniform(-3, 3))]
                a = [single(c) for c in numbers(product(order, angles))]
            else:
                a = [single(c) for c in numbers(sign() * turn(axis(), mpf(rng.uniform(-3, 3))))]
            r = matrix(of_numbers(a))
            locked = "lock" in kind and kind != "near lock"
            angles = angles_of(r, order, locked)
            off = mp.mnorm(matrix(product(order, angles)) - r)
            assert off < mpf(10) ** (-18 if locked else -60), (kind, order, a, off)
            if max(abs(angles[0]), abs(angles[2])) > mp.pi - mpf("1e-3"):
                continue  # π or −π would be a matter of rounding
            yield kind, {"a": a, "order": float(order)}, [*angles, mpf(locked)]


OPERATIONS = {"EulerAngles::to_quat": to_quat, "Quat::to_euler": to_euler}
