"""Two profiles of ramps that last a duration, one short of the distance and one beyond it.

Their weighted mean covers it. They are in the two lists of phases of a cell (Cell), their counts
and distances in the row NEAREST of the work space.
"""

from segfmu.kernels.numerics.numbers import COVERED
from segfmu.kernels.planner.braking import surround
from segfmu.kernels.planner.merged import same_members, set_family, set_member, tempered_form
from segfmu.kernels.planner.phases import fit_duration, speed_bound
from segfmu.kernels.planner.records import Cell, Nearest, PlanWork, Problem
from segfmu.kernels.planner.timed_cruise import (
    between_cruises,
    cruise_range,
    is_enclosed,
    keep_cruise,
    keep_nearest,
    scan_cruises,
    timed_cruise,
)


def timed_merged(
    problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Nearest profiles of the merged form, on all of its branches."""
    trial, family = work[PlanWork.TRIAL:PlanWork.BEST, :], work[PlanWork.FAMILY, :]
    for branch in range(4):
        if same_members(branch, problem, family):
            continue
        set_family(branch, problem, axis, family)
        for member in range(2):
            set_member(member, problem[Problem.DURATION], True, family)
            count = tempered_form(trial, family, axis)
            if count < 0:
                break
            keep_nearest(count, problem, axis, cell, work)


def usual_cruise(
    problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """The paper's form with a cruise about as fast as the mean velocity, if there is one."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    v, w, distance = problem[Problem.V], problem[Problem.W], problem[Problem.DISTANCE]
    middle = min(max(distance / problem[Problem.DURATION], min(v, w)), max(v, w))
    count, y, hold = timed_cruise(trial, middle, problem, axis)
    if count >= 0 and hold >= 0.0:
        keep_nearest(count, problem, axis, cell, work)
        edge = cruise_range(trial, middle, y, hold, problem, axis)
        y_edge = keep_cruise(edge, problem, axis, cell, work)
        if is_enclosed(work):
            between_cruises(
                middle, edge, y - distance, y_edge - distance, problem, axis, cell, work
            )


def timed_between(
    problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Nearest profiles below and above the distance, without braking."""
    usual_cruise(problem, axis, cell, work)
    if not is_enclosed(work):
        scan_cruises(problem, axis, cell, work)
    if not is_enclosed(work):
        timed_merged(problem, axis, cell, work)


def note_known(work: 'float[:,:]') -> None:
    """Note on which side of the distance a profile is kept (Nearest.KNOWN), on one at most."""
    nearest = work[PlanWork.NEAREST, :]
    nearest[Nearest.KNOWN] = 0.0
    if nearest[Nearest.BELOW_COUNT] > 0.0:
        nearest[Nearest.KNOWN] = -1.0
    elif nearest[Nearest.ABOVE_COUNT] > 0.0:
        nearest[Nearest.KNOWN] = 1.0


def clear_nearest(work: 'float[:,:]') -> None:
    """Forget the profiles next to the distance."""
    work[PlanWork.NEAREST, Nearest.BELOW_COUNT] = 0.0
    work[PlanWork.NEAREST, Nearest.ABOVE_COUNT] = 0.0


def nearest_weight(problem: 'float[:]', axis: 'float[:]', nearest: 'float[:]') -> float:
    """Share of the profile above in the weighted mean that covers the distance."""
    distance = problem[Problem.DISTANCE]
    below, above = nearest[Nearest.BELOW_DISTANCE], nearest[Nearest.ABOVE_DISTANCE]
    target = problem[Problem.DURATION]
    speed = speed_bound(1.0, target, problem, axis)
    speed = max(speed, speed_bound(-1.0, target, problem, axis))
    # one profile is enough if it misses the distance by rounding
    tiny = COVERED * (abs(distance) + speed * target)
    if above - distance <= tiny:
        return 1.0
    if distance - below > tiny:
        return (distance - below) / (above - below)
    return 0.0


def surround_nearest(
    variant: int, axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Add a variant's braking phases to both profiles, and give them the exact duration."""
    problem, nearest = work[PlanWork.PROBLEM, :], work[PlanWork.NEAREST, :]
    below, above = cell[Cell.BELOW:Cell.ABOVE, :], cell[Cell.ABOVE:Cell.PROBLEM, :]
    count = int(nearest[Nearest.BELOW_COUNT])
    count = surround(below, count, variant, problem, axis, work)
    nearest[Nearest.BELOW_COUNT] = fit_duration(below, count, problem[Problem.DURATION])
    count = int(nearest[Nearest.ABOVE_COUNT])
    count = surround(above, count, variant, problem, axis, work)
    nearest[Nearest.ABOVE_COUNT] = fit_duration(above, count, problem[Problem.DURATION])
