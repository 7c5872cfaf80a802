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
# the most of a stop that was slower before: what the load has of jerk and snap is left in time
CALMER_STOP = 0.87


def is_slower(attempt: int) -> bool:
    """Whether a plan is built up more slowly than the limits permit."""
    if attempt == Attempt.SLOWER or attempt == Attempt.SLOWEST:
        return True
    return attempt == Attempt.STOP_SLOWER or attempt == Attempt.STOP_SLOWEST


def is_apart(attempt: int, operation: 'float[:,:]') -> bool:
    """Whether the axes go apart to a target."""
    if attempt == Attempt.APART:
        return True
    slower = is_slower(attempt) and attempt < Attempt.STOP
    return slower and operation[Operation.PROGRESS, Progress.APART] > 0.5


def is_straight(attempt: int, operation: 'float[:,:]') -> bool:
    """Whether a plan is for the aim itself, a target if it is one."""
    return attempt < Attempt.STOP and not is_apart(attempt, operation)


def ease_of(attempt: int, place: int, operation: 'float[:,:]') -> float:
    """Pace, steepness or speed of an attempt, by its place in `Progress`; see `set_attempt`."""
    if is_slower(attempt):
        return operation[Operation.PROGRESS, place]
    return 1.0


def note_ease(
    attempt: int, pace: float, steepness: float, speed: float, operation: 'float[:,:]'
) -> None:
    """Note how slow the next attempt is; pace, steepness, speed: what the last one tells, or 1."""
    share = CALMER
    if min(pace, speed) < 1.0:
        share = CLOSER * pace
    if is_slower(attempt) and steepness == 1.0:
        most = CALMER
        if attempt >= Attempt.STOP:
            most = CALMER_STOP
        share = min(share, most)
    if speed < 1.0:
        speed = CLOSER * speed
    progress = operation[Operation.PROGRESS, :]
    progress[Progress.PACE] = share * ease_of(attempt, Progress.PACE, operation)
    progress[Progress.STEEPNESS] = steepness * ease_of(attempt, Progress.STEEPNESS, operation)
    progress[Progress.SPEED] = speed * ease_of(attempt, Progress.SPEED, operation)


def stop_as_before(operation: 'float[:,:]') -> None:
    """Let a slower stop have ramps as those of the present plan, unless its own are quicker.

    What a stop asks for tells too little where the load is accelerated slowly when it begins.
    """
    progress = operation[Operation.PROGRESS, :]
    pace = progress[Progress.KEPT_PACE]
    steepness = progress[Progress.KEPT_STEEPNESS]
    if pace >= 1.0 or pace <= progress[Progress.PACE]:
        return
    progress[Progress.PACE] = pace
    progress[Progress.STEEPNESS] = steepness


def share_of(attempt: int, axis: int, operation: 'float[:,:]') -> float:
    """Share of its velocity that an axis gets in an attempt."""
    if attempt >= Attempt.STOP:
        return 0.0
    if attempt == Attempt.PART:
        return 0.25
    if attempt == Attempt.LEVEL and axis == 2:
        return 0.0
    if attempt == Attempt.UPRIGHT and axis < 2:
        return 0.0
    return ease_of(attempt, Progress.SPEED, operation)


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


def implied_snap(acceleration: float, jerk: float) -> float:
    """The snap that limits of acceleration and jerk imply."""
    return jerk * jerk / acceleration


def set_attempt(
    attempt: int, operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]'
) -> None:
    """Write the limits of an attempt to limits[1] and LOWER, from those in limits[0] and `known`.

    Limits of order i are pace^i of those given, from the acceleration on, and those above
    steepness^(i - 2) of that. Targets are planned with the scaled velocity; velocities are within
    it.
    """
    pace = ease_of(attempt, Progress.PACE, operation)
    steepness = ease_of(attempt, Progress.STEEPNESS, operation)
    scale = 1.0
    if operation[Operation.AIM, Aim.IS_TARGET] > 0.5 and is_straight(attempt, operation):
        scale = operation[Operation.AIM, Aim.SCALE] * ease_of(attempt, Progress.SPEED, operation)
    for axis in range(3):
        power = pace
        limits[1, axis, 0] = scale * limits[0, axis, 0]
        for i in range(1, limits.shape[2]):
            power = power * pace
            if i > 1:
                power = power * steepness
            given = limits[0, axis, i]
            # without a limit the snap of a slower plan would be as steep as before
            if i == 3 and given == 0.0 and is_slower(attempt):
                given = implied_snap(limits[0, axis, 1], limits[0, axis, 2])
            limits[1, axis, i] = power * given
    set_lower_of(1, operation, limits, known)


def set_lower_of(
    place: int, operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]'
) -> None:
    """Write the limits in the negative direction, LOWER, that belong to limits[place]."""
    for axis in range(3):
        for i in range(Lower.SIZE):
            share = limits[place, axis, i] / limits[0, axis, i]
            operation[Operation.LOWER + axis, i] = share * known[Known.LOWER + axis, i]
