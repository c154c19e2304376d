"""Mechanisms, from URDF and from arrays, against matrices by hand and against pinocchio."""

import copy
import pickle

import numpy as np
import pytest
from robots import ROBOTS, random_values

import dq8

CRANE = """
<robot name="crane">
  <link name="ground"/><link name="tower"/><link name="trolley"/><link name="hook"/>
  <joint name="turn" type="revolute">
    <parent link="ground"/><child link="tower"/>
    <origin xyz="0 0 10"/><axis xyz="0 0 2"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/>
  </joint>
  <joint name="travel" type="prismatic">
    <parent link="tower"/><child link="trolley"/>
    <origin xyz="1 0 0" rpy="0 1.5707963267948966 0"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="8" effort="1" velocity="1"/>
  </joint>
  <joint name="rope" type="fixed">
    <parent link="trolley"/><child link="hook"/>
    <origin xyz="4 0 0"/>
  </joint>
</robot>
"""


@pytest.fixture
def crane() -> dq8.Mechanism:
    return dq8.Mechanism.from_urdf(CRANE)


def hook_by_hand(turn: float, travel: float) -> np.ndarray:
    """The rotation is z by `turn`, then y by a quarter turn; the hook hangs 4 below the trolley."""
    c, s = np.cos(turn), np.sin(turn)
    reach = 1 + travel
    return np.array([[0, -s, c, c * reach], [0, c, s, s * reach], [-1, 0, 0, 6], [0, 0, 0, 1]])


def test_the_hook_of_a_crane_hangs_where_it_does_by_hand(crane, rng, close):
    values = random_values(crane, rng, 21)
    poses = dq8.to_matrix(crane.poses(values, "hook"))
    close(poses, np.array([hook_by_hand(*each) for each in values]), poses)


def test_a_crane_has_the_names_and_limits_of_its_file(crane):
    assert crane.links == ["ground", "tower", "trolley", "hook"]
    assert crane.joints == [None, "turn", "travel", "rope"]
    assert crane.values == crane.rates == ["turn", "travel"]
    np.testing.assert_array_equal(crane.limits, [[-3, 3], [0, 8]])
    assert len(crane) == 4
    assert repr(crane) == "<dq8.Mechanism of 4 links, 2 values>"


@pytest.mark.parametrize("leading", [(), (1,), (9,), (3, 5), (0,), (2, 0)])
def test_poses_and_jacobians_have_the_leading_dimensions_of_values(crane, rng, leading):
    values = random_values(crane, rng, *leading)
    assert crane.poses(values).shape == (*leading, 4, 8)
    assert crane.poses(values, ["hook", 0]).shape == (*leading, 2, 8)
    assert crane.poses(values, []).shape == (*leading, 0, 8)
    assert crane.poses(values, "hook").shape == (*leading, 8)
    assert crane.jacobian(values, "hook").shape == (*leading, 6, 2)
    for index in np.ndindex(*leading):
        np.testing.assert_array_equal(crane.poses(values)[index], crane.poses(values[index]))
        np.testing.assert_array_equal(crane.jacobian(values, 3)[index], crane.jacobian(values[index], 3))


def test_links_are_chosen_by_name_number_and_from_the_end(crane, rng):
    values = random_values(crane, rng, 9)
    every = crane.poses(values)
    for links in (["hook", "tower"], [3, 1], np.array([3, 1]), (-1, "tower")):
        np.testing.assert_array_equal(crane.poses(values, links), every[:, [3, 1]])
    for link in ("trolley", 2, np.int64(2), -2):
        np.testing.assert_array_equal(crane.poses(values, link), every[:, 2])


def test_jacobians_of_a_crane_are_those_by_hand(crane, close):
    # Turned by a quarter: the trolley travels along y, and the turn moves the hook along −x.
    values = [np.pi / 2, 2.0]
    world = [[0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 1, 0]]
    aligned = [[0, 0, 1, -3, 0, 0], [0, 0, 0, 0, 1, 0]]
    body = [[-1, 0, 0, 0, 3, 0], [0, 0, 0, 0, 0, 1]]
    for frame, columns in (("world", world), ("aligned", aligned), ("body", body)):
        jacobian = crane.jacobian(values, "hook", frame)
        close(jacobian, np.transpose(columns))


