"""Lazy functions on arrays of Dask: the same numbers, known before anything is computed."""

import os
import signal

import dask
import dask.array as da
import dask.dataframe as dd
import numpy as np
import pandas as pd
import pytest
from calls import ARM, CALLS, COUNT, INFLUENCES, MESH_JOINTS, MOTIONS, PALETTE, ROTATIONS, VALUES, arguments_of
from robots import ROBOTS
from test_rows import SIX

import dq8
import dq8.dask
from dq8._signatures import SIGNATURES

LAZY = [name for name in SIGNATURES if name in dq8.dask.__all__]


def chunked(array, size=8):
    return da.from_array(array, chunks=(size, *array.shape[1:]))


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("name", LAZY)
def test_lazy_results_are_those_of_arrays_and_known_before(name, dtype, rng):
    function, arguments = CALLS[name][0], arguments_of(name, rng, dtype)
    expected = function(*arguments)
    lazy = getattr(dq8.dask, name)(*map(chunked, arguments))
    assert isinstance(lazy, da.Array)
    assert (lazy.dtype, lazy.shape, lazy.numblocks[0]) == (expected.dtype, expected.shape, 3)
    computed = lazy.compute(scheduler="synchronous")
    assert computed.dtype == expected.dtype
    np.testing.assert_array_equal(computed, expected)


def test_leading_dimensions_broadcast_and_split_elements_are_joined(random_motions, rng):
    a, b, t = random_motions(6, 1), random_motions(4), rng.random((6, 4))
    expected = dq8.nlerp(a, b, t)
    lazy = dq8.dask.nlerp(da.from_array(a, chunks=(2, 1, 3)), da.from_array(b, chunks=(2, 8)), da.from_array(t, chunks=2))
    assert lazy.shape == expected.shape
    np.testing.assert_array_equal(lazy.compute(), expected)
    np.testing.assert_array_equal(dq8.dask.pow(chunked(b, 2), t=0.5), dq8.pow(b, 0.5))
    single = dq8.dask.pow(chunked(b.astype(np.float32), 2), 0.5)
    assert single.dtype == single.compute().dtype == np.float32


def test_wrong_arguments_are_refused_before_anything_is_computed(random_motions):
    with pytest.raises(ValueError, match=r"mul: expected shape \(\.\.\., 8\), got \(3, 7\)"):
        dq8.dask.mul(da.zeros((3, 7)), da.zeros((3, 8)))
    for call in (lambda a: dq8.dask.mul(a), lambda a: dq8.dask.mul(a, a, b=a), lambda a: dq8.dask.mul(a, c=a)):
        with pytest.raises(TypeError, match=r"Expected mul\(a, b\)"):
            call(da.zeros((3, 8)))


def test_robots_and_meshes_are_lazy_too(rng):
    values = VALUES(rng)
    lazy = chunked(values)
    assert len(ARM.values) == 3 and COUNT == len(values)
    for links in (None, 3, [1, 3]):
        made, expected = dq8.dask.poses(ARM, lazy, links), ARM.poses(values, links)
        assert made.shape == expected.shape
        np.testing.assert_array_equal(made.compute(), expected)
    np.testing.assert_array_equal(dq8.dask.jacobian(ARM, lazy, 3, "body").compute(), ARM.jacobian(values, 3, "body"))
    targets, start = ARM.poses(values, 3), values + 0.05
    found, converged = dask.compute(*dq8.dask.reach(ARM, chunked(targets), chunked(start), 3))
    expected, report = ARM.reach(targets, start, 3)
    np.testing.assert_array_equal(found, expected)
    np.testing.assert_array_equal(converged, report.converged)
    points, weights, palettes = rng.normal(size=(COUNT, 3)), rng.dirichlet(np.ones(5), COUNT), np.stack([PALETTE(rng)] * 4)
    made = dq8.dask.skin(points, MESH_JOINTS, weights, da.from_array(palettes, chunks=(1, 5, 8)))
    np.testing.assert_array_equal(made.compute(), dq8.skin(points, MESH_JOINTS, weights, palettes))


