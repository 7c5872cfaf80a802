"""The paper's form (Fig. 3): a velocity change over one level, a cruise, a second velocity change.

The cruise velocity is given, or such that the cruise has zero duration.
"""

from segfmu.kernels.numerics.numbers import COARSE, GAINED, HALVINGS, NEVER, ROUNDED, SAME
from segfmu.kernels.numerics.roots import next_bracket, next_point
from segfmu.kernels.planner.levels import solve_level
from segfmu.kernels.planner.phases import (
    append_change,
    append_hold,
    append_ramp,
    copy_phases,
    insert_hold,
    measure_phases,
    reverse_phases,
    speed_bound,
    total_duration,
    valid_duration,
)
from segfmu.kernels.planner.records import Axis, Problem


def append_velocity_change(
    phases: 'float[:,:]', count: int, v: float, a: float, w: float, top: float, bottom: float,
    axis: 'float[:]',
) -> int:
    """Append the fastest change from (v, a) to (w, 0) over one level; -1 if there is none.

    top, bottom: limits of the acceleration in both directions.
    """
    sign = 1.0
    t1, hold, level = solve_level(w - v, a, 0.0, max(0.0, a), top, -1.0, axis)
    if hold < 0.0:
        sign = -1.0
        t1, hold, level = solve_level(v - w, -a, 0.0, max(0.0, -a), bottom, -1.0, axis)
        if hold < 0.0:
            return -1
    count = append_ramp(phases, count, a, sign * level, t1, axis)
    count = append_hold(phases, count, sign * level, hold)
    return append_change(phases, count, sign * level, 0.0, axis)


def cruise_form(
    phases: 'float[:,:]', cruise: float, problem: 'float[:]', axis: 'float[:]'
) -> 'tuple[int, int, float, float]':
    """The paper's form with a given cruise velocity, without the cruise itself.

    Returns the number of phases (-1: a velocity change does not exist), the row before which to
    insert the cruise, duration and distance.
    """
    v = problem[Problem.V]
    top = axis[Axis.ACCELERATION]
    bottom = axis[Axis.LOWER + 1]
    row = append_velocity_change(phases, 0, v, problem[Problem.A], cruise, top, bottom, axis)
    if row < 0:
        return -1, 0, 0.0, 0.0
    # the second part is the first part of the reversed problem
    w, b = problem[Problem.W], problem[Problem.B]
    count = append_velocity_change(phases, row, w, -b, cruise, bottom, top, axis)
    if count < 0:
        return -1, 0, 0.0, 0.0
    reverse_phases(phases, row, count)
    duration, y, end, lowest, highest = measure_phases(phases, count, v, NEVER, axis)
    return count, row, duration, y


def with_cruise(phases: 'float[:,:]', cruise: float, problem: 'float[:]', axis: 'float[:]') -> int:
    """The paper's form with the cruise that covers the distance; 0 if it is overshot."""
    distance = problem[Problem.DISTANCE]
    count, row, duration, y = cruise_form(phases, cruise, problem, axis)
    if count < 0 or cruise == 0.0:
        return max(count, 0)
    hold = (distance - y) / cruise
    # shorter than rounding: no cruise; the caller checks the remaining error
    if hold < 0.0 and abs(distance - y) > SAME * abs(distance):
        return 0
    return insert_hold(phases, count, row, 0.0, hold)


def vanishing_cruise(
    short: float, far: float, start: float, phases: 'float[:,:]', problem: 'float[:]',
    axis: 'float[:]',
) -> int:
    """The paper's form with a cruise velocity, between two, that makes the cruise vanish.

    At the velocity `short` it falls short of the distance, at `far` it exceeds it; the search
    begins at `start` and bisects where the form does not exist. Returns the number of phases.
    """
    distance = problem[Problem.DISTANCE]
    newest, other = short, far
    before = other
    e_newest, e_other, e_before, falls_short = 0.0, 0.0, 0.0, True
    for i in range(HALVINGS):
        middle = next_point(newest, other, before, e_newest, e_other, e_before) if i > 0 else start
        if (middle - newest) * (middle - other) >= 0.0:
            if i > 0:
                break
            middle = 0.5 * (newest + other)
        count, row, duration, y = cruise_form(phases, middle, problem, axis)
        error = y - distance
        missing = count < 0 or error < 0.0
        if count < 0:
            error = 0.0
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            missing != falls_short, middle, error, newest, other, e_newest, e_other
        )
        falls_short = missing
        if count >= 0 and abs(error) <= ROUNDED * abs(distance):
            other = newest
            break
    lower, upper = newest, other
    if not falls_short:
        lower, upper = other, newest
    # the side whose rounding error a short cruise can compensate
    cruise = lower
    if cruise < 0.0:
        cruise = upper
    return with_cruise(phases, cruise, problem, axis)


def slower_cruise(phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]') -> int:
    """The paper's form with a cruise velocity, below the limit, that makes the cruise vanish."""
    start = max(problem[Problem.V], problem[Problem.W])
    slowest = -axis[Axis.LOWER]
    return vanishing_cruise(slowest, axis[Axis.VELOCITY], start, phases, problem, axis)


def shorter_cruise(
    count: int, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', trial: 'float[:,:]'
) -> int:
    """Replace a profile of `count` phases by a shorter one whose cruise vanishes, if there is one.

    Several cruise velocities can cover the distance. Returns the new number of phases.
    """
    distance = problem[Problem.DISTANCE]
    longest = NEVER
    fastest, backwards = axis[Axis.VELOCITY], axis[Axis.LOWER]
    if count > 0:
        longest = total_duration(phases, count)
        fastest = speed_bound(1.0, longest, problem, axis)
        backwards = speed_bound(-1.0, longest, problem, axis)
    before, e_before = 0.0, 0.0
    for i in range(COARSE + 1):
        cruise = fastest * (1.0 - 2.0 * i / COARSE)
        if 2 * i > COARSE:
            cruise = backwards * (1.0 - 2.0 * i / COARSE)
        used, row, duration, y = cruise_form(trial, cruise, problem, axis)
        error = y - distance if used >= 0 else 0.0
        if error * e_before < 0.0:
            short = cruise
            far = before
            if e_before < 0.0:
                short = before
                far = cruise
            used = vanishing_cruise(short, far, 0.5 * (short + far), trial, problem, axis)
            duration = -1.0
            if used > 0:
                duration = valid_duration(trial, used, problem, axis)
            # a gain by rounding is none
            if duration >= 0.0 and duration < longest * (1.0 - GAINED):
                copy_phases(trial, phases, used)
                count = used
                longest = duration
        before = cruise
        e_before = error
    return count
