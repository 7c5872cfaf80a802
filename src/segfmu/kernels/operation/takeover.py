"""When a swing is taken over: behind an emergency stop, and from a measured state on."""

from math import cos, sin

from segfmu.kernels.crane.records import Masses, State
from segfmu.kernels.operation.calming import plan_calm
from segfmu.kernels.operation.emergency import cover_swing
from segfmu.kernels.operation.plans import copy_plan, plan_end
from segfmu.kernels.operation.records import (
    Aim,
    Command,
    HeldVelocity,
    Known,
    Operation,
    OperationMode,
    OperationStatus,
    Progress,
    Slot,
    Swing,
)
from segfmu.kernels.operation.swing import advance_swing, resolved_step, stand_time


def is_calming(operation: 'float[:,:]') -> bool:
    """Whether the load of a swing that has been taken over does not rest yet."""
    return operation[Operation.COMMAND, Command.TIME] < operation[Operation.SWING, Swing.CALM]


def note_calming(operation: 'float[:,:]') -> None:
    """Note what a command comes to until the load rests: a stop, or less than asked."""
    progress = operation[Operation.PROGRESS, :]
    progress[Progress.STATUS] = OperationStatus.REDUCED
    if int(operation[Operation.COMMAND, Command.MODE]) == OperationMode.STOP:
        progress[Progress.STATUS] = OperationStatus.TAKEN


def wants_calm(operation: 'float[:,:]') -> bool:
    """Whether a command asks to take the swing behind an emergency stop over, now."""
    command = operation[Operation.COMMAND, :]
    mode = int(command[Command.MODE])
    if mode == OperationMode.EMERGENCY or mode == OperationMode.MISSION:
        return False
    return command[Command.TIME] >= next_calm(operation)


def next_calm(operation: 'float[:,:]') -> float:
    """When the swing behind an emergency stop can be taken over [s]."""
    progress = operation[Operation.PROGRESS, :]
    stands = progress[Progress.BEGIN] + stand_time(operation[Operation.SWING, :])
    return max(stands, progress[Progress.RETRY])


def take_over(
    elapsed: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> None:
    """Take the swing behind an emergency stop over, or let it swing on; since its start [s]."""
    swing = operation[Operation.SWING, :]
    advance_swing(elapsed, known[Known.CRANE, Masses.GRAVITY], swing, work)
    cover_swing(operation, known, timing, coefficients, offsets, work)
    try_calm(operation, known, timing, coefficients, offsets, work, stack)


def try_calm(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> None:
    """Follow a plan from the state SWING to rest, if there is one that is proved."""
    command = operation[Operation.COMMAND, :]
    progress = operation[Operation.PROGRESS, :]
    swing = operation[Operation.SWING, :]
    progress[Progress.ATTEMPTS] = progress[Progress.ATTEMPTS] + 1.0
    status = plan_calm(operation, known, timing, coefficients, offsets, work, stack)
    if status != OperationStatus.TAKEN:
        progress[Progress.STATUS] = status
        progress[Progress.REFUSED] = status
        # when the swing is another one: after a radian of its phase
        radian = 20.0 * resolved_step(known[Known.CRANE, Masses.GRAVITY], swing)
        progress[Progress.RETRY] = command[Command.TIME] + radian
        return
    copy_plan(Slot.TRIED, Slot.PRESENT, timing, coefficients, offsets)
    for axis in range(3):
        for i in range(HeldVelocity.SIZE):
            operation[Operation.HELD + axis, i] = 0.0
    swing[Swing.ACTIVE] = 0.0
    swing[Swing.CALM] = command[Command.TIME] + plan_end(Slot.PRESENT, 0, timing, offsets)
    progress[Progress.BEGIN] = command[Command.TIME]
    progress[Progress.PLANS] = progress[Progress.PLANS] + 1.0
    progress[Progress.ATTEMPT] = 0.0
    progress[Progress.NEXT] = 0.0
    progress[Progress.RETRY] = 0.0
    operation[Operation.TAKEN, Aim.IS_TARGET] = -1.0
    note_calming(operation)


def take_over_state(
    state: 'float[:]', operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> int:
    """Begin in a state of the crane (State) by bringing it to rest: an `OperationStatus`.

    `operation` has been begun; its command tells the time. Bridge, trolley and hoist have no
    acceleration at first.
    """
    swing = operation[Operation.SWING, :]
    for axis in range(3):
        swing[Swing.POSITION + axis] = state[State.POSITION + axis]
        swing[Swing.VELOCITY + axis] = state[State.VELOCITY + axis]
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
    operation[Operation.COMMAND, Command.MODE] = OperationMode.STOP
    try_calm(operation, known, timing, coefficients, offsets, work, stack)
    return int(operation[Operation.PROGRESS, Progress.STATUS])
