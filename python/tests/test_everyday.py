"""Everyday functions: as SciPy has them, and back from what they make."""

import itertools

import numpy as np
import pytest
from calls import neighbours
from robots import ROBOTS
from scipy.spatial.transform import RigidTransform as Theirs
from scipy.spatial.transform import Rotation

import dq8

ORDERS = ["".join(order) for order in itertools.product("xyz", repeat=3) if order[0] != order[1] != order[2]]
ORDERS += [order.upper() for order in ORDERS]


@pytest.fixture
def rotations(rng):
    return Rotation.random(50, rng=rng)


def same(motions, rotations, atol=1e-14):
    np.testing.assert_allclose(dq8.to_matrix(motions)[..., :3, :3], rotations.as_matrix(), rtol=0, atol=atol)


def test_rotations_of_scipy_are_taken_where_rotations_are(rotations, rng):
    points = rng.normal(size=(50, 3))
    same(dq8.from_rotation(rotations), rotations)
    np.testing.assert_array_equal(dq8.from_rotation(rotations), dq8.from_rotation(rotations.as_quat()))
    motions = dq8.from_rotation_translation(rotations, points)
    q, t = dq8.to_rotation_translation(motions)
    np.testing.assert_array_equal(q, rotations.as_quat())
    np.testing.assert_allclose(t, points, rtol=0, atol=1e-15 * 8)
    np.testing.assert_array_equal(dq8.rotation(motions), q)
    assert dq8.from_rotation(q.astype(np.float32)).dtype == np.float32


def test_vectors_axes_and_angles_are_those_of_scipy(rotations):
    vectors = rotations.as_rotvec()
    same(dq8.from_rotation_vector(vectors), rotations)
    np.testing.assert_allclose(dq8.to_rotation_vector(dq8.from_rotation(rotations)), vectors, rtol=0, atol=1e-14)
    axes, angles = dq8.to_axis_angle(dq8.from_rotation(rotations))
    np.testing.assert_allclose(angles, rotations.magnitude(), rtol=0, atol=1e-14)
    same(dq8.from_axis_angle(3 * axes, angles), rotations)
    axis, angle = dq8.to_axis_angle(dq8.from_translation([1.0, 2.0, 3.0]))
    assert (*axis, angle) == (1, 0, 0, 0)
    single = dq8.from_axis_angle(np.float32([0, 0, 1]), 0.5)
    assert single.dtype == np.float32


@pytest.mark.parametrize("order", ORDERS)
def test_euler_angles_are_those_of_scipy(order, rotations, rng):
    angles = rng.uniform(-3, 3, size=(50, 3))
    same(dq8.from_euler(order, angles), Rotation.from_euler(order, angles))
    np.testing.assert_allclose(dq8.to_euler(dq8.from_rotation(rotations), order), rotations.as_euler(order), rtol=0, atol=1e-13)
    # Where only a sum of two angles counts.
    middle = [0.0, np.pi] if order[0] == order[2] else [-np.pi / 2, np.pi / 2]
    for end in middle:
        motions = dq8.from_euler(order, [0.3, end, 0.4])
        found = dq8.to_euler(motions, order)
        assert found[0 if order.isupper() else 2] == 0
        assert dq8.allclose(dq8.from_euler(order, found), motions, angle=1e-7)


@pytest.mark.parametrize("order", ["xyy", "xy", "xyzx", "xYz", "abc", ""])
def test_orders_that_are_none_are_refused(order):
    with pytest.raises(ValueError, match="Expected `order` to be three of"):
        dq8.from_euler(order, [0.0, 0.0, 0.0])


def test_the_other_order_of_components_is_that_of_scipy(rotations, random_motions):
    motions = random_motions(4)
    transforms = Theirs.from_dual_quat(motions)
    np.testing.assert_array_equal(dq8.from_wxyz(transforms.as_dual_quat(scalar_first=True)), transforms.as_dual_quat())
    np.testing.assert_array_equal(dq8.to_wxyz(rotations.as_quat()), rotations.as_quat(scalar_first=True))
    np.testing.assert_array_equal(dq8.from_wxyz(dq8.to_wxyz(motions)), motions)
    with pytest.raises(ValueError, match=r"shape \(\.\.\., 8\) or \(\.\.\., 4\), got \(3,\)"):
        dq8.to_wxyz([1.0, 2, 3])


