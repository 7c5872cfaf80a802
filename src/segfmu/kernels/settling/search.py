"""The shortest lead by settling: its stages end where all of it takes the least time.

The last stage of a lead that ends at a velocity (order 1) leads to it; a lead to where the planner
takes over (order 2) may end at any acceleration, and the planner's profile belongs to its time. All
other ends are free. The search starts from the soonest ends, goes to the level that the following
profile wants first, over a grid, and refines by halved steps.
"""

from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import Axis, Phase, Problem
from segfmu.kernels.settling.chain import chain_limits, set_chains
from segfmu.kernels.settling.records import Chain, Lead, LeadRows, LeadWork
from segfmu.kernels.settling.stages import settle
from segfmu.kernels.trajectory.check import check_axis
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Timing


def profile_time(lead: 'float[:,:]') -> float:
    """Duration [s] of the planner's profile from the row STATE to the target; -1: there is none."""
    state = lead[LeadWork.STATE, :]
    target = lead[LeadWork.TARGET, :]
    problem = lead[LeadWork.PROBLEM, :]
    axis = lead[LeadWork.AXIS, :]
    phases = lead[LeadWork.PHASES:LeadWork.AXIS, :]
    if abs(state[Chain.DERIVATIVES + 1]) > axis[Axis.VELOCITY] * (1.0 + 1e-12):
        return -1.0
    if abs(state[Chain.DERIVATIVES + 2]) > axis[Axis.ACCELERATION] * (1.0 + 1e-12):
        return -1.0
    problem[Problem.V] = state[Chain.DERIVATIVES + 1]
    problem[Problem.A] = state[Chain.DERIVATIVES + 2]
    problem[Problem.W] = target[Problem.W]
    problem[Problem.B] = target[Problem.B]
    problem[Problem.DISTANCE] = target[Problem.DISTANCE] - state[Chain.DERIVATIVES]
    count = shortest_profile(problem, axis, phases, lead[LeadWork.PLAN:LeadWork.EXPANSION, :])
    if count < 0:
        return -1.0
    duration = 0.0
    for i in range(count):
        duration = duration + phases[i, Phase.DURATION]
    return duration


