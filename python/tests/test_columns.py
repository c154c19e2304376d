"""Values with names go to the joints of those names, whatever their order; other names are refused."""

from collections import namedtuple

import numpy as np
import pandas as pd
import pyarrow as pa
import pytest
from robots import ROBOTS, random_values

import dq8

ARM = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
NAMES = ARM.values
SHUFFLED = [NAMES[i] for i in (3, 0, 7, 6, 1, 5, 2, 4)]


@pytest.fixture
def values(rng):
    return random_values(ARM, rng, 20)


class Frame:
    """As a data frame of Polars: columns by name, no `keys`."""

    def __init__(self, columns):
        self._columns, self.columns = columns, list(columns)

    def __getitem__(self, name):
        return self._columns[name]

    def __array__(self, dtype=None, copy=None):
        return np.column_stack(list(self._columns.values()))


def record(columns):
    array = np.empty(len(next(iter(columns.values()))), [(name, "f8") for name in columns])
    for name, column in columns.items():
        array[name] = column
    return array


TABLES = {
    "dict": dict,
    "DataFrame": pd.DataFrame,
    "Table": pa.table,
    "RecordBatch": lambda columns: pa.table(columns).combine_chunks().to_batches()[0],
    "structured array": record,
    "record array": lambda columns: record(columns).view(np.recarray),
    "frame": Frame,
}


def named(values, names):
    return {name: values[..., NAMES.index(name)] for name in names}


@pytest.mark.parametrize("names", [NAMES, SHUFFLED], ids=["in order", "shuffled"])
@pytest.mark.parametrize("kind", TABLES)
def test_columns_go_to_the_joints_of_their_names(kind, names, values):
    table = TABLES[kind](named(values, names))
    np.testing.assert_array_equal(ARM.poses(table), ARM.poses(values))
    np.testing.assert_array_equal(ARM.jacobian(table, "hand"), ARM.jacobian(values, "hand"))
    targets = ARM.poses(values, "hand")
    expected = ARM.reach(targets, values + 0.05, "hand", posture=values[0])[0]
    start = TABLES[kind](named(values + 0.05, names))
    posture = dict(zip(names, named(values[0], names).values()))
    np.testing.assert_array_equal(ARM.reach(targets, start, "hand", posture=posture)[0], expected)


@pytest.mark.parametrize("names", [NAMES, SHUFFLED], ids=["in order", "shuffled"])
def test_one_row_of_a_table_goes_to_the_joints_of_its_names(names, values):
    table = pd.DataFrame(named(values, names))
    expected = ARM.poses(values[3], "hand")
    tuples = namedtuple("Row", [f"axis{i}" for i in range(8)])
    same = [table.iloc[3], record(named(values, names))[3], table.to_dict("records")[3]]
    for row in same:
        np.testing.assert_array_equal(ARM.poses(row, "hand"), expected)
    if all(name.isidentifier() for name in NAMES):
        for row in table.iloc[3:4].itertuples(index=False):
            np.testing.assert_array_equal(ARM.poses(row, "hand"), expected)
    lists = [[table.iloc[i] for i in range(4)], list(record(named(values, names))[:4]), table.to_dict("records")[:4]]
    for rows in lists:
        np.testing.assert_array_equal(ARM.poses(rows, "hand"), ARM.poses(values[:4], "hand"))
    with pytest.raises(ValueError, match="`values`: the column 'axis0' is not a value of this mechanism"):
        ARM.poses(tuples(*values[3]), "hand")


@pytest.mark.parametrize("kind", TABLES)
def test_unknown_and_missing_names_are_refused(kind, values):
    make = TABLES[kind]
    unknown = make({**named(values, NAMES), "time": values[:, 0]})
    with pytest.raises(ValueError, match=f"`values`: the column 'time' is not a value of this mechanism; the values are {NAMES[0]}, "):
        ARM.poses(unknown)
    missing = make(named(values, SHUFFLED[1:]))
    with pytest.raises(ValueError, match=f'`values`: there is no column "{SHUFFLED[0]}"; the values are'):
        ARM.jacobian(missing, "hand")
    other = make({name.upper() + "_": column for name, column in named(values, NAMES).items()})
    with pytest.raises(ValueError, match="`values`: the column '.*_' is not a value"):
        ARM.reach(dq8.identity(), other, "hand")
    with pytest.raises(ValueError, match="`posture`: the column '.*_' is not a value"):
        ARM.reach(dq8.identity(), values, "hand", posture=other)


