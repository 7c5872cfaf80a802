"""The lead of one axis: from any state to one from which the planner goes on, or to a velocity.

Settling at once is tried (search.py), and with limits above the snap also following an old plan to
the end of one of its ramps, where all derivatives above the acceleration are zero, and settling
there. Where that takes too long, leads over a level are tried (level.py). A state outside its
limits is brought inside first (brake.py).
"""

from segfmu.kernels.numerics.numbers import EQUAL, EXCEEDED, NEVER
from segfmu.kernels.planner.parameters import axis_limits, ramp_parameters, usual_share
from segfmu.kernels.planner.records import Problem
from segfmu.kernels.planner.sides import set_lower
from segfmu.kernels.settling.brake import find_brake
from segfmu.kernels.settling.brake_limits import is_outside
from segfmu.kernels.settling.level import level_order
from segfmu.kernels.settling.level_search import (
    follow_level,
    hopeful_time,
    jumps_often,
    permits_levels,
    search_levels,
)
from segfmu.kernels.settling.records import Chain, Lead, LeadRows, LeadStage, LeadTask, LeadWork
from segfmu.kernels.settling.search import STEEPEST, leads_in, search_ends, try_steeper
from segfmu.kernels.settling.trial import soonest_ends, time_anew, try_lead
from segfmu.kernels.trajectory.check import rounding_error
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Timing


