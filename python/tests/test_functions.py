"""Every function against SciPy and pytransform3d, or against its formula in NumPy."""

import itertools

import numpy as np
import pytest
import pytransform3d.trajectories as p3t
import pytransform3d.transformations as p3d
from calls import CALLS, arguments_of
from scipy.spatial.transform import RigidTransform, Rotation

import dq8
from dq8._signatures import SIGNATURES

FIRST = [3, 0, 1, 2, 7, 4, 5, 6]
LAST = [1, 2, 3, 0, 5, 6, 7, 4]
# A register is left half empty, and then there are several.
COUNTS = [1, 3, 4, 21]


def scipy_of(motions) -> RigidTransform:
    return RigidTransform.from_dual_quat(motions)


def signed(motions, like):
    """Those of ±σ that are on the side of others."""
    return motions * np.sign(np.sum(motions[..., :4] * like[..., :4], axis=-1, keepdims=True))


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("size", [1.0, 1000.0])
def test_products_are_those_of_scipy_and_pytransform3d(random_motions, close, count, size):
    a, b = random_motions(count, size=size), random_motions(count, size=size)
    expected = (scipy_of(a) * scipy_of(b)).as_matrix()
    for product in (dq8.mul(a, b), dq8.compose(a, b)):
        close(dq8.to_matrix(product), expected, a, b)
    theirs = p3t.batch_concatenate_dual_quaternions(a[:, FIRST], b[:, FIRST])[:, LAST]
    close(dq8.mul(a, b), theirs, a, b)


@pytest.mark.parametrize("count", COUNTS)
def test_inverses_are_those_of_scipy(random_motions, close, count):
    a = random_motions(count)
    expected = scipy_of(a).inv().as_matrix()
    close(dq8.to_matrix(dq8.conjugate(a)), expected, a)
    close(dq8.to_matrix(dq8.inverse(a)), expected, a)


def test_the_inverse_of_any_dual_quaternion_undoes_it(rng, close):
    a = rng.normal(size=(9, 8))
    close(dq8.mul(a, dq8.inverse(a)), np.broadcast_to(dq8.identity(), (9, 8)), a, dq8.inverse(a))


@pytest.mark.parametrize("count", COUNTS)
def test_normalization_is_that_of_scipy(rng, close, count):
    a = rng.normal(size=(count, 8))
    expected = RigidTransform.from_dual_quat(a).as_matrix()
    unit = dq8.normalize(a)
    close(dq8.to_matrix(unit), expected, expected)
    close(np.linalg.norm(unit[:, :4], axis=-1), 1.0)
    close(np.sum(unit[:, :4] * unit[:, 4:], axis=-1), 0.0, unit)


def test_what_cannot_be_normalized_is_nan():
    assert np.isnan(dq8.normalize(np.zeros(8))).any()


@pytest.mark.parametrize("count", COUNTS)
def test_nlerp_is_the_normalized_sum(random_motions, close, count):
    a, b, t = random_motions(count), random_motions(count), np.linspace(0, 1, count)
    mixed = (1 - t)[:, None] * a + t[:, None] * signed(b, a)
    expected = RigidTransform.from_dual_quat(mixed).as_matrix()
    close(dq8.to_matrix(dq8.nlerp(a, b, t)), expected, a, b, expected)


@pytest.mark.parametrize("count", COUNTS)
def test_sclerp_is_that_of_pytransform3d(random_motions, close, count):
    a, b, t = random_motions(count), random_motions(count), np.linspace(0, 1, count)
    theirs = p3t.dual_quaternions_sclerp(a[:, FIRST], signed(b, a)[:, FIRST], t)[:, LAST]
    ours = dq8.sclerp(a, b, t)
    close(ours, signed(theirs, ours), a, b, theirs)


def test_sclerp_begins_at_a_and_ends_at_b(random_motions, close):
    a, b = random_motions(21), random_motions(21)
    close(dq8.sclerp(a, b, 0), a, a, b)
    close(dq8.sclerp(a, b, 1), signed(b, a), a, b)


@pytest.mark.parametrize("count", COUNTS)
def test_twists_are_the_exponential_coordinates_of_scipy(random_motions, close, count):
    a = random_motions(count)
    twists = dq8.to_twist(a)
    close(twists, scipy_of(a).as_exp_coords(), a)
    np.testing.assert_array_equal(twists, 2 * dq8.log(a)[..., [0, 1, 2, 4, 5, 6]])
    assert (dq8.log(a)[..., [3, 7]] == 0).all()
    expected = RigidTransform.from_exp_coords(twists).as_matrix()
    close(dq8.to_matrix(dq8.from_twist(twists)), expected, a)
    close(dq8.exp(dq8.log(a)), signed(a, dq8.exp(dq8.log(a))), a)


