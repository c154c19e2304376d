"""`RigidTransform`: SciPy's class of that name, on dual quaternions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import ORTHOGONAL, check_out, floats, unrigid_made_rigid
from ._extras import needed
from ._rotations import FIRST, LAST

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, DTypeLike, NDArray
    from scipy.spatial.transform import Rotation


def identity(shape: int | tuple[int, ...] = (), dtype: DTypeLike = np.float64) -> NDArray[Any]:
    """The motions that move nothing.

    Parameters
    ----------
    shape : int or tuple of ints, optional
        Leading dimensions.
    dtype : optional
        float64, the default, or float32.

    Returns
    -------
    ndarray, shape (*shape, 8)
        ``1 + 0ε``, of the dtype given.

    Examples
    --------
    >>> import dq8
    >>> dq8.identity()
    array([0., 0., 0., 1., 0., 0., 0., 0.])
    """
    leading = (shape,) if isinstance(shape, int) else tuple(shape)
    motions = np.zeros((*leading, 8), dtype)
    motions[..., 3] = 1
    return motions


def _rotation_type() -> type[Rotation]:
    # Imported when it is needed: importing SciPy takes longer than importing this package.
    made: type[Rotation] = needed("scipy.spatial.transform", "scipy").Rotation
    return made


class RigidTransform:
    """Rigid motions: a rotation, then a translation.

    The methods of ``scipy.spatial.transform.RigidTransform``, on an array ``(..., 8)`` of unit dual
    quaternions. What differs:

    - float32 stays float32: a transform has the precision of the arrays it is made of (`dtype`, `astype`), and so have
      the arrays that it returns.
    - Transforms are dual quaternions and not matrices, so they are always rigid. ``copy=False`` does not
      share memory with a matrix, and ``normalize=False`` takes rows of a matrix that is not rigid for
      those of the rotation which their quaternion gives; a last row that is not 0 0 0 1 and a determinant that is
      not positive are errors in any case.
    - Any number of leading dimensions, and exponents of `**` that broadcast.
    - What returns an array writes to ``out=``: `apply`, `as_matrix`, `as_exp_coords`, `as_dual_quat`. `motions` is the
      array itself.

    Parameters
    ----------
    matrix : array_like, shape (..., 4, 4)
        Matrices ``[R t; 0 1]`` for column vectors; lengths in the unit of the caller.
    normalize : bool, optional
        Whether to check that the matrix is rigid, and to make R the nearest rotation.
    copy : bool, optional
        Without effect.

    Examples
    --------
    >>> from dq8 import RigidTransform as Tf
    >>> step = Tf.from_translation([1, 0, 0])
    >>> (step * step).translation
    array([2., 0., 0.])
    """

    __slots__ = ("_motions",)

    def __init__(self, matrix: ArrayLike, normalize: bool = True, copy: bool = True) -> None:
        matrices = floats("matrix", matrix, (4, 4))
        if normalize:
            matrices = unrigid_made_rigid(matrices)
        self._motions = _core.from_matrix(matrices, check=False)

    @staticmethod
    def _of(motions: NDArray[Any]) -> RigidTransform:
        """Of unit dual quaternions that nobody else writes."""
        transform = RigidTransform.__new__(RigidTransform)
        transform._motions = motions
        return transform

    @staticmethod
    def from_matrix(matrix: ArrayLike) -> RigidTransform:
        """From matrices ``[R t; 0 1]``, shape (..., 4, 4), t in lengths.

        R becomes the nearest rotation where it is none by more than rounding. ValueError where the last row
        is not 0 0 0 1 or the determinant of R is not positive.
        """
        return RigidTransform(matrix)

    @staticmethod
    def from_rotation(rotation: Rotation) -> RigidTransform:
        """From a SciPy rotation r of any shape, in float64, without translation: ``r + 0ε``."""
        return RigidTransform.from_components(np.zeros(3), rotation)

    @staticmethod
    def from_translation(translation: ArrayLike) -> RigidTransform:
        """From translations t, shape (..., 3), in lengths, without rotation: ``1 + ½εt``."""
        return RigidTransform._of(_core.from_translation(translation))

    @staticmethod
    def from_components(translation: ArrayLike, rotation: Rotation) -> RigidTransform:
        """Rotate, then translate, ``r + ½εtr``: translations t, shape (..., 3), in lengths, and a SciPy rotation r.

        They broadcast; SciPy's rotations are float64, and so is the result.
        """
        if not isinstance(rotation, _rotation_type()):
            raise TypeError(f"Expected `rotation` to be a `Rotation` instance, got {type(rotation)}.")
        return RigidTransform._of(_core.from_rotation_translation(rotation.as_quat(), translation))

    @staticmethod
    def from_exp_coords(exp_coords: ArrayLike) -> RigidTransform:
        """From exponential coordinates, shape (..., 6): rotation vector in radians, then velocity in lengths.

        ``exp(½ξ)`` of the twist ξ = ω + εv.
        """
        return RigidTransform._of(_core.from_twist(floats("exp_coords", exp_coords, (6,))))

    @staticmethod
    def from_dual_quat(dual_quat: ArrayLike, *, scalar_first: bool = False) -> RigidTransform:
        """From dual quaternions σ, shape (..., 8), real part then dual part, made unit: ``σ/√(σσ*)``.

        The scalar is the last of each four, or the first. A real part of zero is taken for 1.
        """
        if scalar_first:
            dual_quat = floats("dual_quat", dual_quat, (8,))[..., LAST]
        return RigidTransform._of(_core.unit_or_identity(dual_quat))

    @staticmethod
    def identity(
        num: int | None = None, *, shape: int | tuple[int, ...] | None = None
    ) -> RigidTransform:
        """`num` transforms that move nothing, or of a `shape`, or a single one; float64."""
        if num is not None and shape is not None:
            raise ValueError("Only one of `num` and `shape` can be specified.")
        if num is not None:
            shape = (num,)
        elif shape is None:
            shape = ()
        elif not isinstance(shape, (int, tuple)):
            raise ValueError("`shape` must be an int or a tuple of ints or None.")
        return RigidTransform._of(identity(shape))

    @staticmethod
    def concatenate(transforms: RigidTransform | Iterable[RigidTransform]) -> RigidTransform:
        """One after the other along the first dimension; single ones count as one."""
        if isinstance(transforms, RigidTransform):
            return RigidTransform._of(transforms._motions.copy())
        transforms = list(transforms)
        if not all(isinstance(transform, RigidTransform) for transform in transforms):
            raise TypeError("input must contain RigidTransform objects only")
        return RigidTransform._of(
            np.concatenate([np.atleast_2d(transform._motions) for transform in transforms])
        )

    @property
    def motions(self) -> NDArray[Any]:
        """The unit dual quaternions themselves, shape (..., 8), of `dtype`: what is written here changes the transform."""
        return self._motions

    @property
    def dtype(self) -> np.dtype[Any]:
        """float64 or float32."""
        return self._motions.dtype

    def astype(self, dtype: DTypeLike) -> RigidTransform:
        """The same transforms in float64 or float32."""
        if np.dtype(dtype) not in ORTHOGONAL:
            raise TypeError(f"Expected `dtype` to be float64 or float32, got {np.dtype(dtype)}.")
        return RigidTransform._of(_core.normalize(self._motions.astype(dtype)))

    def as_matrix(self, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
        """Matrices ``[R t; 0 1]``, shape (..., 4, 4), of `dtype`, t in lengths; written to `out`, if given."""
        return _core.to_matrix(self._motions, out=out)

    def as_components(self) -> tuple[NDArray[Any], Rotation]:
        """Translations, shape (..., 3), of `dtype`, in lengths, and a SciPy rotation, which is float64."""
        return self.translation, self.rotation

    def as_exp_coords(self, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
        """Exponential coordinates, shape (..., 6), of `dtype`: rotation vector of at most π radians, then velocity.

        ``2 log σ``, the dual angle times the dual axis; the velocity in lengths. Written to `out`, if given.
        """
        return _core.to_twist(self._motions, out=out)

    def as_dual_quat(
        self, *, scalar_first: bool = False, out: NDArray[Any] | None = None
    ) -> NDArray[Any]:
        """Unit dual quaternions ``p + εq``, shape (..., 8), of `dtype`: p, then q, scalars last or first.

        q is a length. Written to `out`, if given.
        """
        motions = self._motions[..., FIRST] if scalar_first else self._motions
        if out is None:
            return motions if scalar_first else motions.copy()
        check_out(out, motions)
        np.copyto(out, motions)
        return out

    @property
    def rotation(self) -> Rotation:
        """The rotations ``p``, as SciPy has them: float64."""
        return _rotation_type().from_quat(self._motions[..., :4])

    @property
    def translation(self) -> NDArray[Any]:
        """The translations ``2qp*``, shape (..., 3), of `dtype`, in lengths."""
        return _core.translation(self._motions)

    @property
    def single(self) -> bool:
        """Whether this is one transform, and not an array of them."""
        return self._motions.ndim == 1

    @property
    def shape(self) -> tuple[int, ...]:
        """The leading dimensions; () of a single transform."""
        return self._motions.shape[:-1]

    def inv(self) -> RigidTransform:
        """The inverses ``σ*``."""
        return RigidTransform._of(_core.conjugate(self._motions))

    def apply(
        self, vector: ArrayLike, inverse: bool = False, *, out: NDArray[Any] | None = None
    ) -> NDArray[Any]:
        """Points moved: ``Rv + t``, or by the inverses.

        Parameters
        ----------
        vector : array_like, shape (..., 3)
            Points, lengths, converted to `dtype`; leading dimensions broadcast.
        inverse : bool, optional
            Whether to move them back.
        out : ndarray, optional
            Where to write the result.

        Returns
        -------
        ndarray, shape (..., 3)
            Of `dtype`.
        """
        points = _core.real_array("vector", vector).astype(self.dtype, copy=False)
        if points.shape[-1:] != (3,):
            raise ValueError(f"Expected vector to have shape (..., 3), got {points.shape}.")
        motions = _core.conjugate(self._motions) if inverse else self._motions
        return _core.transform_points(motions, points, out=out)

    def mean(
        self, weights: ArrayLike | None = None, axis: int | tuple[int, ...] | None = None
    ) -> RigidTransform:
        """The chordal mean of the rotations with the mean of the translations, over all or some axes.

        ``r + ½εtr`` with ``t = Σ wᵢtᵢ/Σ wᵢ`` and the unit r for which ``Σ wᵢ(r·rᵢ)²`` is greatest.

        `dq8.mean` is another one, which does not depend on the frame.

        Parameters
        ----------
        weights : array_like, the shape of the transforms, optional
            Not negative; equal ones by default.
        axis : int or tuple of ints, optional
            Over which dimensions; all by default.

        References
        ----------
        R. Hartley et al., "Rotation Averaging", IJCV 103 (2013); F. L. Markley et al., "Averaging
        Quaternions", J. Guidance, Control, and Dynamics 30 (2007).
        """
        shape = self.shape
        motions = self._motions[np.newaxis] if self.single else self._motions
        rank = motions.ndim - 1
        if motions.shape[0] == 0:
            raise ValueError("Mean of an empty rotation set is undefined.")
        axes = tuple(range(rank)) if axis is None else (axis,) if isinstance(axis, int) else axis
        if not isinstance(axes, tuple):
            raise ValueError("`axis` must be None, int, or tuple of ints.")
        if any(not -rank <= a < rank for a in axes):
            raise ValueError(f"axis {axes} is out of bounds for transform with shape {shape}.")
        over = tuple(sorted({a % rank for a in axes}))
        kept = tuple(a for a in range(rank) if a not in over)

        if weights is None:
            w = np.ones(motions.shape[:-1])
        else:
            w = _core.real_array("weights", weights).astype(np.float64, copy=False)
            if (w < 0).any():
                raise ValueError("`weights` must be non-negative.")
            if w.shape != shape:
                raise ValueError(
                    f"Expected `weights` to match transform shape, got shape {w.shape} for {shape} transformations."
                )
            w = w.reshape(motions.shape[:-1])
        leading = tuple(motions.shape[a] for a in kept)
        w = w.transpose(*kept, *over).reshape(*leading, -1)
        w = w / w.sum(axis=-1, keepdims=True)
        ordered = motions.transpose(*kept, *over, rank).reshape(*leading, -1, 8)
        rotations = ordered[..., :4].astype(np.float64, copy=False)
        # The largest eigenvector of Σ w r rᵀ.
        squares = np.swapaxes(rotations * w[..., np.newaxis], -1, -2) @ rotations
        rotation = np.linalg.eigh(squares)[1][..., -1]
        translation = (w[..., np.newaxis, :] @ _core.translation(ordered))[..., 0, :]
        made = _core.from_rotation_translation(rotation, translation)
        return RigidTransform._of(made.astype(self.dtype, copy=False))

    def __mul__(self, other: RigidTransform) -> RigidTransform:
        """Composition ``στ``: `other` τ acts first. Leading dimensions broadcast; the result is normalized."""
        if not isinstance(other, RigidTransform):
            return NotImplemented
        try:
            return RigidTransform._of(_core.compose(self._motions, other._motions))
        except ValueError:
            raise ValueError(
                f"Cannot broadcast {self.shape} transforms in first to {other.shape} transforms in second object."
            ) from None

    def __pow__(self, n: ArrayLike) -> RigidTransform:
        """The part `n` of each screw motion, ``exp(n log σ)``; of an array, each its own."""
        exponent = n if isinstance(n, (int, float)) else _core.real_array("n", n).astype(self.dtype, copy=False)
        if not isinstance(exponent, (int, float)) and exponent.shape == (1,):
            exponent = exponent[0]
        return RigidTransform._of(_core.pow(self._motions, exponent))

    def __len__(self) -> int:
        if self.single:
            raise TypeError("Single transform has no len")
        return len(self._motions)

    def __getitem__(self, indexer: Any) -> RigidTransform:
        if self.single:
            raise TypeError("Single transform is not subscriptable.")
        picked = self._motions[_before_components(indexer)]
        return RigidTransform._of(picked if picked.base is None else picked.copy())

    def __setitem__(self, indexer: Any, value: RigidTransform) -> None:
        if self.single:
            raise TypeError("Single transform is not subscriptable.")
        if not isinstance(value, RigidTransform):
            raise TypeError("value must be a RigidTransform object")
        self._motions[_before_components(indexer)] = value._motions

    def __iter__(self) -> Iterator[RigidTransform]:
        if self.single:
            raise TypeError("Single transform is not iterable.")
        return (RigidTransform._of(motions.copy()) for motions in self._motions)

    def __repr__(self) -> str:
        first, *others = repr(self.as_matrix()).splitlines()
        return "RigidTransform.from_matrix(" + "\n".join([first, *(" " * 27 + line for line in others)]) + ")"

    def __reduce__(self) -> tuple[Any, ...]:
        return RigidTransform._of, (self._motions,)


def _before_components(indexer: Any) -> Any:
    """An index into motions that does not reach into their eight numbers."""
    if not isinstance(indexer, tuple):
        return indexer
    # `in` would compare arrays.
    if any(part is Ellipsis for part in indexer):
        return (*indexer, slice(None))
    return (*indexer, Ellipsis, slice(None))
