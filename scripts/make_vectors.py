#!/usr/bin/env python3
"""Known answers for the operations that reference.jsonl leaves out -> tests/vectors/more.jsonl.

    pip install mpmath                       # the only dependency; Python 3.11
    python3 scripts/make_vectors.py          # writes the file (half a minute)
    python3 scripts/make_vectors.py --check  # derives it again, exit 1 if the committed file differs

The truth shares definitions with the crate, not methods. A quaternion is the 2×2 matrix w − i(xX + yY + zZ) with
Pauli's X, Y, Z, and σ = p + εq is the 4×4 matrix [p q; 0 p]. Products, inverses, square roots, logarithms and exponentials are those of
matrices, which know nothing of screws, half angles or dual numbers; rigid matrices are exponentials of skew ones.

One JSON object a line: op, kind, inputs by name, and the answer as text with 20 digits. σ is [pw,px,py,pz, qw,qx,qy,qz].
Inputs are exactly binary32 numbers, so that f32 and f64 start from the same. Only `rows` of from_matrix3x4 and the axis
`l`, `m` of from_screw are text with 20 digits, which each type rounds: rigid ones are no binary32 numbers.
The answers of add, sub, scale, scale_dual, dot, canonical and mul_rotation_translation are those of the inputs as they
stand; all others of the inputs normalized exactly.
"""

import json
import random
import struct
import sys
from pathlib import Path

from mpmath import mp, mpc, mpf

OUT = Path(__file__).resolve().parent.parent / "tests/vectors/more.jsonl"
mp.dps = 80  # an angle of 1e-38 beside a cosine of 1 still has forty digits
NEAR_0 = [mpf(10) ** -e for e in (1, 2, 3, 4, 6, 8, 12, 16, 20, 26, 32, 38)]
NEAR_PI = [mp.pi - mpf(10) ** -e for e in range(1, 10)]
COUNT = 10  # rows of a kind that has no list of its own
PAULI = [mp.matrix([[0, 1], [1, 0]]), mp.matrix([[0, mpc(0, -1)], [mpc(0, 1), 0]]), mp.matrix([[1, 0], [0, -1]])]
rng = random.Random()


# Dual quaternions as matrices.


def pauli(w, xyz):
    return w * mp.eye(2) - mpc(0, 1) * sum((c * s for c, s in zip(xyz, PAULI)), mp.zeros(2))


def block(p, q):
    m = mp.zeros(4)
    m[:2, :2], m[2:, 2:], m[:2, 2:] = p, p, q
    return m


def of_numbers(c):
    return block(pauli(mpf(c[0]), c[1:4]), pauli(mpf(c[4]), c[5:8]))


def numbers(m):
    return [c for p in (m[:2, :2], m[:2, 2:]) for c in (p[0, 0].real, -p[1, 0].imag, p[1, 0].real, -p[0, 0].imag)]


def star(m):
    return block(m[:2, :2].H, m[:2, 2:].H)


def unit(c):
    """The rigid part of the polar decomposition."""
    m = of_numbers(c)
    return m * mp.inverse(mp.sqrtm(star(m) * m))


def turn(axis, angle):
    return block(mp.expm(pauli(0, [angle * n / 2 for n in axis])), mp.zeros(2))


def move(t):
    return block(mp.eye(2), pauli(0, [mpf(c) / 2 for c in t]))


def translation(m):
    return [2 * c for c in numbers(block(m[:2, 2:] * m[:2, :2].H, mp.zeros(2)))[1:4]]


def homogeneous(m):
    p, t = m[:2, :2], translation(m)
    trace = lambda a: (a[0, 0] + a[1, 1]).real / 2
    return [[trace(r * p * c * p.H) for c in PAULI] + [t[i]] for i, r in enumerate(PAULI)] + [[0, 0, 0, 1]]


def log(m):
    """The principal logarithm, of m as it stands and not of -m."""
    # ε → ε/s is an automorphism; with a small q the matrix is nearer to 1, where the logarithm is quicker.
    s = 1 + mp.mnorm(m[:2, 2:])
    small = block(m[:2, :2], m[:2, 2:] / s)
    # mpmath may turn a matrix before it takes its root, which near -1 is another branch: the middle between 1 and m is
    # the root that is meant.
    root = unit(numbers(mp.eye(4) + small))
    with mp.workdps(60):  # of the answer; on the way mpmath takes three times as many
        half = mp.logm(root)
    assert mp.mnorm(mp.expm(2 * half) - small) < mpf(10) ** -50
    return block(2 * half[:2, :2], 2 * half[:2, 2:] * s)


def along(a, b, t):
    return a * mp.expm(mpf(t) * log(mp.inverse(a) * b))


def dot_real(a, b):
    return mp.fdot(numbers(a)[:4], numbers(b)[:4])