@pytest.mark.parametrize("robot", ["arm6", "arm7", "humanoid"])
def test_poses_and_jacobians_are_those_of_pinocchio(robot, rng, close):
    pin = pytest.importorskip("pinocchio")
    path = ROBOTS / f"{robot}.urdf"
    own, model = dq8.Mechanism.from_urdf(path), pin.buildModelFromUrdf(str(path), mimic=True)
    data = model.createData()
    values = random_values(own, rng, 7)
    poses = dq8.to_matrix(own.poses(values))
    link = own.links[-1]
    frames = {
        "world": pin.ReferenceFrame.WORLD,
        "body": pin.ReferenceFrame.LOCAL,
        "aligned": pin.ReferenceFrame.LOCAL_WORLD_ALIGNED,
    }
    jacobians = {frame: own.jacobian(values, link, frame) for frame in frames}
    for i, each in enumerate(values):
        # Continuous joints are cosine and sine there.
        configuration, columns = pin.neutral(model), []
        for name, value in zip(own.values, each):
            joint = model.joints[model.getJointId(name)]
            configuration[joint.idx_q : joint.idx_q + joint.nq] = (
                value if joint.nq == 1 else [np.cos(value), np.sin(value)]
            )
            columns.append(joint.idx_v)
        pin.framesForwardKinematics(model, data, configuration)
        for name, pose in zip(own.links, poses[i]):
            close(np.array(data.oMf[model.getFrameId(name)]), pose, poses[i])
        frame_id = model.getFrameId(link)
        for frame, theirs in frames.items():
            # Linear first, there.
            expected = pin.computeFrameJacobian(model, data, configuration, frame_id, theirs)[[3, 4, 5, 0, 1, 2]]
            close(jacobians[frame][i], expected[:, columns], poses[i])


@pytest.mark.parametrize("frame", ["world", "body", "aligned"])
def test_a_jacobian_is_the_derivative_of_the_pose(rng, frame):
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
    values, step = random_values(arm, rng, 9), 1e-6
    here = arm.poses(values, "hand")
    jacobian = arm.jacobian(values, "hand", frame)
    for i in range(len(arm.values)):
        ahead, behind = (arm.poses(values + way * step * np.eye(8)[i], "hand") for way in (1, -1))
        if frame == "body":
            twist = dq8.to_twist(dq8.mul(dq8.conjugate(behind), ahead))
        else:
            twist = dq8.to_twist(dq8.mul(ahead, dq8.conjugate(behind)))
        if frame == "aligned":
            twist[:, 3:] += np.cross(twist[:, :3], dq8.translation(here))
        # Rounding over the step: 1e-16 / 1e-6, and some operations.
        np.testing.assert_allclose(jacobian[..., i], twist / (2 * step), rtol=0, atol=2e-9)


def test_the_second_finger_mimics_the_first():
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
    assert arm.values[-1] == "finger_joint" and len(arm.values) == 8
    hand, left, right = arm.poses([0.0] * 7 + [0.03], ["hand", "finger_left", "finger_right"])
    left, right = (dq8.translation(dq8.mul(dq8.conjugate(hand), finger)) for finger in (left, right))
    np.testing.assert_allclose(left * [1, -1, 1], right, rtol=0, atol=1e-15)


def test_a_mechanism_of_arrays_is_that_of_its_file(crane, rng):
    placements = [[0, 0, 0, 1, 0, 0, 0, 0], dq8.from_translation([0, 0, 10.0])]
    placements += [dq8.from_rotation_translation([0, np.sqrt(0.5), 0, np.sqrt(0.5)], [1.0, 0, 0])]
    placements += [dq8.from_translation([4.0, 0, 0])]
    kinds = ["fixed", "revolute", "prismatic", "fixed"]
    unlimited = [-np.inf, np.inf]
    limits, links = [unlimited, [-3, 3], [0, 8], unlimited], ["ground", "tower", "trolley", "hook"]
    own = dq8.Mechanism([-1, 0, 1, 2], kinds, [0, 0, 1], placements, limits=limits, links=links)
    values = random_values(crane, rng, 9)
    np.testing.assert_allclose(own.poses(values), crane.poses(values), rtol=0, atol=1e-14)
    np.testing.assert_array_equal(own.limits, crane.limits)
    assert own.links == crane.links
    assert own.values == ["tower", "trolley"]


