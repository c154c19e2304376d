"""Rows of 3×3 matrices near rotations, of affine maps, and of rotations with translations.

The polar decomposition is that of the singular values, and poses are 4×4 real matrices.
"""

from mpmath import mp, mpf

from .inputs import CLOSE, FEW, axis, each, near_0, poses, rng, single, singles, size, vector
from .matrices import homogeneous, pauli
from .matrices import unit as unit_motion
from .rotations import matrix, numbers, of_numbers, turn
from .space import add, beside, cross, direction, dot, exact, rounded, scale, unit

def any_turn():
    return turn(axis(), mpf(rng.uniform(-3, 3)))


def quat_of(r):
    """The unit quaternion of a rotation matrix, w > 0, by the eigenvector of eigenvalue 1 and the trace."""
    w = mp.sqrt(1 + r[0, 0] + r[1, 1] + r[2, 2]) / 2
    assert w > mpf("1e-5"), "either sign"
    return [w, *((r[(c + 2) % 3, (c + 1) % 3] - r[(c + 1) % 3, (c + 2) % 3]) / (4 * w) for c in range(3))]


def motion(q, t):
    half = pauli(0, [mpf(c) / 2 for c in t]) * pauli(q[0], q[1:])
    return [*q, *numbers(half)]


def flat(m):
    return [m[i, j] for i in range(m.rows) for j in range(m.cols)]


def square(rows):
    return mp.matrix([exact(rows[3 * i : 3 * i + 3]) for i in range(3)])


def nearest(a):
    """R and S of A = R S, and whether A mirrors; of a flat A the R that does not."""
    u, values, v = mp.svd_r(a)
    mirrors = mp.det(a) < 0 and values[2] > values[0] * mpf(10) ** -60
    if mirrors:
        r = -u * v
    else:
        r = u * mp.diag([1, 1, mp.det(u) * mp.det(v)]) * v
    assert mp.mnorm(r.T * r - mp.eye(3)) < mpf(10) ** -60 and mp.det(r) > 0
    return r, r.T * a, mirrors


STRETCHED = {
    "stretched": lambda i: [1, 10.0 ** -(i % 3), 10.0 ** -(i % 4)],
    "close": lambda i: [1, CLOSE[i % 4], CLOSE[i % 4] / 2],
    "mirror": lambda i: [-1, 0.5 + 0.1 * i, 10.0 ** -(i % 3)],
    "rigid": lambda i: [1, 1, 1],
}


def linear(kind, i):
    """Rows of a matrix."""
    while True:
        if kind in STRETCHED:
            s = mp.diag(STRETCHED[kind](i))
            rows = rounded(flat(matrix(any_turn()) * s * matrix(any_turn())))
        elif kind == "flat":
            a, b = ([float(rng.randint(-9, 9)) for _ in range(3)] for _ in "ab")
            columns = [a, b, [x - y for x, y in zip(a, b)]]
            rows = [columns[c][r] for r in range(3) for c in range(3)]
            if not any(cross(a, b)):
                continue
        else:
            scale_of = {"tiny": 1e-30, "huge": 1e30}.get(kind, size(kind, i))
            rows = [single(scale_of * rng.uniform(-1, 1)) for _ in range(9)]
        with mp.workdps(20):
            u, values, v = mp.svd_r(square(rows))
            trace = sum((u * v)[c, c] for c in range(3)) * mp.det(u) * mp.det(v)
        # Not near half a turn, where the sign of q is rounding; nor where rounding would decide on the mirror.
        wild = kind in ("plain", "tiny", "huge") and values[2] < values[0] / 100
        if 1 + trace > mpf("0.01") and not wild:
            return rows


def polar():
    for kind, i in each("plain", "tiny", "huge", "flat", *STRETCHED):
        rows = linear(kind, i)
        r, s, mirrors = nearest(square(rows))
        yield kind, {"rows": rows}, quat_of(r) + flat(s) + [mpf(mirrors)]


def orthonormal():
    for kind, i in each("plain", "slender", "low", "scaled", "tiny", "huge"):
        x, y, z = (direction({"tiny": 1e-30, "huge": 1e30}.get(kind, 1)) for _ in range(3))
        if kind == "slender":
            y = beside(x, CLOSE[i % 5])
        elif kind == "scaled":
            x, y, z = (rounded(scale(10 ** rng.uniform(-12, 12), exact(c))) for c in (x, y, z))
        a, b = exact(x), exact(y)
        up = unit(cross(a, b))
        if kind == "low":
            z = rounded(add(add(a, scale(mpf("0.3"), b)), scale(CLOSE[i % 4], up)))
        if dot(up, exact(z)) < 0:
            z = [-c for c in z]
        across = [unit(a), cross(up, unit(a)), up]
        rows = [c[r] for r in range(3) for c in (x, y, z)]
        yield kind, {"rows": rows}, [c[r] for r in range(3) for c in across]


def rigid():
    """Turns and translations whose rotation matrices each type rounds, w clearly positive."""
    thirds = [(1, 1, 1), (1, -1, 1), (1, 0, 0), (0, -1, 0), (1, 1, 0)]
    for kind, i in each("plain", "near0", "nearpi", "far", "ties"):
        n, angle = axis(), mpf(rng.uniform(-3, 3))
        if kind == "near0":
            angle = near_0(i)
        elif kind == "nearpi":
            angle = mp.pi - CLOSE[i % 3]
        elif kind == "ties":  # two or more of the four sums of the diagonal agree
            n, angle = unit(exact(thirds[i])), mp.pi * (2 if i < 2 else 1.5) / 3
        p = turn(n, angle)
        yield kind, matrix(p), (p if numbers(p)[0] > 0 else -p), vector(size(kind, i))


