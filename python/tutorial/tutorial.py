# %% [markdown]
# # dq8 for NumPy
#
# Run it as a script, `python tutorial/tutorial.py DIRECTORY`, which writes the plots; or cell by cell in an
# editor that knows `# %%`.

# %%
import sys
from pathlib import Path

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np

import dq8
import dq8.plot

directory = Path(sys.argv[1] if len(sys.argv) > 1 else ".")

# %% [markdown]
# ## A motion is eight numbers
#
# `[px, py, pz, pw, qx, qy, qz, qw]`: p is the rotation, a quaternion, and q = ½tp holds the translation t.
# Arrays of motions have the shape `(..., 8)`.

# %%
quarter_turn = np.array([0, 0, np.sqrt(0.5), np.sqrt(0.5)])
a = dq8.from_rotation_translation(quarter_turn, [2.0, 0.0, 0.0])
print(a)
print(dq8.transform_points(a, [1.0, 0.0, 0.0]))  # turned to (0, 1, 0), then moved
assert np.allclose(dq8.transform_points(a, [1.0, 0.0, 0.0]), [2, 1, 0])

# %% [markdown]
# `mul(a, b)` lets `b` act first. Leading dimensions broadcast: one motion times a thousand, or a column of
# motions times a row.

# %%
steps = dq8.from_translation(np.linspace(0, 1, 1000)[:, None] * [1.0, 0.0, 0.0])
assert dq8.mul(a, steps).shape == (1000, 8)
assert dq8.mul(steps[:3, None], steps[:5]).shape == (3, 5, 8)

# %% [markdown]
# ## Between two poses
#
# `sclerp` moves along one screw at constant speed; `nlerp` is nearly the same path, and quicker. The usual
# way, slerp of the rotations and straight lines for the translations, is neither: it depends on the frame.

# %%
b = dq8.from_twist([0.0, 0.0, 2.5, 0.0, 0.0, 1.5])
start, end = dq8.from_translation([1.0, 0, 0]), dq8.mul(b, dq8.from_translation([1.0, 0, 0]))
t = np.linspace(0, 1, 50)
screw = dq8.translation(dq8.sclerp(start, end, t))
linear = dq8.translation(dq8.nlerp(start, end, t))
straight = (1 - t)[:, None] * screw[0] + t[:, None] * screw[-1]

figure = plt.figure(figsize=(5, 4), layout="constrained")
axes = figure.add_subplot(projection="3d")
for path, name in [(screw, "sclerp"), (linear, "nlerp"), (straight, "slerp and lerp")]:
    axes.plot(*path.T, label=name)
dq8.plot.frames(axes, dq8.sclerp(start, end, t[::7]), length=0.3)
dq8.plot.screw(axes, b, length=2.0)
axes.legend()
dq8.plot.fitted(axes)
figure.savefig(directory / "between.png")
# The screw keeps its distance from the axis.
assert np.allclose(np.linalg.norm(screw[:, :2], axis=1), 1)

# %% [markdown]
# ## Through many poses
#
# `resample` follows screws from pose to pose, at any times. Its velocity jumps at every key; `squad` goes through the
# same keys without a jump, drawn by `squad_control`. `dib_windows` smooths what was measured.

# %%
keys = dq8.from_rotation_translation([0.0, 0, 0, 1], [[0.0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 1, 0]])
times = np.array([0.0, 1.0, 2.0, 3.0])
straight = dq8.translation(dq8.resample(times, keys, np.linspace(0, 3, 31)))
assert np.allclose(straight[15], [1.5, 0.5, 0])

before, after = np.concatenate([keys[:1], keys[:-1]]), np.concatenate([keys[1:], keys[-1:]])
controls = dq8.squad_control(before, keys, after)
between = np.linspace(0, 1, 11)[:, None]  # of each piece: (11, pieces, 8)
smooth = dq8.squad(keys[:-1], controls[:-1], controls[1:], keys[1:], between)
assert smooth.shape == (11, 3, 8) and np.allclose(smooth[0], keys[:-1])

figure = plt.figure(figsize=(5, 4), layout="constrained")
axes = figure.add_subplot(projection="3d")
dq8.plot.frames(axes, smooth.swapaxes(0, 1), length=0.3, every=3, path=True)
dq8.plot.fitted(axes)
figure.savefig(directory / "keys.png")