def test_transforms_of_scipy_and_back(random_motions):
    motions = random_motions(4)
    assert isinstance(dq8.to_scipy(motions), Theirs)
    assert dq8.allclose(dq8.from_scipy(dq8.to_scipy(motions)), motions)
    assert dq8.allclose(dq8.from_scipy(dq8.RigidTransform.from_dual_quat(motions)), motions)
    with pytest.raises(TypeError, match="got list"):
        dq8.from_scipy([1])


def test_random_motions_are_unit_and_repeat(rng):
    motions = dq8.random((1000, 2), length=3.0, rng=1, dtype=np.float32)
    assert motions.shape == (1000, 2, 8) and motions.dtype == np.float32
    assert dq8.is_unit(motions).all()
    np.testing.assert_array_equal(motions, dq8.random((1000, 2), length=3.0, rng=1, dtype=np.float32))
    assert abs(dq8.translation(motions).std() - 3) < 0.15
    # Rotations alike: their mean is nowhere.
    assert abs(dq8.to_matrix(motions)[..., :3, :3].mean(axis=(0, 1))).max() < 0.06


def test_arguments_of_to_euler_that_are_swapped_are_told_their_order(random_motions):
    with pytest.raises(TypeError, match=r"to_euler\(motions, 'xyz'\), got ndarray"):
        dq8.to_euler("xyz", random_motions())


def test_the_same_motions_are_close_up_to_sign_and_others_are_not(random_motions):
    a = random_motions(6)
    assert dq8.allclose(a, -a)
    moved = dq8.mul(dq8.from_translation([0, 0, 1e-6]), a)
    assert not dq8.allclose(a, moved, length=9e-7) and dq8.allclose(a, moved, length=1.1e-6)
    turned = dq8.mul(a, dq8.from_rotation_vector([0, 0, 1e-6]))
    assert not dq8.allclose(a, turned, angle=9e-7) and dq8.allclose(a, turned, angle=1.1e-6) and not dq8.allclose(a, np.full(8, np.nan))


def test_what_is_not_unit_is_found(random_motions):
    motions = random_motions(5)
    motions[1] *= 1.001
    motions[2, 4:] += 0.1 * motions[2, :4]
    motions[3, 0] = np.nan
    np.testing.assert_array_equal(dq8.is_unit(motions), [True, False, False, False, True])


@pytest.mark.parametrize("shape", [(), (3,), (2, 3)])
def test_fits_find_the_motion_of_points_and_are_those_of_scipy(shape, rng, random_motions, close):
    motions, points = random_motions(*shape), rng.normal(size=(*shape, 12, 3))
    moved = dq8.transform_points(motions[..., np.newaxis, :], points)
    close(dq8.to_matrix(dq8.fit(points, moved)), dq8.to_matrix(motions), motions, bound=1e-13)
    noisy, weights = moved + 0.1 * rng.normal(size=moved.shape), rng.random((*shape, 12))
    found = dq8.fit(points, noisy, weights)
    for index in np.ndindex(shape):
        w = weights[index] / weights[index].sum()
        x, y = (p[index] - w @ p[index] for p in (points, noisy))
        same(found[index], Rotation.align_vectors(y, x, w)[0], 1e-12)
        middle = dq8.transform_points(found[index], w @ points[index])
        np.testing.assert_allclose(middle, w @ noisy[index], rtol=0, atol=1e-13)


def test_fits_of_mirrored_points_are_motions(rng):
    points = rng.normal(size=(8, 3))
    found = dq8.fit(points, points * [1, 1, -1], full=True).motions
    assert np.linalg.det(dq8.to_matrix(found)[:3, :3]) > 0.999
    assert dq8.fit(points.astype(np.float32), points.astype(np.float32)).dtype == np.float32


def test_fits_refuse_what_has_no_answer():
    with pytest.raises(ValueError, match="with n > 0"):
        dq8.fit(np.zeros((3, 3)), np.zeros((4, 3)))
    with pytest.raises(ValueError, match="not to be negative, got -1"):
        dq8.fit(np.zeros((3, 3)), np.zeros((3, 3)), [1, -1, 1])
    with pytest.raises(ValueError, match="not to be all zero"):
        dq8.fit(np.zeros((3, 3)), np.zeros((3, 3)), [0, 0, 0])


