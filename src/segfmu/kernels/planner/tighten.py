"""Limits that come down to what they are, while a sequence of levels of the snap keeps them.

From the sequence without the limits below the levels, Newton's method can lead astray where these
are exceeded by far. Here it has several starts for each plateau, derivatives may touch a limit for
an instant (instant.py), and where all that fails the limits come down in steps.
"""

from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.instant import add_instant
from segfmu.kernels.planner.newton import solve_sequence
from segfmu.kernels.planner.plateaus import (
    insert_node,
    insert_plateau,
    keep_sequence,
    overlong_plateau,
    remove_node,
    restore_sequence,
    solve_rotated,
)
from segfmu.kernels.planner.records import Axis, Excess, Node, Passing, PlanWork, Tighten
from segfmu.kernels.planner.sequence import sequence_duration


def may_go_on(work: 'float[:,:]') -> bool:
    """Whether Newton's method has taken few steps so far; it hardly ever succeeds after more."""
    return work[PlanWork.TIGHTEN, Tighten.STEPS] < 100.0


def loosen(share: float, axis: 'float[:]', work: 'float[:,:]') -> None:
    """Write the axis with limits that lie between those asked for (1) and what is taken (0)."""
    loose = work[PlanWork.LOOSE, :]
    for i in range(Axis.SIZE):
        loose[i] = axis[i]
    for order in range(1, int(work[PlanWork.PASSING, Passing.ABOVE]) + 2):
        i = Axis.VELOCITY + order - 1
        excess = work[PlanWork.TIGHTEN, Tighten.SHARE + order]
        loose[i] = axis[i] * (1.0 + excess) ** (1.0 - share)


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
        place = 0
        beside = 0
        sign = -1.0
    elif variant == 5:
        place = count
        beside = count - 1
        sign = -1.0
    if place < 0 or beside < 0 or beside >= count or count > 12:
        return False
    row = PlanWork.NODES + beside
    if passing[Passing.INSTANTS] > 2.5 or work[row, Node.KIND] > 0.5:
        return False
    sign = sign * work[row, Node.SIGN]
    insert_node(place, 0, sign, 0.5 * work[row, Node.TIME], False, work)
    add_instant(order, work[PlanWork.EXCESS + order, Excess.SIGN], node, passing)
    return solve_rotated(problem, axis, work)


def insert_instant(
    order: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Let a derivative that exceeds its limit reach it for an instant; false: nothing changes."""
    for variant in range(6):
        if may_go_on(work) and insert_level(variant, order, problem, axis, work):
            return True
        restore_sequence(PlanWork.KEPT, work)
    return False


def insert_limit(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Keep a limit that a solved sequence exceeds, that of the highest order; solved again."""
    q = int(work[PlanWork.PASSING, Passing.ABOVE]) + 2
    order = q - 1
    while work[PlanWork.EXCESS + order, Excess.SHARE] == 0.0:
        order = order - 1
    keep_sequence(PlanWork.KEPT, work)
    if order == q - 3 and insert_instant(order, problem, axis, work):
        return True
    guesses = 1
    if order == q - 2:
        guesses = 3
    for guess in range(guesses):
        if may_go_on(work) and insert_plateau(order, False, guess, axis, work):
            if solve_rotated(problem, axis, work):
                return True
        restore_sequence(PlanWork.KEPT, work)
    return order == q - 2 and insert_instant(order, problem, axis, work)


def end_plateau(place: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Replace a plateau whose hold is below zero by an instant, or let its derivative stay below.

    The sequence is solved again.
    """
    row = PlanWork.NODES + place
    order = int(work[row, Node.KIND])
    sign = work[row, Node.SIGN]
    if order == int(work[PlanWork.PASSING, Passing.ABOVE]) + 1:
        work[row, Node.TOUCH] = 2.0
        work[row, Node.AIM] = 0.0
        return solve_sequence(problem, axis, work)
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
    for attempt in range(10):
        place = overlong_plateau(work)
        if place >= 0:
            if not end_plateau(place, problem, axis, work):
                return False
        elif not measure_excess(axis, work):
            return True
        elif not insert_limit(problem, axis, work):
            return False
    return False


def tighten(longest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Bring the limits of a solved sequence down to those of its axis, in as few steps as possible.

    It is that in the rows SOLVED of `work`. False if that fails, or takes `longest` [s] or more.
    """
    passing = work[PlanWork.PASSING, :]
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
    loose = work[PlanWork.LOOSE, :]
    measure_excess(axis, work)
    for order in range(1, int(passing[Passing.ABOVE]) + 2):
        work[PlanWork.TIGHTEN, Tighten.SHARE + order] = work[PlanWork.EXCESS + order, Excess.SHARE]
    work[PlanWork.TIGHTEN, Tighten.STEPS] = 0.0
    reached = 0.0
    step = 1.0
    while step > 0.1 and may_go_on(work):
        share = min(reached + step, 1.0)
        loosen(share, axis, work)
        restore_sequence(PlanWork.SOLVED, work)
        if solve_rotated(problem, loose, work) and meet_all(problem, loose, work):
            if sequence_duration(passing, nodes) >= longest:
                return False
            if share == 1.0:
                return True
            keep_sequence(PlanWork.SOLVED, work)
            reached = share
        else:
            step = 0.5 * step
    return False