def test_what_is_written_in_python_is_lazy_too(rng):
    motions, angles, rotations = MOTIONS(rng), rng.normal(size=(COUNT, 3)), ROTATIONS(rng)
    lazy, plain = dq8.dask, chunked(motions)
    for made, expected in [
        (lazy.from_matrix(chunked(dq8.to_matrix(motions))), dq8.from_matrix(dq8.to_matrix(motions))),
        (lazy.from_matrix(chunked(dq8.to_matrix(motions)[:, :3])), dq8.from_matrix(dq8.to_matrix(motions))),
        (lazy.from_euler("ZYX", chunked(angles)), dq8.from_euler("ZYX", angles)),
        (lazy.to_euler(plain, "xyz"), dq8.to_euler(motions, "xyz")),
        (lazy.from_rotation(chunked(rotations)), dq8.from_rotation(rotations)),
        (lazy.from_rotation_vector(chunked(angles)), dq8.from_rotation_vector(angles)),
        (lazy.to_rotation_vector(plain), dq8.to_rotation_vector(motions)),
        (lazy.rotation(plain), dq8.rotation(motions)),
        (lazy.from_wxyz(plain), dq8.from_wxyz(motions)),
        (lazy.to_wxyz(plain), dq8.to_wxyz(motions)),
        (lazy.is_unit(plain, tolerance=0.1), dq8.is_unit(motions, tolerance=0.1)),
    ]:
        assert (made.dtype, made.shape, made.numblocks[0]) == (expected.dtype, expected.shape, 3)
        np.testing.assert_array_equal(made.compute(), expected)
    single = lazy.from_euler("xyz", chunked(angles.astype(np.float32)))
    assert single.dtype == single.compute().dtype == np.float32
    with pytest.raises(ValueError, match="Expected `order` to be three of"):
        lazy.from_euler("abc", chunked(angles))


def test_blends_go_along_a_dimension_that_is_in_one_chunk(rng):
    clip, weights = INFLUENCES(rng), rng.random((COUNT, 5))
    lazy = da.from_array(clip, chunks=(8, 5, 8))
    for function, own in ((dq8.dlb, dq8.dask.dlb), (dq8.mean, dq8.dask.mean)):
        np.testing.assert_array_equal(own(lazy), function(clip))
        np.testing.assert_array_equal(own(lazy, weights[0]), function(clip, weights[0]))
        np.testing.assert_array_equal(own(lazy, da.from_array(weights, chunks=(8, 5))), function(clip, weights))
        joints = da.from_array(clip, chunks=(-1, 2, 8))
        np.testing.assert_array_equal(own(joints, axis=0), function(clip, axis=0))
        np.testing.assert_array_equal(own(joints, weights, axis=0), function(clip, weights, axis=0))
        with pytest.raises(ValueError, match=r"expected dimension 0 to be in one chunk, got 3: pass `motions.rechunk\(\{0: -1\}\)`"):
            own(lazy, axis=0)
        with pytest.raises(ValueError, match="expected `axis` to be one of the 2 dimensions"):
            own(lazy, axis=2)
    np.testing.assert_array_equal(dq8.dask.mean(lazy, max_iterations=1), dq8.mean(clip, max_iterations=1))


def test_fits_are_lazy_too(rng):
    points, motions = rng.normal(size=(COUNT, 6, 3)), MOTIONS(rng)
    moved = dq8.transform_points(motions[:, np.newaxis], points)
    weights = rng.random((COUNT, 6))
    lazy = dq8.dask.fit(chunked(points), chunked(moved), chunked(weights), robust="huber")
    assert lazy.shape == (COUNT, 8) and lazy.numblocks == (3, 1)
    np.testing.assert_array_equal(lazy, dq8.fit(points, moved, weights, robust="huber"))
    with pytest.raises(ValueError, match="Expected `robust`"):
        dq8.dask.fit(chunked(points), chunked(moved), robust="cauchy")
    with pytest.raises(ValueError, match="expected no `full`"):
        dq8.dask.fit(chunked(points), chunked(moved), full=True)


def test_all_solutions_and_velocities_are_lazy_too(rng):
    values = rng.uniform(-1, 1, size=(COUNT, 6))
    targets = SIX.poses(values, 5)
    made, expected = dq8.dask.solutions(SIX, chunked(targets), chunked(values), 5), SIX.solutions(targets, values, 5)
    for own, one in zip(made, expected):
        assert (own.dtype, own.shape, own.numblocks[0]) == (one.dtype, one.shape, 3)
        np.testing.assert_array_equal(own.compute(), one)
    values, rates = VALUES(rng), VALUES(rng)
    np.testing.assert_array_equal(
        dq8.dask.velocity(ARM, chunked(values), chunked(rates), 3, "body"), ARM.velocity(values, rates, 3, "body")
    )


