"""Rotations as people write them: quaternions, axes and angles, vectors, Euler angles, SciPy's classes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import floats
from ._extras import needed

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from scipy.spatial.transform import Rotation

# Components with the scalar first, and last.
FIRST = [3, 0, 1, 2, 7, 4, 5, 6]
LAST = [1, 2, 3, 0, 5, 6, 7, 4]

# Narrow, so that it is the other argument that decides the precision.
_NOWHERE = np.zeros(3, np.float32)


def rotation(motions: ArrayLike) -> NDArray[Any]:
    """The rotations ``p`` of unit dual quaternions ``p + εq``, shape (..., 4): unit quaternions [x, y, z, w].

    Examples
    --------
    >>> import dq8
    >>> dq8.rotation(dq8.from_translation([1.0, 2.0, 3.0]))
    array([0., 0., 0., 1.])
    """
    return floats("motions", motions, (8,))[..., :4].copy()


def from_rotation(rotations: ArrayLike | Rotation, *, check: bool = True) -> NDArray[Any]:
    """Rotations about the origin, ``r + 0ε``, shape (..., 8), from unit quaternions [x, y, z, w] or SciPy's `Rotation`.

    ValueError names the first quaternion whose length is farther than 0.001 from one; ``check=False`` takes all as they are.

    Examples
    --------
    >>> import dq8
    >>> dq8.transform_points(dq8.from_rotation([0.0, 0.0, 1.0, 0.0]), [1.0, 0.0, 0.0])
    array([-1.,  0.,  0.])
    """
    return _core.from_rotation_translation(rotations, _NOWHERE, check=check)


def to_rotation_translation(motions: ArrayLike) -> tuple[NDArray[Any], NDArray[Any]]:
    """The rotations ``p``, shape (..., 4), and the translations ``2qp*``, shape (..., 3), lengths.

    Examples
    --------
    >>> import dq8
    >>> dq8.to_rotation_translation(dq8.from_rotation_translation([0.0, 0, 1, 0], [1.0, 2, 3]))
    (array([0., 0., 1., 0.]), array([1., 2., 3.]))
    """
    motions = floats("motions", motions, (8,))
    return rotation(motions), _core.translation(motions)


def from_rotation_vector(vectors: ArrayLike) -> NDArray[Any]:
    """Rotations about the origin from rotation vectors, shape (..., 3): axis times angle, radians.

    ``cos(θ/2) + sin(θ/2)a`` of θa.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> turn = dq8.from_rotation_vector([0.0, 0.0, np.pi / 2])
    >>> dq8.transform_points(turn, [1.0, 0.0, 0.0]).round(9) + 0.0
    array([0., 1., 0.])
    """
    vectors = floats("vectors", vectors, (3,))
    return _core.from_twist(np.concatenate([vectors, np.zeros_like(vectors)], axis=-1))


def to_rotation_vector(motions: ArrayLike) -> NDArray[Any]:
    """The rotation vectors of motions, shape (..., 3): axis times angle, at most π radians; ``2 log p``.

    Examples
    --------
    >>> import dq8
    >>> dq8.to_rotation_vector(dq8.from_rotation_vector([0.0, 0.0, 0.5])).round(12)
    array([0. , 0. , 0.5])
    """
    return _core.to_twist(motions)[..., :3].copy()


def from_axis_angle(axes: ArrayLike, angles: ArrayLike) -> NDArray[Any]:
    """Rotations about axes through the origin, shape (..., 3) and of any length, by angles, shape (...), radians.

    ``cos(θ/2) + sin(θ/2)a/|a|``; NaN of an axis without length.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> dq8.from_axis_angle([0.0, 0.0, 2.0], np.pi)[:3].round(9)
    array([0., 0., 1.])
    """
    axes = floats("axes", axes, (3,))
    angles = np.asarray(_core.real_array("angles", angles), axes.dtype if np.ndim(angles) == 0 else None)
    with np.errstate(invalid="ignore"):
        units = axes / np.linalg.norm(axes, axis=-1, keepdims=True)
    return from_rotation_vector(angles[..., np.newaxis] * units)


def to_axis_angle(motions: ArrayLike) -> tuple[NDArray[Any], NDArray[Any]]:
    """Unit axes, shape (..., 3), and angles in [0, π] radians, shape (...), of the rotations of motions.

    ``θ = |2 log p|``. Where nothing turns, the axis is (1, 0, 0).

    Examples
    --------
    >>> import dq8
    >>> axis, angle = dq8.to_axis_angle(dq8.from_axis_angle([0.0, 0.0, 1.0], -0.5))
    >>> axis + 0.0, angle.round(12)
    (array([ 0.,  0., -1.]), np.float64(0.5))
    """
    vectors = to_rotation_vector(motions)
    angles = np.linalg.norm(vectors, axis=-1)
    turns = angles[..., np.newaxis] > 0
    axes = np.divide(vectors, angles[..., np.newaxis], out=np.zeros_like(vectors), where=turns)
    axes[..., :1] += ~turns
    return axes, angles


def _order(order: str) -> tuple[list[int], bool]:
    """The axes by number as an extrinsic order has them, and whether it was one."""
    if not isinstance(order, str):
        kind = type(order).__name__
        raise TypeError(f"Expected `order` to be text, as in from_euler('xyz', angles) and to_euler(motions, 'xyz'), got {kind}.")
    axes = ["xyz".find(axis) for axis in order.lower()]
    if not (order.islower() or order.isupper()) or len(axes) != 3 or -1 in axes or axes[0] == axes[1] or axes[1] == axes[2]:
        raise ValueError(
            "Expected `order` to be three of x, y and z (fixed axes) or of X, Y and Z (moving axes), "
            f"none twice in a row, got {order!r}."
        )
    return (axes, True) if order.islower() else (axes[::-1], False)


def from_euler(order: str, angles: ArrayLike) -> NDArray[Any]:
    """Rotations from Euler angles, shape (..., 3), radians, in an order as SciPy writes them.

    ``'xyz'`` turns about the fixed axes, x first: ``r = r_z r_y r_x``. ``'XYZ'`` turns about the moving axes, X first:
    ``r = r_x r_y r_z``.

    Examples
    --------
    >>> import dq8, numpy as np
    >>> yaw = dq8.from_euler("ZYX", [np.pi / 2, 0.0, 0.0])
    >>> dq8.transform_points(yaw, [1.0, 0.0, 0.0]).round(9) + 0.0
    array([0., 1., 0.])
    """
    axes, fixed = _order(order)
    angles = floats("angles", angles, (3,))
    turns = angles if fixed else angles[..., ::-1]
    vectors = np.zeros((3, *angles.shape), angles.dtype)
    for place, axis in enumerate(axes):
        vectors[place, ..., axis] = turns[..., place]
    first, second, third = from_rotation_vector(vectors)
    return _core.mul(third, _core.mul(second, first))


def to_euler(motions: ArrayLike, order: str) -> NDArray[Any]:
    """Euler angles, shape (..., 3), radians, of the rotations of motions: what `from_euler` makes ``p`` of.

    The middle one is in [0, π], or in [−π/2, π/2] where the order names three axes. Where it is at an end, and only a
    sum of the others counts, the last of them is zero (of fixed axes: the third, of moving ones: the first).

    References
    ----------
    E. Bernardes, S. Viollet, "Quaternion to Euler angles conversion", PLoS ONE 17 (2022).

    Examples
    --------
    >>> import dq8
    >>> dq8.to_euler(dq8.from_euler("ZYX", [0.3, -0.2, 0.1]), "ZYX").round(12)
    array([ 0.3, -0.2,  0.1])
    """
    (i, j, k), fixed = _order(order)
    p = floats("motions", motions, (8,))[..., :4]
    proper = i == k
    if proper:
        k = 3 - i - j
    sign = (i - j) * (j - k) * (k - i) // 2
    a, b, c, d = p[..., 3], p[..., i], p[..., j], sign * p[..., k]
    if not proper:
        a, b, c, d = a - c, b + d, c + a, d - b
    middle = 2 * np.arctan2(np.hypot(c, d), np.hypot(a, b))
    half_sum, half_difference = np.arctan2(b, a), np.arctan2(d, c)
    first, last = half_sum - half_difference, half_sum + half_difference
    near = 4 * np.sqrt(np.finfo(p.dtype).eps) if p.dtype == np.float32 else 1e-7
    for end, alone in ((np.abs(middle) <= near, 2 * half_sum), (np.abs(middle - np.pi) <= near, -2 * half_difference)):
        first, last = np.where(end, alone, first), np.where(end, 0, last)
    if not proper:
        last, middle = sign * last, middle - np.pi / 2
    angles = np.stack([first, middle, last] if fixed else [last, middle, first], axis=-1)
    return ((angles + np.pi) % (2 * np.pi) - np.pi).astype(p.dtype, copy=False)


def from_wxyz(components: ArrayLike) -> NDArray[Any]:
    """Dual quaternions, shape (..., 8), or quaternions, shape (..., 4), from the order of the literature, ``w`` first.

    [pw, px, py, pz, qw, qx, qy, qz] becomes ``p + εq``, q a length; quaternions [w, x, y, z] become [x, y, z, w].

    Examples
    --------
    >>> import dq8
    >>> dq8.from_wxyz([1.0, 0.0, 0.0, 0.0])
    array([0., 0., 0., 1.])
    """
    return _ordered("components", components, LAST)


def to_wxyz(components: ArrayLike) -> NDArray[Any]:
    """Dual quaternions ``p + εq``, shape (..., 8), or quaternions, shape (..., 4), in the order that has w first.

    Examples
    --------
    >>> import dq8
    >>> dq8.to_wxyz(dq8.identity())
    array([1., 0., 0., 0., 0., 0., 0., 0.])
    """
    return _ordered("components", components, FIRST)


def _ordered(name: str, value: ArrayLike, order: list[int]) -> NDArray[Any]:
    array = _core.real_array(name, value)
    if array.shape[-1:] not in [(4,), (8,)]:
        raise ValueError(f"Expected `{name}` to have shape (..., 8) or (..., 4), got {array.shape}.")
    return array[..., order[: array.shape[-1]]]


def from_scipy(transform: Any) -> NDArray[Any]:
    """Unit dual quaternions, shape (..., 8), of SciPy's `RigidTransform` or `Rotation`: ``r + ½εtr``.

    Examples
    --------
    >>> import dq8
    >>> from scipy.spatial.transform import Rotation
    >>> dq8.from_scipy(Rotation.identity()) + 0.0
    array([0., 0., 0., 1., 0., 0., 0., 0.])
    """
    if hasattr(transform, "as_dual_quat"):
        motions: NDArray[Any] = transform.as_dual_quat()
        return motions
    if hasattr(transform, "as_quat"):
        return from_rotation(transform)
    raise TypeError(f"Expected `transform` to be a RigidTransform or Rotation of SciPy, got {type(transform).__name__}.")


def to_scipy(motions: ArrayLike) -> Any:
    """SciPy's own `RigidTransform` of unit dual quaternions ``p + εq``, shape (..., 8).

    Examples
    --------
    >>> import dq8
    >>> dq8.to_scipy(dq8.from_translation([1.0, 2.0, 3.0])).translation
    array([1., 2., 3.])
    """
    transforms = needed("scipy.spatial.transform", "scipy")
    return transforms.RigidTransform.from_dual_quat(floats("motions", motions, (8,)))
