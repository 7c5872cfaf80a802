"""Plateaus of a sequence (sequence.py): which derivatives stay at their limits, and where."""


from segfmu.kernels.numerics.numbers import EQUAL, FEW, TIE, TRIES
from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.instant import shift_instants
from segfmu.kernels.planner.newton import LESS, solve_sequence
from segfmu.kernels.planner.records import Axis, Excess, Node, Passing, PlanWork, Touch
from segfmu.kernels.planner.sequence import sequence_duration

# of the whole duration: what a level at an end takes at first
NEW = 0.03


def keep_sequence(row: int, work: 'float[:,:]') -> None:
    """Copy the sequence to the rows KEPT, FOUND or SOLVED of `work` (PlanWork), from `row` on."""
    # itself, its nodes, the end and the state there
    for j in range(int(work[PlanWork.PASSING, Passing.COUNT]) + 3):
        work[row + j, :] = work[PlanWork.PASSING + j, :]


def restore_sequence(row: int, work: 'float[:,:]') -> None:
    """Copy it back."""
    for j in range(int(work[row, Passing.COUNT]) + 3):
        work[PlanWork.PASSING + j, :] = work[row + j, :]


def insert_node(
    place: int, kind: int, sign: float, time: float, touch: bool, work: 'float[:,:]'
) -> None:
    """Insert a node before another one."""
    passing = work[PlanWork.PASSING, :]
    count = int(passing[Passing.COUNT])
    shift_instants(place, 1, passing)
    for j in range(count - place):
        row = PlanWork.NODES + count - j
        work[row, :] = work[row - 1, :]
    row = PlanWork.NODES + place
    work[row, Node.KIND] = kind
    work[row, Node.SIGN] = sign
    work[row, Node.TIME] = time
    work[row, Node.TOUCH] = touch
    work[row, Node.AIM] = 0.0
    passing[Passing.COUNT] = count + 1


def set_alternating(sign: float, time: float, work: 'float[:,:]') -> None:
    """Replace the nodes by as many levels as there are conditions at the end, of alternating signs.

    sign: of the first one. time: of each [s].
    """
    work[PlanWork.PASSING, Passing.COUNT] = 0.0
    for i in range(int(work[PlanWork.PASSING, Passing.ABOVE]) + 2):
        insert_node(i, 0, sign * (1.0 - 2.0 * (i % 2)), time, False, work)


def remove_node(place: int, work: 'float[:,:]') -> None:
    """Remove a node."""
    passing = work[PlanWork.PASSING, :]
    count = int(passing[Passing.COUNT])
    for row in range(PlanWork.NODES + place, PlanWork.NODES + count - 1):
        work[row, :] = work[row + 1, :]
    passing[Passing.COUNT] = count - 1
    shift_instants(place + 1, -1, passing)


def split_guess(guess: int) -> 'tuple[float, float, float]':
    """What Newton's method starts from where a level is split: shares of the level and the dip."""
    if guess == 1:
        return 0.9, 0.7, 0.6
    if guess == 2:
        return 0.6, 0.7, 0.9
    return 0.8, 0.5, 0.8


