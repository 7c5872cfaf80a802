"""Between what each axis may come to rest: the ends of its way, and an obstacle that is ahead.

An obstacle that a plan meets becomes an end of the way of one axis, as that of the workspace is. It
is an axis along which the load is before the obstacle now: while it stays there, whatever the
others do, nothing meets.
"""

from segfmu.kernels.clearance.records import Box, Part, SpaceFault
from segfmu.kernels.clearance.space import write_box
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.aim import end_rounding_of, high_end, low_end
from segfmu.kernels.operation.records import Known, Operation, OperationWork, Way
from segfmu.kernels.planner.records import WaypointState


def open_ways(operation: 'float[:,:]', known: 'float[:,:]') -> None:
    """Let ways to be tried end at the ends of the load's range alone."""
    for axis in range(3):
        operation[Operation.TRIED_WAYS + axis, Way.LOW] = low_end(axis, known)
        operation[Operation.TRIED_WAYS + axis, Way.HIGH] = high_end(axis, known)


def are_ways_kept(operation: 'float[:,:]') -> bool:
    """Whether the ways to be tried are those of the present plan."""
    for axis in range(3):
        for i in range(Way.SIZE):
            kept = operation[Operation.WAYS + axis, i]
            if not kept == operation[Operation.TRIED_WAYS + axis, i]:
                return False
    return True


def keep_ways(operation: 'float[:,:]') -> None:
    """Note the ways of the plan that has been tried as those of the present one."""
    for axis in range(3):
        for i in range(Way.SIZE):
            operation[Operation.WAYS + axis, i] = operation[Operation.TRIED_WAYS + axis, i]


def rests_short(operation: 'float[:,:]') -> bool:
    """Whether an axis that the command moves rests before the end of its way."""
    for axis in range(3):
        now = operation[Operation.NOW + axis, :]
        end = now[WaypointState.POSITION]
        if operation[Operation.WISH, axis] > 0.0:
            end = operation[Operation.TRIED_WAYS + axis, Way.HIGH]
        elif operation[Operation.WISH, axis] < 0.0:
            end = operation[Operation.TRIED_WAYS + axis, Way.LOW]
        # what is left by rounding is nothing to go
        left = abs(end - now[WaypointState.POSITION]) - 2.0 * end_rounding_of(end)
        resting = now[WaypointState.VELOCITY] == 0.0 and now[WaypointState.ACCELERATION] == 0.0
        if resting and left > 0.0:
            return True
    return False


def end_before_obstacle(
    operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """End the way of an axis before the obstacle that the plan in TRIED meets; False: none can.

    Of the axes that the command moves towards the obstacle it is the last one that enters it.
    """
    fault = work[OperationWork.FAULT, :]
    box = work[OperationWork.BOXES, :]
    obstacle = Known.OBSTACLES + int(fault[SpaceFault.BOX])
    write_box(known[Known.SPACE, :], known[obstacle, :], box)
    low = int(Box.LOAD_LOW)
    high = int(Box.LOAD_HIGH)
    axes = 3
    if int(fault[SpaceFault.PART]) == Part.ROPE:
        low = int(Box.ROPE_LOW)
        high = int(Box.ROPE_HIGH)
        # the rope reaches up to its carriage, so it can stay beside an obstacle alone
        axes = 2
    chosen = -1
    least = NEVER
    for axis in range(axes):
        depth = depth_towards(
            axis, box[low + axis], box[high + axis], fault[SpaceFault.X + axis], operation
        )
        if depth < least:
            least = depth
            chosen = axis
    if chosen < 0:
        return False
    end_way(chosen, box[low + chosen], box[high + chosen], operation)
    return True


def end_way(axis: int, low: float, high: float, operation: 'float[:,:]') -> None:
    """End the way of an axis at the face ahead; where it ends there already, at once.

    A rope that leans over the face while its load moves meets the obstacle all the same.
    """
    now = operation[Operation.NOW + axis, WaypointState.POSITION]
    way = operation[Operation.TRIED_WAYS + axis, :]
    if operation[Operation.WISH, axis] > 0.0:
        end = low - end_rounding_of(low)
        if way[Way.HIGH] <= end:
            end = now
        way[Way.HIGH] = end
    else:
        end = high + end_rounding_of(high)
        if way[Way.LOW] >= end:
            end = now
        way[Way.LOW] = end


def depth_towards(
    axis: int, low: float, high: float, place: float, operation: 'float[:,:]'
) -> float:
    """How deep a place is behind the face that an axis moves to [m], NEVER: it need not come there.

    low and high are faces of the obstacle. An axis along which the load is beside the obstacle
    cannot keep away, nor can one that does not move.
    """
    wish = operation[Operation.WISH, axis] * operation[Operation.SHARE, axis]
    now = operation[Operation.NOW + axis, WaypointState.POSITION]
    way = operation[Operation.TRIED_WAYS + axis, :]
    # what is at a face may be behind it by rounding
    touch = 1e-9 * max(abs(low), abs(high))
    if wish > 0.0 and now <= low + touch and way[Way.HIGH] > now:
        return place - low
    if wish < 0.0 and now >= high - touch and way[Way.LOW] < now:
        return high - place
    return NEVER
