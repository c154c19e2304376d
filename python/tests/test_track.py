"""Goals with points, bases that float, and clips: forward kinematics of what comes back, and numbers that Rust computes."""

import copy
import pickle

import numpy as np
import pytest
from robots import ROBOTS, random_values

import dq8
from dq8 import Goal


@pytest.fixture(scope="module")
def person() -> dq8.Mechanism:
    return dq8.Mechanism.from_urdf(ROBOTS / "humanoid.urdf").floating()


@pytest.fixture(scope="module")
def arm() -> dq8.Mechanism:
    return dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")


def configurations(person: dq8.Mechanism, rng: np.random.Generator, *shape: int) -> np.ndarray:
    """Configurations whose bases have moved a little."""
    values = random_values(person, rng, *shape)
    values[..., :7] = dq8.rotation(dq8.identity()).tolist() + [0.0] * 3 + 0.2 * rng.normal(size=(*shape, 7))
    values[..., :4] /= np.linalg.norm(values[..., :4], axis=-1, keepdims=True)
    return values


def moving(robot: dq8.Mechanism, rng: np.random.Generator, frames: int) -> np.ndarray:
    """Configurations that move slowly within the limits, from half way between them."""
    low, high = np.clip(robot.limits, -2, 2).T
    phase = 0.03 * np.arange(frames)[:, np.newaxis] + rng.uniform(0, 6, len(low))
    values = (low + high) / 2 + 0.1 * (high - low) * np.sin(phase)
    if "root_joint.qw" in robot.values:
        values[:, :7] = 0.1 * np.sin(phase[:, :7])
        values[:, 3] = 1.0
    return values


def points_of(robot: dq8.Mechanism, values: np.ndarray, goals: list[Goal]) -> np.ndarray:
    """Where the points of goals are, by matrices."""
    matrices = dq8.to_matrix(robot.poses(values, [goal.link for goal in goals]))
    points = np.array([[*goal.point, 1.0] for goal in goals])
    return (matrices @ points[..., np.newaxis])[..., :3, 0]


# Bases that float.


def test_a_base_that_floats_moves_everything_by_its_pose(rng):
    fixed = dq8.Mechanism.from_urdf(ROBOTS / "humanoid.urdf")
    person = fixed.floating()
    assert person.values[:7] == [f"root_joint.{part}" for part in ("qx", "qy", "qz", "qw", "x", "y", "z")]
    assert person.values[7:] == fixed.values and person.links == fixed.links and person.name == fixed.name
    assert len(person.rates) == len(fixed.rates) + 6 and np.isinf(person.velocity_limits[:6]).all()
    values = configurations(person, rng, 20)
    bases = dq8.from_rotation_translation(values[:, :4], values[:, 4:7])
    expected = dq8.mul(bases[:, np.newaxis], fixed.poses(values[:, 7:]))
    np.testing.assert_allclose(person.poses(values), expected, rtol=0, atol=1e-14)


def test_a_base_of_arrays_floats_from_where_it_stood():
    stand = dq8.from_translation([[0.0, 0, 0.5], [1, 0, 0]])
    robot = dq8.Mechanism([-1, 0], ["fixed", "revolute"], [0, 0, 1], stand, links=["body", "arm"])
    still = [0, 0, 0, 1, 0, 0, 0, 0.3]
    np.testing.assert_array_equal(robot.floating().poses(still), robot.poses([0.3]))
    assert robot.floating().values[0] == "root_joint.qx" and robot.floating().joints == ["root_joint", "arm"]