def test_columns_that_are_there_twice_are_refused(values):
    table = pd.DataFrame(values, columns=[NAMES[0], *NAMES[:-1]])
    with pytest.raises(ValueError, match=f"the column '{NAMES[0]}' is there twice"):
        ARM.poses(table)


def test_columns_that_are_numbered_are_positions_if_in_order(values):
    table = pd.DataFrame(values)
    np.testing.assert_array_equal(ARM.poses(table), ARM.poses(values))
    np.testing.assert_array_equal(ARM.poses(table.iloc[2]), ARM.poses(values[2]))
    with pytest.raises(ValueError, match="the column 1 is no name of a value"):
        ARM.poses(table[[1, 0, 2, 3, 4, 5, 6, 7]])


def test_single_numbers_are_the_same_in_all_rows_and_keep_the_precision(values):
    single = {name: column.astype(np.float32) for name, column in named(values, SHUFFLED).items()}
    assert ARM.poses(single).dtype == np.float32
    single[NAMES[2]] = 0.25
    result = ARM.poses(single)
    values[:, 2] = 0.25
    assert result.dtype == np.float32
    np.testing.assert_array_equal(result, ARM.poses(values.astype(np.float32)))


def test_columns_that_do_not_fit_or_are_no_numbers_are_named(values):
    columns = named(values, SHUFFLED)
    with pytest.raises(ValueError, match="`values`: the columns do not fit each other"):
        ARM.poses({**columns, NAMES[1]: values[:3, 1]})
    with pytest.raises(TypeError, match=rf'Expected `values\["{NAMES[1]}"\]` to hold real numbers.*got None'):
        ARM.poses({**columns, NAMES[1]: None})
    with pytest.raises(TypeError, match=rf'Expected `values\["{NAMES[1]}"\]` to have no mask'):
        ARM.poses({**columns, NAMES[1]: np.ma.masked_array(values[:, 1])})


@pytest.mark.parametrize("count", [0, 1, 383, 384, 385, 769])
def test_columns_of_any_length_and_any_stride_are_read_where_they_lie(count, rng):
    values = random_values(ARM, rng, count)
    columns = {name: values[:, NAMES.index(name)].copy() for name in SHUFFLED}
    columns[NAMES[1]] = values[:, 1]
    columns[NAMES[4]] = values[:, 4].astype(">f8")
    np.testing.assert_array_equal(ARM.poses(columns, "hand"), ARM.poses(values, "hand"))
    np.testing.assert_array_equal(ARM.jacobian(columns, "hand"), ARM.jacobian(values, "hand"))
    for name, column in columns.items():
        np.testing.assert_array_equal(column, values[:, NAMES.index(name)])


def test_columns_broadcast_and_out_may_be_a_column(values):
    grid = {name: 0.1 for name in NAMES}
    grid[NAMES[0]], grid[NAMES[3]] = np.linspace(-1, 1, 4)[:, np.newaxis], np.linspace(-1, 1, 5)
    rows = np.full((4, 5, len(NAMES)), 0.1)
    rows[..., 0], rows[..., 3] = grid[NAMES[0]], grid[NAMES[3]]
    np.testing.assert_array_equal(ARM.poses(grid), ARM.poses(rows))
    memory = np.empty((20, 8))
    columns = named(values, NAMES)
    memory[:, 2] = columns[NAMES[2]]
    expected = ARM.poses(values, "hand")
    ARM.poses({**columns, NAMES[2]: memory[:, 2]}, "hand", out=memory)
    np.testing.assert_array_equal(memory, expected)


def test_a_mechanism_of_one_value_takes_its_column(rng):
    wheel = dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.identity())
    angles = rng.random(5000)
    np.testing.assert_array_equal(wheel.poses({"0": angles}), wheel.poses(angles[:, np.newaxis]))
    np.testing.assert_array_equal(wheel.poses({"0": 0.5}), wheel.poses([0.5]))
