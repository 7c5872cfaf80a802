"""Duration, change and distance of an acceleration ramp, from the parameters of its axis.

The duration is a maximum of powers of the change (parameters.py), and inverted in closed form.
"""

from math import sqrt

from segfmu.kernels.planner.records import Axis


def slowest_root(change: float, first: int, axis: 'float[:]') -> 'tuple[float, float]':
    """max over e >= first of (q_e change)^(1/e), and its derivative with the change."""
    slowest = 0.0
    exponent = 1
    if first <= 1 and axis[Axis.POWERS] > 0.0:
        slowest = axis[Axis.POWERS] * change
    if axis[Axis.POWERS + 1] > 0.0:
        root = sqrt(axis[Axis.POWERS + 1] * change)
        if root > slowest:
            slowest = root
            exponent = 2
    for e in range(3, 9):
        if axis[Axis.POWERS + e - 1] > 0.0:
            root = (axis[Axis.POWERS + e - 1] * change) ** (1.0 / e)
            if root > slowest:
                slowest = root
                exponent = e
    return slowest, slowest / (exponent * change)


def ramp_duration(change: float, axis: 'float[:]') -> 'tuple[float, float, float]':
    """Duration of the ramp for an acceleration change >= 0, duration of its jerk rise [s], and the
    derivative of the former with respect to the change (0 for no change, where it is infinite)."""
    if change <= 0.0:
        return 0.0, 0.0, 0.0
    if axis[Axis.LINEAR_FROM] >= 0.0 and change >= axis[Axis.LINEAR_FROM]:
        slope = axis[Axis.LINEAR_SLOPE]
        duration = change * slope + axis[Axis.LINEAR_CONSTANT]
        return duration, axis[Axis.RISE] + axis[Axis.RISE_SHARE] * duration, slope
    if axis[Axis.PLATEAU] < 0.5:
        root, slope = slowest_root(change, 1, axis)
        return root, 0.0, slope
    root, slope = slowest_root(change, 2, axis)
    return 2.0 * root, root, 2.0 * slope


def ramp_rise(duration: float, axis: 'float[:]') -> float:
    """Duration of the jerk rise of the ramp that lasts `duration`."""
    if axis[Axis.PLATEAU] < 0.5:
        return 0.0
    if axis[Axis.LINEAR_FROM] >= 0.0 and duration >= 2.0 * axis[Axis.RISE]:
        return axis[Axis.RISE] + axis[Axis.RISE_SHARE] * duration
    return 0.5 * duration


def fastest_power(duration: float, first: int, axis: 'float[:]') -> 'tuple[float, float]':
    """Inverse of `slowest_root`: min over e >= first of duration^e / q_e, and its derivative."""
    fastest = -1.0
    exponent = 1
    power = 1.0
    for e in range(1, 9):
        power = power * duration
        if e >= first and axis[Axis.POWERS + e - 1] > 0.0:
            change = power / axis[Axis.POWERS + e - 1]
            if fastest < 0.0 or change < fastest:
                fastest = change
                exponent = e
    return fastest, exponent * fastest / duration


def ramp_change(duration: float, axis: 'float[:]') -> 'tuple[float, float]':
    """Inverse of `ramp_duration`: the acceleration change of a ramp, and its derivative with
    the duration. Small ramps are solved for in their duration, which loses no digits."""
    if duration <= 0.0:
        return 0.0, 0.0
    start = axis[Axis.LINEAR_FROM]
    if start >= 0.0:
        slope = axis[Axis.LINEAR_SLOPE]
        constant = axis[Axis.LINEAR_CONSTANT]
        if duration >= start * slope + constant:
            return (duration - constant) / slope, 1.0 / slope
    if axis[Axis.PLATEAU] < 0.5:
        return fastest_power(duration, 1, axis)
    change, growth = fastest_power(0.5 * duration, 2, axis)
    return change, 0.5 * growth


def ramp_distance(
    v: float, a: float, b: float, duration: float, rise: float, axis: 'float[:]'
) -> float:
    """Distance covered by the ramp from acceleration a to b that starts with velocity v."""
    flat = duration - rise
    variance = axis[Axis.FLAT_VARIANCE] * flat * flat + axis[Axis.RISE_VARIANCE] * rise * rise
    return (
        v * duration
        + 0.5 * a * duration * duration
        + (b - a) * (0.125 * duration * duration + 0.5 * variance)
    )
