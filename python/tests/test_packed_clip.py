"""Packed clips: what is sampled, what is kept, and what is refused."""

import pickle

import numpy as np
import pytest

import dq8

FRAMES, JOINTS = 30, 4


def walk():
    """Three joints swing, one keeps still; the first one walks."""
    time = np.arange(FRAMES)[:, np.newaxis]
    speeds = np.array([0.2, 0.1, 0.0, 0.15])
    angles = np.sin(time * speeds) * np.array([0.5, 1.0, 0.0, 2.0])
    half = angles / 2
    turns = np.stack([np.sin(half), 0 * half, 0 * half, np.cos(half)], axis=-1)
    shifts = np.tile([0.0, 0.4, 0.1], (FRAMES, JOINTS, 1))
    shifts[:, 0, 2] = 0.03 * np.arange(FRAMES)
    return dq8.from_rotation_translation(turns, shifts)


def test_sampled_at_frames_and_between():
    frames = walk()
    clip = dq8.PackedClip(frames)
    assert (clip.frames, clip.joints, clip.moving) == (FRAMES, JOINTS, 4)
    np.testing.assert_allclose(clip.sample(np.arange(FRAMES)), frames, atol=6e-5)
    middle = clip.sample(2.5)
    assert middle.shape == (JOINTS, 8) and middle.dtype == np.float64
    wanted = (frames[2] + frames[3]) / 2
    np.testing.assert_allclose(middle[:, :4], dq8.normalize(wanted)[:, :4], atol=6e-5)
    # Beyond the clip are its ends.
    np.testing.assert_array_equal(clip.sample([-3.0, 99.0]), clip.sample([0.0, FRAMES - 1.0]))
    assert clip.sample(np.float32([[1.0, 2.0]])).dtype == np.float32
    out = np.empty((2, JOINTS, 8))
    assert clip.sample([1.0, 2.0], out=out) is out


def test_bytes_come_back_and_others_are_refused():
    clip = dq8.PackedClip(walk())
    data = clip.to_bytes()
    assert len(data) < FRAMES * JOINTS * 28 / 2
    for same in (dq8.PackedClip.from_bytes(data), pickle.loads(pickle.dumps(clip))):
        np.testing.assert_array_equal(same.sample(7.3), clip.sample(7.3))
    with pytest.raises(ValueError, match="at byte 8"):
        dq8.PackedClip.from_bytes(data[:8] + b"\x09" + data[9:])


def test_deviation_is_that_of_models():
    frames, legs = walk(), dq8.Hierarchy([-1, 0, 1, 2])
    clip = dq8.PackedClip(frames)
    worst, p99 = clip.deviation(legs, frames, 0.03)
    assert 0 < p99 <= worst < 1.5e-4
    models = [legs.local_to_model(poses) for poses in (frames, clip.sample(np.arange(FRAMES)))]
    tips = np.eye(3) * 0.03
    points = [dq8.transform_points(m[:, :, np.newaxis], tips) for m in models]
    distances = np.linalg.norm(points[0] - points[1], axis=-1)
    assert worst == pytest.approx(distances.max(), abs=1e-6)


def test_times_are_seconds_and_rounds_follow_each_other():
    frames = walk()
    clip, timed = dq8.PackedClip(frames), dq8.PackedClip(frames, fps=30, loops=True)
    assert (clip.fps, clip.loops, clip.duration) == (1.0, False, FRAMES - 1)
    assert (timed.fps, timed.loops, timed.duration) == (30.0, True, (FRAMES - 1) / 30)
    at = np.array([0.0, 2.25, 17.5])
    np.testing.assert_allclose(timed.sample(at / 30), clip.sample(at), atol=1e-5)
    np.testing.assert_allclose(timed.sample(at / 30 + 3 * timed.duration), clip.sample(at), atol=1e-5)
    out = np.full((3, JOINTS, 8), 7.0)
    for own, time in ((clip, np.nan), (timed, np.nan), (timed, np.inf)):
        with pytest.raises(ValueError, match=f"`at`: sample 1 is asked for at {str(time).replace('nan', 'NaN')}"):
            own.sample([0.0, time, time], out=out)
    assert (out == 7.0).all()
    np.testing.assert_array_equal(clip.sample([-np.inf, np.inf]), clip.sample([0, FRAMES - 1]))
    for rate in (0, -30, np.nan):
        with pytest.raises(ValueError, match="frames a second, which must be a positive number"):
            dq8.PackedClip(frames, fps=rate)


def test_a_turn_of_a_half_turn_has_frames_between():
    frames = walk()
    frames[5, 1] = dq8.from_rotation_translation([0, 1.0, 0, 0], [0.0, 0.4, 0.1])
    clip = dq8.PackedClip(frames, fps=30)
    assert (clip.frames, clip.fps) == (FRAMES, 30) and clip.duration == pytest.approx((FRAMES - 1) / 30)
    turned = dq8.angle_to(clip.sample(np.arange(FRAMES) / 30), frames)
    assert turned.max() < 1e-4
    worst, _ = clip.deviation(dq8.Hierarchy([-1, 0, 1, 2]), frames, 0.03)
    assert worst < 1.5e-4


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("loops", [False, True])
def test_an_error_is_bounded_where_a_bound_is_asked_for(dtype, loops):
    frames = walk()
    frames[:, 2] = dq8.mul(dq8.from_translation(np.linspace(0, 1, FRAMES)[:, np.newaxis] * [1e6, 2e5, 0]), frames[:, 2])
    frames = frames.astype(dtype)
    clip = dq8.PackedClip(frames, fps=30, loops=loops, max_error=1e6 * 2**-16)
    at = np.arange(FRAMES - loops)
    error = dq8.distance_to(clip.sample(at / 30), frames[at]).max(axis=0)
    # Half a step along each axis, and what float32 has lost of the way.
    assert error.max() == error[2] <= (np.sqrt(3) / 2 + 0.1) * 1e6 * 2**-16
    with pytest.raises(ValueError, match=r"`max_error`: packing moves joint 2 by up to \S+, more than 1\.00e-3, because it goes far"):
        dq8.PackedClip(frames, fps=30, loops=loops, max_error=1e-3)
    for wrong in (-1.0, np.nan):
        with pytest.raises(ValueError, match="Expected `max_error` to be a length"):
            dq8.PackedClip(frames, max_error=wrong)


@pytest.mark.parametrize(("name", "kind"), [("angle", "an angle"), ("length", "a length")])
@pytest.mark.parametrize("wrong", [-1.0, np.nan])
def test_a_limit_that_no_track_is_within_is_refused(name, kind, wrong):
    with pytest.raises(ValueError, match=f"Expected `{name}` to be {kind}, got"):
        dq8.PackedClip(walk(), **{name: wrong})


@pytest.mark.parametrize("frames", [walk()[:0], walk()[:, :0]])
def test_a_clip_without_frames_or_joints_is_refused_by_the_name_of_its_argument(frames):
    with pytest.raises(ValueError, match="`frames` to have shape .* with a frame and a joint at least, got"):
        dq8.PackedClip(frames)


def test_what_cannot_be_held_is_named():
    frames = walk()
    for at, message in (((3, 1, 0), "joint 1"), ((3, 1, 5), "joint 1")):
        wrong = frames.copy()
        wrong[at] = np.nan
        with pytest.raises(ValueError, match=message):
            dq8.PackedClip(wrong)
    with pytest.raises(ValueError, match="frames"):
        dq8.PackedClip(frames[0])
