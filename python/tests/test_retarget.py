"""The motions of people on humanoids: files in, files out, and archives."""

import dataclasses
import json
import os
import pickle
import subprocess
import sys
import threading
import time
from pathlib import Path

import dask
import numpy as np
import pyarrow.parquet
import pytest
from processes import environment
from robots import ROBOTS
from scipy.spatial.transform import Rotation

import dq8
import dq8.dask
from dq8 import retarget as rt

URDF = ROBOTS / "humanoid.urdf"
WALK = ROBOTS.parents[1] / "examples" / "mocap" / "walk.bvh"
BODIES = ["right_foot", "pelvis", "head", "left_palm"]


@pytest.fixture(scope="module")
def robot():
    return rt.Humanoid(URDF)


@pytest.fixture(scope="module")
def motion(robot):
    return rt.retarget(rt.load(WALK), robot, fps=50)


@pytest.fixture
def clips(tmp_path):
    """Three clips of different lengths in folders."""
    made = []
    for index, name in enumerate(["a/walk.bvh", "b/walk.bvh", "b/last.bvh"]):
        path = tmp_path / "clips" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(of_frames(20 + 10 * index))
        made.append(path)
    return made


def of_frames(count: int, times: int = 1) -> str:
    """The text of the walk's first frames, forward, backward and so on."""
    head, rest = WALK.read_text().split("Frames: ")
    _, seconds, *rows = rest.rstrip("\n").split("\n")
    ways = [rows[:count], rows[:count][::-1]]
    return "\n".join([f"{head}Frames: {count * times}", seconds, *(row for index in range(times) for row in ways[index % 2]), ""])


def test_a_humanoid_says_what_was_found(robot):
    assert dict(robot.roles)["left_knee"] == "left_shin" and len(robot.roles) == 15
    assert "left_knee" in str(robot) and "left_shin" in robot._repr_html_()
    assert robot.joints == dq8.Mechanism.from_urdf(URDF).values
    for same in (rt.Humanoid(URDF.read_bytes()), rt.Humanoid(URDF.read_text()), pickle.loads(pickle.dumps(robot))):
        assert type(same) is rt.Humanoid and (same.roles, same.joints, same.links) == (robot.roles, robot.joints, robot.links)


def test_a_file_in_another_encoding_is_decoded(robot):
    text = '<?xml version="1.0" encoding="ISO-8859-1"?><!-- é -->' + URDF.read_text().split("?>", 1)[-1]
    assert rt.Humanoid(text.encode("latin-1")).roles == robot.roles


def test_tables_say_the_last_word(robot, tmp_path):
    table = {"links": {"left_foot": "left_ankle", "left_hip": {"link": "left_thigh", "centre": "left_hip_roll"}}}
    text = '[links]\nleft_foot = "left_ankle"\nleft_hip = { link = "left_thigh", centre = "left_hip_roll" }\n'
    path = tmp_path / "table.toml"
    path.write_text(text)
    for given in (table, text, path, str(path)):
        made = rt.Humanoid(URDF, given)
        assert dict(made.roles)["left_foot"] == "left_ankle" and "by the table" in str(made)
        assert pickle.loads(pickle.dumps(made)).roles == made.roles
    assert rt.Humanoid(URDF, robot.table()).roles == robot.roles
    assert dict(rt.load(WALK, table={"joints": {"head": "Chest"}}).roles)["head"] == "Chest"
    for wrong in ({"links": {"left_foot": "no such"}}, {"links": {"no such": "head"}}, {"others": {}}, "[links"):
        with pytest.raises(ValueError, match="the table"):
            rt.Humanoid(URDF, wrong)
    for wrong in ({"links": {"left_foot": 3}}, {"links": "left_foot"}):
        with pytest.raises(TypeError, match="table"):
            rt.Humanoid(URDF, wrong)


def test_a_walk_is_followed_with_both_feet_on_the_ground(motion, robot):
    assert motion.values.shape == (len(motion), len(robot.joints)) and motion.root.shape == (len(motion), 8)
    assert motion.contacts.dtype == bool and motion.contacts.any(axis=0).all() and not motion.contacts.all()
    assert (motion.fps, motion.joints) == (50, robot.joints)
    assert motion.report["residual"] < 20 and abs(motion.report["ground"]) < 2 and motion.report["slide"] < 40
    assert len(motion.report) == 14 and dict(motion.report) == {name: motion.report[name] for name in motion.report}
    assert "mm" in motion.report._repr_html_() and "residual" in repr(motion.report) and "50 fps" in motion._repr_html_()
    # The root is that link which floats, and the sole is at the height zero.
    np.testing.assert_allclose(motion.poses(["pelvis"])[:, 0], motion.root, rtol=0, atol=1e-12)
    low, high = np.array(robot._mechanism.limits).T
    configurations = motion.configurations()
    assert (configurations >= low - 1e-6).all() and (configurations <= high + 1e-6).all()


