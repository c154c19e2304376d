"""Trajectories: smooth motion through keys, poses at other times, means of windows."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import RigidTransform

import dq8


def scipy_of(motions):
    return RigidTransform.from_dual_quat(motions)


def screw(a: RigidTransform, b: RigidTransform, t: np.ndarray) -> RigidTransform:
    """a (a⁻¹ b)ᵗ by SciPy's exponential coordinates, which turn by less than π: the shorter way."""
    return a * RigidTransform.from_exp_coords(np.atleast_1d(t)[:, None] * (a.inv() * b).as_exp_coords())


def keys_along(rng, random_motions, count, step=0.5):
    """Key poses, each less than half a turn from the one before."""
    keys = [random_motions()]
    for twist in step * rng.normal(size=(count - 1, 6)):
        keys.append(dq8.mul(keys[-1], dq8.from_twist(twist)))
    return np.array(keys)


# A register is left half empty, and then there are several.
@pytest.mark.parametrize("count", [1, 3, 4, 21])
def test_squad_is_its_formula_in_scipy(rng, random_motions, close, count):
    base = random_motions(count)
    poses = [dq8.mul(base, dq8.from_twist(0.4 * rng.normal(size=(count, 6)))) for _ in range(4)]
    t = np.linspace(-0.1, 1.1, count)
    a, s, r, b = map(scipy_of, poses)
    expected = screw(screw(a, b, t), screw(s, r, t), 2 * t * (1 - t))
    close(dq8.to_matrix(dq8.squad(*poses, t)), expected.as_matrix(), *poses)


@pytest.mark.parametrize("count", [1, 3, 21])
def test_controls_are_their_formula_in_scipy(rng, random_motions, close, count):
    base = random_motions(count)
    poses = [dq8.mul(base, dq8.from_twist(0.4 * rng.normal(size=(count, 6)))) for _ in range(3)]
    before, key, after = map(scipy_of, poses)
    ahead, back = (key.inv() * after).as_exp_coords(), (key.inv() * before).as_exp_coords()
    expected = key * RigidTransform.from_exp_coords(-(ahead + back) / 4)
    close(dq8.to_matrix(dq8.squad_control(*poses)), expected.as_matrix(), *poses)


def test_velocity_is_continuous_across_keys(rng, random_motions):
    keys = keys_along(rng, random_motions, 5)
    controls = dq8.squad_control(keys[:-2], keys[1:-1], keys[2:])
    h = 1e-4

    def near(k, t):
        return dq8.squad(keys[k], controls[k - 1], controls[k], keys[k + 1], t)

    before = dq8.to_twist(dq8.mul(dq8.conjugate(near(1, 1 - h)), near(1, 1))) / h
    after = dq8.to_twist(dq8.mul(dq8.conjugate(near(2, 0)), near(2, h))) / h
    np.testing.assert_allclose(before, after, rtol=0, atol=2e-2 * np.linalg.norm(after))


def test_signs_of_keys_and_controls_do_not_matter(rng, random_motions):
    a, b, c, d = keys_along(rng, random_motions, 4)
    np.testing.assert_array_equal(dq8.squad(a, b, c, d, 0.3), dq8.squad(a, -b, c, -d, 0.3))
    np.testing.assert_array_equal(dq8.squad_control(a, b, c), dq8.squad_control(-a, b, -c))


@settings(deadline=None)
@given(
    shapes=st.lists(st.sampled_from([(), (1,), (7,), (5, 1), (5, 7), (1, 7)]), min_size=5, max_size=5),
    seed=st.integers(0, 1000),
)
def test_all_five_arguments_broadcast(shapes, seed):
    rng = np.random.default_rng(seed)
    *motions, t = [rng.normal(size=(*shape, 6)) for shape in shapes]
    motions, t = [dq8.from_twist(0.3 * twists) for twists in motions], t[..., 0]
    shape = np.broadcast_shapes(*shapes)
    full = [np.broadcast_to(motion, (*shape, 8)).copy() for motion in motions]
    result = dq8.squad(*motions, t)
    assert result.shape == (*shape, 8)
    np.testing.assert_array_equal(result, dq8.squad(*full, np.broadcast_to(t, shape).copy()))
    full = [np.broadcast_to(motion, (*np.broadcast_shapes(*shapes[:3]), 8)).copy() for motion in motions[:3]]
    np.testing.assert_array_equal(dq8.squad_control(*motions[:3]), dq8.squad_control(*full))


@pytest.mark.parametrize("over", [None, 0, 1, 3])
def test_squad_is_written_to_out_even_over_an_argument(random_motions, over):
    poses = [random_motions(30) for _ in range(4)]
    expected = dq8.squad(*poses, 0.25)
    out = np.empty((30, 8)) if over is None else poses[over]
    assert dq8.squad(*poses, 0.25, out=out) is out
    np.testing.assert_array_equal(out, expected)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_precision_is_that_of_the_arrays(rng, random_motions, dtype):
    keys = keys_along(rng, random_motions, 6).astype(dtype)
    times = np.arange(6, dtype=dtype)
    assert dq8.squad(*keys[:4], 0.5).dtype == dtype
    assert dq8.squad_control(*keys[:3]).dtype == dtype
    assert dq8.resample(times, keys, times).dtype == dtype
    assert dq8.dib_windows(keys, np.ones(3, dtype)).dtype == dtype


def test_threads_change_no_bit(random_motions, one_thread):
    keys, t = [random_motions(9001) for _ in range(4)], np.linspace(0, 1, 9001)

    def results():
        return [dq8.squad(*keys, t), dq8.squad_control(*keys[:3]), dq8.dib_windows(keys[0], [1.0, 2.0], max_iterations=3)]

    expected = results()
    dq8.set_num_threads(2)
    for result, one in zip(results(), expected):
        np.testing.assert_array_equal(result, one)


