"""What a command comes to: a velocity within the limits, or a target.

A number that is none counts as no wish: the load stops. `operation` is an `Operation`.
"""

from segfmu.kernels.clearance.records import Space
from segfmu.kernels.crane.records import Demand, RopeBounds
from segfmu.kernels.crane.travel import end_stop
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.records import (
    Aim,
    Command,
    Known,
    Operation,
    OperationMode,
    Progress,
    Slot,
)
from segfmu.kernels.planner.records import Lower
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Timing


def least_scale() -> float:
    """Share of the velocity limits below which nothing moves."""
    return 1e-3


def has_tripped(command: 'float[:]') -> bool:
    """Whether a drive has tripped."""
    for drive in range(3):
        if command[Command.TRIPPED + drive] > 0.5:
            return True
    return False


def wanted_mode(command: 'float[:]') -> int:
    """The mode that is followed: an emergency stop as long as a drive has tripped."""
    if has_tripped(command):
        return OperationMode.EMERGENCY
    return int(command[Command.MODE])


def write_aim(
    operation: 'float[:,:]', limits: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]',
) -> None:
    """Write what the command comes to; limits (3, n + 1), known a `Known`.

    The present plan tells where a push of INCHING begins.
    """
    command = operation[Operation.COMMAND, :]
    mode = wanted_mode(command)
    scale = command[Command.SCALE]
    if not scale >= least_scale():
        scale = 0.0
    scale = min(scale, 1.0)
    if mode == OperationMode.INCHING and scale > 0.0:
        write_push(scale, operation, known, timing, coefficients, offsets)
    else:
        write_wish(mode, scale, operation[Operation.AIM, :], command, limits, known)
        for axis in range(3):
            operation[Operation.PUSHED, axis] = 0.0
    operation[Operation.PROGRESS, Progress.MODE] = mode


def write_wish(
    mode: int, scale: float, aim: 'float[:]', command: 'float[:]', limits: 'float[:,:]',
    known: 'float[:,:]',
) -> None:
    """Write the aim (Aim) of a command that does not depend on those before."""
    aim[Aim.IS_TARGET] = 0.0
    aim[Aim.SCALE] = 0.0
    for axis in range(3):
        aim[Aim.VALUE + axis] = 0.0
    if mode == OperationMode.VELOCITY:
        for axis in range(3):
            lower = known[Known.LOWER + axis, Lower.VELOCITY]
            aim[Aim.VALUE + axis] = limited_velocity(
                command[Command.VELOCITY + axis], scale, limits[axis, 0], lower
            )
    elif mode == OperationMode.TARGET:
        write_target(scale, aim, command)


def write_target(scale: float, aim: 'float[:]', command: 'float[:]') -> None:
    """Write the aim of a target; without one it stays what it is."""
    if not command[Command.GO] > 0.5 or not scale > 0.0:
        return
    for axis in range(3):
        if not abs(command[Command.TARGET + axis]) < NEVER:
            return
    aim[Aim.IS_TARGET] = 1.0
    aim[Aim.SCALE] = scale
    for axis in range(3):
        aim[Aim.VALUE + axis] = command[Command.TARGET + axis]


def is_aim(row: int, operation: 'float[:,:]') -> bool:
    """Whether the aim in a row is the present one."""
    for i in range(Aim.SIZE):
        if not operation[Operation.AIM, i] == operation[row, i]:
            return False
    return True


def limited_velocity(velocity: float, scale: float, limit: float, lower: float) -> float:
    """A velocity [m/s] within a share of its limits; lower: magnitude of the least, 0: none."""
    least = limit
    if lower > 0.0:
        least = lower
    if velocity > 0.0:
        return min(velocity, scale * limit)
    if velocity < 0.0:
        return max(velocity, -scale * least)
    return 0.0


def push_of(velocity: float) -> float:
    """Sign of a velocity [m/s] as a push, 0 without one."""
    if velocity > 0.0:
        return 1.0
    if velocity < 0.0:
        return -1.0
    return 0.0


def write_push(
    scale: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]',
) -> None:
    """Write the aim of INCHING: each push moves the target by a distance, not beyond the ends.

    At first the load stops; the first push is counted from there.
    """
    aim = operation[Operation.AIM, :]
    command = operation[Operation.COMMAND, :]
    if not operation[Operation.PROGRESS, Progress.MODE] == OperationMode.INCHING:
        aim[Aim.IS_TARGET] = 0.0
        for axis in range(3):
            aim[Aim.VALUE + axis] = 0.0
            operation[Operation.PUSHED, axis] = push_of(command[Command.VELOCITY + axis])
    for axis in range(3):
        push = push_of(command[Command.VELOCITY + axis])
        if push == operation[Operation.PUSHED, axis]:
            continue
        operation[Operation.PUSHED, axis] = push
        distance = command[Command.DISTANCE + axis]
        if abs(push) > 0.0 and 0.0 < distance < NEVER:
            if aim[Aim.IS_TARGET] < 0.5:
                aim[Aim.IS_TARGET] = 1.0
                for i in range(3):
                    aim[Aim.VALUE + i] = standstill(Slot.PRESENT, i, timing, coefficients, offsets)
            wished = aim[Aim.VALUE + axis] + push * distance
            aim[Aim.VALUE + axis] = min(max(wished, low_end(axis, known)), high_end(axis, known))
    aim[Aim.SCALE] = scale * aim[Aim.IS_TARGET]


def standstill(
    slot: int, axis: int, timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]'
) -> float:
    """Where an axis of a plan comes to rest [m]."""
    last = offsets[slot * Slot.OFFSETS + axis + 1] - 1
    return evaluate_piece(
        coefficients[slot, :, :], last, coefficients.shape[2],
        timing[slot, last, Timing.LENGTH], 0,
    )


def low_end(axis: int, known: 'float[:,:]') -> float:
    """The lowest position of the load at rest [m], by workspace, longest rope and travel."""
    end = known[Known.SPACE, Space.WORKSPACE_MIN + axis]
    longest = known[Known.ROPE, RopeBounds.LONGEST]
    if axis == 2 and longest > 0.0:
        end = max(end, -longest)
    end = max(end, -stop_towards(1, axis, known))
    return end + end_rounding_of(end)


def high_end(axis: int, known: 'float[:,:]') -> float:
    """The highest one, by workspace, shortest rope and travel."""
    end = known[Known.SPACE, Space.WORKSPACE_MAX + axis]
    if axis == 2:
        end = min(end, -known[Known.ROPE, RopeBounds.SHORTEST])
    end = min(end, stop_towards(0, axis, known))
    return end - end_rounding_of(end)


def stop_towards(side: int, axis: int, known: 'float[:,:]') -> float:
    """The highest position of the load at an end stop [m], or, side 1, minus the lowest one."""
    if axis == 2:
        # the rope is long where the load is low
        return end_stop(Demand.PLACE + axis, 1 - side, known[Known.BOUNDS, :])
    return end_stop(Demand.PLACE + axis, side, known[Known.BOUNDS, :])


def end_rounding_of(end: float) -> float:
    """What rounding may take from the way to an end [m]."""
    return 1e-10 * abs(end)
