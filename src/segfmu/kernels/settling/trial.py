"""One lead: settling to given ends, its time, its check, and the best one so far."""

from segfmu.kernels.numerics.numbers import BESIDE, EQUAL, NEARLY, NEVER
from segfmu.kernels.planner.phases import total_duration
from segfmu.kernels.planner.profile import plain_profile, shortest_ramps
from segfmu.kernels.planner.records import Axis, Problem
from segfmu.kernels.planner.sides import side_limit
from segfmu.kernels.settling.chain import chain_limits, set_chains
from segfmu.kernels.settling.level import settle_over_level
from segfmu.kernels.settling.records import Chain, Lead, LeadRows, LeadStage, LeadWork
from segfmu.kernels.settling.stages import append_phases, settle, settle_above, stage_phases
from segfmu.kernels.trajectory.check import check_axis, keep_inside
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.evaluate import evaluate_piece


def set_limits(steep: float, lead: 'float[:,:]') -> None:
    """Set natural limits (`natural_limit`) of the row START of `lead`, and the chains."""
    axis = lead[LeadWork.AXIS, :]
    chain_limits(steep, axis, lead[LeadWork.START, :], lead[LeadWork.LIMITS, :])
    set_chains(steep, axis, lead[LeadWork.LIMITS, :], lead[LeadWork.CHAINS:LeadWork.PLAN, :])


def is_settled(lead: 'float[:,:]') -> bool:
    """Whether all derivatives above the acceleration are zero in the row START of `lead`."""
    for i in range(3, int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) + 1):
        if lead[LeadWork.START, i] != 0.0:
            return False
    return True


def soonest_ends(order: int, lead: 'float[:,:]') -> None:
    """Let all stages end as soon as possible, but the last one at the velocity, if it is one."""
    lead[LeadWork.ENDS, :] = NEVER
    if order == LeadStage.VELOCITY:
        lead[LeadWork.ENDS, order] = lead[LeadWork.TARGET, Problem.W]


def profile_time(ramps: bool, lead: 'float[:,:]') -> float:
    """Duration [s] of the planner's profile from the row STATE to the target; -1: there is none.

    ramps: of ramps of the acceleration alone, which is found sooner.
    """
    state, target = lead[LeadWork.STATE, :], lead[LeadWork.TARGET, :]
    problem, axis = lead[LeadWork.PROBLEM, :], lead[LeadWork.AXIS, :]
    phases = lead[LeadWork.PHASES:LeadWork.AXIS, :]
    for order in range(1, 3):
        value = state[Chain.DERIVATIVES + order]
        if abs(value) > side_limit(order, value, axis) * (1.0 + EQUAL):
            return -1.0
    problem[Problem.V] = state[Chain.DERIVATIVES + 1]
    problem[Problem.A] = state[Chain.DERIVATIVES + 2]
    problem[Problem.W] = target[Problem.W]
    problem[Problem.B] = target[Problem.B]
    problem[Problem.DISTANCE] = target[Problem.DISTANCE] - state[Chain.DERIVATIVES]
    count = -1
    if ramps:
        count = shortest_ramps(problem, axis, phases, lead[LeadWork.PLAN:LeadWork.EXPANSION, :])
    else:
        count = plain_profile(problem, axis, phases, lead[LeadWork.PLAN:LeadWork.EXPANSION, :])
    if count < 0:
        return -1.0
    return total_duration(phases, count)


def time_anew(order: int, lead: 'float[:,:]') -> None:
    """Let the best lead be followed by the planner's profile, no more by that of ramps alone."""
    if order == LeadStage.VELOCITY or lead[LeadWork.BEST, Lead.TIME] < 0.0:
        return
    lead[LeadWork.STATE, :] = lead[LeadWork.REACHED, :]
    rest = profile_time(False, lead)
    if rest >= 0.0:
        time = lead[LeadWork.STATE, Chain.TIME] + rest
        lead[LeadWork.BEST, Lead.TIME] = min(lead[LeadWork.BEST, Lead.TIME], time)


