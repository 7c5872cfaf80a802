"""Which limits are active in a sequence (sequence.py), as limits or its duration change.

Derivatives stay at limits on plateaus, with several starts for Newton's method, or touch them for
an instant (instant.py). Plateaus become instants as their holds vanish, and levels that vanish at
one end go to the other.
"""

from segfmu.kernels.numerics.numbers import FEW, NEVER, SMALL, TIE, WORTH
from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.instant import add_instant, place_instant
from segfmu.kernels.planner.newton import has_pace
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.plateaus import (
    insert_node,
    insert_plateau,
    keep_sequence,
    overlong_plateau,
    remove_node,
    restore_sequence,
    solve_rotated,
)
from segfmu.kernels.planner.records import Axis, Excess, Node, Passing, PlanWork, Tighten, Touch
from segfmu.kernels.planner.sequence import sequence_duration


def may_go_on(work: 'float[:,:]') -> bool:
    """Whether Newton's method has taken few steps for these limits; more hardly ever help."""
    return work[PlanWork.TIGHTEN, Tighten.STEPS] < work[PlanWork.TIGHTEN, Tighten.MOST]


def insert_level(
    variant: int, order: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Insert a level near where a derivative exceeds its limit, which it then has for an instant.

    variant: after the node before it, before that node, before the node before, or after it; or of
    the other sign, before the first node or after the last one.
    """
    passing = work[PlanWork.PASSING, :]
    node = int(work[PlanWork.EXCESS + order, Excess.NODE])
    count = int(passing[Passing.COUNT])
    place = node
    beside = node
    sign = 1.0
    if variant == 0:
        beside = node - 1
    elif variant == 2:
        place = node - 1
        beside = node - 1
    elif variant == 3:
        place = node + 1
    elif variant == 4:
        place, beside, sign = 0, 0, -1.0
    elif variant == 5:
        place = count
        beside = count - 1
        sign = -1.0
    if place < 0 or beside < 0 or beside >= count or count > FEW:
        return False
    row = PlanWork.NODES + beside
    if int(passing[Passing.INSTANTS]) > 2 or work[row, Node.KIND] != 0.0:
        return False
    sign = sign * work[row, Node.SIGN]
    insert_node(place, 0, sign, 0.5 * work[row, Node.TIME], False, work)
    add_instant(order, work[PlanWork.EXCESS + order, Excess.SIGN], node, passing)
    return solve_rotated(problem, axis, work)


def move_instant(order: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Let a derivative reach its limit where it exceeds it, in place of another instant."""
    passing = work[PlanWork.PASSING, :]
    node = int(work[PlanWork.EXCESS + order, Excess.NODE])
    for peak in range(int(passing[Passing.INSTANTS])):
        if int(passing[Passing.INSTANT_ORDER + peak]) == order and may_go_on(work):
            place_instant(peak, order, work[PlanWork.EXCESS + order, Excess.SIGN], node, passing)
            if solve_rotated(problem, axis, work):
                return True
            restore_sequence(PlanWork.KEPT, work)
    return False


def compares_levels(axis: 'float[:]') -> bool:
    """Whether all levels that can be inserted are compared: levels of the jerk beside a crackle.

    Of levels of the snap the shortest one often leads to a sequence that meets no further limit.
    """
    return int(axis[Axis.ABOVE]) < 2 and not ramps_suffice(axis)


def sequence_cost(work: 'float[:,:]') -> float:
    """What a solved sequence is better by having less of: its duration [s], or a distance [m]."""
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    if passing[Passing.FREE] != 0.0:
        end = int(passing[Passing.COUNT]) + 1
        return -passing[Passing.FREE] * nodes[end, Node.STATE]
    return sequence_duration(passing, nodes)


def insert_instant(order: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Let a derivative that exceeds its limit reach it for an instant; false: nothing changes.

    Of the levels that can be inserted the best one is taken where they are compared, but for a
    slower pace; else the first one.
    """
    if work[PlanWork.TIGHTEN, Tighten.MOVING] != 0.0 and move_instant(order, problem, axis, work):
        return True
    least = NEVER
    for variant in range(6):
        if may_go_on(work) and insert_level(variant, order, problem, axis, work):
            if has_pace(work[PlanWork.PASSING, :]) or not compares_levels(axis):
                return True
            cost = sequence_cost(work)
            if cost < least:
                least = cost - WORTH * abs(cost)
                keep_sequence(PlanWork.TRIED, work)
        restore_sequence(PlanWork.KEPT, work)
    if least < NEVER:
        restore_sequence(PlanWork.TRIED, work)
    return least < NEVER


def insert_limit(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Keep the limit that a solved sequence exceeds the most; it is solved again."""
    q = int(work[PlanWork.PASSING, Passing.ABOVE]) + 2
    order = q - 1
    for j in range(1, q - 1):
        lower = q - 1 - j
        excess = work[PlanWork.EXCESS + order, Excess.SHARE]
        if work[PlanWork.EXCESS + lower, Excess.SHARE] > excess:
            order = lower
    keep_sequence(PlanWork.KEPT, work)
    if order == q - 3 and insert_instant(order, problem, axis, work):
        return True
    guesses = 3 if order == q - 2 else 1
    for guess in range(guesses):
        if may_go_on(work) and insert_plateau(order, False, guess, axis, work):
            if solve_rotated(problem, axis, work):
                return True
        restore_sequence(PlanWork.KEPT, work)
    return order >= q - 2 and insert_instant(order, problem, axis, work)


def stay_below(place: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Let the derivative q - 1 stay below its limit at a plateau whose hold is below zero."""
    keep_sequence(PlanWork.KEPT, work)
    row = PlanWork.NODES + place
    work[row, Node.TOUCH] = Touch.BELOW
    work[row, Node.AIM] = 0.0
    if solve_rotated(problem, axis, work):
        return True
    restore_sequence(PlanWork.KEPT, work)
    return False


def end_highest(place: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """`end_plateau` of the derivative q - 1.

    Where it stays below its limit all derivatives above are zero, which costs time: where levels
    are compared, that is tried last. At a slower pace it is the motion next to the one before.
    """
    first = has_pace(work[PlanWork.PASSING, :]) or not compares_levels(axis)
    if first and stay_below(place, problem, axis, work):
        return True
    row = PlanWork.NODES + place
    order = int(work[row, Node.KIND])
    sign, hold = work[row, Node.SIGN], work[row, Node.TIME]
    remove_node(place, work)
    work[PlanWork.EXCESS + order, Excess.NODE] = place
    work[PlanWork.EXCESS + order, Excess.SIGN] = sign
    keep_sequence(PlanWork.KEPT, work)
    if insert_instant(order, problem, axis, work):
        return True
    insert_node(place, order, sign, hold, False, work)
    return not first and stay_below(place, problem, axis, work)


def end_plateau(place: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Replace a plateau whose hold is below zero by an instant, or let its derivative stay below.

    The sequence is solved again.
    """
    row = PlanWork.NODES + place
    order = int(work[row, Node.KIND])
    sign = work[row, Node.SIGN]
    if order == int(work[PlanWork.PASSING, Passing.ABOVE]) + 1:
        return end_highest(place, problem, axis, work)
    keep_sequence(PlanWork.KEPT, work)
    for side in range(2):
        # one of the levels around it goes as well
        remove_node(place, work)
        remove_node(place - side, work)
        add_instant(order, sign, place - side, work[PlanWork.PASSING, :])
        if solve_rotated(problem, axis, work):
            return True
        restore_sequence(PlanWork.KEPT, work)
    return False


def meet_all(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Change a solved sequence until it keeps the limits of an axis."""
    for attempt in range(FEW):
        place = overlong_plateau(work)
        if place >= 0:
            if not end_plateau(place, problem, axis, work):
                return False
        elif not measure_excess(axis, work):
            return True
        elif not insert_limit(problem, axis, work):
            return False
    return False


def vanishing_end(work: 'float[:,:]') -> int:
    """The free level at the start or the end that takes the least time, if that is short; -1."""
    passing = work[PlanWork.PASSING, :]
    last = int(passing[Passing.COUNT]) - 1
    found = -1
    least = SMALL * passing[Passing.TIME]
    for side in range(2):
        row = PlanWork.NODES + side * last
        if work[row, Node.KIND] == 0.0 and abs(work[row, Node.TIME]) < least:
            found = side * last
            least = abs(work[row, Node.TIME]) / TIE
    return found


def release_plateau(work: 'float[:,:]') -> bool:
    """Replace a derivative that touches its limit at a level by an instant.

    A level that vanishes at the start or the end goes. False if there are no such two.
    """
    passing = work[PlanWork.PASSING, :]
    kind = int(passing[Passing.ABOVE])
    end = vanishing_end(work)
    if end < 0 or int(passing[Passing.INSTANTS]) > 2:
        return False
    for i in range(int(passing[Passing.COUNT])):
        row = PlanWork.NODES + i
        touches = int(work[row, Node.TOUCH]) == Touch.HOLDS and work[row, Node.TIME] < 0.0
        if touches and int(work[row, Node.KIND]) == kind:
            work[row, Node.KIND] = 0.0
            add_instant(kind, work[row, Node.SIGN], i, passing)
            remove_node(end, work)
            return True
    return False


def follow(target: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Solve the sequence in the rows SOLVED of `work` for other limits, as it is or changed.

    target: the duration that it lasts at a slower pace [s]; 0: as long as it takes.
    """
    for change in range(2):
        restore_sequence(PlanWork.SOLVED, work)
        work[PlanWork.PASSING, Passing.QUICK] = 1.0
        work[PlanWork.PASSING, Passing.TARGET] = target
        changed = change == 0 or release_plateau(work)
        if changed and may_go_on(work) and solve_rotated(problem, axis, work):
            if meet_all(problem, axis, work):
                return True
    return False
