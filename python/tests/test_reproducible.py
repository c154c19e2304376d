"""`set_reproducible`: the same bits on every machine, with lanes of its own (the feature `reproducible`) or with SSE2."""

import hashlib

import numpy as np
import pytest
from robots import ROBOTS

import dq8


def results(dtype):
    """Of numbers that are the same everywhere."""
    n = 1000
    x = ((np.arange(21 * n) * 7919 % 2003 - 1001) / 1024).astype(dtype)
    a = dq8.normalize(x[: 8 * n].reshape(n, 8))
    b = dq8.normalize(x[8 * n : 16 * n].reshape(n, 8))
    t, points = x[16 * n : 17 * n], x[17 * n : 20 * n].reshape(n, 3)
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
    values = x[: len(arm.values) * n].reshape(n, -1)
    yield dq8.mul(a, b)
    yield dq8.mul(a[0], b)
    yield dq8.nlerp(a, b, t)
    yield dq8.sclerp(a, b, t)
    yield dq8.log(a)[..., [0, 1, 2, 4, 5, 6]]
    yield dq8.transform_points(a, points)
    yield dq8.chain_products(a)
    yield dq8.Hierarchy([-1, 0, 1, 1]).local_to_model(a.reshape(-1, 4, 8))
    yield arm.poses(values)
    yield arm.jacobian(values, arm.links[-1], "world")


@pytest.mark.parametrize(("dtype", "bits"), [("float32", "1eccf9b32928424e"), ("float64", "3396da6c7a21533b")])
def test_the_bits_are_those_of_every_machine(dtype, bits):
    fused = dq8.backend()
    dq8.set_reproducible(True)
    try:
        assert dq8.backend() in {"portable", f"{fused}, unfused"}
        found = hashlib.sha256()
        for result in results(dtype):
            found.update(result.astype(result.dtype.newbyteorder("<")).tobytes())
    finally:
        dq8.set_reproducible(False)
    assert dq8.backend() == fused
    assert found.hexdigest()[:16] == bits
