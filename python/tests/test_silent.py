"""Calls that were once taken for something else without a word: right now, or refused in words that name the cure."""

import dask.dataframe
import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
from robots import ROBOTS, random_values

import dq8
import dq8.dask

ARM = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
NAMES = ARM.values
SHUFFLED = [NAMES[i] for i in (3, 0, 7, 6, 1, 5, 2, 4)]
MOTION = "px py pz pw qx qy qz qw".split()
BACKWARDS = MOTION[::-1]


@pytest.fixture
def values(rng):
    return random_values(ARM, rng, 20)


@pytest.fixture
def frame(values):
    return pd.DataFrame(values, columns=NAMES)[SHUFFLED]


def in_one_column(frame):
    """The rows of a frame as structs, as engines make them."""
    given = pa.Table.from_pandas(frame, preserve_index=False)
    structs = given.to_struct_array().combine_chunks()
    own = pl.from_arrow(given)
    packed = ", ".join(f'"{name}" := "{name}"' for name in frame.columns)
    return {
        "pyarrow": structs,
        "chunks": pa.chunked_array([structs[:7], structs[7:7], structs[7:]]),
        "a slice": pa.concat_arrays([structs[:3], structs]).slice(3),
        "polars": own.select(pl.struct(pl.all()).alias("q"))["q"],
        "duckdb": duckdb.sql(f"select struct_pack({packed}) as q from given").to_arrow_table()["q"],
    }


@pytest.mark.parametrize("kind", ["pyarrow", "chunks", "a slice", "polars", "duckdb"])
def test_fields_of_structs_go_to_the_joints_of_their_names(kind, frame, values):
    column = in_one_column(frame)[kind]
    np.testing.assert_array_equal(ARM.poses(column, "hand"), ARM.poses(values, "hand"))
    np.testing.assert_array_equal(ARM.jacobian(column, "hand"), ARM.jacobian(values, "hand"))
    targets = ARM.poses(values + 0.01, "hand")
    np.testing.assert_array_equal(ARM.reach(targets, column, "hand")[0], ARM.reach(targets, values, "hand")[0])


def test_functions_of_several_columns_in_polars_take_them_by_name(frame, values):
    turned = pl.from_pandas(frame).select(
        pl.struct(pl.all()).map_batches(
            lambda column: pl.Series(dq8.to_arrow(ARM.poses(column, "hand"))), return_dtype=pl.Array(pl.Float64, 8)
        )
    )
    np.testing.assert_array_equal(turned.to_series().to_numpy(), ARM.poses(values, "hand"))


def test_unknown_and_missing_fields_of_structs_are_refused(frame):
    other = pa.Table.from_pandas(frame.rename(columns={NAMES[2]: "time"})).to_struct_array()
    with pytest.raises(ValueError, match="`values`: the column 'time' is not a value of this mechanism; the values are"):
        ARM.poses(other, "hand")
    missing = pa.Table.from_pandas(frame.drop(columns=NAMES[2])).to_struct_array()
    with pytest.raises(ValueError, match=f'`values`: there is no column "{NAMES[2]}"'):
        ARM.poses(missing, "hand")
    # A column that is not asked for need not hold numbers to be named.
    text = pa.table({**dict(zip(NAMES, np.zeros((8, 3)))), "name": ["a", "b", "c"]})
    with pytest.raises(ValueError, match="the column 'name' is not a value"):
        ARM.poses(text, "hand")


