"""The durations at which a gap between feasible durations can end.

Outside a gap, profiles of the same duration cover distances on both sides of the required one. A
gap ends in one of two ways. Either a profile covers exactly the required distance; then it belongs
to the families of the shortest profile. Or a new kind of profile begins to exist, at the minimum of
the duration over a family.
"""

from segfmu.kernels.numerics.numbers import GAINED, GOLDEN, NEVER, SAMPLES, SECTIONS
from segfmu.kernels.planner.braking import braked
from segfmu.kernels.planner.cruise import cruise_form, slower_cruise, with_cruise
from segfmu.kernels.planner.forms import usual_duration
from segfmu.kernels.planner.merged import same_members, set_family, set_member, tempered_form
from segfmu.kernels.planner.phases import speed_bound, valid_duration
from segfmu.kernels.planner.records import Axis, PlanWork, Problem


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


def cruise_times(
    cruise: float, problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]'
) -> 'tuple[float, float]':
    """Duration of the paper's form, and that with the cruise that covers the distance.

    NEVER if there is no such form.
    """
    count, row, duration, y = cruise_form(phases, cruise, problem, axis)
    if count < 0:
        return NEVER, NEVER
    rest = problem[Problem.DISTANCE] - y
    if rest * cruise <= 0.0:
        return duration, NEVER
    return duration, duration + rest / cruise


def cruise_time(
    cruise: float, covering: bool, problem: 'float[:]', axis: 'float[:]', phases: 'float[:,:]'
) -> float:
    """One of both (`cruise_times`)."""
    duration, covered = cruise_times(cruise, problem, axis, phases)
    return covered if covering else duration


def turning_time(
    lower: float, upper: float, covering: bool, problem: 'float[:]', axis: 'float[:]',
    phases: 'float[:,:]',
) -> float:
    """The least `cruise_time` between two cruise velocities, by golden section."""
    p = upper - GOLDEN * (upper - lower)
    q = lower + GOLDEN * (upper - lower)
    t_p = cruise_time(p, covering, problem, axis, phases)
    t_q = cruise_time(q, covering, problem, axis, phases)
    for i in range(SECTIONS):
        if t_p <= t_q:
            upper = q
            q = p
            t_q = t_p
            p = upper - GOLDEN * (upper - lower)
            t_p = cruise_time(p, covering, problem, axis, phases)
        else:
            lower = p
            p = q
            t_p = t_q
            q = lower + GOLDEN * (upper - lower)
            t_q = cruise_time(q, covering, problem, axis, phases)
    return min(t_p, t_q)


def insert_turn(
    sample: int, covering: bool, least: float, spent: float, after: float, fastest: float,
    backwards: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]', count: int,
) -> int:
    """Insert the minimum of `cruise_time` next to a sample, which takes `least` [s]."""
    # the minimum is shorter still
    if spent + least <= after:
        return count
    phases = work[PlanWork.TRIAL:PlanWork.BEST, :]
    ends = work[PlanWork.GAP_ENDS:PlanWork.NEAREST, :]
    lower = cruise_sample(max(sample - 1, 0), fastest, backwards)
    upper = cruise_sample(min(sample + 1, SAMPLES), fastest, backwards)
    turn = turning_time(lower, upper, covering, problem, axis, phases)
    return insert_end(spent + min(turn, least), after, count, ends)


def cruise_sample(sample: int, fastest: float, backwards: float) -> float:
    """One of 25 cruise velocities up to the fastest one, in both directions."""
    share = 2.0 * sample / SAMPLES - 1.0
    return backwards * share if share < 0.0 else fastest * share


def turning_ends(
    spent: float, after: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]',
    count: int,
) -> int:
    """Insert the minima of `cruise_times` over all cruise velocities.

    `spent` is the duration of braking, `count` the number of durations; returns the new number.
    """
    phases = work[PlanWork.TRIAL:PlanWork.BEST, :]
    first, second, first_covered, second_covered = NEVER, NEVER, NEVER, NEVER
    # gaps that end later are of no use
    fastest = speed_bound(1.0, 4.0 * after, problem, axis)
    backwards = speed_bound(-1.0, 4.0 * after, problem, axis)
    for i in range(SAMPLES + 2):
        third, third_covered = NEVER, NEVER
        if i < SAMPLES + 1:
            cruise = cruise_sample(i, fastest, backwards)
            third, third_covered = cruise_times(cruise, problem, axis, phases)
        if second < NEVER and first >= second and third >= second:
            count = insert_turn(
                i - 1, False, second, spent, after, fastest, backwards, problem, axis, work, count
            )
        if second_covered < NEVER and first_covered >= second_covered:
            if third_covered >= second_covered:
                count = insert_turn(
                    i - 1, True, second_covered, spent, after, fastest, backwards, problem, axis,
                    work, count,
                )
        first = second
        second = third
        first_covered = second_covered
        second_covered = third_covered
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
        count = turning_ends(spent, after, rest, axis, work, count)
    return count
