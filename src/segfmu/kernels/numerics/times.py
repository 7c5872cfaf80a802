"""Times that are given as parameters."""

from segfmu.kernels.numerics.records import GivenTime


def begin_time(given: float, start: float) -> float:
    """When something begins [s]: at a time that is given, or at the start of the simulation.

    given: `GivenTime.AT_START` for the start [s].
    """
    if given <= GivenTime.AT_START:
        return start
    return given