@pytest.mark.parametrize("shape", [(), (3,)])
@pytest.mark.parametrize("count", [2, 3, 20])
def test_hand_eye_finds_where_the_camera_sits(shape, count, rng, random_motions):
    x, eyes = random_motions(*shape), random_motions(*shape, count)
    own = x[..., np.newaxis, :]
    hands = dq8.mul(dq8.mul(own, eyes), dq8.inverse(own))
    assert dq8.allclose(dq8.hand_eye(hands, -eyes), x, angle=1e-10, length=1e-10)
    noisy = dq8.mul(hands, dq8.from_twist(1e-4 * rng.normal(size=(*shape, count, 6))))
    assert dq8.allclose(dq8.hand_eye(noisy, eyes), x, angle=1e-2, length=1e-2)


def test_hand_eye_refuses_parallel_axes(rng, random_motions):
    x, eyes = random_motions(), dq8.from_rotation_vector(rng.normal(size=(5, 1)) * [0, 0, 1.0])
    hands = dq8.mul(dq8.mul(x, eyes), dq8.inverse(x))
    with pytest.raises(ValueError, match="axes that are not parallel"):
        dq8.hand_eye(hands, eyes)


@pytest.mark.parametrize("noise", [1e-6, 1e-4, 1e-3])
def test_hand_eye_refuses_motions_in_a_plane_with_noise(noise, rng, random_motions):
    x = random_motions()
    turns = np.linspace(0.1, 1.0, 20)[:, np.newaxis] * [0, 0, 1.0]
    flat = dq8.from_twist(np.concatenate([turns, rng.normal(size=(20, 2)), np.zeros((20, 1))], axis=-1))
    hands = np.stack([random_motions(20), dq8.mul(dq8.mul(x, flat), dq8.inverse(x))])
    eyes = np.stack([dq8.mul(dq8.mul(dq8.inverse(x), hands[0]), x), flat])
    hands, eyes = (dq8.mul(m, dq8.from_twist(noise * rng.normal(size=(2, 20, 6)))) for m in (hands, eyes))
    dq8.hand_eye(hands[0], eyes[0])
    with pytest.raises(ValueError, match=r"not parallel, by more than the noise"):
        dq8.hand_eye(hands[1], eyes[1])
    with pytest.warns(UserWarning, match=r"1 of 2 problems .*: \(1,\)\. .* not parallel, by more"):
        found = dq8.hand_eye(hands, eyes)
    assert np.isfinite(found[0]).all() and np.isnan(found[1]).all()


def test_what_is_not_finite_stays_in_its_fit(rng, random_motions):
    points, motion = rng.normal(size=(4, 10, 3)), random_motions(4)
    moved = dq8.transform_points(motion[:, np.newaxis], points)
    moved[1, 3, 2], weights = np.nan, np.ones((4, 10))
    weights[2, 5], weights[3, 0] = np.nan, np.inf
    fitted = dq8.fit(points, moved, weights)
    assert dq8.allclose(fitted[0], motion[0]) and np.isnan(fitted[1:]).all()
    eyes = random_motions(3, 5)
    x = random_motions()
    hands = dq8.mul(dq8.mul(x, eyes), dq8.inverse(x))
    hands[1, 2, 0] = np.nan
    found = dq8.hand_eye(hands, eyes)
    assert dq8.allclose(found[0], x) and dq8.allclose(found[2], x) and np.isnan(found[1]).all()


def test_the_left_jacobian_is_the_derivative_of_the_exponential(rng):
    twists, steps = rng.normal(size=(20, 6)), 1e-6 * rng.normal(size=(20, 6))
    jacobian, inverse = dq8.left_jacobian(twists), dq8.left_jacobian_inverse(twists)
    change = dq8.to_twist(dq8.mul(dq8.from_twist(twists + steps), dq8.inverse(dq8.from_twist(twists))))
    np.testing.assert_allclose((jacobian @ steps[..., np.newaxis])[..., 0], change, rtol=0, atol=1e-10)
    np.testing.assert_allclose(jacobian @ inverse, np.broadcast_to(np.eye(6), (20, 6, 6)), rtol=0, atol=1e-13)
    np.testing.assert_array_equal(dq8.left_jacobian(np.zeros(6)), np.eye(6))


