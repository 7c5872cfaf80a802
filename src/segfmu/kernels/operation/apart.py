"""Ways to a target on which the axes go apart, as the rope is too short for all at once.

A load that accelerates sideways needs a longer rope than one at rest. Near the longest one a plan
along all axes is slow, if there is any. So the load rises before it goes sideways, and goes
sideways before it sinks; on the way it is tried again whether all axes can go.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.aim import (
    end_rounding_of,
    high_end,
    is_aim,
    limited_velocity,
    low_end,
)
from segfmu.kernels.operation.attempts import CALMER
from segfmu.kernels.operation.plans import rest_time
from segfmu.kernels.operation.records import (
    Aim,
    Attempt,
    Command,
    Known,
    Operation,
    Progress,
    Slot,
)
from segfmu.kernels.operation.target import end_ways_at_target
from segfmu.kernels.planner.records import Lower, WaypointState

# what is left of a way to the target and is none, relative to the height of the target
LEFT = 1e-6
# share of what is left of a plan with axes apart, after which it is tried again to go along all
AGAIN = 0.05


def way_to_target(axis: int, operation: 'float[:,:]') -> float:
    """What is left of an axis's way to the target of AIM [m], 0: nothing that counts."""
    target = operation[Operation.AIM, Aim.VALUE + axis]
    way = target - operation[Operation.NOW + axis, WaypointState.POSITION]
    if abs(way) > LEFT * abs(operation[Operation.AIM, Aim.VALUE + 2]):
        return way
    return 0.0


def moves_apart(axis: int, operation: 'float[:,:]') -> bool:
    """Whether an axis goes while others wait."""
    if way_to_target(2, operation) > 0.0:
        return axis == 2
    return axis < 2


def rests_at_target(operation: 'float[:,:]', known: 'float[:,:]') -> bool:
    """Whether the load can rest at the target of AIM, but for obstacles."""
    for axis in range(3):
        target = operation[Operation.AIM, Aim.VALUE + axis]
        # an end itself is no place of `low_end` and `high_end`, by rounding
        touch = 2.0 * end_rounding_of(target)
        if not low_end(axis, known) - touch <= target <= high_end(axis, known) + touch:
            return False
    return True


def goes_apart(operation: 'float[:,:]') -> bool:
    """Whether there are such ways, and nothing that goes along all axes is nearly as fast.

    Such a plan has been chosen before, see `choose_ease`.
    """
    if operation[Operation.PROGRESS, Progress.PACE] > CALMER:
        return False
    level = abs(way_to_target(0, operation)) + abs(way_to_target(1, operation))
    return level > 0.0 and abs(way_to_target(2, operation)) > 0.0


def choose_apart(
    share: float, operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]'
) -> None:
    """Let some axes go towards the target of AIM, where their ways end, and the others rest.

    They have a share of their velocity. limits as those of `operate`, `known` a `Known`.
    """
    end_ways_at_target(operation)
    for axis in range(3):
        way = way_to_target(axis, operation)
        wish = 0.0
        if way > 0.0:
            wish = NEVER
        elif way < 0.0:
            wish = -NEVER
        operation[Operation.WISH, axis] = limited_velocity(
            wish, operation[Operation.AIM, Aim.SCALE], limits[0, axis, 0],
            known[Known.LOWER + axis, Lower.VELOCITY],
        )
        operation[Operation.SHARE, axis] = 0.0
        if moves_apart(axis, operation):
            operation[Operation.SHARE, axis] = share


def goes_on(operation: 'float[:,:]', timing: 'float[:,:,:]', offsets: 'int[:]') -> bool:
    """Whether the present plan goes to the aim, with axes apart, and is not at its end.

    Then all that is tried is whether all axes can go.
    """
    progress = operation[Operation.PROGRESS, :]
    if progress[Progress.ATTEMPT] != Attempt.APART or not is_aim(Operation.TAKEN, operation):
        return False
    return left_of_plan(operation, timing, offsets) > 0.0


def left_of_plan(
    operation: 'float[:,:]', timing: 'float[:,:,:]', offsets: 'int[:]'
) -> float:
    """Time until the present plan comes to rest [s]."""
    elapsed = operation[Operation.COMMAND, Command.TIME]
    elapsed = elapsed - operation[Operation.PROGRESS, Progress.BEGIN]
    return rest_time(Slot.PRESENT, timing, offsets) - elapsed


def has_ended(operation: 'float[:,:]', timing: 'float[:,:,:]', offsets: 'int[:]') -> bool:
    """Whether the present plan is at its end."""
    return not left_of_plan(operation, timing, offsets) > 0.0


def retry_later(operation: 'float[:,:]', timing: 'float[:,:,:]', offsets: 'int[:]') -> None:
    """Try a command again after a share of what is left of a plan with axes apart."""
    progress = operation[Operation.PROGRESS, :]
    later = AGAIN * left_of_plan(operation, timing, offsets)
    progress[Progress.RETRY] = max(
        progress[Progress.RETRY], operation[Operation.COMMAND, Command.TIME] + later
    )