def test_frames_of_dask_are_taken_by_name(frame, values):
    lazy = dask.dataframe.from_pandas(frame, npartitions=3)
    np.testing.assert_array_equal(dq8.dask.poses(ARM, lazy, "hand").compute(), ARM.poses(values, "hand"))
    np.testing.assert_array_equal(dq8.dask.jacobian(ARM, lazy, "hand").compute(), ARM.jacobian(values, "hand"))
    numbered = dask.dataframe.from_pandas(pd.DataFrame(values), npartitions=3)
    np.testing.assert_array_equal(dq8.dask.poses(ARM, numbered, "hand").compute(), ARM.poses(values, "hand"))
    with pytest.raises(ValueError, match="`values`: the column 'time' is not a value of this mechanism"):
        dq8.dask.poses(ARM, lazy.rename(columns={NAMES[2]: "time"}), "hand")
    with pytest.raises(ValueError, match=f'`values`: there is no column "{NAMES[2]}"'):
        dq8.dask.poses(ARM, lazy[[name for name in SHUFFLED if name != NAMES[2]]], "hand")


def test_rates_are_taken_by_name_and_their_number_is_checked(values, rng):
    rates = rng.normal(size=(20, len(ARM.rates)))
    named = pd.DataFrame(rates, columns=ARM.rates)[SHUFFLED]
    expected = ARM.velocity(values, rates, "hand")
    for given in (named, pl.from_pandas(named), in_one_column(named)["polars"], dict(named)):
        np.testing.assert_array_equal(ARM.velocity(values, given, "hand"), expected)
    with pytest.raises(ValueError, match="`rates`: the column 'time' is not a rate of this mechanism; the rates are"):
        ARM.velocity(values, named.rename(columns={NAMES[0]: "time"}), "hand")
    with pytest.raises(ValueError, match=r"Expected `rates` to have shape \(\.\.\., 8\), got \(20, 5\)"):
        ARM.velocity(values, rates[:, :5], "hand")


@pytest.mark.parametrize("names", [MOTION, BACKWARDS, "pw px py pz qw qx qy qz".split()])
def test_columns_of_motions_are_taken_by_name(names, random_motions):
    motions = random_motions(9)
    frame = pd.DataFrame(motions, columns=MOTION)[names]
    table = pa.Table.from_pandas(frame)
    same = [frame, table, pl.from_pandas(frame), table.to_struct_array(), in_one_column(frame)["polars"]]
    for given in same:
        np.testing.assert_array_equal(dq8.inverse(given), dq8.inverse(motions))
    np.testing.assert_array_equal(dq8.inverse(frame.iloc[2]), dq8.inverse(motions[2]))
    lazy = dask.dataframe.from_pandas(frame, npartitions=2)
    np.testing.assert_array_equal(dq8.dask.inverse(lazy).compute(), dq8.inverse(motions))


def test_columns_of_quaternions_and_points_are_taken_by_name(random_motions, rng):
    turns, points = random_motions(9)[:, :4], rng.normal(size=(9, 3))
    first = pd.DataFrame(turns, columns=["qx", "qy", "qz", "qw"])[["qw", "qx", "qy", "qz"]]
    np.testing.assert_array_equal(dq8.from_rotation(first), dq8.from_rotation(turns))
    back = pl.DataFrame(points, schema=["x", "y", "z"]).select("z", "y", "x")
    np.testing.assert_array_equal(dq8.from_translation(back), dq8.from_translation(points))
    np.testing.assert_array_equal(dq8.fit(back.to_pandas(), points), dq8.fit(points, points))
    # Of names that nobody knows, it is the order that counts.
    np.testing.assert_array_equal(dq8.from_translation(pd.DataFrame(points, columns=list("cba"))), dq8.from_translation(points))


def test_labels_of_a_series_of_scalars_do_not_order_it(random_motions):
    a, b, t = random_motions(3), random_motions(3), [0.0, 0.25, 1.0]
    np.testing.assert_array_equal(dq8.nlerp(a, b, pd.Series(t, index=list("zyx"))), dq8.nlerp(a, b, t))


def test_what_a_dictionary_encodes_is_not_read_as_its_indices(random_motions):
    times = pa.array([1.0, 0.0, 1.0]).dictionary_encode()
    with pytest.raises(ValueError, match="encoded by a dictionary: decode it first"):
        dq8.nlerp(random_motions(3), random_motions(3), times)


