"""Seconds of CPU time that evo takes for two files of TUM's format, imports apart, and its figures: `figures_of_evo.py REFERENCE ESTIMATE`.

Stamps are sorted and of equal ones the first is kept, as dq8 does it: evo takes them as they come, which changes its pairs.
"""

import sys
import time

import numpy as np
from evo.core import metrics, sync
from evo.tools import file_interface

NAMES = ("rmse", "mean", "median", "std", "min", "max", "sse")


def figures():
    paths = []
    for name in sys.argv[1:]:
        path = file_interface.read_tum_trajectory_file(name)
        path.reduce_to_ids(np.unique(path.timestamps, return_index=True)[1])
        paths.append(path)
    reference, estimate = sync.associate_trajectories(*paths, max_diff=0.01)
    estimate.align(reference)
    steps = {"delta": 1, "delta_unit": metrics.Unit.frames}
    all_of_them = (
        metrics.APE(metrics.PoseRelation.translation_part),
        metrics.RPE(metrics.PoseRelation.translation_part, **steps),
        metrics.RPE(metrics.PoseRelation.rotation_angle_rad, **steps),
    )
    for metric in all_of_them:
        metric.process_data((reference, estimate))
    return [metric.get_all_statistics()[name] for metric in all_of_them for name in NAMES]


least = np.inf
for _ in range(3):
    begin = time.process_time()
    found = figures()
    least = min(least, time.process_time() - begin)
print(least, *map(repr, map(float, found)), sep="\n")