def test_settings_are_obeyed(robot):
    person = rt.load(WALK)
    free = rt.retarget(person, robot)
    bound = 0.6 * free.report["speed_most"]
    slow = rt.retarget(person, robot, speeds=bound)
    assert slow.report["speed_most"] <= bound < free.report["speed_most"]
    assert rt.retarget(person, robot, smooth=None).report["jerk"] > free.report["jerk"]
    assert len(rt.retarget(person, robot, fps=np.float32(60))) == len(person)
    assert rt.retarget(person, robot, rest=0).told == ("frame 0 is the rest pose",)
    wrong = [{"fps": 0}, {"fps": np.nan}, {"smooth": -1.0}, {"rest": 10_000}, {"rest": -1}, {"speeds": "fast"}, {"speeds": 0.0}, {"ankle": np.inf}]
    for options in wrong:
        with pytest.raises(ValueError, match=next(iter(options))):
            rt.retarget(person, robot, **options)
    with pytest.raises(TypeError, match="fast"):
        rt.retarget(person, robot, fast=True)


def test_every_setting_changes_the_motion(tmp_path):
    # Hands that are so large that they meet the thighs, and soles.
    shape = "<collision><origin xyz='{}'/><geometry><{}/></geometry></collision></link>"
    text = URDF.read_text()
    for side in ("left", "right"):
        text = text.replace(f'<link name="{side}_hand"/>', f'<link name="{side}_hand">' + shape.format("0 0 -0.03", "sphere radius='0.2'"))
        text = text.replace(f'<link name="{side}_foot"/>', f'<link name="{side}_foot">' + shape.format("0 0 -0.05", "box size='0.2 0.08 0.04'"))
        text = text.replace(f'<link name="{side}_thigh"/>', f'<link name="{side}_thigh">' + shape.format("0 0 -0.1", "cylinder length='0.3' radius='0.15'"))
    robot, person = rt.Humanoid(text), rt.load(WALK)
    usual = rt.retarget(person, robot)
    for options in ({"fps": 60}, {"rest": 5}, {"ankle": 0.2}, {"feet": False}, {"smooth": 8.0}, {"speeds": "file"}, {"speeds": 1.0}, {"collide": False}):
        changed = rt.retarget(person, robot, **options)
        assert changed.values.shape != usual.values.shape or abs(changed.values - usual.values).max() > 1e-3, options
    wrong = [{"fps": "x"}, {"fps": True}, {"rest": 1.5}, {"feet": 1}, {"smooth": "no"}, {"speeds": [1.0]}, {"collide": None}]
    for options in wrong:
        with pytest.raises(TypeError, match=f"Expected `{next(iter(options))}` to be"):
            rt.settings(**options)


def test_a_report_measures_other_motions(motion, robot):
    person = rt.load(WALK)
    assert dict(rt.report(motion, person)) == pytest.approx(dict(motion.report), abs=1e-4, nan_ok=True)
    shaken = dataclasses.replace(motion, values=motion.values + 0.1 * (np.arange(len(motion)) % 2)[:, np.newaxis])
    assert rt.report(shaken, person)["jerk"] > 10 * motion.report["jerk"]
    with pytest.raises(ValueError, match="`values` to have shape"):
        rt.report(motion, person, fps=30)
    with pytest.raises(ValueError, match="a row for each frame of `person` at 30 per second, got"):
        rt.report(motion, person, fps=30)
    with pytest.raises(TypeError, match="Expected `motion` to be a Motion, got Person"):
        rt.report(person, motion)
    values = motion.values.copy()
    values[3, 2] = np.nan
    with pytest.raises(ValueError, match="nan in frame 3, column 9 "):
        rt.report(dataclasses.replace(motion, values=values), person)
    with pytest.raises(TypeError, match="got one: 'pelvis'"):
        motion.poses("pelvis")


def check_rows(robot, root, values, motion):
    """Whether root and joints of a file, in the order of the robot, put the hands where the motion has them."""
    np.testing.assert_allclose(dq8.translation(root), dq8.translation(motion.root), rtol=0, atol=2e-6)
    read = dataclasses.replace(motion, root=root, values=values)
    np.testing.assert_allclose(dq8.translation(read.poses(BODIES)), dq8.translation(motion.poses(BODIES)), rtol=0, atol=1e-5)