def test_tiny_twists_are_those_of_pytransform3d(rng, close):
    twists = 1e-7 * rng.normal(size=(20, 6))
    theirs = p3t.transforms_from_exponential_coordinates(twists)
    close(dq8.to_matrix(dq8.from_twist(twists)), theirs)
    # The whole of a small twist is there again, to the last places.
    np.testing.assert_allclose(dq8.to_twist(dq8.from_twist(twists)), twists, rtol=1e-14, atol=0)


def test_twists_of_nearly_half_a_turn_come_back(rng, random_motions, close):
    axes = rng.normal(size=(14, 3))
    angles = np.pi - 10.0 ** -np.arange(1, 15)
    turns = axes * (angles / np.linalg.norm(axes, axis=-1))[:, None]
    twists = np.concatenate([turns, rng.normal(size=(14, 3))], axis=-1)
    close(dq8.to_twist(dq8.from_twist(twists)), twists, twists)
    a = random_motions(14)
    between = dq8.sclerp(a, dq8.mul(a, dq8.from_twist(twists)), 0.3)
    expected = scipy_of(a) * RigidTransform.from_exp_coords(0.3 * twists)
    close(dq8.to_matrix(between), expected.as_matrix(), a, twists)


@pytest.mark.parametrize("exponent", [-1.5, -1, 0, 0.25, 1, 2])
def test_powers_are_those_of_scipy_and_pytransform3d(random_motions, close, exponent):
    a = random_motions(21)
    a *= np.sign(a[:, 3:4])
    powers = dq8.pow(a, exponent)
    expected = (scipy_of(a) ** exponent).as_matrix()
    close(dq8.to_matrix(powers), expected, a, expected)
    theirs = p3t.dual_quaternions_power(a[:, FIRST], np.full(21, float(exponent)))[:, LAST]
    close(powers, theirs, a, expected)


def test_screws_are_those_of_pytransform3d(random_motions, close):
    a = random_motions(21)
    a *= np.sign(a[:, 3:4])
    screws = dq8.to_screw(a)
    point, direction, pitch, angle = p3t.screw_parameters_from_dual_quaternions(a[:, FIRST])
    close(screws[:, :3], direction, a)
    close(screws[:, 3:6], np.cross(point, direction), a, point)
    close(screws[:, 6], angle, a)
    close(screws[:, 7], pitch * angle, a)
    close(dq8.from_screw(screws), a, a)


@pytest.mark.parametrize("count", COUNTS)
def test_points_and_vectors_move_as_in_scipy(random_motions, rng, close, count):
    a, v = random_motions(count), rng.normal(size=(count, 3))
    transforms = scipy_of(a)
    close(dq8.transform_points(a, v), transforms.apply(v), a, v)
    close(dq8.transform_vectors(a, v), transforms.rotation.apply(v), v)
    # One motion of many points takes another way.
    close(dq8.transform_points(a[0], v), transforms[0].apply(v), a, v)
    close(dq8.transform_vectors(a[0], v), transforms[0].rotation.apply(v), v)


def test_a_moved_line_goes_through_the_moved_points(random_motions, rng, close):
    a, x, l = random_motions(21), rng.normal(size=(21, 3)), rng.normal(size=(21, 3))
    lines = np.concatenate([l, np.cross(x, l)], axis=-1)
    moved = dq8.transform_lines(a, lines)
    close(moved[:, :3], scipy_of(a).rotation.apply(l), l)
    close(np.cross(scipy_of(a).apply(x), moved[:, :3]), moved[:, 3:], lines, moved)


def test_a_moved_plane_goes_through_the_moved_points(random_motions, rng, close):
    a, x, n = random_motions(21), rng.normal(size=(21, 3)), rng.normal(size=(21, 3))
    planes = np.concatenate([n, np.sum(n * x, -1, keepdims=True)], axis=-1)
    moved = dq8.transform_planes(a, planes)
    close(moved[:, :3], scipy_of(a).rotation.apply(n), n)
    close(np.sum(moved[:, :3] * scipy_of(a).apply(x), -1), moved[:, 3], planes, moved)


def test_twists_move_by_the_adjoint_of_pytransform3d(random_motions, rng, close):
    a, twist = random_motions(21), rng.normal(size=(21, 6))
    matrices = scipy_of(a).as_matrix()
    expected = np.stack([p3d.adjoint_from_transform(m) @ t for m, t in zip(matrices, twist)])
    close(dq8.adjoint(a, twist), expected, twist, expected)