@pytest.mark.parametrize("name", sorted(path.name for path in ROBOTS.glob("*.urdf")))
def test_samples_of_a_robot_are_within_its_limits(name):
    robot = dq8.Mechanism.from_urdf(ROBOTS / name)
    values, limits = robot.sample((40, 2), rng=1), robot.limits
    assert values.shape == (40, 2, len(robot.values))
    assert (limits[:, 0] <= values).all() and (values <= limits[:, 1]).all()
    assert dq8.is_unit(robot.poses(values)).all()
    assert robot.name and robot == dq8.Mechanism.from_urdf(ROBOTS / name) and hash(robot) == hash(robot)
    assert all(parent < link for link, parent in enumerate(robot.parents))


def test_mechanisms_differ_where_joints_or_names_do():
    def arm(**changes):
        return dq8.Mechanism(**{"parents": [None, 0], "kinds": "floating", "axes": [0, 0, 1], "placements": dq8.identity(), **changes})

    assert arm() == arm() and arm().parents == [-1, 0] and arm().name is None
    assert arm() != arm(kinds="revolute") and arm() != arm(links=["a", "b"]) and arm() != 3
    rotations = arm().sample(5, rng=1).reshape(5, 2, 7)[..., :4]
    np.testing.assert_allclose(np.linalg.norm(rotations, axis=-1), 1)


@pytest.mark.parametrize("frame", ["world", "body", "aligned"])
def test_rates_and_velocities_of_links_belong_to_each_other(frame, rng):
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
    values, rates = arm.sample(6, rng=rng), rng.normal(size=(6, len(arm.rates)))
    twists = arm.velocity(values, rates, "hand", frame)
    np.testing.assert_allclose(twists, (arm.jacobian(values, "hand", frame) @ rates[..., np.newaxis])[..., 0])
    found = arm.rates_for(values, twists, "hand", frame)
    np.testing.assert_allclose(arm.velocity(values, found, "hand", frame), twists, rtol=0, atol=1e-9)
    damped = arm.rates_for(values, twists, "hand", frame, damping=0.3)
    assert (np.linalg.norm(damped, axis=-1) < np.linalg.norm(found, axis=-1)).all()


def test_hierarchies_in_any_order_and_roots_of_each_instance(rng):
    parents, shuffle = [-1, 0, 0, 1, 3], np.array([3, 1, 4, 0, 2])
    back = np.argsort(shuffle)
    shuffled = dq8.Hierarchy([None if parents[j] < 0 else int(back[parents[j]]) for j in shuffle])
    sorted_ = dq8.Hierarchy(parents=parents)
    locals_, roots = neighbours(rng, 4, 3, 5), neighbours(rng, 3)
    models = sorted_.local_to_model(locals_, root=roots)
    for i in range(3):
        np.testing.assert_array_equal(models[:, i], sorted_.local_to_model(locals_[:, i], root=roots[i]))
    moved = shuffled.local_to_model(locals_[..., shuffle, :], root=roots)
    np.testing.assert_array_equal(moved, models[..., shuffle, :])
    assert dq8.allclose(shuffled.model_to_local(moved, root=roots), locals_[..., shuffle, :])
    shuffled.local_to_model(moved, out=moved)
    np.testing.assert_array_equal(moved, sorted_.local_to_model(models)[..., shuffle, :])
    assert shuffled.parents == [back[parents[j]] if parents[j] >= 0 else -1 for j in shuffle]
    with pytest.raises(ValueError, match=r"Expected `root` to have shape \(8,\) or \(4, 3, 8\), got \(2, 8\)"):
        shuffled.local_to_model(moved, root=roots[:2])
    with pytest.raises(ValueError, match="`parents`: .*ancestor"):
        dq8.Hierarchy([1, 0])


def test_arguments_may_be_given_by_name(random_motions):
    a, b = random_motions(3), random_motions(3)
    np.testing.assert_array_equal(dq8.mul(b=b, a=a), dq8.mul(a, b))
    np.testing.assert_array_equal(dq8.transform_points(points=[1.0, 0, 0], motions=a), dq8.transform_points(a, [1.0, 0, 0]))