def test_npz_is_what_beyondmimic_and_mjlab_read(motion, robot, tmp_path):
    joints = robot.joints[::-1]
    rt.save(motion, tmp_path / "walk.npz", joints=joints, bodies=BODIES)
    with np.load(tmp_path / "walk.npz") as file:
        read = dict(file)
    assert list(read) == ["fps", "joint_pos", "joint_vel", "body_pos_w", "body_quat_w", "body_lin_vel_w", "body_ang_vel_w"]
    assert read["fps"] == [50] and all(read[name].dtype == np.float32 for name in list(read)[1:])
    count = len(motion)
    assert [read[name].shape for name in list(read)[1:]] == [(count, len(joints))] * 2 + [(count, 4, 3), (count, 4, 4)] + [(count, 4, 3)] * 2
    turns = Rotation.from_quat(read["body_quat_w"].reshape(-1, 4), scalar_first=True)
    base = read["body_quat_w"][:, 1][:, [1, 2, 3, 0]].astype(float)
    root = dq8.from_rotation_translation(base / np.linalg.norm(base, axis=1, keepdims=True), read["body_pos_w"][:, 1].astype(float))
    check_rows(robot, root, read["joint_pos"][:, ::-1].astype(float), motion)
    # Velocities bring each frame to the next one.
    step = 1 / 50
    for place, speed in (("joint_pos", "joint_vel"), ("body_pos_w", "body_lin_vel_w")):
        ways = read[place][2:] - read[place][:-2]
        np.testing.assert_allclose(2 * step * read[speed][1:-1], ways, rtol=0, atol=1e-5)
        np.testing.assert_allclose(step * read[speed][0], read[place][1] - read[place][0], rtol=0, atol=1e-5)
    moved = Rotation.from_rotvec(2 * step * read["body_ang_vel_w"][1:-1].reshape(-1, 3)) * turns[: 4 * (count - 2)]
    assert (moved * turns[8:].inv()).magnitude().max() < 1e-5
    last = Rotation.from_rotvec(step * read["body_ang_vel_w"][-1]) * turns[-8:-4]
    assert (last * turns[-4:].inv()).magnitude().max() < 1e-5


def test_pickles_are_what_gmr_writes(motion, robot, tmp_path):
    rt.save(motion, tmp_path / "walk.pkl", joints=robot.joints, bodies=BODIES)
    read = pickle.loads((tmp_path / "walk.pkl").read_bytes())
    assert list(read) == ["fps", "root_pos", "root_rot", "dof_pos", "local_body_pos", "link_body_list"]
    assert read["fps"] == 50 and read["link_body_list"] == BODIES
    root = dq8.from_rotation_translation(read["root_rot"], read["root_pos"])
    check_rows(robot, root, read["dof_pos"], motion)
    world = dq8.transform_points(root[:, np.newaxis], read["local_body_pos"])
    np.testing.assert_allclose(world, dq8.translation(motion.poses(BODIES)), rtol=0, atol=1e-9)


def test_csv_is_what_unitree_writes(motion, robot, tmp_path):
    rt.save(motion, tmp_path / "walk.csv", joints=robot.joints[::-1])
    rows = np.loadtxt(tmp_path / "walk.csv", delimiter=",")
    turns = rows[:, 3:7] / np.linalg.norm(rows[:, 3:7], axis=1, keepdims=True)
    check_rows(robot, dq8.from_rotation_translation(turns, rows[:, :3]), rows[:, 7:][:, ::-1], motion)


def test_names_and_formats_are_checked_before_anything_is_written(motion, tmp_path):
    for options, said in (
        ({"joints": ["knee"]}, "no 'knee'; it has"),
        ({"bodies": ["pelvis", "tail"]}, "no 'tail'"),
        ({"bodies": ["pelvis", "pelvis"]}, "twice"),
        ({"format": "fbx"}, "'fbx'"),
    ):
        with pytest.raises(ValueError, match=said):
            rt.save(motion, tmp_path / "walk.npz", **options)
    with pytest.raises(TypeError, match="sequence of names"):
        rt.save(motion, tmp_path / "walk.npz", bodies="pelvis")
    with pytest.raises(ValueError, match="walk.fbx"):
        rt.save(motion, tmp_path / "walk.fbx")
    assert not list(tmp_path.iterdir())


