"""The durations at which a gap between feasible durations can end.

Outside a gap, profiles of the same duration cover distances on both sides of the required one. A
gap can end where a profile covers exactly the required distance: it belongs to the families of the
shortest profile. Where a new kind of profile begins to exist, which is rare, none of them tells
(intervals.py).
"""

from segfmu.kernels.numerics.numbers import GAINED
from segfmu.kernels.planner.braking import braked
from segfmu.kernels.planner.cruise import slower_cruise, with_cruise
from segfmu.kernels.planner.forms import usual_duration
from segfmu.kernels.planner.merged import same_members, set_family, set_member, tempered_form
from segfmu.kernels.planner.phases import valid_duration
from segfmu.kernels.planner.records import Axis, PlanWork


def insert_end(duration: float, after: float, count: int, ends: 'float[:,:]') -> int:
    """Insert a duration above `after` in the sorted first column of ends; the longest drops out."""
    if duration <= after:
        return count
    place = count
    while place > 0 and ends[place - 1, 0] > duration:
        place = place - 1
    if place > 0 and duration - ends[place - 1, 0] <= GAINED * duration:
        return count
    count = min(count + 1, ends.shape[0])
    for j in range(count - 1 - place):
        i = count - 1 - j
        ends[i, 0] = ends[i - 1, 0]
    if place < count:
        ends[place, 0] = duration
    return count


def covering_ends(
    spent: float, after: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]',
    count: int,
) -> int:
    """Insert the durations of all candidates of the shortest profile that cover the distance.

    `spent` is the duration of braking, `count` the number of durations; returns the new number.
    """
    phases = work[PlanWork.TRIAL:PlanWork.BEST, :]
    ends, family = work[PlanWork.GAP_ENDS:PlanWork.NEAREST, :], work[PlanWork.FAMILY, :]
    usual = usual_duration(problem, axis)
    for form in range(3):
        if form == 0:
            taken = slower_cruise(phases, problem, axis)
        else:
            cruise = -axis[Axis.LOWER] if form == 2 else axis[Axis.VELOCITY]
            taken = with_cruise(phases, cruise, problem, axis)
        count = insert_covering(phases, taken, spent, after, problem, axis, count, ends)
    for branch in range(4):
        if same_members(branch, problem, family):
            continue
        set_family(branch, problem, axis, family)
        for member in range(4):
            set_member(member, usual, False, family)
            taken = tempered_form(phases, family, axis)
            if taken < 0:
                break
            count = insert_covering(phases, taken, spent, after, problem, axis, count, ends)
    return count


def insert_covering(
    phases: 'float[:,:]', taken: int, spent: float, after: float, problem: 'float[:]',
    axis: 'float[:]', count: int, ends: 'float[:,:]',
) -> int:
    """Insert the duration of `taken` phases, if they are valid."""
    if taken <= 0:
        return count
    duration = valid_duration(phases, taken, problem, axis)
    if duration < 0.0:
        return count
    return insert_end(spent + duration, after, count, ends)


def gap_ends(after: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> int:
    """Write the shortest durations above a given one at which a gap can end; returns their number.

    They are in ascending order in the first column of the rows GAP_ENDS of `work`, at most one per
    row.
    """
    rest = work[PlanWork.REST, :]
    count = 0
    for variant in range(4):
        taken, spent = braked(variant, problem, axis, work)
        if taken < 0:
            continue
        count = covering_ends(spent, after, rest, axis, work, count)
    return count
