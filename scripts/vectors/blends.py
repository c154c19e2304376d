"""Rows of blends and means of several motions: kind, inputs `s` with the weights `w`, answer."""

from mpmath import mp, mpf

from .inputs import BETWEEN, COUNT, NEAR_0, angles, axis, clusters, poses, reach, rng, sign, single, singles, uniform, vector
from .matrices import block, dot_real, numbers, pauli, toward, unit


def weight():
    return single(rng.uniform(0.1, 1))


def running_sum(motions, weights):
    """Each on the side of the sum so far, and whether that is the side of the first for every one of them."""
    total, like_first = mpf(weights[0]) * motions[0], True
    for motion, w in zip(motions[1:], weights[1:]):
        turned = toward(total, motion)
        like_first &= dot_real(motions[0], turned) > 0
        total += mpf(w) * turned
    return total, like_first


def spread():
    """Poses all around: one of them at least is on the side of the sum so far, and not on that of the first."""
    pool, made = [sign() * m for m in poses("plain")], 0
    while made < COUNT:
        chosen = rng.sample(pool, 4)
        try:
            _, like_first = running_sum(chosen, [1] * 4)
        except AssertionError:  # half a turn apart
            continue
        if not like_first:
            made += 1
            yield chosen


def dlb_running():
    for kind in (*BETWEEN, "spread"):
        for i, drawn in enumerate(spread() if kind == "spread" else clusters(kind, 4)):
            motions = [singles(m) for m in drawn[: 4 if kind == "spread" else 2 + i % 3]]
            # Those all around are what they are for equal weights.
            weights = [1.0 if kind == "spread" else weight() for _ in motions]
            total, _ = running_sum([unit(c) for c in motions], weights)
            yield kind, {"s": motions, "w": weights}, numbers(unit(numbers(total)))


def screw(kind, i):
    """A logarithm of a kind, as a pair of vectors: at most 0.65 rad of half an angle."""
    half = {"near0": NEAR_0[i % len(NEAR_0)], "translation": mpf(0), "close": mpf(10) ** -(i % 7 + 1)}.get(kind, uniform(0, 0.65))
    size = 10.0 ** -(i % 7 + 1) if kind == "close" else reach(kind, i)
    return mp.matrix([half * c for c in axis()] + [mpf(c) for c in vector(size)])


def dib():
    """The mean comes first: b is that of all b exp(xᵢ) whose weighted xᵢ cancel. They are no binary32 numbers."""
    for kind in BETWEEN:
        for i, b in enumerate(poses("plain" if kind == "close" else kind)):
            others = 1 + i % 3
            logs, weights = [screw(kind, i) for _ in range(others)], [weight() for _ in range(others)]
            # It weighs no less than the others together, so that its screw is no longer than theirs.
            last = single(2 * sum(weights))
            logs.append(-sum((mpf(w) * x for w, x in zip(weights, logs)), mp.zeros(6, 1)) / mpf(last))
            motions = [sign() * b * mp.expm(block(pauli(0, x[:3]), pauli(0, x[3:]))) for x in logs]
            yield kind, {"s": [numbers(m) for m in motions], "w": [*weights, last]}, numbers(b)


OPERATIONS = {"dlb_running": dlb_running, "dib": dib}
