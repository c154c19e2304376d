"""What is given as an array and is none, or more than one: refused in words that help, or taken for what it says."""

import dask.array as da
import numpy as np
import pandas as pd
import pyarrow as pa
import pytest
from calls import CALLS, arguments_of
from scipy.spatial.transform import RigidTransform as Theirs
from scipy.spatial.transform import Rotation

import dq8
from dq8 import RigidTransform

A = np.tile(dq8.identity(), (5, 1))


def given(name: str, make):
    """Each call with one argument after the other made something else."""
    function = CALLS[name][0]
    for index in range(len(arguments_of(name, np.random.default_rng(1)))):
        arguments = arguments_of(name, np.random.default_rng(1))
        arguments[index] = make(arguments[index])
        yield function, arguments


@pytest.mark.parametrize("name", CALLS)
def test_masked_arrays_are_refused(name):
    for make in (np.ma.masked_array, lambda a: np.ma.masked_array(a, np.zeros(a.shape, bool)), lambda a: list(np.ma.masked_array(np.atleast_2d(a)))):
        for function, arguments in given(name, make):
            if name == "Mechanism.reach" and any(isinstance(argument, list) for argument in arguments):
                continue  # It computes with them before it calls.
            with pytest.raises(TypeError, match=r"to have no mask, got numpy\.ma.*MaskedArray: pass `\w+\.filled"):
                function(*arguments)


@pytest.mark.parametrize("name", CALLS)
def test_a_masked_out_is_refused(name, rng):
    function, arguments = CALLS[name][0], arguments_of(name, rng)
    out = np.ma.zeros(function(*arguments).shape)
    with pytest.raises(TypeError, match="Expected `out` to have no mask"):
        function(*arguments, out=out)
    assert not out.any()


def test_masked_parents_are_refused():
    parents = np.ma.masked_array([-1, 0], [False, True])
    for call in (lambda: dq8.Hierarchy(parents), lambda: dq8.Mechanism(parents, "fixed", [0, 0, 1], A[0])):
        with pytest.raises(TypeError, match="Expected `parents` to have no mask"):
            call()


def test_masked_joints_and_transforms_of_masked_arrays_are_refused():
    with pytest.raises(TypeError, match="Expected `joints` to have no mask"):
        dq8.skin(np.ones((5, 3)), np.ma.zeros((5, 1), int), np.ones((5, 1)), A)
    transform = RigidTransform.identity(5)
    for call in (
        lambda: RigidTransform.from_matrix(np.ma.masked_array(np.eye(4))),
        lambda: RigidTransform.from_exp_coords(np.ma.zeros(6)),
        lambda: transform.apply(np.ma.zeros(3)),
        lambda: transform.mean(np.ma.ones(5)),
        lambda: transform ** np.ma.ones(5),
    ):
        with pytest.raises(TypeError, match="to have no mask"):
            call()


class Local:
    """An array in memory, of a class that takes NumPy's ufuncs over."""

    __array_ufunc__ = None

    def __init__(self, array):
        self.array, self.computed = array, 0

    def __array__(self, dtype=None, copy=None):
        self.computed += 1
        return self.array


class Remote(Local):
    """An array that takes all of NumPy's functions over."""

    def __array_function__(self, function, types, arguments, options):
        raise AssertionError("not a function of NumPy")


class Graph(Local):
    """A collection of Dask that is no array of NumPy's kind."""

    def __dask_graph__(self):
        return {}


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize("kind", [Remote, Graph])
def test_arrays_that_are_not_in_memory_are_refused_and_not_computed(name, kind):
    if name == "Mechanism.reach":
        pytest.skip("computes with its arguments before it calls `reach`")
    for function, arguments in given(name, kind):
        with pytest.raises(TypeError, match=rf"to be an array in memory, got \w+\.{kind.__name__}: pass `numpy\.asarray"):
            function(*arguments)
        assert not any(getattr(argument, "computed", 0) for argument in arguments)


def test_lists_of_arrays_that_are_not_in_memory_are_refused():
    remote = Remote(A[0])
    with pytest.raises(TypeError, match="in memory"):
        dq8.mul([remote, remote], A[0])
    assert not remote.computed


def test_reach_refuses_what_is_not_in_memory():
    arm = dq8.Mechanism([-1], "revolute", [0, 0, 1], dq8.identity())
    for targets, values, posture in [(Remote(A), [0.0], None), (A, Remote(np.zeros(1)), None), (A, [0.0], Remote(np.zeros(1)))]:
        with pytest.raises(TypeError, match="in memory"):
            arm.reach(targets, values, 0, posture=posture)


