"""A call of everything public that computes, large enough to take long: what a promise of the README holds for.

By name: what is made before, and the call. Calls that are quick for all data that fit memory are called over and over.
"""

from pathlib import Path

MANY = "many = np.tile(turned, (1_000_000, 1))"
OTHERS = "many, points = np.tile(turned, (1_000_000, 1)), np.ones((1_000_000, 3))"
CLIP = "clip = np.tile(turned, (40_000, 60, 1))"
VALUES = "values = np.zeros((500_000, 1))"
STAMPED = "stamps, many = np.arange(3_000_000.0), np.tile(turned, (3_000_000, 1))"
PATH = "path = dq8.Trajectory(np.arange(1000.0), np.tile(turned, (1000, 1))); at = np.linspace(0, 999, 3_000_000)"

HERE = Path(__file__).parents[2]
WALK = (
    f"from dq8 import retarget as rt; robot = rt.Humanoid({str(HERE / 'robot/robots/humanoid.urdf')!r});"
    f"text = open({str(HERE / 'examples/mocap/walk.bvh')!r}).read(); head, rows = text.split('Frames: ');"
    "count, time, rows = rows.split('\\n', 2); import tempfile, os; folder = tempfile.TemporaryDirectory();"
    "path = os.path.join(folder.name, 'walk.bvh');"
    "write = lambda path, k: open(path, 'w').write(f'{head}Frames: {k * int(count)}\\n{time}\\n' + k * rows);"
)
MOVED = WALK + "write(path, 50); motion = rt.retarget(rt.load(path), robot, fps=60)"