def test_a_file_that_is_not_written_to_its_end_is_not_there(motion, tmp_path, monkeypatch):
    (tmp_path / "walk.npz").write_bytes(b"before")

    def full(file, **arrays):
        file.write(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "savez", full)
    with pytest.raises(OSError, match="space"):
        rt.save(motion, tmp_path / "walk.npz")
    assert [path.name for path in tmp_path.iterdir()] == ["walk.npz"] and (tmp_path / "walk.npz").read_bytes() == b"before"


@pytest.mark.parametrize("suffix", [".npz", ".pkl", ".csv"])
def test_clips_of_one_frame_are_written(suffix, robot, tmp_path):
    (tmp_path / "one.bvh").write_text(of_frames(1))
    one = rt.retarget(rt.load(tmp_path / "one.bvh"), robot)
    assert len(one) == 1 and np.isfinite(one.values).all() and one.report["jerk"] == 0
    rt.save(one, tmp_path / f"one{suffix}")
    if suffix == ".npz":
        with np.load(tmp_path / "one.npz") as file:
            assert file["body_pos_w"].shape == (1, len(robot.links), 3)
            assert not any(file[name].any() for name in ("joint_vel", "body_lin_vel_w", "body_ang_vel_w"))


def test_files_that_are_no_clips_are_named(tmp_path):
    path = tmp_path / "bad.bvh"
    lines = of_frames(3).split("\n")
    for text, said in (("", "empty"), ("ROBOT", "line 1"), ("\n".join(lines).replace("1.", "nan.", 1), "line"), ("\n".join(lines[:-2]), "announced")):
        path.write_text(text)
        with pytest.raises(ValueError, match=rf"bad\.bvh: .*{said}"):
            rt.load(path)
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(ValueError, match="UTF-8"):
        rt.load(path)
    with pytest.raises(FileNotFoundError):
        rt.load(tmp_path / "no.bvh")
    path.write_text("\n".join([*lines[:-1], lines[-2], ""]))
    with pytest.warns(UserWarning, match=r"bad\.bvh: .*one more"):
        assert len(rt.load(path)) == 4
    bad = tmp_path / "bad.npz"
    bad.write_bytes(b"PK\x03\x04 half a file")
    with pytest.raises(ValueError, match="bad.npz"):
        rt.load(bad, {})
    np.savez(bad, trans=np.zeros((2, 3)))
    with pytest.raises(ValueError, match=r"bad\.npz: .*mocap_frame_rate"):
        rt.load(bad, {})
    with pytest.raises(ValueError, match="`model`"):
        rt.load(bad)


def positions_of(motion):
    """The robot as a person: names of roles, parents, places."""
    roles = dict(motion.humanoid.roles)
    above = {"chest": "pelvis", "head": "chest"}
    for side in ("left", "right"):
        chain = [f"{side}_{part}" for part in ("hip", "knee", "foot")], [f"{side}_{part}" for part in ("shoulder", "elbow", "hand")]
        for carrier, limb in zip(("pelvis", "chest"), chain):
            above |= dict(zip(limb, [carrier, *limb]))
    names = list(roles)
    return names, [names.index(above[name]) if name in above else -1 for name in names], dq8.translation(motion.poses(list(roles.values())))


def test_places_of_joints_are_followed_and_what_is_wrong_in_them_is_named(motion, robot):
    names, parents, places = positions_of(motion)
    again = rt.retarget(rt.positions(names, parents, places, 50), robot, fps=50)
    assert len(again) == len(motion) and again.report["residual"] < 60
    for frames in ([5], [0, 7]):
        wrong = places.copy()
        wrong[frames, 3] = np.nan
        with pytest.raises(ValueError, match=f"{names[3]!r}|\"{names[3]}\" in frame {frames[0]} is not finite"):
            rt.positions(names, parents, wrong, 50)
    with pytest.raises(ValueError, match=rf"`array` to have shape \(frames, {len(names)}, 3\)"):
        rt.positions(names, parents, places[:, 1:], 50)
    with pytest.raises(ValueError, match="`fps`"):
        rt.positions(names, parents, places, np.nan)
    with pytest.raises(ValueError, match="before it"):
        rt.positions(names, parents[::-1], places, 50)
    with pytest.raises(ValueError, match="elements"):
        rt.positions(names, parents, places[:0], 50)
    with pytest.raises(ValueError, match="`table=`"):
        rt.retarget(rt.positions([f"j{i}" for i in range(len(names))], parents, places, 50), robot)


