"""Arrow's C data interface, without a library of Arrow: arrays in and out, with no copy where there need be none.

https://arrow.apache.org/docs/format/CDataInterface/PyCapsuleInterface.html
"""

from __future__ import annotations

import ctypes
import itertools
from collections.abc import Callable
from ctypes import POINTER, Structure, c_char_p, c_int, c_int64, c_void_p, cast, py_object
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._names import order

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class _Schema(Structure):
    pass


class _Array(Structure):
    pass


class _Stream(Structure):
    pass


_Release = ctypes.CFUNCTYPE(None, c_void_p)
_Schema._fields_ = [
    ("format", c_char_p), ("name", c_char_p), ("metadata", c_void_p), ("flags", c_int64), ("n_children", c_int64),
    ("children", POINTER(POINTER(_Schema))), ("dictionary", c_void_p), ("release", _Release), ("private_data", c_void_p),
]  # fmt: skip
_Array._fields_ = [
    ("length", c_int64), ("null_count", c_int64), ("offset", c_int64), ("n_buffers", c_int64), ("n_children", c_int64),
    ("buffers", POINTER(c_void_p)), ("children", POINTER(POINTER(_Array))), ("dictionary", c_void_p),
    ("release", _Release), ("private_data", c_void_p),
]  # fmt: skip
_Get = ctypes.CFUNCTYPE(c_int, c_void_p, c_void_p)
_Stream._fields_ = [
    ("get_schema", _Get), ("get_next", _Get), ("get_last_error", ctypes.CFUNCTYPE(c_char_p, c_void_p)),
    ("release", _Release), ("private_data", c_void_p),
]  # fmt: skip

_pointer = ctypes.pythonapi.PyCapsule_GetPointer
_pointer.restype, _pointer.argtypes = c_void_p, [py_object, c_char_p]
_new_capsule = ctypes.pythonapi.PyCapsule_New
_new_capsule.restype, _new_capsule.argtypes = py_object, [c_void_p, c_char_p, c_void_p]

# As libraries say of lists that they make.
_NULLABLE = 2

_NUMBERS: dict[bytes, np.dtype[Any]] = {
    form: np.dtype(name)
    for form, name in zip(
        (b"f", b"g", b"e", b"c", b"C", b"s", b"S", b"i", b"I", b"l", b"L"),
        "float32 float64 float16 int8 uint8 int16 uint16 int32 uint32 int64 uint64".split(),
    )
}


class _Owner:
    """What keeps memory of a producer alive: released with the last array that shows it."""

    def __init__(self, array: _Array, before: int = 0) -> None:
        # Rows of a column are counted from its first chunk on.
        self.array, self.before = array, before

    def __del__(self) -> None:
        if self.array.release:
            self.array.release(ctypes.addressof(self.array))


def _moved(source: int) -> _Array:
    """An array of a producer, from now on this one's to release."""
    array = _Array.from_buffer_copy(cast(source, POINTER(_Array)).contents)
    cast(source, POINTER(_Array)).contents.release = _Release()
    return array


def _memory(owner: _Owner, address: int | None, dtype: np.dtype[Any], first: int, count: int) -> NDArray[Any]:
    if not count:
        return np.empty(0, dtype)
    if not address:
        raise ValueError("Expected an Arrow array with numbers, got one without a buffer.")
    raw = (ctypes.c_byte * (count * dtype.itemsize)).from_address(address + first * dtype.itemsize)
    # Of whom NumPy's arrays are views, and who holds the producer's.
    raw._owner = owner  # type: ignore[attr-defined]
    numbers: NDArray[Any] = np.frombuffer(memoryview(raw), dtype)
    numbers.flags.writeable = False
    return numbers


