"""Duration, change and distance of an acceleration ramp, from the parameters of its axis.

Smoothstep: the duration is a maximum of powers of the change (parameters.py). Plateau: the jerk
rises to its peak within a rise, stays, and falls; within that rise the snap does the same, and so
on up to the derivative n + 1, which is constant in each piece. If the rises last x_0 = duration,
x_1, .., the widths w_i = x_i - x_{i+1} (the last one is its rise) are those of boxes whose
convolution is the jerk. So the derivative 2 + j has the peak change / (w_0 .. w_{j-1}), and the
jerk's variance is the sum of w_i^2 / 12. A rise is at most half of the one it belongs to.
"""

from math import sqrt

from segfmu.kernels.numerics.numbers import HALVINGS, LAST_DIGIT
from segfmu.kernels.planner.records import Axis


def inner_rise(rise: float, level: int, axis: 'float[:]') -> float:
    """Duration of the rises within a rise of the derivative 2 + level, 3 + level for the ramp."""
    return min(max(axis[Axis.RISES + level], axis[Axis.SHARES + level] * rise), 0.5 * rise)


def shifted_root(value: float, power: int, shift: float) -> float:
    """The x > shift at which x^power (x - shift) has the value."""
    if power == 0:
        return value + shift
    if power == 1:
        return 0.5 * (shift + sqrt(shift * shift + 4.0 * value))
    x = shift + value ** (1.0 / (power + 1))
    for i in range(HALVINGS):
        x_power = 1.0
        for j in range(power - 1):
            x_power = x_power * x
        error = x_power * x * (x - shift) - value
        step = error / (x_power * (power * (x - shift) + x))
        # convex, and begun above the root
        if step <= LAST_DIGIT * x:
            break
        x = x - step
    return x


def plateau_duration(change: float, first: int, axis: 'float[:]') -> 'tuple[float, float]':
    """Duration of the fastest rise by `change` [s] of the derivative 2 + first, and its slope.

    The least derivative that reaches its limit c is found first. With x the duration of its rise,
    and all rises below it triangles, the change is a power of x times c (x - the rise within).
    """
    boxes = int(axis[Axis.SMOOTHNESS]) - 1
    factor, doubled = 1.0, 1.0
    for level in range(first, boxes):
        limit = axis[Axis.JERK + level]
        least = axis[Axis.RISES + level]
        share = axis[Axis.SHARES + level]
        power = level - first
        x_power = 1.0
        for j in range(power):
            x_power = x_power * 2.0 * least
        if limit > 0.0 and change >= factor * x_power * limit * least:
            value = change / (factor * limit)
            x = 0.0
            if share > 0.0:
                x = value / (1.0 - share)
                if power == 1:
                    x = sqrt(x)
                elif power > 1:
                    x = x ** (1.0 / (power + 1))
            if share == 0.0 or share * x < least:
                if least > 0.0 or power == 0:
                    x = shifted_root(value, power, least)
                elif power == 1:
                    x = sqrt(value)
                else:
                    x = value ** (1.0 / (power + 1))
                rest = x - least
                return doubled * x, doubled * x * rest / (change * (power * rest + x))
            return doubled * x, doubled * x / ((power + 1) * change)
        factor = factor * doubled
        doubled = 2.0 * doubled
    return 0.0, 0.0


def plateau_change(duration: float, first: int, axis: 'float[:]') -> 'tuple[float, float]':
    """Inverse of `plateau_duration`, and its derivative with the duration."""
    boxes = int(axis[Axis.SMOOTHNESS]) - 1
    x = duration
    factor, doubled = 1.0, 1.0
    for level in range(first, boxes):
        least = axis[Axis.RISES + level]
        if x >= 2.0 * least:
            share = axis[Axis.SHARES + level]
            power = level - first
            steepest = factor * axis[Axis.JERK + level]
            for j in range(power):
                steepest = steepest * x
            if share * x >= least:
                change = steepest * (1.0 - share) * x
                return change, (power + 1) * change / duration
            change = steepest * (x - least)
            return change, (power * change + steepest * x) / duration
        x = 0.5 * x
        factor = factor * doubled
        doubled = 2.0 * doubled
    return 0.0, 0.0


