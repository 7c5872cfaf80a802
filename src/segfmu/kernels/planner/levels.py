"""The merged profile (no cruise): two acceleration levels, found by a bracketed root.

I.2 and II.1 of the paper's profile merge into one ramp between the levels. Then (15a-g) have no
closed form, and a root in one unknown gives the position (end of section 3.1).

Mirroring the position and reversing the time reduce every case to one canonical family. Its first
level is the higher one, and not below zero or the initial acceleration. Its second level falls from
the end acceleration. The first level follows from the velocity balance, which is monotone because
the ratio of a ramp's duration to its change never grows with the change.
"""

from math import sqrt

from segfmu.kernels.numerics.numbers import COVERED, HALF_DIGITS, HALVINGS, LAST_DIGIT
from segfmu.kernels.planner.ramp import ramp_change, ramp_distance, ramp_duration
from segfmu.kernels.planner.records import Axis, Family


def level_gain(level: float, a: float, b: float, axis: 'float[:]') -> 'tuple[float, float]':
    """Duration of the ramp from a to a level [s], and what it and the ramp to b gain [m/s]."""
    first, slope = ramp_duration(level - a, axis)
    last, slope = ramp_duration(level - b, axis)
    return first, 0.5 * (a + level) * first + 0.5 * (level + b) * last


def solve_level(
    gain: float, a: float, b: float, low: float, high: float, near: float, axis: 'float[:]'
) -> 'tuple[float, float, float]':
    """Ramp from a to a level in [low, high], hold it, ramp to b, and gain a velocity.

    low >= max(0, a, b), where the gain grows with the level. near: about the duration of the first
    ramp, if that is known, else -1. Returns the duration of the first ramp, the hold (above zero
    only at `high`), and -1 in place of the hold when even the lowest level gains too much; last the
    level.
    """
    linear_from = axis[Axis.LINEAR_FROM]
    if max(a, b) + linear_from <= high:
        level = linear_level(gain, a, b, axis)
        if level >= max(a, b) + linear_from and level >= low and level <= high:
            t = (level - a) * axis[Axis.LINEAR_SLOPE] + axis[Axis.LINEAR_CONSTANT]
            return t, 0.0, level
    t_high, most = level_gain(high, a, b, axis)
    if gain > most:
        return t_high, (gain - most) / high, high
    t_low, least = level_gain(low, a, b, axis)
    if gain <= least:
        # up to rounding, this is the lowest level
        if gain < least - COVERED * (abs(gain) + abs(least)):
            return 0.0, -1.0, low
        return t_low, 0.0, low
    start = near
    if start <= t_low or start >= t_high:
        # the gain is nearly quadratic in the duration
        start = t_low + (t_high - t_low) * sqrt((gain - least) / (most - least))
    t, level = root_level(gain, a, b, t_low, t_high, start, axis)
    return t, 0.0, level


def linear_level(gain: float, a: float, b: float, axis: 'float[:]') -> float:
    """The level of `solve_level` where the durations of both ramps are linear in their change.

    slope level^2 + constant level = gain + slope (a^2 + b^2) / 2 - constant (a + b) / 2; -1 if that
    has no root.
    """
    slope = axis[Axis.LINEAR_SLOPE]
    half = 0.5 * axis[Axis.LINEAR_CONSTANT]
    rest = gain + 0.5 * slope * (a * a + b * b) - half * (a + b)
    square = half * half + slope * rest
    if square <= 0.0:
        return -1.0
    # the form without a difference of nearly equal numbers
    return rest / (half + sqrt(square))


def root_level(
    gain: float, a: float, b: float, lower: float, upper: float, start: float, axis: 'float[:]'
) -> 'tuple[float, float]':
    """Duration of the first ramp of `solve_level` in [lower, upper] by Newton's method; level."""
    t = start
    level = a
    t_before = start
    rate_before = 0.0
    for i in range(HALVINGS):
        change, growth = ramp_change(t, axis)
        level = a + change
        t_end, slope = ramp_duration(level - b, axis)
        first = 0.5 * (a + level) * t
        second = 0.5 * (level + b) * t_end
        error = first + second - gain
        if abs(error) <= LAST_DIGIT * (abs(first) + abs(second)):
            return t, level
        if error > 0.0:
            upper = t
        else:
            lower = t
        rate = 0.5 * (a + level) + 0.5 * growth * (t + t_end + (level + b) * slope)
        following = 0.5 * (lower + upper)
        if rate > 0.0:
            newton = t - error / rate
            bend = 0.5 * error / rate * (rate - rate_before) / (t - t_before) if i > 0 else 0.0
            if bend != 0.0 and abs(bend) < 0.5 * rate:
                # Halley's method, with the change of the slope since the step before
                newton = t - error / (rate - bend)
            # the error of the next step is the square of this one, or less
            if abs(newton - t) <= HALF_DIGITS * t:
                change, growth = ramp_change(newton, axis)
                return newton, a + change
            reached = first + second
            # far from the root, Newton's method on logarithms, as the gain is nearly a power
            far = reached > 0.0 and gain > 0.0 and (reached > 2.0 * gain or gain > 2.0 * reached)
            # a higher power leads out of the bracket
            if far and reached < t * rate:
                newton = t * (gain / reached) ** (reached / (t * rate))
                # the power can differ on both sides of the root: halve the bracket in between
                if i % 3 == 2:
                    newton = sqrt(lower * upper)
            if newton > lower and newton < upper:
                following = newton
        if abs(following - t) <= LAST_DIGIT * t:
            return t, level
        t_before = t
        rate_before = rate
        t = following
    change, growth = ramp_change(t, axis)
    return t, a + change