def test_a_robot_that_floats_is_pickled_copied_and_compared():
    fixed = dq8.Mechanism.from_urdf(ROBOTS / "humanoid.urdf")
    person = fixed.floating()
    for same in (pickle.loads(pickle.dumps(person)), copy.deepcopy(person), fixed.floating()):
        assert same == person and hash(same) == hash(person) and same.values == person.values
    assert person != fixed and fixed != person


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        (lambda: dq8.Mechanism.from_urdf(ROBOTS / "humanoid.urdf").floating(), 'joint "root_joint" already'),
        (lambda: dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.identity()), "one link that is fixed to the base"),
        (lambda: dq8.Mechanism([-1, -1], "fixed", [0, 0, 1], dq8.identity()), "one link that is fixed to the base"),
        (lambda: dq8.Mechanism([-1, 0], "fixed", [0, 0, 1], dq8.identity(), links=["a", "root_joint"]), "already"),
    ],
)
def test_what_cannot_float_is_refused(robot, message):
    with pytest.raises(ValueError, match=message):
        robot().floating()


# Goals.


def test_points_of_several_links_come_to_their_targets(person, rng):
    goals = [Goal.position("left_palm").at([0.05, 0.0, -0.1]), Goal.position(14).at([0, 0.1, 0.02]), Goal.pose("pelvis")]
    wanted = configurations(person, rng, 2, 10)
    targets = person.poses(wanted, [goal.link for goal in goals])
    targets[..., :2, :] = dq8.from_translation(points_of(person, wanted, goals)[..., :2, :])
    values, report = person.reach(targets, wanted + 0.05 * rng.normal(size=wanted.shape), goals, max_iterations=1000)
    assert report.converged.all() and report.converged.shape == (2, 10)
    found = points_of(person, values, goals)
    np.testing.assert_allclose(found, dq8.translation(targets), rtol=0, atol=2e-5)
    assert dq8.angle_to(person.poses(values, "pelvis"), targets[..., 2, :]).max() < 1.1e-5


def test_positions_alone_are_targets_too(arm, rng):
    goal = Goal.position("hand").at([0.0, 0.05, 0.1])
    wanted, start = random_values(arm, rng, 30), random_values(arm, rng)
    points = points_of(arm, wanted, [goal])[:, 0]
    values, report = arm.reach(points, start, goal)
    np.testing.assert_array_equal(values, arm.reach(dq8.from_translation(points), start, goal)[0])
    assert report.converged.all()
    np.testing.assert_allclose(points_of(arm, values, [goal])[:, 0], points, rtol=0, atol=1.1e-5)
    # Links without goals: the position of each is asked for.
    origins = dq8.translation(arm.poses(wanted, ["hand", 3]))
    expected = arm.reach(arm.poses(wanted, ["hand", 3]), start, [Goal.position("hand"), Goal.position(3)])[0]
    np.testing.assert_allclose(arm.reach(origins, start, ["hand", 3])[0], expected, rtol=0, atol=1e-9)
    single = arm.reach(points.astype(np.float32), start.astype(np.float32), goal)[0]
    assert single.dtype == np.float32


def test_goals_weigh_as_the_weights_of_a_call(arm, rng):
    targets, start = arm.poses(random_values(arm, rng, 20), ["hand", 2]), random_values(arm, rng)
    weights = np.array([[1.0, 2, 0, 1, 0.5, 3], [0, 0, 0, 1, 1, 2]])
    goals = [Goal("hand", weights[0, :3], weights[0, 3:]), Goal.position(2).with_linear([1, 1, 2])]
    expected = arm.reach(targets, start, ["hand", 2], weights=weights)[0]
    np.testing.assert_array_equal(arm.reach(targets, start, goals)[0], expected)
    np.testing.assert_array_equal(arm.reach(targets, start, tuple(goals))[0], expected)


def test_goals_are_values():
    goal = Goal.pose("hand").weighing(0.5, 2).at(np.array([1, 2, 3]))
    assert goal == Goal("hand", (0.5,) * 3, [2] * 3, (1, 2, 3)) and hash(goal) == hash(copy.deepcopy(goal))
    assert goal == pickle.loads(pickle.dumps(goal)) and goal != Goal.pose("hand")
    assert Goal.orientation(3).linear == (0, 0, 0) and Goal.orientation(3).with_angular([1, 0, 0]).angular == (1, 0, 0)
    for wrong in (lambda: Goal(0, point=[1, 2]), lambda: Goal(0).at(3.0), lambda: Goal(0, angular=np.eye(3))):
        with pytest.raises(ValueError, match="to be three numbers, got shape"):
            wrong()


