"""Random motions, and distances from peers."""

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform, Rotation

import dq8


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(18)


@pytest.fixture
def random_motions(rng):
    """Unit dual quaternions from SciPy, with translations of about `size`."""

    def make(*shape: int, size: float = 1.0) -> np.ndarray:
        count = int(np.prod(shape))
        rotations = Rotation.random(count, rng=rng)
        transforms = RigidTransform.from_components(size * rng.normal(size=(count, 3)), rotations)
        return transforms.as_dual_quat().reshape(*shape, 8)

    return make


@pytest.fixture
def close():
    """Whether arrays differ by at most 1e-14·max(1, |t|), the promise for float64."""

    def check(actual, expected, size: float = 1.0) -> None:
        np.testing.assert_allclose(actual, expected, rtol=0, atol=1e-14 * max(1.0, size))

    return check


@pytest.fixture
def one_thread():
    """Leaves the number of threads as it was."""
    before = dq8.get_num_threads()
    yield
    dq8.set_num_threads(before)