CALLS: dict[str, tuple[str, str]] = {
    "retarget.load": (WALK + "write(path, 2_000)", "rt.load(path)"),
    "retarget.positions": ("from dq8 import retarget as rt; at = np.random.default_rng(1).normal(size=(300_000, 5, 3))",
                           "rt.positions('abcde', [-1, 0, 0, 1, 2], at, 60)"),  # fmt: skip
    "retarget.body_model": (
        "from dq8 import retarget as rt; at = np.random.default_rng(1).normal(size=(100_000, 22, 3));"
        "model = {'v_template': at[0], 'shapedirs': at[0][..., None], 'J_regressor': np.eye(22)}",
        "rt.body_model(model, at, at[:, 0], 60)",
    ),
    "retarget.Humanoid": (WALK, "rt.Humanoid(robot.__reduce__()[1][0])"),
    "retarget.retarget": (WALK + "write(path, 500); person = rt.load(path)", "rt.retarget(person, robot, fps=60)"),
    "retarget.report": (MOVED, "rt.report(motion, rt.load(path))"),
    "retarget.save": (MOVED, "rt.save(motion, os.path.join(folder.name, 'walk.npz'))"),
    "retarget.save of text": (MOVED, "rt.save(motion, os.path.join(folder.name, 'walk.csv'))"),
    "retarget.archive": (
        WALK + "paths = [os.path.join(folder.name, f'{i}.bvh') for i in range(20)]; [write(path, 100) for path in paths]",
        "rt.archive(paths, robot, folder.name, fps=60)",
    ),
    "PackedClip": (CLIP, "dq8.PackedClip(clip)"),
    "PackedClip.deviation": (
        CLIP + "; packed, legs = dq8.PackedClip(clip), dq8.Hierarchy([-1] + list(range(59)))",
        "packed.deviation(legs, clip, 0.1)",
    ),
    "PackedClip.sample": (
        "packed = dq8.PackedClip(np.tile(turned, (50, 120, 1))); at = np.linspace(0, 49, 100_000)",
        "packed.sample(at)",
    ),
    "Mechanism.from_urdf": (
        "links = ''.join(f'<link name=\"l{i}\"/>' for i in range(150_000));"
        "joints = ''.join(f'<joint name=\"j{i}\" type=\"revolute\"><parent link=\"l{i}\"/><child link=\"l{i + 1}\"/>"
        "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>' for i in range(149_999));"
        "text = f'<robot name=\"r\">{links}{joints}</robot>'",
        "dq8.Mechanism.from_urdf(text)",
    ),
    "Mechanism.solutions": (
        "offsets = [[0, 0, 0.1], [0, 0.1, 0], [0.4, 0, 0], [0.4, 0, 0], [0, 0.1, 0], [0, 0, -0.1]];"
        "axes = np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 0, -1], [0, 1, 0]]);"
        "six = dq8.Mechanism(range(-1, 5), 'revolute', axes, dq8.from_translation(offsets));"
        "start = np.tile([0.4, -1.2, 1.5, -0.8, 1.1, 0.2], (1_000_000, 1)); targets = six.poses(start, 5)",
        "six.solutions(targets, start)",
    ),
    "Mechanism.reach": ("far = np.tile(dq8.from_translation([1e3, 0, 0]), (3_000_000, 1))", "arm.reach(far, np.zeros(2), 1)"),
    "Mechanism.reach of goals": (
        "points = np.full((1_000_000, 2, 3), 1e3); goals = [dq8.Goal.position(1), dq8.Goal.position(0).at([1.0, 0, 0])]",
        "arm.reach(points, np.zeros(2), goals)",
    ),
    "Mechanism.track": (
        "clip = np.tile(dq8.from_translation([1e3, 0, 0]), (3_000_000, 1))",
        "arm.track(clip, np.zeros(2), 1)",
    ),
    "Mechanism.sequence": (
        "clips, targets = np.full(100_000, 30), np.tile(dq8.from_translation([1e3, 0, 0]), (3_000_000, 1))",
        "arm.sequence(clips, targets, np.zeros(2), 1)",
    ),
    "Mechanism.floating": (
        "long = dq8.Mechanism(range(-1, 99_999), 'fixed', [0, 0, 1], dq8.identity())",
        "long.floating()",
    ),
    "Mechanism.poses": (VALUES, "chain.poses(values, 2_000)"),
    "Mechanism.jacobian": (VALUES, "chain.jacobian(values, 2_000)"),
    "Mechanism.velocity": (VALUES, "chain.velocity(values, values, 2_000)"),
    "Mechanism.rates_for": (VALUES, "chain.rates_for(values, np.ones(6), 2_000)"),
    "Mechanism.manipulability": (VALUES, "chain.manipulability(values, 2_000)"),
    "Mechanism.sample": ("", "arm.sample(3_000_000)"),
    "Hierarchy.local_to_model": (
        "legs = dq8.Hierarchy([-1] + list(range(59)));" + CLIP,
        "legs.local_to_model(clip)",
    ),
    "Hierarchy.model_to_local": (
        "legs = dq8.Hierarchy([-1] + list(range(59)));" + CLIP,
        "legs.model_to_local(clip)",
    ),
    "mean": (MANY, "dq8.mean(many, tolerance=-1.0, max_iterations=10_000)"),
    "mean of few": ("eight = np.tile(turned, (20_000, 8, 1))", "dq8.mean(eight, tolerance=-1.0, max_iterations=2_000)"),
    "dlb": ("eight = np.tile(turned, (300_000, 8, 1))", "dq8.dlb(eight)"),
    "dib_windows": (
        "path = np.tile(turned, (20_000, 1))",
        "dq8.dib_windows(path, np.ones(9), tolerance=-1.0, max_iterations=5_000)",
    ),
    "chain_products": (MANY, "dq8.chain_products(many)"),
    "resample": (MANY, "dq8.resample(np.arange(1_000_000), many, np.linspace(0, 999_999, 3_000_000))"),
    "skin": (
        "mesh = np.ones((50_000, 3)), np.tile(np.arange(64), (50_000, 1)), np.full((50_000, 64), 1 / 64)",
        "dq8.skin(*mesh, np.tile(turned, (200, 64, 1)))",
    ),
    "skin of matrices": (
        "entries = np.tile(np.diag([1.0, 2, 3, 1])[:3], (1_000_000, 1, 1))",
        "dq8.skin(np.ones((5, 3)), np.zeros((5, 1), int), np.ones((5, 1)), entries)",
    ),
    "deskew": (
        "cloud, times = np.ones((10_000_000, 3)), np.random.default_rng(1).random(10_000_000)",
        "dq8.deskew(cloud, times, np.linspace(0, 1, 8), np.tile(turned, (8, 1)), out=cloud)",
    ),
    "skew": (
        "cloud, times = np.ones((10_000_000, 3)), np.random.default_rng(1).random(10_000_000)",
        "dq8.skew(cloud, times, np.linspace(0, 1, 8), np.tile(turned, (8, 1)), out=cloud)",
    ),
    "Trajectory": (STAMPED, "dq8.Trajectory(stamps, many)"),
    "Trajectory.sorted": (STAMPED, "dq8.Trajectory.sorted(stamps[::-1], many)"),
    "Trajectory.poses": (STAMPED + "; path = dq8.Trajectory(stamps, many)", "path.poses"),
    "Trajectory.sample": (PATH, "path.sample(at)"),
    "Spline": (MANY, "dq8.Spline(many)"),
    "compare": ("path = dq8.Trajectory(np.arange(300_000.0), np.tile(turned, (300_000, 1)))", "dq8.compare(path, path)"),
    "fit": ("points = np.random.default_rng(1).normal(size=(200_000, 10, 3))", "dq8.fit(points, points)"),
    "hand_eye": ("motions = dq8.random((50_000, 5), rng=1)", "dq8.hand_eye(motions, motions)"),
    "hand_eye, robust": ("motions = dq8.random((5_000, 5), rng=1)", "dq8.hand_eye(motions, motions, robust='tukey')"),
    "fit, robust": ("points = np.random.default_rng(1).normal(size=(20_000, 10, 3))", "dq8.fit(points, points + 0.01 * points[:, ::-1], robust='tukey')"),
    "fit, robust, one of many points": (
        "points = np.random.default_rng(1).normal(size=(2_000_000, 3))",
        "dq8.fit(points, points + 0.01 * points[:, ::-1], robust='tukey')",
    ),
    "hand_eye, one of many pairs": ("motions = dq8.random(2_000_000, rng=1)", "dq8.hand_eye(motions, motions)"),
    "hand_eye, robust, one of many pairs": ("motions = dq8.random(500_000, rng=1)", "dq8.hand_eye(motions, motions, robust='tukey')"),
    "from_matrix": ("matrices = np.tile(np.eye(4), (3_000_000, 1, 1))", "dq8.from_matrix(matrices)"),
    "angle_to": ("a = np.tile(turned, (12_000, 1)).astype(np.float32)", "dq8.angle_to(a[:, None], a)"),
    "allclose": (MANY, "dq8.allclose(many, many)"),
    "is_unit": (MANY, "dq8.is_unit(many)"),
    "random": ("", "dq8.random(500_000)"),
    "from_euler": ("angles = np.zeros((1_000_000, 3))", "dq8.from_euler('xyz', angles)"),
    "to_euler": (MANY, "dq8.to_euler(many, 'xyz')"),
    "from_axis_angle": (OTHERS, "dq8.from_axis_angle(points, 0.3)"),
    "to_axis_angle": (MANY, "dq8.to_axis_angle(many)"),
    "from_rotation": (MANY, "dq8.from_rotation(many[:, :4], check=False)"),
    "from_rotation_vector": (OTHERS, "dq8.from_rotation_vector(points)"),
    "to_rotation_vector": (MANY, "dq8.to_rotation_vector(many)"),
    "to_rotation_translation": (MANY, "dq8.to_rotation_translation(many)"),
    "rotation": (MANY, "dq8.rotation(many)"),
    "from_wxyz": (MANY, "dq8.from_wxyz(many)"),
    "to_wxyz": (MANY, "dq8.to_wxyz(many)"),
    "to_scipy": (MANY, "dq8.to_scipy(many)"),
    "from_scipy": ("theirs = dq8.to_scipy(np.tile(turned, (10_000, 1)))", "dq8.from_scipy(theirs)"),
    "RigidTransform": (MANY, "dq8.RigidTransform.from_dual_quat(many).inv().as_matrix()"),
    "identity": ("", "dq8.identity(1_000_000)"),
}

