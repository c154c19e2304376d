"""Rows of velocities, twists and Jacobians: twists are the 4×4 real matrices of textbooks, [ω× v; 0 0]."""

from mpmath import mp, mpf

from .distances import pairs
from .inputs import UNIT, angles, axis, parameter, poses, reach, shared, sign, single, singles, vector
from .matrices import PAULI, block, homogeneous, log, numbers, of_numbers, pauli, toward, unit, w_positive

# Beyond half a turn, but not a whole one, where an inverse Jacobian is infinite.
TURNS = (*UNIT, "turns")


def hat(x):
    (wx, wy, wz), (vx, vy, vz) = map(mpf, x[:3]), map(mpf, x[3:])
    return mp.matrix([[0, -wz, wy, vx], [wz, 0, -wx, vy], [-wy, wx, 0, vz], [0, 0, 0, 0]])


def vee(m):
    return [m[2, 1], m[0, 2], m[1, 0], m[0, 3], m[1, 3], m[2, 3]]


def half(x):
    """The same twist for the other matrices: quaternions carry half the angle."""
    return block(pauli(0, [mpf(c) / 2 for c in x[:3]]), pauli(0, [mpf(c) / 2 for c in x[3:]]))


def matrix(m):
    return mp.matrix(homogeneous(m))


def rate(m, change):
    """How the real matrix of m changes, by the product rule on the sandwich and on t = 2qp*."""
    p, q, dp, dq = m[:2, :2], m[:2, 2:], change[:2, :2], change[:2, 2:]
    trace = lambda a: (a[0, 0] + a[1, 1]).real / 2
    moved = numbers(block(2 * (dq * p.H + q * dp.H), mp.zeros(2)))[1:4]
    turned = lambda c: dp * c * p.H + p * c * dp.H
    return mp.matrix([[trace(r * turned(c)) for c in PAULI] + [moved[i]] for i, r in enumerate(PAULI)] + [[0] * 4])


def equal(a, b):
    """A formula with dual quaternions and the real matrices must say the same."""
    assert mp.mnorm(a - b) < mpf(10) ** -50 * (1 + mp.mnorm(b)), "not what the real matrices say"


# Inputs.


def twists(kind):
    for i, angle in enumerate(angles(kind)):
        angle = 2 * angle if kind == "turns" else angle
        yield [single(angle * c) for c in axis()] + vector(reach(kind, i))


def of_twist(x, prefix=""):
    return {prefix + "angular": x[:3], prefix + "linear": x[3:]}


@shared
def posed_twists():
    """Kind, a pose as it is given and as it is meant, and a twist."""
    for kind in TURNS:
        for pose, x in zip(poses(kind), twists(kind)):
            a = singles(pose)
            yield kind, a, unit(a), x


@shared
def directions():
    """Kind, a twist, and the direction in which it changes."""
    for kind in TURNS:
        for x in twists(kind):
            yield kind, x, vector() + vector()


# Rows.


def derivative_spatial():
    for kind, a, s, x in posed_twists():
        change = half(x) * s
        equal(rate(s, change), hat(x) * matrix(s))
        yield kind, {"a": a, **of_twist(x)}, numbers(change)


def derivative_body():
    for kind, a, s, x in posed_twists():
        change = s * half(x)
        equal(rate(s, change), matrix(s) * hat(x))
        yield kind, {"a": a, **of_twist(x)}, numbers(change)


def derivative_from_velocity():
    for kind, a, s, x in posed_twists():
        # Of the velocity of the body's origin, what the turn about the fixed origin does not make.
        v = vee(hat(x) - hat([*x[:3], 0, 0, 0]) * matrix(s))[3:]
        change = half([*x[:3], *v]) * s
        equal(rate(s, change)[:3, 3], mp.matrix(x[3:]))
        yield kind, {"a": a, **of_twist(x)}, numbers(change)


def changes():
    """Poses, and derivatives that are rounded, so that they are not quite those of unit motions."""
    for kind, a, s, x in posed_twists():
        change = singles(half(x) * s)
        yield kind, {"a": a, "derivative": change}, s, of_numbers(change)


def without_scalars(m):
    c = numbers(2 * m)
    return [*c[1:4], *c[5:8]]


def spatial_twist():
    for kind, inputs, s, change in changes():
        yield kind, inputs, without_scalars(change * mp.inverse(s))


def body_twist():
    for kind, inputs, s, change in changes():
        yield kind, inputs, without_scalars(mp.inverse(s) * change)