# Clips.

RUST = [
    Goal.pose("pelvis").weighing(0.5, 1.0),
    Goal.position("left_sole").at([0.05, 0.0, 0.0]),
    Goal.position("right_sole").at([0.05, 0.0, 0.0]),
    Goal.pose("left_palm").with_angular([0.1, 0.2, 0.3]).with_linear([1.0, 2.0, 3.0]),
    Goal.orientation("head"),
]


# Of the last frame: what `Reach::track` of dq8-robot returns, without lanes.
KNOWN = [
    -0.0008369847230397083, 0.26550438566701406, 0.001365205691206006, 0.9641083221617661, 0.06498077403157297,
    0.0002721555660067957, -0.07345151765299775, -0.5076628553434724, 0.013362439329399994, -0.0065890678811306004,
    0.0, -0.8, -0.26, -0.5064075511908934, -0.01282656259153909, 0.006217901856709707, 0.0, -0.8, 0.26, 0.15917519856375553,
]  # fmt: skip
KNOWN_ERROR = 0.04891229320070734


def of_rust(person: dq8.Mechanism) -> tuple[np.ndarray, np.ndarray]:
    """Targets and a start, as the program has them that `KNOWN` is from."""
    zero = np.zeros(len(person.values))
    zero[3] = 1.0
    frames = np.arange(5.0)
    shift = lambda x, y, z: dq8.from_translation(np.stack(np.broadcast_arrays(x, y, z, frames)[:3], axis=-1))
    up, head = shift(0.05, 0, 0.01 * frames), dq8.from_axis_angle([0.0, 0, 1], 0.05 * frames)
    at = lambda name: person.poses(zero, name)
    targets = [
        shift(0.02 * frames, 0, -0.03 * frames),
        dq8.mul(at("left_sole"), up),
        dq8.mul(at("right_sole"), up),
        dq8.mul(at("left_palm"), shift(0.05 * frames, 0.02 * frames, 0)),
        dq8.mul(at("head"), dq8.from_rotation(head) if head.shape[-1] == 4 else head),
    ]
    return np.stack(targets, axis=1), zero


def test_the_last_frame_of_a_clip_has_the_numbers_of_rust(person):
    targets, start = of_rust(person)
    values, report = person.track(targets, start, RUST, start_weight=0.1, floating_weight=0.2)
    np.testing.assert_allclose(values[4, :20], KNOWN, rtol=0, atol=1e-9)
    assert report.linear_error[4] == pytest.approx(KNOWN_ERROR, abs=1e-9)


def test_a_clip_that_can_be_reached_is_followed(person, rng):
    goals = [Goal.pose("pelvis"), Goal.position("left_palm").at([0.1, 0, 0]), Goal.position("right_sole"), Goal.orientation("head")]
    wanted = moving(person, rng, 200)
    targets = person.poses(wanted, [goal.link for goal in goals])
    targets[:, 1:3] = dq8.from_translation(points_of(person, wanted, goals)[:, 1:3])
    values, report = person.track(targets, wanted[0], goals)
    assert values.shape == wanted.shape and report.linear_error.shape == (200,)
    apart = np.linalg.norm(points_of(person, values, goals)[:, :3] - dq8.translation(targets[:, :3]), axis=-1)
    np.testing.assert_allclose(report.linear_error, apart.max(axis=1), rtol=0, atol=1e-9)
    assert apart.max() < 0.02
    low, high = person.limits.T
    assert (low <= values).all() and (values <= high).all()


