"""What Newton's method starts from, and the sequence (sequence.py) that it finds without limits.

The levels are those in the ramps of an ordinary profile. A much shorter sequence is looked for from
levels that alternate.
"""

from math import sqrt

from segfmu.kernels.numerics.numbers import FINE, NEARLY, NEVER, SMALL
from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.phases import has_dip, is_resting, total_duration
from segfmu.kernels.planner.plateaus import (
    insert_node,
    keep_sequence,
    set_alternating,
    solve_rotated,
)
from segfmu.kernels.planner.ramp import inner_rise, ramp_duration
from segfmu.kernels.planner.records import (
    Axis,
    Effort,
    Excess,
    Family,
    Node,
    Passing,
    Phase,
    PlanWork,
    Problem,
)
from segfmu.kernels.planner.sequence import is_square, sequence_duration
from segfmu.kernels.planner.sides import side_limit

# levels of a start, as shares of those that alone fill the duration; half of it for a much shorter
# sequence
ALTERNATING = 0.7
# levels of ordinary profiles meet at zero: where the snap has them, they are higher by this, which
# an attempt takes off again; and another one has more
HIGHER = 1.25
MORE = 1.3
# what a sequence without plateaus may exceed limits by; it takes less (SMALL) than one with them
BEYOND = 0.3


def append_level(sign: float, time: float, work: 'float[:,:]') -> None:
    """Append a level to a sequence, or enlarge the last one if that has the same sign."""
    count = int(work[PlanWork.PASSING, Passing.COUNT])
    if count > 0:
        row = PlanWork.NODES + count - 1
        if work[row, Node.KIND] == 0.0 and work[row, Node.SIGN] == sign:
            last = work[row, Node.TIME]
            work[row, Node.TIME] = sqrt(last * last + time * time)
            return
    insert_node(count, 0, sign, time, False, work)


def append_levels(change: float, axis: 'float[:]', work: 'float[:,:]') -> None:
    """Append the levels of a ramp of the acceleration; nothing for no change."""
    if change == 0.0:
        return
    sign = -1.0 if change < 0.0 else 1.0
    duration, slope = ramp_duration(abs(change), axis)
    rise = inner_rise(duration, 0, axis)
    hold = max(duration - 2.0 * rise, 0.0)
    if int(work[PlanWork.PASSING, Passing.ABOVE]) < 2:
        append_level(sign, rise + hold, work)
        return
    time = rise - inner_rise(rise, 1, axis)
    append_level(sign, time, work)
    if hold > NEARLY * duration:
        count = int(work[PlanWork.PASSING, Passing.COUNT])
        insert_node(count, 3, sign, hold, False, work)
    append_level(-sign, time, work)


def limit_held(a: float, v: float, axis: 'float[:]') -> 'tuple[int, float]':
    """The derivative that a hold keeps at its limit, 1 or 2, and its sign; 0 if there is none."""
    order, value = 0, 0.0
    if abs(a) >= side_limit(2, a, axis) * (1.0 - NEARLY):
        order = 2
        value = a
    elif a == 0.0 and abs(v) >= side_limit(1, v, axis) * (1.0 - NEARLY):
        order = 1
        value = v
    if value < 0.0:
        return order, -1.0
    return order, 1.0


def copy_levels(
    count: int, phases: 'float[:,:]', v: float, axis: 'float[:]', work: 'float[:,:]'
) -> None:
    """Set the sequence of the levels in the ramps of an ordinary profile from the velocity v."""
    passing = work[PlanWork.PASSING, :]
    passing[Passing.COUNT] = 0.0
    pending = 0.0
    for i in range(count):
        a, change = phases[i, Phase.ACCELERATION], phases[i, Phase.CHANGE]
        duration = phases[i, Phase.DURATION]
        if change * pending < 0.0:
            append_levels(pending, axis, work)
            pending = 0.0
        pending = pending + change
        if change == 0.0:
            order, sign = limit_held(a, v, axis)
            if order > 0:
                append_levels(pending, axis, work)
                pending = 0.0
                insert_node(int(passing[Passing.COUNT]), order, sign, duration, False, work)
        v = v + (a + 0.5 * change) * duration
    append_levels(pending, axis, work)


def begin_sequence(
    duration: float, acceleration: float, axis: 'float[:]', passing: 'float[:]'
) -> None:
    """Set all of a sequence but its nodes: about what it lasts [s], and its peak [m/s2]."""
    passing[Passing.ABOVE] = axis[Axis.ABOVE]
    passing[Passing.PACE] = 1.0
    passing[Passing.TARGET] = 0.0
    passing[Passing.FREE] = 0.0
    passing[Passing.INSTANTS] = 0.0
    passing[Passing.QUICK] = 0.0
    passing[Passing.TIME] = duration
    passing[Passing.ACCELERATION] = acceleration


