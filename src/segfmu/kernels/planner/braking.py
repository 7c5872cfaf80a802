"""Bring a boundary acceleration to zero without exceeding the velocity limit.

One ramp to zero is the simplest way. If it ends beyond the velocity limit, a ramp past zero and
back can still keep the limit: it crosses zero while its jerk is high, and so gains less velocity
before. If no level beyond zero helps, no profile of ramps keeps the limit; beside a limit of the
pop, a dip (dip.py) may. Else the problem is refused. From zero acceleration on, a plan always
exists (docs/planner.md).
"""

from segfmu.kernels.numerics.numbers import EQUAL, FAR, GOLDEN, HALVINGS, NEVER, SECTIONS
from segfmu.kernels.numerics.roots import next_bracket, next_point
from segfmu.kernels.planner.dip import find_dips, write_dip
from segfmu.kernels.planner.parameters import saving
from segfmu.kernels.planner.phases import (
    append_change,
    copy_phases,
    join_phases,
    measure_phases,
    reverse_phases,
)
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.ramp_peak import ramp_extreme_velocity
from segfmu.kernels.planner.records import Braking, PlanWork, Problem
from segfmu.kernels.planner.sides import is_beyond, reverse_axis, side_limit


def peak_past_zero(v: float, a: float, level: float, axis: 'float[:]') -> float:
    """Extreme velocity of the ramp from a > 0 to a level <= 0 that starts with velocity v."""
    duration, slope = ramp_duration(a - level, axis)
    if level >= 0.0:
        return v + 0.5 * a * duration
    return ramp_extreme_velocity(v, a, level, duration, duration, axis)


def deep_level(v: float, a: float, velocity_limit: float, bottom: float, axis: 'float[:]') -> float:
    """A level past zero to which a ramp from a > 0 keeps a velocity limit; 1 if there is none.

    bottom: the limit of the acceleration past zero. Golden section, as far as needed: the extreme
    velocity falls with the depth of the level, and may rise again.
    """
    # a ramp to a level beyond that crosses zero while all derivatives still rise, and no faster
    lower = -min(bottom, FAR * a)
    upper = 0.0
    if peak_past_zero(v, a, lower, axis) <= velocity_limit:
        return lower
    inner = upper - GOLDEN * (upper - lower)
    outer = lower + GOLDEN * (upper - lower)
    at_inner = peak_past_zero(v, a, inner, axis)
    at_outer = peak_past_zero(v, a, outer, axis)
    for i in range(SECTIONS):
        if at_inner <= velocity_limit:
            return inner
        if at_outer <= velocity_limit:
            return outer
        # far from zero they differ by rounding
        if at_inner < at_outer - EQUAL * velocity_limit:
            upper = outer
            outer = inner
            at_outer = at_inner
            inner = upper - GOLDEN * (upper - lower)
            at_inner = peak_past_zero(v, a, inner, axis)
        else:
            lower = inner
            inner = outer
            at_inner = at_outer
            outer = lower + GOLDEN * (upper - lower)
            at_outer = peak_past_zero(v, a, outer, axis)
    return 1.0


def level_past_zero(
    v: float, a: float, velocity_limit: float, bottom: float, axis: 'float[:]'
) -> float:
    """The level nearest to zero to which a ramp from a > 0 keeps a velocity limit [m/s2].

    v is the velocity at its start; bottom: the limit of the acceleration past zero. Returns 1 if
    there is no such level.
    """
    inside = deep_level(v, a, velocity_limit, bottom, axis)
    if inside > 0.0:
        return inside
    newest, other, before = inside, 0.0, 0.0
    e_newest = peak_past_zero(v, a, inside, axis) - velocity_limit
    e_other = peak_past_zero(v, a, other, axis) - velocity_limit
    e_before = e_other
    for i in range(HALVINGS):
        level = next_point(newest, other, before, e_newest, e_other, e_before)
        if level == newest or level == other:
            break
        error = peak_past_zero(v, a, level, axis) - velocity_limit
        crossed = newest == inside
        if error <= 0.0:
            crossed = newest != inside
            inside = level
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            crossed, level, error, newest, other, e_newest, e_other
        )
    return inside


