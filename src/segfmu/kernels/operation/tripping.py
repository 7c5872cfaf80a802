"""A drive trips while the carriages are being stopped already: its brake takes over."""

from segfmu.kernels.crane.records import Masses
from segfmu.kernels.operation.emergency import cover_swing, note_trips, plan_brakes
from segfmu.kernels.operation.records import (
    Command,
    Known,
    Operation,
    OperationStatus,
    Progress,
    Swing,
)
from segfmu.kernels.operation.swing import advance_swing
from segfmu.kernels.operation.takeover import bring_back, put_aside


def trips(operation: 'float[:,:]') -> bool:
    """Whether a drive has tripped since the emergency stop was planned."""
    for drive in range(3):
        if operation[Operation.COMMAND, Command.TRIPPED + drive] > 0.5:
            if operation[Operation.SWING, Swing.TRIPPED + drive] < 0.5:
                return True
    return False


def brake_anew(
    elapsed: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> bool:
    """Plan the emergency stop anew from here, with what has tripped; since its start [s].

    Where no such stop keeps the bounds, the one before goes on.
    """
    advance_swing(elapsed, known[Known.CRANE, Masses.GRAVITY], operation[Operation.SWING, :], work)
    put_aside(operation)
    note_trips(operation)
    if not plan_brakes(operation, known, work):
        bring_back(operation)
        note_trips(operation)
        operation[Operation.PROGRESS, Progress.REFUSED] = OperationStatus.DRIVES
    cover_swing(operation, known, timing, coefficients, offsets, work)
    return True