noise = np.random.default_rng(1).normal(scale=0.02, size=(50, 6))
shaken = dq8.integrate_body(dq8.sclerp(start, end, t), noise, 1.0)
calm = dq8.dib_windows(shaken, [1, 2, 3, 2, 1])
steps = [dq8.distance_to(path[1:], path[:-1]).std() for path in (shaken, calm)]
assert calm.shape == (46, 8) and steps[1] < 0.5 * steps[0]

# %% [markdown]
# ## A scan, deskewed
#
# A scanner turns once in a tenth of a second, on a robot that drives and turns meanwhile. It measures each point in the
# frame of another moment, so its walls bend. `deskew` moves each point by the pose at its own time into one frame, here
# that of the first moment; between two poses of the odometer it follows a screw. `skew` leads back.

# %%
stamps = np.linspace(0, 0.1, 11)
odometer = dq8.from_twist(stamps[:, None] * [0.0, 0, 4, 12, 0, 0])  # 4 radians and 12 metres a second
moments = (np.arange(720) + 0.5) * (0.1 / 720)
beams = np.stack([np.cos(20 * np.pi * moments), np.sin(20 * np.pi * moments), 0 * moments], axis=-1)
# The walls of the room are at x = ±4 and y = ±3. A beam ends at the nearest one ahead.
there = dq8.resample(stamps, odometer, moments)
ahead = dq8.transform_vectors(there, beams)[:, :2]
ranges = ((np.copysign([4.0, 3.0], ahead) - dq8.translation(there)[:, :2]) / ahead).min(axis=1)
scan = ranges[:, None] * beams  # as the scanner has it
moved = dq8.deskew(scan, moments, stamps, odometer, frame="start")

figure, both = plt.subplots(1, 2, figsize=(8, 3.4), sharex=True, sharey=True, layout="constrained")
for axes, points, title in zip(both, (scan, moved), ("as measured", "deskewed"), strict=True):
    axes.plot([-4, 4, 4, -4, -4], [-3, -3, 3, 3, -3], color="0.8", linewidth=5, zorder=0, label="room")
    axes.scatter(points[:, 0], points[:, 1], c=moments, s=3, label="points, from first to last")
    axes.set_aspect("equal")
    axes.set_title(title)
both[0].legend(loc="center")
figure.savefig(directory / "deskew.png")
off = [np.abs(np.abs(points[:, :2] / [4, 3]).max(axis=1) - 1).max() for points in (scan, moved)]
assert off[0] > 0.2 and off[1] < 1e-12
assert np.allclose(dq8.skew(moved, moments, stamps, odometer, frame="start"), scan)

# %% [markdown]
# ## An arm
#
# A `Hierarchy` has the parent of every joint. The pose of a link in its parent is an offset, then a turn
# about the hinge: `integrate_body(offset, twist, angle)`. Ten thousand configurations are one call.

# %%
arm = dq8.Hierarchy([-1, 0, 1, 2])
offsets = dq8.from_translation([[0.0, 0, 0], [1, 0, 0], [0.8, 0, 0], [0.5, 0, 0]])
hinge = [0.0, 0, 1, 0, 0, 0]
rng = np.random.default_rng(0)
angles = rng.uniform([-1.5, -2.5, -2.5, 0], [1.5, 2.5, 2.5, 0.001], size=(10_000, 4))
poses = arm.local_to_model(dq8.integrate_body(offsets, hinge, angles))
hands = dq8.translation(poses[:, -1])

figure, axes = plt.subplots(figsize=(5, 4), layout="constrained")
axes.plot(hands[:, 0], hands[:, 1], ",", alpha=0.4)
for links in dq8.translation(poses[:5]):
    axes.plot(links[:, 0], links[:, 1], "o-")
axes.set_aspect("equal")
axes.set_title("where the hand can be")
figure.savefig(directory / "arm.png")
assert np.linalg.norm(hands, axis=1).max() <= 2.3 + 1e-12

# %% [markdown]
# ## Back from poses to angles
#
# A `Mechanism` knows its joints as well: `reach` finds the angles that bring a link to a pose. Here the same arm,
# with limits, and all ten thousand poses of its hand at once, from one start.