def keep_lead(
    last: int, time: float, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> None:
    """Keep the lead in the second half of the arrays as the best one."""
    first = LeadRows.PIECES
    for row in range(first, last):
        for i in range(Timing.SIZE):
            timing[row - first, i] = timing[row, i]
        for i in range(coefficients.shape[1]):
            coefficients[row - first, i] = coefficients[row, i]
    for i in range(Chain.SIZE):
        lead[LeadWork.REACHED, i] = lead[LeadWork.STATE, i]
        lead[LeadWork.BEST_ENDS, i] = lead[LeadWork.ENDS, i]
    lead[LeadWork.BEST, Lead.TIME] = time
    lead[LeadWork.BEST, Lead.COUNT] = last - first


def begins_now(lead: 'float[:,:]', coefficients: 'float[:,:]') -> bool:
    """Whether the lead in the second half of the pieces begins in the state of the row NOW."""
    width = coefficients.shape[1]
    for i in range(1, width // 2 + 1):
        value = evaluate_piece(coefficients, LeadRows.PIECES, width, 0.0, i)
        if not abs(value - lead[LeadWork.NOW, i]) <= 1e-11 * lead[LeadWork.LIMITS, i]:
            return False
    return True


def try_lead(
    order: int,
    row: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """Settle from `row` on to the ends in the row ENDS; keep the lead if it is the best one so far.

    Rows of the second half before `row` belong to the lead as they are.
    """
    first = LeadRows.PIECES
    last = settle(order, row, lead, timing, coefficients)
    if last < 0:
        return False
    time = lead[LeadWork.STATE, Chain.TIME]
    if order == 2:
        rest = profile_time(lead)
        if rest < 0.0:
            return False
        time = time + rest
    best = lead[LeadWork.BEST, Lead.TIME]
    if best >= 0.0 and not time < best * lead[LeadWork.BEST, Lead.GAIN]:
        return False
    check = lead[LeadWork.CHECK:LeadWork.SIZE, :]
    if last > first:
        if not begins_now(lead, coefficients):
            return False
        if not check_axis(first, last, timing, coefficients, limits, 1e-9, check):
            return False
    keep_lead(last, time, lead, timing, coefficients)
    lead[LeadWork.BEST, Lead.GAIN] = 1.0 - 1e-12
    return True


def try_end(
    order: int,
    stage: int,
    end: float,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> bool:
    """`try_lead` with the ends of the best lead, but one of them changed."""
    bound = lead[LeadWork.LIMITS, stage]
    for i in range(Chain.SIZE):
        lead[LeadWork.ENDS, i] = lead[LeadWork.BEST_ENDS, i]
    lead[LeadWork.ENDS, stage] = min(max(end, -bound), bound)
    return try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)


def search_end(
    order: int,
    stage: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Improve the end of one stage: over a grid, then by halved steps."""
    bound = lead[LeadWork.LIMITS, stage]
    for i in range(-4, 5):
        try_end(order, stage, 0.25 * i * bound, limits, lead, timing, coefficients)
    step = 0.125 * bound
    for i in range(10):
        end = lead[LeadWork.BEST_ENDS, stage]
        if end > 1e299:
            break
        if not try_end(order, stage, end + step, limits, lead, timing, coefficients):
            if not try_end(order, stage, end - step, limits, lead, timing, coefficients):
                step = 0.5 * step


def follow_profile(
    order: int,
    stage: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """End a stage at the first level of the profile that follows."""
    first = lead[LeadWork.PHASES, :]
    for i in range(3):
        if first[Phase.ABOVE] > 0.5:
            break
        level = first[Phase.ACCELERATION] + first[Phase.CHANGE]
        if not try_end(order, stage, level, limits, lead, timing, coefficients):
            break


def is_settled(state: 'float[:]', smoothness: int) -> bool:
    """Whether all derivatives above the acceleration are zero in a state (Chain)."""
    for i in range(3, smoothness + 1):
        if state[i] != 0.0:
            return False
    return True


def search_ends(
    order: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Try the soonest ends of all stages, then search for better ones unless all is settled."""
    smoothness = int(lead[LeadWork.AXIS, Axis.SMOOTHNESS])
    for i in range(Chain.SIZE):
        lead[LeadWork.ENDS, i] = 1e300
    first_free = order
    if order == 1:
        lead[LeadWork.ENDS, order] = lead[LeadWork.TARGET, Problem.W]
        first_free = order + 2
    for i in range(Chain.SIZE):
        lead[LeadWork.BEST_ENDS, i] = lead[LeadWork.ENDS, i]
    try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)
    if is_settled(lead[LeadWork.START, :], smoothness):
        return
    for sweep in range(2):
        for i in range(2):
            stage = first_free + 2 * i
            if stage < smoothness:
                if i == 0:
                    follow_profile(order, stage, limits, lead, timing, coefficients)
                search_end(order, stage, limits, lead, timing, coefficients)
        if first_free + 2 >= smoothness:
            break


def search_lead(
    order: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search for the best lead from the row START.

    Derivatives that nothing limits are raised as long as that shortens it by more than 1 %.
    """
    axis = lead[LeadWork.AXIS, :]
    steep = 1.0
    for i in range(4):
        chain_limits(steep, axis, lead[LeadWork.START, :], lead[LeadWork.LIMITS, :])
        set_chains(steep, axis, lead[LeadWork.LIMITS, :], lead[LeadWork.CHAINS:LeadWork.PLAN, :])
        lead[LeadWork.BEST, Lead.GAIN] = 0.99
        before = lead[LeadWork.BEST, Lead.TIME]
        if before >= 0.0:
            for j in range(Chain.SIZE):
                lead[LeadWork.ENDS, j] = lead[LeadWork.BEST_ENDS, j]
            gained = try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)
            # before a gap of durations the best ends move: they are searched for once more
            if i > 1 and not gained:
                break
        search_ends(order, limits, lead, timing, coefficients)
        steep = 10.0 * steep