def velocity():
    """Lanes and scalars tell ṫ on different ways, which agree for derivatives of unit motions: here they are not rounded."""
    for kind, a, s, x in posed_twists():
        change = half(x) * s
        moving = rate(s, change)
        turning = moving[:3, :3] * matrix(s)[:3, :3].T
        w = [(turning[i, j] - turning[j, i]) / 2 for i, j in ((2, 1), (0, 2), (1, 0))]
        yield kind, {"a": a, "derivative": numbers(change)}, [*w, *moving[:3, 3]]


def from_twist():
    for kind in TURNS:
        for x in twists(kind):
            m = mp.expm(half(x))
            equal(matrix(m), mp.expm(hat(x)))
            yield kind, of_twist(x), numbers(m)


# Logarithms take long: every other row.


def to_twist():
    for kind, a, s, _ in posed_twists()[1::2]:
        yield kind, {"a": a}, without_scalars(log(w_positive(s)))


def twist_to():
    for kind, _, inputs, _ in pairs()[1::2]:
        a, b = map(unit, inputs.values())
        yield kind, inputs, without_scalars(log(mp.inverse(a) * toward(a, b)))


def integrate(product):
    def rows():
        for kind, a, s, x in posed_twists():
            dt = single(sign() * parameter())
            step = [mpf(c) * mpf(dt) for c in x]
            yield kind, {"a": a, **of_twist(x), "dt": dt}, numbers(product(mp.expm(half(step)), s))

    return rows


def carried(s, x):
    """Ad_σ ξ"""
    return vee(matrix(s) * hat(x) * mp.inverse(matrix(s)))


def adjoint():
    for kind, a, s, x in posed_twists():
        yield kind, {"a": a, **of_twist(x)}, carried(s, x)


def units():
    return [[int(i == j) for j in range(6)] for i in range(6)]


def coadjoint():
    """Whatever the twist, the power f·v + τ·ω is that in the other frame."""
    for kind, a, s, x in posed_twists():
        force, torque = vector(), x[3:]
        back = mp.inverse(s)
        power = [mp.fdot([*torque, *force], carried(back, e)) for e in units()]
        yield kind, {"a": a, "force": force, "torque": torque}, [*power[3:], *power[:3]]


@shared
def changed_exponentials():
    """The block beside the exponential of [X Y; 0 X] is the derivative of exp at X in direction Y; and exp(−X)."""
    for kind, x, y in directions():
        both = mp.zeros(8)
        both[:4, :4] = both[4:, 4:] = hat(x)
        both[:4, 4:] = hat(y)
        yield kind, directed(x, y), mp.expm(both)[:4, 4:], mp.expm(-hat(x))


def directed(x, y):
    return {**of_twist(x), **of_twist(y, "along_")}


def left_jacobian():
    for kind, inputs, change, back in changed_exponentials():
        yield kind, inputs, vee(change * back)


def right_jacobian():
    for kind, inputs, change, back in changed_exponentials():
        yield kind, inputs, vee(back * change)


def jacobian_inverse(of_sign):
    """exp of [A 1; 0 0] has (eᴬ − 1)/A beside it; A is the bracket with x, or with −x for the right Jacobian."""

    def rows():
        for kind, x, y in directions():
            both = mp.zeros(12)
            both[:6, 6:] = mp.eye(6)
            for i, e in enumerate(units()):
                for j, c in enumerate(vee(hat(x) * hat(e) - hat(e) * hat(x))):
                    both[j, i] = of_sign * c
            yield kind, directed(x, y), list(mp.lu_solve(mp.expm(both)[:6, 6:], mp.matrix([mpf(c) for c in y])))

    return rows


OPERATIONS = {
    "derivative_spatial": derivative_spatial,
    "derivative_body": derivative_body,
    "spatial_twist": spatial_twist,
    "body_twist": body_twist,
    "derivative_from_velocity": derivative_from_velocity,
    "velocity": velocity,
    "from_twist": from_twist,
    "to_twist": to_twist,
    "twist_to": twist_to,
    "integrate_spatial": integrate(lambda step, s: step * s),
    "integrate_body": integrate(lambda step, s: s * step),
    "adjoint": adjoint,
    "coadjoint": coadjoint,
    "left_jacobian": left_jacobian,
    "right_jacobian": right_jacobian,
    "left_jacobian_inverse": jacobian_inverse(1),
    "right_jacobian_inverse": jacobian_inverse(-1),
}
