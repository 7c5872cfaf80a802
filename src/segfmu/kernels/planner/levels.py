"""The merged profile (no cruise): two acceleration levels, found by a bracketed root.

I.2 and II.1 of the paper's profile merge into one ramp between the levels; (15a-g) then have no
closed form and the position is met by a root in one unknown (end of section 3.1).

Mirroring the position and reversing the time reduce every case to one canonical family: the
first level is the higher one and not below zero or the initial acceleration, the second level
falls from the end acceleration, and the first one follows from the velocity balance, which is
monotone there because ramps never take longer in proportion to a larger change.
"""

from math import sqrt

from segfmu.kernels.planner.transition import ramp_change, ramp_distance, ramp_duration, ramp_rise


def solve_level(
    gain: float, a: float, b: float, low: float, high: float, ramp: 'float[:]'
) -> 'tuple[float, float, float]':
    """Ramp from a to a level in [low, high], hold it, ramp to b, and gain a velocity.

    low >= max(0, a, b), where the gain grows with the level. Returns the duration of the first
    ramp, the hold (above zero only at `high`), and -1 in place of the hold when even the lowest
    level gains too much; last the level.
    """
    if ramp[3] >= 0.0:
        level = linear_level(gain, a, b, ramp)
        if level >= max(a, b) + ramp[3] and level >= low and level <= high:
            return (level - a) * ramp[41] + ramp[42], 0.0, level
    t_low, rise, slope = ramp_duration(low - a, ramp)
    t_end, rise, slope = ramp_duration(low - b, ramp)
    least = 0.5 * (a + low) * t_low + 0.5 * (low + b) * t_end
    if gain <= least:
        # a rounding error short of the lowest level is that level
        if gain < least - 1e-14 * (abs(gain) + abs(least)):
            return 0.0, -1.0, low
        return t_low, 0.0, low
    t_high, rise, slope = ramp_duration(high - a, ramp)
    t_end, rise, slope = ramp_duration(high - b, ramp)
    most = 0.5 * (a + high) * t_high + 0.5 * (high + b) * t_end
    if gain >= most:
        return t_high, (gain - most) / high, high
    share = (gain - least) / (most - least)
    t, level = root_level(gain, a, b, t_low, t_high, share, ramp)
    return t, 0.0, level


def linear_level(gain: float, a: float, b: float, ramp: 'float[:]') -> float:
    """The level of `solve_level` where the durations of both ramps are linear in their change.

    slope level^2 + constant level = gain + slope (a^2 + b^2) / 2 - constant (a + b) / 2; -1 where
    that has no root.
    """
    slope = ramp[41]
    half = 0.5 * ramp[42]
    rest = gain + 0.5 * slope * (a * a + b * b) - half * (a + b)
    square = half * half + slope * rest
    if square <= 0.0:
        return -1.0
    # the form without a difference of nearly equal numbers
    return rest / (half + sqrt(square))


def root_level(
    gain: float, a: float, b: float, lower: float, upper: float, share: float, ramp: 'float[:]'
) -> 'tuple[float, float]':
    """Duration of the first ramp of `solve_level` in [lower, upper] by Newton's method; level.

    share is where the gain lies between those of the two durations; the gain is nearly quadratic
    in the duration.
    """
    t = lower + (upper - lower) * sqrt(share)
    level = a
    for i in range(100):
        change, growth = ramp_change(t, ramp)
        level = a + change
        t_end, rise, slope = ramp_duration(level - b, ramp)
        first = 0.5 * (a + level) * t
        second = 0.5 * (level + b) * t_end
        error = first + second - gain
        if abs(error) <= 2e-16 * (abs(first) + abs(second)):
            return t, level
        if error > 0.0:
            upper = t
        else:
            lower = t
        rate = 0.5 * (a + level) + 0.5 * growth * (t + t_end + (level + b) * slope)
        following = 0.5 * (lower + upper)
        if rate > 0.0:
            newton = t - error / rate
            # at the root the step may round to nothing, which a bracket would not admit
            if abs(newton - t) <= 4e-16 * t:
                return t, level
            found = first + second
            # far from the root, Newton's method on logarithms, as the gain is nearly a power
            if found > 0.0 and gain > 0.0 and (found > 2.0 * gain or gain > 2.0 * found):
                newton = t * (gain / found) ** (found / (t * rate))
            if newton > lower and newton < upper:
                following = newton
        if abs(following - t) <= 4e-16 * t:
            return t, level
        t = following
    change, growth = ramp_change(t, ramp)
    return t, a + change


def levels_distance(
    v: float,
    a: float,
    t1: float,
    hold1: float,
    level1: float,
    hold2: float,
    level2: float,
    t3: float,
    b: float,
    ramp: 'float[:]',
) -> 'tuple[float, float]':
    """Duration and distance of: ramp, hold, ramp, hold, ramp (merged form)."""
    t2, rise, slope = ramp_duration(abs(level2 - level1), ramp)
    y = ramp_distance(v, a, level1, t1, ramp_rise(t1, ramp), ramp)
    v = v + 0.5 * (a + level1) * t1
    if hold1 > 0.0:
        y = y + (v + 0.5 * level1 * hold1) * hold1
        v = v + level1 * hold1
    y = y + ramp_distance(v, level1, level2, t2, rise, ramp)
    v = v + 0.5 * (level1 + level2) * t2
    if hold2 > 0.0:
        y = y + (v + 0.5 * level2 * hold2) * hold2
        v = v + level2 * hold2
    y = y + ramp_distance(v, level2, b, t3, ramp_rise(t3, ramp), ramp)
    return t1 + hold1 + t2 + hold2 + t3, y


def canonical_point(
    p: float,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    ramp: 'float[:]',
) -> 'tuple[float, float, float, float, float, float, float, float]':
    """One member of the canonical family from (v, a) to (w, b).

    p is the duration of the last ramp, from the second level up to b; beyond t_top, where that
    level is -top, it goes on as the hold there. The first level is at most `high`: `top`, or less
    to keep the velocity down between the levels, but not less than a and b. Returns duration
    (-1: no such member), distance, t1, hold1, level1, hold2, level2, t3.
    """
    hold2 = 0.0
    t3 = p
    if p >= t_top:
        t3 = t_top
        hold2 = p - t_top
        level2 = -top
    else:
        change, slope = ramp_change(p, ramp)
        level2 = b - change
    gain = w - v - 0.5 * (level2 + b) * t3 - level2 * hold2
    low = max(0.0, max(a, level2))
    t1, hold1, level1 = solve_level(gain, a, level2, low, high, ramp)
    if hold1 < 0.0:
        return -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    duration, y = levels_distance(v, a, t1, hold1, level1, hold2, level2, t3, b, ramp)
    return duration, y, t1, hold1, level1, hold2, level2, t3