TOLERANCE = single(1e-5)


def from_matrix3():
    for kind, r, p, _ in rigid():
        yield kind, {"rows": flat(r), "tolerance": TOLERANCE}, numbers(p)


def from_matrix(last):
    def rows():
        for kind, r, p, t in list(rigid())[:: 1 + len(last)]:
            given = [[*(r[i, j] for j in range(3)), mpf(t[i])] for i in range(3)] + last
            yield kind, {"rows": given, "tolerance": TOLERANCE}, motion(numbers(p), t)

    return rows


def affine(kind, i, linear_kind="plain"):
    """Numbers of the rows of a map."""
    rows, t = linear(linear_kind, i), vector(size(kind, i))
    return [c for i in range(3) for c in (*rows[3 * i : 3 * i + 3], t[i])]


def real(rows12):
    return mp.matrix([exact(rows12[4 * i : 4 * i + 4]) for i in range(3)] + [[0, 0, 0, 1]])


def from_motion():
    for kind in ("plain", "near0", "far"):
        for m in list(poses(kind))[::2]:
            rows = homogeneous(unit_motion(singles(m)))[:3]
            yield kind, {"a": singles(m)}, [c for row in rows for c in row[:3]] + [row[3] for row in rows]


def shear():
    for kind, i in each("plain"):
        s, n = vector(10.0 ** (i % 3 - 1)), vector()
        given = [mpf(r == c) + mpf(s[r]) * mpf(n[c]) for r in range(3) for c in range(3)]
        yield kind, {"s": s, "n": n}, given + [mpf(0)] * 3


def reflection():
    for kind, i in each("plain", "far"):
        n, d = rounded(unit(exact(direction()))), single(size(kind, i) * rng.uniform(-1, 1))
        k = exact(n)
        given = [mpf(r == c) - 2 * k[r] * k[c] for r in range(3) for c in range(3)]
        yield kind, {"a": [*n, d]}, given + scale(2 * mpf(d), k)


def map_of(last):
    def rows():
        for kind, i in each("plain", "far"):
            a, p = affine(kind, i), vector(size(kind, i + 1))
            moved = real(a) * mp.matrix(exact(p) + [last])
            yield kind, {"a": a, "p": p}, list(moved)[:3]

    return rows


def product_of_maps():
    for kind, i in each("plain", "far"):
        a, b = affine(kind, i), affine(kind, i + 1)
        yield kind, {"a": a, "b": b}, flat(real(a) * real(b))[:12]


def decompose():
    for kind, i in each("plain", "far", "flat", *STRETCHED):
        a = affine(kind, i, "plain" if kind == "far" else kind)
        m = real(a)
        r, s, _ = nearest(m[:3, :3])
        yield kind, {"a": a}, motion(quat_of(r), list(m[:3, 3])) + flat(s)


def pose(kind, i):
    """A quaternion that is nearly unit, and a translation."""
    angle = near_0(i) if kind == "near0" else mpf(rng.uniform(-3, 3))
    return rounded(numbers(turn(axis(), angle))) + vector(size(kind, i))


def rigid_of(numbers_of_pose):
    m = mp.eye(4)
    m[:3, :3] = matrix(of_numbers(numbers_of_pose[:4]))
    m[:3, 3] = mp.matrix(exact(numbers_of_pose[4:]))
    return m


def of_poses(count, answer):
    def rows():
        for kind, i in each("plain", "near0", "far"):
            given = [pose(kind, i + k) if i + k < FEW else pose(kind, 0) for k in range(count)]
            yield kind, dict(zip("ab", given)), answer(*given)

    return rows


def product_of_poses(a, b):
    turned = numbers(of_numbers(a[:4]) * of_numbers(b[:4]))
    return turned + list((rigid_of(a) * rigid_of(b))[:3, 3])


def inverse_of_pose(a):
    return numbers(of_numbers(a[:4]).H) + list(mp.inverse(rigid_of(a))[:3, 3])


def pose_of(last):
    def rows():
        for kind, i in each("plain", "near0", "far"):
            a, p = pose(kind, i), vector(size(kind, i + 1))
            yield kind, {"a": a, "p": p}, list(rigid_of(a) * mp.matrix(exact(p) + [last]))[:3]

    return rows


OPERATIONS = {
    "Polar::try_from_matrix3": polar,
    "gram_schmidt": orthonormal,
    "Quat::try_from_matrix3": from_matrix3,
    "DualQuat::try_from_matrix3x4": from_matrix([]),
    "DualQuat::try_from_matrix4": from_matrix([[mpf(0), mpf(0), mpf(0), mpf(1)]]),
    "Affine::from_motion": from_motion,
    "Affine::shear": shear,
    "Affine::reflection": reflection,
    "Affine::transform_point": map_of(mpf(1)),
    "Affine::transform_vector": map_of(mpf(0)),
    "Affine::mul": product_of_maps,
    "Affine::try_decompose": decompose,
    "RotationTranslation::mul": of_poses(2, product_of_poses),
    "RotationTranslation::inverse": of_poses(1, inverse_of_pose),
    "RotationTranslation::transform_point": pose_of(mpf(1)),
    "RotationTranslation::transform_vector": pose_of(mpf(0)),
}