def test_rows_of_chunks_are_counted_over_the_whole_column():
    column = pa.chunked_array([pa.array([0.0, 0.5, 1.0]), pa.array([0.0, None, 1.0])])
    with pytest.raises(ValueError, match="row 4 is null"):
        dq8.nlerp(dq8.identity((6,)), dq8.identity((6,)), column)


def null_inside(rows):
    numbers = rows.reshape(-1).tolist()
    numbers[4 * rows.shape[1] + 2] = None
    return numbers


def with_null(rows, kind):
    """Rows of which number 4 is null, or has a null in it."""
    size = rows.shape[1]
    lists = [None if i == 4 else row for i, row in enumerate(rows.tolist())]
    inside = np.array(null_inside(rows), object).reshape(-1, size)
    names = [f"c{i}" for i in range(size)] if size != len(NAMES) else NAMES
    columns = {name: [value for value in column] for name, column in zip(names, inside.T)}
    made = {
        "a polars array": lambda: pl.Series(lists, dtype=pl.Array(pl.Float64, size)),
        "in a polars array": lambda: pl.Series(inside.tolist(), dtype=pl.Array(pl.Float64, size)),
        "a polars list": lambda: pl.Series(lists, dtype=pl.List(pl.Float64)),
        "a polars frame": lambda: pl.DataFrame(columns),
        "a table": lambda: pa.table(columns),
        "a fixed list": lambda: pa.array(lists, pa.list_(pa.float64(), size)),
        "a struct": lambda: pa.table(columns).to_struct_array(),
        "integers": lambda: pl.DataFrame({name: [None if v is None else int(v) for v in c] for name, c in columns.items()}),
    }
    return made[kind]()


NULLS = ["a polars array", "in a polars array", "a polars list", "a polars frame", "a table", "a fixed list", "a struct", "integers"]


@pytest.mark.parametrize("kind", NULLS)
def test_nulls_are_refused_by_row_on_every_way_in(kind, values, random_motions):
    with pytest.raises(ValueError, match="row 4 is null"):
        dq8.inverse(with_null(random_motions(9), kind))
    with pytest.raises(ValueError, match="row 4 is null"):
        ARM.poses(with_null(values, kind), "hand")


def test_nulls_among_single_numbers_are_refused_by_row(random_motions):
    t = pl.Series([0.0, 0.5, None])
    with pytest.raises(ValueError, match="`t`: .*row 2 is null"):
        dq8.pow(random_motions(3), t)


def test_empty_chunks_and_columns_of_no_rows_are_taken(random_motions, values):
    lists = pa.array(random_motions(5).tolist(), pa.list_(pa.float64()))
    chunks = pa.chunked_array([lists[:2], lists[:0], lists[2:], lists[:0]])
    np.testing.assert_array_equal(dq8.inverse(chunks), dq8.inverse(lists))
    for nothing in (lists[:0], pa.chunked_array([], lists.type), pa.array([], pa.list_(pa.float32(), 8)), pl.Series([], dtype=pl.List(pl.Float64))):
        assert dq8.inverse(nothing).shape == (0, 8)
        assert dq8.from_arrow(nothing).shape == (0, 8)
    assert dq8.inverse(pa.array([], pa.list_(pa.float32()))).dtype == np.float32
    assert dq8.from_twist(lists[:0]).shape == (0, 8)
    assert ARM.poses(lists[:0], "hand").shape == (0, 8)
    assert ARM.poses(pa.table(dict(zip(NAMES, values.T)))[:0], "hand").shape == (0, 8)


@pytest.mark.parametrize("dtype", ["float16", "int8", "uint8", "int32", "int64"])
def test_lists_of_all_numbers_are_taken(dtype):
    rows = np.array([[0, 0, 0, 1, 1, 2, 3, 0]] * 3).astype(dtype)
    column = pa.FixedSizeListArray.from_arrays(pa.array(rows.reshape(-1)), 8)
    np.testing.assert_array_equal(dq8.inverse(column), dq8.inverse(rows))
    assert dq8.inverse(column).dtype == dq8.inverse(rows).dtype


