"""Which plans are tried for a command, one after the other.

First as it is. Where bounds of the drives are in the way, more slowly built up; where the way is
blocked, with a part of the velocity, or along some axes alone; at last a stop, also more slowly.
"""

from math import sqrt

from segfmu.kernels.operation.records import Aim, Known, Operation, OperationStatus, Tries
from segfmu.kernels.planner.records import Lower


def most_attempts() -> int:
    """Number of the attempts."""
    return Tries.MOST


def first_stop() -> int:
    """Number of the first attempt that is a stop."""
    return 6


def pace_of(attempt: int) -> float:
    """Pace of an attempt: limits of order i are pace^i of those given, from the acceleration on."""
    if attempt == 1 or attempt == 7:
        return sqrt(0.5)
    if attempt == 2 or attempt == 8:
        return 0.5
    return 1.0


def share_of(attempt: int, axis: int) -> float:
    """Share of its velocity that an axis gets in an attempt."""
    if attempt >= first_stop():
        return 0.0
    if attempt == 3:
        return 0.25
    if attempt == 4 and axis == 2:
        return 0.0
    if attempt == 5 and axis < 2:
        return 0.0
    return 1.0


def is_worth(attempt: int, failed: int, aim: 'float[:]') -> bool:
    """Whether an attempt is worth while for an aim (Aim), after one that failed by a status."""
    slows = attempt == 1 or attempt == 2 or attempt == 7 or attempt == 8
    blocked = failed == OperationStatus.WORKSPACE or failed == OperationStatus.OBSTACLE
    if slows and blocked:
        return False
    if attempt >= first_stop():
        return True
    if aim[Aim.IS_TARGET] > 0.5:
        return attempt <= 2
    horizontal = abs(aim[Aim.VALUE]) + abs(aim[Aim.VALUE + 1])
    vertical = abs(aim[Aim.VALUE + 2])
    if attempt == 4 or attempt == 5:
        return horizontal > 0.0 and vertical > 0.0
    return horizontal + vertical > 0.0


def set_attempt(
    attempt: int, operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]'
) -> None:
    """Write the limits of an attempt to limits[1] and LOWER, from those in limits[0] and `known`.

    Targets are planned with the scaled velocity; velocities are within it.
    """
    pace = pace_of(attempt)
    scale = 1.0
    if operation[Operation.AIM, Aim.IS_TARGET] > 0.5 and attempt < first_stop():
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
