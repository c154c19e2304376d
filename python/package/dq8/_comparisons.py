"""Random motions, and whether motions are the same."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, DTypeLike, NDArray


def random(
    shape: int | tuple[int, ...] = (), *, length: float = 1.0, rng: Any = None, dtype: DTypeLike = np.float64
) -> NDArray[Any]:
    """Random unit dual quaternions ``r + ½εtr``: all rotations alike, translations normal.

    Parameters
    ----------
    shape : int or tuple of ints, optional
        Leading dimensions.
    length : float, optional
        The standard deviation of each component of the translation, a length.
    rng : optional
        A generator of NumPy, or a seed for one.
    dtype : optional
        float64, the default, or float32.

    Returns
    -------
    ndarray, shape ``(*shape, 8)``

    Examples
    --------
    >>> import dq8
    >>> dq8.random((2, 3), rng=1).shape
    (2, 3, 8)
    """
    rng = np.random.default_rng(rng)
    leading = (shape,) if isinstance(shape, int) else tuple(shape)
    rotations = rng.normal(size=(*leading, 4))
    rotations /= np.linalg.norm(rotations, axis=-1, keepdims=True)
    made = _core.from_rotation_translation(rotations, length * rng.normal(size=(*leading, 3)), check=False)
    return made.astype(dtype, copy=False)


def allclose(a: ArrayLike, b: ArrayLike, *, angle: float = 1e-8, length: float = 1e-8) -> bool:
    """Whether motions are the same up to sign and rounding: ``angle_to(a, b)`` and ``distance_to(a, b)`` are small.

    Parameters
    ----------
    a, b : array_like, shape (..., 8)
        Unit dual quaternions; leading dimensions broadcast. σ and −σ are the same motion.
    angle, length : float, optional
        The largest differences: radians, and lengths. (float32 has rounding of some 1e-7.)

    Returns
    -------
    bool
        False where something is NaN.

    Examples
    --------
    >>> import dq8
    >>> a = dq8.random(5, rng=1)
    >>> dq8.allclose(a, -a)
    True
    """
    # A distance of them all that is NaN is not at most anything.
    return bool(np.max(_core.distance_to(a, b), initial=0) <= length and np.max(_core.angle_to(a, b), initial=0) <= angle)


def is_unit(motions: ArrayLike, *, tolerance: float = 1e-6) -> Any:
    """Whether dual quaternions are unit: ``| |p| − 1 |`` and ``|p·q|`` are at most `tolerance`, this relative to ``1 + |q|``.

    Parameters
    ----------
    motions : array_like, shape (..., 8)
        Dual quaternions.
    tolerance : float, optional
        A pure number.

    Returns
    -------
    ndarray of bool, shape (...)

    Examples
    --------
    >>> import dq8
    >>> motion = dq8.random(rng=1)
    >>> bool(dq8.is_unit(motion)), bool(dq8.is_unit(2 * motion))
    (True, False)
    """
    return _core.unit_defect(motions) <= tolerance
