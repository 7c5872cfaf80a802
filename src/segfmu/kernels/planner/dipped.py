"""Profiles with dips (dip.py) at the ends, where a ramp to zero exceeds the velocity limit.

Ramps past zero keep that limit too, but bring all derivatives to zero on the way: of random
problems with a limit of the pop one in a hundred takes up to twice the time. The depth of the dips
is searched for: a deep one takes longer, but leads on into a motion in the other direction.
"""

from segfmu.kernels.planner.dip import find_dips, write_dip
from segfmu.kernels.planner.forms import (
    braked_ramps,
    is_done,
    passing_either_way,
    shortest_between,
)
from segfmu.kernels.planner.phases import join_phases, reverse_phases, total_duration
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Axis, Dip, PlanWork, Problem


def set_dips(v: float, a: float, axis: 'float[:]', dips: 'float[:]', work: 'float[:,:]') -> bool:
    """Set the dips (Dip) from (v, a) where a ramp exceeds the velocity limit; False: has none."""
    dips[Dip.V] = v
    dips[Dip.ABOVE] = 0.0
    duration, slope = ramp_duration(abs(a), axis)
    if abs(v + 0.5 * a * duration) <= axis[Axis.VELOCITY]:
        return True
    return find_dips(v, a, axis, dips, work)


def problem_between(
    depth: float, asked: 'float[:]', axis: 'float[:]', rest: 'float[:]', work: 'float[:,:]'
) -> float:
    """Write the problem (Problem) that dips of a depth leave; their duration [s]."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    first, spent, y, v = write_dip(depth, axis, work[PlanWork.DIP_FIRST, :], trial, work)
    rest[Problem.V] = v
    rest[Problem.A] = 0.0
    if first == 0:
        rest[Problem.A] = asked[Problem.A]
    rest[Problem.DISTANCE] = asked[Problem.DISTANCE] - y
    last, duration, y, w = write_dip(depth, axis, work[PlanWork.DIP_LAST, :], trial, work)
    rest[Problem.W] = w
    rest[Problem.B] = 0.0
    if last == 0:
        rest[Problem.B] = asked[Problem.B]
    rest[Problem.DISTANCE] = rest[Problem.DISTANCE] - y
    return spent + duration


def dipped_profile(
    depth: float, longest: float, phases: 'float[:,:]', asked: 'float[:]', axis: 'float[:]',
    work: 'float[:,:]',
) -> int:
    """Write the profile with dips of a depth (write_dip) at the ends; the number of its phases.

    0: there is none that takes less than `longest` [s].
    """
    rest = work[PlanWork.DIPPED, :]
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    between = work[PlanWork.DIP_PHASES:PlanWork.FAMILY, :]
    spent = problem_between(depth, asked, axis, rest, work)
    if spent >= longest:
        return 0
    count = 0
    if not is_done(rest):
        count = shortest_between(0, between, rest, axis, work)
        if count == 0:
            count = braked_ramps(rest, axis, between, work)
        if count <= 0:
            return 0
        count = passing_either_way(count, between, rest, axis, work)
    if spent + total_duration(between, count) >= longest:
        return 0
    used, spent, y, v = write_dip(depth, axis, work[PlanWork.DIP_FIRST, :], phases, work)
    used = join_phases(between, count, phases, used)
    count, spent, y, v = write_dip(depth, axis, work[PlanWork.DIP_LAST, :], trial, work)
    reverse_phases(trial, 0, count)
    return join_phases(trial, count, phases, used)


def shorter_dipped(
    count: int, phases: 'float[:,:]', asked: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> int:
    """Replace a profile of `count` phases by the shortest one with dips; its number of phases."""
    if not set_dips(asked[Problem.V], asked[Problem.A], axis, work[PlanWork.DIP_FIRST, :], work):
        return count
    if not set_dips(asked[Problem.W], -asked[Problem.B], axis, work[PlanWork.DIP_LAST, :], work):
        return count
    if work[PlanWork.DIP_FIRST, Dip.ABOVE] + work[PlanWork.DIP_LAST, Dip.ABOVE] == 0.0:
        return count
    middle = 0.5
    best = -1.0
    for sweep in range(3):
        # depths of 0, 1/4 .. 1, then those between the best one and its neighbours
        for i in range(-2, 3):
            depth = middle + 0.25 * i / 2**sweep
            if sweep > 0 and (i % 2 == 0 or depth < 0.0 or depth > 1.0):
                continue
            longest = total_duration(phases, count) * (1.0 - 1e-9)
            taken = dipped_profile(depth, longest, phases, asked, axis, work)
            if taken > 0:
                count = taken
                best = depth
        if best < 0.0:
            break
        middle = best
    return count