def member_distance(family: 'float[:]', axis: 'float[:]') -> 'tuple[float, float]':
    """Duration [s] and distance [m] of the member: ramp, hold, ramp, hold, ramp.

    The distance is 0 where members are searched by their duration.
    """
    v, a, b, t1 = family[Family.V], family[Family.A], family[Family.B], family[Family.FIRST_TIME]
    hold1, level1 = family[Family.FIRST_HOLD], family[Family.FIRST_LEVEL]
    hold2, level2 = family[Family.SECOND_HOLD], family[Family.SECOND_LEVEL]
    t3 = family[Family.LAST_TIME]
    basis, slope = ramp_duration(abs(level2 - level1), axis)
    t2 = basis * family[Family.STRETCH]
    basis = basis + family[Family.FLATNESS] * (t2 - basis)
    if family[Family.BY_TIME] != 0.0:
        return t1 + hold1 + t2 + hold2 + t3, 0.0
    y = ramp_distance(v, a, level1, t1, t1, axis)
    v = v + 0.5 * (a + level1) * t1
    if hold1 > 0.0:
        y = y + (v + 0.5 * level1 * hold1) * hold1
        v = v + level1 * hold1
    y = y + ramp_distance(v, level1, level2, t2, basis, axis)
    v = v + 0.5 * (level1 + level2) * t2
    if hold2 > 0.0:
        y = y + (v + 0.5 * level2 * hold2) * hold2
        v = v + level2 * hold2
    y = y + ramp_distance(v, level2, b, t3, t3, axis)
    return t1 + hold1 + t2 + hold2 + t3, y


def second_level(
    p: float, family: 'float[:]', axis: 'float[:]'
) -> 'tuple[float, float, float, float]':
    """The second level of a member, the ramp from it, its hold, and what is to be gained before.

    p as in `canonical_member`.
    """
    b, last_ramp = family[Family.B], family[Family.LAST_RAMP]
    hold = 0.0
    t = p
    if p >= last_ramp:
        t = last_ramp
        hold = p - last_ramp
        level = -family[Family.LOWEST]
    else:
        change, slope = ramp_change(p, axis)
        level = b - change
    gain = family[Family.W] - family[Family.V] - 0.5 * (level + b) * t - level * hold
    return level, t, hold, gain


def has_member(p: float, family: 'float[:]', axis: 'float[:]') -> bool:
    """Whether there is a canonical member: the lowest first level does not gain too much."""
    a = family[Family.A]
    level, t, hold, gain = second_level(p, family, axis)
    first, least = level_gain(max(0.0, max(a, level)), a, level, axis)
    return gain >= least


def canonical_member(p: float, family: 'float[:]', axis: 'float[:]') -> 'tuple[float, float]':
    """Write one member of the canonical family (Family) from (V, A) to (W, B).

    p is the duration of the last ramp, from the second level up to B. Above LAST_RAMP that level is
    the negative acceleration limit, and the excess is the duration of its hold. The first level is
    at most HIGHEST: the acceleration limit, or less to limit the velocity between the levels, but
    not less than A and B. Returns duration [s] (-1: no such member) and distance [m].
    """
    a = family[Family.A]
    level2, t3, hold2, gain = second_level(p, family, axis)
    low = max(0.0, max(a, level2))
    # of the member before
    near = family[Family.FIRST_TIME]
    t1, hold1, level1 = solve_level(gain, a, level2, low, family[Family.HIGHEST], near, axis)
    if hold1 < 0.0:
        return -1.0, 0.0
    family[Family.FIRST_TIME] = t1
    family[Family.FIRST_HOLD] = hold1
    family[Family.FIRST_LEVEL] = level1
    family[Family.SECOND_HOLD] = hold2
    family[Family.SECOND_LEVEL] = level2
    family[Family.LAST_TIME] = t3
    return member_distance(family, axis)