def body():
    """A body of 22 vertices, one for each joint; its first shape is taller."""
    at = [[0, 0, 1.0], [0.1, 0, 0.9], [-0.1, 0, 0.9], [0, 0, 1.1], [0.1, 0, 0.5], [-0.1, 0, 0.5], [0, 0, 1.2], [0.1, 0, 0.1], [-0.1, 0, 0.1], [0, 0, 1.3],
          [0.1, -0.15, 0.02], [-0.1, -0.15, 0.02], [0, 0, 1.5], [0.05, 0, 1.45], [-0.05, 0, 1.45], [0, 0, 1.65], [0.2, 0, 1.45], [-0.2, 0, 1.45],
          [0.45, 0, 1.4], [-0.45, 0, 1.4], [0.7, 0, 1.35], [-0.7, 0, 1.35]]  # fmt: skip
    shapes = np.zeros((22, 3, 3))
    shapes[:, 2, 0] = 0.1 * np.array(at)[:, 2]
    return {"v_template": np.array(at), "shapedirs": shapes, "J_regressor": np.eye(22)}


def test_arrays_of_body_models_are_read_in_all_their_forms(robot, tmp_path):
    turns, places = np.zeros((12, 55, 3)), np.zeros((12, 3))
    turns[:, 18, 1] = np.linspace(0, 1.2, 12)
    model = body()
    np.savez(tmp_path / "model.npz", **model, others=np.array({"a": 1}, object))
    rate = {"mocap_frame_rate": np.array(30.0), "betas": np.ones(2), "trans": places}
    np.savez(tmp_path / "clip.npz", poses=turns.reshape(12, -1), gender="neutral", **rate)
    parts = {"root_orient": turns[:, 0], "pose_body": turns[:, 1:22].reshape(12, -1), **rate}
    people = [
        rt.load(tmp_path / "clip.npz", model),
        rt.load(tmp_path / "clip.npz", tmp_path / "model.npz"),
        rt.load(parts, model),
        rt.body_model(model, turns[:, :22], places, 30, betas=np.ones(2)),
    ]
    motions = [rt.retarget(person, robot, smooth=None) for person in people]
    for motion in motions:
        np.testing.assert_array_equal(motion.values, motions[0].values)
    assert len(motions[0]) == 12 and np.ptp(motions[0].values, axis=0).max() > 0.5
    with pytest.raises(ValueError, match="no 'shapedirs'"):
        rt.load(parts, {"v_template": model["v_template"]})
    with pytest.raises(ValueError, match="betas"):
        rt.body_model(model, turns, places, 30, betas=np.ones(4))
    with pytest.raises(ValueError, match="not finite"):
        rt.body_model(model, np.full_like(turns, np.nan), places, 30)
    with pytest.raises(ValueError, match="turns"):
        rt.body_model(model, turns[:, :21], places, 30)


def test_arrays_of_body_models_that_do_not_fit_are_named():
    turns, places = np.zeros((10, 55, 3)), np.zeros((10, 3))
    model = {"v_template": np.zeros((30, 3)), "shapedirs": np.zeros((30, 3, 2)), "J_regressor": np.zeros((55, 30))}
    for name, wrong in (("turns", (turns[:5], places)), ("places", (turns, places[:, :2])), ("turns", (turns[0], places)), ("turns", (turns, places[:5]))):
        with pytest.raises(ValueError, match=f"Expected `{name}` to have shape"):
            rt.body_model(model, *wrong, 30)
    for name in model:
        with pytest.raises(ValueError, match=f"Expected `{name}` to have shape"):
            rt.body_model(model | {name: model[name].T}, turns, places, 30)
    with pytest.raises(ValueError, match="`betas` has 9 elements, and the other arrays ask for 2"):
        rt.body_model(model, turns, places, 30, betas=np.zeros(9))


def test_a_robot_without_legs_is_refused():
    with pytest.raises(ValueError, match=r"(?s)no two legs .*\(`table=`\)"):
        rt.Humanoid(ROBOTS / "arm7.urdf")


def test_progress_is_told_and_grows(robot, tmp_path):
    (tmp_path / "long.bvh").write_text(of_frames(64, 150))
    person, told = rt.load(tmp_path / "long.bvh"), []
    with dq8.progress(told.append):
        rt.retarget(person, robot, fps=60)
    assert told == sorted(told) and told[-1] == 1 and any(0 < part < 1 for part in told), told