# Settings, what others return, and what others take.
WITHOUT_OF_RETARGET = ["Motion", "Person", "Report", "settings"]

# Settings of the process, what others return, and what lends memory.
WITHOUT = ["to_arrow", "from_arrow", "Comparison", "Fit", "Goal", "HandEye", "Hierarchy", "Mechanism", "Outcome", "ReachReport", "Solutions", "Statistics", "backend",
           "get_num_threads", "progress", "set_num_threads", "set_reproducible"]  # fmt: skip


def of_table(name: str, parameters: dict[str, tuple[int, ...]]) -> tuple[str, str]:
    """A call of a function of `_signatures`, on a million elements."""
    made = {(8,): "many", (6,): "twists", (3,): "points", (4,): "many[:, :4]", (): "0.5", (4, 4): "matrices"}
    arguments = ", ".join("many[:, :8]" if own in ("logs", "screws") else made[shape] for own, shape in parameters.items())
    matrices = "; matrices = np.tile(np.eye(4), (1_000_000, 1, 1))" if (4, 4) in parameters.values() else ""
    checked = ", check=False" if name in ("from_rotation_translation", "from_screw") else ""
    return f"{OTHERS}; twists = np.full((1_000_000, 6), 0.3){matrices}", f"dq8._core.{name}({arguments}{checked})"
