"""A measured state of the crane is taken over: the motion begins there and comes to rest."""

from math import cos, sin

from segfmu.kernels.crane.records import Masses, State
from segfmu.kernels.numerics.numbers import FARTHEST_PLACE, NEVER
from segfmu.kernels.operation.aim import wanted_mode
from segfmu.kernels.operation.records import (
    Command,
    Known,
    Operation,
    OperationMode,
    OperationStatus,
    Progress,
    Swing,
)
from segfmu.kernels.operation.swing import advance_swing
from segfmu.kernels.operation.takeover import bring_back, put_aside, try_calm, write_calm_aim


def takes_measured(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]', coefficients:
    'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> bool:
    """Whether the command asks to begin in its measured state, and a plan from there is followed.

    It asks where TAKE_OVER rises. An emergency stop comes first.
    """
    command = operation[Operation.COMMAND, :]
    progress = operation[Operation.PROGRESS, :]
    if wanted_mode(command) == OperationMode.EMERGENCY:
        return False
    if not command[Command.TAKE_OVER] > 0.5:
        progress[Progress.TAKES] = 0.0
        return False
    if progress[Progress.TAKES] > 0.5:
        return False
    return (
        take_over_measured(operation, known, timing, coefficients, offsets, work, stack)
        == OperationStatus.TAKEN
    )


def take_over_measured(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]', coefficients:
    'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> int:
    """Follow a plan from the measured state of the command on: TAKEN, or why there is none.

    Then what was followed goes on.
    """
    progress = operation[Operation.PROGRESS, :]
    progress[Progress.TAKES] = operation[Operation.COMMAND, Command.TAKE_OVER]
    refused = state_status(operation[Operation.COMMAND, :])
    if refused != OperationStatus.TAKEN:
        progress[Progress.STATUS] = refused
        progress[Progress.REFUSED] = refused
        return refused
    put_aside(operation)
    write_measured(operation, known, work)
    write_calm_aim(operation)
    retry = progress[Progress.RETRY]
    if try_calm(True, operation, known, timing, coefficients, offsets, work, stack):
        return OperationStatus.TAKEN
    bring_back(operation)
    progress[Progress.RETRY] = retry
    return int(progress[Progress.STATUS])


def state_status(command: 'float[:]') -> int:
    """TAKEN for a measured state of a command that a motion can begin in; or ROPE, or WORKSPACE.

    Its places are no farther away than targets are [m].
    """
    if not is_hanging(command):
        return OperationStatus.ROPE
    for axis in range(3):
        if abs(command[Command.MEASURED + State.POSITION + axis]) > FARTHEST_PLACE:
            return OperationStatus.WORKSPACE
    return OperationStatus.TAKEN


def is_hanging(command: 'float[:]') -> bool:
    """Whether the measured state of a command is one of a load below its crane."""
    for i in range(State.SIZE):
        if not abs(command[Command.MEASURED + i]) < NEVER:
            return False
    for i in range(2):
        if not abs(command[Command.MEASURED + State.ANGLE + i]) < 1.5:
            return False
    length = command[Command.MEASURED + State.POSITION + 2]
    paid_out = command[Command.LEAD] * command[Command.MEASURED + State.VELOCITY + 2]
    return min(length, length + paid_out) > 0.0


def write_measured(operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]') -> None:
    """Write the measured state of the command to SWING, as it is a LEAD later.

    Until then bridge, trolley and hoist keep their velocities.
    """
    command = operation[Operation.COMMAND, :]
    state = command[Command.MEASURED : Command.SIZE]
    swing = operation[Operation.SWING, :]
    for i in range(Swing.SIZE):
        swing[i] = 0.0
    for axis in range(3):
        swing[Swing.POSITION + axis] = state[State.POSITION + axis]
        swing[Swing.VELOCITY + axis] = state[State.VELOCITY + axis]
        swing[Swing.LEFT + axis] = NEVER
    length = state[State.POSITION + 2]
    stretch = state[State.VELOCITY + 2]
    sin_x = sin(state[State.ANGLE])
    cos_x = cos(state[State.ANGLE])
    sin_y = sin(state[State.ANGLE + 1])
    cos_y = cos(state[State.ANGLE + 1])
    rate_x = state[State.RATE]
    rate_y = state[State.RATE + 1]
    # (16) and its rate
    swing[Swing.PATH] = length * sin_x
    swing[Swing.PATH + 1] = -length * cos_x * sin_y
    swing[Swing.PATH + 2] = -length * cos_x * cos_y
    swing[Swing.RATE] = stretch * sin_x + length * cos_x * rate_x
    swing[Swing.RATE + 1] = -stretch * cos_x * sin_y + length * (
        sin_x * sin_y * rate_x - cos_x * cos_y * rate_y
    )
    swing[Swing.RATE + 2] = -stretch * cos_x * cos_y + length * (
        sin_x * cos_y * rate_x + cos_x * sin_y * rate_y
    )
    advance_swing(command[Command.LEAD], known[Known.CRANE, Masses.GRAVITY], swing, work)
    for axis in range(3):
        swing[Swing.LEFT + axis] = 0.0