def test_planar_and_floating_joints_have_several_values(random_motions, close):
    kinds, placements = ["floating", "planar"], dq8.identity(2)
    own = dq8.Mechanism([-1, 0], kinds, [0, 0, 1], placements, links=["ship", "crab"])
    parts = [".qx", ".qy", ".qz", ".qw", ".x", ".y", ".z"]
    assert own.values == ["ship" + part for part in parts] + ["crab.x", "crab.y", "crab.angle"]
    assert own.rates == ["ship" + part for part in (".wx", ".wy", ".wz", ".vx", ".vy", ".vz")] + own.values[7:]
    ship = random_motions(5)
    values = np.concatenate([ship[:, :4], dq8.translation(ship), np.tile([2.0, 3.0, 0.5], (5, 1))], axis=-1)
    crab = dq8.from_rotation_translation([0, 0, np.sin(0.25), np.cos(0.25)], [2.0, 3.0, 0.0])
    close(dq8.to_matrix(own.poses(values, "crab")), dq8.to_matrix(dq8.mul(ship, crab)), ship, crab)
    assert own.jacobian(values, "crab").shape == (5, 6, 9)
    np.testing.assert_array_equal(own.limits, np.tile([-np.inf, np.inf], (10, 1)))


def test_float32_stays_float32(crane, rng):
    values = random_values(crane, rng, 9)
    single = values.astype(np.float32)
    for of in (crane.poses, lambda values: crane.poses(values, "hook"), lambda values: crane.jacobian(values, "hook")):
        assert of(single).dtype == np.float32
        # The hook is 15 away at most, and a few operations of 2⁻²⁴ lead to it.
        np.testing.assert_allclose(of(single), of(values), rtol=0, atol=1e-5)


def test_lengths_beyond_float32_are_refused_where_values_are_float32():
    far = dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.from_translation([1e300, 0.0, 0.0]))
    assert dq8.translation(far.poses([0.0], 0))[0] == 1e300
    with pytest.raises(ValueError, match="float32, for which the translation of joint 0 is not finite"):
        far.poses(np.zeros(1, np.float32))


def test_every_layout_of_memory_gives_the_same_bits(crane, rng):
    values = random_values(crane, rng, 20)
    wide = np.zeros((40, 4))
    wide[::2, ::2] = values
    frozen = values.copy()
    frozen.flags.writeable = False
    for same in (wide[::2, ::2], np.asfortranarray(values), values.astype(">f8"), values.tolist(), frozen):
        np.testing.assert_array_equal(crane.poses(same), crane.poses(values))
        np.testing.assert_array_equal(crane.jacobian(same, 3), crane.jacobian(values, 3))
    repeated = np.broadcast_to(values[0], (9, 2))
    np.testing.assert_array_equal(crane.poses(repeated), crane.poses(repeated.copy()))


def test_out_is_written_and_returned(crane, rng):
    values = random_values(crane, rng, 9)
    for links, core in ((None, (4, 8)), ("hook", (8,)), (["hook", "tower"], (2, 8))):
        for out in (np.full((9, *core), np.nan), np.full((9, *core, 2), np.nan)[..., 0]):
            assert crane.poses(values, links, out=out) is out
            np.testing.assert_array_equal(out, crane.poses(values, links))
    for out in (np.full((9, 6, 2), np.nan), np.full((9, 2, 6), np.nan).swapaxes(-1, -2)):
        assert crane.jacobian(values, "hook", out=out) is out
        np.testing.assert_array_equal(out, crane.jacobian(values, "hook"))


def test_out_may_overlap_values(crane, rng):
    memory = rng.uniform(0, 1, size=9 * 32)
    values = memory[40:58].reshape(9, 2)
    expected = crane.poses(values.copy())
    np.testing.assert_array_equal(crane.poses(values, out=memory.reshape(9, 4, 8)), expected)


