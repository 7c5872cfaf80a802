"""The shortest lead over a level: see level.py.

Each level is followed to the one at which the profile behind it stays first. The search begins
with the present value and zero. With limits above the snap the time jumps often: there it goes
over a grid, and refines by smaller steps.
"""

from segfmu.kernels.numerics.numbers import COARSE, EQUAL, GAINED, NEVER
from segfmu.kernels.planner.records import Axis, Phase, Problem
from segfmu.kernels.settling.chain import STEEPER
from segfmu.kernels.settling.level import level_order
from segfmu.kernels.settling.records import Lead, LeadStage, LeadWork
from segfmu.kernels.settling.search import FINER, STEEPEST, TURNS, WORTH_STEEPER
from segfmu.kernels.settling.trial import is_settled, set_limits, try_level

# halved steps without a gain, after which a level is no more improved
USELESS = 4
# levels of a grid over the next larger ones
DENSER = 0.7
# times over the best one from which a better one may still be found
HOPEFUL = 1.2
# the first step around the best level, of it and of its limit
OF_LEVEL = 0.15
OF_BOUND = 0.005


def near_zero(i: float) -> float:
    """Numbers from -1 to 1 for i from -COARSE to COARSE, denser near 0."""
    if i == 0.0:
        return 0.0
    share = DENSER ** (COARSE - abs(i))
    if i < 0.0:
        share = -share
    return share


def jumps_often(lead: 'float[:,:]') -> bool:
    """Whether the time of leads jumps often between levels: with limits above the snap."""
    return int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) > 4


def hopeful_time(lead: 'float[:,:]') -> float:
    """Time of a lead over a level [s] from which others may be better than the best one."""
    if lead[LeadWork.BEST, Lead.TIME] < 0.0:
        return NEVER
    return HOPEFUL * lead[LeadWork.BEST, Lead.TIME]


def follow_level(
    order: int, level: float, least: float, limits: 'float[:]', lead: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> float:
    """Time [s] of a lead over a level, or over the first one of the profile behind it, and so on.

    The soonest of them, NEVER if none takes less than `least` [s]; its level is noted.
    """
    first = lead[LeadWork.PHASES, :]
    found = NEVER
    for i in range(4):
        time = try_level(order, level, least, limits, lead, timing, coefficients)
        if not time < (1.0 - GAINED) * least:
            break
        least = time
        found = time
        lead[LeadWork.BEST, Lead.LEVEL] = level
        after = first[Phase.ACCELERATION] + first[Phase.CHANGE]
        if level_order(order, lead) != first[Phase.ABOVE] + 4 - order:
            break
        level = after
    return found


def search_grid(
    order: int, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> float:
    """Search for the soonest lead over the level before, zero, or levels on a grid; its time [s].

    NEVER: there is none.
    """
    stage = level_order(order, lead)
    kept = lead[LeadWork.BEST, Lead.LEVEL]
    least = hopeful_time(lead)
    found = NEVER
    count = COARSE if jumps_often(lead) else 0
    for i in range(-count - 1, count + 1):
        level = near_zero(float(i)) * lead[LeadWork.LIMITS, stage] if i >= -count else kept
        time = follow_level(order, level, least, limits, lead, timing, coefficients)
        if time < least:
            least = time
            found = time
    return found


def improve_level(
    order: int, least: float, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Improve the level of a lead that takes `least` [s] by halved steps."""
    bound = lead[LeadWork.LIMITS, level_order(order, lead)]
    step = OF_LEVEL * abs(lead[LeadWork.BEST, Lead.LEVEL]) + OF_BOUND * bound
    useless = 0
    for i in range(TURNS):
        around = lead[LeadWork.BEST, Lead.LEVEL]
        for side in range(2):
            level = min(max(around + step * (1 - 2 * side), -bound), bound)
            time = try_level(order, level, least, limits, lead, timing, coefficients)
            if time < (1.0 - GAINED) * least:
                least = time
                lead[LeadWork.BEST, Lead.LEVEL] = level
        useless = useless + 1
        if lead[LeadWork.BEST, Lead.LEVEL] == around:
            step = FINER * step
        else:
            useless = 0
        if useless == USELESS:
            break


def search_levels(
    order: int, found: float, limits: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Search for a lead over a level; shorter ones than the best alone are kept.

    found: time of one over the noted level [s]; NEVER: none is known.
    """
    first = 0
    if found >= NEVER:
        lead[LeadWork.BEST, Lead.LEVEL] = lead[LeadWork.START, level_order(order, lead)]
        lead[LeadWork.BEST, Lead.GAIN] = 1.0 - EQUAL
    else:
        first = 1
        lead[LeadWork.BEST, Lead.GAIN] = WORTH_STEEPER
    for i in range(first, STEEPEST):
        set_limits(STEEPER ** i, lead)
        before = lead[LeadWork.BEST, Lead.TIME]
        # where times jump, other levels may be best with steeper rises
        if found >= NEVER or (i == 1 and jumps_often(lead)):
            found = search_grid(order, limits, lead, timing, coefficients)
            if found < NEVER and jumps_often(lead):
                improve_level(order, found, limits, lead, timing, coefficients)
        else:
            level = lead[LeadWork.BEST, Lead.LEVEL]
            found = try_level(order, level, NEVER, limits, lead, timing, coefficients)
        if i > 0 and lead[LeadWork.BEST, Lead.TIME] == before:
            break
        lead[LeadWork.BEST, Lead.GAIN] = WORTH_STEEPER


def permits_levels(order: int, lead: 'float[:,:]') -> bool:
    """Whether leads over a level are searched for."""
    target = lead[LeadWork.TARGET, :]
    if int(lead[LeadWork.AXIS, Axis.SMOOTHNESS]) < 4 or is_settled(lead):
        return False
    if level_order(order, lead) == 0:
        return False
    # behind such a lead the planner has nothing left to prolong but rest
    resting = target[Problem.W] == 0.0 and target[Problem.B] == 0.0
    return order == LeadStage.VELOCITY or resting