def toward(a, b):
    """Of ±b the one on the side of a; no row may leave that to rounding."""
    assert abs(dot_real(a, b)) > mpf("0.01"), "half a turn apart"
    return b if dot_real(a, b) > 0 else -b


def sclerp(a, b, t):
    return along(a, toward(a, b), t)


def w_positive(m):
    return -m if numbers(m)[0] < 0 else m


# Inputs.


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


def parameter():
    return single(rng.random())


# Rows: kind, inputs, answer. Inputs that are mpf become text.

UNIT = ("plain", "near0", "nearpi", "far", "translation")
BETWEEN = (*UNIT, "close")
ALGEBRA = ("general", "far")


def from_screw():
    for kind in ("plain", "near0", "nearpi", "far", "translation", "turns"):
        for i, angle in enumerate(angles(kind)):
            angle = mpf(single(angle * 10 if kind == "turns" else angle))
            l, point, slide = axis(), vector(reach(kind, i)), vector(reach(kind, i))[0]
            if kind == "near0" and i % 2 == 0:  # so far away that the tiny turn moves by something
                point = [c / angle for c in point]
            m = [0] * 3 if angle == 0 else cross(point, l)
            back = [-c for c in point]
            truth = move(point) * turn(l, angle) * move(back) * move([slide * c for c in l])
            yield kind, {"l": l, "m": m, "angle": float(angle), "slide": slide}, numbers(truth)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def from_matrix3x4():
    turns = [(kind, i, axis(), angle) for kind in UNIT for i, angle in enumerate(angles(kind))]
    # Two or more of the four sums of the diagonal agree.
    ties = [((1, 1, 1), 2 / mpf(3)), ((1, 0, 0), 0.5), ((0, -1, 0), 0.5), ((0, 0, 1), 0.5), ((1, 1, 1), 1)]
    ties += [(n, 1) for n in ((1, 1, 0), (1, 0, -1), (0, 1, 1), (-1, 1, 0), (0, 1, 0))]
    turns += [("ties", i, [c / mp.norm(n) for c in n], part * mp.pi) for i, (n, part) in enumerate(ties)]
    for kind, i, n, angle in turns:
        t = vector(reach(kind, i))
        x, y, z = (angle * c for c in n)
        r = mp.expm(mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]]))
        rows = [[r[i, j] for j in range(3)] + [mpf(t[i])] for i in range(3)]
        yield kind, {"rows": rows}, numbers(w_positive(move(t) * turn(n, angle)))


def to_matrix4():
    for kind in UNIT:
        for m in poses(kind):
            yield kind, {"a": singles(m)}, homogeneous(unit(singles(m)))


def transform_plane():
    for kind in UNIT:
        for i, m in enumerate(poses(kind)):
            n, offset = vector(), single(10 * rng.uniform(-1, 1))
            inverse = mp.inverse(mp.matrix(homogeneous(unit(singles(m)))))
            *moved, minus_offset = mp.matrix([[*map(mpf, n), -mpf(offset)]]) * inverse
            yield kind, {"a": singles(m), "n": n, "offset": offset}, [*moved, -minus_offset]


def from_translation_rotation():
    for kind in UNIT[:-1]:
        for i, pose in enumerate(poses(kind)):
            r, t = singles(pose)[:4], vector(reach(kind, i))
            yield kind, {"t": t, "r": r}, numbers(unit([*r, 0, 0, 0, 0]) * move(t))


def mul_rotation_translation():
    for kind in (*UNIT, "general"):
        others = poses("plain" if kind == "general" else kind)
        for i, ([a], pose) in enumerate(zip(any_motions(kind, 1), others)):
            r, t = singles(pose)[:4], vector(reach(kind, i))
            inputs = {"a": a, "r": r, "t": t}
            yield kind, inputs, numbers(of_numbers(a) * move(t) * of_numbers([*r, 0, 0, 0, 0]))


def sqrt():
    for kind in UNIT:
        for m in poses(kind):
            yield kind, {"a": singles(m)}, numbers(mp.sqrtm(w_positive(unit(singles(m)))))


def sclerp_long():
    pairs = [(kind, a, toward(a, b)) for kind in BETWEEN if kind != "nearpi" for a, b in clusters(kind, 2)]
    far_apart = [(a, b) for a, b in clusters("plain", 2) if dot_real(a, b) ** 2 < 0.9]
    pairs += [("long", a, -toward(a, b)) for a, b in far_apart]
    apart = [("nearpi", sign() * angle, 1) for angle in NEAR_PI]
    # The last bit of a whole turn: an axis is left of the difference. They slide as little as they lack in turning, or
    # the way would be long.
    apart += [("opposite", 2 * mp.pi - 10.0**-e, 10.0**-e) for e in (1, 1, 1, 2, 2, 2, 3, 3, 3, 4)]
    for (kind, angle, slide), a in zip(apart, 2 * list(poses("plain"))):
        pairs.append((kind, a, a * move(vector(slide)) * turn(axis(), angle)))
    for kind, a, b in pairs:
        inputs = {"a": singles(a), "b": singles(b), "t": parameter()}
        yield kind, inputs, numbers(along(unit(inputs["a"]), unit(inputs["b"]), inputs["t"]))


