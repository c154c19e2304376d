"""What a motion is like by the kinematics and the shapes of MuJoCo, and what mink finds for the same goals."""

import time

import mink
import mujoco
import numpy as np

SLOW, LOW, SHORTEST = 0.2, 0.04, 0.1  # m/s, m, s: a foot that stands
HIT = 0.01
ANKLE = 0.05


class Scene:
    """A robot in MuJoCo with the goals that dq8 wrote."""

    def __init__(self, robot, targets, clip, columns):
        self.goals, self.step = targets["goals"], targets["step"]
        self.targets = np.array(targets["targets"])
        spec = robot.spec.copy()
        for index, goal in enumerate(self.goals):
            spec.body(goal["link"]).add_site(name=f"goal {index}", pos=goal["point"])
        self.model = model = spec.compile()
        self.data = mujoco.MjData(model)
        self.sites = [model.site(f"goal {index}").id for index in range(len(self.goals))]
        # The column of each value of MuJoCo. The first joint of both floats; its quaternion has w first here.
        self.order = [4, 5, 6, 3, 0, 1, 2]
        for joint in range(1, model.njnt):
            name = model.joint(joint).name
            self.order.append(columns.index(name) if name in columns else -1)
        self.start = self.values(np.array([targets["start"]]))[0]
        self.feet = [index for index, goal in enumerate(self.goals) if goal["role"].endswith("_foot")]
        self.place(model.qpos0)
        self.soles = [self.sole(goal) for goal in self.feet]
        self.stands = self.standing(clip)
        self.pairs = {}

    def values(self, rows):
        """Returns values in the order of MuJoCo."""
        zero = np.zeros((len(rows), 1))
        return np.concatenate([rows, zero], axis=1)[:, self.order]

    def place(self, values):
        self.data.qpos[:] = values
        mujoco.mj_kinematics(self.model, self.data)

    def moving(self, body):
        """Returns the nearest body above, or the body itself, that has a joint."""
        while body and self.model.body_jntnum[body] == 0:
            body = self.model.body_parentid[body]
        return body

    def path(self, body):
        path = [self.moving(body)]
        while path[-1]:
            path.append(self.moving(self.model.body_parentid[path[-1]]))
        return path[::-1]

    def sole(self, goal):
        """Returns the body of a foot, the lowest points of its shapes while the robot stands, and their radii."""
        model, data = self.model, self.data
        body, points = model.body(self.goals[goal]["link"]).id, []
        for geom in range(model.ngeom):
            if self.moving(model.geom_bodyid[geom]) != self.moving(body):
                continue
            kind, size, radius = model.geom_type[geom], model.geom_size[geom], 0.0
            if kind == mujoco.mjtGeom.mjGEOM_MESH:
                mesh = model.geom_dataid[geom]
                first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
                own = model.mesh_vert[first : first + count]
            elif kind == mujoco.mjtGeom.mjGEOM_BOX:
                own = size * (np.indices((2, 2, 2)).reshape(3, -1).T * 2 - 1)
            else:
                own, radius = np.zeros((1, 3)), size[0]
            points += [(data.geom_xpos[geom] + data.geom_xmat[geom].reshape(3, 3) @ p, radius) for p in own]
        if not points:
            soles = [b for b in range(model.nbody) if "sole" in model.body(b).name and self.moving(b) == self.moving(body)]
            site = self.data.site_xpos[self.sites[goal]]
            points = [(data.xpos[soles[0]] if soles else site - [0, 0, ANKLE], 0.0)]
        lowest = min(point[2] - radius for point, radius in points)
        points = [(point, radius) for point, radius in points if point[2] - radius < lowest + 0.01]
        turn, at = data.xmat[body].reshape(3, 3), data.xpos[body]
        return body, np.array([turn.T @ (point - at) for point, _ in points]), np.array([r for _, r in points])

    def standing(self, clip):
        """Returns when the person's feet stand, [foot, frame], from the clip alone: ankle and toes are slow and low."""
        places = clip.places()
        joint = {goal["role"]: clip.names.index(goal["joint"]) for goal in self.goals}
        legs = [f"{side}_{part}" for side in ("left", "right") for part in ("hip", "knee", "foot")]
        bones = [(a, b) for a, b in zip(legs, legs[1:]) if a[0] == b[0]]
        limb = lambda at, index: sum(np.linalg.norm(at[index[a]] - at[index[b]]) for a, b in bones)
        own = {goal["role"]: index for index, goal in enumerate(self.goals)}
        places = places * limb(self.targets[0, :, :3], own) / limb(places[0], joint)
        top = joint.get("head", joint.get("chest"))
        trunk = (places[:, top] - places[:, joint["pelvis"]]).mean(axis=0)
        up = np.argmax(np.abs(trunk))
        new = np.arange(len(self.targets)) * self.step / clip.step
        first = np.minimum((new + 1e-6).astype(int), len(places) - 2)
        share = (new - first)[:, None, None]
        places = places[first] + share * (places[first + 1] - places[first])
        stands = []
        for goal in self.feet:
            ankle = joint[self.goals[goal]["role"]]
            toes = [j for j, parent in enumerate(clip.parents) if parent == ankle and clip.channels[j]]
            still = np.ones(len(places), bool)
            for j in (ankle, *toes):
                way = np.gradient(places[:, j], axis=0) / self.step
                height = places[:, j, up] * np.sign(trunk[up])
                still &= (np.linalg.norm(way, axis=1) < SLOW) & (height < np.sort(height)[len(height) // 20] + LOW)
            edges = np.flatnonzero(np.diff(np.concatenate([[0], still.astype(int), [0]])))
            for begin, end in edges.reshape(-1, 2):
                if end - begin < max(SHORTEST / self.step, 2):
                    still[begin:end] = False
            stands.append(still)
        return np.array(stands)

    def hits(self):
        """Returns `True` if two shapes, of bodies more than three joints apart, are deeper in each other than a centimetre."""
        mujoco.mj_collision(self.model, self.data)
        for contact in self.data.contact:
            if contact.dist >= -HIT:
                continue
            pair = tuple(int(self.model.geom_bodyid[geom]) for geom in contact.geom)
            if pair not in self.pairs:
                a, b = (self.path(body) for body in pair)
                same = sum(x == y for x, y in zip(a, b))
                self.pairs[pair] = 0 not in pair and len(a) + len(b) - 2 * same > 3
            if self.pairs[pair]:
                return True
        return False

    def measure(self, rows):
        """Returns the measures of a motion, [frame, value of MuJoCo]; millimetres, seconds and radians."""
        apart, soles, hits = [], [], []
        for values, targets in zip(rows, self.targets):
            self.place(values)
            apart.append(np.linalg.norm(self.data.site_xpos[self.sites] - targets[:, :3], axis=1))
            soles.append([
                self.data.xpos[body] + points @ self.data.xmat[body].reshape(3, 3).T - radii[:, None] * [0, 0, 1]
                for body, points, radii in self.soles
            ])
            hits.append(self.hits())
        apart = 1e3 * np.array(apart)
        heights, slides, corners, standing = [], [], [], []
        for foot, still in enumerate(self.stands):
            points = 1e3 * np.array([frame[foot] for frame in soles])
            heights.append(points[:, :, 2].min(axis=1))
            standing += list(heights[-1][still])
            both = still[1:] & still[:-1]
            ways = np.diff(points, axis=0)[both] / self.step
            slides += list(np.linalg.norm(ways.mean(axis=1), axis=1))
            corners += list(np.linalg.norm(ways, axis=2).mean(axis=1))
        ground = np.median(standing) if standing else np.nan
        # Joints that mimic others have no value of their own.
        own = np.array(self.order[7:]) >= 0
        joints = rows[:, 7:][:, own]
        low, high = self.model.jnt_range[1:][own].T
        beyond = np.maximum(low - joints, joints - high)[:, self.model.jnt_limited[1:][own].astype(bool)]
        return {
            "residual": apart.mean(),
            "high": np.quantile(apart, 0.95),
            "feet": apart[:, self.feet].mean(),
            "slide": np.mean(slides) if slides else np.nan,
            "corners": np.mean(corners) if corners else np.nan,
            "ground": ground,
            "sink": ground - np.min(heights),
            "speed": np.abs(np.diff(joints, axis=0)).max() / self.step,
            "jerk": np.abs(np.diff(joints, 3, axis=0)).mean() / self.step**3,
            "hits": 100 * np.mean(hits),
            "beyond": max(beyond.max(initial=0.0), 0.0),
        }

    def mink(self, first, steps=10, lag=1 / 480):
        """Returns the motion that mink finds for the same goals, weights and limits, and its seconds of CPU time.

        `lag` makes the weight of the frame before, as dq8 has it. Errors of distances are in metres, and a radian
        counts as the eighth of the longest way along links to a goal.
        """
        model = self.model
        longest = 0.0
        for goal in self.goals:
            body, way = model.body(goal["link"]).id, np.linalg.norm(goal["point"])
            while body:
                way += np.linalg.norm(model.body_pos[body])
                body = model.body_parentid[body]
            longest = max(longest, way)
        length = longest / 8
        tasks = [
            mink.FrameTask(f"goal {index}", "site", goal["position"], goal["rotation"] * length)
            for index, goal in enumerate(self.goals)
        ]
        posture = mink.PostureTask(model, 0.02 * length)
        before = mink.PostureTask(model, np.r_[np.zeros(6), np.full(model.nv - 6, np.sqrt(lag / self.step) * length)])
        posture.set_target(self.start)
        limits = [mink.ConfigurationLimit(model, gain=1.0)]
        configuration = mink.Configuration(model, q=first)
        rows, seconds = [], 0.0
        for frame, targets in enumerate(self.targets):
            turns = self.targets[frame, :, [6, 3, 4, 5]].T
            for index, task in enumerate(tasks):
                own = configuration.get_transform_frame_to_world(f"goal {index}", "site")
                turn = mink.SO3(turns[index]) if self.goals[index]["rotation"] else own.rotation()
                task.set_target(mink.SE3.from_rotation_and_translation(turn, targets[index, :3]))
            before.set_target(configuration.q)
            begin, error = time.process_time(), np.inf
            for _ in range(steps if frame else 10 * steps):
                velocity = mink.solve_ik(configuration, [*tasks, posture, before], 1.0, "daqp", damping=1e-6, limits=limits)
                configuration.integrate_inplace(velocity, 1.0)
                now = sum(np.sum((task.cost * task.compute_error(configuration)) ** 2) for task in tasks)
                if now > error * (1 - 1e-3):
                    break
                error = now
            seconds += time.process_time() - begin
            rows.append(configuration.q.copy())
        return np.array(rows), seconds