def test_each_frame_begins_from_the_one_before(arm, rng):
    wanted = moving(arm, rng, 60)
    targets = arm.poses(wanted, "hand")
    values, report = arm.track(targets, wanted[0], "hand")
    now = wanted[0]
    for frame, target in enumerate(targets):
        now, said = arm.track(target[np.newaxis], now, "hand")
        now = now[0]
        np.testing.assert_array_equal(now, values[frame])
        assert said.iterations[0] == report.iterations[frame]


def test_clips_in_leading_dimensions_and_of_any_lengths_are_those_alone(arm, rng, one_thread):
    lengths = [40, 0, 700, 1, *rng.integers(1, 90, size=100)]
    clips = [moving(arm, rng, length) for length in lengths]
    starts = np.array([clip[0] if len(clip) else np.zeros(len(arm.values)) for clip in clips])
    targets = arm.poses(np.concatenate(clips), ["hand", 3])
    values, report = arm.sequence(lengths, targets, starts, ["hand", 3])
    ends = np.cumsum(lengths)
    for end, length, start in zip(ends, lengths, starts):
        frames = slice(end - length, end)
        alone, said = arm.track(targets[frames], start, ["hand", 3])
        np.testing.assert_array_equal(values[frames], alone)
        np.testing.assert_array_equal(report.linear_error[frames], said.linear_error)
    dq8.set_num_threads(3)
    again, said = arm.sequence(np.array(lengths, np.uint8 if max(lengths) < 256 else np.int32), targets, starts, ["hand", 3])
    np.testing.assert_array_equal(again, values)
    np.testing.assert_array_equal(said.outcome, report.outcome)
    # Of one length: starts and targets broadcast.
    two = targets[ends[0] - 40 : ends[0]]
    many = arm.track(np.stack([two, two[::-1]])[:, np.newaxis], starts[:3], ["hand", 3])[0]
    assert many.shape == (2, 3, 40, len(arm.values))
    np.testing.assert_array_equal(many[1, 2], arm.track(two[::-1], starts[2], ["hand", 3])[0])


def test_float32_is_rounded_float64(arm, rng):
    wanted = moving(arm, rng, 30).astype(np.float32)
    targets = arm.poses(wanted, "hand")
    values, report = arm.track(targets, wanted[0], "hand")
    assert values.dtype == report.linear_error.dtype == np.float32
    expected = arm.track(targets.astype(float), wanted[0].astype(float), "hand")[0]
    np.testing.assert_array_equal(values, expected.astype(np.float32))


def test_a_frame_without_a_target_keeps_the_values_of_the_one_before(arm, rng):
    wanted = moving(arm, rng, 20)
    targets = np.stack([arm.poses(wanted, "hand")] * 3)
    targets[1, 7] = np.nan
    targets[2, 0] = 2.0
    values, report = arm.track(targets, wanted[0], "hand")
    np.testing.assert_array_equal(values[1, :7], values[0, :7])
    np.testing.assert_array_equal(values[1, 7], values[0, 6])
    np.testing.assert_array_equal(values[2, 0], wanted[0])
    invalid = np.zeros((3, 20), bool)
    invalid[1, 7] = invalid[2, 0] = True
    np.testing.assert_array_equal(report.outcome == dq8.Outcome.INVALID, invalid)
    assert (np.isnan(report.linear_error) == invalid).all()
    starts = np.stack([wanted[0]] * 3)
    starts[1, 2] = np.inf
    clean = np.stack([targets[0]] * 3)
    values, report = arm.track(clean, starts, "hand")
    assert (report.outcome[1] == dq8.Outcome.INVALID).all() and np.isinf(values[1, :, 2]).all()
    np.testing.assert_array_equal(values[2], values[0])


