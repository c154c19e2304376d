"""Random motions, and distances from peers."""

import functools

import numpy as np
import pytest
from calls import motions

import dq8


def pytest_addoption(parser):
    parser.addoption("--rows", type=int, default=200_000, help="how many rows go from Parquet to Parquet")


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(18)


@pytest.fixture
def random_motions(rng):
    """Motions of a shape, with translations of about a `size`."""
    return functools.partial(motions, rng)


def longest(array) -> float:
    """The longest translation of motions or matrices, the longest of other vectors."""
    array = np.asarray(array)
    if array.shape[-1:] == (8,):
        array = 2 * array[..., 4:]
    elif array.shape[-2:] == (4, 4):
        array = array[..., :3, 3]
    return np.linalg.norm(array, axis=-1).max(initial=0)


@pytest.fixture(scope="session")
def close():
    """Whether arrays differ by at most 1e-14·max(1, |t|), the promise for float64, |t| the longest of what was given.

    By `bound` in the place of 1e-14 where a test says why.
    """

    def check(actual, expected, *given, bound: float = 1e-14) -> None:
        size = max([1.0, *map(longest, given)])
        np.testing.assert_allclose(actual, expected, rtol=0, atol=bound * size)

    return check


@pytest.fixture
def one_thread():
    """Leaves the number of threads as it was."""
    before = dq8.get_num_threads()
    yield
    dq8.set_num_threads(before)