def keep_lead(
    last: int, time: float, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Keep the lead in the second half of the arrays as the best one."""
    first = LeadRows.PIECES
    for row in range(first, last):
        copy_piece(timing, coefficients, row, timing, coefficients, row - first)
    lead[LeadWork.REACHED, :] = lead[LeadWork.STATE, :]
    lead[LeadWork.BEST_ENDS, :] = lead[LeadWork.ENDS, :]
    lead[LeadWork.BEST, Lead.TIME] = time
    lead[LeadWork.BEST, Lead.COUNT] = last - first


def begins_now(lead: 'float[:,:]', coefficients: 'float[:,:]') -> bool:
    """Whether the lead in the second half of the pieces begins in the state of the row NOW."""
    width = coefficients.shape[1]
    for i in range(1, width // 2 + 1):
        value = evaluate_piece(coefficients, LeadRows.PIECES, width, 0.0, i)
        if not abs(value - lead[LeadWork.NOW, i]) <= BESIDE * lead[LeadWork.LIMITS, i]:
            return False
    return True


def is_better(time: float, lead: 'float[:,:]') -> bool:
    """Whether a lead that takes `time` [s] would be the best one so far."""
    best = lead[LeadWork.BEST, Lead.TIME]
    return best < 0.0 or time < best * lead[LeadWork.BEST, Lead.GAIN]


def keep_better(
    last: int, time: float, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """Keep a lead that takes `time` [s] and ends before the row `last`, if it is the best one."""
    first = LeadRows.PIECES
    if not is_better(time, lead):
        return False
    check, lower = lead[LeadWork.CHECK:LeadWork.SIZE, :], lead[LeadWork.LOWER, :]
    if last > first:
        if not begins_now(lead, coefficients):
            return False
        keep_inside(check)
        if not check_axis(
            first, last, timing, coefficients, limits, lower, NEARLY, 0.5 * NEARLY, check
        ):
            return False
    keep_lead(last, time, lead, timing, coefficients)
    lead[LeadWork.BEST, Lead.GAIN] = 1.0 - EQUAL
    return True


def try_lead(
    order: int, row: int, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """Settle from `row` on to the ends in the row ENDS; the time to the target [s].

    NEVER: there is none, or the best one so far is at the target before this one settles. The lead
    is kept if it is the best one. Rows of the second half before `row` belong to it as they are.
    """
    if order == LeadStage.VELOCITY:
        return try_velocity(row, limits, lead, timing, coefficients)
    last = settle(order, row, lead, timing, coefficients)
    if last < 0:
        return NEVER
    time = lead[LeadWork.STATE, Chain.TIME]
    best = lead[LeadWork.BEST, Lead.TIME]
    if best >= 0.0 and time >= best:
        return NEVER
    rest = profile_time(True, lead)
    if rest < 0.0:
        return NEVER
    time = time + rest
    keep_better(last, time, limits, lead, timing, coefficients)
    return time


def try_velocity(
    row: int, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """`try_lead` to a velocity. The last stage has pieces only where the lead is the best one."""
    order = int(LeadStage.VELOCITY)
    row = settle_above(order, row, lead, timing, coefficients)
    if row < 0:
        return NEVER
    end = lead[LeadWork.ENDS, order]
    count = stage_phases(order, end, False, lead)
    if count < 0:
        return NEVER
    phases = lead[LeadWork.PHASES:LeadWork.AXIS, :]
    time = lead[LeadWork.STATE, Chain.TIME] + total_duration(phases, count)
    if not is_better(time, lead):
        return time
    last = append_phases(order, end, count, row, lead, timing, coefficients)
    if last < 0:
        return NEVER
    time = lead[LeadWork.STATE, Chain.TIME]
    keep_better(last, time, limits, lead, timing, coefficients)
    return time


def try_level(
    order: int, level: float, least: float, limits: 'float[:]', lead: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> float:
    """Settle over a level in less than `least` [s]; its time, NEVER if it fails.

    The lead is kept if it is the best one so far.
    """
    last = settle_over_level(order, level, least, LeadRows.PIECES, lead, timing, coefficients)
    if last < 0:
        return NEVER
    time = lead[LeadWork.STATE, Chain.TIME]
    keep_better(last, time, limits, lead, timing, coefficients)
    return time