def test_dask_computes_block_by_block_and_never_of_itself():
    lazy = da.from_array(A, chunks=(2, 8))
    for call in (lambda: dq8.mul(lazy, lazy), lambda: dq8.mul(A, lazy), lambda: RigidTransform.from_dual_quat(lazy)):
        with pytest.raises(TypeError, match=r"got dask\.array\.core\.Array.*dq8\.dask"):
            call()
    mapped = da.map_blocks(dq8.mul, lazy, lazy, dtype=float)
    np.testing.assert_array_equal(mapped.compute(), dq8.mul(A, A))


def test_what_is_in_memory_is_taken():
    motions = np.arange(40.0).reshape(5, 8)
    for same in (
        Local(motions),
        pd.DataFrame(motions),
        pa.table({str(i): motions[:, i] for i in range(8)}),
        motions.view(np.matrix),
        memoryview(motions),
    ):
        np.testing.assert_array_equal(dq8.conjugate(same), dq8.conjugate(motions))


class OnlyDlpack:
    def __dlpack__(self, **options):
        return A.__dlpack__(**options)

    def __dlpack_device__(self):
        return A.__dlpack_device__()


CURES = {
    "Series": (pd.Series(list(A)), np.stack),
    "Rotation": (Rotation.identity(5), lambda a: a.as_quat()),
    "dq8._rigid_transform.RigidTransform": (RigidTransform.identity(5), lambda a: a.motions),
    "scipy.*RigidTransform": (Theirs.identity(5), lambda a: a.as_dual_quat()),
    "generator": ((a for a in A), list),
    "OnlyDlpack": (OnlyDlpack(), np.from_dlpack),
    "dtype object": (np.array([*A, None], object)[:5], np.stack),
}


@pytest.mark.parametrize("name", CURES)
def test_what_is_no_array_is_named_with_its_cure(name):
    value, cure = CURES[name]
    with pytest.raises(TypeError, match=rf"Expected `a` to hold real numbers of at most 64 bits, got .*{name}") as error:
        dq8.mul(value, A)
    # The cure stands in the message, and it cures.
    text = str(error.value).split("pass `")[1].split("`")[0]
    cured = eval(text, {"numpy": np, "list": list, "a": value})
    np.testing.assert_array_equal(cured, cure(value) if name != "generator" else cured)
    if name != "Rotation":
        np.testing.assert_array_equal(dq8.mul(cured, A) if name != "generator" else A, A)


@pytest.mark.parametrize(
    ("value", "named"),
    [
        (None, r"got None\."),
        ("text", r"got str\."),
        ([None], r"got a list with None in it\."),
        ([Rotation.identity()], r"got a list with scipy\.[\w.]*Rotation in it: pass `each\.as_quat\(\)`"),
        ({"x": 1.0}, r"got dict"),
        ({1.0}, r"got set\."),
        (pd.DataFrame({"x": [1.0, None]}, dtype="object"), r"got pandas\.[\w.]*DataFrame: pass `a\.to_numpy\(float"),
        (np.ones(8, complex), r"got dtype complex128\."),
        (np.ones(8, np.longdouble), r"got dtype (float128|longdouble)\."),
    ],
)
def test_the_type_of_what_is_no_array_is_named(value, named):
    with pytest.raises(TypeError, match="Expected `a` to hold real numbers of at most 64 bits, " + named):
        dq8.mul(value, A)


def test_nullable_columns_are_named_with_their_cure():
    table = pd.DataFrame({"x": pd.array([1.0, None], "Float64")})
    try:
        np.asarray(table).astype(float)
    except TypeError:
        with pytest.raises(TypeError, match=r"DataFrame: pass `points\.to_numpy\(float, na_value=numpy\.nan\)`"):
            dq8.transform_points(A[0], table)
    assert np.isnan(table.to_numpy(float, na_value=np.nan)[1, 0])


def test_no_exponent_is_a_type_error_as_in_scipy():
    for transform in (RigidTransform.identity(3), Theirs.identity(3)):
        with pytest.raises(TypeError):
            transform**None


@pytest.mark.parametrize("count", [0, -1, 257, 2_000, 10**30])
def test_numbers_of_threads_have_bounds(count, one_thread):
    with pytest.raises(ValueError, match=rf"Expected `count` to be from 1 to 256, got {count}\."):
        dq8.set_num_threads(count)
    assert dq8.get_num_threads() == 1


@pytest.mark.parametrize("count", [1.5, "2", None])
def test_numbers_of_threads_are_whole(count):
    with pytest.raises(TypeError, match="Expected `count` to be a whole number, got"):
        dq8.set_num_threads(count)


def test_the_environment_keeps_to_the_same_bounds():
    from processes import run

    for value in ("0", "-1", "257"):
        done = run("import dq8", DQ8_NUM_THREADS=value)
        assert "DQ8_NUM_THREADS to be a whole number from 1 to 256" in done.stderr
