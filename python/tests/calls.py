"""A call of every function and method that has `out=`, for the tests of what holds for all of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import RigidTransform as Theirs
from scipy.spatial.transform import Rotation

import dq8
from dq8 import RigidTransform
from dq8._signatures import SIGNATURES

COUNT, JOINTS = 21, 5


def motions(rng: np.random.Generator, *shape: int, size: float = 1.0) -> np.ndarray:
    """Unit dual quaternions from SciPy, with translations of about `size`."""
    count = int(np.prod(shape))
    rotations = Rotation.random(count, rng=rng)
    transforms = Theirs.from_components(size * rng.normal(size=(count, 3)), rotations)
    return transforms.as_dual_quat().reshape(*shape, 8)


def neighbours(rng: np.random.Generator, *shape: int) -> np.ndarray:
    """Motions less than half a turn from each other, where interpolations and means do not jump."""
    return dq8.mul(motions(rng), dq8.from_twist(0.3 * rng.normal(size=(*shape, 6))))


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
LOGS = lambda rng: dq8.log(motions(rng, COUNT))
TIMES = lambda rng: np.cumsum(0.5 + rng.random(COUNT))
WINDOW = lambda rng: rng.random(3)
PALETTE = lambda rng: neighbours(rng, JOINTS)
VALUES = lambda rng: rng.uniform(-1, 1, size=(COUNT, 3))
# The poses of a link in clips of some frames, and in one frame each.
CLIPS = lambda rng: ARM.poses(rng.uniform(-1, 1, size=(COUNT, 1, 3)) + 0.05 * np.arange(4)[:, np.newaxis], 3)
POSES = lambda rng: CLIPS(rng)[:, 0]

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


def made_of(parameters: dict[str, tuple[int, ...]]) -> list[Callable]:
    """What the arguments of a function of the table are made of: by their shape, unless their name says more."""
    by_name = {"rotations": ROTATIONS, "screws": SCREWS, "logs": LOGS}
    # Interpolations and means take motions that are close together, where they do not jump.
    several = sum(shape == (8,) for shape in parameters.values()) > 1
    by_shape = {
        (8,): NEIGHBOURS if several else MOTIONS,
        (6,): TWISTS,
        (4,): PLANES,
        (3,): VECTORS,
        (): NUMBERS,
        (4, 4): MATRICES,
    }
    return [by_name.get(name) or by_shape[shape] for name, shape in parameters.items()]


CALLS: dict[str, tuple[Callable, list[Callable]]] = {
    **{name: (getattr(dq8._core, name), made_of(parameters)) for name, (parameters, _) in SIGNATURES.items()},
    "resample": (dq8.resample, [TIMES, NEIGHBOURS, TIMES]),
    "from_matrix": (dq8.from_matrix, [MATRICES]),
    "dlb": (dq8.dlb, [INFLUENCES, WEIGHTS]),
    "mean": (dq8.mean, [INFLUENCES, WEIGHTS]),
    "dib_windows": (dq8.dib_windows, [NEIGHBOURS, WINDOW]),
    "chain_products": (dq8.chain_products, [NEIGHBOURS]),
    "skin": (skin, [VECTORS, WEIGHTS, PALETTE]),
    "Hierarchy.local_to_model": (HIERARCHY.local_to_model, [LOCALS]),
    "Hierarchy.model_to_local": (HIERARCHY.model_to_local, [LOCALS]),
    "Mechanism.poses": (ARM.poses, [VALUES]),
    "Mechanism.jacobian": (lambda values, out=None: ARM.jacobian(values, 3, out=out), [VALUES]),
    "Mechanism.velocity": (lambda values, rates, out=None: ARM.velocity(values, rates, 3, out=out), [VALUES, VALUES]),
    "Mechanism.rates_for": (lambda values, twists, out=None: ARM.rates_for(values, twists, 3, out=out), [VALUES, TWISTS]),
    "Mechanism.manipulability": (lambda values, out=None: ARM.manipulability(values, 3, out=out), [VALUES]),
    "Mechanism.reach": (reach, [VALUES, VALUES]),
    "Mechanism.track": (lambda targets, values, out=None: ARM.track(targets, values, 3, out=out)[0], [CLIPS, VALUES]),
    "Mechanism.sequence": (
        lambda targets, values, out=None: ARM.sequence(np.ones(COUNT, int), targets, values, 3, out=out)[0], [POSES, VALUES]
    ),
    "RigidTransform.as_matrix": (of_transform("as_matrix"), [MOTIONS]),
    "RigidTransform.as_exp_coords": (of_transform("as_exp_coords"), [MOTIONS]),
    "RigidTransform.as_dual_quat": (of_transform("as_dual_quat"), [MOTIONS]),
    "RigidTransform.apply": (of_transform("apply"), [MOTIONS, VECTORS]),
}


def arguments_of(name: str, rng: np.random.Generator, dtype=np.float64) -> list[np.ndarray]:
    """The arguments of a call, which a seed makes the same in every precision."""
    return [make(rng).astype(dtype) for make in CALLS[name][1]]
