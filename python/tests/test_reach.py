"""Inverse kinematics of mechanisms: forward kinematics, in NumPy, of what comes back."""

import copy
import pickle

import numpy as np
import pandas as pd
import pytest
from robots import ROBOTS, random_values

import dq8

NONE = [-np.inf, np.inf]
POSITION = [0, 0, 0, 1, 1, 1]


@pytest.fixture(scope="module")
def arm() -> dq8.Mechanism:
    return dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")


@pytest.fixture
def planar() -> dq8.Mechanism:
    """Three hinges about z, a meter apart; the last link is where the third hinge is."""
    offsets = dq8.from_translation([[0.0, 0, 0], [1, 0, 0], [1, 0, 0]])
    return dq8.Mechanism([-1, 0, 1], "revolute", [0, 0, 1], offsets)


def matrices_of_planar(values: np.ndarray) -> np.ndarray:
    """The poses of the links of `planar`, by products of matrices."""
    links, pose = [], np.broadcast_to(np.eye(4), (*values.shape[:-1], 4, 4))
    for joint in range(3):
        c, s = np.cos(values[..., joint]), np.sin(values[..., joint])
        step = np.zeros((*c.shape, 4, 4))
        step[..., 0, 0] = step[..., 1, 1] = c
        step[..., 1, 0], step[..., 0, 1] = s, -s
        step[..., 0, 3] = 1.0 if joint else 0.0
        step[..., 2, 2] = step[..., 3, 3] = 1
        pose = pose @ step
        links.append(pose)
    return np.stack(links, axis=-3)


def test_poses_of_what_comes_back_are_the_targets(arm, rng):
    targets = arm.poses(random_values(arm, rng, 3, 50), "hand")
    start = random_values(arm, rng, 50)
    values, report = arm.reach(targets, start, "hand")
    assert values.shape == (3, 50, len(arm.values)) and report.converged.shape == (3, 50)
    assert report.converged.mean() > 0.98
    reached = arm.poses(values, "hand")[report.converged]
    assert dq8.angle_to(reached, targets[report.converged]).max() < 1.001e-5
    assert dq8.distance_to(reached, targets[report.converged]).max() < 1.001e-5
    low, high = arm.limits.T
    assert (values >= low).all() and (values <= high).all()


def test_a_planar_arm_reaches_by_its_matrices(planar, rng):
    wanted = matrices_of_planar(rng.uniform(-2, 2, size=(40, 3)))[:, 2]
    values, report = planar.reach(dq8.from_matrix(wanted), [0.1, 0.2, 0.3], 2)
    assert report.converged.all()
    np.testing.assert_allclose(matrices_of_planar(values)[:, 2], wanted, rtol=0, atol=2e-5)


def test_errors_in_the_report_are_those_at_the_values(arm, rng):
    targets = arm.poses(random_values(arm, rng, 40), "hand")
    far = dq8.mul(dq8.from_translation([0.3, 0.0, 0.2]), targets)
    values, report = arm.reach(far, random_values(arm, rng, 40), "hand", max_iterations=4, restarts=False)
    reached = arm.poses(values, "hand")
    np.testing.assert_allclose(report.angular_error, dq8.angle_to(reached, far), rtol=0, atol=1e-12)
    np.testing.assert_allclose(report.linear_error, dq8.distance_to(reached, far), rtol=0, atol=1e-12)
    assert (report.iterations <= 4).all() and (report.restarts == 0).all()
    assert (report.converged == (report.outcome == dq8.Outcome.CONVERGED)).all()
    np.testing.assert_array_equal(report.converged, (report.angular_error <= 1e-5) & (report.linear_error <= 1e-5))


@pytest.mark.parametrize("count", [-1, 2**32, 10**30])
def test_a_number_of_iterations_out_of_range_is_told_with_the_range(planar, count):
    target, start, path = dq8.identity(), [0.1, 0.2, 0.3], dq8.random(9, rng=1)
    for call in (
        lambda: planar.reach(target, start, 2, max_iterations=count),
        lambda: planar.track(dq8.identity((4, 1)), start, [2], max_iterations=count),
        lambda: dq8.mean(path, max_iterations=count),
        lambda: dq8.dib_windows(path, np.ones(3), max_iterations=count),
    ):
        with pytest.raises(OverflowError, match=f"Expected `max_iterations` to be from 0 to 4294967295, got {count}."):
            call()
    with pytest.raises(TypeError, match="max_iterations"):
        dq8.mean(path, max_iterations=1.5)


