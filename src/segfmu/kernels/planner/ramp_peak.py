"""The extreme velocity inside a ramp whose acceleration changes sign."""

from math import sqrt

from segfmu.kernels.numerics.numbers import HALF_DIGITS, HALVINGS
from segfmu.kernels.planner.nested import held_level, piece_peak, rise_pieces
from segfmu.kernels.planner.ramp import inner_rise
from segfmu.kernels.planner.records import Axis


def curved_part(s: float, axis: 'float[:]') -> 'tuple[float, float, float]':
    """The transition polynomial at s, its derivative and its integral from 0."""
    count = int(axis[Axis.CURVE_SIZE])
    value, slope, integral = 0.0, 0.0, 0.0
    for j in range(count):
        i = count - 1 - j
        value = value * s + axis[Axis.CURVE + i]
        integral = integral * s + axis[Axis.CURVE + i] / (i + 1.0)
        if i > 0:
            slope = slope * s + i * axis[Axis.CURVE + i]
    return value, slope, integral * s


def invert_curved_part(value: float, upper: float, axis: 'float[:]') -> float:
    """The s in [0, upper] at which the transition polynomial, 1/2 at `upper`, has the given value.

    The accuracy suffices for an extremum, whose error is of second order in that of s. The
    polynomial is nearly a square at its upper end.
    """
    low = 0.0
    high = upper
    s = upper * sqrt(min(max(2.0 * value, 0.0), 1.0))
    for i in range(HALVINGS):
        at, slope, integral = curved_part(s, axis)
        if at > value:
            high = s
        else:
            low = s
        step = 0.5 * (low + high) - s
        if slope > 0.0:
            newton = (value - at) / slope
            if s + newton >= low and s + newton <= high:
                step = newton
        s = s + step
        if abs(step) <= HALF_DIGITS:
            return s
    return s


def extreme_gain(a: float, b: float, duration: float, basis: float, axis: 'float[:]') -> float:
    """Bound of the change of the velocity to the extreme one of a ramp that crosses zero.

    It changes from the end of the smaller acceleration, less than half of the ramp away. From there
    the acceleration falls ever faster to the middle of the ramp: it is below the tangent there.
    """
    smaller = min(abs(a), abs(b))
    if axis[Axis.PLATEAU] == 0.0:
        return 0.5 * smaller * duration
    # the reciprocal of the steepest jerk
    slowness = (basis - inner_rise(basis, 0, axis)) * (duration / basis) / abs(b - a)
    return 0.5 * smaller * (duration + (smaller - abs(b - a)) * slowness)


def ramp_extreme_velocity(
    v: float, a: float, b: float, duration: float, basis: float, axis: 'float[:]'
) -> float:
    """Velocity where the acceleration of a ramp from a to b, of opposite signs, is zero."""
    start = v
    first = a
    change = b - a
    if abs(a) > abs(b):
        # the symmetric ramp, run backwards from its end, crosses zero in its first half
        start = v + 0.5 * (a + b) * duration
        first = -b
    if axis[Axis.PLATEAU] != 0.0:
        return plateau_extreme_velocity(start, first, change, duration, basis, axis)
    if axis[Axis.CURVE_SIZE] == 2.0:
        return start - 0.5 * first * first * duration / change
    s = invert_curved_part(-first / change, 0.5, axis)
    value, slope, integral = curved_part(s, axis)
    return start + duration * (first * s + change * integral)


def plateau_extreme_velocity(
    v: float, a: float, change: float, duration: float, basis: float, axis: 'float[:]'
) -> float:
    """`ramp_extreme_velocity` of a plateau ramp that crosses zero in its first half."""
    boxes = int(axis[Axis.SMOOTHNESS]) - 1
    jerk, snap, crackle, pop = 0.0, 0.0, 0.0, 0.0
    highest = 0.0
    pieces = rise_pieces(boxes)
    for piece in range(1, pieces + 1):
        level, sign = held_level(piece, boxes)
        length, peak = piece_peak(level, 0, change, duration, basis, axis)
        if level == 0:
            jerk, snap, crackle, pop, highest = sign * peak, 0.0, 0.0, 0.0, 0.0
        elif level == 1:
            snap, crackle, pop, highest = sign * peak, 0.0, 0.0, 0.0
        elif level == 2:
            crackle, pop, highest = sign * peak, 0.0, 0.0
        elif level == 3:
            pop, highest = sign * peak, 0.0
        else:
            highest = sign * peak
        end = length
        gain = taylor(end, jerk, snap, crackle, pop, highest)
        crossed = (a + gain) * change >= 0.0
        if crossed:
            end = crossing_time(a, length, jerk, snap, crackle, pop, highest)
        v = v + end * a
        v = v + end * taylor(end, jerk / 2.0, snap / 3.0, crackle / 4.0, pop / 5.0, highest / 6.0)
        if crossed:
            return v
        a = a + gain
        jerk = jerk + taylor(length, snap, crackle, pop, highest, 0.0)
        snap = snap + taylor(length, crackle, pop, highest, 0.0, 0.0)
        crackle = crackle + taylor(length, pop, highest, 0.0, 0.0, 0.0)
        pop = pop + length * highest
    return v


def taylor(
    t: float, first: float, second: float, third: float, fourth: float, fifth: float
) -> float:
    """Change within t by the derivatives from the first one on."""
    return t * (
        first
        + t / 2.0 * (second + t / 3.0 * (third + t / 4.0 * (fourth + t / 5.0 * fifth)))
    )


def crossing_time(
    a: float, length: float, jerk: float, snap: float, crackle: float, pop: float, highest: float
) -> float:
    """When within [0, length] an acceleration a, with these derivatives, is zero.

    The accuracy suffices for an extremum of the velocity, whose error is of second order.
    """
    low = 0.0
    high = length
    t = 0.5 * length
    for i in range(HALVINGS):
        at = a + taylor(t, jerk, snap, crackle, pop, highest)
        if at * a <= 0.0:
            high = t
        else:
            low = t
        slope = jerk + taylor(t, snap, crackle, pop, highest, 0.0)
        step = 0.5 * (low + high) - t
        if slope * a < 0.0:
            newton = -at / slope
            if t + newton >= low and t + newton <= high:
                step = newton
        t = t + step
        if abs(step) <= HALF_DIGITS * length:
            break
    return t