# %%
limits = [[-1.5, 1.5], [-2.5, 2.5], [-2.5, 2.5], [-np.inf, np.inf]]
kinds = ["revolute", "revolute", "revolute", "fixed"]
robot = dq8.Mechanism([-1, 0, 1, 2], kinds, [0, 0, 1], offsets, limits)
targets = robot.poses(angles[:, :3], 3)
found, report = robot.reach(targets, [0.1, 0.2, 0.3], 3)
print(f"{report.converged.mean():.1%} reached, in {report.iterations.mean():.1f} steps")
reached = report.converged
figure = plt.figure(figsize=(5, 4), layout="constrained")
axes = figure.add_subplot(projection="3d")
for values in found[:5]:
    links = robot.poses(values)
    dq8.plot.skeleton(axes, robot, links)
    dq8.plot.frames(axes, links[3], length=0.3)
dq8.plot.fitted(axes)
axes.view_init(elev=70, azim=-90)
figure.savefig(directory / "robot.png")
assert reached.mean() > 0.9
assert dq8.distance_to(robot.poses(found, 3), targets)[reached].max() < 1.1e-5

# %% [markdown]
# ## A mesh that follows joints
#
# A tube, twisted by half a turn at its end. Sums of matrices (`"lbs"`) collapse in the middle; dual quaternions
# (`"dlb"`) keep the radius.

# %%
height, around = np.meshgrid(np.linspace(0, 1, 41), np.linspace(0, 2 * np.pi, 25), indexing="ij")
tube = np.stack([0.3 * np.cos(around), 0.3 * np.sin(around), height], axis=-1).reshape(-1, 3)
joints = np.tile([0, 1], (len(tube), 1))
weights = np.stack([1 - tube[:, 2], tube[:, 2]], axis=-1)
twists = dq8.from_twist(np.linspace(0, 0.95 * np.pi, 20)[:, None] * [0, 0, 1.0, 0, 0, 0])
palettes = np.stack([np.broadcast_to(dq8.identity(), twists.shape), twists], axis=1)  # (20, 2, 8)
frames = {method: dq8.skin(tube, joints, weights, palettes, method=method) for method in ("lbs", "dlb")}

figure = plt.figure(figsize=(6, 4), layout="constrained")
for place, (method, frame) in enumerate(frames.items()):
    axes = figure.add_subplot(1, 2, place + 1, projection="3d")
    axes.plot_wireframe(*frame[-1].reshape(41, 25, 3).transpose(2, 0, 1), linewidth=0.4)
    axes.set_title(method)
figure.savefig(directory / "skin.png")
radius = {method: np.linalg.norm(frame[-1, :, :2], axis=-1) for method, frame in frames.items()}
assert np.allclose(radius["dlb"], 0.3) and radius["lbs"].min() < 0.05

# %% [markdown]
# ## A mean that does not depend on the frame
#
# `mean` is intrinsic: the mean of moved poses is the moved mean. `dlb` is the normalized sum, close to it.

# %%
truth = dq8.from_twist([0.3, -0.2, 0.5, 1.0, 2.0, 3.0])
noisy = dq8.integrate_body(truth, rng.normal(scale=0.05, size=(200, 6)), 1.0)
estimate = dq8.mean(noisy)
print("angle off:", dq8.angle_to(truth, estimate), "distance off:", dq8.distance_to(truth, estimate))
assert dq8.distance_weighted(truth, estimate, 1.0) < 0.05
moved = dq8.mean(dq8.mul(a, noisy))
assert np.allclose(dq8.to_matrix(moved), dq8.to_matrix(dq8.mul(a, estimate)))

# %% [markdown]
# ## Memory and precision
#
# float32 stays float32. `out=` writes where it is told; arguments may be read-only or strided.

# %%
single = noisy.astype(np.float32)
assert dq8.mul(single, single).dtype == np.float32
out = np.empty_like(noisy)
dq8.conjugate(noisy, out=out)
every_other = dq8.to_twist(noisy[::2])
assert every_other.shape == (100, 6)

# %% [markdown]
# ## SciPy's names
#
# `dq8.RigidTransform` has the methods of `scipy.spatial.transform.RigidTransform`, on the same eight numbers.

# %%
try:
    from scipy.spatial.transform import Rotation
except ImportError:
    print("SciPy is not installed")
else:
    turn = Rotation.from_euler("z", 90, degrees=True)
    transform = dq8.RigidTransform.from_components([2.0, 0.0, 0.0], turn)
    print((transform**0.5).apply([1.0, 0.0, 0.0]))
    assert np.allclose(transform.as_dual_quat(), a)
    assert np.allclose((transform**0.5 * transform**0.5).as_matrix(), transform.as_matrix())
plt.close("all")
