"""A call of every function and method that has `out=`, for the tests of what holds for all of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import RigidTransform as Theirs
from scipy.spatial.transform import Rotation

import dq8
from dq8 import RigidTransform

COUNT, JOINTS = 21, 5


def motions(rng: np.random.Generator, *shape: int, size: float = 1.0) -> np.ndarray:
    """Unit dual quaternions from SciPy, with translations of about `size`."""
    count = int(np.prod(shape))
    rotations = Rotation.random(count, rng=rng)
    transforms = Theirs.from_components(size * rng.normal(size=(count, 3)), rotations)
    return transforms.as_dual_quat().reshape(*shape, 8)


def neighbours(rng: np.random.Generator, *shape: int) -> np.ndarray:
    """Motions less than half a turn from each other, where interpolations and means do not jump."""
    return dq8.integrate_body(motions(rng), 0.3 * rng.normal(size=(*shape, 6)), 1.0)


def weights(rng: np.random.Generator, *shape: int) -> np.ndarray:
    return rng.dirichlet(np.ones(JOINTS), size=shape)


# What an argument is made of. Each call has its own, in float64.
MOTIONS = lambda rng: motions(rng, COUNT)
NEIGHBOURS = lambda rng: neighbours(rng, COUNT)
INFLUENCES = lambda rng: neighbours(rng, COUNT, JOINTS)
LOCALS = lambda rng: motions(rng, COUNT, JOINTS)
WEIGHTS = lambda rng: weights(rng, COUNT)
NUMBERS = lambda rng: rng.random(COUNT)
VECTORS = lambda rng: rng.normal(size=(COUNT, 3))
TWISTS = lambda rng: rng.normal(size=(COUNT, 6))
PLANES = lambda rng: rng.normal(size=(COUNT, 4))
ROTATIONS = lambda rng: Rotation.random(COUNT, rng=rng).as_quat()
MATRICES = lambda rng: dq8.to_matrix(motions(rng, COUNT))
SCREWS = lambda rng: dq8.to_screw(motions(rng, COUNT))
TIMES = lambda rng: np.cumsum(0.5 + rng.random(COUNT))
WINDOW = lambda rng: rng.random(3)
PALETTE = lambda rng: neighbours(rng, JOINTS)
VALUES = lambda rng: rng.uniform(-1, 1, size=(COUNT, 3))

HIERARCHY = dq8.Hierarchy([-1, 0, 0, 1, 3])
ARM = dq8.Mechanism(
    [-1, 0, 1, 2],
    ["revolute", "revolute", "revolute", "fixed"],
    [[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, 1]],
    dq8.from_translation([1.0, 0.5, 0.0]),
)
MESH_JOINTS = np.add.outer(np.arange(COUNT), np.arange(JOINTS)) % JOINTS


def skin(points, weights, palette, out=None):
    return dq8.skin(points, MESH_JOINTS, weights, palette, out=out)


def reach(values, nearby, out=None):
    """Back to `values`, from a tenth of the way to others."""
    return ARM.reach(ARM.poses(values, 3), values + 0.1 * (nearby - values), 3, out=out)[0]


def of_transform(method: str) -> Callable:
    def call(motions, *points, out=None):
        return getattr(RigidTransform.from_dual_quat(motions), method)(*points, out=out)

    return call


CALLS: dict[str, tuple[Callable, list[Callable]]] = {
    "mul": (dq8.mul, [MOTIONS, MOTIONS]),
    "compose": (dq8.compose, [MOTIONS, MOTIONS]),
    "inverse": (dq8.inverse, [MOTIONS]),
    "conjugate": (dq8.conjugate, [MOTIONS]),
    "normalize": (dq8.normalize, [MOTIONS]),
    "unit_or_identity": (dq8._core.unit_or_identity, [MOTIONS]),
    "nlerp": (dq8.nlerp, [NEIGHBOURS, NEIGHBOURS, NUMBERS]),
    "sclerp": (dq8.sclerp, [NEIGHBOURS, NEIGHBOURS, NUMBERS]),
    "squad": (dq8.squad, [NEIGHBOURS, NEIGHBOURS, NEIGHBOURS, NEIGHBOURS, NUMBERS]),
    "squad_control": (dq8.squad_control, [NEIGHBOURS, NEIGHBOURS, NEIGHBOURS]),
    "resample": (dq8.resample, [TIMES, NEIGHBOURS, TIMES]),
    "log": (dq8.log, [MOTIONS]),
    "exp": (dq8.exp, [TWISTS]),
    "to_twist": (dq8.to_twist, [MOTIONS]),
    "from_twist": (dq8.from_twist, [TWISTS]),
    "pow": (dq8.pow, [MOTIONS, NUMBERS]),
    "to_screw": (dq8.to_screw, [MOTIONS]),
    "from_screw": (dq8.from_screw, [SCREWS]),
    "integrate_body": (dq8.integrate_body, [MOTIONS, TWISTS, NUMBERS]),
    "integrate_spatial": (dq8.integrate_spatial, [MOTIONS, TWISTS, NUMBERS]),
    "left_jacobian": (dq8.left_jacobian, [TWISTS]),
    "left_jacobian_inverse": (dq8.left_jacobian_inverse, [TWISTS]),
    "transform_points": (dq8.transform_points, [MOTIONS, VECTORS]),
    "transform_vectors": (dq8.transform_vectors, [MOTIONS, VECTORS]),
    "transform_lines": (dq8.transform_lines, [MOTIONS, TWISTS]),
    "transform_planes": (dq8.transform_planes, [MOTIONS, PLANES]),
    "adjoint": (dq8.adjoint, [MOTIONS, TWISTS]),
    "coadjoint": (dq8.coadjoint, [MOTIONS, TWISTS]),
    "from_translation": (dq8.from_translation, [VECTORS]),
    "from_rotation_translation": (dq8.from_rotation_translation, [ROTATIONS, VECTORS]),
    "translation": (dq8.translation, [MOTIONS]),
    "to_matrix": (dq8.to_matrix, [MOTIONS]),
    "from_matrix": (dq8.from_matrix, [MATRICES]),
    "rigidity": (dq8._core.rigidity, [MATRICES]),
    "angle_to": (dq8.angle_to, [MOTIONS, MOTIONS]),
    "distance_to": (dq8.distance_to, [MOTIONS, MOTIONS]),
    "distance_weighted": (dq8.distance_weighted, [MOTIONS, MOTIONS, NUMBERS]),
    "point_error": (dq8.point_error, [MOTIONS, MOTIONS, VECTORS]),
    "dlb": (dq8.dlb, [INFLUENCES, WEIGHTS]),
    "mean": (dq8.mean, [INFLUENCES, WEIGHTS]),
    "dib_windows": (dq8.dib_windows, [NEIGHBOURS, WINDOW]),
    "chain_products": (dq8.chain_products, [NEIGHBOURS]),
    "skin": (skin, [VECTORS, WEIGHTS, PALETTE]),
    "Hierarchy.local_to_model": (HIERARCHY.local_to_model, [LOCALS]),
    "Hierarchy.model_to_local": (HIERARCHY.model_to_local, [LOCALS]),
    "Mechanism.poses": (ARM.poses, [VALUES]),
    "Mechanism.jacobian": (lambda values, out=None: ARM.jacobian(values, 3, out=out), [VALUES]),
    "Mechanism.reach": (reach, [VALUES, VALUES]),
    "RigidTransform.as_matrix": (of_transform("as_matrix"), [MOTIONS]),
    "RigidTransform.as_exp_coords": (of_transform("as_exp_coords"), [MOTIONS]),
    "RigidTransform.as_dual_quat": (of_transform("as_dual_quat"), [MOTIONS]),
    "RigidTransform.apply": (of_transform("apply"), [MOTIONS, VECTORS]),
}


def arguments_of(name: str, rng: np.random.Generator, dtype=np.float64) -> list[np.ndarray]:
    """The arguments of a call, which a seed makes the same in every precision."""
    return [make(rng).astype(dtype) for make in CALLS[name][1]]
