"""Rows of dual vectors, screws, twists and wrenches, and of a limb of two bones."""

from mpmath import mp, mpf

from .inputs import each, rng, single, vector
from .maps import quat_of
from .matrices import pauli
from .rotations import numbers, turn
from .space import add, cross, direction, dot, exact, length, rounded, scale, sub, unit

def dual_vector(kind, i):
    return vector(10.0 ** (i % 3 - 1)) + vector({"far": 1e4}.get(kind, 1))


def skew(a):
    x, y, z = exact(a)
    return mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def of_dual_vectors(combine):
    def rows():
        for kind, i in each("plain", "far"):
            a, b = dual_vector(kind, i), dual_vector(kind, i + 1)
            yield kind, {"a": a, "b": b}, combine(a, b)

    return rows


def dual_cross(a, b):
    """The product of the skew matrices of dual numbers, [A B; 0 A], with a vector."""
    both = mp.zeros(6)
    both[:3, :3] = both[3:, 3:] = skew(a[:3])
    both[3:, :3] = skew(a[3:])
    return list(both * mp.matrix(exact(b)))


def dual_dot(a, b):
    p, q, r, s = exact(a[:3]), exact(a[3:]), exact(b[:3]), exact(b[3:])
    return [dot(p, r), dot(p, s) + dot(q, r)]


def scale_dual():
    for kind, i in each("plain", "far"):
        a, s = dual_vector(kind, i), [single(rng.uniform(-3, 3)) for _ in range(2)]
        p, q = exact(a[:3]), exact(a[3:])
        yield kind, {"a": a, "s": s}, scale(mpf(s[0]), p) + add(scale(mpf(s[0]), q), scale(mpf(s[1]), p))


def pitch():
    for kind, i in each("plain"):
        angle, slide = single(rng.uniform(0.1, 3) * 10.0 ** -(2 * i)), single(rng.uniform(-9, 9))
        l = direction()
        yield kind, {"a": [*l, *vector(), angle, slide]}, [mpf(slide) / mpf(angle)]


def velocity_at():
    """What the 4×4 matrix [ω× v; 0 0] makes of a point."""
    for kind, i in each("plain", "far"):
        a, p = dual_vector("plain", i), vector({"far": 1e4}.get(kind, 1))
        m = mp.zeros(4)
        m[:3, :3], m[:3, 3] = skew(a[:3]), mp.matrix(exact(a[3:]))
        yield kind, {"a": a, "p": p}, list(m * mp.matrix(exact(p) + [1]))[:3]


def power():
    for kind, i in each("plain", "far"):
        a, b = dual_vector(kind, i), dual_vector("plain", i + 1)
        yield kind, {"a": a, "b": b}, [dot(exact(a[:3]), exact(b[3:])) + dot(exact(a[3:]), exact(b[:3]))]


def reach():
    """The triangle of the bones by the law of cosines; at many digits nothing is lost where it is flat."""
    for kind, i in each("plain", "flat", "bent", "far", "stretched", "folded"):
        while True:
            bones = [single(rng.uniform(0.3, 2)) for _ in "ab"]
            a, b = exact(bones)
            near, most = abs(a - b), a + b
            d = {
                "flat": most - mpf(10) ** -(i + 1), "bent": near + mpf(10) ** -(i + 1),
                "stretched": most * 1.5, "folded": near / 2,
            }.get(kind) or near + (most - near) * mpf(rng.uniform(0.2, 0.8))
            root = vector({"far": 1e3}.get(kind, 1))
            target, pole = rounded(add(exact(root), scale(d, unit(exact(direction()))))), direction()
            way = sub(exact(target), exact(root))
            wanted = length(way)
            x = unit(way) if wanted else None
            across = x and sub(exact(pole), scale(dot(x, exact(pole)), x))
            if not x or length(across) < 0.1 or (near > wanted) != (kind == "folded") or (wanted > most) != (kind == "stretched"):
                continue
            y = scale(-1, unit(across))
            r = mp.matrix([x, y, cross(x, y)]).T
            if 1 + r[0, 0] + r[1, 1] + r[2, 2] < mpf("0.01"):
                continue
            break
        d = min(max(wanted, near), most)
        # The angle at the root, and how far the knee is from straight.
        clip = lambda c: min(max(c, mpf(-1)), mpf(1))
        at_root = mp.acos(clip((a * a + d * d - b * b) / (2 * a * d))) if d else mpf(0)
        bend = mp.pi - mp.acos(clip((a * a + b * b - d * d) / (2 * a * b)))
        q = quat_of(r)
        frame, z = pauli(q[0], q[1:]), [0, 0, 1]
        upper, lower = frame * turn(z, -at_root), frame * turn(z, bend - at_root)
        given = {"p": root, "lengths": bones, "q": target, "r": pole}
        yield kind, given, numbers(upper) + numbers(lower) + [bend, abs(wanted - d)]


OPERATIONS = {
    "DualVector::cross": of_dual_vectors(dual_cross),
    "DualVector::dot": of_dual_vectors(dual_dot),
    "DualVector::scale_dual": scale_dual,
    "Screw::pitch": pitch,
    "Twist::velocity_at": velocity_at,
    "Wrench::dot": power,
    "TwoBone::reach": reach,
}