def test_weights_hold_joints_bases_and_postures(person, rng):
    goals = [Goal.position("left_palm"), Goal.position("right_palm")]
    zero = np.zeros(len(person.values))
    zero[3] = 1.0
    away = dq8.translation(person.poses(zero, ["left_palm", "right_palm"])) + [0.3, 0, 0.1]
    clip = np.tile(away, (10, 1, 1))
    free, held = person.track(clip, zero, goals)[0], person.track(clip, zero, goals, floating_weight=5.0)[0]
    assert np.abs(held[-1, 4:7]).max() < 0.3 * np.abs(free[-1, 4:7]).max()
    slow = person.track(clip, zero, goals, start_weight=3.0)[0]
    assert np.abs(np.diff(slow[:, 7:], axis=0)).max() < 0.5 * np.abs(np.diff(np.vstack([zero, free])[:, 7:], axis=0)).max()
    bent = zero.copy()
    bent[7:] = np.clip(0.3, *person.limits[7:].T)
    near = person.track(clip, zero, goals, posture=bent, posture_weight=1.0)[0][-1, 7:] - bent[7:]
    assert np.linalg.norm(near) < 0.5 * np.linalg.norm(free[-1, 7:] - bent[7:])


def test_steady_robots_stand_still_beyond_reach(arm):
    far = np.tile([[0.3, 0.4, 5.0]], (60, 1))
    start = np.clip(0.5, *arm.limits.T) + 0.01 * np.arange(len(arm.values))
    start = np.clip(start, *arm.limits.T)
    values, _ = arm.track(far, start, Goal.position("hand"), steady=True)
    assert (values[-1] == values[-10]).all()


def test_out_may_overlap_targets_and_starts(arm, rng):
    wanted, count = moving(arm, rng, 30), len(arm.values)
    memory = np.zeros(30 * 8 + 30 * count)
    targets, out = memory[: 30 * 8].reshape(30, 8), memory[8 * 15 : 8 * 15 + 30 * count].reshape(30, count)
    targets[:] = arm.poses(wanted, "hand")
    expected = arm.track(targets.copy(), wanted[0], "hand")[0]
    assert arm.track(targets, wanted[0], "hand", out=out)[0] is out
    np.testing.assert_array_equal(out, expected)
    out[20] = wanted[0]
    np.testing.assert_array_equal(arm.track(arm.poses(wanted, "hand"), out[20], "hand", out=out)[0], expected)


def test_columns_by_name_are_starts_and_postures(arm, rng):
    wanted = moving(arm, rng, 30)
    targets, names = arm.poses(wanted, "hand"), arm.values
    expected = arm.track(targets, wanted[0], "hand", posture=wanted[3], posture_weight=0.1)[0]
    start, posture = (dict(reversed(list(zip(names, row)))) for row in (wanted[0], wanted[3]))
    np.testing.assert_array_equal(arm.track(targets, start, "hand", posture=posture, posture_weight=0.1)[0], expected)


