"""An arm of six hinges from a URDF file: all ways to 10,000 poses, and of each the one that is farthest from the limits."""

import sys

import numpy as np

import dq8

arm = dq8.Mechanism.from_urdf(sys.argv[1])
q = arm.sample(10_000, rng=1)
targets = arm.poses(q, arm.links[-1])
found = arm.solutions(targets, q)
counts, poses = np.unique(found.counts, return_counts=True)
print("poses by solutions:", dict(zip(counts.tolist(), poses.tolist())), "complete:", found.complete.all())

# Places that are left over hold NaN.
there = np.arange(8) < found.counts[:, np.newaxis]
assert dq8.allclose(arm.poses(found.values, arm.links[-1])[there], np.repeat(targets, found.counts, axis=0))
# The nearest to the start first, and here the start is one of them.
assert (found.distances[:, 0] < 1e-6).mean() > 0.999

low, high = arm.limits.T
room = np.minimum(found.values - low, high - found.values).min(axis=-1)
best = np.argmax(np.where(there, room, -np.inf), axis=1)
chosen = np.take_along_axis(found.values, best[:, np.newaxis, np.newaxis], axis=1)[:, 0]
before, after = (np.minimum(values - low, high - values).min(axis=-1) for values in (q, chosen))
print(f"from the limits: {np.median(before):.2f} rad as drawn, {np.median(after):.2f} rad as chosen")
assert (after >= before - 1e-6).mean() > 0.999
