"""The paper's form with prescribed duration: the cruise velocity that covers the distance.

A cruise velocity is possible if its velocity changes leave time for a cruise. The possible ones
form one or several windows; within a window the distance is continuous.
"""

from segfmu.kernels.numerics.numbers import EQUAL, GAINED, HALVINGS, ROUNDED, SAMPLES
from segfmu.kernels.numerics.roots import next_bracket, next_point, root_share
from segfmu.kernels.planner.cruise import cruise_form
from segfmu.kernels.planner.phases import copy_phases, insert_hold, measure_phases, speed_bound
from segfmu.kernels.planner.records import Cell, Nearest, PlanWork, Problem
from segfmu.kernels.planner.sides import is_beyond, slowest_velocity

# of the change of a cruise velocity that the distance needs, by how much more it is changed at
# first: a mean with a velocity much farther away is another motion
WIDER = 2.5


def timed_cruise(
    phases: 'float[:,:]', cruise: float, problem: 'float[:]', axis: 'float[:]'
) -> 'tuple[int, float, float]':
    """The paper's form with the cruise that makes it last the problem's duration.

    Returns the number of phases, the distance, and the duration of the cruise, which is negative if
    the form takes longer; the number is -1 if the form does not exist.
    """
    count, row, duration, y = cruise_form(phases, cruise, problem, axis)
    if count < 0:
        return -1, 0.0, -1.0
    hold = problem[Problem.DURATION] - duration
    count = insert_hold(phases, count, row, 0.0, hold)
    return count, y + cruise * hold, hold


def cruise_range(
    phases: 'float[:,:]', middle: float, y: float, hold: float, problem: 'float[:]',
    axis: 'float[:]',
) -> float:
    """A possible cruise velocity that, if there is one, covers at least the distance.

    The velocity `middle` is possible and covers y with a cruise of the duration `hold`; the search
    goes from there to the fastest velocity on the side of the distance. If there is no such
    velocity, the last possible one is returned.
    """
    distance = problem[Problem.DISTANCE]
    limit = speed_bound(1.0, problem[Problem.DURATION], problem, axis)
    if y > distance:
        limit = -speed_bound(-1.0, problem[Problem.DURATION], problem, axis)
    inside = middle
    outside = limit
    failed = False
    missing = distance - y
    # the distance grows with the cruise velocity by about its duration and half of the ramps'
    cruise = middle + WIDER * missing / (problem[Problem.DURATION] + hold)
    if cruise * limit > limit * limit:
        cruise = limit
    for i in range(HALVINGS):
        # the distance changes as if all velocities changed by twice as much, at most
        if abs(missing) > 2.0 * problem[Problem.DURATION] * abs(outside - inside):
            break
        count, y_cruise, hold = timed_cruise(phases, cruise, problem, axis)
        if count >= 0 and hold >= 0.0:
            inside = cruise
            if (y_cruise - distance) * missing >= 0.0 or cruise == limit:
                break
            missing = distance - y_cruise
        else:
            outside = cruise
            failed = True
        cruise = limit
        if failed:
            cruise = 0.5 * (inside + outside)
            if cruise == inside or cruise == outside:
                break
    return inside