def test_wrenches_move_by_the_transposed_inverse_of_the_adjoint(random_motions, rng, close):
    a, wrench = random_motions(21), rng.normal(size=(21, 6))
    matrices = scipy_of(a).inv().as_matrix()
    # pytransform3d's adjoint is of [ω, v], dual to [τ, f].
    duals = np.stack([p3d.adjoint_from_transform(m).T @ w for m, w in zip(matrices, wrench[:, [3, 4, 5, 0, 1, 2]])])
    expected = duals[:, [3, 4, 5, 0, 1, 2]]
    close(dq8.coadjoint(a, wrench), expected, wrench, expected)


def test_the_power_of_a_wrench_on_a_twist_is_the_same_in_every_frame(random_motions, rng, close):
    a, twist, wrench = random_motions(21), rng.normal(size=(21, 6)), rng.normal(size=(21, 6))

    def power(wrench, twist):
        return np.sum(wrench[:, :3] * twist[:, 3:] + wrench[:, 3:] * twist[:, :3], axis=-1)

    moved_wrench, moved_twist = dq8.coadjoint(a, wrench), dq8.adjoint(a, twist)
    products = np.linalg.norm(moved_wrench, axis=-1) * np.linalg.norm(moved_twist, axis=-1)
    close(power(moved_wrench, moved_twist), power(wrench, twist), products)


@pytest.mark.parametrize("count", COUNTS)
def test_matrices_and_components_are_those_of_scipy(random_motions, rng, close, count):
    a = random_motions(count)
    transforms = scipy_of(a)
    matrices = transforms.as_matrix()
    close(dq8.to_matrix(a), matrices, a)
    close(dq8.translation(a), transforms.translation, a)
    close(dq8.from_matrix(matrices), signed(a, dq8.from_matrix(matrices)), a)
    t, r = rng.normal(size=(count, 3)), Rotation.random(count, rng=rng)
    expected = RigidTransform.from_components(t, r).as_matrix()
    close(dq8.to_matrix(dq8.from_rotation_translation(r.as_quat(), t)), expected, t)
    close(dq8.to_matrix(dq8.from_translation(t)), RigidTransform.from_translation(t).as_matrix(), t)


@pytest.mark.parametrize("count", COUNTS)
def test_distances_are_those_of_scipy(random_motions, rng, close, count):
    a, b, v = random_motions(count), random_motions(count), rng.normal(size=(count, 3))
    x, y = scipy_of(a), scipy_of(b)
    angle = (x.rotation.inv() * y.rotation).magnitude()
    length = np.linalg.norm(x.translation - y.translation, axis=-1)
    close(dq8.angle_to(a, b), angle)
    close(dq8.distance_to(a, b), length, a, b)
    close(dq8.distance_weighted(a, b, 3.0), np.hypot(3 * angle, length), a, b)
    close(dq8.point_error(a, b, v), np.linalg.norm(x.apply(v) - y.apply(v), axis=-1), a, b, v)


def test_integrating_a_twist_is_a_product_with_its_exponential(random_motions, rng, close):
    a, twist, dt = random_motions(21), rng.normal(size=(21, 6)), rng.normal(size=21)
    step = RigidTransform.from_exp_coords(twist * dt[:, None])
    close(dq8.to_matrix(dq8.integrate_body(a, twist, dt)), (scipy_of(a) * step).as_matrix(), a, step.as_matrix())
    close(dq8.to_matrix(dq8.integrate_spatial(a, twist, dt)), (step * scipy_of(a)).as_matrix(), a, step.as_matrix())


# Of few influences, lanes are blends; of many, lanes are influences, and the last register is not full.
INFLUENCES = [1, 5, 67]


@pytest.mark.parametrize("count", INFLUENCES)
@pytest.mark.parametrize("shared_weights", [False, True])
def test_dlb_is_the_normalized_sum_with_signs_toward_the_first(random_motions, rng, close, shared_weights, count):
    a = random_motions(9, count)
    weights = rng.random(size=count if shared_weights else (9, count))
    sign = np.sign(np.sum(a[:, :, :4] * a[:, :1, :4], axis=-1))
    total = np.sum((weights * sign)[..., None] * a, axis=1)
    expected = RigidTransform.from_dual_quat(total).as_matrix()
    close(dq8.to_matrix(dq8.dlb(a, weights)), expected, a, expected)