def test_jacobians_are_written_without_a_copy(rng):
    tracemalloc = pytest.importorskip("tracemalloc")
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
    values = random_values(arm, rng, 10_000)
    out = np.empty((10_000, 8, 6)).swapaxes(-1, -2)
    tracemalloc.start()
    arm.jacobian(values, "hand", out=out)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10_000


def test_threads_change_no_bit(rng, one_thread):
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
    values = random_values(arm, rng, 5_001)

    def results():
        jacobians = [arm.jacobian(values, "hand", frame) for frame in ("world", "body", "aligned")]
        return [arm.poses(values), arm.poses(values, "hand"), arm.poses(values, [3, 5]), *jacobians]

    expected = results()
    dq8.set_num_threads(3)
    for result, one in zip(results(), expected):
        np.testing.assert_array_equal(result, one)


@pytest.mark.parametrize("robot", [CRANE, ROBOTS / "arm7.urdf", str(ROBOTS / "humanoid.urdf")])
def test_files_are_named_or_given_as_text(robot, rng):
    own = dq8.Mechanism.from_urdf(robot)
    for other in (pickle.loads(pickle.dumps(own)), copy.deepcopy(own)):
        values = random_values(own, rng)
        np.testing.assert_array_equal(other.poses(values), own.poses(values))
        assert other.links == own.links and other.joints == own.joints


def test_files_are_read_in_the_encoding_that_they_declare(tmp_path):
    declared = '<?xml version="1.0" encoding="ISO-8859-1"?>' + CRANE.replace("hook", "b\xfcgel")
    path = tmp_path / "crane.urdf"
    path.write_bytes(declared.encode("latin1"))
    # As text it is what it is, whatever it declares.
    for source in (path, path.read_bytes(), declared):
        robot = dq8.Mechanism.from_urdf(source)
        assert "b\xfcgel" in robot.links and pickle.loads(pickle.dumps(robot)) == robot


