"""An arm from a URDF file: 10,000 configurations, velocities, inverse kinematics."""

import sys

import numpy as np

import dq8

arm = dq8.Mechanism.from_urdf(sys.argv[1])
print(f"{arm.name}: {dict(zip(arm.values, arm.limits.round(2).tolist()))}")
q = arm.sample(10_000, rng=1)
tool = arm.links[-1]
poses = arm.poses(q, tool)
reach = np.linalg.norm(dq8.translation(poses), axis=-1)
print(f"the tool is between {reach.min():.2f} and {reach.max():.2f} from the base")

# Straight down, 0.1 a second: rates that do it, and back.
down = [0, 0, 0, 0, 0, -0.1]
rates = arm.rates_for(q, down, tool, "aligned", damping=1e-4)
error = np.abs(arm.velocity(q, rates, tool, "aligned") - down).max(axis=-1)
print(f"{(error < 1e-3).mean():.1%} of the configurations can")

# By columns, as tables have them, in any order.
columns = {name: q[:, place].copy() for place, name in reversed(list(enumerate(arm.values)))}
assert np.array_equal(arm.poses(columns, tool), poses)

found, report = arm.reach(poses[:1000], arm.sample(1000, rng=2), tool)
print(f"{report.converged.mean():.1%} of 1000 poses reached from elsewhere")
assert dq8.allclose(arm.poses(found, tool)[report.converged], poses[:1000][report.converged], angle=2e-5, length=2e-5)
