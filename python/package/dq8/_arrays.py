"""Arrays, checked before they become transforms."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

# How far RRᵀ may be from 1 in a matrix whose R is taken as it is: some units of the last place, which
# rounding to the type leaves. Beyond, the nearest rotation is sought.
ORTHOGONAL = {np.dtype(np.float64): 1e-12, np.dtype(np.float32): 2e-6}


def floats(name: str, value: ArrayLike, core: tuple[int, ...]) -> NDArray[Any]:
    """`value` as an array of float32 or float64 whose last dimensions are `core`."""
    array = _core.real_array(name, value)
    if array.shape[-len(core) :] != core:
        dimensions = ", ".join(map(str, core))
        raise ValueError(f"Expected `{name}` to have shape (..., {dimensions}), got {array.shape}.")
    if array.dtype == np.float16:
        return array.astype(np.float32)
    if array.dtype.kind in "iub":
        return array.astype(np.float64)
    return array


def check_out(out: NDArray[Any], result: NDArray[Any]) -> None:
    """What the compiled functions say where `out` cannot hold the result."""
    if not isinstance(out, np.ndarray):
        raise TypeError(f"Expected `out` to be an array, got {type(out).__name__}.")
    if hasattr(type(out), "mask"):
        raise TypeError(f"Expected `out` to have no mask, got {type(out).__name__}.")
    if out.dtype != result.dtype:
        raise TypeError(f"Expected `out` to have dtype {result.dtype}, the dtype of the result, got {out.dtype}.")
    if out.shape != result.shape:
        raise ValueError(f"Expected `out` to have shape {result.shape}, that of the result, got {out.shape}.")
    if not out.flags.writeable:
        raise ValueError("Expected `out` to be writeable, got a read-only array.")


def unrigid_made_rigid(matrices: NDArray[Any]) -> NDArray[Any]:
    """`matrices` with the nearest rotation in the place of each R that is none.

    Raises ValueError where there is none: a last row that is not 0 0 0 1, a reflection, or no volume.
    """
    rigidity = _core.rigidity(matrices)
    if (rigidity[..., 2] != 0).any():
        index = tuple(int(i) for i in np.argwhere(rigidity[..., 2] != 0)[0])
        raise ValueError(
            f"Expected last row of transformation matrix {index} to be exactly [0, 0, 0, 1], got {matrices[index][3]}"
        )
    if (rigidity[..., 1] <= 0).any():
        index = tuple(int(i) for i in np.argwhere(rigidity[..., 1] <= 0)[0])
        raise ValueError(
            "Non-positive determinant (left-handed or null coordinate frame) in rotation matrix "
            f"{index}: {matrices[index][:3, :3]}."
        )
    skew = ~(rigidity[..., 0] <= ORTHOGONAL[matrices.dtype])
    if not skew.any():
        return matrices
    matrices = matrices.copy()
    u, _, vt = np.linalg.svd(matrices[skew][..., :3, :3])
    matrices[skew, :3, :3] = u @ vt
    return matrices