def test_weights_of_zero_leave_the_rotation_free(planar):
    target = dq8.from_rotation_translation([1.0, 0, 0, 0], [1.2, 0.8, 0.0])
    assert not planar.reach(target, [0.1, 0.2, 0.3], 2)[1].converged
    values, report = planar.reach(target, [0.1, 0.2, 0.3], 2, weights=POSITION)
    assert report.converged
    np.testing.assert_allclose(matrices_of_planar(values)[2, :3, 3], [1.2, 0.8, 0], rtol=0, atol=1e-5)


def test_several_links_have_a_target_each(planar, rng):
    wanted = planar.poses(rng.uniform(-2, 2, size=(20, 3)), [1, 2])
    values, report = planar.reach(wanted, np.full(3, 0.1), [1, 2], weights=[POSITION, [1, 1, 1, 0, 0, 0]])
    assert report.converged.all() and report.converged.shape == (20,)
    reached = planar.poses(values, [1, 2])
    assert dq8.distance_to(reached[:, 0], wanted[:, 0]).max() < 1e-5
    assert dq8.angle_to(reached[:, 1], wanted[:, 1]).max() < 1e-5


def test_freedom_that_is_left_goes_to_the_posture(planar):
    target = dq8.from_translation([1.2, 0.8, 0.0])
    values, report = planar.reach(target, [0.1, 0.2, 0.3], 2, weights=POSITION, posture=[0.0, 0.0, 1.25])
    assert report.converged
    assert values[2] == pytest.approx(1.25, abs=1e-3)


def test_outcomes_say_why_a_target_is_not_reached(planar):
    targets = dq8.from_translation([[5.0, 0, 0], [1.2, 0.8, 0.0], [np.nan, 0, 0]])
    start = np.array([0.1, 0.2, 0.3])
    values, report = planar.reach(targets, start, 2, weights=POSITION)
    assert list(map(dq8.Outcome, report.outcome)) == [
        dq8.Outcome.OUT_OF_REACH,
        dq8.Outcome.CONVERGED,
        dq8.Outcome.INVALID,
    ]
    np.testing.assert_array_equal(values[2], start)
    assert np.isnan(report.linear_error[2])
    assert "1 of 3" in repr(report)
    held = dq8.Mechanism([-1, 0], ["revolute", "fixed"], [0, 0, 1], dq8.from_translation([1.0, 0, 0]), [[-0.5, 0.5], NONE])
    assert held.reach(held.poses([0.4], 1), [0.0], 1)[1].outcome == dq8.Outcome.CONVERGED
    aside = dq8.from_translation([1.0, 0.9, 0.0])
    values, report = held.reach(aside, [0.0], 1, weights=POSITION)
    assert report.outcome == dq8.Outcome.AT_LIMITS and values[0] == 0.5


def test_iterations_end_where_they_should(planar):
    target = planar.poses([2.0, -1.0, 0.5], 2)
    _, report = planar.reach(target, [0.1, 0.2, 0.3], 2, max_iterations=1)
    assert report.outcome == dq8.Outcome.UNFINISHED and report.iterations == 1
    _, report = planar.reach(target, [2.0, -1.0, 0.5], 2)
    assert report.converged and report.iterations == 0


def test_tighter_tolerances_leave_less(arm, rng):
    targets = arm.poses(random_values(arm, rng, 30), "hand")
    start = random_values(arm, rng, 30)
    tight = {"angular_tolerance": 1e-11, "linear_tolerance": 1e-11}
    values, report = arm.reach(targets, start, "hand", **tight)
    assert report.converged.mean() > 0.9
    reached = report.converged
    assert dq8.distance_to(arm.poses(values, "hand"), targets)[reached].max() < 1.1e-11


def test_float32_stays_float32(arm, rng):
    targets = arm.poses(random_values(arm, rng, 50), "hand").astype(np.float32)
    start = random_values(arm, rng, 50).astype(np.float32)
    values, report = arm.reach(targets, start, "hand", weights=np.ones(6))
    assert values.dtype == report.angular_error.dtype == np.float32
    assert report.iterations.dtype == report.restarts.dtype == np.uint32
    assert report.converged.dtype == bool and report.outcome.dtype == np.uint8
    assert report.converged.mean() > 0.95
    distances = dq8.distance_to(arm.poses(values, "hand"), targets)
    assert distances[report.converged].max() < 1.2e-5


