"""Rigid motions as dual quaternions, for NumPy arrays on SIMD lanes.

A motion is eight numbers, ``[px, py, pz, pw, qx, qy, qz, qw]``: the dual quaternion p + εq with p the
rotation and q = ½tp, t the translation. This is the layout of SciPy's
``RigidTransform.as_dual_quat(scalar_first=False)``.

Functions take arrays ``(..., 8)`` and broadcast leading dimensions. Arguments are arrays of real numbers of at most
64 bits, or what NumPy makes such arrays of; a call computes in float32 if all of them are float32 or float16, otherwise
in float64. Python's own numbers, as the exponent of `pow`, do not count. Arrays that lie in memory one element after the
other are read as they are; others are copied first. Refused are masked arrays, and arrays that are not in memory (Dask)
or take NumPy's functions over. ``out=`` writes into an array of the result's shape and dtype; where it does not fit, or an
argument is wrong, nothing is written.

Ctrl-C ends a call within 0.2 seconds. What `out` holds then is partly the result, partly what it held before. `progress`
tells how much of a call is done.

`Mechanism` is a robot: joint values ``(..., values)`` to poses of links and Jacobians, and back from poses
(`Mechanism.reach`; `track` and `sequence` for clips of targets; `solutions` for all ways of an arm of six hinges). `skin` lets a mesh follow joints.
`PackedClip` is an animation in a quarter of its memory.

`Trajectory` is poses at stamps: sampled at any times, and clouds of points moved by the pose at each point's time (`deskew`).
`Spline` is a smooth one by control poses; `compare` gives evo's figures for two.

Time is the first dimension of a clip ``(frames, joints, 8)``; ``axis=`` says where it is another. Columns of Arrow are
taken as arrays of rows (`from_arrow`, `to_arrow`). ``dq8.dask`` has the functions for arrays of Dask.

`RigidTransform` wraps such an array in the methods of ``scipy.spatial.transform.RigidTransform``.

Angles are radians, lengths the unit of the caller; in a dual quaternion p has no unit and q is a length. ``a b`` lets b
act first, matrices are for column vectors.
"""

import os as _os

from ._arrow import from_arrow, to_arrow
from ._comparisons import allclose, is_unit, random
from ._core import (
    Hierarchy,
    Mechanism,
    PackedClip,
    ReachReport,
    Spline,
    Trajectory,
    adjoint,
    angle_to,
    backend,
    chain_products,
    coadjoint,
    compose,
    conjugate,
    dib_windows,
    distance_to,
    distance_weighted,
    dlb,
    exp,
    from_matrix,
    from_rotation_translation,
    from_screw,
    from_translation,
    from_twist,
    get_num_threads,
    integrate_body,
    integrate_spatial,
    inverse,
    left_jacobian,
    left_jacobian_inverse,
    log,
    mean,
    mul,
    nlerp,
    normalize,
    point_error,
    pow,
    resample,
    sclerp,
    set_num_threads,
    set_reproducible,
    skin,
    squad,
    squad_control,
    to_matrix,
    to_screw,
    to_twist,
    transform_lines,
    transform_planes,
    transform_points,
    transform_vectors,
    translation,
)
from ._core import forget_threads as _forget_threads
from ._fits import Fit, HandEye, fit, hand_eye
from ._goals import Goal
from . import _mechanisms as _methods
from . import _notebooks as _shown
from ._outcome import Outcome
from ._progress import progress
from ._rigid_transform import RigidTransform, identity
from ._rotations import (
    from_axis_angle,
    from_euler,
    from_rotation,
    from_rotation_vector,
    from_scipy,
    from_wxyz,
    rotation,
    to_axis_angle,
    to_euler,
    to_rotation_translation,
    to_rotation_vector,
    to_scipy,
    to_wxyz,
)
from ._solutions import Solutions
from ._trajectories import Comparison, Statistics, compare, deskew, skew

__version__ = "0.1.0"

__all__ = [
    "Comparison",
    "Fit",
    "Goal",
    "HandEye",
    "Hierarchy",
    "Mechanism",
    "Outcome",
    "PackedClip",
    "ReachReport",
    "RigidTransform",
    "Solutions",
    "Spline",
    "Statistics",
    "Trajectory",
    "adjoint",
    "allclose",
    "angle_to",
    "backend",
    "chain_products",
    "coadjoint",
    "compare",
    "compose",
    "conjugate",
    "deskew",
    "dib_windows",
    "distance_to",
    "distance_weighted",
    "dlb",
    "exp",
    "fit",
    "from_arrow",
    "from_axis_angle",
    "from_euler",
    "from_matrix",
    "from_rotation",
    "from_rotation_translation",
    "from_rotation_vector",
    "from_scipy",
    "from_screw",
    "from_translation",
    "from_twist",
    "from_wxyz",
    "get_num_threads",
    "hand_eye",
    "identity",
    "integrate_body",
    "integrate_spatial",
    "inverse",
    "is_unit",
    "left_jacobian",
    "left_jacobian_inverse",
    "log",
    "mean",
    "mul",
    "nlerp",
    "normalize",
    "point_error",
    "pow",
    "progress",
    "random",
    "resample",
    "rotation",
    "sclerp",
    "set_num_threads",
    "set_reproducible",
    "skew",
    "skin",
    "squad",
    "squad_control",
    "to_arrow",
    "to_axis_angle",
    "to_euler",
    "to_matrix",
    "to_rotation_translation",
    "to_rotation_vector",
    "to_scipy",
    "to_screw",
    "to_twist",
    "to_wxyz",
    "transform_lines",
    "transform_planes",
    "transform_points",
    "transform_vectors",
    "translation",
]

if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(after_in_child=_forget_threads)


def _threads_of_environment() -> None:
    name = "DQ8_NUM_THREADS"
    value = _os.environ.get(name)
    # Empty is how shells and settings of containers leave it out.
    if not value:
        return
    if not value.isdecimal() or not 1 <= int(value) <= 256:
        raise ValueError(f"Expected the environment variable {name} to be a whole number from 1 to 256, got {value!r}.")
    set_num_threads(int(value))


_threads_of_environment()
