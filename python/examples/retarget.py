"""The motion of a person on a humanoid robot: python retarget.py robot.urdf walk.bvh [more.bvh ...]."""

import sys
import tempfile
from pathlib import Path

import numpy as np

from dq8 import retarget as rt

robot = rt.Humanoid(sys.argv[1])
print(robot)  # which link is a knee

motion = rt.retarget(rt.load(sys.argv[2]), robot, fps=50)
print(motion, motion.report, sep="\n")
print("left foot stands in", f"{motion.contacts[:, 0].mean():.0%} of frames")

with tempfile.TemporaryDirectory() as folder:
    rt.save(motion, Path(folder, "walk.npz"), joints=robot.joints, bodies=["pelvis", "left_foot"])
    with np.load(Path(folder, "walk.npz")) as file:
        print({name: file[name].shape for name in file})

    # A file for each clip, and a table of measures; called again, it goes on where it was.
    table = rt.archive(sys.argv[2:], robot, Path(folder, "motions"), format="gmr")
    print(table.select(["file", "frames", "residual", "slide", "jerk"]).to_pylist())
