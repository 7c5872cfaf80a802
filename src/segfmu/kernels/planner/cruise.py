"""The paper's form (Fig. 3): a velocity change over one level, a cruise, a second velocity change.

Its cruise velocity is given, found such that the cruise vanishes, or that which one ramp to zero
reaches from either end.
"""

from segfmu.kernels.numerics.roots import root_share
from segfmu.kernels.planner.levels import solve_level
from segfmu.kernels.planner.phases import (
    append_change,
    append_hold,
    append_ramp,
    insert_hold,
    measure_phases,
    reverse_phases,
)
from segfmu.kernels.planner.transition import ramp_duration


def append_velocity_change(
    phases: 'float[:,:]', count: int, v: float, a: float, w: float, top: float, ramp: 'float[:]'
) -> int:
    """Append the fastest change from (v, a) to (w, 0) over one level; -1 if there is none."""
    sign = 1.0
    t1, hold, level = solve_level(w - v, a, 0.0, max(0.0, a), top, ramp)
    if hold < 0.0:
        sign = -1.0
        t1, hold, level = solve_level(v - w, -a, 0.0, max(0.0, -a), top, ramp)
        if hold < 0.0:
            return -1
    count = append_ramp(phases, count, a, sign * level, t1, ramp)
    count = append_hold(phases, count, sign * level, hold)
    return append_change(phases, count, sign * level, 0.0, ramp)


def cruise_form(
    phases: 'float[:,:]',
    cruise: float,
    v: float,
    a: float,
    w: float,
    b: float,
    top: float,
    ramp: 'float[:]',
) -> 'tuple[int, int, float, float]':
    """The paper's form with a given cruise velocity, the cruise itself left out.

    Returns the number of phases (-1: a velocity change does not exist), the row before which
    the cruise belongs, duration and distance.
    """
    row = append_velocity_change(phases, 0, v, a, cruise, top, ramp)
    if row < 0:
        return -1, 0, 0.0, 0.0
    # the second part is the first part of the reversed problem
    count = append_velocity_change(phases, row, w, -b, cruise, top, ramp)
    if count < 0:
        return -1, 0, 0.0, 0.0
    reverse_phases(phases, row, count)
    duration, y, end, lowest, highest = measure_phases(phases, count, v, 1e300, ramp)
    return count, row, duration, y


def with_cruise(
    phases: 'float[:,:]',
    cruise: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The paper's form with the cruise that covers the distance; 0 if it is overshot."""
    count, row, duration, y = cruise_form(phases, cruise, v, a, w, b, top, ramp)
    if count < 0 or cruise == 0.0:
        return max(count, 0)
    hold = (distance - y) / cruise
    # shorter than rounding: no cruise, and what it misses is judged by its caller
    if hold < 0.0 and abs(distance - y) > 1e-13 * abs(distance):
        return 0
    return insert_hold(phases, count, row, 0.0, hold)


def slower_cruise(
    phases: 'float[:,:]',
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The paper's form whose cruise velocity, below the limit, makes the cruise vanish.

    Searched between the two limits, of which one falls short of the distance and the other one
    is too far; by bisection where the form does not exist.
    """
    newest = -velocity_limit
    other = velocity_limit
    before = velocity_limit
    e_newest = 0.0
    e_other = 0.0
    e_before = 0.0
    falls_short = True
    for i in range(120):
        middle = max(v, w)
        if i > 0:
            share = root_share(newest, other, before, e_newest, e_other, e_before)
            middle = newest + share * (other - newest)
        if (middle - newest) * (middle - other) >= 0.0:
            if i > 0:
                break
            middle = 0.0
        count, row, duration, y = cruise_form(phases, middle, v, a, w, b, top, ramp)
        error = y - distance
        short = count < 0 or error < 0.0
        if count < 0:
            error = 0.0
        before = newest
        e_before = e_newest
        if short != falls_short:
            before = other
            e_before = e_other
            other = newest
            e_other = e_newest
        newest = middle
        e_newest = error
        falls_short = short
        if count >= 0 and abs(error) <= 1e-15 * abs(distance):
            other = newest
            break
    lower = newest
    upper = other
    if not falls_short:
        lower = other
        upper = newest
    # the side whose rounding error a short cruise can make up
    cruise = lower
    if cruise < 0.0:
        cruise = upper
    return with_cruise(phases, cruise, v, a, w, b, distance, top, ramp)


def direct_form(
    phases: 'float[:,:]',
    from_start: bool,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The paper's form around the velocity that one ramp to zero reaches from one end, or 0.

    The distance has a kink there, which can be the only member that covers it: a state on the
    way of another profile leads to such problems.
    """
    end = abs(b)
    cruise = w
    if from_start:
        end = abs(a)
        cruise = v
    if end == 0.0:
        return 0
    t, rise, slope = ramp_duration(end, ramp)
    if from_start:
        cruise = v + 0.5 * a * t
    else:
        cruise = w - 0.5 * b * t
    if abs(cruise) > velocity_limit:
        return 0
    count, row, duration, y = cruise_form(phases, cruise, v, a, w, b, top, ramp)
    if abs(y - distance) > 1e-14 * (abs(distance) + (abs(v) + abs(w)) * duration):
        return 0
    return max(count, 0)
