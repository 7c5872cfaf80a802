"""Which plans are tried for a command, one after the other.

First as it is. Where bounds of the drives are in the way, more slowly built up, as slowly as what
the plan asks of them tells (pace.py); at last with a part of the velocity, along some axes alone,
or a stop, also more slowly. What meets an obstacle is tried once more with a way that ends before
it, see ways.py.
"""

from segfmu.kernels.operation.records import (
    Aim,
    Attempt,
    Known,
    Operation,
    OperationStatus,
    Progress,
)
from segfmu.kernels.planner.records import Lower

# share of the pace that a failed plan tells, for what it does not: peaks between samples, and axes
# that meet otherwise
CLOSER = 0.98
# pace over that of a plan which failed, where that tells none; the most where it was slower before
CALMER = 0.7


def is_slower(attempt: int) -> bool:
    """Whether a plan is built up more slowly than the limits permit."""
    if attempt == Attempt.SLOWER or attempt == Attempt.SLOWEST:
        return True
    return attempt == Attempt.STOP_SLOWER or attempt == Attempt.STOP_SLOWEST


def pace_of(attempt: int, operation: 'float[:,:]') -> float:
    """Pace of an attempt: limits of order i are pace^i of those given, from the acceleration on."""
    if is_slower(attempt):
        return operation[Operation.PROGRESS, Progress.PACE]
    return 1.0


def note_pace(attempt: int, told: float, operation: 'float[:,:]') -> None:
    """Note the pace of the next attempt; told: the share that the plan of the last one tells.

    1 if it tells none.
    """
    share = CALMER
    if told < 1.0:
        share = CLOSER * told
    if is_slower(attempt):
        share = min(share, CALMER)
    operation[Operation.PROGRESS, Progress.PACE] = share * pace_of(attempt, operation)


def share_of(attempt: int, axis: int) -> float:
    """Share of its velocity that an axis gets in an attempt."""
    if attempt >= Attempt.STOP:
        return 0.0
    if attempt == Attempt.PART:
        return 0.25
    if attempt == Attempt.LEVEL and axis == 2:
        return 0.0
    if attempt == Attempt.UPRIGHT and axis < 2:
        return 0.0
    return 1.0


def is_worth(attempt: int, failed: int, aim: 'float[:]') -> bool:
    """Whether an attempt is worth while for an aim (Aim), after one that failed by a status."""
    blocked = failed == OperationStatus.WORKSPACE or failed == OperationStatus.OBSTACLE
    if is_slower(attempt) and blocked:
        return False
    if attempt >= Attempt.STOP:
        return True
    if aim[Aim.IS_TARGET] > 0.5:
        return attempt <= Attempt.SLOWEST
    horizontal = abs(aim[Aim.VALUE]) + abs(aim[Aim.VALUE + 1])
    vertical = abs(aim[Aim.VALUE + 2])
    if attempt == Attempt.LEVEL or attempt == Attempt.UPRIGHT:
        return horizontal > 0.0 and vertical > 0.0
    return horizontal + vertical > 0.0


def set_attempt(
    attempt: int, operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]'
) -> None:
    """Write the limits of an attempt to limits[1] and LOWER, from those in limits[0] and `known`.

    Targets are planned with the scaled velocity; velocities are within it.
    """
    pace = pace_of(attempt, operation)
    scale = 1.0
    if operation[Operation.AIM, Aim.IS_TARGET] > 0.5 and attempt < Attempt.STOP:
        scale = operation[Operation.AIM, Aim.SCALE]
    for axis in range(3):
        power = pace
        limits[1, axis, 0] = scale * limits[0, axis, 0]
        for i in range(1, limits.shape[2]):
            power = power * pace
            limits[1, axis, i] = power * limits[0, axis, i]
    set_lower_of(1, operation, limits, known)


def set_lower_of(
    place: int, operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]'
) -> None:
    """Write the limits in the negative direction, LOWER, that belong to limits[place]."""
    for axis in range(3):
        for i in range(Lower.SIZE):
            share = limits[place, axis, i] / limits[0, axis, i]
            operation[Operation.LOWER + axis, i] = share * known[Known.LOWER + axis, i]
