"""Rows of dual numbers: f(a + εb) = f(a) + εb f'(a), with derivatives that mpmath takes by differences at many more digits.

Products and quotients are those of the matrices [a b; 0 a].
"""

from mpmath import mp, mpf

from .inputs import FEW, each, near_0, rng, sign, single
from .space import exact

def of_matrix(m):
    return [m[0, 0], m[0, 1]]


def matrix(a):
    return mp.matrix([[mpf(a[0]), mpf(a[1])], [0, mpf(a[0])]])


def slope(f, x):
    """f'(x) by a central difference with a step of 10⁻⁴⁵ |x|, whose error is of the order of the square of that."""
    x = mpf(x)
    with mp.workdps(200):
        step = (abs(x) if x else 1) * mpf(10) ** -45
        found = (f(x + step) - f(x - step)) / (2 * step)
    return +found


def numbers(kind, i):
    """Real parts of a kind."""
    return {
        "plain": lambda: rng.uniform(0.1, 3),
        "near0": lambda: float(near_0(i)),
        "large": lambda: 10 ** (i + 1) * rng.uniform(0.1, 0.9),
        "near1": lambda: 1 - 10.0 ** -(i + 1),
        "tiny": lambda: 10.0 ** (-30 - i),
        "huge": lambda: 10.0 ** (30 + i),
        "steep": lambda: 15.0 * (i + 1),
    }[kind]()


def dual(kind, i):
    return [single(numbers(kind, i)), single(rng.uniform(-3, 3))]


def signed(a):
    return [sign() * a[0], a[1]]


def function(f, *kinds, positive=False):
    def rows():
        for kind, i in each(*kinds):
            a = dual(kind, i)
            a = a if positive else signed(a)
            yield kind, {"a": a}, [f(mpf(a[0])), mpf(a[1]) * slope(f, a[0])]

    return rows


def of_two(combine, *kinds):
    def rows():
        for kind, i in each(*kinds):
            a, b = (signed(dual(kind, (i + k) % FEW)) for k in (0, 2))
            if kind in ("tiny", "huge"):
                a[1], b[1] = (single(d * x) for x, d in (a, b))
            yield kind, {"a": a, "b": b}, combine(a, b)

    return rows


def inverse_rows():
    for kind, i in each("plain", "tiny", "huge"):
        a = signed(dual(kind, i))
        a[1] = single(a[1] * a[0])  # 1/a² is beyond f32
        yield kind, {"a": a}, of_matrix(mp.inverse(matrix(a)))


def powi():
    for n in (-5, -1, 0, 2, 3, 13):
        for i in range(3):
            a = signed(dual("plain", i))
            yield "plain", {"a": a, "n": float(n)}, of_matrix(matrix(a) ** n)


def atan2(a, b):
    (y, dy), (x, dx) = exact(a), exact(b)
    return [mp.atan2(y, x), slope(lambda s: mp.atan2(y + s * dy, x + s * dx), 0)]


OPERATIONS = {
    "Dual::mul": of_two(lambda a, b: of_matrix(matrix(a) * matrix(b)), "plain", "near1"),
    "Dual::div": of_two(lambda a, b: of_matrix(matrix(a) * mp.inverse(matrix(b))), "plain", "near1", "tiny", "huge"),
    "Dual::recip": inverse_rows,
    "Dual::inverse": inverse_rows,
    "Dual::powi": powi,
    "Dual::sqrt": function(mp.sqrt, "plain", "near1", "tiny", "huge", positive=True),
    "Dual::sin": function(mp.sin, "plain", "near0", "large"),
    "Dual::cos": function(mp.cos, "plain", "near0", "large"),
    "Dual::tan": function(mp.tan, "plain", "near0", "large"),
    "Dual::asin": function(mp.asin, "near0", "near1"),
    "Dual::acos": function(mp.acos, "near0", "near1"),
    "Dual::atan": function(mp.atan, "plain", "near0", "large"),
    "Dual::atan2": of_two(atan2, "plain", "near0", "tiny", "huge"),
    "Dual::exp": function(mp.exp, "plain", "near0", "steep"),
    "Dual::ln": function(mp.ln, "plain", "near1", "tiny", "huge", positive=True),
}