ROUND, START = np.tile(np.eye(8)[3], (4, 1)), np.zeros(3)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda m, out: m.track(np.eye(8)[3], START, 2), ValueError, r"Expected `targets` to have shape \(\.\.\., frames, 8\), got \(8,\)"),
        (lambda m, out: m.track(np.ones((2, 8)), START, [1, 2]), ValueError, r"Expected `targets` to have shape \(\.\.\., frames, 2, 8\), got \(2, 8\)"),
        (lambda m, out: m.track(np.ones((4, 2, 7)), START, [1, 2]), ValueError, r"Expected `targets` to have shape \(\.\.\., 8\)"),
        (lambda m, out: m.track(ROUND, np.zeros(4), 2, out=out), ValueError, r"Expected `values` to have shape \(\.\.\., 3\), got \(4,\)"),
        (lambda m, out: m.track(np.ones((5, 4, 8)), np.zeros((2, 3)), 2), ValueError, r"leading dimensions `targets` \(5,\), `values` \(2,\)"),
        (lambda m, out: m.track(ROUND, START, "tool", out=out), ValueError, r"`links`: there is no link \"tool\""),
        (lambda m, out: m.track(ROUND, START, Goal.pose("tool"), out=out), ValueError, r"`links`: there is no link \"tool\""),
        (lambda m, out: m.track(ROUND, START, {1, 2}, out=out), TypeError, r"a set, which has no order"),
        (lambda m, out: m.track(ROUND, START, Goal(2, angular=[1, -1, 1]), out=out), ValueError, r"`weights`: component 1 of goal 0 .* -1"),
        (lambda m, out: m.track(ROUND, START, Goal(2, point=[0, np.nan, 0]), out=out), ValueError, r"`links`: component 1 of the point of goal 0 is not finite"),
        (lambda m, out: m.track(ROUND, START, Goal(2), weights=np.ones(6), out=out), ValueError, r"`weights`: goal 0 of `links` has weights of its own"),
        (lambda m, out: m.track(np.ones((4, 3)), START, Goal.pose(2), out=out), ValueError, r"`targets` are positions, and goal 0 asks for a rotation"),
        (lambda m, out: m.track(np.ones((4, 3)), START, 2, weights=np.ones(6), out=out), ValueError, r"goal 0 asks for a rotation"),
        (lambda m, out: m.track(ROUND, START, 2, least_gain=1.5, out=out), ValueError, r"Expected `least_gain` to be from 0 to 1, got 1.5"),
        (lambda m, out: m.track(ROUND, START, 2, floating_weight=-1.0, out=out), ValueError, r"Expected `floating_weight` to be finite and at least 0, got -1"),
        (lambda m, out: m.track(ROUND, START, 2, start_weight=np.inf, out=out), ValueError, r"Expected `start_weight` .* inf"),
        (lambda m, out: m.track(ROUND, START, 2, posture_weight=np.nan, out=out), ValueError, r"Expected `posture_weight` .* NaN"),
        (lambda m, out: m.track(ROUND, START, 2, damping="much", out=out), TypeError, r"'damping'"),
        (lambda m, out: m.track(ROUND, START, 2, out=np.zeros(3)), ValueError, r"Expected `out` to have shape \(4, 3\).*\(3,\)"),
        (lambda m, out: m.sequence([2, 3], ROUND, START, 2, out=out), ValueError, r"`clips` have 5 frames together, and `targets` have 4"),
        (lambda m, out: m.sequence([5, -1], ROUND, START, 2, out=out), ValueError, r"`clips`: clip 1 has -1 frames"),
        (lambda m, out: m.sequence([2.5, 1.5], ROUND, START, 2, out=out), ValueError, r"`clips`: clip 0 has 2.5 frames"),
        (lambda m, out: m.sequence(4, ROUND, START, 2, out=out), ValueError, r"Expected `clips` to have shape \(clips,\), got \(\)"),
        (lambda m, out: m.sequence([3, 1], ROUND, np.zeros((3, 3)), 2, out=out), ValueError, r"Expected `values` to have shape \(2, 3\) or \(3,\), got \(3, 3\)"),
        (lambda m, out: m.sequence([4], ROUND[np.newaxis], START, 2, out=out), ValueError, r"Expected `targets` to have shape \(4, 8\), got \(1, 4, 8\)"),
    ],
)  # fmt: skip
def test_errors_name_the_argument_and_leave_out_untouched(call, error, message):
    arm = dq8.Mechanism([-1, 0, 1], "revolute", [0, 0, 1], dq8.from_translation([1.0, 0, 0]))
    out = np.full((4, 3), 7.0)
    with pytest.raises(error, match=message):
        call(arm, out)
    assert (out == 7.0).all()


def test_no_frames_and_no_clips_are_no_values(arm):
    start = np.zeros(len(arm.values))
    values, report = arm.track(np.zeros((0, 8)), start, "hand")
    assert values.shape == (0, len(start)) and report.converged.shape == (0,)
    assert arm.track(np.zeros((5, 0, 8)), start, "hand")[0].shape == (5, 0, len(start))
    assert arm.sequence([], np.zeros((0, 8)), start, "hand")[0].shape == (0, len(start))
    assert arm.sequence([0, 0], np.zeros((0, 8)), start, "hand")[0].shape == (0, len(start))
