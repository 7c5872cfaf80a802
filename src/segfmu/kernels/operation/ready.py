"""Whether a feedforward can follow commands, and when it next has to look at them."""

from segfmu.kernels.crane.friction import rubs
from segfmu.kernels.crane.records import Compensation
from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.aim import wanted_mode
from segfmu.kernels.operation.records import (
    Command,
    HeldVelocity,
    Operation,
    OperationMode,
    OperationRows,
    Progress,
    ReadyFault,
    ReadyStatus,
    Swing,
)
from segfmu.kernels.operation.takeover import is_calming, next_calm


def check_ready(
    compensation: 'float[:]', resistance: 'float[:]', pieces: int, fault: 'float[:]'
) -> int:
    """Whether commands can be followed behind a plan of so many pieces: a `ReadyStatus`.

    compensation: `Compensation`, resistance: `Resistance`. A drive that acts late has setpoints
    that are ahead of those of the others, and the contact of an axis with dry friction a history:
    a command would change both afterwards.
    """
    for drive in range(3):
        fault[ReadyFault.DRIVE] = drive
        fault[ReadyFault.VALUE] = compensation[Compensation.DEAD_TIME + drive]
        if fault[ReadyFault.VALUE] > 0.0:
            return ReadyStatus.DEAD_TIME
        if rubs(resistance, drive):
            return ReadyStatus.FRICTION
    fault[ReadyFault.VALUE] = pieces
    if pieces > OperationRows.KEPT:
        return ReadyStatus.PIECES
    return ReadyStatus.READY


def next_operation(operation: 'float[:,:]') -> float:
    """When a command has to be looked at again though it stays the same [s], NEVER: never."""
    command = operation[Operation.COMMAND, :]
    progress = operation[Operation.PROGRESS, :]
    swing = operation[Operation.SWING, :]
    mode = wanted_mode(command)
    if swing[Swing.ACTIVE] > 0.5:
        uncovered = progress[Progress.BEGIN] + swing[Swing.COVERED] - 0.5 * command[Command.HOLD]
        if mode == OperationMode.EMERGENCY or mode == OperationMode.MISSION:
            return uncovered
        return min(uncovered, next_calm(operation))
    if mode == OperationMode.MISSION:
        return NEVER
    if is_calming(operation):
        return swing[Swing.CALM]
    if progress[Progress.ATTEMPT] > 0.0 or progress[Progress.NEXT] > 0.0:
        return max(progress[Progress.RETRY], command[Command.TIME] + 0.25 * command[Command.HOLD])
    following = NEVER
    for axis in range(3):
        held = operation[Operation.HELD + axis, :]
        if held[HeldVelocity.FREE] > 0.5:
            renewed = held[HeldVelocity.UNTIL] - 0.5 * command[Command.HOLD]
            following = min(following, progress[Progress.BEGIN] + renewed)
    return following
