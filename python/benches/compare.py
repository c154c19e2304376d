"""dq8 and its peers, side by side in one run: a table, the ratios, and a plot.

    python benches/compare.py [--quick] [--plot FILE.svg] [--check]

Contenders of a job take turns, and each turn is repeated at once, so that everyone finds the caches as it
left them; what counts is the quickest of all. One thread. `--check` fails if dq8 is not the quickest of a job.
"""

from __future__ import annotations

import argparse
import sys
import timeit
from collections.abc import Callable
from dataclasses import dataclass, field

import matplotlib.pyplot as plt
import numpy as np
import pytransform3d.trajectories as p3t
import scipy
from matplotlib.figure import Figure
from scipy.spatial.transform import RigidTransform as Theirs
from scipy.spatial.transform import Rotation

import dq8

FIRST = [3, 0, 1, 2, 7, 4, 5, 6]
# Of the plot's width: where titles begin, and from where to where there are bars.
MARGIN, LEFT, RIGHT = 0.018, 0.29, 0.98


@dataclass
class Job:
    """What is computed, of how many, by whom; and how many times as fast as a peer dq8 is meant to be."""

    name: str
    count: int
    contenders: dict[str, Callable[[], object]]
    goals: dict[str, float] = field(default_factory=dict)
    best: dict[str, float] = field(default_factory=dict)

    def run(self, rounds: int, calls: int, repeat: int) -> None:
        """Contenders take turns for `rounds`, and are timed `repeat` times a turn, short ones over so many `calls` that
        the clock does not count.
        """
        self.best = dict.fromkeys(self.contenders, float("inf"))
        for _ in range(rounds):
            for name, contender in self.contenders.items():
                number = max(1, calls // self.count)
                seconds = min(timeit.repeat(contender, number=number, repeat=repeat)) / number
                self.best[name] = min(self.best[name], seconds / self.count * 1e9)


def of_arrays(count: int) -> list[Job]:
    rng = np.random.default_rng(0)
    x, y = (
        Theirs.from_components(rng.normal(size=(count, 3)), Rotation.random(count, rng=rng)) for _ in range(2)
    )
    a, b = x.as_dual_quat(), y.as_dual_quat()
    a32, b32 = a.astype(np.float32), b.astype(np.float32)
    b_near = b * np.sign(np.sum(a[:, :4] * b[:, :4], axis=-1, keepdims=True))
    a_first, b_first, t = a[:, FIRST].copy(), b_near[:, FIRST].copy(), np.linspace(0, 1, count)
    matrices, others = x.as_matrix(), y.as_matrix()
    points = rng.normal(size=(count, 3))
    own_x, own_y = dq8.RigidTransform.from_dual_quat(a), dq8.RigidTransform.from_dual_quat(b)
    out, matrix_out = np.empty_like(a), np.empty_like(matrices)
    columns = points[:, :, None]
    return [
        Job(
            "product",
            count,
            {
                "dq8": lambda: dq8.mul(a, b, out=out),
                "dq8 float32": lambda: dq8.mul(a32, b32),
                "dq8 RigidTransform": lambda: own_x * own_y,
                "NumPy 4×4 matmul": lambda: np.matmul(matrices, others, out=matrix_out),
                "NumPy a + b": lambda: np.add(a, b, out=out),
                "SciPy": lambda: x * y,
                "pytransform3d": lambda: p3t.batch_concatenate_dual_quaternions(a_first, b_first),
            },
            {"SciPy": 40, "NumPy 4×4 matmul": 10},
        ),
        Job(
            "ScLERP",
            count,
            {
                "dq8": lambda: dq8.sclerp(a, b, t, out=out),
                "dq8 float32": lambda: dq8.sclerp(a32, b32, 0.5),
                "pytransform3d": lambda: p3t.dual_quaternions_sclerp(a_first, b_first, t),
            },
            {"pytransform3d": 100},
        ),
        Job(
            "logarithm",
            count,
            {
                "dq8": lambda: dq8.to_twist(a),
                "dq8 float32": lambda: dq8.to_twist(a32),
                "dq8 RigidTransform": own_x.as_exp_coords,
                "SciPy": x.as_exp_coords,
                "pytransform3d": lambda: p3t.exponential_coordinates_from_transforms(matrices),
            },
            {"SciPy": 30},
        ),
        Job(
            "inverse",
            count,
            {"dq8": lambda: dq8.conjugate(a, out=out), "dq8 RigidTransform": own_x.inv, "SciPy": x.inv},
        ),
        Job(
            "a point by each",
            count,
            {
                "dq8": lambda: dq8.transform_points(a, points),
                "dq8 RigidTransform": lambda: own_x.apply(points),
                "SciPy": lambda: x.apply(points),
                "NumPy 3×3 matmul + t": lambda: (matrices[:, :3, :3] @ columns)[..., 0] + matrices[:, :3, 3],
            },
        ),
    ]


def of_an_arm(configurations: int) -> list[Job]:
    """Poses of the links of a 7-axis arm (DH-like offsets, hinges about z) from its angles."""
    rng = np.random.default_rng(1)
    joints = 7
    offsets = Theirs.from_components(rng.normal(size=(joints, 3)), Rotation.random(joints, rng=rng))
    motions = offsets.as_dual_quat()
    axes = np.tile([0.0, 0, 1, 0, 0, 0], (joints, 1))
    angles = rng.uniform(-3, 3, size=(configurations, joints))
    parents = [-1, *range(joints - 1)]
    arm, chain = dq8.Mechanism(parents, "revolute", [0, 0, 1], motions), dq8.Hierarchy(parents)
    angles32, tool = angles.astype(np.float32), joints - 1
    poses = np.empty((configurations, joints, 8))
    columns = np.empty((configurations, joints, 6)).swapaxes(-1, -2)

    def by_hierarchy() -> np.ndarray:
        dq8.integrate_body(motions, axes, angles, out=poses)
        return chain.local_to_model(poses, out=poses)

    forward: dict[str, Callable[[], object]] = {
        "dq8": lambda: arm.poses(angles, out=poses),
        "dq8 float32": lambda: arm.poses(angles32),
        "dq8, the last link alone": lambda: arm.poses(angles, tool),
        "dq8 Hierarchy": by_hierarchy,
    }
    jacobian: dict[str, Callable[[], object]] = {
        "dq8": lambda: arm.jacobian(angles, tool, out=columns),
        "dq8 float32": lambda: arm.jacobian(angles32, tool),
    }
    jobs = [
        Job("arm of 7 joints, per configuration", configurations, forward),
        Job("its Jacobian, per configuration", configurations, jacobian),
    ]
    try:
        import pinocchio as pin
    except ImportError:
        print("pinocchio is not installed (pip install pin): the arm runs without it", file=sys.stderr)
        return jobs
    model = pin.Model()
    link = 0
    for j, matrix in enumerate(offsets.as_matrix()):
        link = model.addJoint(link, pin.JointModelRZ(), pin.SE3(matrix), f"joint {j}")
    data = model.createData()
    # All must compute the same.
    ways = [dq8.to_matrix(way) for way in (arm.poses(angles), by_hierarchy())]
    jacobians = arm.jacobian(angles, tool)
    for i in range(5):
        pin.computeJointJacobians(model, data, angles[i])
        for matrices in ways:
            np.testing.assert_allclose(np.array(data.oMi[joints]), matrices[i, -1], rtol=0, atol=1e-12)
        # Linear first, there.
        np.testing.assert_allclose(data.J[[3, 4, 5, 0, 1, 2]], jacobians[i], rtol=0, atol=1e-12)

    def one_by_one(function: Callable[[object, object, np.ndarray], object]) -> None:
        for q in angles:
            function(model, data, q)

    loop = "pinocchio, in a loop"
    forward[loop] = lambda: one_by_one(pin.forwardKinematics)
    jacobian[loop] = lambda: one_by_one(pin.computeJointJacobians)
    jobs[0].goals[loop] = 20
    return jobs


def of_single_calls() -> list[Job]:
    rng = np.random.default_rng(2)
    made = [Theirs.from_components(rng.normal(size=3), Rotation.random(rng=rng)) for _ in range(2)]
    calls = {
        "x * y": lambda x, y, r, p: x * y,
        "x ** 0.5": lambda x, y, r, p: x**0.5,
        "x.inv()": lambda x, y, r, p: x.inv(),
        "x.apply(p)": lambda x, y, r, p: x.apply(p),
        "x.as_matrix()": lambda x, y, r, p: x.as_matrix(),
        "x.as_dual_quat()": lambda x, y, r, p: x.as_dual_quat(),
        "x.as_exp_coords()": lambda x, y, r, p: x.as_exp_coords(),
        "x.translation": lambda x, y, r, p: x.translation,
        "x.rotation": lambda x, y, r, p: x.rotation,
        "from_translation": lambda x, y, r, p: type(x).from_translation(p),
        "from_rotation": lambda x, y, r, p: type(x).from_rotation(r),
        "from_components": lambda x, y, r, p: type(x).from_components(p, r),
        "from_matrix": lambda x, y, r, p, m=made[0].as_matrix(): type(x).from_matrix(m),
        "from_dual_quat": lambda x, y, r, p, d=made[0].as_dual_quat(): type(x).from_dual_quat(d),
        "from_exp_coords": lambda x, y, r, p, e=made[0].as_exp_coords(): type(x).from_exp_coords(e),
        "identity": lambda x, y, r, p: type(x).identity(),
        "concatenate": lambda x, y, r, p: type(x).concatenate([x, y]),
        "mean": lambda x, y, r, p: x.mean(),
    }
    rotation, point = made[0].rotation, rng.normal(size=3)
    jobs = []
    for name, call in calls.items():
        contenders = {}
        for who, pair in (("dq8", [dq8.RigidTransform.from_matrix(m.as_matrix()) for m in made]), ("SciPy", made)):
            contenders[who] = lambda call=call, pair=pair: call(*pair, rotation, point)
        jobs.append(Job(f"single {name}", 1, contenders, {"SciPy": 1}))
    return jobs


def table(jobs: list[Job]) -> str:
    lines = ["| job | contender | ns | times dq8's | goal |", "|---|---|---|---|---|"]
    for job in jobs:
        own = job.best["dq8"]
        for name, ns in job.best.items():
            goal = f"≥ {job.goals[name]:g}" if name in job.goals else ""
            ratio = "" if name == "dq8" else f"{ns / own:.1f}" if ns / own < 10 else f"{ns / own:.0f}"
            lines.append(f"| {job.name} | {name} | {ns:,.1f} | {ratio} | {goal} |")
    return "\n".join(lines)


def drawn(jobs: list[Job]) -> Figure:
    """A group of bars for each job, 800 pixels wide: dq8, then its peers, the quickest first, with their numbers."""
    figure, axes = plt.subplots(figsize=(8, 8), dpi=100)
    times = [ns for job in jobs for ns in job.best.values()]
    # From a power of ten that is less than all; a quarter of the width is for the number behind the longest bar.
    low = 10.0 ** np.floor(np.log10(min(times)))
    high = low * (max(times) / low) ** (1 / 0.75)
    place, names = 0.0, []
    for job in jobs:
        # As far to the left as the title.
        at = ((MARGIN - LEFT) / (RIGHT - LEFT), place)
        axes.text(*at, job.name, transform=axes.get_yaxis_transform(), va="center", weight="bold", size=10)
        own = job.best["dq8"]
        for name, ns in sorted(job.best.items(), key=lambda item: (not item[0].startswith("dq8"), item[1])):
            place += 1
            is_own = name.startswith("dq8")
            axes.barh(place, ns, 0.78, color="#0072b2" if is_own else "#bbb")
            ratio = "" if is_own else f" ({ns / own:.{0 if ns / own >= 10 else 1}f}×)"
            axes.annotate(f"{ns:.3g}{ratio}", (ns, place), (4, 0), textcoords="offset points", va="center", size=9)
            names.append((place, name))
        place += 1.6
    axes.set_yticks([at for at, _ in names], [name for _, name in names], size=9)
    axes.tick_params(axis="y", length=0)
    axes.tick_params(axis="x", labelsize=9)
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    axes.set_ylim(place - 0.6, -1)
    axes.set_xlabel("nanoseconds per element, on a logarithmic scale", size=9)
    figure.text(MARGIN, 1, "dq8 and its peers in Python", va="top", size=13, weight="bold")
    note = (
        "Nanoseconds per element, less is better, and in brackets how many times dq8's.\n"
        "One thread, float64 unless it says otherwise."
    )
    figure.text(MARGIN, 1, note, va="top", size=9)
    for spine in ("top", "right", "left"):
        axes.spines[spine].set_visible(False)
    # Heights in inches: of a row, of what is above the axes, and below.
    row, above, below = 0.19, 0.75, 0.5
    height = row * (place + 0.4) + above + below
    figure.set_figheight(height)
    title, note_text = figure.texts
    title.set_y(1 - 0.1 / height)
    note_text.set_y(1 - 0.38 / height)
    figure.subplots_adjust(left=LEFT, right=RIGHT, top=1 - above / height, bottom=below / height)
    return figure


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="few elements, few rounds")
    parser.add_argument("--plot", metavar="FILE", help="where to write the plot")
    parser.add_argument("--check", action="store_true", help="fail if a goal is missed by more than half")
    options = parser.parse_args()
    count, configurations = (10_000, 1_000) if options.quick else (100_000, 10_000)
    dq8.set_num_threads(1)
    print(f"dq8 {dq8.__version__} ({dq8.backend()}), NumPy {np.__version__}, SciPy {scipy.__version__}, {count} elements\n")
    jobs = [*of_arrays(count), *of_an_arm(configurations), *of_single_calls()]
    for job in jobs:
        job.run(*((1, 100, 2) if options.quick else (8, 2000, 3)))
    print(table(jobs))
    if options.plot:
        plt.switch_backend("agg")
        drawn([job for job in jobs if not job.name.startswith("single")]).savefig(options.plot)
    missed = [
        f"{job.name}: {job.best[peer] / job.best['dq8']:.1f} times as fast as {peer}, goal {goal:g}"
        for job in jobs
        for peer, goal in job.goals.items()
        if job.best[peer] / job.best["dq8"] < (goal / 2 if options.check else goal)
    ]
    for line in missed:
        print("missed:", line)
    return 1 if options.check and missed else 0


if __name__ == "__main__":
    sys.exit(main())