def _check_nulls(owner: _Owner, array: _Array, what: str, first: int, count: int, size: int = 1) -> None:
    if array.null_count == 0 or array.n_buffers == 0 or not array.buffers[0] or not count:
        return
    begin = array.offset + first
    bits = _memory(owner, array.buffers[0], np.dtype(np.uint8), 0, (begin + count + 7) // 8)
    valid = np.unpackbits(bits, bitorder="little")[begin : begin + count]
    if not valid.all():
        raise ValueError(f"Expected {what} without nulls: row {owner.before + int(np.argmin(valid)) // size} is null.")


def _numbers(owner: _Owner, schema: _Schema, array: _Array, first: int, count: int) -> NDArray[Any]:
    """Rows `first` to `first + count` of an array, as the numbers that they hold."""
    form = schema.format
    if schema.dictionary:
        raise ValueError("Expected an Arrow array of numbers, got one that is encoded by a dictionary: decode it first.")
    if form in _NUMBERS:
        _check_nulls(owner, array, "an Arrow array", first, count)
        return _memory(owner, array.buffers[1], _NUMBERS[form], array.offset + first, count)
    if form == b"+s":
        _check_nulls(owner, array, "an Arrow struct", first, count)
        first += array.offset
        fields = [
            _numbers(owner, schema.children[i].contents, array.children[i].contents, first, count)
            for i in range(schema.n_children)
        ]
        names = [(schema.children[i].contents.name or b"").decode() for i in range(schema.n_children)]
        return np.stack([fields[i] for i in order(names) or range(len(fields))], axis=-1)
    if form.startswith(b"+w:"):
        size = int(form[3:])
        _check_nulls(owner, array, "an Arrow list", first, count)
        begin = (array.offset + first) * size
    elif form in (b"+l", b"+L"):
        _check_nulls(owner, array, "an Arrow list", first, count)
        kind = np.dtype(f"int{32 if form == b'+l' else 64}")
        ends = _memory(owner, array.buffers[1], kind, array.offset + first, count + 1)
        sizes = np.diff(ends)
        size, begin = (int(sizes[0]), int(ends[0])) if count else (0, 0)
        if (sizes != size).any():
            row = int(np.argmax(sizes != size))
            raise ValueError(f"Expected lists of one length, got {size} numbers in row {owner.before} and {sizes[row]} in row {owner.before + row}.")
    else:
        raise TypeError(f"Expected an Arrow array of numbers of at most 64 bits, lists or structs of these, got format {form.decode()!r}.")
    child = array.children[0].contents
    _check_nulls(owner, child, "an Arrow list", begin, count * size, max(size, 1))
    inner = _numbers(owner, schema.children[0].contents, child, begin, count * size)
    return inner.reshape(count, size, *inner.shape[1:])


class _Form:
    """The schema of a producer, as long as it is read."""

    def __init__(self, schema: _Schema, capsule: object = None) -> None:
        # That of a capsule is released with it.
        self.schema, self.capsule = schema, capsule

    def __del__(self) -> None:
        if self.capsule is None and self.schema.release:
            self.schema.release(ctypes.addressof(self.schema))


def _read(value: Any) -> tuple[_Form, list[_Owner]]:
    """The schema of a column, and its chunks."""
    if hasattr(value, "__arrow_c_array__"):
        capsule, array = value.__arrow_c_array__()
        schema = cast(_pointer(capsule, b"arrow_schema"), POINTER(_Schema)).contents
        return _Form(schema, capsule), [_Owner(_moved(_pointer(array, b"arrow_array")))]
    capsule = value.__arrow_c_stream__()
    address = _pointer(capsule, b"arrow_array_stream")
    stream = cast(address, POINTER(_Stream)).contents

    def got(get: Callable[..., int], into: Structure) -> None:
        if get(address, ctypes.addressof(into)):
            raise ValueError(f"Arrow: {(stream.get_last_error(address) or b'').decode()}")

    chunks: list[_Owner] = []
    form = _Form(_Schema())
    got(stream.get_schema, form.schema)
    while True:
        array = _Array()
        got(stream.get_next, array)
        if not array.release:
            return form, chunks
        chunks.append(_Owner(array, sum(chunk.array.length for chunk in chunks)))


def _joined(chunks: list[NDArray[Any]], schema: _Schema, core: tuple[int, ...]) -> NDArray[Any]:
    """The rows of all chunks; of no rows, with elements of the shape `core` where the schema does not say another one."""
    # Lists of no rows do not say how long they are.
    full = [chunk for chunk in chunks if len(chunk)]
    if not full:
        shape, dtype = _element(schema)
        return np.empty((0, *((core or (0,)) if None in shape else shape)), dtype)  # type: ignore[arg-type]
    for chunk in full:
        if chunk.shape[1:] != full[0].shape[1:]:
            raise ValueError(f"Expected lists of one length, got {full[0].shape[1:]} and {chunk.shape[1:]} in different chunks.")
    return full[0] if len(full) == 1 else np.concatenate(full)


def _element(schema: _Schema) -> tuple[tuple[int | None, ...], np.dtype[Any]]:
    """The shape of a row, with None for a length that only rows would tell, and the dtype."""
    form = schema.format
    if form in _NUMBERS:
        return (), _NUMBERS[form]
    inner, dtype = _element(schema.children[0].contents) if schema.n_children else ((), np.dtype(np.float64))
    if form == b"+s":
        return (*inner, schema.n_children), dtype
    return (int(form[3:]) if form.startswith(b"+w:") else None, *inner), dtype


def rows(value: Any, core: tuple[int, ...]) -> NDArray[Any]:
    """Arrow's numbers as an array of rows, whose elements have the shape `core`."""
    form, owners = _read(value)
    chunks = [_numbers(owner, form.schema, owner.array, 0, owner.array.length) for owner in owners]
    return _joined(chunks, form.schema, core)


class _Columns:
    """The columns of a table, or fields of structs, by name."""

    def __init__(self, form: _Form, owners: list[_Owner]) -> None:
        self.form, self.owners = form, owners
        schema = form.schema
        self.names = [(schema.children[i].contents.name or b"").decode() for i in range(schema.n_children)]
        for owner in owners:
            _check_nulls(owner, owner.array, "an Arrow struct", 0, owner.array.length)

    def keys(self) -> list[str]:
        return self.names

    def __getitem__(self, name: str) -> NDArray[Any]:
        index = self.names.index(name)
        schema, chunks = self.form.schema.children[index].contents, []
        for owner in self.owners:
            array = owner.array.children[index].contents
            try:
                chunks.append(_numbers(owner, schema, array, owner.array.offset, owner.array.length))
            except (TypeError, ValueError) as error:
                raise type(error)(f"the column {name!r}: {error}") from None
        return _joined(chunks, schema, ())


def columns(value: Any) -> _Columns | None:
    """The columns of a table of Arrow, or the fields of a column of structs; None of any other column."""
    form, owners = _read(value)
    return _Columns(form, owners) if form.schema.format == b"+s" else None


def from_arrow(column: Any) -> NDArray[Any]:
    """Arrow's numbers as an array: ``row i`` of a column of lists of 8 is motion i, of shape (rows, 8).

    Parameters
    ----------
    column : object with ``__arrow_c_array__`` or ``__arrow_c_stream__``
        Of pyarrow, Polars, DuckDB, DataFusion, Daft …: numbers of at most 64 bits, lists of these of fixed or of equal
        length, or structs. Fields that are named px py pz pw qx qy qz qw, x y z w, x y z, tx ty tz or wx wy wz vx vy vz are
        put in that order, others are taken in their own; `Mechanism` puts those of its values in its order. ValueError names
        the first row that is null.

    Returns
    -------
    ndarray, read-only
        The same memory, if it is one chunk of numbers or lists; otherwise a copy. All functions take such columns as
        they are.

    Examples
    --------
    >>> import dq8
    >>> column = dq8.to_arrow(dq8.identity(3))
    >>> dq8.from_arrow(column).shape
    (3, 8)
    """
    if not hasattr(column, "__arrow_c_array__") and not hasattr(column, "__arrow_c_stream__"):
        raise TypeError(f"Expected `column` to have __arrow_c_array__ or __arrow_c_stream__, got {type(column).__name__}.")
    return rows(column, (8,))


# What consumers have not released yet, by the number in `private_data`; and structures of capsules, by address.
_LENT: dict[int, Any] = {}
_IN_CAPSULES: dict[int, Structure] = {}
_numbers_of_loans = itertools.count(1)


def _taken_back(kind: type[Structure]) -> Any:
    def release(address: int) -> None:
        it = cast(address, POINTER(kind)).contents
        for i in range(it.n_children):
            child = it.children[i].contents
            if child.release:
                child.release(ctypes.addressof(child))
        it.release = _Release()
        _LENT.pop(it.private_data, None)

    return _Release(release)


_RELEASES: dict[type[Structure], Any] = {kind: _taken_back(kind) for kind in (_Schema, _Array)}
_address_of = ctypes.PYFUNCTYPE(c_void_p, c_void_p, c_char_p)(("PyCapsule_GetPointer", ctypes.pythonapi))


def _destructor(kind: type[Structure], name: bytes) -> Any:
    def destroy(capsule: int) -> None:
        address = _address_of(capsule, name)
        if cast(address, POINTER(kind)).contents.release:
            _RELEASES[kind](address)
        _IN_CAPSULES.pop(address, None)

    return ctypes.PYFUNCTYPE(None, c_void_p)(destroy)


_DESTRUCTORS = {name: _destructor(kind, name) for kind, name in ((_Schema, b"arrow_schema"), (_Array, b"arrow_array"))}


def _lent(made: Structure, child: Structure | None, *kept: Any) -> Any:
    if child is not None:
        made.n_children, made.children = 1, (POINTER(type(child)) * 1)(ctypes.pointer(child))
    made.private_data = next(_numbers_of_loans)
    made.release = _RELEASES[type(made)]
    _LENT[made.private_data] = (child, made.children, kept)
    return made


def _capsule(made: Structure, name: bytes) -> Any:
    _IN_CAPSULES[ctypes.addressof(made)] = made
    return _new_capsule(ctypes.addressof(made), name, cast(_DESTRUCTORS[name], c_void_p))


class ArrowArray:
    """An array as libraries of Arrow take it; see `to_arrow`."""

    def __init__(self, array: NDArray[Any]) -> None:
        self._array = array

    def __len__(self) -> int:
        return len(self._array)

    def __arrow_c_array__(self, requested_schema: object = None) -> tuple[object, object]:
        array = self._array
        schema = _lent(_Schema(format=b"f" if array.itemsize == 4 else b"g", name=b"item", flags=_NULLABLE), None)
        buffers = (c_void_p * 2)(None, array.ctypes.data)
        made = _lent(_Array(length=array.size, n_buffers=2, buffers=buffers), None, array, buffers)
        for size in array.shape[:0:-1]:
            schema = _lent(_Schema(format=b"+w:%d" % size, name=b"item", flags=_NULLABLE), schema)
            buffers = (c_void_p * 1)(None)
            made = _lent(_Array(length=made.length // size, n_buffers=1, buffers=buffers), made, buffers)
        return _capsule(schema, b"arrow_schema"), _capsule(made, b"arrow_array")


def to_arrow(array: ArrayLike) -> ArrowArray:
    """An array, shape (rows, ..., 8) or any other, as Arrow's ``FixedSizeList<…, 8>``: ``row i`` is element i.

    What it returns has ``__arrow_c_array__``: ``pyarrow.array(it)``, ``polars.Series(it)`` and a column of a table take it
    without a copy of the numbers, which the caller must not change meanwhile.

    Examples
    --------
    >>> import dq8
    >>> len(dq8.to_arrow(dq8.identity(3)))
    3
    """
    numbers = _core.real_array("array", array)
    if not numbers.ndim or 0 in numbers.shape[1:]:
        raise ValueError(f"Expected `array` to have rows of numbers, got shape {numbers.shape}.")
    single = numbers.dtype.kind == "f" and numbers.itemsize <= 4
    return ArrowArray(np.ascontiguousarray(numbers, np.float32 if single else np.float64))