def test_long_clips_are_followed_as_short_ones(robot, tmp_path):
    (tmp_path / "long.bvh").write_text(of_frames(64, 150))
    long = rt.retarget(rt.load(tmp_path / "long.bvh"), robot, fps=60)
    short = rt.retarget(rt.load(WALK), robot, fps=60)
    assert len(long) == 64 * 150 and long.report["residual"] < short.report["residual"] + 3


def test_self_hits_are_not_known_where_shapes_are_meshes(tmp_path):
    shape = "<collision><geometry>{}</geometry></collision></link>"
    text = URDF.read_text().replace('<link name="left_hand"/>', '<link name="left_hand">' + shape.format("<sphere radius='0.05'/>"))
    text = text.replace('<link name="right_hand"/>', '<link name="right_hand">' + shape.format("<sphere radius='0.05'/>"))
    spheres = rt.Humanoid(text)
    meshes = rt.Humanoid(text.replace("<sphere radius='0.05'/>", "<mesh filename='hand.stl'/>", 1))
    (tmp_path / "short.bvh").write_text(of_frames(20))
    known, unknown = (rt.retarget(rt.load(tmp_path / "short.bvh"), robot, fps=60) for robot in (spheres, meshes))
    assert known.report["self_hits"] == 0 and spheres.told == []
    assert np.isnan(unknown.report["self_hits"]) and "1 of 2 links have meshes" in meshes.told[0]


def test_a_report_says_where_edges_of_soles_are_not_known(robot):
    text = URDF.read_text()
    for side in ("left", "right"):
        box = "<collision><origin xyz='0.03 0 -0.05'/><geometry><box size='0.2 0.08 0.04'/></geometry></collision>"
        text = text.replace(f'<link name="{side}_foot"/>', f'<link name="{side}_foot">{box}</link>')
    person = rt.load(WALK)
    for humanoid, known in ((robot, False), (rt.Humanoid(text), True)):
        motion = rt.retarget(person, humanoid)
        for report in (motion.report, rt.report(motion, person), pickle.loads(pickle.dumps(motion.report))):
            assert report.edges is known
            assert ("edges of soles are not known" in repr(report)) is not known
            assert ("edges of soles are not known" in report._repr_html_()) is not known


def test_an_archive_has_a_file_and_a_row_for_each_clip(clips, robot, tmp_path):
    told = []
    table = rt.archive(str(tmp_path / "clips/**/*.bvh"), robot, tmp_path / "out", workers=2, progress=told.append, bodies=BODIES, fps=60)
    rows = {row["file"]: row for row in table.to_pylist()}
    assert list(rows) == ["a/walk.bvh", "b/last.bvh", "b/walk.bvh"]
    assert sorted(told) == told and told[-1] == 1 and len(told) == 4
    for path, frames in zip(clips, (20, 30, 40)):
        row = rows[path.relative_to(tmp_path / "clips").as_posix()]
        alone = rt.retarget(rt.load(path), robot, fps=60)
        assert (row["frames"], row["fps"], row["error"]) == (frames, 60, None)
        assert row["self_hits"] is None and np.isnan(alone.report["self_hits"])
        assert row["edges"] is alone.report.edges is False
        assert {name: row[name] for name in alone.report} == dict(alone.report) | {"self_hits": None}
        with np.load(tmp_path / "out" / row["motion"]) as file:
            np.testing.assert_array_equal(file["joint_pos"], alone.values.astype(np.float32))
            assert file["body_pos_w"].shape == (frames, len(BODIES), 3)
    assert pyarrow.parquet.read_table(tmp_path / "out/measures.parquet").equals(table)
    assert {path.name for path in (tmp_path / "out").rglob("*") if path.is_file()} == {"walk.npz", "last.npz", "measures.parquet"}


def stamps(out: Path) -> dict[str, int]:
    return {path.relative_to(out).as_posix(): path.stat().st_mtime_ns for path in out.rglob("*.npz")}


def test_an_archive_computes_nothing_twice_but_what_has_changed(clips, robot, tmp_path):
    out = tmp_path / "out"
    first = rt.archive(clips, robot, out)
    before = stamps(out)
    assert rt.archive(clips, rt.Humanoid(URDF), out).equals(first) and stamps(out) == before
    clips[0].write_text(of_frames(25))
    (out / "b/last.npz").unlink()
    again = {row["file"]: row for row in rt.archive(clips, robot, out).to_pylist()}
    assert {name for name, stamp in stamps(out).items() if stamp != before[name]} == {"a/walk.npz", "b/last.npz"}
    assert again["a/walk.bvh"]["size"] == clips[0].stat().st_size
    before = stamps(out)
    rt.archive(clips, robot, out, smooth=None)
    assert all(stamp != before[name] for name, stamp in stamps(out).items())


