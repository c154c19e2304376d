"""How searches of inverse kinematics end."""

from enum import IntEnum


class Outcome(IntEnum):
    """How a search of `Mechanism.reach` ended: the numbers in ``ReachReport.outcome``."""

    CONVERGED = 0
    """The errors are within the tolerances."""
    OUT_OF_REACH = 1
    """The target is farther away than the robot is long."""
    AT_LIMITS = 2
    """No way led nearer, and a joint is at its limit."""
    STALLED = 3
    """No way led nearer: a local minimum, or a pose out of reach."""
    UNFINISHED = 4
    """The iterations were used up while links still came nearer."""
    INVALID = 5
    """The target is not unit, or a number is not finite; the values are the start."""