def settled_end(
    row: int, last: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> bool:
    """Whether a ramp ends with a piece; the row START of `lead` becomes the state there."""
    state = lead[LeadWork.START, :]
    width = coefficients.shape[1]
    length = timing[row, Timing.LENGTH]
    settled = True
    for i in range(width // 2 + 1):
        if row + 1 < last:
            # the start of the next piece has no rounding errors
            state[i] = evaluate_piece(coefficients, row + 1, width, 0.0, i)
        else:
            state[i] = evaluate_piece(coefficients, row, width, length, i)
        if i > 2:
            if abs(state[i]) > EXCEEDED * lead[LeadWork.LIMITS, i]:
                settled = False
            state[i] = 0.0
    state[Chain.TIME] = timing[row, Timing.START] + length
    return settled


def follow_plan(
    order: int, axis: int, plan_offsets: 'int[:]', plan_timing: 'float[:,:]',
    plan_coefficients: 'float[:,:]', limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Try leads that follow the pieces of an axis to the end of a ramp."""
    first = plan_offsets[axis]
    last = plan_offsets[axis + 1]
    tried = 0
    for row in range(first, last):
        place = LeadRows.PIECES + row - first
        if row - first >= 3 * LeadRows.PIECES // 4 or tried >= 8:
            break
        best = lead[LeadWork.BEST, Lead.TIME]
        if best >= 0.0 and plan_timing[row, Timing.START] >= best:
            break
        copy_piece(plan_timing, plan_coefficients, row, timing, coefficients, place)
        if settled_end(row, last, lead, plan_timing, plan_coefficients):
            tried = tried + 1
            soonest_ends(order, lead)
            try_lead(order, place + 1, limits, lead, timing, coefficients)


def find_lead(
    order: int, within: float, axis: int, plan_offsets: 'int[:]', plan_timing: 'float[:,:]',
    plan_coefficients: 'float[:,:]', limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """Find the shortest lead of one axis; False: none keeps the limits.

    With the order 1 it ends at the velocity in the row TARGET of `lead` (LeadWork), with the order
    2 where the planner goes on to the position there. The caller sets that row, the state in the
    row NOW, the row LOWER, and shape and brakes in the row TASK. limits are c_1 .. c_{n+1}, 0 where
    absent.
    The plan to follow has no pieces where there is none; its times count from now on.

    The search ends with a lead that takes `within` [s] at most, to the target. One that takes
    longer is searched for over levels as well. With the order 2 the target is where that one ends;
    nothing is left to be slowed down.

    With 1 in LeadTask.BRAKES, a state that cannot keep the limits is brought inside first
    (brake.py).

    Written: the rows REACHED and BEST, and pieces from the first row on of timing and coefficients,
    which have LeadRows.ALL rows.
    """
    lead[LeadWork.BEST, Lead.TIME] = -1.0
    lead[LeadWork.BEST, Lead.COUNT] = 0.0
    lead[LeadWork.BEST, Lead.STEEP] = 1.0
    brakes = lead[LeadWork.TASK, LeadTask.BRAKES] != 0.0
    smoothness = limits.shape[0] - 1
    if axis < 0 or smoothness < 2 or smoothness > 6 or coefficients.shape[1] != 2 * smoothness:
        return False
    if order == LeadStage.VELOCITY and holds_target(lead):
        if not brakes or not is_outside(limits, lead):
            lead[LeadWork.REACHED, :] = lead[LeadWork.NOW, :]
            lead[LeadWork.BEST, Lead.TIME] = 0.0
            return True
    shape = int(lead[LeadWork.TASK, LeadTask.SHAPE])
    if not brakes or not is_outside(limits, lead):
        if start_search(shape, limits, lead):
            if not search_stages(order, within, limits, lead, timing, coefficients):
                # with limits up to the snap settling at once takes no longer
                if jumps_often(lead):
                    lead[LeadWork.BEST, Lead.GAIN] = 1.0 - EQUAL
                    follow_plan(
                        order, axis, plan_offsets, plan_timing, plan_coefficients, limits, lead,
                        timing, coefficients,
                    )
                improve_lead(order, within, limits, lead, timing, coefficients)
    if brakes and lead[LeadWork.BEST, Lead.TIME] < 0.0:
        search_braked(order, within, shape, limits, lead, timing, coefficients)
    return lead[LeadWork.BEST, Lead.TIME] >= 0.0


def holds_target(lead: 'float[:,:]') -> bool:
    """Whether the row NOW of `lead` has the velocity of the target, and keeps it."""
    if lead[LeadWork.NOW, Chain.DERIVATIVES + 1] != lead[LeadWork.TARGET, Problem.W]:
        return False
    for i in range(2, Chain.SIZE - 1):
        if lead[LeadWork.NOW, i] != 0.0:
            return False
    return True


def start_search(shape: int, limits: 'float[:]', lead: 'float[:,:]') -> bool:
    """Set the axis and the start of a search; False if there are no ramps within the limits."""
    axis_limits(limits.shape[0] - 1, shape, limits, lead[LeadWork.AXIS, :])
    set_lower(lead[LeadWork.LOWER, :], lead[LeadWork.AXIS, :])
    if not ramp_parameters(
        usual_share(lead[LeadWork.AXIS, :]), lead[LeadWork.AXIS, :],
        lead[LeadWork.CHAINS:LeadWork.PLAN, :],
    ):
        return False
    for i in range(1, limits.shape[0]):
        lead[LeadWork.ROUNDING, i] = rounding_error(i, limits)
    lead[LeadWork.START, :] = lead[LeadWork.NOW, :]
    return True


def goes_on_at_level(
    order: int, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """Whether a lead over the present level is the best one so far; then steeper ones are tried.

    That is for limits up to the snap alone, where times seldom jump.
    """
    if jumps_often(lead) or not permits_levels(order, lead):
        return False
    level = lead[LeadWork.START, level_order(order, lead)]
    best = lead[LeadWork.BEST, Lead.TIME]
    found = follow_level(order, level, hopeful_time(lead), limits, lead, timing, coefficients)
    if lead[LeadWork.BEST, Lead.TIME] == best:
        return False
    search_levels(order, found, limits, lead, timing, coefficients)
    return True


def search_stages(
    order: int, within: float, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """Search for a lead by its stages; whether one goes on at its present level.

    Then other ends and levels gain nothing worth their time.
    """
    soonest_ends(order, lead)
    lead[LeadWork.BEST_ENDS, :] = lead[LeadWork.ENDS, :]
    for times in range(STEEPEST):
        if not try_steeper(order, within, times, limits, lead, timing, coefficients):
            break
        if times == 0 and goes_on_at_level(order, limits, lead, timing, coefficients):
            return True
    search_ends(order, within, limits, lead, timing, coefficients)
    return False


def improve_lead(
    order: int, within: float, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search over levels where there is no lead yet.

    Where times jump (`jumps_often`), also for a shorter one, if it takes longer than `within` [s].
    """
    if leads_in(NEVER, lead) and not jumps_often(lead):
        return
    time_anew(order, lead)
    lead[LeadWork.START, :] = lead[LeadWork.NOW, :]
    if permits_levels(order, lead) and not leads_in(within, lead):
        search_levels(order, NEVER, limits, lead, timing, coefficients)


def search_braked(
    order: int, within: float, shape: int, limits: 'float[:]', lead: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> None:
    """Search for a lead behind a brake, or, if there is none, behind one that lets go."""
    lead[LeadWork.GIVEN, :] = lead[LeadWork.NOW, :]
    for repeat in range(2):
        if lead[LeadWork.BEST, Lead.TIME] < 0.0:
            steps = find_brake(repeat == 1, limits, lead, timing, coefficients)
            if steps > 0:
                lead[LeadWork.NOW, :] = lead[LeadWork.BRAKED, :]
                if start_search(shape, limits, lead):
                    if not search_stages(order, within, limits, lead, timing, coefficients):
                        improve_lead(order, within, limits, lead, timing, coefficients)
                lead[LeadWork.NOW, :] = lead[LeadWork.GIVEN, :]
                prepend_brake(steps, lead, timing, coefficients)


def prepend_brake(
    steps: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Put the pieces of a brake before those of the best lead; without room there is no lead."""
    count = int(lead[LeadWork.BEST, Lead.COUNT])
    if lead[LeadWork.BEST, Lead.TIME] < 0.0:
        return
    if count + steps > LeadRows.PIECES:
        lead[LeadWork.BEST, Lead.TIME] = -1.0
        return
    for i in range(count):
        row = count - 1 - i
        copy_piece(timing, coefficients, row, timing, coefficients, row + steps)
    for row in range(steps):
        copy_piece(timing, coefficients, 2 * LeadRows.PIECES + row, timing, coefficients, row)
    lead[LeadWork.BEST, Lead.COUNT] = count + steps
