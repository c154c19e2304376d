"""Clouds of points moved by the pose at each point's time, and trajectories sampled, read, written and compared."""

import pickle
import threading

import dask.array as da
import numpy as np
import pytest
from calls import neighbours
from scipy.spatial.transform import Rotation, Slerp

import dq8
import dq8.dask

STAMPS = np.array([100.0, 100.03, 100.05, 100.1])


@pytest.fixture
def poses(rng):
    return neighbours(rng, 4)


@pytest.fixture
def path(poses):
    return dq8.Trajectory(STAMPS, poses)


def by_the_book(path, points, times, into=None):
    """Each point by the pose at its time, one after the other."""
    moved = [dq8.transform_points(path.at(time), point[:3]) for point, time in zip(points, times)]
    moved = np.array(moved).reshape(-1, 3)
    return moved if into is None else dq8.transform_points(dq8.inverse(into), moved)


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("count", [0, 1, 50, 30_000])
def test_points_are_moved_by_the_pose_at_their_time(rng, path, poses, count, threads):
    points, times = rng.normal(size=(count, 3)), rng.uniform(99.9, 100.2, count)
    frames = {"world": None, "start": poses[0], "end": poses[3], 100.04: path.at(100.04)}
    dq8.set_num_threads(threads)
    try:
        for frame, into in frames.items():
            moved = dq8.deskew(points, times, STAMPS, poses, frame=frame)
            some = slice(0, count, 1 + count // 100)
            np.testing.assert_allclose(moved[some], by_the_book(path, points[some], times[some], into), atol=1e-12)
            np.testing.assert_allclose(dq8.skew(moved, times, STAMPS, poses, frame=frame), points, atol=1e-12)
        own = path.deskew(points, times, frame=path.at(100.01))
        np.testing.assert_array_equal(own, path.deskew(points, times, frame=100.01))
    finally:
        dq8.set_num_threads(1)


def test_scipy_moves_points_the_same_way_where_the_body_only_turns(rng):
    turns = Rotation.random(1, rng=rng) * Rotation.from_rotvec(0.3 * rng.normal(size=(4, 3)))
    poses = dq8.from_rotation(turns)
    points, times = rng.normal(size=(200, 3)), rng.uniform(100.0, 100.1, 200)
    expected = Slerp(STAMPS, turns)(times).apply(points)
    np.testing.assert_allclose(dq8.deskew(points, times, STAMPS, poses), expected, atol=1e-13)


def test_what_a_record_holds_beside_a_point_is_copied(rng, path):
    for numbers in (4, 5, 8):
        points, times = rng.normal(size=(300, numbers)), rng.uniform(100.0, 100.1, 300)
        moved = path.deskew(points, times)
        np.testing.assert_array_equal(moved[:, 3:], points[:, 3:])
        np.testing.assert_array_equal(moved[:, :3], path.deskew(points[:, :3], times))
        np.testing.assert_allclose(path.skew(moved, times), points, atol=1e-12)


def test_rows_share_the_times_of_their_columns(rng, path):
    points, times = rng.normal(size=(20, 64, 3)), rng.uniform(100.0, 100.1, 64)
    each = path.deskew(points, np.tile(times, (20, 1)))
    for shared in (times, times[np.newaxis]):
        np.testing.assert_allclose(path.deskew(points, shared), each, atol=1e-12)
        np.testing.assert_allclose(path.skew(each, shared), points, atol=1e-12)
    rows = np.arange(20) * 0.005 + 100
    np.testing.assert_array_equal(path.deskew(points, rows[:, np.newaxis]), path.deskew(points, np.tile(rows[:, None], 64)))
    np.testing.assert_array_equal(path.deskew(points, 100.02), path.deskew(points, np.full((20, 64), 100.02)))


def test_precision_is_that_of_the_points(rng, path, poses):
    points, times = rng.normal(size=(500, 3)), rng.uniform(100.0, 100.1, 500)
    single = path.deskew(points.astype(np.float32), times)
    assert single.dtype == np.float32 and path.deskew(points, times).dtype == np.float64
    np.testing.assert_allclose(single, path.deskew(points, times), atol=2e-6)
    # A map a thousand kilometres away costs nothing.
    far = dq8.mul(dq8.from_translation([1e6, -2e6, 0]), poses)
    moved = dq8.deskew(points.astype(np.float32), times, STAMPS, far, frame="end")
    np.testing.assert_allclose(moved, path.deskew(points, times, frame="end"), atol=3e-6)


@pytest.mark.parametrize("dtype", [np.uint32, np.int64, np.uint64, np.float64, np.float32])
def test_clocks_count_nanoseconds_of_any_type(rng, path, dtype):
    points, since = rng.normal(size=(300, 3)), rng.integers(0, 100_000_000, 300)
    expected = path.deskew(points, 100.0 + 1e-9 * since)
    np.testing.assert_allclose(path.deskew(points, since.astype(dtype), clock=(100.0, 1e-9)), expected, atol=1e-6)
    if dtype == np.int64:
        epoch = since + 100_000_000_000
        np.testing.assert_allclose(path.deskew(points, epoch, clock=(0.0, 1e-9)), expected, atol=1e-12)


def test_outside_the_stamps_the_body_stands_or_goes_on_or_it_is_refused(rng, poses, path):
    points, times = rng.normal(size=(3, 3)), np.array([99.0, 100.05, 101.0])
    stands = by_the_book(path, points, [100.0, 100.05, 100.1])
    np.testing.assert_allclose(path.deskew(points, times), stands, atol=1e-12)
    np.testing.assert_array_equal(path.twists(times)[[0, 2]], 0)
    on = path.sample(times, outside="continue")
    way = dq8.to_twist(dq8.mul(dq8.inverse(poses[2]), poses[3])) / 0.05
    expected = dq8.mul(poses[3], dq8.from_twist(0.9 * way))
    assert dq8.allclose(on[2], expected)
    np.testing.assert_allclose(path.twists(101.0, outside="continue"), way, atol=1e-10)
    out = np.full((3, 3), 7.0)
    with pytest.raises(ValueError, match=r"`times`: time 0 is 99 s, and the stamps go from 100 s to 100.1 s"):
        path.deskew(points, times, outside="refuse", out=out)
    # Also where another piece of the work would find it.
    many = np.full(200_000, 100.05)
    many[-1] = np.nan
    big = np.full((200_000, 3), 7.0)
    with pytest.raises(ValueError, match=r"time 199999 is NaN s"):
        path.deskew(np.ones((200_000, 3)), many, outside="refuse", out=big)
    assert (out == 7).all() and (big == 7).all()


def test_what_is_not_finite_stays_in_its_point(rng, path):
    points, times = rng.normal(size=(100, 3)), rng.uniform(100.0, 100.1, 100)
    whole = path.deskew(points, times)
    points[7, 1], times[21] = np.nan, np.nan
    moved = path.deskew(points, times)
    assert np.isnan(moved[[7, 21]]).any(axis=-1).all()
    rest = np.setdiff1d(np.arange(100), [7, 21])
    np.testing.assert_array_equal(moved[rest], whole[rest])
    assert np.isnan(path.sample(np.nan)).all()


def test_out_may_be_the_points(rng, path):
    points, times = rng.normal(size=(100, 3)), rng.uniform(100.0, 100.1, 100)
    expected = path.deskew(points, times)
    assert path.deskew(points, times, out=points) is points
    np.testing.assert_array_equal(points, expected)
    strided = np.zeros((100, 6))[:, ::2]
    path.skew(expected, times, out=strided)
    np.testing.assert_array_equal(strided, path.skew(expected, times))


def test_samples_are_poses_at_times_of_any_shape(rng, path):
    times = rng.uniform(99.9, 100.2, (3, 5))
    samples = path.sample(times)
    assert samples.shape == (3, 5, 8) and path.sample(100.04).shape == (8,)
    for index in np.ndindex(3, 5):
        assert dq8.allclose(samples[index], path.at(times[index]))
    ends = dq8.mul(dq8.inverse(path.at(100.1)), samples)
    assert dq8.allclose(path.sample(times, frame="end"), ends)
    step = dq8.mul(dq8.inverse(path.sample(100.04)), path.sample(100.04 + 1e-6))
    np.testing.assert_allclose(path.twists(100.04), dq8.to_twist(step) / 1e-6, atol=1e-6)


def test_stamps_in_any_order_are_sorted_and_doubles_dropped(poses):
    path, dropped = dq8.Trajectory.sorted([2.0, 1.0, 3.0, 1.0], poses)
    np.testing.assert_array_equal(path.stamps, [1, 2, 3])
    np.testing.assert_array_equal(path.poses, poses[[1, 0, 2]])
    assert dropped == 1 and len(path) == 3
    copy = pickle.loads(pickle.dumps(path))
    np.testing.assert_array_equal(copy.poses, path.poses)
    assert copy.range == path.range == (1.0, 3.0)


@pytest.mark.parametrize("format", ["tum", "euroc", "kitti"])
def test_files_come_back(tmp_path, path, format):
    name = tmp_path / "path.txt"
    path.to_file(name, format)
    read = dq8.Trajectory.from_file(name)
    assert dq8.allclose(read.poses, path.poses, angle=1e-14, length=1e-14)
    np.testing.assert_allclose(read.stamps, np.arange(4) if format == "kitti" else STAMPS, atol=1e-9)
    np.testing.assert_array_equal(dq8.Trajectory.from_file(name, format).poses, read.poses)


def test_faults_of_files_are_warnings_or_errors(tmp_path):
    name = tmp_path / "path.txt"
    name.write_text("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n")
    with pytest.warns(UserWarning, match=r"path.txt: line 2: the stamp 1 s is before"):
        np.testing.assert_array_equal(dq8.Trajectory.from_file(name).stamps, [1, 2])
    name.write_text("1 0 0 0 0 0 0 x\n")
    with pytest.raises(ValueError, match="line 1, field 8"):
        dq8.Trajectory.from_file(name)
    with pytest.raises(FileNotFoundError, match=r"cannot read .*none.txt"):
        dq8.Trajectory.from_file(tmp_path / "none.txt")
    with pytest.raises(ValueError, match="Expected `format` to be 'tum'"):
        dq8.Trajectory.from_file(name, "bag")


def test_comparisons_have_the_figures_of_their_definitions(rng, tmp_path):
    stamps = np.arange(50.0)
    poses = dq8.chain_products(dq8.from_twist(np.tile([0.1, 0.05, 0.2, 1, 0.3, 0], (50, 1))))
    noisy = dq8.mul(poses, dq8.from_twist(0.01 * rng.normal(size=(50, 6))))
    reference, estimate = dq8.Trajectory(stamps, poses), dq8.Trajectory(stamps + 0.004, noisy)
    found = dq8.compare(reference, estimate)
    lengths = np.linalg.norm(dq8.translation(poses) - dq8.translation(noisy), axis=-1)
    np.testing.assert_allclose(found.translations, lengths, atol=1e-14)
    np.testing.assert_allclose(found.rotations, dq8.angle_to(poses, noisy), atol=1e-14)
    figures = [np.sqrt(np.mean(lengths**2)), lengths.mean(), np.median(lengths), lengths.std(), lengths.min(), lengths.max(), sum(lengths**2)]
    np.testing.assert_allclose(found.translation, figures, rtol=1e-12)
    steps = [dq8.mul(dq8.inverse(of[:-1]), of[1:]) for of in (poses, noisy)]
    motions = dq8.compare(reference, estimate, frames=1)
    np.testing.assert_allclose(motions.rotations, dq8.angle_to(*steps), atol=1e-12)
    elsewhere = dq8.Trajectory(stamps, dq8.mul(dq8.random(rng=3), noisy))
    aligned = dq8.compare(reference, elsewhere, align="rigid")
    best = dq8.fit(dq8.translation(elsewhere.poses), dq8.translation(poses))
    assert dq8.allclose(aligned.alignment, best) and aligned.scale == 1
    assert aligned.translation.rmse < found.translation.rmse
    for how in ("origin", "yaw", "similarity"):
        dq8.compare(reference, elsewhere, align=how)
    assert len(dq8.compare(reference, estimate, interpolated=True).stamps) == 49
    reference.to_file(tmp_path / "a"), estimate.to_file(tmp_path / "b")
    assert dq8.compare(tmp_path / "a", str(tmp_path / "b")).translation.rmse == pytest.approx(found.translation.rmse)
    for wrong, message in (
        ({"align": "up"}, "Expected `align`"),
        ({"frames": 1, "metres": 2.0}, "at most one of"),
        ({"tolerance": 0.001}, "no pose has a partner"),
        ({"seconds": 0.0}, "a step must be positive"),
    ):
        with pytest.raises(ValueError, match=message):
            dq8.compare(reference, estimate, **wrong)


@pytest.mark.parametrize("basis", ["smooth", "through"])
def test_splines_have_the_derivatives_of_their_poses(rng, basis):
    control = neighbours(rng, 7)
    spline = dq8.Spline(control, 0.5, 10.0, basis=basis)
    assert spline.range == (10.0, 12.0)
    times, step = rng.uniform(10.01, 11.99, 40), 1e-5
    around = [spline.sample(times + shift) for shift in (-step, 0, step)]
    assert dq8.allclose(around[1][3], spline.at(times[3]))
    ways = dq8.to_twist(dq8.mul(dq8.inverse(around[0]), around[2])) / (2 * step)
    np.testing.assert_allclose(spline.twists(times), ways, atol=1e-7 * abs(ways).max())
    change = (spline.twists(times + step) - spline.twists(times - step)) / (2 * step)
    inside = abs((times - 10) % 0.5 - 0.25) < 0.24
    accelerations = spline.accelerations(times)
    np.testing.assert_allclose(accelerations[inside], change[inside], atol=1e-6 * abs(change).max())
    at, delta = times[0], 1e-6 * rng.normal(size=6)
    first = int((at - 10) // 0.5)
    jacobians = spline.jacobians(at)
    assert jacobians.shape == (4, 6, 6) and spline.jacobians(times[:6].reshape(2, 3)).shape == (2, 3, 4, 6, 6)
    for k in range(4):
        other = control.copy()
        other[first + k] = dq8.mul(control[first + k], dq8.from_twist(delta))
        moved = dq8.Spline(other, 0.5, 10.0, basis=basis).at(at)
        np.testing.assert_allclose(dq8.to_twist(dq8.mul(dq8.inverse(spline.at(at)), moved)), jacobians[k] @ delta, atol=1e-10)
    copy = pickle.loads(pickle.dumps(spline))
    np.testing.assert_array_equal(copy.sample(times), around[1])
    if basis == "through":
        assert dq8.allclose(spline.sample([10.0, 10.5]), control[1:3], angle=1e-7)


def test_fits_say_how_well_the_points_tell_the_motion(rng):
    motions = dq8.random((3, 2), rng=rng)
    points = rng.normal(size=(2, 20, 3))
    moved = dq8.transform_points(motions[..., np.newaxis, :], 2.5 * points)
    found = dq8.fit(2.5 * points, moved, full=True)
    assert isinstance(found, dq8.Fit) and dq8.allclose(found.motions, motions)
    np.testing.assert_allclose(found.scales, 1)
    np.testing.assert_array_equal(found.ranks, np.full((3, 2), 3))
    assert (found.rms < 1e-14).all() and (found.conditions < 10).all()
    scaled = dq8.fit(points, moved, scale=True, full=True)
    np.testing.assert_allclose(scaled.scales, 2.5)
    yaw = dq8.from_screw([0, 0, 1, 0, 0, 0, 0.7, 0.0])
    about = dq8.fit(points[0], dq8.transform_points(yaw, points[0]), about=[0, 0, 2.0])
    assert dq8.allclose(about, yaw)
    line = np.outer(np.arange(5.0), [1, 2, 3])
    with pytest.raises(ValueError, match="many rotations fit equally well: their rank is 1"):
        dq8.fit(line, line)
    on_line = dq8.fit(line, line, full=True)
    assert np.isnan(on_line.motions).all() and on_line.ranks == 1 and np.isinf(on_line.conditions)
    with pytest.raises(ValueError, match="Expected `about` to be a direction"):
        dq8.fit(points[0], points[0], about=[0, 0, 0])


POINTS, TIMES = np.zeros((5, 3)), np.full(5, 100.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda path: dq8.Trajectory([0, 0], dq8.identity(2)), r"`stamps`: stamp 1 is 0 s"),
        (lambda path: dq8.Trajectory([0, 1, 2], dq8.identity(2)), r"Expected `poses` to have shape \(3, 8\), got \(2, 8\)"),
        (lambda path: dq8.Trajectory([], dq8.identity(0)), r"`poses`: a trajectory needs at least one pose"),
        (lambda path: dq8.Trajectory([[0]], dq8.identity(1)), r"Expected `stamps` to have shape \(n,\), got \(1, 1\)"),
        (lambda path: dq8.Trajectory.of_twist(np.zeros(5), 0, 1), r"Expected `twist`"),
        (lambda path: path.deskew(POINTS, TIMES[:4]), r"Expected `times` to have shape that of `points`"),
        (lambda path: path.deskew(POINTS, TIMES[:, np.newaxis, np.newaxis]), r"Expected `times`"),
        (lambda path: path.deskew(POINTS[:, :2], TIMES), r"Expected `points` to have shape \(\.\.\., c\) with c ≥ 3"),
        (lambda path: path.deskew(POINTS, TIMES, frame="map"), r"Expected `frame` to be 'world', 'start'"),
        (lambda path: path.deskew(POINTS, TIMES, frame=[0, 0, 0]), r"Expected `frame` to have shape"),
        (lambda path: path.deskew(POINTS, TIMES, frame=np.nan), r"there is no frame at NaN s"),
        (lambda path: path.deskew(POINTS, TIMES, outside="away"), r"Expected `outside` to be 'hold'"),
        (lambda path: path.deskew(POINTS, TIMES, clock=(0.0, 0.0)), r"the clock has 0"),
        (lambda path: path.deskew(POINTS, TIMES, out=np.zeros((5, 4))), r"Expected `out` to have shape \(5, 3\)"),
        (lambda path: dq8.Trajectory([0], dq8.identity(1)).sample([1], outside="continue"), r"one pose has no velocity"),
        (lambda path: dq8.Spline(dq8.identity(3)), r"3 control poses"),
        (lambda path: dq8.Spline(dq8.identity(4), 0.0), r"knots every 0 s"),
        (lambda path: dq8.Spline(dq8.identity(4), basis="round"), r"Expected `basis` to be 'smooth' or 'through'"),
    ],
)
def test_what_does_not_fit_is_refused(path, call, message):
    with pytest.raises(ValueError, match=message):
        call(path)


def test_dask_moves_each_block_by_itself(rng, poses):
    points, times = rng.normal(size=(1000, 4)).astype(np.float32), rng.uniform(100.0, 100.1, 1000)
    expected = dq8.deskew(points, times, STAMPS, poses, frame="end")
    for function, given in ((dq8.dask.deskew, points), (dq8.dask.skew, expected)):
        lazy = function(da.from_array(given, chunks=(300, 4)), da.from_array(times, chunks=300), STAMPS, poses, frame="end")
        assert isinstance(lazy, da.Array) and lazy.dtype == np.float32 and lazy.numblocks == (4, 1)
        np.testing.assert_allclose(lazy.compute(scheduler="synchronous"), expected if given is points else points, atol=2e-6)


def test_other_threads_of_python_run_meanwhile(rng, path):
    points, times = rng.normal(size=(2_000_000, 3)), rng.uniform(100.0, 100.1, 2_000_000)
    ticks, done = [], threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(1)

    other = threading.Thread(target=tick)
    other.start()
    path.deskew(points, times)
    done.set()
    other.join()
    assert len(ticks) > 2
