"""One step of an operated motion: a command -> a plan up to standstill, or the old one goes on.

Every plan that is taken begins in the state of the one before, all continuous derivatives included,
and is proved to keep the limits, the rope, the space and the bounds of the drives until it rests.
Nothing else is ever followed. Work spaces are cleared before they are used, so that the same
commands give the same plans after a state was restored.
"""

from segfmu.kernels.operation.aim import is_aim, wanted_mode, write_aim
from segfmu.kernels.operation.apart import has_ended
from segfmu.kernels.operation.emergency import begin_emergency, prolong_swing
from segfmu.kernels.operation.held import holds_long_enough
from segfmu.kernels.operation.measured import takes_measured
from segfmu.kernels.operation.plans import note_present
from segfmu.kernels.operation.records import (
    Aim,
    Attempt,
    Command,
    HeldVelocity,
    Operation,
    OperationMode,
    OperationStatus,
    Progress,
    Swing,
)
from segfmu.kernels.operation.takeover import calm_on, is_calming, take_over, wants_calm
from segfmu.kernels.operation.tries import attempt_plans, is_prolonged, renew_holds
from segfmu.kernels.operation.tripping import brake_anew, trips


def begin_operation(time: float, operation: 'float[:,:]') -> None:
    """Begin with the plan in the slot PRESENT, which begins at a time [s]; the command stays."""
    for row in range(Operation.AIM, Operation.SIZE):
        for i in range(operation.shape[1]):
            operation[row, i] = 0.0
    operation[Operation.PROGRESS, Progress.BEGIN] = time
    # times may be below zero
    operation[Operation.PROGRESS, Progress.RETRY] = time
    operation[Operation.SWING, Swing.CALM] = time
    # it is for no command
    operation[Operation.TAKEN, Aim.IS_TARGET] = -1.0


def operate(
    operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', cells: 'float[:,:,:]',
    lead: 'float[:,:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> bool:
    """Follow the command in `operation` (Operation); whether another plan is in the slot PRESENT.

    limits (2, 3, n + 1): those of the load in the first place, 0 where absent, room in the second;
    known a `Known`; timing and coefficients (Slot.COUNT, OperationRows.ALL, ..), offsets those of
    all slots; states (2, 3, n + 1); cells (3, Cell.SIZE, Cell.COLUMNS), lead a `LeadWork`, work an
    `OperationWork`, stack (Stack.ROWS, Span.SIZE, 4 n - 3).
    """
    command = operation[Operation.COMMAND, :]
    progress = operation[Operation.PROGRESS, :]
    mode = wanted_mode(command)
    elapsed = command[Command.TIME] - progress[Progress.BEGIN]
    if takes_measured(operation, known, timing, coefficients, offsets, work, stack):
        return True
    if operation[Operation.SWING, Swing.ACTIVE] > 0.5:
        if trips(operation):
            return brake_anew(elapsed, operation, known, timing, coefficients, offsets, work)
        if not wants_calm(operation):
            return prolong_swing(elapsed, operation, known, timing, coefficients, offsets, work)
        take_over(elapsed, operation, known, timing, coefficients, offsets, work, stack)
        return True
    if mode == OperationMode.EMERGENCY:
        note_present(elapsed, operation, timing, coefficients, offsets)
        if begin_emergency(operation, known, timing, coefficients, offsets, work):
            begin_swing(operation)
            return True
    if mode == OperationMode.MISSION:
        return False
    if is_calming(operation):
        return calm_on(elapsed, operation, known, timing, coefficients, offsets, work, stack)
    for i in range(Aim.SIZE):
        operation[Operation.BEFORE, i] = operation[Operation.AIM, i]
    write_aim(operation, limits[0, :, :], known, timing, coefficients, offsets)
    if not is_aim(Operation.BEFORE, operation):
        progress[Progress.NEXT] = 0.0
    if is_served(elapsed, operation) or is_in_vain(operation, timing, offsets):
        return False
    note_present(elapsed, operation, timing, coefficients, offsets)
    if renews(elapsed, operation) and renew_holds(
        operation, limits[0, :, :], known, timing, coefficients, offsets, states, lead, work, stack
    ):
        return True
    return attempt_plans(
        operation, limits, known, timing, coefficients, offsets, states, cells, lead, work, stack
    )


def is_served(elapsed: float, operation: 'float[:,:]') -> bool:
    """Whether the present plan is what the aim asks for, or it is not yet time to try again."""
    progress = operation[Operation.PROGRESS, :]
    if not is_aim(Operation.TAKEN, operation):
        return False
    if progress[Progress.ATTEMPT] == Attempt.FULL:
        return holds_long_enough(elapsed, operation)
    if progress[Progress.NEXT] > 0.0 or is_due(operation):
        return False
    return not is_prolonged(operation) or holds_long_enough(elapsed, operation)


def is_in_vain(operation: 'float[:,:]', timing: 'float[:,:,:]', offsets: 'int[:]') -> bool:
    """Whether all plans for the aim have been tried from where the load still rests."""
    progress = operation[Operation.PROGRESS, :]
    if not is_aim(Operation.TAKEN, operation) or progress[Progress.NEXT] > 0.0:
        return False
    if progress[Progress.ATTEMPT] != Attempt.NONE:
        return False
    # how long a velocity is held depends on the step
    if progress[Progress.RESTED] != operation[Operation.COMMAND, Command.STEP]:
        return False
    return has_ended(operation, timing, offsets)


def is_due(operation: 'float[:,:]') -> bool:
    """Whether it is time to try a command again that was not taken as it is."""
    retry = operation[Operation.PROGRESS, Progress.RETRY]
    return not operation[Operation.COMMAND, Command.TIME] < retry


def renews(elapsed: float, operation: 'float[:,:]') -> bool:
    """Whether velocities are to be held longer before anything else is tried."""
    if not is_prolonged(operation) or holds_long_enough(elapsed, operation):
        return False
    return operation[Operation.PROGRESS, Progress.ATTEMPT] == Attempt.FULL or not is_due(operation)


def begin_swing(operation: 'float[:,:]') -> None:
    """Note that the present motion is an emergency stop, which holds nothing and is for no aim."""
    progress = operation[Operation.PROGRESS, :]
    for axis in range(3):
        for i in range(HeldVelocity.SIZE):
            operation[Operation.HELD + axis, i] = 0.0
    progress[Progress.PLANS] = progress[Progress.PLANS] + 1.0
    progress[Progress.STATUS] = OperationStatus.TAKEN
    progress[Progress.ATTEMPT] = 0.0
    progress[Progress.NEXT] = 0.0
    progress[Progress.RETRY] = operation[Operation.COMMAND, Command.TIME]
    progress[Progress.MODE] = OperationMode.EMERGENCY
    operation[Operation.SWING, Swing.CALM] = operation[Operation.COMMAND, Command.TIME]
    operation[Operation.TAKEN, Aim.IS_TARGET] = -1.0
