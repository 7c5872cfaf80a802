"""The shortest lead by settling: its stages end where all of it takes the least time.

The last stage of a lead that ends at a velocity (order 1) leads to it; a lead to where the planner
takes over (order 2) may end at any acceleration, and the planner's profile belongs to its time. All
other ends are free. The search starts from the soonest ends, goes to the level that the following
profile wants first, or over a grid where there is none, and refines by halved steps. It counts
with profiles of ramps alone, which are found sooner, until all but one of the free ends are known.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.records import Axis, Phase
from segfmu.kernels.settling.records import Chain, Lead, LeadRows, LeadStage, LeadWork
from segfmu.kernels.settling.trial import (
    is_settled,
    set_limits,
    soonest_ends,
    time_anew,
    try_lead,
)

# values on both sides of the best one cost at most this share of its time: closer ones gain less
FLAT = 1.0001
# steps around the best end: the first one, as a share of its limit, halved where it gains nothing
FIRST_STEP = 0.125
STEPS = 10
# derivatives that nothing limits are raised by this factor, so often, as long as the time of a lead
# becomes less than this share
STEEPER = 10.0
STEEPEST = 4
WORTH_STEEPER = 0.99


def try_end(
    order: int,
    stage: int,
    end: float,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
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
    """Improve the end of one stage by halved steps; where it is any, over a grid first."""
    bound = lead[LeadWork.LIMITS, stage]
    if lead[LeadWork.BEST_ENDS, stage] >= NEVER or lead[LeadWork.BEST, Lead.TIME] < 0.0:
        for i in range(-4, 5):
            try_end(order, stage, 0.25 * i * bound, limits, lead, timing, coefficients)
    step = FIRST_STEP * bound
    for i in range(STEPS):
        around = lead[LeadWork.BEST_ENDS, stage]
        if around >= NEVER:
            break
        worst = 0.0
        for side in range(2):
            end = around + step * (1 - 2 * side)
            time = try_end(order, stage, end, limits, lead, timing, coefficients)
            worst = max(worst, time)
        if worst <= FLAT * lead[LeadWork.BEST, Lead.TIME]:
            break
        if lead[LeadWork.BEST_ENDS, stage] == around:
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
        if first[Phase.ABOVE] != 0.0:
            break
        level = first[Phase.ACCELERATION] + first[Phase.CHANGE]
        before = lead[LeadWork.BEST, Lead.TIME]
        try_end(order, stage, level, limits, lead, timing, coefficients)
        if lead[LeadWork.BEST, Lead.TIME] == before:
            break


def leads_in(time: float, lead: 'float[:,:]') -> bool:
    """Whether there is a lead that takes `time` [s] at most."""
    return 0.0 <= lead[LeadWork.BEST, Lead.TIME] <= time


def search_ends(
    order: int,
    within: float,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Try the soonest ends of all stages, then search for better ones unless all is settled."""
    soonest_ends(order, lead)
    for i in range(Chain.SIZE):
        lead[LeadWork.BEST_ENDS, i] = lead[LeadWork.ENDS, i]
    try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)
    if not is_settled(lead):
        improve_ends(order, within, limits, lead, timing, coefficients)


def first_free_stage(order: int) -> int:
    """The last stage whose end is free."""
    if order == LeadStage.VELOCITY:
        return order + 2
    return order


def improve_ends(
    order: int,
    within: float,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search for better ends of the stages, one after the other, until one takes `within` [s]."""
    smoothness = int(lead[LeadWork.AXIS, Axis.SMOOTHNESS])
    first_free = first_free_stage(order)
    for sweep in range(2):
        if sweep == 1:
            time_anew(order, lead)
        for i in range(2):
            stage = first_free + 2 * i
            if stage < smoothness:
                if i == 0:
                    follow_profile(order, stage, limits, lead, timing, coefficients)
                if leads_in(within, lead):
                    return
                search_end(order, stage, limits, lead, timing, coefficients)
        if first_free + 2 >= smoothness:
            break


def search_stages(
    order: int,
    within: float,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search for a lead of `within` [s] at most, else the best, from START by the ends of stages.

    Derivatives that nothing limits are raised as long as that shortens it (WORTH_STEEPER).
    """
    steep = 1.0
    lead[LeadWork.BEST, Lead.RAMPS] = 1.0
    for i in range(STEEPEST):
        set_limits(steep, lead)
        lead[LeadWork.BEST, Lead.GAIN] = WORTH_STEEPER
        before = lead[LeadWork.BEST, Lead.TIME]
        if before >= 0.0:
            for j in range(Chain.SIZE):
                lead[LeadWork.ENDS, j] = lead[LeadWork.BEST_ENDS, j]
            try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)
            # before a gap of durations the best ends move: they are searched for once more
            if i > 1 and lead[LeadWork.BEST, Lead.TIME] == before:
                break
        search_ends(order, within, limits, lead, timing, coefficients)
        if leads_in(within, lead):
            break
        steep = STEEPER * steep