def test_logarithms_and_twists_cannot_be_taken_for_each_other(random_motions):
    motions = random_motions(5)
    with pytest.raises(ValueError, match=r"`logs` to have shape \(\.\.\., 8\), got \(5, 6\): .*twists.*`dq8\.from_twist`"):
        dq8.exp(dq8.to_twist(motions))
    with pytest.raises(ValueError, match=r"`twists` to have shape \(\.\.\., 6\), got \(5, 8\): of motions pass `dq8\.to_twist\(twists\)`"):
        dq8.from_twist(dq8.log(motions))
    # Motions are no logarithms.
    assert np.isnan(dq8.exp(motions)).all()
    assert dq8.allclose(dq8.exp(dq8.log(motions)), motions) and dq8.allclose(dq8.from_twist(dq8.to_twist(motions)), motions)


def test_the_default_of_jacobians_is_how_the_point_of_the_link_moves(values, rng):
    rates = rng.normal(size=values.shape)
    step = 1e-6
    ahead, behind = (dq8.translation(ARM.poses(values + s * rates, "hand")) for s in (step, -step))
    velocity = (ahead - behind) / (2 * step)
    jacobian = ARM.jacobian(values, "hand")
    np.testing.assert_allclose((jacobian @ rates[..., np.newaxis])[:, 3:, 0], velocity, rtol=0, atol=1e-8)
    np.testing.assert_allclose(ARM.velocity(values, rates, "hand")[:, 3:], velocity, rtol=0, atol=1e-8)
    np.testing.assert_array_equal(jacobian, ARM.jacobian(values, "hand", "aligned"))
    found = ARM.rates_for(values, ARM.velocity(values, rates, "hand"), "hand")
    np.testing.assert_allclose(ARM.velocity(values, found, "hand"), ARM.velocity(values, rates, "hand"), rtol=0, atol=1e-9)
    lazy = dq8.dask.jacobian(ARM, dask.array.from_array(values), "hand")
    np.testing.assert_array_equal(lazy.compute(), jacobian)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_rotations_that_are_not_unit_are_refused(dtype, random_motions):
    turns = random_motions(3, 700)[..., :4].astype(dtype)
    for wrong, length in (([0, 0, 0, 2], "2"), ([0, 0, 0, 0], "0"), ([0, 0, 0, np.inf], "inf")):
        turns[1, 333] = wrong
        for call in (dq8.from_rotation, lambda r: dq8.from_rotation_translation(r, [1.0, 2, 3])):
            with pytest.raises(ValueError, match=rf"`rotations` \(1, 333\): the length of .* is {length}, which must be 1: divide by it"):
                call(turns)
            with pytest.raises(ValueError, match="`rotations`: the length"):
                call(wrong)
    turns[1, 333] = [0, 0, 0, 2]
    assert dq8.from_rotation(turns, check=False)[1, 333, 3] == 2
    assert dq8.from_rotation_translation(turns, np.zeros(3, dtype), check=False).dtype == dtype
    # Typed with four digits is near enough, and NaN stays in its row.
    assert dq8.from_rotation([0, 0, 0.7071, 0.7071]).shape == (8,)
    turns[1, 333] = np.nan
    made = dq8.from_rotation(turns)
    assert np.isnan(made[1, 333]).any() and not np.isnan(np.delete(made.reshape(-1, 8), 1033, axis=0)).any()


def test_axes_that_are_not_unit_are_refused():
    with pytest.raises(ValueError, match=r"`screws`: the length of the direction \[0\.0, 0\.0, 2\.0\] is 2, which must be 1"):
        dq8.from_screw([0, 0, 2, 0, 0, 0, 0.5, 2.0])
    with pytest.raises(ValueError, match=r"`screws` \(1,\): the moment of the axis is not at right angles to its direction"):
        dq8.from_screw([[0, 0, 1, 0, 0, 0, 0.5, 2.0], [0, 0, 1, 0, 0, 1, 0.5, 2.0]])
    assert dq8.from_screw([0, 0, 2, 0, 0, 0, 0.5, 2.0], check=False).shape == (8,)


