"""How slowly a plan has to be built up for drives and rope, from what it asks of them.

Built up at a pace p, a motion has p^i of its derivatives of order i, from the acceleration on. With
ramps of the acceleration that are less steep by a share s, those above have s^(i - 2) of that. That
is about so, as times change as well. So a plan that asks for too much tells how it would not. Where
its velocity is too much, that is slower, too.
"""

from segfmu.kernels.crane.records import Demand, RopeBounds
from segfmu.kernels.crane.rope import interval_end
from segfmu.kernels.numerics.numbers import NEARLY, NEVER
from segfmu.kernels.operation.attempts import implied_snap
from segfmu.kernels.operation.drives import judge_reach
from segfmu.kernels.operation.reach import write_demands, write_load
from segfmu.kernels.operation.records import Known, OperationWork, Range, Reach
from segfmu.kernels.trajectory.records import Timing

# times in an interval at which a plan is looked at
SAMPLES = 4
# the lowest pace that is looked for, and bisections to the one sought
LOWEST = 0.0625
BISECTIONS = 8
# from one steepness to the next one, and the least of them
FLATTER = 0.25
FLATTEST = 0.01


def ease_within(
    limits: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    known: 'float[:,:]', work: 'float[:,:]',
) -> 'tuple[float, float, float]':
    """About the pace, steepness and share of the velocity at which drives and rope follow a plan.

    1 if it does, or none helps. limits (3, n + 1): those of the plan, 0 where absent; timing,
    coefficients and offsets are its own; known: `Known`, work: `OperationWork`.
    """
    speed = 1.0
    best = 1.0
    steepest = 1.0
    least = NEVER
    # at first with the whole velocity
    for _ in range(2):
        steepness = 1.0
        # times to reach a velocity and to build its acceleration up, a half of that by default
        while 1.0 + 0.5 / steepness < least and steepness > FLATTEST:
            pace = pace_within(speed, steepness, limits, timing, coefficients, offsets, known, work)
            if pace > 0.0:
                takes = 1.0 / (pace * pace) + 0.5 / (pace * steepness)
                if takes < least:
                    least = takes
                    best = pace
                    steepest = steepness
            steepness = FLATTER * steepness
        if least < NEVER:
            return best, steepest, speed
        speed = pace_within(0.0, 0.0, limits, timing, coefficients, offsets, known, work)
        if speed == 0.0:
            break
    return 1.0, 1.0, 1.0


def pace_within(
    speed: float, steepness: float, limits: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', offsets: 'int[:]', known: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """That pace with a share of the velocity, 0: as the pace, and a steepness; 0 if none helps."""
    pace = 1.0
    time = timing[offsets[0], Timing.START]
    until = interval_end(time, timing, offsets)
    while until > time:
        samples = SAMPLES
        if keeps_through(
            time, until, pace, speed, steepness, limits, timing, coefficients, offsets, known, work
        ):
            samples = 0
        for k in range(samples):
            at = time + (until - time) * k / SAMPLES
            note_load(at, timing, coefficients, offsets, work)
            low = 1.0
            tried = pace
            # the pace itself, the lowest one, and what is between them
            for i in range(2 + BISECTIONS):
                if keeps_at(tried, speed, steepness, limits, known, work):
                    low = tried
                    if i == 0:
                        break
                else:
                    if i == 1:
                        return 0.0
                    pace = tried
                tried = LOWEST
                if i > 0:
                    tried = 0.5 * (low + pace)
            pace = low
        time = until
        until = interval_end(time, timing, offsets)
    return pace


def paced_share(order: int, pace: float, speed: float, steepness: float) -> float:
    """What is left of a derivative of an order, from 1 on, at a pace."""
    if order == 1 and speed > 0.0:
        return speed
    power = pace
    for i in range(1, order):
        power = power * pace
        if i > 1:
            power = power * steepness
    return power


def keeps_through(
    begin: float, end: float, pace: float, speed: float, steepness: float, limits: 'float[:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]', known: 'float[:,:]',
    work: 'float[:,:]',
) -> bool:
    """Whether all the motion between two times is proved to keep the bounds, built up at a pace."""
    order = 3
    for axis in range(3):
        # without a limit the snap is another one, see `keeps_at`
        if not limits[axis, order] > 0.0:
            return False
    write_load(begin, end, timing, coefficients, offsets, work)
    for order in range(1, 5):
        share = paced_share(order, pace, speed, steepness)
        for axis in range(3):
            place = OperationWork.REACH + Reach.POSITION + 3 * order + axis
            for i in range(Range.SIZE):
                work[place, i] = share * work[place, i]
    return keeps_reached(known, work)


def note_load(
    time: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    work: 'float[:,:]',
) -> None:
    """Note the motion at a time [s] in the rows FLAT, as it is looked at for many paces."""
    write_load(time, time, timing, coefficients, offsets, work)
    for order in range(5):
        for axis in range(3):
            place = OperationWork.REACH + Reach.POSITION + 3 * order + axis
            work[OperationWork.FLAT + order, axis] = work[place, Range.CENTRE]


def keeps_at(
    pace: float, speed: float, steepness: float, limits: 'float[:,:]', known: 'float[:,:]',
    work: 'float[:,:]',
) -> bool:
    """Whether the motion that `note_load` noted, built up at a pace, keeps the bounds."""
    for order in range(1, 5):
        share = paced_share(order, pace, speed, steepness)
        for axis in range(3):
            place = OperationWork.REACH + Reach.POSITION + 3 * order + axis
            value = work[OperationWork.FLAT + order, axis]
            if order == 4 and limits[axis, order - 1] == 0.0:
                # that of steep ramps, which a slower plan has not
                most = implied_snap(limits[axis, 1], limits[axis, 2])
                value = min(max(value, -most), most)
            work[place, Range.CENTRE] = share * value
    return keeps_reached(known, work)


def keeps_reached(known: 'float[:,:]', work: 'float[:,:]') -> bool:
    """Whether rope and drives keep their bounds in all of the ranges of the load."""
    if not write_demands(known[Known.CRANE, :], work):
        return False
    longest = known[Known.ROPE, RopeBounds.LONGEST]
    rope = work[OperationWork.REACH + Reach.DEMAND + Demand.PLACE + 2, :]
    length = rope[Range.CENTRE] + rope[Range.RADIUS]
    if longest > 0.0 and length > longest * (1.0 + NEARLY):
        return False
    return judge_reach(0, Demand.SIZE, known[Known.BOUNDS, :], work) > 0
