"""How slowly a plan has to be built up for the drives, from what it asks of them.

Built up at a pace p, a motion has p^i of its derivatives of order i, from the acceleration on. That
is about so, as times change as well. So a plan that asks for too much tells at which pace it would
not.
"""

from segfmu.kernels.crane.records import Demand
from segfmu.kernels.crane.rope import interval_end
from segfmu.kernels.operation.drives import judge_reach
from segfmu.kernels.operation.reach import write_demands, write_load
from segfmu.kernels.operation.records import Known, OperationWork, Range, Reach
from segfmu.kernels.trajectory.records import Timing

# times in an interval at which a plan is looked at
SAMPLES = 4
# the lowest pace that is looked for, and bisections to the one sought
LOWEST = 0.25
BISECTIONS = 8


def pace_within(
    timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]', known: 'float[:,:]',
    work: 'float[:,:]',
) -> float:
    """About the pace at which a plan keeps the bounds of the drives; 1 if it does, or none helps.

    timing, coefficients and offsets of a plan; known: `Known`, work: `OperationWork`.
    """
    pace = 1.0
    time = timing[offsets[0], Timing.START]
    until = interval_end(time, timing, offsets)
    while until > time:
        for k in range(SAMPLES):
            at = time + (until - time) * k / SAMPLES
            low = 1.0
            tried = pace
            # the pace itself, the lowest one, and what is between them
            for i in range(2 + BISECTIONS):
                if keeps_at(tried, at, timing, coefficients, offsets, known, work):
                    low = tried
                    if i == 0:
                        break
                else:
                    if i == 1:
                        return 1.0
                    pace = tried
                tried = LOWEST
                if i > 0:
                    tried = 0.5 * (low + pace)
            pace = low
        time = until
        until = interval_end(time, timing, offsets)
    return pace


def keeps_at(
    pace: float, time: float, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    known: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """Whether the motion at a time [s], built up at a pace, keeps the bounds."""
    write_load(time, time, timing, coefficients, offsets, work)
    share = pace
    for order in range(2, 5):
        share = share * pace
        for axis in range(3):
            place = OperationWork.REACH + Reach.POSITION + 3 * order + axis
            work[place, Range.CENTRE] = share * work[place, Range.CENTRE]
    if not write_demands(known[Known.CRANE, :], work):
        return False
    return judge_reach(0, Demand.SIZE, known[Known.BOUNDS, :], work) > 0
