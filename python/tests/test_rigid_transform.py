"""`RigidTransform` where it says that it differs from SciPy's; the rest is tested by SciPy's own tests."""

import pickle

import numpy as np
import pytest
from scipy.spatial.transform import RigidTransform as Theirs
from scipy.spatial.transform import Rotation

import dq8
from dq8 import RigidTransform


def test_every_method_of_scipy_is_there():
    for name in dir(Theirs):
        if not name.startswith("_"):
            assert hasattr(RigidTransform, name), name


def test_float32_stays_float32(random_motions):
    single = random_motions(5).astype(np.float32)
    transform = RigidTransform.from_dual_quat(single)
    for result in (
        transform,
        transform * transform,
        transform**0.5,
        transform.inv(),
        transform[1:],
        transform.mean(),
        RigidTransform.from_matrix(transform.as_matrix()),
        RigidTransform.from_exp_coords(transform.as_exp_coords()),
        RigidTransform.concatenate([transform, transform]),
    ):
        assert result.dtype == np.float32
    assert transform.apply([1, 2, 3]).dtype == np.float32
    assert transform.translation.dtype == np.float32
    assert transform.astype(np.float64).dtype == np.float64
    with pytest.raises(TypeError, match="float64 or float32"):
        transform.astype(int)


def test_leading_dimensions_and_exponents_broadcast(random_motions):
    a, b = RigidTransform.from_dual_quat(random_motions(3, 1)), RigidTransform.from_dual_quat(random_motions(4))
    assert (a * b).shape == (3, 4)
    assert (b ** np.linspace(0, 1, 4)).shape == (4,)
    assert (b[0] ** np.linspace(0, 1, 5)).shape == (5,)


def test_out_is_written(random_motions, rng):
    transform, points = RigidTransform.from_dual_quat(random_motions(5)), rng.normal(size=(5, 3))
    expected = transform.apply(points)
    assert transform.apply(points, out=points) is points
    np.testing.assert_array_equal(points, expected)
    motions = np.empty((5, 8))
    assert transform.as_dual_quat(scalar_first=True, out=motions) is motions
    np.testing.assert_array_equal(motions, transform.motions[:, [3, 0, 1, 2, 7, 4, 5, 6]])
    # Even over the transform itself.
    transform.as_dual_quat(scalar_first=True, out=transform.motions)
    np.testing.assert_array_equal(transform.motions, motions)


def test_indices_do_not_reach_into_the_eight_numbers():
    transform = RigidTransform.identity(shape=(3, 4))
    assert transform[1, 2].single
    assert transform[..., 0].shape == (3,)
    assert transform[:, None].shape == (3, 1, 4)
    for indexer in ((0, 0, 0), (..., 0, 0, 0)):
        with pytest.raises(IndexError):
            transform[indexer]


def test_parts_are_copies():
    transform = RigidTransform.identity(3)
    part = transform[:2]
    part[0] = RigidTransform.from_translation([1, 2, 3])
    next(iter(transform)).motions[:] = 0
    np.testing.assert_array_equal(transform.as_matrix(), RigidTransform.identity(3).as_matrix())


def test_chains_of_products_stay_rigid(random_motions):
    step = RigidTransform.from_dual_quat(random_motions())
    pose = step
    for _ in range(1000):
        pose = pose * step
    p, q = pose.motions[:4], pose.motions[4:]
    assert abs(np.linalg.norm(p) - 1) < 1e-15 * 4
    assert abs(p @ q) < 1e-15 * max(1, np.linalg.norm(q)) * 4


def test_a_mean_of_one_axis_is_that_of_scipy(random_motions, rng):
    motions, weights = random_motions(4, 5, 6), rng.random((4, 5, 6))
    for axis in (None, 0, 1, -1, (0, 2), ()):
        own = RigidTransform.from_dual_quat(motions).mean(weights, axis)
        theirs = Theirs.from_dual_quat(motions).mean(weights, axis)
        np.testing.assert_allclose(own.as_matrix(), theirs.as_matrix(), rtol=0, atol=1e-13)
    with pytest.raises(ValueError, match="out of bounds"):
        RigidTransform.identity(3).mean(axis=1)
    with pytest.raises(ValueError, match="empty"):
        RigidTransform.identity(0).mean()


def test_rotations_that_are_none_by_little_become_the_nearest(rng):
    # SciPy orthogonalizes by the same decomposition.
    matrix = Theirs.from_rotation(Rotation.random(6, rng=rng)).as_matrix()
    matrix[:4, :3, :3] += 0.1 * rng.normal(size=(4, 3, 3))
    own, theirs = RigidTransform.from_matrix(matrix), Theirs.from_matrix(matrix)
    np.testing.assert_allclose(own.as_matrix(), theirs.as_matrix(), rtol=0, atol=1e-14)


def test_what_is_not_real_is_refused():
    with pytest.raises(TypeError, match="`matrix`.*complex"):
        RigidTransform.from_matrix(np.eye(4, dtype=complex))
    with pytest.raises(ValueError, match=r"`exp_coords` to have shape \(\.\.\., 6\), got \(5,\)"):
        RigidTransform.from_exp_coords(np.zeros(5))
    with pytest.raises(ValueError, match=r"`dual_quat` to have shape \(\.\.\., 8\), got \(7,\)"):
        RigidTransform.from_dual_quat(np.zeros(7))


def test_pickles_keep_every_bit(random_motions):
    transform = RigidTransform.from_dual_quat(random_motions(5).astype(np.float32))
    again = pickle.loads(pickle.dumps(transform))
    np.testing.assert_array_equal(again.motions, transform.motions)
    assert again.dtype == np.float32


def test_motions_are_the_memory_of_the_transform():
    transform = RigidTransform.identity(2)
    transform.motions[1] = dq8.from_translation([1.0, 2.0, 3.0])
    np.testing.assert_array_equal(transform[1].translation, [1, 2, 3])