@pytest.mark.parametrize(
    ("targets", "starts"), [((), ()), ((5,), ()), ((), (5,)), ((3, 1), (1, 5)), ((2, 3), (3,)), ((0,), ()), ((0, 3), (3,))]
)
def test_leading_dimensions_broadcast_as_in_numpy(planar, rng, targets, starts):
    for links in (2, [1, 2]):
        wanted, start = planar.poses(rng.uniform(-2, 2, size=(*targets, 3)), links), rng.uniform(-1, 1, size=(*starts, 3))
        values, report = planar.reach(wanted, start, links)
        shape = np.broadcast_shapes(targets, starts)
        assert values.shape == (*shape, 3)
        assert np.shape(report.converged) == np.shape(report.linear_error) == shape
        tail = wanted.shape[len(targets) :]
        wanted, start = np.broadcast_to(wanted, (*shape, *tail)), np.broadcast_to(start, (*shape, 3))
        for index in np.ndindex(shape):
            np.testing.assert_array_equal(values[index], planar.reach(wanted[index], start[index], links)[0])


def test_out_may_be_the_start_and_overlap_targets(planar, rng):
    memory = rng.uniform(-1, 1, size=200)
    targets = memory[:80].reshape(10, 8)
    targets[...] = planar.poses(rng.uniform(-2, 2, size=(10, 3)), 2)
    start = memory[60:90].reshape(10, 3)
    expected, _ = planar.reach(targets.copy(), start.copy(), 2)
    values, _ = planar.reach(targets, start, 2, out=start)
    assert values is start
    np.testing.assert_array_equal(values, expected)
    strided = np.full((10, 3, 2), np.nan)[..., 0]
    assert planar.reach(dq8.identity(), expected, 2, out=strided)[0] is strided
    np.testing.assert_array_equal(strided, planar.reach(dq8.identity(), expected, 2)[0])


def test_threads_change_no_bit(arm, rng, one_thread):
    targets, start = arm.poses(random_values(arm, rng, 1500), "hand"), random_values(arm, rng)

    def results():
        values, report = arm.reach(targets, start, "hand")
        return [values, report.outcome, report.iterations, report.restarts, report.angular_error, report.linear_error]

    expected = results()
    dq8.set_num_threads(3)
    for result, one in zip(results(), expected):
        np.testing.assert_array_equal(result, one)


START, TARGET = np.zeros(3), np.eye(8)[3]


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda m, out: m.reach(np.zeros(7), START, 2, out=out), ValueError, r"Expected `targets` to have shape \(\.\.\., 8\), got \(7,\)"),
        (lambda m, out: m.reach(TARGET, START, [1, 2], out=out), ValueError, r"Expected `targets` to have shape \(\.\.\., 2, 8\), got \(8,\)"),
        (lambda m, out: m.reach(np.ones((3, 8)), START, [1, 2]), ValueError, r"Expected `targets` to have shape \(\.\.\., 2, 8\), got \(3, 8\)"),
        (lambda m, out: m.reach(TARGET, np.zeros((5, 4)), 2, out=out), ValueError, r"Expected `values` to have shape \(\.\.\., 3\), got \(5, 4\)"),
        (lambda m, out: m.reach(TARGET, 0.5, 2, out=out), ValueError, r"Expected `values` to have shape \(\.\.\., 3\), got \(\)"),
        (
            lambda m, out: m.reach(np.ones((4, 8)), np.zeros((5, 3)), 2),
            ValueError,
            r"could not be broadcast together: leading dimensions `targets` \(4,\), `values` \(5,\)",
        ),
        (lambda m, out: m.reach(TARGET, START, "tool", out=out), ValueError, r"`links`: there is no link \"tool\""),
        (lambda m, out: m.reach(TARGET, START, 1.5, out=out), TypeError, r"Expected `links` to name links or their numbers"),
        (lambda m, out: m.reach(np.ones((0, 8)), START, [], out=out), ValueError, r"`links`: there is no goal"),
        (lambda m, out: m.reach(TARGET, START, 2, weights=[1, 2], out=out), ValueError, r"Expected `weights` to have shape \(\.\.\., 6\), got \(2,\)"),
        (lambda m, out: m.reach(TARGET, START, 2, weights=np.ones((1, 6)), out=out), ValueError, r"Expected `weights` to have shape \(6,\), got \(1, 6\)"),
        (
            lambda m, out: m.reach(np.ones((2, 8)), START, [1, 2], weights=np.ones((3, 6)), out=out),
            ValueError,
            r"Expected `weights` to have shape \(6,\) or \(2, 6\), got \(3, 6\)",
        ),
        (lambda m, out: m.reach(TARGET, START, 2, weights=[0, 0, -1, 1, 1, 1], out=out), ValueError, r"`weights`: component 2 of goal 0.* -1"),
        (lambda m, out: m.reach(TARGET, START, 2, weights=[0] * 6, out=out), ValueError, r"`weights`: all weights of goal 0 are zero"),
        (lambda m, out: m.reach(TARGET, START, 2, posture=[0, 1], out=out), ValueError, r"Expected `posture` to have shape \(3,\), got \(2,\)"),
        (lambda m, out: m.reach(TARGET, START, 2, posture=[0, 1, np.inf], out=out), ValueError, r"`posture`: value 2 .* inf"),
        (lambda m, out: m.reach(TARGET, START, 2, damping=-1.0, out=out), ValueError, r"Expected `damping` to be finite and at least 0, got -1"),
        (lambda m, out: m.reach(TARGET, START, 2, damping=np.inf, out=out), ValueError, r"Expected `damping` to be finite and at least 0, got inf"),
        (lambda m, out: m.reach(TARGET, START, 2, length_per_radian=0, out=out), ValueError, r"Expected `length_per_radian` to be finite and more than 0, got 0"),
        (lambda m, out: m.reach(np.float32(TARGET), np.float32(START), 2, length_per_radian=1e-50), ValueError, r"Expected `length_per_radian` to be finite and more than 0"),
        (lambda m, out: m.reach(np.float32(TARGET), np.float32(START), 2, max_step=1e-50), ValueError, r"Expected `max_step` to be more than 0"),
        (lambda m, out: m.reach(TARGET, START, 2, max_step=0.0, out=out), ValueError, r"Expected `max_step` to be more than 0, got 0"),
        (lambda m, out: m.reach(TARGET, START, 2, max_step=np.nan, out=out), ValueError, r"Expected `max_step` .* NaN"),
        (lambda m, out: m.reach(TARGET, START, 2, linear_tolerance=np.nan, out=out), ValueError, r"Expected `linear_tolerance` .* NaN"),
        (lambda m, out: m.reach(TARGET, START, 2, max_iterations=-1, out=out), OverflowError, r"max_iterations|negative|unsigned"),
        (lambda m, out: m.reach(TARGET, START, 2, out=np.zeros(4)), ValueError, r"Expected `out` to have shape \(3,\).*\(4,\)"),
        (lambda m, out: m.reach(TARGET, START, 2, out=np.zeros(3, "f4")), TypeError, r"Expected `out` to have dtype float64"),
    ],
)
def test_errors_name_the_argument_and_leave_out_untouched(planar, call, error, message):
    out = np.full(3, 7.0)
    with pytest.raises(error, match=message):
        call(planar, out)
    assert (out == 7.0).all()


