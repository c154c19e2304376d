"""Robots to test with, and values of their joints."""

from pathlib import Path

import numpy as np

import dq8

ROBOTS = Path(__file__).parents[2] / "robot" / "robots"


def random_values(mechanism: dq8.Mechanism, rng: np.random.Generator, *shape: int) -> np.ndarray:
    """Configurations within the limits."""
    low, high = np.clip(mechanism.limits, -3, 3).T
    return rng.uniform(low, high, size=(*shape, len(low)))
