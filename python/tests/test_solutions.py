"""All solutions of arms of six hinges: forward kinematics of what comes back, and what `reach` finds."""

import pickle

import numpy as np
import pytest
from robots import ROBOTS, random_values

import dq8


@pytest.fixture(scope="module")
def arm() -> dq8.Mechanism:
    return dq8.Mechanism.from_urdf(ROBOTS / "arm6.urdf")


@pytest.fixture(scope="module")
def other() -> dq8.Mechanism:
    """Axes that are askew."""
    axes = np.random.default_rng(6).normal(size=(6, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    offsets = dq8.from_translation([[0.0, 0, 0.2], [0.1, 0, 0.3], [0.4, 0, 0], [0.3, 0.1, 0], [0.1, 0, 0], [0, 0, 0.1]])
    return dq8.Mechanism(range(-1, 5), "revolute", axes, offsets, limits=[-3, 3])


def places(found):
    return np.arange(8) < np.asarray(found.counts)[..., np.newaxis]


@pytest.mark.parametrize(("dtype", "near"), [("f8", 1e-9), ("f4", 1e-4)])
def test_all_are_at_the_target_within_the_limits_and_the_start_is_the_first(arm, rng, dtype, near):
    values = random_values(arm, rng, 3, 100).astype(dtype)
    targets = arm.poses(values, "tool")
    found = arm.solutions(targets, values, "tool")
    assert found.values.shape == (3, 100, 8, 6) and found.values.dtype == dtype
    assert found.distances.shape == (3, 100, 8) and found.distances.dtype == dtype
    assert found.counts.shape == found.complete.shape == (3, 100) and found.singular.shape == (3, 100, 8, 3)
    there = places(found)
    assert (np.isfinite(found.values).all(axis=-1) == there).all() and (np.isfinite(found.distances) == there).all()
    assert found.complete.all() and found.counts.min() >= 1 and found.counts.max() > 2
    poses, wanted = arm.poses(found.values, "tool")[there], np.repeat(targets.reshape(-1, 8), found.counts.ravel(), axis=0)
    assert dq8.angle_to(poses, wanted).max() < near and dq8.distance_to(poses, wanted).max() < near
    low, high = arm.limits.T
    assert (found.values[there] >= low - near).all() and (found.values[there] <= high + near).all()
    assert (np.diff(found.distances, axis=-1)[there[..., 1:]] >= 0).all()
    np.testing.assert_allclose(found.distances[there], np.linalg.norm(found.values - values[..., None, :], axis=-1)[there],
                               rtol=1e-5, atol=near)
    assert np.mean(found.distances[..., 0] < 100 * near) > 0.97


def test_what_reach_finds_is_one_of_them(arm, rng):
    targets = arm.poses(random_values(arm, rng, 20), "tool")
    found = arm.solutions(targets, np.zeros(6), "tool")
    values, report = arm.reach(targets[:, np.newaxis], random_values(arm, rng, 20, 30), "tool", angular_tolerance=1e-9, linear_tolerance=1e-9)
    assert report.converged.mean() > 0.9
    apart = np.abs(np.sin((values[:, :, np.newaxis] - found.values[:, np.newaxis]) / 2)).max(axis=-1)
    assert (np.nanmin(apart, axis=-1)[report.converged] < 1e-5).all()


def test_other_arms_are_searched_and_say_so(other, rng):
    values = random_values(other, rng, 5)
    found = other.solutions(other.poses(values, -1), values)
    assert not found.complete.any() and (found.counts >= 1).all() and (found.distances[:, 0] < 1e-6).all()


def test_one_target_of_a_robot_that_has_more_joints_gives_scalars_and_keeps_their_values(arm):
    start = [0.3, 0.2, -0.5, 0.4, 0.6, 0.1]
    axes, offsets = [[0, 0, 1], [0, 1, 0], [0, 1, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [0, 0, 1]], np.zeros((7, 3))
    offsets[1:6] = [0.1, 0, 0.1], [0, 0, 0.5], [0.2, 0, 0.03], [0.2, 0, 0], [0.07, 0, 0]
    robot = dq8.Mechanism([-1, 0, 1, 2, 3, 4, 5], "revolute", axes, dq8.from_translation(offsets), links=list("abcdefg"))
    start.append(2.5)
    found = robot.solutions(robot.poses(start, "f"), start, "f")
    assert found.counts.shape == () and found.complete and found.values.shape == (8, 7)
    assert (found.values[: found.counts, 6] == 2.5).all()
    # By name, in any order.
    columns = dict(zip(reversed(robot.values), reversed(start)))
    np.testing.assert_array_equal(robot.solutions(robot.poses(start, "f"), columns, "f").values, found.values)
    again = pickle.loads(pickle.dumps(found))
    assert type(again) is dq8.Solutions
    np.testing.assert_array_equal(again.values, found.values)


def test_nothing_is_found_out_of_reach(arm):
    found = arm.solutions(dq8.from_translation([9.0, 0, 0]), np.zeros(6), "tool")
    assert found.counts == 0 and found.complete and np.isnan(found.values).all() and not found.singular.any()


def test_threads_change_nothing(arm, rng):
    values = random_values(arm, rng, 2000)
    targets = arm.poses(values, "tool")
    alone = arm.solutions(targets, values, "tool")
    dq8.set_num_threads(2)
    try:
        shared = arm.solutions(targets, values, "tool")
    finally:
        dq8.set_num_threads(1)
    for one, two in zip(alone, shared):
        np.testing.assert_array_equal(one, two)


def test_errors_name_what_is_wrong(arm, rng):
    targets, start = np.tile(dq8.identity(), (300, 1)), np.zeros((300, 6))
    with pytest.raises(ValueError, match=r"`values` to have shape \(\.\.\., 6\), got \(5,\)"):
        arm.solutions(targets, np.zeros(5), "tool")
    with pytest.raises(ValueError, match=r"broadcast.*`targets` \(300,\), `values` \(4,\)"):
        arm.solutions(targets, np.zeros((4, 6)), "tool")
    with pytest.raises(ValueError, match="`link`: 4 hinges carry the link"):
        arm.solutions(targets, start, "wrist_roll")
    with pytest.raises(ValueError, match='`link`: there is no link "hand"'):
        arm.solutions(targets, start, "hand")
    targets[270, 3] = 2.0
    with pytest.raises(ValueError, match="target 270 is not a unit motion"):
        arm.solutions(targets, start, "tool")
    start[290, 2] = np.nan
    targets[270, 3] = 1.0
    assert arm.solutions(targets, start, "tool").counts[290] == 0
