"""A tube that follows a chain of joints: bind poses, weights, skin, normals, many frames."""

import numpy as np

import dq8

joints, rings, around = 5, 81, 24
height, angle = np.meshgrid(np.linspace(0, 4, rings), np.linspace(0, 2 * np.pi, around, endpoint=False), indexing="ij")
normals = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1).reshape(-1, 3)
points = 0.4 * normals + height.reshape(-1, 1) * [0, 0, 1]

# Each vertex follows the two joints next to it.
below = np.minimum(height.reshape(-1).astype(int), joints - 2)
share = height.reshape(-1) - below
influences, weights = np.stack([below, below + 1], axis=-1), np.stack([1 - share, share], axis=-1)

step = dq8.from_translation(np.where(np.arange(joints)[:, None] > 0, [0.0, 0, 1], 0))
bind = dq8.chain_products(step)
# 60 frames of a bend that grows: a turn at each joint.
bend = dq8.from_euler("xyz", np.linspace(0, 0.4, 60)[:, None] * [1.0, 0, 0.5])
poses = dq8.chain_products(dq8.mul(step, bend[:, None]), axis=1)
palette = dq8.mul(poses, dq8.inverse(bind))

moved, turned = dq8.skin(points, influences, weights, palette, normals=normals)
print("frames, vertices:", moved.shape[:2])
assert np.allclose(moved[0], points) and np.allclose(np.linalg.norm(turned, axis=-1), 1)
for method in ("lbs", "dlb"):
    last = dq8.skin(points, influences, weights, palette[-1], method=method)
    radius = np.linalg.norm(last.reshape(rings, around, 3) - last.reshape(rings, around, 3).mean(axis=1, keepdims=True), axis=-1)
    print(f"{method}: the radius of 0.4 is {radius.min():.3f} at the least")