def test_mechanisms_of_arrays_are_pickled(rng):
    kinds, axes = ["revolute", "prismatic", "fixed", "planar", "floating"], np.eye(3)[[0, 1, 2, 2, 0]]
    limits = np.tile([-np.inf, np.inf], (5, 1))
    limits[1] = [-1, 2]
    own = dq8.Mechanism([-1, 0, 0, 1, 3], kinds, axes, dq8.from_translation(rng.normal(size=(5, 3))), limits)
    other = pickle.loads(pickle.dumps(own))
    values = random_values(own, rng)
    np.testing.assert_array_equal(other.poses(values), own.poses(values))
    np.testing.assert_array_equal(other.limits, own.limits)
    assert other.values == own.values


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda m: m.poses(np.zeros((5, 3))), ValueError, r"Expected `values` to have shape \(\.\.\., 2\), got \(5, 3\)"),
        (lambda m: m.poses(0.5), ValueError, r"Expected `values` to have shape \(\.\.\., 2\), got \(\)"),
        (lambda m: m.poses(["a", "b"]), TypeError, r"Expected `values` to hold real numbers"),
        (lambda m: m.poses([0, 0], "tool"), ValueError, r"`links`: there is no link \"tool\""),
        (lambda m: m.poses([0, 0], [0, 4]), ValueError, r"`links`: there is no link 4 among 4"),
        (lambda m: m.poses([0, 0], -5), ValueError, r"`links`: there is no link -5 among 4"),
        (lambda m: m.poses([0, 0], 1.5), TypeError, r"Expected `links` to name links or their numbers, got .*float"),
        (lambda m: m.poses([0, 0], [1.5]), TypeError, r"Expected `links` to name links or their numbers, got .*float"),
        (lambda m: m.poses([0, 0], out=np.zeros((4, 7))), ValueError, r"Expected `out` to have shape \(4, 8\)"),
        (lambda m: m.jacobian([0, 0], "tool"), ValueError, r"`link`: there is no link \"tool\""),
        (lambda m: m.jacobian([0, 0], 0, "base"), ValueError, r"Expected `frame` to be 'world'.*got 'base'"),
        (lambda m: m.jacobian([0, 0], 0, out=np.zeros((2, 6))), ValueError, r"`out` to have shape \(6, 2\).*\(2, 6\)"),
        (lambda m: m.jacobian([0, 0], 0, out=[]), TypeError, r"Expected `out` to be an array, got list"),
        (lambda m: m.from_urdf("no/such.urdf"), FileNotFoundError, r"no/such\.urdf"),
        (lambda m: m.from_urdf("<robot"), ValueError, r"not a URDF file"),
        (lambda m: m.from_urdf(CRANE.replace('"hook"', '"tower"')), ValueError, r"two <link> have the name \"tower\""),
        (lambda m: m.from_urdf(5), TypeError, r"int"),
        (lambda m: dq8.Mechanism([], [], [0, 0, 1], np.eye(8)[3]), ValueError, r"`parents` to have an element"),
        (lambda m: dq8.Mechanism([0], "fixed", [0, 0, 1], np.eye(8)[3]), ValueError, r"joint 0 has the parent 0"),
        (lambda m: dq8.Mechanism([-1], "ball", [0, 0, 1], np.eye(8)[3]), ValueError, r"Expected `kinds` to be .*\"ball\""),
        (lambda m: dq8.Mechanism([-1], ["fixed"] * 2, [0, 0, 1], np.eye(8)[3]), ValueError, r"`kinds` to have 1 elem"),
        (lambda m: dq8.Mechanism([-1], 5, [0, 0, 1], np.eye(8)[3]), TypeError, r"Expected `kinds` to be a string"),
        (lambda m: dq8.Mechanism([-1], "revolute", [0, 0, 2], np.eye(8)[3]), ValueError, r"axis of joint 0 has length 2"),
        (lambda m: dq8.Mechanism([-1] * 3, "fixed", np.eye(3)[:2], np.eye(8)[3]), ValueError, r"`axes` to have shape \(3, 3\)"),
        (lambda m: dq8.Mechanism([-1], "fixed", [0, 0, 1], np.eye(8)[3], links=["a", "b"]), ValueError, r"to have 1 names"),
        (lambda m: dq8.Mechanism([-1] * 2, "fixed", [0, 0, 1], np.eye(8)[3], links=["a"] * 2), ValueError, r"two have the name"),
        (lambda m: dq8.Mechanism([-1], "revolute", [0, 0, 1], np.eye(8)[3], [1, 0]), ValueError, r"the limits 1 and 0"),
        (lambda m: dq8.Mechanism([-1], "fixed", [0, 0, 1], np.eye(8)[3], effort_limits=-1), ValueError, r"of joint 0 is -1"),
        (lambda m: dq8.Mechanism([-1], "fixed", [0, 0, 1], np.eye(8)[3], velocity_limits=[np.nan]), ValueError, r"joint 0 is NaN"),
    ],
)
def test_errors_name_argument_and_what_is_wrong(crane, call, error, message):
    with pytest.raises(error, match=message):
        call(crane)


def test_speed_and_effort_have_the_limits_of_the_file_or_of_the_arrays():
    urdf = """<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
        <joint name="turn" type="continuous"><parent link="a"/><child link="b"/><limit velocity="1.5" effort="30"/></joint>
        <joint name="fly" type="floating"><parent link="b"/><child link="c"/></joint>
        <joint name="follow" type="continuous"><parent link="c"/><child link="d"/><limit velocity="9"/>
        <mimic joint="turn"/></joint></robot>"""
    robot = dq8.Mechanism.from_urdf(urdf)
    np.testing.assert_array_equal(robot.velocity_limits, [1.5] + [np.inf] * 6)
    np.testing.assert_array_equal(robot.effort_limits, [30] + [np.inf] * 6)
    arm = dq8.Mechanism([-1, 0], ["revolute", "planar"], [0, 0, 1], dq8.identity(), velocity_limits=[2, 3], effort_limits=5)
    for own in (arm, pickle.loads(pickle.dumps(arm))):
        np.testing.assert_array_equal(own.velocity_limits, [2, 3, 3, 3])
        np.testing.assert_array_equal(own.effort_limits, [5] * 4)
    other = dq8.Mechanism([-1, 0], ["revolute", "planar"], [0, 0, 1], dq8.identity())
    assert arm == pickle.loads(pickle.dumps(arm)) != other