def test_links_in_a_set_have_no_order_and_a_bool_is_no_link(values):
    for links in ({"hand", "tool"}, frozenset({1, 2})):
        with pytest.raises(TypeError, match="got a set, which has no order: pass a list"):
            ARM.poses(values, links)
    for call in (lambda: ARM.poses(values, True), lambda: ARM.jacobian(values, True), lambda: ARM.poses(values, [True, False])):
        with pytest.raises(TypeError, match="names? .*links? or their numbers, got <class 'bool'>"):
            call()


OTHERS = [
    ((5, 6), "of twists pass `dq8.from_twist(motions)`"),
    ((5, 4, 4), "of matrices pass `dq8.from_matrix(motions)`"),
    ((5, 3, 4), "of matrices pass `dq8.from_matrix(motions)`"),
    ((5, 4), "of quaternions pass `dq8.from_rotation(motions)`"),
    ((5, 3), "of translations pass `dq8.from_translation(motions)`"),
    ((5, 7), "pass `dq8.from_rotation_translation(rotations, translations)`"),
    ((8, 5), "of motions in columns pass `motions.T`"),
]


@pytest.mark.parametrize("shape, cure", OTHERS)
def test_what_is_no_motion_is_refused_with_what_makes_one_of_it(shape, cure):
    with pytest.raises(ValueError) as error:
        dq8.inverse(np.zeros(shape))
    assert cure in str(error.value)


def test_points_that_do_not_say_how_they_turned_are_refused(rng):
    line = rng.normal(size=(10, 1)) * [1.0, 2, 3]
    for points in (line, line[:2]):
        with pytest.raises(ValueError, match="many rotations fit equally well"):
            dq8.fit(points, points)


def test_what_is_not_finite_stays_in_its_row_of_solutions(rng):
    offsets = [[0, 0, 0.1], [0, 0.1, 0], [0.4, 0, 0], [0.4, 0, 0], [0, 0.1, 0], [0, 0, -0.1]]
    axes = np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 0, -1], [0, 1, 0]])
    arm = dq8.Mechanism(range(-1, 5), "revolute", axes, dq8.from_translation(offsets))
    start = rng.uniform(-1, 1, size=(700, 6))
    targets = arm.poses(start, 5)
    expected = arm.solutions(targets, start)
    wrong, begun = targets.copy(), start.copy()
    wrong[7, 3], begun[400, 1] = np.nan, np.inf
    found = arm.solutions(wrong, begun)
    rest = ~np.isin(np.arange(700), [7, 400])
    for part, own in zip(found, expected):
        np.testing.assert_array_equal(part[rest], own[rest])
    assert (found.counts[~rest] == 0).all() and not found.complete[~rest].any() and np.isnan(found.values[~rest]).all()
    wrong[3] *= 2
    with pytest.raises(ValueError, match="3"):
        arm.solutions(wrong, start)


def test_a_matrix_with_nan_stays_in_its_row(random_motions):
    matrices = dq8.to_matrix(random_motions(20))
    expected = dq8.from_matrix(matrices)
    for at in ((0, 1), (1, 3), (3, 2)):
        wrong = matrices.copy()
        wrong[(5, *at)] = np.nan
        made = dq8.from_matrix(wrong)
        assert np.isnan(made[5]).all()
        np.testing.assert_array_equal(np.delete(made, 5, axis=0), np.delete(expected, 5, axis=0))


def test_a_dict_of_joints_is_refused_with_words_that_fit():
    with pytest.raises(TypeError, match=r"got builtins\.dict|got dict"):
        dq8.Hierarchy([-1]).local_to_model({"root": dq8.identity()})