def test_limits_that_leave_no_value_are_an_error():
    far = dq8.Mechanism([-1, 0], ["revolute", "fixed"], [0, 0, 1], dq8.from_translation([1.0, 0, 0]), [[1e15, 1e16], NONE])
    with pytest.raises(ValueError, match=r"joint 0 cannot move between"):
        far.reach(np.eye(8)[3], [0.0], 1)


@pytest.mark.parametrize("shape", [(), (4,), (2, 3)])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_reports_pickle_and_are_dicts_of_their_arrays(planar, shape, dtype):
    targets = np.broadcast_to(dq8.from_translation([2.0, 1.0, 0.0]), (*shape, 8)).astype(dtype)
    _, report = planar.reach(targets, np.zeros(3, dtype), 2, weights=POSITION)
    names = ["converged", "outcome", "iterations", "restarts", "angular_error", "linear_error"]
    assert list(report.to_dict()) == names
    for same in (pickle.loads(pickle.dumps(report)), copy.deepcopy(report)):
        assert repr(same) == repr(report)
        for name in names:
            one, other = getattr(report, name), getattr(same, name)
            assert one.dtype == other.dtype and report.to_dict()[name] is one
            np.testing.assert_array_equal(one, other)
    if len(shape) == 1:
        assert pd.DataFrame(report.to_dict()).shape == (*shape, 6)


@pytest.mark.parametrize("restarts", [False, True])
@pytest.mark.parametrize(("start", "there"), [(3.2, 3.25), (9.0, 3.25 + 2 * np.pi), (-3.2, -3.25)])
def test_of_whole_turns_the_nearest_to_the_start_comes_back(planar, start, there, restarts):
    target = planar.poses(np.array([there, 0.9, -0.7]), 2)
    values, report = planar.reach(target, [start, 0.9, -0.7], 2, restarts=restarts)
    assert report.converged
    np.testing.assert_allclose(values, [there, 0.9, -0.7], rtol=0, atol=1e-4)


def test_a_goal_for_a_link_that_no_joint_moves_is_refused():
    offsets = dq8.from_translation([[0.0, 0, 0], [1, 0, 0]])
    machine = dq8.Mechanism([-1, -1], ["revolute", "fixed"], [0, 0, 1], offsets)
    with pytest.raises(ValueError, match="goal 0 is for link 1, which no joint moves"):
        machine.reach(dq8.from_translation([1.0, 0, 0]), [0.1], 1)