def test_names_are_tried_when_the_graph_is_made(rng):
    values, targets = chunked(VALUES(rng)), chunked(MOTIONS(rng))
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm6.urdf")
    six = chunked(arm.sample(COUNT, rng=rng))
    for call in (
        lambda: dq8.dask.poses(arm, six, "tol0"),
        lambda: dq8.dask.poses(arm, six, ["tol0"]),
        lambda: dq8.dask.jacobian(arm, six, "tol0"),
        lambda: dq8.dask.velocity(arm, six, six, "tol0"),
        lambda: dq8.dask.reach(arm, targets, six, "tol0"),
        lambda: dq8.dask.solutions(arm, targets, six, "tol0"),
    ):
        with pytest.raises((KeyError, ValueError), match="tol0"):
            call()
    with pytest.raises(ValueError, match="frame"):
        dq8.dask.jacobian(ARM, values, 3, "spatial")
    with pytest.raises(TypeError):
        dq8.dask.reach(ARM, targets, values, 3, tolerances=1.0)
    with pytest.raises(ValueError, match="six"):
        dq8.dask.solutions(ARM, targets, values, 3)


def test_ids_of_frames_are_kept(rng):
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm6.urdf")
    values = arm.sample(COUNT, rng=rng)
    ids = pd.Index(rng.permutation(COUNT), name="id")
    frame = dd.from_pandas(pd.DataFrame(values, ids, arm.values)[arm.values[::-1]], npartitions=3, sort=False)
    names = ["px", "py", "pz", "pw", "qx", "qy", "qz", "qw"]
    made = dd.from_dask_array(dq8.dask.poses(arm, frame, arm.links[-1]), columns=names, index=frame.index).compute()
    assert made.index.equals(ids)
    np.testing.assert_array_equal(made.to_numpy(), arm.poses(values, arm.links[-1]))


def test_tasks_have_names_that_people_understand():
    lazy = dq8.dask.mul(da.zeros((4, 8)), dq8.dask.inverse(da.ones((4, 8))))
    names = {dask.utils.key_split(key) for key in lazy.__dask_graph__()}
    assert {"dq8-mul", "dq8-inverse"} <= names


def test_a_killed_worker_leaves_every_row_once_and_right(tmp_path, request):
    distributed = pytest.importorskip("distributed")
    import pyarrow as pa
    import pyarrow.parquet as pq

    count, parts = request.config.getoption("--rows"), 10
    rng = np.random.default_rng(1)
    values = rng.uniform(-1, 1, size=(count, 3))
    for part in range(parts):
        rows = slice(part * count // parts, (part + 1) * count // parts)
        table = pa.table({"row": np.arange(count)[rows], "q": pa.array(dq8.to_arrow(values[rows]))})
        pq.write_table(table, tmp_path / f"in{part}.parquet")

    def convert(part):
        table = pq.read_table(tmp_path / f"in{part}.parquet")
        poses = ARM.poses(dq8.from_arrow(table["q"]), 3)
        pq.write_table(pa.table({"row": table["row"], "pose": pa.array(dq8.to_arrow(poses))}), tmp_path / f"out{part}.parquet")
        return len(poses)

    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            pids = list(client.run(os.getpid).values())
            futures = client.map(convert, range(parts), pure=False)
            distributed.wait(futures[:2])
            os.kill(pids[0], signal.SIGKILL)
            assert sum(client.gather(futures)) == count
            lazy = dq8.dask.poses(ARM, da.from_array(values, chunks=(50_000, 3)), 3)
            expected = ARM.poses(values, 3)
            np.testing.assert_array_equal(lazy.compute(), expected)
    tables = [pq.read_table(tmp_path / f"out{part}.parquet") for part in range(parts)]
    rows = np.concatenate([table["row"].to_numpy() for table in tables])
    np.testing.assert_array_equal(rows, np.arange(count))
    np.testing.assert_array_equal(np.concatenate([dq8.from_arrow(table["pose"]) for table in tables]), expected)
