"""The motion of a person on a humanoid robot: from files of motion capture and a URDF file to joint values for each frame.

`load` reads a clip, `Humanoid` a robot, and `retarget` brings one on the other, by the Rust crate dq8-retarget: feet that
stand are held on the ground, the motion is smooth, and shapes that meet are pushed apart. `save` writes what trainers read,
and `archive` does all of it with many files. No simulator and no GPU is needed.

    >>> import numpy as np
    >>> from dq8 import retarget as rt
    >>> rt.settings()["fps"]
    30.0

A session::

    robot = rt.Humanoid("g1.urdf")                          # print(robot) lists which link is a knee
    motion = rt.retarget(rt.load("walk.bvh"), robot, fps=50)
    motion.report["slide"]                                  # of standing feet, mm/s
    rt.save(motion, "walk.npz", bodies=["pelvis", "torso_link"])
    rt.archive("clips/**/*.bvh", robot, "motions", fps=50)
"""

from ._core import Person
from ._motion_archives import archive
from ._motion_files import save
from ._motions import Humanoid, Motion, Report, report, retarget, settings
from ._people import body_model, load, positions

__all__ = ["Humanoid", "Motion", "Person", "Report", "archive", "body_model", "load", "positions", "report", "retarget", "save", "settings"]

# Private modules are no part of the names in pickles.
for _kind in (Humanoid, Motion, Report):
    _kind.__module__ = __name__
