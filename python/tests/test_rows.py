"""What is wrong with one row stays in it: NaN in its result, and a null in an error that names it. For all public calls."""

import numpy as np
import polars as pl
import pyarrow as pa
import pytest
from calls import CALLS, COUNT, MOTIONS, NEIGHBOURS, ROTATIONS, SCREWS, VECTORS

import dq8

ROW = 7
ANGLES = VECTORS
POINTS = lambda rng: rng.normal(size=(COUNT, 6, 3))
PAIRS = lambda rng: dq8.random((COUNT, 6), rng=rng)


def fit(points, moved):
    return dq8.fit(points, moved, full=True).motions


# Those of `calls`, and what has no `out`.
ALL = {
    **CALLS,
    "from_rotation": (dq8.from_rotation, [ROTATIONS]),
    "from_rotation_translation": (dq8.from_rotation_translation, [ROTATIONS, VECTORS]),
    "from_screw": (dq8.from_screw, [SCREWS]),
    "from_rotation_vector": (dq8.from_rotation_vector, [VECTORS]),
    "from_axis_angle": (dq8.from_axis_angle, [VECTORS, lambda rng: rng.random(COUNT)]),
    "from_euler": (lambda angles: dq8.from_euler("xyz", angles), [ANGLES]),
    "to_euler": (lambda motions: dq8.to_euler(motions, "ZYX"), [MOTIONS]),
    "to_axis_angle": (lambda motions: dq8.to_axis_angle(motions)[1], [MOTIONS]),
    "to_rotation_vector": (dq8.to_rotation_vector, [MOTIONS]),
    "to_rotation_translation": (lambda motions: np.concatenate(dq8.to_rotation_translation(motions), axis=-1), [MOTIONS]),
    "rotation": (dq8.rotation, [MOTIONS]),
    "from_wxyz": (dq8.from_wxyz, [MOTIONS]),
    "to_wxyz": (dq8.to_wxyz, [MOTIONS]),
    "is_unit": (lambda motions: np.where(dq8.is_unit(motions), 1.0, np.nan), [MOTIONS]),
    "fit": (fit, [POINTS, POINTS]),
    "hand_eye": (lambda hands: dq8.hand_eye(hands, hands), [PAIRS]),
    "Mechanism.solutions": (lambda values: SIX.solutions(SIX.poses(values, 5), values).values[:, 0], [lambda rng: rng.uniform(-1, 1, (COUNT, 6))]),
    "Trajectory.sample": (
        lambda poses: dq8.Trajectory(np.arange(float(COUNT)), poses).sample(np.arange(COUNT) + 0.0), [NEIGHBOURS]
    ),
}
OFFSETS = [[0, 0, 0.1], [0, 0.1, 0], [0.4, 0, 0], [0.4, 0, 0], [0, 0.1, 0], [0, 0, -0.1]]
AXES = np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 0, -1], [0, 1, 0]])
SIX = dq8.Mechanism(range(-1, 5), "revolute", AXES, dq8.from_translation(OFFSETS))

# Results of other rows that a row is in: means of windows, products that go on, ways between poses.
REACHES = {"chain_products": range(ROW, COUNT), "dib_windows": range(ROW - 2, ROW + 1), "Trajectory.sample": [ROW - 1, ROW]}
# Arguments that are no rows (the weights of a window, stamps and times, the joints of a mesh), and which are refused.
NO_ROWS = {("dib_windows", 1), ("resample", 0), ("resample", 2), ("skin", 1), ("skin", 2)}
# What they return is the start then, and their reports say so.
ANSWERS = ["Mechanism.reach", "Mechanism.track", "Mechanism.sequence"]


def cases():
    for name, (_, makers) in ALL.items():
        for index in range(len(makers)):
            if (name, index) not in NO_ROWS:
                yield name, index


def given(name):
    rng = np.random.default_rng(1)
    return ALL[name][0], [make(rng) for make in ALL[name][1]]


@pytest.mark.parametrize("name, index", cases())
def test_nan_stays_in_its_row(name, index):
    function, arguments = given(name)
    expected = np.asarray(function(*arguments))
    arguments[index] = arguments[index].copy()
    arguments[index][ROW] = np.nan
    found = np.asarray(function(*arguments))
    rows = REACHES.get(name, [ROW])
    if name == "resample":
        at = np.searchsorted(arguments[0], arguments[2], side="right") - 1
        rows = np.flatnonzero(np.isin(at, [ROW - 1, ROW]))
    for row in rows:
        assert name in ANSWERS or np.isnan(found[row]).any(), row
    np.testing.assert_array_equal(np.delete(found, rows, axis=0), np.delete(expected, rows, axis=0))


def with_null(array):
    """Lists of fixed length, of which one is null."""
    kind = pa.float64()
    for size in array.shape[:0:-1]:
        kind = pa.list_(kind, size)
    rows = array.tolist()
    rows[ROW] = None
    return pa.array(rows, kind)


# Tests of these compute with their arguments before they call.
COMPUTES = ["Mechanism.reach", "Mechanism.solutions", "is_unit"]


@pytest.mark.parametrize("library", ["pyarrow", "polars"])
@pytest.mark.parametrize("name, index", [case for case in cases() if case[0] not in COMPUTES])
def test_nulls_are_refused_by_row(name, index, library):
    function, arguments = given(name)
    column = with_null(arguments[index])
    arguments[index] = column if library == "pyarrow" else pl.Series(column)
    with pytest.raises(ValueError, match=f"row {ROW} is null"):
        function(*arguments)
