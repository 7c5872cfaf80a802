"""Bringing a boundary acceleration to zero without passing the velocity limit.

One ramp to zero is the obvious way. Where that ends beyond the velocity limit, a ramp past zero and
back can still stay within it: it crosses zero while its jerk is high, and so gains less before.
If no level beyond zero helps, no profile of ramps keeps the limit and the problem is refused; what
comes after the acceleration is zero can always be planned (docs/planner.md).
"""

from segfmu.kernels.planner.phases import append_change, copy_phases, measure_phases, reverse_phases
from segfmu.kernels.planner.transition import ramp_duration, ramp_extreme_velocity


def peak_past_zero(v: float, a: float, level: float, ramp: 'float[:]') -> float:
    """Extreme velocity of the ramp from a > 0 to a level <= 0 that starts with velocity v."""
    duration, rise, slope = ramp_duration(a - level, ramp)
    if level >= 0.0:
        return v + 0.5 * a * duration
    return ramp_extreme_velocity(v, a, level, duration, rise, ramp)


def level_past_zero(
    v: float, a: float, velocity_limit: float, top: float, ramp: 'float[:]'
) -> float:
    """The level next to zero past which a ramp from a > 0 keeps the limit; 1 if there is none."""
    shrink = 0.6180339887498949
    lower = -top
    upper = 0.0
    # golden section: the extreme velocity falls with the depth of the level, and may rise again
    for i in range(60):
        inner = upper - shrink * (upper - lower)
        outer = lower + shrink * (upper - lower)
        if peak_past_zero(v, a, inner, ramp) < peak_past_zero(v, a, outer, ramp):
            upper = outer
        else:
            lower = inner
    deepest = 0.5 * (lower + upper)
    if peak_past_zero(v, a, -top, ramp) < peak_past_zero(v, a, deepest, ramp):
        deepest = -top
    if peak_past_zero(v, a, deepest, ramp) > velocity_limit:
        return 1.0
    inside = deepest
    outside = 0.0
    for i in range(60):
        level = 0.5 * (inside + outside)
        if peak_past_zero(v, a, level, ramp) <= velocity_limit:
            inside = level
        else:
            outside = level
    return inside


def brake(
    v: float, a: float, velocity_limit: float, top: float, ramp: 'float[:]', phases: 'float[:,:]'
) -> 'tuple[int, float, float, float]':
    """Phases from (v, a) to zero acceleration; their number (-1: the limit does not admit them).

    Also returns duration, distance and end velocity. Where the way back from a level past zero
    passes the limit on the other side, it is braked in turn.
    """
    count = 0
    level = a
    reached = v
    for i in range(3):
        count = append_change(phases, count, level, 0.0, ramp)
        duration, y, end, lowest, highest = measure_phases(phases, count, v, 1e300, ramp)
        if abs(end) <= velocity_limit * (1.0 + 1e-12):
            return count, duration, y, end
        count = count - 1
        sign = 1.0
        if level < 0.0:
            sign = -1.0
        past = sign * level_past_zero(sign * reached, sign * level, velocity_limit, top, ramp)
        if past * sign > 0.0:
            break
        count = append_change(phases, count, level, past, ramp)
        duration, y, reached, lowest, highest = measure_phases(phases, count, v, 1e300, ramp)
        level = past
    return -1, 0.0, 0.0, 0.0


def braked(
    variant: int,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
    trial: 'float[:,:]',
) -> 'tuple[int, float, float, float, float, float, float]':
    """The problem that braking leaves: none (0), the first (1), the last (2), both (3).

    Returns the number of phases that braking takes, their duration, and distance, v, a, w, b of
    what is left. The number is -1, -2 where the limit does not admit braking the first, the last
    acceleration, and -3 where one that shall be braked is zero.
    """
    first = 0
    last = 0
    time = 0.0
    if (variant % 2 == 1 and a == 0.0) or (variant >= 2 and b == 0.0):
        return -3, 0.0, distance, v, a, w, b
    if variant % 2 == 1:
        first, duration, y, v = brake(v, a, velocity_limit, top, ramp, trial)
        if first < 0:
            return -1, 0.0, distance, v, a, w, b
        time = duration
        distance = distance - y
        a = 0.0
    if variant >= 2:
        last, duration, y, w = brake(w, -b, velocity_limit, top, ramp, trial)
        if last < 0:
            return -2, 0.0, distance, v, a, w, b
        time = time + duration
        distance = distance - y
        b = 0.0
    return first + last, time, distance, v, a, w, b


def surround(
    phases: 'float[:,:]',
    count: int,
    brake_start: bool,
    v: float,
    a: float,
    brake_end: bool,
    w: float,
    b: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
    trial: 'float[:,:]',
) -> int:
    """Put the braking of the initial and the build-up of the final acceleration around phases."""
    if brake_start:
        first, duration, y, end = brake(v, a, velocity_limit, top, ramp, trial)
        for j in range(count):
            i = count - 1 - j
            for column in range(4):
                phases[first + i, column] = phases[i, column]
        copy_phases(trial, phases, first)
        count = first + count
    if brake_end:
        last, duration, y, end = brake(w, -b, velocity_limit, top, ramp, trial)
        reverse_phases(trial, 0, last)
        for i in range(last):
            for column in range(4):
                phases[count + i, column] = trial[i, column]
        count = count + last
    return count
