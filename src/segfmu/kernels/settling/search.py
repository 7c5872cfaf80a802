"""The shortest lead by settling: its stages end where all of it takes the least time.

The last stage of a lead that ends at a velocity (order 1) leads to it; a lead to where the planner
takes over (order 2) may end at any acceleration, and the planner's profile belongs to its time. All
other ends are free. The soonest ends, and the level that the following profile wants first, also
tell how steep the rises of derivatives have to be that nothing limits. Other ends are searched for
by halved steps, or over a grid where the soonest are the best. The search counts with profiles of
ramps alone, which are found sooner.
"""

from segfmu.kernels.numerics.numbers import EQUAL, FINE, NEVER
from segfmu.kernels.planner.records import Axis, Phase
from segfmu.kernels.settling.chain import STEEPER
from segfmu.kernels.settling.records import Lead, LeadRows, LeadStage, LeadWork
from segfmu.kernels.settling.trial import is_settled, set_limits, soonest_ends, try_lead

# steps around the best end: the first one, as a share of its limit, halved where it gains nothing
FIRST_STEP = 0.125
STEPS = 10
# ends of a grid on each side of zero, and each one over the next larger one
ENDS = 4
FINER = 0.25
# levels in turn: of profiles behind a lead, or next to the best one
TURNS = 8
# derivatives that nothing limits are raised (STEEPER) so often, as long as the time of a lead
# becomes less than this share
STEEPEST = 4
WORTH_STEEPER = 0.99


def try_end(
    order: int, stage: int, end: float, limits: 'float[:]', lead: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> float:
    """`try_lead` with the ends of the best lead, but one of them changed."""
    bound = lead[LeadWork.LIMITS, stage]
    lead[LeadWork.ENDS, :] = lead[LeadWork.BEST_ENDS, :]
    lead[LeadWork.ENDS, stage] = min(max(end, -bound), bound)
    return try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)


def search_end(
    order: int, stage: int, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Improve the end of one stage by halved steps; where it is any, over a grid first."""
    bound = lead[LeadWork.LIMITS, stage]
    if lead[LeadWork.BEST_ENDS, stage] >= NEVER or lead[LeadWork.BEST, Lead.TIME] < 0.0:
        try_end(order, stage, 0.0, limits, lead, timing, coefficients)
        end = bound
        for i in range(ENDS):
            try_end(order, stage, end, limits, lead, timing, coefficients)
            try_end(order, stage, -end, limits, lead, timing, coefficients)
            end = FINER * end
    step = FIRST_STEP * bound
    for i in range(STEPS):
        around = lead[LeadWork.BEST_ENDS, stage]
        if around >= NEVER:
            break
        nearest = NEVER
        for side in range(2):
            end = around + step * (1 - 2 * side)
            # beyond the limit there is nothing but the limit itself
            if abs(end) <= bound or abs(around) < bound:
                time = try_end(order, stage, end, limits, lead, timing, coefficients)
                # a sooner one that is not kept breaks a limit
                if time >= lead[LeadWork.BEST, Lead.TIME]:
                    nearest = min(nearest, time)
        if lead[LeadWork.BEST_ENDS, stage] == around:
            # steps to its side, and to the other one, gain less
            if nearest <= (1.0 + FINE) * lead[LeadWork.BEST, Lead.TIME]:
                break
            step = 0.5 * step


def leads_in(time: float, lead: 'float[:,:]') -> bool:
    """Whether there is a lead that takes `time` [s] at most."""
    return 0.0 <= lead[LeadWork.BEST, Lead.TIME] <= time


def try_soonest(
    order: int, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Try the soonest ends of all stages, and those at the first level of what follows.

    The level of the profile behind such a lead is tried in turn, as long as that shortens it: of an
    axis that waits as well, which the drives follow with less effort from there.
    """
    first = lead[LeadWork.PHASES, :]
    stage = first_free_stage(order)
    soonest_ends(order, lead)
    time = try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)
    if is_settled(lead) or stage >= int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]):
        return
    bound = lead[LeadWork.LIMITS, stage]
    for i in range(TURNS):
        if time >= NEVER or first[Phase.ABOVE] != 0.0:
            break
        before = lead[LeadWork.BEST, Lead.TIME]
        level = first[Phase.ACCELERATION] + first[Phase.CHANGE]
        lead[LeadWork.ENDS, stage] = min(max(level, -bound), bound)
        time = try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)
        if before >= 0.0 and (1.0 + FINE) * lead[LeadWork.BEST, Lead.TIME] > before:
            break


def first_free_stage(order: int) -> int:
    """The last stage whose end is free."""
    return order + 2 if order == LeadStage.VELOCITY else order


def improve_ends(
    order: int, within: float, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search for better ends of the stages, one after the other, until one takes `within` [s]."""
    for i in range(2):
        stage = first_free_stage(order) + 2 * i
        if leads_in(within, lead):
            break
        if stage < int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]):
            search_end(order, stage, limits, lead, timing, coefficients)


def try_steeper(
    order: int, within: float, times: int, limits: 'float[:]', lead: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> bool:
    """Try the soonest ends with derivatives that nothing limits (`set_limits`) raised so often.

    Whether to raise them once more may shorten a lead that takes more than `within` [s]: as long as
    it did (WORTH_STEEPER), and after the first time.
    """
    steep = STEEPER ** times
    set_limits(steep, lead)
    lead[LeadWork.BEST, Lead.GAIN] = WORTH_STEEPER
    before = lead[LeadWork.BEST, Lead.TIME]
    try_soonest(order, limits, lead, timing, coefficients)
    lead[LeadWork.BEST, Lead.GAIN] = 1.0 - EQUAL
    shorter = lead[LeadWork.BEST, Lead.TIME] != before
    if shorter:
        lead[LeadWork.BEST, Lead.STEEP] = steep
    return (shorter or times <= 1) and not leads_in(within, lead)


def search_ends(
    order: int, within: float, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search for a lead of `within` [s] at most, else the best, by the ends of its stages."""
    steep = lead[LeadWork.BEST, Lead.STEEP]
    for i in range(STEEPEST):
        if is_settled(lead) or leads_in(within, lead):
            break
        before = lead[LeadWork.BEST, Lead.TIME]
        set_limits(steep, lead)
        improve_ends(order, within, limits, lead, timing, coefficients)
        if before >= 0.0:
            break
        if lead[LeadWork.BEST, Lead.TIME] < 0.0:
            # steeper rises may permit a lead
            steep = STEEPER * steep
