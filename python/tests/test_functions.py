"""Every function against SciPy and pytransform3d, or against its formula in NumPy."""

import numpy as np
import pytest
import pytransform3d.trajectories as p3t
import pytransform3d.transformations as p3d
from scipy.spatial.transform import RigidTransform, Rotation

import dq8

FIRST = [3, 0, 1, 2, 7, 4, 5, 6]
LAST = [1, 2, 3, 0, 5, 6, 7, 4]
# A register is left half empty, and then there are several.
COUNTS = [1, 3, 4, 21]


def scipy_of(motions) -> RigidTransform:
    return RigidTransform.from_dual_quat(motions)


def same_motion(actual, expected, atol=1e-14):
    sign = np.sign(np.sum(actual[..., :4] * expected[..., :4], axis=-1, keepdims=True))
    np.testing.assert_allclose(actual, sign * expected, rtol=0, atol=atol)


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("size", [1.0, 1000.0])
def test_products_are_those_of_scipy_and_pytransform3d(random_motions, close, count, size):
    a, b = random_motions(count, size=size), random_motions(count, size=size)
    expected = (scipy_of(a) * scipy_of(b)).as_matrix()
    for product in (dq8.mul(a, b), dq8.compose(a, b)):
        # Two translations and their sum, each of a few times `size`.
        close(dq8.to_matrix(product), expected, 10 * size)
    theirs = p3t.batch_concatenate_dual_quaternions(a[:, FIRST], b[:, FIRST])[:, LAST]
    close(dq8.mul(a, b), theirs, size)


@pytest.mark.parametrize("count", COUNTS)
def test_inverses_are_those_of_scipy(random_motions, close, count):
    a = random_motions(count)
    expected = scipy_of(a).inv().as_matrix()
    close(dq8.to_matrix(dq8.conjugate(a)), expected, 10)
    close(dq8.to_matrix(dq8.inverse(a)), expected, 10)


def test_the_inverse_of_any_dual_quaternion_undoes_it(rng, close):
    a = rng.normal(size=(9, 8))
    close(dq8.mul(a, dq8.inverse(a)), np.broadcast_to(dq8.identity(), (9, 8)), 10)


@pytest.mark.parametrize("count", COUNTS)
def test_normalization_is_that_of_scipy(rng, close, count):
    a = rng.normal(size=(count, 8))
    expected = RigidTransform.from_dual_quat(a).as_matrix()
    close(dq8.to_matrix(dq8.normalize(a)), expected, 100)
    unit = dq8.normalize(a)
    close(np.linalg.norm(unit[:, :4], axis=-1), 1.0)
    close(np.sum(unit[:, :4] * unit[:, 4:], axis=-1), 0.0, 10)


def test_what_cannot_be_normalized_is_nan():
    assert np.isnan(dq8.normalize(np.zeros(8))).any()


@pytest.mark.parametrize("count", COUNTS)
def test_nlerp_is_the_normalized_sum(random_motions, close, count):
    a, b, t = random_motions(count), random_motions(count), np.linspace(0, 1, count)
    nearer = b * np.sign(np.sum(a[:, :4] * b[:, :4], axis=-1, keepdims=True))
    mixed = (1 - t)[:, None] * a + t[:, None] * nearer
    close(dq8.to_matrix(dq8.nlerp(a, b, t)), RigidTransform.from_dual_quat(mixed).as_matrix(), 10)


@pytest.mark.parametrize("count", COUNTS)
def test_sclerp_is_that_of_pytransform3d(random_motions, count):
    a, b, t = random_motions(count), random_motions(count), np.linspace(0, 1, count)
    nearer = b * np.sign(np.sum(a[:, :4] * b[:, :4], axis=-1, keepdims=True))
    theirs = p3t.dual_quaternions_sclerp(a[:, FIRST], nearer[:, FIRST], t)[:, LAST]
    # Their way through screw parameters divides by the sine of half the angle.
    same_motion(dq8.sclerp(a, b, t), theirs, 1e-13)


def test_sclerp_begins_at_a_and_ends_at_b(random_motions):
    a, b = random_motions(21), random_motions(21)
    same_motion(dq8.sclerp(a, b, 0), a)
    same_motion(dq8.sclerp(a, b, 1), b)


@pytest.mark.parametrize("count", COUNTS)
def test_twists_are_the_exponential_coordinates_of_scipy(random_motions, close, count):
    a = random_motions(count)
    twists = dq8.to_twist(a)
    # Near π the rotation vector of a matrix has lost digits; SciPy's goes through one.
    np.testing.assert_allclose(twists, scipy_of(a).as_exp_coords(), rtol=0, atol=1e-13)
    close(twists, 2 * dq8.log(a))
    expected = RigidTransform.from_exp_coords(twists).as_matrix()
    np.testing.assert_allclose(dq8.to_matrix(dq8.from_twist(twists)), expected, rtol=0, atol=1e-14 * 10)
    same_motion(dq8.exp(dq8.log(a)), a)