def brake(
    v: float, a: float, axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> 'tuple[int, float, float, float]':
    """Phases from (v, a) to zero acceleration; their number (-1: none keeps the limit).

    Also returns duration, distance and end velocity. If the ramp back from a level past zero
    exceeds the limit on the other side, it is braked in turn.
    """
    count = 0
    level = a
    reached = v
    for i in range(3):
        count = append_change(phases, count, level, 0.0, axis)
        duration, y, end, lowest, highest = measure_phases(phases, count, v, NEVER, axis)
        if not is_beyond(end, end, 1.0 + EQUAL, axis):
            return count, duration, y, end
        count = count - 1
        sign = -1.0 if level < 0.0 else 1.0
        most = side_limit(1, sign, axis)
        bottom = side_limit(2, -sign, axis)
        past = sign * level_past_zero(sign * reached, sign * level, most, bottom, axis)
        if past * sign > 0.0:
            break
        count = append_change(phases, count, level, past, axis)
        duration, y, reached, lowest, highest = measure_phases(phases, count, v, NEVER, axis)
        level = past
    dips = work[PlanWork.DIP, :]
    if find_dips(v, a, 0.0, axis, dips, work):
        return write_dip(0.0, axis, dips, phases, work)
    return -1, 0.0, 0.0, 0.0


def nearly_brakes(v: float, a: float, axis: 'float[:]') -> bool:
    """Whether one ramp to zero acceleration exceeds the limit, but may not with steeper rises."""
    duration, slope = ramp_duration(abs(a), axis)
    end = v + 0.5 * a * duration
    near = v + (1.0 - saving(axis)) * (0.5 * a * duration)
    return is_beyond(end, end, 1.0, axis) and not is_beyond(near, near, 1.0, axis)


def braked(
    variant: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> 'tuple[int, float]':
    """Write the problem that remains after braking none (0), the first (1), last (2), both (3).

    It is the row REST of `work`. Returns the number of braking phases and their duration. The
    number is one of `Braking` if there is no such problem.
    """
    trial, rest = work[PlanWork.TRIAL:PlanWork.BEST, :], work[PlanWork.REST, :]
    first, last, spent = 0, 0, 0.0
    v, a, w, b = problem[Problem.V], problem[Problem.A], problem[Problem.W], problem[Problem.B]
    distance = problem[Problem.DISTANCE]
    if (variant % 2 == 1 and a == 0.0) or (variant >= 2 and b == 0.0):
        return Braking.NOT_NEEDED, 0.0
    if variant % 2 == 1:
        first, duration, y, v = brake(v, a, axis, trial, work)
        if first < 0:
            return Braking.START_FAILS, 0.0
        spent = duration
        distance = distance - y
        a = 0.0
    if variant >= 2:
        reverse_axis(axis)
        last, duration, y, w = brake(w, -b, axis, trial, work)
        reverse_axis(axis)
        if last < 0:
            return Braking.END_FAILS, 0.0
        spent = spent + duration
        distance = distance - y
        b = 0.0
    rest[Problem.V] = v
    rest[Problem.A] = a
    rest[Problem.W] = w
    rest[Problem.B] = b
    rest[Problem.DISTANCE] = distance
    rest[Problem.DURATION] = problem[Problem.DURATION] - spent
    return first + last, spent


def surround(
    phases: 'float[:,:]', count: int, variant: int, problem: 'float[:]', axis: 'float[:]',
    work: 'float[:,:]',
) -> int:
    """Add a variant's braking phases to the others; returns the number of phases."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    if variant % 2 == 1:
        v = problem[Problem.V]
        first, duration, y, end = brake(v, problem[Problem.A], axis, trial, work)
        for j in range(count):
            i = count - 1 - j
            phases[first + i, :] = phases[i, :]
        copy_phases(trial, phases, first)
        count = first + count
    if variant >= 2:
        w = problem[Problem.W]
        reverse_axis(axis)
        last, duration, y, end = brake(w, -problem[Problem.B], axis, trial, work)
        reverse_axis(axis)
        reverse_phases(trial, 0, last)
        count = join_phases(trial, last, phases, count)
    return count
