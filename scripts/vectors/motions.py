"""Rows of the algebra, of constructors and of blends: kind, inputs, answer. Inputs that are mpf become text."""

from mpmath import mp, mpf

from .inputs import (
    ALGEBRA, BETWEEN, NEAR_PI, UNIT, angles, any_motions, axis, clusters, parameter, poses, reach, rng, sign, single,
    singles, vector,
)
from .matrices import (
    along, block, dot_real, homogeneous, log, move, numbers, of_numbers, sclerp, star, toward, translation, turn, unit,
    w_positive,
)


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


def small(names, answer):
    """Rows of an operation of reference.jsonl, in its form, for all of NEAR_0: there no angle of near0 exceeds 1e-4."""

    def rows():
        for [a, b] in clusters("near0", 2):
            inputs = {"a": singles(w_positive(a)), "b": singles(b), "t": parameter(), "v": vector(3)}
            inputs = {name: inputs[name] for name in names}
            yield "near0", inputs, answer(unit(inputs["a"]), *(inputs[name] for name in names[1:]))

    return rows


def log_of(a):
    _, *real, _, x, y, z = numbers(log(a))
    return [real, [x, y, z]]


def at(a, v):
    moved = mp.matrix(homogeneous(a)) * mp.matrix([*map(mpf, v), 1])
    return list(moved)[:3]


OPERATIONS = {
    "log": small("a", log_of),
    "pow": small("at", lambda a, t: numbers(along(mp.eye(4), a, mpf(t)))),
    "sclerp": small("abt", lambda a, b, t: numbers(sclerp(a, unit(b), mpf(t)))),
    "matrix": small("a", lambda a: homogeneous(a)[:3]),
    "point": small("av", at),
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
