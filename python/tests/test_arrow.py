"""Arrow's columns in and out, without importing a library of Arrow."""

import gc
import subprocess
import sys

import numpy as np
import pyarrow as pa
import pytest

import dq8
from dq8 import _arrow


@pytest.fixture
def rows(random_motions):
    return random_motions(6)


def fixed(rows, **options):
    return pa.FixedSizeListArray.from_arrays(pa.array(rows.reshape(-1)), rows.shape[-1], **options)


def struct(rows):
    return pa.StructArray.from_arrays([pa.array(column.copy()) for column in rows.T], list("abcdefgh"))


COLUMNS = {
    "fixed lists": fixed,
    "lists": lambda rows: pa.array(rows.tolist()),
    "large lists": lambda rows: pa.array(rows.tolist(), pa.large_list(pa.float64())),
    "a struct": struct,
    "chunks": lambda rows: pa.chunked_array([fixed(rows[:2]), fixed(rows[2:])]),
    "a slice": lambda rows: fixed(np.concatenate([rows[:3], rows])).slice(3),
    "a slice of lists": lambda rows: pa.array(np.concatenate([rows[:3], rows]).tolist()).slice(3),
    "a slice of a struct": lambda rows: struct(np.concatenate([rows[:3], rows])).slice(3),
    "valid lists": lambda rows: fixed(rows, mask=pa.array(np.zeros(len(rows), bool))),
}


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("kind", COLUMNS)
def test_columns_are_taken_row_by_row(kind, dtype, rows):
    rows = rows if "lists" in kind and "fixed" not in kind and "valid" not in kind else rows.astype(dtype)
    column = COLUMNS[kind](rows)
    np.testing.assert_array_equal(dq8.from_arrow(column), rows)
    assert dq8.from_arrow(column).dtype == rows.dtype
    if kind != "a slice of a struct" and "struct" not in kind:
        np.testing.assert_array_equal(dq8.inverse(column), dq8.inverse(rows))


def test_fixed_lists_are_not_copied_and_live_as_long_as_the_array(rows):
    column = fixed(rows)
    array = dq8.from_arrow(column)
    assert array.ctypes.data == column.flatten().buffers()[1].address
    assert not array.flags.writeable
    del column
    gc.collect()
    np.testing.assert_array_equal(array, rows)


def test_nulls_are_refused_by_row(rows):
    with pytest.raises(ValueError, match="list without nulls: row 4 is null"):
        dq8.from_arrow(fixed(rows, mask=pa.array([False] * 4 + [True, False])))
    with pytest.raises(ValueError, match="list without nulls: row 2 is null"):
        dq8.from_arrow(fixed(rows, mask=pa.array([False] * 4 + [True, False])).slice(2))
    inner = pa.FixedSizeListArray.from_arrays(pa.array([*rows.reshape(-1)[:-1], None]), 8)
    with pytest.raises(ValueError, match="without nulls: row 5 is null"):
        dq8.from_arrow(inner)
    with pytest.raises(ValueError, match="row 1 is null"):
        dq8.from_arrow(pa.array([[1.0], None, [2.0]]))


def test_what_holds_no_numbers_is_refused(rows):
    with pytest.raises(ValueError, match="one length, got 2 numbers in row 0 and 1 in row 1"):
        dq8.from_arrow(pa.array([[1.0, 2.0], [3.0]]))
    with pytest.raises(TypeError, match="got format 'u'"):
        dq8.from_arrow(pa.array(["a"]))
    with pytest.raises(TypeError, match="__arrow_c_array__ or __arrow_c_stream__, got list"):
        dq8.from_arrow([1.0])
    with pytest.raises(ValueError, match="rows of numbers"):
        dq8.to_arrow(1.0)


@pytest.mark.parametrize("shape", [(5, 8), (3, 4, 8), (6,)])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_arrays_become_fixed_lists_without_a_copy(shape, dtype, rng):
    array = rng.normal(size=shape).astype(dtype)
    gc.collect()
    lent = len(_arrow._LENT)
    column = pa.array(dq8.to_arrow(array))
    kind = pa.from_numpy_dtype(dtype)
    for size in shape[:0:-1]:
        kind = pa.list_(kind, size)
    assert column.type.equals(kind)
    numbers = column
    while pa.types.is_fixed_size_list(numbers.type):
        numbers = numbers.flatten()
    assert numbers.buffers()[1].address == array.ctypes.data
    np.testing.assert_array_equal(dq8.from_arrow(column), array)
    expected = array.copy()
    del array
    gc.collect()
    np.testing.assert_array_equal(np.array(column.to_pylist()), expected)
    del column, numbers
    gc.collect()
    assert len(_arrow._LENT) == lent and not _arrow._IN_CAPSULES


def test_what_nobody_took_is_given_back(rows):
    gc.collect()
    lent = len(_arrow._LENT)
    dq8.to_arrow(rows).__arrow_c_array__()
    gc.collect()
    assert len(_arrow._LENT) == lent and not _arrow._IN_CAPSULES


def test_no_library_of_arrow_is_imported():
    code = "import sys, dq8; dq8.from_arrow(dq8.to_arrow(dq8.identity(3))); assert 'pyarrow' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
