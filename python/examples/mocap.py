"""A clip of 19 joints: shaken, smoothed in time, resampled, posed."""

import numpy as np

import dq8

rng = np.random.default_rng(1)
parents = [None, 0, 1, 2, 3, 0, 5, 6, 7, 0, 9, 10, 11, 10, 13, 14, 10, 16, 17]
skeleton = dq8.Hierarchy(parents)
frames, times = 600, np.arange(600) / 60

# Each joint swings about an axis of its own: (frames, joints, 8).
swing = 0.4 * np.sin(2 * np.pi * times[:, None] + np.linspace(0, 3, len(parents)))
offsets = dq8.from_translation(0.3 * rng.normal(size=(len(parents), 3)))
clip = dq8.mul(offsets, dq8.from_axis_angle(rng.normal(size=(len(parents), 3)), swing))

shaken = dq8.mul(clip, dq8.from_twist(0.02 * rng.normal(size=(*clip.shape[:-1], 6))))
calm = dq8.dib_windows(shaken, [1, 2, 3, 2, 1], axis=0)  # in time: joints stay apart
off = [dq8.angle_to(path, clip[2:-2]).mean() for path in (shaken[2:-2], calm)]
print(f"off by {off[0]:.4f} radians, smoothed {off[1]:.4f}")
assert off[1] < 0.6 * off[0]

slow = dq8.resample(times[2:-2], calm, np.linspace(1, 2, 240))  # a second in 240 frames
poses = skeleton.local_to_model(slow)
print("the head goes from", dq8.translation(poses[[0, -1], 12]).round(2).tolist())
packed = dq8.PackedClip(calm)
print(f"packed: {len(packed.to_bytes())} bytes of {calm.nbytes}")
