"""Proof that a plan keeps the bounds of the drives and of the sway, and the travel.

Ranges of all demands (reach.py) are inside the bounds in each interval of a partition of the plan.
It begins with the times at which pieces begin; an interval is halved until it is proved, or a value
in it is outside. So a plan that exceeds a bound is never taken for one that keeps it; one that uses
more than about 99.9 % of a bound may be taken for one that exceeds it.
"""

from segfmu.kernels.crane.records import Demand
from segfmu.kernels.crane.rope import interval_end
from segfmu.kernels.crane.uses import bound_magnitude, bound_origin, has_bounds
from segfmu.kernels.operation.reach import write_reach
from segfmu.kernels.operation.records import Known, OperationWork, Range, Reach
from segfmu.kernels.trajectory.records import Timing


def keeps_drives(
    timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]', known: 'float[:,:]',
    work: 'float[:,:]',
) -> bool:
    """Whether a plan is proved to keep the bounds; known: `Known`, work: `OperationWork`."""
    return keeps_demands(0, Demand.SIZE, timing, coefficients, offsets, known, work)


def keeps_demands(
    first: int, last: int, timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
    known: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """The same for the demands from one up to another, without that."""
    if not has_bounds(first, last, known[Known.BOUNDS, :]):
        return True
    time = timing[offsets[0], Timing.START]
    until = interval_end(time, timing, offsets)
    intervals = 0
    while until > time or intervals == 0:
        intervals = intervals + 1
        if not keeps_between(
            first, last, time, until, timing, coefficients, offsets, known, work
        ):
            return False
        time = until
        until = interval_end(time, timing, offsets)
    return True


def keeps_between(
    first: int, last: int, begin: float, end: float, timing: 'float[:,:]',
    coefficients: 'float[:,:]', offsets: 'int[:]', known: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """The same between two times [s] that no piece begins between."""
    depth = 0
    place = 0
    while depth > 0 or place == 0:
        length = (end - begin) * 0.5 ** depth
        start = begin + place * length
        found = 0
        if write_reach(
            start, start + length, timing, coefficients, offsets, known[Known.CRANE, :], work
        ):
            found = judge_reach(first, last, known[Known.BOUNDS, :], work)
        if found < 0 or (found == 0 and depth == 10):
            return False
        if found == 0:
            place = 2 * place
            depth = depth + 1
        else:
            place = place + 1
            while depth > 0 and place % 2 == 0:
                place = place // 2
                depth = depth - 1
    return True


def judge_reach(first: int, last: int, bounds: 'float[:]', work: 'float[:,:]') -> int:
    """1: these demands are inside their bounds; -1: one is outside; 0: an open question."""
    proved = 1
    # what rounding may add to a demand at its bound
    rounding = 1.0 + 1e-9
    for i in range(first, last):
        demand = work[OperationWork.REACH + Reach.DEMAND + i, :]
        for side in range(2):
            bound = bound_magnitude(i, side, bounds) * rounding
            if not bound == 0.0:
                value = (1.0 - 2.0 * side) * demand[Range.CENTRE]
                value = value - bound_origin(i, side, bounds)
                if not value <= bound:
                    return -1
                if not value + demand[Range.RADIUS] <= bound:
                    proved = 0
    return proved
