"""Profiles with dips (dip.py) at the ends, where a ramp to zero exceeds the velocity limit.

Ramps past zero keep that limit too, but bring all derivatives to zero on the way: of random
problems with a limit of the pop one in a hundred takes up to twice the time. The depth of the dips
and the acceleration at their ends are searched for: a deep one takes longer, but leads on into a
motion in the other direction.
"""

from segfmu.kernels.numerics.numbers import WORTH
from segfmu.kernels.planner.dip import find_deepest, find_dips, write_dip
from segfmu.kernels.planner.enclose import clear_nearest, nearest_weight, timed_between
from segfmu.kernels.planner.forms import braked_ramps, is_done, passing_either_way, shortest_between
from segfmu.kernels.planner.passing import slower_form
from segfmu.kernels.planner.phases import (
    copy_phases,
    fit_duration,
    join_phases,
    reverse_phases,
    total_duration,
)
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Axis, Cell, Dip, Nearest, PlanWork, Problem
from segfmu.kernels.planner.sides import is_beyond, reverse_axis
from segfmu.kernels.planner.timed_cruise import is_enclosed

# accelerations at which dips end, beside zero, as shares of the limit
ENDS = 0.45


def set_dips(
    v: float, a: float, end: float, axis: 'float[:]', dips: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Set the dips (Dip) from (v, a) where a ramp exceeds the velocity limit; False: has none."""
    dips[Dip.V] = v
    dips[Dip.END] = a
    dips[Dip.ABOVE] = 0.0
    duration, slope = ramp_duration(abs(a), axis)
    reached = v + 0.5 * a * duration
    if not is_beyond(reached, reached, 1.0, axis):
        return True
    if not find_dips(v, a, end, axis, dips, work):
        return False
    find_deepest(axis, dips, work)
    return True


def problem_between(
    depth: float, asked: 'float[:]', axis: 'float[:]', rest: 'float[:]', work: 'float[:,:]'
) -> float:
    """Write the problem (Problem) that dips of a depth leave; their duration [s]."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    first, spent, y, v = write_dip(depth, axis, work[PlanWork.DIP_FIRST, :], trial, work)
    rest[Problem.V] = v
    rest[Problem.A] = work[PlanWork.DIP_FIRST, Dip.END]
    rest[Problem.DISTANCE] = asked[Problem.DISTANCE] - y
    last, duration, y, w = write_dip(depth, axis, work[PlanWork.DIP_LAST, :], trial, work)
    rest[Problem.W] = w
    rest[Problem.B] = -work[PlanWork.DIP_LAST, Dip.END]
    rest[Problem.DISTANCE] = rest[Problem.DISTANCE] - y
    return spent + duration


def profile_between(rest: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> int:
    """Write the shortest profile of a problem in DIP_PHASES; the number of its phases, -1: none."""
    phases = work[PlanWork.DIP_PHASES:PlanWork.FAMILY, :]
    if is_done(rest):
        return 0
    count = shortest_between(0, phases, rest, axis, work)
    if count == 0:
        count = braked_ramps(0, rest, axis, phases, work)
    if count <= 0:
        return -1
    return passing_either_way(count, phases, rest, axis, work)


def with_dips(
    depth: float, count: int, phases: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Write dips of a depth, and the `count` phases in DIP_PHASES between them; their number."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    between = work[PlanWork.DIP_PHASES:PlanWork.FAMILY, :]
    used, duration, y, v = write_dip(depth, axis, work[PlanWork.DIP_FIRST, :], phases, work)
    used = join_phases(between, count, phases, used)
    last, duration, y, v = write_dip(depth, axis, work[PlanWork.DIP_LAST, :], trial, work)
    reverse_phases(trial, 0, last)
    return join_phases(trial, last, phases, used)


def dipped_profile(
    depth: float, longest: float, phases: 'float[:,:]', asked: 'float[:]', axis: 'float[:]',
    work: 'float[:,:]',
) -> int:
    """Write the profile with dips of a depth (write_dip) at the ends; the number of its phases.

    0: there is none that takes less than `longest` [s].
    """
    rest, between = work[PlanWork.DIPPED, :], work[PlanWork.DIP_PHASES:PlanWork.FAMILY, :]
    spent = problem_between(depth, asked, axis, rest, work)
    if spent >= longest:
        return 0
    count = profile_between(rest, axis, work)
    if count < 0 or spent + total_duration(between, count) >= longest:
        return 0
    return with_dips(depth, count, phases, axis, work)


def set_both_dips(end: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Set the dips at both ends; False if there are none, or none are needed."""
    first, last = work[PlanWork.DIP_FIRST, :], work[PlanWork.DIP_LAST, :]
    if not set_dips(problem[Problem.V], problem[Problem.A], end, axis, first, work):
        return False
    reverse_axis(axis)
    found = set_dips(problem[Problem.W], -problem[Problem.B], end, axis, last, work)
    reverse_axis(axis)
    return found and first[Dip.ABOVE] + last[Dip.ABOVE] > 0.0


def best_depth(
    count: int, phases: 'float[:,:]', asked: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Replace a profile by the shortest one with the dips that are set, of any depth."""
    middle, best = 0.5, -1.0
    for sweep in range(3):
        # depths of 0, 1/4 .. 1, then those between the best one and its neighbours
        for i in range(-2, 3):
            depth = middle + 0.25 * i / 2**sweep
            if sweep > 0 and (i % 2 == 0 or depth < 0.0 or depth > 1.0):
                continue
            longest = total_duration(phases, count) * (1.0 - WORTH)
            taken = dipped_profile(depth, longest, phases, asked, axis, work)
            if taken > 0:
                count = taken
                best = depth
        if best < 0.0:
            break
        middle = best
    return count


def shorter_dipped(
    count: int, phases: 'float[:,:]', asked: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Replace a profile of `count` phases by the shortest one with dips; its number of phases."""
    for i in range(3):
        end = ENDS * i * min(axis[Axis.ACCELERATION], axis[Axis.LOWER + 1])
        if set_both_dips(end, asked, axis, work):
            count = best_depth(count, phases, asked, axis, work)
    return count


def surround_with_dips(
    column: int, depth: float, phases: 'float[:,:]', axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Add dips to the profile whose number of phases is in a column of the row NEAREST."""
    count = int(work[PlanWork.NEAREST, column])
    if count > 0:
        copy_phases(phases, work[PlanWork.DIP_PHASES:PlanWork.FAMILY, :], count)
        count = with_dips(depth, count, phases, axis, work)
        duration = work[PlanWork.PROBLEM, Problem.DURATION]
        work[PlanWork.NEAREST, column] = fit_duration(phases, count, duration)


def timed_between_dips(
    rest: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """`timed_profile` of what dips leave: ramps, or the shortest profile at a slower pace."""
    nearest, between = work[PlanWork.NEAREST, :], work[PlanWork.DIP_PHASES:PlanWork.FAMILY, :]
    clear_nearest(work)
    if rest[Problem.DURATION] <= 0.0:
        return -1.0
    timed_between(rest, axis, cell, work)
    if is_enclosed(work):
        return nearest_weight(rest, axis, nearest)
    clear_nearest(work)
    count = slower_form(profile_between(rest, axis, work), between, rest, axis, work)
    copy_phases(between, cell[Cell.BELOW:Cell.ABOVE, :], count)
    nearest[Nearest.BELOW_COUNT] = count
    return -1.0 if count == 0 else 0.0


def timed_dipped(axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]') -> float:
    """`timed_profile` with dips at the ends where ramps exceed the velocity limit."""
    problem, rest = work[PlanWork.PROBLEM, :], work[PlanWork.DIPPED, :]
    if not set_both_dips(0.0, problem, axis, work):
        return -1.0
    for i in range(5):
        depth = 0.25 * i
        spent = problem_between(depth, problem, axis, rest, work)
        rest[Problem.DURATION] = problem[Problem.DURATION] - spent
        weight = timed_between_dips(rest, axis, cell, work)
        if weight >= 0.0:
            below, above = cell[Cell.BELOW:Cell.ABOVE, :], cell[Cell.ABOVE:Cell.PROBLEM, :]
            surround_with_dips(Nearest.BELOW_COUNT, depth, below, axis, work)
            surround_with_dips(Nearest.ABOVE_COUNT, depth, above, axis, work)
            return weight
    return -1.0
