"""A script for SciPy's classes, with one import changed; and both sides by side."""

import numpy as np
from scipy.spatial.transform import RigidTransform as Theirs
from scipy.spatial.transform import Rotation

import dq8
from dq8 import RigidTransform

rng = np.random.default_rng(1)
turns = Rotation.random(1000, rng=rng)
a = RigidTransform.from_components(rng.normal(size=(1000, 3)), turns)
b = RigidTransform.from_exp_coords(rng.normal(size=(1000, 6)))
c = (a * b.inv()) ** 0.5
print(c[0].as_matrix().round(3))

same = Theirs.from_components(a.translation, turns) * Theirs.from_exp_coords(b.as_exp_coords()).inv()
assert np.allclose((same**0.5).as_matrix(), c.as_matrix())

# Arrays take SciPy's rotations, and give them back.
motions = dq8.from_rotation_translation(turns, a.translation)
assert dq8.allclose(motions, a.motions)
assert np.allclose(dq8.to_euler(motions, "xyz"), turns.as_euler("xyz"))
assert np.allclose(dq8.to_scipy(motions).as_matrix(), dq8.to_matrix(motions))

# Points measured before and after: the motion between them, and where a camera sits on a hand.
points = rng.normal(size=(1000, 20, 3))
moved = dq8.transform_points(motions[:, None], points) + 0.001 * rng.normal(size=points.shape)
print("fits are off by", dq8.point_error(dq8.fit(points, moved), motions, [0, 0, 0]).max().round(4))
camera, seen = dq8.random(rng=2), dq8.random(8, rng=3)
hand = dq8.mul(dq8.mul(camera, seen), dq8.inverse(camera))
assert dq8.allclose(dq8.hand_eye(hand, seen), camera)