def test_tiny_twists_are_those_of_pytransform3d(rng):
    twists = 1e-7 * rng.normal(size=(20, 6))
    theirs = p3t.transforms_from_exponential_coordinates(twists)
    np.testing.assert_allclose(dq8.to_matrix(dq8.from_twist(twists)), theirs, rtol=0, atol=1e-14)
    # The whole of a small twist is there again, to the last places.
    np.testing.assert_allclose(dq8.to_twist(dq8.from_twist(twists)), twists, rtol=1e-14, atol=0)


@pytest.mark.parametrize("exponent", [-1.5, -1, 0, 0.25, 1, 2])
def test_powers_are_those_of_scipy_and_pytransform3d(random_motions, exponent):
    a = random_motions(21)
    a *= np.sign(a[:, 3:4])
    powers = dq8.pow(a, exponent)
    expected = (scipy_of(a) ** exponent).as_matrix()
    np.testing.assert_allclose(dq8.to_matrix(powers), expected, rtol=0, atol=1e-13)
    theirs = p3t.dual_quaternions_power(a[:, FIRST], np.full(21, float(exponent)))[:, LAST]
    same_motion(powers, theirs, 1e-13)


def test_screws_are_those_of_pytransform3d(random_motions):
    a = random_motions(21)
    a *= np.sign(a[:, 3:4])
    screws = dq8.to_screw(a)
    point, direction, pitch, angle = p3t.screw_parameters_from_dual_quaternions(a[:, FIRST])
    np.testing.assert_allclose(screws[:, :3], direction, rtol=0, atol=1e-13)
    np.testing.assert_allclose(screws[:, 3:6], np.cross(point, direction), rtol=0, atol=1e-12)
    np.testing.assert_allclose(screws[:, 6], angle, rtol=0, atol=1e-13)
    np.testing.assert_allclose(screws[:, 7], pitch * angle, rtol=0, atol=1e-12)
    same_motion(dq8.from_screw(screws), a, 1e-13)


@pytest.mark.parametrize("count", COUNTS)
def test_points_and_vectors_move_as_in_scipy(random_motions, rng, close, count):
    a, v = random_motions(count), rng.normal(size=(count, 3))
    transforms = scipy_of(a)
    close(dq8.transform_points(a, v), transforms.apply(v), 10)
    close(dq8.transform_vectors(a, v), transforms.rotation.apply(v), 10)
    # One motion of many points takes another way.
    close(dq8.transform_points(a[0], v), transforms[0].apply(v), 10)
    close(dq8.transform_vectors(a[0], v), transforms[0].rotation.apply(v), 10)


def test_a_moved_line_goes_through_the_moved_points(random_motions, rng, close):
    a, x, l = random_motions(21), rng.normal(size=(21, 3)), rng.normal(size=(21, 3))
    moved = dq8.transform_lines(a, np.concatenate([l, np.cross(x, l)], axis=-1))
    close(moved[:, :3], scipy_of(a).rotation.apply(l), 10)
    close(np.cross(scipy_of(a).apply(x), moved[:, :3]), moved[:, 3:], 100)


def test_a_moved_plane_goes_through_the_moved_points(random_motions, rng, close):
    a, x, n = random_motions(21), rng.normal(size=(21, 3)), rng.normal(size=(21, 3))
    moved = dq8.transform_planes(a, np.concatenate([n, np.sum(n * x, -1, keepdims=True)], axis=-1))
    close(moved[:, :3], scipy_of(a).rotation.apply(n), 10)
    close(np.sum(moved[:, :3] * scipy_of(a).apply(x), -1), moved[:, 3], 100)


def test_twists_move_by_the_adjoint_of_pytransform3d(random_motions, rng, close):
    a, twist = random_motions(21), rng.normal(size=(21, 6))
    matrices = scipy_of(a).as_matrix()
    expected = np.stack([p3d.adjoint_from_transform(m) @ t for m, t in zip(matrices, twist)])
    close(dq8.adjoint(a, twist), expected, 10)


def test_the_power_of_a_wrench_on_a_twist_is_the_same_in_every_frame(random_motions, rng, close):
    a, twist, wrench = random_motions(21), rng.normal(size=(21, 6)), rng.normal(size=(21, 6))

    def power(wrench, twist):
        return np.sum(wrench[:, :3] * twist[:, 3:] + wrench[:, 3:] * twist[:, :3], axis=-1)

    close(power(dq8.coadjoint(a, wrench), dq8.adjoint(a, twist)), power(wrench, twist), 100)