def split_level(
    place: int, kind: int, sign: float, guess: int, axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Let the derivative q - 2 stay at its limit within a level: level, plateau, level."""
    row = PlanWork.NODES + place
    if work[row, Node.KIND] != 0.0:
        return False
    time, level_sign = work[row, Node.TIME], work[row, Node.SIGN]
    dip = min(abs(time), axis[Axis.RISES + kind - 1])
    before, depth, after = split_guess(guess)
    work[row, Node.TIME] = before * time
    insert_node(place + 1, kind, sign, -depth * dip, False, work)
    insert_node(place + 2, 0, level_sign, after * time, False, work)
    return True


def split_ramp(
    place: int, kind: int, sign: float, touch: bool, holding: bool, work: 'float[:,:]'
) -> bool:
    """Let the derivative q - 3 reach its limit in the ramp to a node: level, plateau, level.

    holding: it exceeds the limit where the derivative q - 1 stays; that goes on at both sides.
    """
    first = PlanWork.NODES + place - 1
    last = PlanWork.NODES + place
    plateau = kind + 2
    if holding:
        last = last + 1
        if work[last - 1, Node.KIND] != plateau:
            return False
    if work[first, Node.KIND] != 0.0 or work[last, Node.KIND] != 0.0:
        return False
    # as much of the level that it begins from as a step of Newton's method may take
    share = 0.5 if touch else LESS
    time = share * 0.5 * (work[first, Node.TIME] + work[last, Node.TIME])
    before, after = work[first, Node.SIGN], work[last, Node.SIGN]
    if holding:
        hold = work[last - 1, Node.TIME]
        insert_node(place + 1, plateau, work[last - 1, Node.SIGN], hold, False, work)
        place = place + 1
    insert_node(place, 0, before, time, False, work)
    insert_node(place, kind, sign, 0.0, touch, work)
    insert_node(place, 0, after, time, False, work)
    return True


def insert_plateau(
    kind: int, touching: bool, guess: int, axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Let a derivative that exceeds its limit the most at a node stay at the limit there.

    touching: that of the order q - 3 only touches it. guess: as in `split_guess`. False if there is
    no place for it.
    """
    passing, excess = work[PlanWork.PASSING, :], work[PlanWork.EXCESS + kind, :]
    q = int(passing[Passing.ABOVE]) + 2
    count = int(passing[Passing.COUNT])
    place = int(excess[Excess.NODE])
    sign = excess[Excess.SIGN]
    holding = excess[Excess.HOLDING] != 0.0
    if count > FEW:
        return False
    if kind == q - 2:
        if not holding:
            row = PlanWork.NODES + place
            here = place < count and work[row, Node.KIND] == 0.0
            if not here or work[row, Node.LEVEL] * sign >= 0.0:
                place = place - 1
        inside = place >= 0 and place < count
        return inside and split_level(place, kind, sign, guess, axis, work)
    if place == 0 or place >= count:
        return False
    if kind == q - 3:
        return split_ramp(place, kind, sign, touching, holding, work)
    row = PlanWork.NODES + place
    if holding or work[row, Node.KIND] != 0.0 or work[row - 1, Node.KIND] != 0.0:
        return False
    insert_node(place, kind, sign, 0.0, False, work)
    return True


def rotate_levels(work: 'float[:,:]') -> bool:
    """Move a first or last level that vanishes to the other end, with the next sign there."""
    passing = work[PlanWork.PASSING, :]
    count = int(passing[Passing.COUNT])
    first = PlanWork.NODES
    last = PlanWork.NODES + count - 1
    tiny = NEW * passing[Passing.TIME]
    if count < 2 or work[first, Node.KIND] != 0.0 or work[last, Node.KIND] != 0.0:
        return False
    # the largest distance would become the least one
    if passing[Passing.FREE] != 0.0:
        return False
    at_first = abs(work[first, Node.TIME])
    at_last = abs(work[last, Node.TIME])
    if min(at_first, at_last) >= tiny:
        return False
    if at_first <= TIE * at_last:
        remove_node(0, work)
        insert_node(count - 1, 0, -work[last - 1, Node.SIGN], tiny, False, work)
    else:
        remove_node(count - 1, work)
        insert_node(0, 0, -work[first, Node.SIGN], tiny, False, work)
    return True


def solve_rotated(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """`solve_sequence`; where that fails as a level at one end vanishes, with one at the other."""
    if solve_sequence(problem, axis, work):
        return True
    return rotate_levels(work) and solve_sequence(problem, axis, work)


def overlong_plateau(work: 'float[:,:]') -> int:
    """The plateau whose hold is the most below zero; -1 if there is none."""
    passing = work[PlanWork.PASSING, :]
    found = -1
    least = -EQUAL * passing[Passing.TIME]
    for i in range(int(passing[Passing.COUNT])):
        row = PlanWork.NODES + i
        kind = int(work[row, Node.KIND])
        held = int(work[row, Node.TOUCH]) == Touch.HOLDS and kind != int(passing[Passing.ABOVE])
        if kind > 0 and held and work[row, Node.TIME] < least:
            found = i
            least = TIE * work[row, Node.TIME]
    return found


def shorten_hold(
    row: int, touch: int, steps: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Bring the hold of a plateau to zero in steps, with one condition less (TOUCH)."""
    hold = work[row, Node.TIME]
    work[row, Node.TOUCH] = touch
    for i in range(steps):
        work[row, Node.AIM] = hold * (steps - 1 - i) / steps
        if not solve_sequence(problem, axis, work):
            return False
    return True


def touch_limit(row: int, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Let the derivative of a plateau whose hold is below zero only touch its limit, or less."""
    keep_sequence(PlanWork.KEPT, work)
    kind = int(work[row, Node.KIND])
    if kind == int(work[PlanWork.PASSING, Passing.ABOVE]) + 1:
        if shorten_hold(row, Touch.BELOW, 1, problem, axis, work):
            return True
    elif shorten_hold(row, Touch.TOUCHES, 4, problem, axis, work):
        return True
    restore_sequence(PlanWork.KEPT, work)
    return shorten_hold(row, Touch.BELOW, 4, problem, axis, work)


def add_plateau(axis: 'float[:]', work: 'float[:,:]') -> int:
    """Add a plateau of the lowest derivative that exceeds its limit; its order, 0: impossible."""
    q = int(work[PlanWork.PASSING, Passing.ABOVE]) + 2
    for kind in range(1, q):
        if work[PlanWork.EXCESS + kind, Excess.SHARE] > 0.0:
            if insert_plateau(kind, False, 0, axis, work):
                return kind
    return 0


def meet_limits(longest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Add plateaus to a solved sequence, or take their holds, until it keeps all limits.

    Those of low order first. False also as soon as it takes `longest` [s].
    """
    passing = work[PlanWork.PASSING, :]
    q = int(passing[Passing.ABOVE]) + 2
    added = 0
    for attempt in range(TRIES):
        if attempt > 0 and not solve_sequence(problem, axis, work):
            if added == 0 or added != q - 3:
                return False
            restore_sequence(PlanWork.KEPT, work)
            added = 0
            if not insert_plateau(q - 3, True, 0, axis, work):
                return False
            if not solve_sequence(problem, axis, work):
                return False
        if sequence_duration(passing, work[PlanWork.NODES:PlanWork.KEPT, :]) >= longest:
            return False
        added = 0
        place = overlong_plateau(work)
        if place >= 0:
            row = PlanWork.NODES + place
            if not touch_limit(row, problem, axis, work):
                return False
        elif not measure_excess(axis, work):
            return True
        else:
            keep_sequence(PlanWork.KEPT, work)
            added = add_plateau(axis, work)
            if added == 0:
                return False
    return False