def keep_nearest(
    count: int, problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Keep the trial profile if it is the nearest one below or above the distance.

    It must last the problem's duration. The phases go to the cell, their number and distance to the
    row NEAREST of `work`.
    """
    if count <= 0:
        return
    trial, nearest = work[PlanWork.TRIAL:PlanWork.BEST, :], work[PlanWork.NEAREST, :]
    distance, target = problem[Problem.DISTANCE], problem[Problem.DURATION]
    most = slowest_velocity(axis) * (1.0 + EQUAL)
    duration, y, end, lowest, highest = measure_phases(trial, count, problem[Problem.V], most, axis)
    if is_beyond(lowest, highest, 1.0 + EQUAL, axis):
        return
    if abs(duration - target) > GAINED * target:
        return
    if abs(end - problem[Problem.W]) > GAINED * max(-lowest, highest):
        return
    below = nearest[Nearest.BELOW_COUNT] > 0.0
    if y <= distance and (not below or y > nearest[Nearest.BELOW_DISTANCE]):
        copy_phases(trial, cell[Cell.BELOW:Cell.ABOVE, :], count)
        nearest[Nearest.BELOW_COUNT] = count
        nearest[Nearest.BELOW_DISTANCE] = y
    above = nearest[Nearest.ABOVE_COUNT] > 0.0
    if y >= distance and (not above or y < nearest[Nearest.ABOVE_DISTANCE]):
        copy_phases(trial, cell[Cell.ABOVE:Cell.PROBLEM, :], count)
        nearest[Nearest.ABOVE_COUNT] = count
        nearest[Nearest.ABOVE_DISTANCE] = y


def is_enclosed(work: 'float[:,:]') -> bool:
    """Whether profiles on both sides of the distance are kept."""
    nearest = work[PlanWork.NEAREST, :]
    return nearest[Nearest.BELOW_COUNT] > 0.0 and nearest[Nearest.ABOVE_COUNT] > 0.0


def keep_cruise(
    cruise: float, problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> float:
    """Try a cruise velocity and keep its profile if it is the nearest one; returns its distance."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    count, y, hold = timed_cruise(trial, cruise, problem, axis)
    keep_nearest(count, problem, axis, cell, work)
    return y


def between_cruises(
    lower: float, upper: float, e_lower: float, e_upper: float, problem: 'float[:]',
    axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]',
) -> None:
    """Search for the cruise velocity that covers the distance.

    e_lower and e_upper are the excess distances of the two velocities [m].
    """
    distance = problem[Problem.DISTANCE]
    newest, other, before = upper, lower, lower
    e_newest, e_other = e_upper, e_lower
    e_before = e_other
    speed = abs(problem[Problem.V]) + abs(problem[Problem.W])
    rounding = ROUNDED * (abs(distance) + speed * problem[Problem.DURATION])
    for i in range(HALVINGS):
        if e_newest == 0.0 or e_other == 0.0:
            return
        share = root_share(newest, other, before, e_newest, e_other, e_before)
        if i == 0:
            # the distance is nearly linear
            share = e_newest / (e_newest - e_other)
        cruise = newest + share * (other - newest)
        if cruise == newest or cruise == other:
            return
        error = keep_cruise(cruise, problem, axis, cell, work) - distance
        if abs(error) <= rounding:
            return
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            error * e_newest < 0.0, cruise, error, newest, other, e_newest, e_other
        )


def cruise_edge(
    inside: float, outside: float, h_inside: float, h_outside: float, phases: 'float[:,:]',
    problem: 'float[:]', axis: 'float[:]',
) -> float:
    """The last possible cruise velocity between a possible one and an impossible one.

    h_inside and h_outside are the durations of their cruises, 0 where there is none [s].
    """
    newest, other, before = outside, inside, inside
    h_newest, h_other, h_before = h_outside, h_inside, h_inside
    for i in range(HALVINGS):
        if newest == other:
            break
        cruise = next_point(newest, other, before, h_newest, h_other, h_before)
        if cruise == newest or cruise == other:
            break
        count, y, hold = timed_cruise(phases, cruise, problem, axis)
        fits = count >= 0 and hold >= 0.0
        if count < 0:
            hold = 0.0
        newest, other, before, h_newest, h_other, h_before = next_bracket(
            fits != (newest == inside), cruise, hold, newest, other, h_newest, h_other
        )
        if fits:
            inside = cruise
            if hold <= EQUAL * problem[Problem.DURATION]:
                break
        else:
            outside = cruise
    return inside


def scan_cruises(
    problem: 'float[:]', axis: 'float[:]', cell: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Nearest profiles with a cruise, over all windows of possible cruise velocities."""
    trial = work[PlanWork.TRIAL:PlanWork.BEST, :]
    distance = problem[Problem.DISTANCE]
    fastest = speed_bound(1.0, problem[Problem.DURATION], problem, axis)
    backwards = speed_bound(-1.0, problem[Problem.DURATION], problem, axis)
    inside, before, e_before, h_before = False, 0.0, 0.0, 0.0
    for i in range(SAMPLES + 1):
        cruise = fastest * (2.0 * i / SAMPLES - 1.0)
        if cruise < 0.0:
            cruise = backwards * (2.0 * i / SAMPLES - 1.0)
        count, y, hold = timed_cruise(trial, cruise, problem, axis)
        error = y - distance
        fits = count >= 0 and hold >= 0.0
        if count < 0:
            hold = 0.0
        if fits:
            keep_nearest(count, problem, axis, cell, work)
        if i > 0 and (inside or fits):
            lower = before
            e_lower = e_before
            upper = cruise
            e_upper = error
            if not inside:
                lower = cruise_edge(cruise, before, hold, h_before, trial, problem, axis)
                e_lower = keep_cruise(lower, problem, axis, cell, work) - distance
            if not fits:
                upper = cruise_edge(before, cruise, h_before, hold, trial, problem, axis)
                e_upper = keep_cruise(upper, problem, axis, cell, work) - distance
            if e_lower * e_upper <= 0.0:
                between_cruises(lower, upper, e_lower, e_upper, problem, axis, cell, work)
            if is_enclosed(work):
                return
        inside, before = fits, cruise
        e_before, h_before = error, hold