@pytest.mark.parametrize("count", COUNTS)
def test_matrices_and_components_are_those_of_scipy(random_motions, rng, close, count):
    a = random_motions(count)
    transforms = scipy_of(a)
    matrices = transforms.as_matrix()
    close(dq8.to_matrix(a), matrices, 10)
    close(dq8.translation(a), transforms.translation, 10)
    same_motion(dq8.from_matrix(matrices), a)
    t, r = rng.normal(size=(count, 3)), Rotation.random(count, rng=rng)
    expected = RigidTransform.from_components(t, r).as_matrix()
    close(dq8.to_matrix(dq8.from_rotation_translation(r.as_quat(), t)), expected, 10)
    close(dq8.to_matrix(dq8.from_translation(t)), RigidTransform.from_translation(t).as_matrix())


@pytest.mark.parametrize("count", COUNTS)
def test_distances_are_those_of_scipy(random_motions, rng, close, count):
    a, b, v = random_motions(count), random_motions(count), rng.normal(size=(count, 3))
    x, y = scipy_of(a), scipy_of(b)
    angle = (x.rotation.inv() * y.rotation).magnitude()
    length = np.linalg.norm(x.translation - y.translation, axis=-1)
    close(dq8.angle_to(a, b), angle, 10)
    close(dq8.distance_to(a, b), length, 10)
    close(dq8.distance_weighted(a, b, 3.0), np.hypot(3 * angle, length), 10)
    close(dq8.point_error(a, b, v), np.linalg.norm(x.apply(v) - y.apply(v), axis=-1), 10)


def test_integrating_a_twist_is_a_product_with_its_exponential(random_motions, rng, close):
    a, twist, dt = random_motions(21), rng.normal(size=(21, 6)), rng.normal(size=21)
    step = RigidTransform.from_exp_coords(twist * dt[:, None])
    close(dq8.to_matrix(dq8.integrate_body(a, twist, dt)), (scipy_of(a) * step).as_matrix(), 100)
    close(dq8.to_matrix(dq8.integrate_spatial(a, twist, dt)), (step * scipy_of(a)).as_matrix(), 100)


@pytest.mark.parametrize("shared_weights", [False, True])
def test_dlb_is_the_normalized_sum_with_signs_toward_the_first(random_motions, rng, close, shared_weights):
    a = random_motions(9, 5)
    weights = rng.random(size=5 if shared_weights else (9, 5))
    sign = np.sign(np.sum(a[:, :, :4] * a[:, :1, :4], axis=-1))
    total = np.sum((weights * sign)[..., None] * a, axis=1)
    expected = RigidTransform.from_dual_quat(total).as_matrix()
    close(dq8.to_matrix(dq8.dlb(a, weights)), expected, 10)


def test_without_weights_all_weigh_the_same(random_motions, close):
    a = random_motions(9, 5)
    close(dq8.dlb(a), dq8.dlb(a, np.ones(5)))
    close(dq8.mean(a), dq8.mean(a, np.ones((9, 5))))


def test_the_steps_from_the_mean_add_up_to_nothing(rng, random_motions):
    steps = 0.5 * rng.normal(size=(9, 5, 6))
    a = dq8.integrate_body(random_motions(9, 1), steps, 1.0)
    weights = rng.random(size=(9, 5))
    mean = dq8.mean(a, weights)
    logs = dq8.log(dq8.mul(dq8.conjugate(mean)[:, None], a))
    np.testing.assert_allclose(np.sum(weights[..., None] * logs, axis=1), 0, atol=1e-13)


def test_the_mean_of_moved_motions_is_the_moved_mean(rng, random_motions):
    a = dq8.integrate_body(random_motions(9, 1), 0.5 * rng.normal(size=(9, 5, 6)), 1.0)
    left, right = random_motions(), random_motions()
    moved = dq8.mean(dq8.mul(dq8.mul(left, a), right))
    same_motion(moved, dq8.mul(dq8.mul(left, dq8.mean(a)), right), 1e-13)


def test_float32_is_float64_to_the_precision_of_float32(random_motions, rng):
    a, b, v = random_motions(21), random_motions(21), rng.normal(size=(21, 3))
    x, y, w = (array.astype(np.float32) for array in (a, b, v))
    for single, double in [
        (dq8.mul(x, y), dq8.mul(a, b)),
        (dq8.sclerp(x, y, 0.25), dq8.sclerp(a, b, 0.25)),
        (dq8.log(x), dq8.log(a)),
        (dq8.transform_points(x, w), dq8.transform_points(a, v)),
        (dq8.to_matrix(x), dq8.to_matrix(a)),
        (dq8.angle_to(x, y), dq8.angle_to(a, b)),
    ]:
        assert single.dtype == np.float32
        np.testing.assert_allclose(single, double, rtol=0, atol=1e-5)
