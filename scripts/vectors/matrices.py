"""Dual quaternions as matrices, and rigid motions as the matrices that everybody else writes.

A quaternion is the 2×2 matrix w − i(xX + yY + zZ) with Pauli's X, Y, Z, and σ = p + εq is the 4×4 matrix [p q; 0 p].
"""

from mpmath import mp, mpc, mpf

mp.dps = 80  # an angle of 1e-38 beside a cosine of 1 still has forty digits
PAULI = [mp.matrix([[0, 1], [1, 0]]), mp.matrix([[0, mpc(0, -1)], [mpc(0, 1), 0]]), mp.matrix([[1, 0], [0, -1]])]


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