def peak_acceleration(count: int, ramps: 'float[:,:]') -> float:
    """Largest magnitude of the acceleration [m/s2] in ramps."""
    peak = 0.0
    for i in range(count):
        peak = max(peak, abs(ramps[i, Phase.ACCELERATION] + ramps[i, Phase.CHANGE]))
        peak = max(peak, abs(ramps[i, Phase.ACCELERATION]))
    return peak


def set_sequence(
    attempt: int, count: int, phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]',
    work: 'float[:,:]',
) -> bool:
    """Set what Newton's method starts from in an attempt; False if it is that of another one."""
    passing = work[PlanWork.PASSING, :]
    q = int(axis[Axis.ABOVE]) + 2
    peak = peak_acceleration(count, phases)
    # a cruise alone has no ramps to start from, and nothing is shorter; a dip has other levels
    if peak == 0.0 or has_dip(phases, count):
        return False
    duration = total_duration(phases, count)
    # what little changes a velocity is known to the digits of the velocity
    speed = max(abs(problem[Problem.V]), abs(problem[Problem.W]))
    begin_sequence(duration, max(peak, FINE * speed / duration), axis, passing)
    copy_levels(count, phases, problem[Problem.V], axis, work)
    if not is_square(passing, work[PlanWork.NODES:PlanWork.KEPT, :]):
        set_alternating(1.0, ALTERNATING * passing[Passing.TIME] / q, work)
    # the levels of ordinary profiles are lower, as they meet at zero
    factor = HIGHER if q == 4 else 1.0
    if attempt % 3 == 1:
        factor = MORE * factor
    elif attempt % 3 == 2:
        factor = factor / HIGHER
    for i in range(int(passing[Passing.COUNT])):
        row = PlanWork.NODES + i
        if work[row, Node.KIND] == 0.0:
            work[row, Node.TIME] = factor * work[row, Node.TIME]
            if attempt >= 3:
                work[row, Node.SIGN] = -work[row, Node.SIGN]
        elif attempt >= 3:
            return False
    return True


def first_solution(
    count: int, ramps: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Keep the first sequence, of several starts, that has a solution; False if none has."""
    for attempt in range(6):
        if not set_sequence(attempt, count, ramps, problem, axis, work):
            return False
        if solve_rotated(problem, axis, work):
            keep_sequence(PlanWork.SOLVED, work)
            return True
    return False


def largest_excess(axis: 'float[:]', work: 'float[:,:]') -> float:
    """By how much the sequence exceeds a limit the most, relative."""
    largest = 0.0
    if measure_excess(axis, work):
        for order in range(1, int(work[PlanWork.PASSING, Passing.ABOVE]) + 2):
            largest = max(largest, work[PlanWork.EXCESS + order, Excess.SHARE])
    return largest


def is_brief(axis: 'float[:]') -> bool:
    """Whether few starts and ways are tried, as with levels of the jerk others hardly help.

    Of 2,000 plans one would be shorter by 0.5 %.
    """
    return ramps_suffice(axis) and axis[Axis.EFFORT] != Effort.THOROUGH


def shorter_solution(problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Keep a much shorter sequence of free levels, if there is one, in place of that which is kept.

    There can be several solutions. Newton's method started from ramps, which may lead far from the
    shortest one, as where these go beyond the target and back. From rest to rest they do not.
    """
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    q = int(passing[Passing.ABOVE]) + 2
    if is_brief(axis) or is_resting(problem, axis):
        return False
    # beside one with plateaus it has to keep the limits nearly
    most = NEVER if int(passing[Passing.COUNT]) == q else BEYOND
    duration = sequence_duration(passing, nodes)
    sign = work[PlanWork.NODES, Node.SIGN]
    scale = duration
    passing[Passing.QUICK] = 1.0
    for attempt in range(4):
        sign = -sign
        if attempt == 2:
            # the levels of a motion that the velocity limit makes much longer are too long
            if work[PlanWork.FAMILY, Family.FREE] >= duration:
                break
            scale = work[PlanWork.FAMILY, Family.FREE]
        set_alternating(sign, 0.5 * ALTERNATING * scale / q, work)
        if solve_rotated(problem, axis, work):
            shorter = sequence_duration(passing, nodes) < (1.0 - SMALL) * duration
            if shorter and largest_excess(axis, work) < most:
                passing[Passing.QUICK] = 0.0
                keep_sequence(PlanWork.SOLVED, work)
                return True
    return False