def test_an_archive_with_bad_files_finishes_and_says_which(clips, robot, tmp_path):
    clips[1].write_text("no clip")
    with pytest.warns(UserWarning, match=r"2 of 4 clips failed\nb/walk\.bvh: ValueError: .*line 1.*\nno\.bvh: FileNotFound"):
        table = rt.archive([*clips, tmp_path / "clips/no.bvh"], robot, tmp_path / "out")
    rows = {row["file"]: row for row in table.to_pylist()}
    assert [row["error"] is None for row in rows.values()] == [True, False, True, False]
    assert rows["b/walk.bvh"]["motion"] is None and not (tmp_path / "out/b/walk.npz").exists()
    # Those that failed are tried again, others are not.
    before = stamps(tmp_path / "out")
    clips[1].write_text(of_frames(30))
    assert rt.archive(clips, robot, tmp_path / "out").column("error").null_count == 3
    assert {name: stamps(tmp_path / "out")[name] for name in before} == before


def test_an_archive_that_was_killed_goes_on(robot, tmp_path):
    clips, out = [tmp_path / f"clips/{name}.bvh" for name in "abcdef"], tmp_path / "out"
    clips[0].parent.mkdir()
    for clip in clips:
        clip.write_text(of_frames(64, 30))
    code = f"from dq8 import retarget as rt\nrt.archive({str(clips[0].parent / '*.bvh')!r}, {str(URDF)!r}, {str(out)!r}, workers=2, fps=60)"
    child = subprocess.Popen([sys.executable, "-c", code], env=environment())
    late = time.monotonic() + 60
    while not (len(stamps(out)) >= 2 and (out / "measures.jsonl").read_text().count("{") >= 1) and time.monotonic() < late:
        time.sleep(0.001)
    child.kill()
    child.wait()
    assert not (out / "measures.parquet").exists()
    before = stamps(out)
    for name in before:
        with np.load(out / name) as file:
            assert file["joint_pos"].shape == (64 * 30, len(robot.joints))
    whole = {json.loads(line)["motion"] for line in (out / "measures.jsonl").read_text().split("\n")[1:] if line.endswith("}")}
    # A line of which a part was written, and a file of which a part was written.
    with open(out / "measures.jsonl", "a") as journal:
        journal.write('\n{"file": "f.bvh", "mot')
    (out / "f.npz.part").write_bytes(b"half")
    table = rt.archive(clips, robot, out, fps=60)
    assert table.column("error").null_count == 6 and table.column("frames").to_pylist() == [64 * 30] * 6
    assert whole and {name for name in before if stamps(out)[name] == before[name]} >= whole
    assert not list(out.glob("*.part")) and not (out / "measures.jsonl").exists()


def test_what_is_wrong_for_all_clips_is_an_error_at_once(clips, robot, tmp_path):
    out = tmp_path / "out"
    for options, said in (({"fps": "fast"}, "fps"), ({"format": "fbx"}, "format"), ({"bodies": ["tail"]}, "tail"), ({"rest": -1}, "rest")):
        with pytest.raises((ValueError, TypeError), match=said):
            rt.archive(clips, robot, out, **options)
    with pytest.raises(TypeError, match="fast"):
        rt.archive(clips, robot, out, fast=True)
    with pytest.raises(ValueError, match=r"no file .*\*\.fbx"):
        rt.archive(str(tmp_path / "*.fbx"), robot, out)
    clips[1].with_suffix(".npz").write_bytes(b"")
    with pytest.raises(ValueError, match="one name"):
        rt.archive([*clips, clips[1].with_suffix(".npz")], robot, out)
    assert not out.exists()


