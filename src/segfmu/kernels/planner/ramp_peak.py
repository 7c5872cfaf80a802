"""The extreme velocity inside a ramp whose acceleration changes sign."""

from math import sqrt

from segfmu.kernels.planner.records import Axis


def curved_part(s: float, axis: 'float[:]') -> 'tuple[float, float, float]':
    """Polynomial of the curved part at s, its derivative and its integral from 0."""
    if axis[Axis.SNAP_SHARE] > 0.0:
        if s > 0.5:
            # the rise is symmetric: the gain from s on follows from the gain up to 1 - s
            value, slope, integral = snap_plateau_half(1.0 - s, axis)
            middle, rate, half = snap_plateau_half(0.5, axis)
            whole = 2.0 * half + 0.125
            return (
                s - 0.5 + value,
                1.0 - slope,
                whole - 0.5 * s * (1.0 - s) - integral,
            )
        return snap_plateau_half(s, axis)
    count = int(axis[Axis.CURVE_SIZE])
    value = 0.0
    slope = 0.0
    integral = 0.0
    for j in range(count):
        i = count - 1 - j
        value = value * s + axis[Axis.CURVE + i]
        integral = integral * s + axis[Axis.CURVE + i] / (i + 1.0)
        if i > 0:
            slope = slope * s + i * axis[Axis.CURVE + i]
    return value, slope, integral * s


def snap_plateau_half(s: float, axis: 'float[:]') -> 'tuple[float, float, float]':
    """`curved_part` for s <= 1/2 of a jerk rise whose snap has a plateau."""
    share = axis[Axis.SNAP_SHARE]
    count = int(axis[Axis.CURVE_SIZE])
    peak = 1.0 / (1.0 - share)
    u = min(s / share, 1.0)
    first = 0.0
    second = 0.0
    third = 0.0
    for j in range(count):
        i = count - 1 - j
        first = first * u + axis[Axis.CURVE + i] / (i + 1.0)
        second = second * u + axis[Axis.CURVE + i] / ((i + 1.0) * (i + 2.0))
        third = third * u + axis[Axis.CURVE + i] / ((i + 1.0) * (i + 2.0) * (i + 3.0))
    first = peak * share * u * first
    second = peak * share * share * u * u * second
    third = peak * share * share * share * u * u * u * third
    rest = max(s - share, 0.0)
    return (
        second + first * rest + 0.5 * peak * rest * rest,
        first + peak * rest,
        third + second * rest + 0.5 * first * rest * rest + peak * rest * rest * rest / 6.0,
    )


def invert_curved_part(value: float, upper: float, axis: 'float[:]') -> float:
    """The s in [0, upper] at which the increasing curved part, 1/2 at `upper`, has the given value.

    The accuracy suffices for an extremum, whose error is of second order in that of s. The curved
    part is nearly a square at its upper end.
    """
    low = 0.0
    high = upper
    s = upper * sqrt(min(max(2.0 * value, 0.0), 1.0))
    for i in range(100):
        at, slope, integral = curved_part(s, axis)
        if at > value:
            high = s
        else:
            low = s
        step = 0.5 * (low + high) - s
        if slope > 0.0:
            newton = (value - at) / slope
            if s + newton > low and s + newton < high:
                step = newton
        s = s + step
        if abs(step) <= 1e-9:
            return s
    return s


def ramp_extreme_velocity(
    v: float, a: float, b: float, duration: float, rise: float, axis: 'float[:]'
) -> float:
    """Velocity where the acceleration of a ramp from a to b, of opposite signs, is zero."""
    if abs(a) > abs(b):
        # the symmetric ramp, run backwards from its end, crosses zero in its first half
        return ramp_extreme_velocity_first_half(
            v + 0.5 * (a + b) * duration, -b, -a, duration, rise, axis
        )
    return ramp_extreme_velocity_first_half(v, a, b, duration, rise, axis)


def ramp_extreme_velocity_first_half(
    v: float, a: float, b: float, duration: float, rise: float, axis: 'float[:]'
) -> float:
    """`ramp_extreme_velocity` for |a| <= |b|."""
    if axis[Axis.PLATEAU] < 0.5:
        if axis[Axis.CURVE_SIZE] == 2.0:
            return v - 0.5 * a * a * duration / (b - a)
        s = invert_curved_part(a / (a - b), 0.5, axis)
        value, slope, integral = curved_part(s, axis)
        return v + duration * (a * s + (b - a) * integral)
    jerk = (b - a) / (duration - rise)
    if abs(a) <= 0.5 * abs(jerk) * rise:
        s = invert_curved_part(-a / (jerk * rise), 1.0, axis)
        value, slope, integral = curved_part(s, axis)
        return v + rise * (a * s + jerk * rise * integral)
    value, slope, integral = curved_part(1.0, axis)
    start = a + 0.5 * jerk * rise
    return v + rise * (a + jerk * rise * integral) - 0.5 * start * start / jerk