def between(blend):
    def rows():
        for kind in BETWEEN:
            for a, b in any_motions(kind, 2):
                t = parameter()
                yield kind, {"a": a, "b": b, "t": t}, numbers(blend(unit(a), unit(b), mpf(t)))

    return rows


def nlerp(a, b, t):
    return unit(numbers((1 - t) * a + t * toward(a, b)))


def slerp_lerp(a, b, t):
    moved = [(1 - t) * start + t * end for start, end in zip(translation(a), translation(b))]
    # Without q the screw is a turn.
    return move(moved) * sclerp(block(a[:2, :2], mp.zeros(2)), block(b[:2, :2], mp.zeros(2)), t)


def squad():
    for kind in BETWEEN:
        for cluster in any_motions(kind, 4):
            (a, b, c, d), t = map(unit, cluster), parameter()
            path = sclerp(sclerp(a, d, t), sclerp(b, c, t), 2 * mpf(t) * (1 - mpf(t)))
            yield kind, dict(zip("abcd", cluster), t=t), numbers(path)


def squad_control():
    for kind in BETWEEN:
        for cluster in any_motions(kind, 3):
            a, b, c = map(unit, cluster)
            logs = sum((log(mp.inverse(b) * toward(b, m)) for m in (a, c)), mp.zeros(4))
            yield kind, dict(zip("abc", cluster)), numbers(b * mp.expm(-logs / 4))


def of_two(combine):
    def rows():
        for kind in ALGEBRA:
            for a, b in any_motions(kind, 2):
                yield kind, {"a": a, "b": b}, combine(of_numbers(a), of_numbers(b))

    return rows


def dot(a, b):
    twice = numbers(a * star(b) + b * star(a))
    return [twice[0] / 2, twice[4] / 2]


def scaled(dual):
    def rows():
        for kind in (*ALGEBRA, "scaled"):
            for [a] in any_motions(kind, 1):
                size = 10 ** rng.uniform(-12, 12) if kind == "scaled" else 3
                factor = [single(size * rng.uniform(-1, 1)) for _ in range(1 + dual)]
                of_factor = block(mpf(factor[0]) * mp.eye(2), mpf(factor[-1] if dual else 0) * mp.eye(2))
                yield kind, {"a": a, "factor": factor}, numbers(of_factor * of_numbers(a))

    return rows


def canonical():
    for kind in ("general", "nearpi"):
        for [a] in any_motions(kind, 1):
            yield kind, {"a": a}, [mpf(c) if a[0] >= 0 else -mpf(c) for c in a]


OPERATIONS = {
    "from_screw": from_screw,
    "from_matrix3x4": from_matrix3x4,
    "to_matrix4": to_matrix4,
    "transform_plane": transform_plane,
    "from_translation_rotation": from_translation_rotation,
    "mul_rotation_translation": mul_rotation_translation,
    "sqrt": sqrt,
    "sclerp_long": sclerp_long,
    "nlerp": between(nlerp),
    "slerp_lerp": between(slerp_lerp),
    "squad": squad,
    "squad_control": squad_control,
    "dot": of_two(dot),
    "add": of_two(lambda a, b: numbers(a + b)),
    "sub": of_two(lambda a, b: numbers(a - b)),
    "scale": scaled(False),
    "scale_dual": scaled(True),
    "canonical": canonical,
}


def text(value):
    """What is not exactly binary32 as text; what is only noise beside a number of size 1 as zero."""
    if isinstance(value, list):
        return [text(v) for v in value]
    return value if isinstance(value, float) else mp.nstr(mp.chop(mpf(value), tol=mpf(10) ** -62), 20)


def lines():
    for op, rows in OPERATIONS.items():
        rng.seed(op)  # so that its rows do not depend on those before it
        for kind, inputs, out in rows():
            numbers_of_row = {name: text(value) for name, value in {**inputs, "out": out}.items()}
            yield json.dumps({"op": op, "kind": kind, **numbers_of_row}, separators=(",", ":")) + "\n"


if __name__ == "__main__":
    made = "".join(lines())
    if "--check" in sys.argv[1:]:
        sys.exit(0 if OUT.read_text("utf-8") == made else f"{OUT} is not what {Path(__file__).name} derives")
    OUT.write_text(made, "utf-8")