def test_an_archive_replaces_no_clip_and_writes_nowhere_else(clips, robot, tmp_path, monkeypatch):
    (tmp_path / "clips/one.npz").write_bytes(b"no arrays")
    with pytest.raises(ValueError, match="would replace a clip"):
        rt.archive(tmp_path / "clips/one.npz", robot, tmp_path / "clips")
    # The same clip by another path, and a folder beside.
    monkeypatch.chdir(tmp_path / "clips/a")
    given = ["walk.bvh", "../a/walk.bvh", clips[0], "../b/walk.bvh"]
    table = rt.archive(given, robot, "../../out", fps=10, bodies=iter(BODIES))
    with np.load("../../out/a/walk.npz") as file:
        assert file["body_pos_w"].shape[1:] == (len(BODIES), 3)
    assert table.column("motion").to_pylist() == ["a/walk.npz", "b/walk.npz"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["clips", "out"]
    # Names with the signs of patterns, folders among what a pattern finds, and one path.
    clips[0].rename(tmp_path / "clips/w[a]lk.bvh")
    assert len(rt.archive(str(tmp_path / "clips/w[a]lk.bvh"), robot, tmp_path / "one", fps=10)) == 1
    (tmp_path / "clips/folder.bvh").mkdir()
    assert len(rt.archive(str(tmp_path / "clips/**/*.bvh"), robot, tmp_path / "all", fps=10)) == 3
    for files, workers, said in (([], None, "got none"), (clips[1:], 0, "workers"), (clips[1:], "2", "workers"), ([b"\xff.bvh".decode(errors="surrogateescape")], 1, "not UTF-8")):
        with pytest.raises(ValueError, match=said):
            rt.archive(files, robot, tmp_path / "none", workers=workers)
    assert not (tmp_path / "none").exists()


def test_an_archive_has_no_motion_of_another_clip_or_call(clips, robot, tmp_path):
    out = tmp_path / "out"
    rt.archive(clips[:2], robot, out, fps=10)
    # Other clips of the same names, sizes and times.
    other = tmp_path / "other"
    for path in clips[:2]:
        to = other / path.parent.name / path.name
        to.parent.mkdir(parents=True)
        to.write_text(path.read_text().replace("0.92", "0.91"))
        os.utime(to, ns=(path.stat().st_atime_ns, path.stat().st_mtime_ns))
    before = stamps(out)
    rt.archive([other / "a/walk.bvh", other / "b/walk.bvh"], robot, out, fps=10)
    assert all(stamp != before[name] for name, stamp in stamps(out).items())
    # The table has what calls before have made; a clip that has become bad has no motion.
    rt.archive(clips, robot, out, fps=10)
    clips[1].write_text("no clip")
    with pytest.warns(UserWarning, match="1 of 3"):
        rt.archive(clips, robot, out, fps=10)
    assert not (out / "b/walk.npz").exists()
    rt.archive(clips[:1] + clips[2:], robot, out, fps=10)
    assert sorted(pyarrow.parquet.read_table(out / "measures.parquet").column("file").to_pylist()) == ["a/walk.bvh", "b/last.bvh"]
    (out / "measures.parquet").write_bytes(b"junk")
    with pytest.raises(ValueError, match="remove it"):
        rt.archive(clips[2:], robot, out)


def test_an_archive_without_pyarrow_says_how_to_install_it(clips, robot, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", None)
    with pytest.raises(ModuleNotFoundError, match=r"pip install dq8\[retarget\]"):
        rt.archive(clips, robot, tmp_path / "out")


def test_threads_and_workers_do_not_change_the_result(clips, robot, tmp_path):
    tables = [rt.archive(clips, robot, tmp_path / f"{workers}", workers=workers) for workers in (1, 3)]
    assert tables[0].equals(tables[1])
    for name in stamps(tmp_path / "1"):
        assert (tmp_path / "1" / name).read_bytes() == (tmp_path / "3" / name).read_bytes()
    # Also in a thread that is not the main one, where nothing is told.
    told = []
    thread = threading.Thread(target=lambda: told.append(rt.archive(clips, robot, tmp_path / "thread")))
    thread.start()
    thread.join()
    assert told[0].equals(tables[0])


def test_dask_writes_the_same_files_and_gives_the_same_rows(clips, robot, tmp_path):
    clips[2].write_text("no clip")
    with pytest.warns(UserWarning, match="1 of 3"):
        table = rt.archive(clips, robot, tmp_path / "own", fps=50, bodies=BODIES)
    bag = dq8.dask.archive(clips, robot, tmp_path / "lazy", fps=50, bodies=BODIES)
    assert bag.npartitions == 3 and dq8.dask.archive(clips, robot, tmp_path / "lazy", partitions=1).npartitions == 1
    assert not list((tmp_path / "lazy").iterdir())
    with dask.config.set(scheduler="processes", num_workers=2):
        rows = bag.compute()
    assert [{"error": None} | row for row in rows] == [{name: row[name] for name in rows[i]} for i, row in enumerate(table.to_pylist())]
    for name in stamps(tmp_path / "own"):
        assert (tmp_path / "own" / name).read_bytes() == (tmp_path / "lazy" / name).read_bytes()
    with pytest.raises(ValueError, match="tail"):
        dq8.dask.archive(clips, robot, tmp_path / "lazy", bodies=["tail"])