@pytest.mark.parametrize("shape", [(), (1,), (100,), (3, 50)])
def test_samples_are_on_the_screws_between_neighbours(rng, random_motions, close, shape):
    keys = keys_along(rng, random_motions, 12)
    times = np.cumsum(0.1 + rng.random(12))
    at = rng.uniform(times[0] - 1, times[-1] + 1, size=shape)
    inside = np.clip(at, times[0], times[-1]).ravel()
    k = np.clip(np.searchsorted(times, inside, side="right") - 1, 0, 10)
    share = (inside - times[k]) / (times[k + 1] - times[k])
    poses = scipy_of(keys)
    expected = screw(poses[k], poses[k + 1], share).as_matrix().reshape(*shape, 4, 4)
    close(dq8.to_matrix(dq8.resample(times, keys, at)), expected, keys)


def test_samples_at_the_times_are_the_poses(rng, random_motions, close):
    keys = keys_along(rng, random_motions, 200)
    times = np.cumsum(0.1 + rng.random(200))
    out = np.empty((200, 8))
    assert dq8.resample(times, keys, times[::-1], out=out) is out
    close(dq8.to_matrix(out), dq8.to_matrix(keys[::-1]), keys)


@pytest.mark.parametrize("width", [1, 2, 5, 66])
@pytest.mark.parametrize("rows", [(), (2,), (2, 3)])
def test_means_of_windows_are_those_of_mean(rng, random_motions, width, rows):
    steps = 0.1 * rng.normal(size=(*rows, 90, 6))
    motions = dq8.mul(random_motions(), dq8.from_twist(steps))
    weights = rng.random(width)
    windows = np.lib.stride_tricks.sliding_window_view(motions, width, axis=-2).swapaxes(-1, -2)
    np.testing.assert_array_equal(dq8.dib_windows(motions, weights, axis=-2), dq8.mean(windows.copy(), weights))


def test_the_logs_from_the_means_of_windows_add_up_to_nothing(rng, random_motions, close):
    motions, weights = keys_along(rng, random_motions, 40, 0.1), np.array([1.0, 3.0, 2.0])
    means = scipy_of(dq8.dib_windows(motions, weights))
    logs = [(means.inv() * scipy_of(motions[i : 38 + i])).as_exp_coords() for i in range(3)]
    # A step of 1e-14 counts as none: half of a logarithm here, for each unit of weight.
    close(sum(w * log for w, log in zip(weights, logs)), 0, motions, bound=2e-14 * weights.sum())


def test_a_window_longer_than_the_trajectory_is_none(random_motions):
    assert dq8.dib_windows(random_motions(4, 3), np.ones(5), axis=1).shape == (4, 0, 8)
    assert dq8.dib_windows(random_motions(5), np.ones(5)).shape == (1, 8)


KEYS = np.tile(dq8.identity(), (5, 1))
TIMES = np.arange(5.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda out: dq8.squad(KEYS, KEYS, KEYS[:, :7], KEYS, 0.5, out=out), r"Expected `control_end` to have shape \(\.\.\., 8\), got \(5, 7\)"),
        (lambda out: dq8.squad(KEYS, KEYS[:3], KEYS, KEYS, 0.5, out=out), r"broadcast.*`start` \(5,\), `control_start` \(3,\)"),
        (lambda out: dq8.squad(KEYS, KEYS, KEYS, KEYS, [0.5] * 4, out=out), r"broadcast.*`t` \(4,\)"),
        (lambda out: dq8.squad_control(KEYS, KEYS, KEYS[:2], out=out), r"broadcast.*`next` \(2,\)"),
        (lambda out: dq8.resample(TIMES[:4], KEYS, TIMES, out=out), r"Expected `poses` to have shape \(4, \.\.\., 8\), got \(5, 8\)"),
        (lambda out: dq8.resample(1.0, KEYS, TIMES, out=out), r"Expected `times` to have shape \(n,\), got \(\)"),
        (lambda out: dq8.resample([], KEYS[:0], TIMES, out=out), r"`poses`: .*at least one pose"),
        (lambda out: dq8.resample([0, 1, 1, 2, 3], KEYS, TIMES, out=out), r"`times`: stamp 2 is 1"),
        (lambda out: dq8.resample([0, 1, np.inf, 2, 3], KEYS, TIMES, out=out), r"`times`: stamp 2 is inf"),
        (lambda out: dq8.resample(TIMES, KEYS, [0, 1, 2, np.nan, 4], out=out), r"`at`: sample 3 .* NaN"),
        (lambda out: dq8.dib_windows(KEYS[0], [1.0], out=out), r"Expected `motions` to have shape \(n, \.\.\., 8\), got \(8,\)"),
        (lambda out: dq8.dib_windows(KEYS, [], out=out), r"Expected `weights` to have shape \(w,\) with w > 0, got \(0,\)"),
        (lambda out: dq8.dib_windows(KEYS, 1.0, out=out), r"Expected `weights` to have shape \(w,\) with w > 0, got \(\)"),
        (lambda out: dq8.dib_windows(KEYS, [1.0, 1.0], out=out), r"Expected `out` to have shape \(4, 8\).*\(5, 8\)"),
    ],
)
def test_errors_name_argument_and_shape_and_leave_out_as_it_was(call, message):
    out = np.full((5, 8), 7.0)
    with pytest.raises(ValueError, match=message):
        call(out)
    assert (out == 7.0).all()
