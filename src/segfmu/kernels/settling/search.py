"""The shortest lead by settling: its stages end where all of it takes the least time.

The last stage of a lead that ends at a velocity (order 1) leads to it; a lead to where the planner
takes over (order 2) may end at any acceleration, and the planner's profile belongs to its time. All
other ends are free. The search starts from the soonest ends, goes to the level that the following
profile wants first, over a grid, and refines by halved steps. That for a level does the same.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.records import Axis, Phase, Problem
from segfmu.kernels.settling.level import level_order
from segfmu.kernels.settling.records import Chain, Lead, LeadRows, LeadStage, LeadWork
from segfmu.kernels.settling.trial import (
    is_settled,
    set_limits,
    soonest_ends,
    try_lead,
    try_level,
)

# values on both sides of the best one cost at most this share of its time: closer ones gain less
FLAT = 1.0001


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
    """Improve the end of one stage: over a grid, then by halved steps."""
    bound = lead[LeadWork.LIMITS, stage]
    for i in range(-4, 5):
        try_end(order, stage, 0.25 * i * bound, limits, lead, timing, coefficients)
    step = 0.125 * bound
    for i in range(10):
        around = lead[LeadWork.BEST_ENDS, stage]
        if around > 1e299:
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
        if first[Phase.ABOVE] > 0.5:
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


def near_zero(i: float) -> float:
    """Numbers from -1 to 1 for i from -12 to 12, denser near 0."""
    if i == 0.0:
        return 0.0
    share = 0.7 ** (12.0 - abs(i))
    if i < 0.0:
        share = -share
    return share


def search_pairs(
    order: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Try the ends of two stages together, over a grid, as few of them keep the limits."""
    smoothness = int(lead[LeadWork.AXIS, Axis.SMOOTHNESS])
    stage = first_free_stage(order)
    earlier = stage + 2
    for i in range(-12, 13):
        for j in range(-12, 14):
            free = j == 13
            if not free and earlier >= smoothness:
                continue
            soonest_ends(order, lead)
            lead[LeadWork.ENDS, stage] = near_zero(float(i)) * lead[LeadWork.LIMITS, stage]
            if not free:
                end = near_zero(float(j)) * lead[LeadWork.LIMITS, earlier]
                lead[LeadWork.ENDS, earlier] = end
            try_lead(order, LeadRows.PIECES, limits, lead, timing, coefficients)


def search_grid(
    order: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """Search for the shortest lead over a level on a grid, and at the one before; its time [s].

    NEVER: there is none.
    """
    stage = level_order(order, lead)
    kept = lead[LeadWork.BEST, Lead.LEVEL]
    least = NEVER
    if lead[LeadWork.BEST, Lead.TIME] >= 0.0:
        # halved steps do not gain more
        least = 1.2 * lead[LeadWork.BEST, Lead.TIME]
    found = NEVER
    # with limits above the snap the time jumps more often
    count = 6
    if lead[LeadWork.AXIS, Axis.SMOOTHNESS] > 4.5:
        count = 24
    for i in range(-count - 1, count + 1):
        level = kept
        if i >= -count:
            level = near_zero(12.0 * i / count) * lead[LeadWork.LIMITS, stage]
        time = try_level(order, level, least, limits, lead, timing, coefficients)
        if time < least:
            least = time
            found = time
            lead[LeadWork.BEST, Lead.LEVEL] = level
    return found


def improve_level(
    order: int,
    least: float,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Improve the level of a lead that takes `least` [s] by halved steps."""
    bound = lead[LeadWork.LIMITS, level_order(order, lead)]
    step = 0.15 * abs(lead[LeadWork.BEST, Lead.LEVEL]) + 0.005 * bound
    for i in range(8):
        around = lead[LeadWork.BEST, Lead.LEVEL]
        worst = 0.0
        for side in range(2):
            level = min(max(around + step * (1 - 2 * side), -bound), bound)
            time = try_level(order, level, least, limits, lead, timing, coefficients)
            worst = max(worst, time)
            if time < least:
                least = time
                lead[LeadWork.BEST, Lead.LEVEL] = level
        if worst <= FLAT * least:
            break
        if lead[LeadWork.BEST, Lead.LEVEL] == around:
            step = 0.5 * step


def search_levels(
    order: int,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """`search_stages`, but over levels; shorter leads alone are kept."""
    steep = 1.0
    found = NEVER
    highest = lead[LeadWork.AXIS, Axis.SMOOTHNESS]
    lead[LeadWork.BEST, Lead.LEVEL] = lead[LeadWork.START, level_order(order, lead)]
    lead[LeadWork.BEST, Lead.GAIN] = 1.0 - 1e-12
    for i in range(4):
        set_limits(steep, lead)
        before = lead[LeadWork.BEST, Lead.TIME]
        # with limits above the snap other levels are best where derivatives may be larger
        if found > 1e299 or (i == 1 and highest > 4.5):
            found = search_grid(order, limits, lead, timing, coefficients)
        else:
            level = lead[LeadWork.BEST, Lead.LEVEL]
            found = try_level(order, level, NEVER, limits, lead, timing, coefficients)
        if found < 1e299:
            improve_level(order, found, limits, lead, timing, coefficients)
        if i > 0 and lead[LeadWork.BEST, Lead.TIME] == before:
            break
        lead[LeadWork.BEST, Lead.GAIN] = 0.99
        steep = 10.0 * steep


def permits_levels(order: int, lead: 'float[:,:]') -> bool:
    """Whether leads over a level are searched for."""
    target = lead[LeadWork.TARGET, :]
    if lead[LeadWork.AXIS, Axis.SMOOTHNESS] < 3.5 or is_settled(lead):
        return False
    if level_order(order, lead) == 0:
        return False
    # behind such a lead the planner has nothing left to prolong but rest
    resting = target[Problem.W] == 0.0 and target[Problem.B] == 0.0
    return order == LeadStage.VELOCITY or resting


def search_stages(
    order: int,
    within: float,
    limits: 'float[:]',
    lead: 'float[:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search for a lead of `within` [s] at most, else the best, from START by the ends of stages.

    Derivatives that nothing limits are raised as long as that shortens it by more than 1 %.
    """
    steep = 1.0
    for i in range(4):
        set_limits(steep, lead)
        lead[LeadWork.BEST, Lead.GAIN] = 0.99
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
        steep = 10.0 * steep
    if lead[LeadWork.BEST, Lead.TIME] < 0.0 and not is_settled(lead):
        search_pairs(order, limits, lead, timing, coefficients)
        if lead[LeadWork.BEST, Lead.TIME] >= 0.0:
            improve_ends(order, within, limits, lead, timing, coefficients)