def slowest_root(change: float, axis: 'float[:]') -> 'tuple[float, float]':
    """max over e of (q_e change)^(1/e), and its derivative with the change."""
    slowest = axis[Axis.POWERS] * change
    exponent = 1
    if axis[Axis.POWERS + 1] > 0.0:
        root = sqrt(axis[Axis.POWERS + 1] * change)
        if root > slowest:
            slowest = root
            exponent = 2
    for e in range(3, 6):
        if axis[Axis.POWERS + e - 1] > 0.0:
            root = (axis[Axis.POWERS + e - 1] * change) ** (1.0 / e)
            if root > slowest:
                slowest = root
                exponent = e
    return slowest, slowest / (exponent * change)


def fastest_power(duration: float, axis: 'float[:]') -> 'tuple[float, float]':
    """Inverse of `slowest_root`: min over e of duration^e / q_e, and its derivative."""
    fastest, exponent, power = -1.0, 1, 1.0
    for e in range(1, 6):
        power = power * duration
        if axis[Axis.POWERS + e - 1] > 0.0:
            change = power / axis[Axis.POWERS + e - 1]
            if fastest < 0.0 or change < fastest:
                fastest = change
                exponent = e
    return fastest, exponent * fastest / duration


def ramp_duration(change: float, axis: 'float[:]') -> 'tuple[float, float]':
    """Duration of the fastest ramp for an acceleration change >= 0 [s], and its derivative with
    the change (0 for no change, where it is infinite)."""
    if change <= 0.0:
        return 0.0, 0.0
    if change >= axis[Axis.LINEAR_FROM]:
        slope = axis[Axis.LINEAR_SLOPE]
        return change * slope + axis[Axis.LINEAR_CONSTANT], slope
    if axis[Axis.SQUARE] > 0.0:
        duration = sqrt(axis[Axis.SQUARE] * change)
        return duration, 0.5 / change * duration
    if axis[Axis.PLATEAU] == 0.0:
        return slowest_root(change, axis)
    return plateau_duration(change, 0, axis)


def ramp_change(duration: float, axis: 'float[:]') -> 'tuple[float, float]':
    """Inverse of `ramp_duration`: the acceleration change of a ramp, and its derivative with
    the duration. Small ramps are solved for in their duration, which loses no digits."""
    if duration <= 0.0:
        return 0.0, 0.0
    if axis[Axis.SQUARE] > 0.0:
        if axis[Axis.LINEAR_SLOPE] > 0.0 and duration >= 2.0 * axis[Axis.RISES]:
            slope = axis[Axis.LINEAR_RATE]
            return (duration - axis[Axis.LINEAR_CONSTANT]) * slope, slope
        slope = duration * axis[Axis.SQUARE_RATE]
        return slope * duration, 2.0 * slope
    if axis[Axis.PLATEAU] == 0.0:
        return fastest_power(duration, axis)
    return plateau_change(duration, 0, axis)


def ramp_variance(basis: float, axis: 'float[:]') -> float:
    """Variance of the jerk over time, seen as a density, of the fastest ramp that lasts `basis`."""
    if axis[Axis.LINEAR_SLOPE] > 0.0 and axis[Axis.PLATEAU] != 0.0:
        rise = axis[Axis.RISES]
        if basis >= 2.0 * rise and axis[Axis.SHARES] == 0.0:
            box = basis - rise
            return box * box / 12.0 + axis[Axis.INNER_VARIANCE]
    if axis[Axis.VARIANCE] > 0.0:
        return axis[Axis.VARIANCE] * basis * basis
    variance, fourth = rise_moments(basis, 0, axis)
    return variance


def rise_moments(duration: float, first: int, axis: 'float[:]') -> 'tuple[float, float]':
    """Variance and fourth cumulant over time of the fastest rise of the derivative 2 + first.

    They are those of its slope, seen as a density: sums over its boxes.
    """
    rise = duration
    squares, fourths = 0.0, 0.0
    for level in range(first, int(axis[Axis.SMOOTHNESS]) - 2):
        inner = inner_rise(rise, level, axis)
        square = (rise - inner) * (rise - inner)
        squares = squares + square
        fourths = fourths + square * square
        rise = inner
    square = rise * rise
    return (squares + square) / 12.0, -(fourths + square * square) / 120.0


def ramp_distance(
    v: float, a: float, b: float, duration: float, basis: float, axis: 'float[:]'
) -> float:
    """Distance covered by the ramp from acceleration a to b that starts with velocity v.

    basis: duration of the fastest ramp with the same proportions; shorter if it is stretched.
    """
    y = (v + 0.5 * a * duration) * duration
    if b == a:
        return y
    variance = ramp_variance(basis, axis)
    if duration != basis:
        variance = variance * (duration / basis) * (duration / basis)
    return y + (b - a) * (0.125 * duration * duration + 0.5 * variance)
