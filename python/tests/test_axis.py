"""`axis`: along the dimension that is asked for, the same as along the last but one after moving it there."""

import warnings

import numpy as np
import pytest
from calls import neighbours

import dq8

TIMES = np.cumsum([0.5, 1, 0.25, 2, 1, 1, 0.5])
AT = np.array([[0.4, 1.0, 7.0], [2.2, 3.3, 0.9]])
SHAPE = (7, 4, 3)

# Along the first dimension of (frames, joints, 8), by hand: joint after joint.
CALLS = {
    "dib_windows": lambda motions, **options: dq8.dib_windows(motions, np.array([1, 2, 1], motions.dtype), **options),
    "resample": lambda motions, **options: dq8.resample(TIMES.astype(motions.dtype), motions, AT[0].astype(motions.dtype), **options),
    "chain_products": dq8.chain_products,
}


@pytest.fixture
def clip(rng):
    return neighbours(rng, *SHAPE)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("name", CALLS)
def test_by_default_frames_of_a_clip_follow_each_other_and_joints_do_not_mix(clip, name, dtype):
    clip = clip[:, :, 0].astype(dtype)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = CALLS[name](clip)
    assert result.dtype == dtype
    for joint in range(4):
        np.testing.assert_array_equal(result[:, joint], CALLS[name](clip[:, joint].copy()))


@pytest.mark.parametrize("axis", [0, 1, 2, -2, -3, -4])
@pytest.mark.parametrize("name", CALLS)
def test_every_axis_is_that_of_moved_arrays(clip, name, axis):
    moved = np.moveaxis(clip, 0, axis)
    expected = np.moveaxis(CALLS[name](clip, axis=0), 0, axis)
    result = CALLS[name](moved, axis=axis)
    np.testing.assert_array_equal(result, expected)
    out = np.full(expected.shape, 7.0)
    assert CALLS[name](moved, axis=axis, out=out) is out
    np.testing.assert_array_equal(out, expected)
    with pytest.raises(ValueError, match=r"Expected `out` to have shape \(.*\), that of the result, got \(1, 8\)"):
        CALLS[name](moved, axis=axis, out=np.empty((1, 8)))


@pytest.mark.parametrize("mean", [dq8.mean, dq8.dlb])
def test_blends_along_every_axis_with_weights_that_are_shared_or_their_own(clip, rng, mean):
    own = rng.random(SHAPE)
    for axis in (0, 1, 2, -2, -3):
        moved = np.moveaxis(clip, axis, -2).copy()
        weights = np.moveaxis(own, axis if axis >= 0 else axis + 1, -1).copy()
        np.testing.assert_array_equal(mean(clip, axis=axis), mean(moved))
        np.testing.assert_array_equal(mean(clip, own, axis=axis), mean(moved, weights))
        shared = weights[0, 0]
        out = np.empty((*moved.shape[:-2], 8))
        np.testing.assert_array_equal(mean(clip, shared, axis=axis, out=out), mean(moved, shared))


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_the_shape_of_samples_stands_where_time_was(clip, axis):
    moved = np.moveaxis(clip, 0, axis)
    result = dq8.resample(TIMES, moved, AT, axis=axis)
    rest = list(SHAPE[1:])
    assert result.shape == (*rest[:axis], 2, 3, *rest[axis:], 8)
    one = dq8.resample(TIMES, moved, AT[1, 2], axis=axis)
    np.testing.assert_array_equal(one, result[(slice(None),) * axis + (1, 2)])


def test_running_products_are_products(clip, close):
    motions = clip[:, 0, 0]
    expected = motions[0]
    for step, product in zip(motions[1:], dq8.chain_products(motions)[1:]):
        expected = dq8.mul(expected, step)
        close(dq8.to_matrix(product), dq8.to_matrix(expected), clip, bound=1e-13)


@pytest.mark.parametrize("name", [*CALLS, "mean"])
@pytest.mark.parametrize("axis", [3, -1, -5, 2**62])
def test_an_axis_that_is_no_leading_dimension_is_refused(clip, name, axis):
    call = CALLS.get(name, dq8.mean)
    with pytest.raises(ValueError, match=rf"Expected `axis` to be a leading dimension of `(motions|poses)`.*got {axis}"):
        call(clip, axis=axis)


@pytest.mark.parametrize("name", CALLS)
def test_nothing_along_an_axis_gives_nothing(clip, name):
    assert CALLS[name](clip[:, :0], axis=0).size == 0


def test_threads_change_nothing(one_thread, rng):
    clip = neighbours(rng, 300, 40)
    times = np.arange(300.0)
    calls = [
        lambda: dq8.chain_products(clip),
        lambda: dq8.resample(times, clip, times[::-1] * 0.9),
        lambda: dq8.dib_windows(clip, [1, 2, 1], axis=0),
    ]
    dq8.set_num_threads(1)
    alone = [call() for call in calls]
    dq8.set_num_threads(3)
    for call, expected in zip(calls, alone):
        np.testing.assert_array_equal(call(), expected)
