"""Ranges of parameters."""

from segfmu.kernels.numerics.records import RangeFault, RangeStatus


def check_range(value: float, least: float, most: float, fault: 'float[:]') -> int:
    """Whether a value is within its range; a `RangeStatus`."""
    fault[RangeFault.VALUE] = value
    fault[RangeFault.LEAST] = least
    fault[RangeFault.MOST] = most
    if value >= least and value <= most:
        return RangeStatus.INSIDE
    if most > 1.7976931348623157e308:
        return RangeStatus.BELOW
    if least < -1.7976931348623157e308:
        return RangeStatus.ABOVE
    return RangeStatus.OUTSIDE