@pytest.mark.parametrize("count", INFLUENCES)
def test_without_weights_all_weigh_the_same(rng, random_motions, close, count):
    a = dq8.integrate_body(random_motions(9, 1), 0.5 * rng.normal(size=(9, count, 6)), 1.0)
    close(dq8.dlb(a), dq8.dlb(a, np.ones(count)), a)
    close(dq8.mean(a), dq8.mean(a, np.ones((9, count))), a)


@pytest.mark.parametrize("count", INFLUENCES)
def test_the_steps_from_the_mean_add_up_to_nothing(rng, random_motions, close, count):
    steps = 0.5 * rng.normal(size=(9, count, 6))
    a = dq8.integrate_body(random_motions(9, 1), steps, 1.0)
    weights = rng.random(size=(9, count))
    mean = dq8.mean(a, weights)
    logs = dq8.log(dq8.mul(dq8.conjugate(mean)[:, None], a))
    step = np.sum(weights[..., None] * logs, axis=1) / np.sum(weights, axis=1)[:, None]
    close(step, 0, a)


@pytest.mark.parametrize("count", INFLUENCES)
def test_means_are_where_steps_of_scipy_end(rng, random_motions, close, count):
    a = dq8.integrate_body(random_motions(9, 1), 0.5 * rng.normal(size=(9, count, 6)), 1.0)
    weights = rng.random(size=(9, count))
    for motions, own, mean in zip(a, weights, dq8.mean(a, weights)):
        found, transforms = scipy_of(motions[0]), scipy_of(motions)
        for _ in range(20):
            steps = (found.inv() * transforms).as_exp_coords()
            found = found * RigidTransform.from_exp_coords(own @ steps / own.sum())
        # A step of 1e-14 counts as none in `mean`: radians, which move what is |t| away, and parts of |t|/2. (By 40
        # digits, the steps that are left of the loop here are 3e-16 and of `mean` up to 3e-14.)
        close(dq8.to_matrix(mean), found.as_matrix(), motions, bound=2e-14)


@pytest.mark.parametrize("count", INFLUENCES)
def test_the_mean_of_moved_motions_is_the_moved_mean(rng, random_motions, close, count):
    a = dq8.integrate_body(random_motions(9, 1), 0.5 * rng.normal(size=(9, count, 6)), 1.0)
    left, right = random_motions(), random_motions()
    moved = dq8.mean(dq8.mul(dq8.mul(left, a), right))
    expected = dq8.mul(dq8.mul(left, dq8.mean(a)), right)
    close(moved, signed(expected, moved), a, left, right, expected)


# Eight units of the last place of 1. What iterates ends where a step is within its tolerance; least squares multiply rounding by
# the condition of the Jacobian.
SINGLE = {"mean": 2e-6, "dib_windows": 2e-6, "Mechanism.reach": 1e-5, "Mechanism.track": 1e-5, "Mechanism.sequence": 1e-5, "Mechanism.rates_for": 2e-6}


@pytest.mark.parametrize("name", CALLS)
def test_float32_is_float64_of_the_same_numbers_to_the_precision_of_float32(name, rng, close):
    arguments = arguments_of(name, rng, np.float32)
    single, double = (CALLS[name][0](*(array.astype(dtype) for array in arguments)) for dtype in ("f4", "f8"))
    assert single.dtype == np.float32 and double.dtype == np.float64
    vectors = [array for array in (*arguments, double) if array.ndim > 1]
    close(single, double, *vectors, bound=SINGLE.get(name, 2**-21))


@pytest.mark.parametrize("name", [name for name, (shapes, _) in SIGNATURES.items() if len(shapes) > 1])
def test_a_large_call_is_many_small_ones_whichever_arguments_are_one_for_all(name, rng):
    function, arguments = CALLS[name][0], arguments_of(name, rng)
    many = lambda array: np.concatenate([array] * 500)
    for is_each in itertools.product([False, True], repeat=len(arguments)):
        pairs = list(zip(arguments, is_each))
        small = function(*(array if each else array[0] for array, each in pairs))
        large = function(*(many(array) if each else array[0] for array, each in pairs))
        np.testing.assert_array_equal(large, many(small) if any(is_each) else small)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("shapes", [((7,), (2000, 7)), ((2000, 1), (1, 7)), ((2000, 7), ())])
def test_a_large_call_repeats_arguments_as_numpy_does_on_any_number_of_threads(
    shapes, dtype, rng, one_thread
):
    first, second = (dq8.random(shape, rng=rng).astype(dtype) for shape in shapes)
    written_out = [array.copy() for array in np.broadcast_arrays(first, second)]
    for threads in [1, 3]:
        dq8.set_num_threads(threads)
        np.testing.assert_array_equal(dq8.mul(first, second), dq8.mul(*written_out))
