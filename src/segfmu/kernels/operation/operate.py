"""One step of an operated motion: a command -> a plan up to standstill, or the old one goes on.

Every plan that is taken begins in the state of the one before, all continuous derivatives included,
and is proved to keep the limits, the rope, the space and the bounds of the drives until it rests.
Nothing else is ever followed. Work spaces are cleared before they are used, so that the same
commands give the same plans after a state was restored.
"""

from segfmu.kernels.operation.aim import is_aim, wanted_mode, write_aim
from segfmu.kernels.operation.attempts import (
    first_stop,
    is_worth,
    most_attempts,
    set_attempt,
    share_of,
)
from segfmu.kernels.operation.emergency import begin_emergency, prolong_swing
from segfmu.kernels.operation.held import holds_long_enough, prolong_holds
from segfmu.kernels.operation.measured import takes_measured
from segfmu.kernels.operation.plans import copy_plan, note_present
from segfmu.kernels.operation.proof import prove_plan
from segfmu.kernels.operation.records import (
    Aim,
    Command,
    HeldVelocity,
    Operation,
    OperationMode,
    OperationStatus,
    Progress,
    Slot,
    Swing,
)
from segfmu.kernels.operation.takeover import calm_on, is_calming, take_over, wants_calm
from segfmu.kernels.operation.target import seek_target
from segfmu.kernels.operation.tripping import brake_anew, trips
from segfmu.kernels.operation.velocity import seek_velocity


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
    taken = is_aim(Operation.TAKEN, operation)
    if not is_aim(Operation.BEFORE, operation):
        progress[Progress.NEXT] = 0.0
    if taken and progress[Progress.ATTEMPT] == 0.0:
        if holds_long_enough(elapsed, operation):
            return False
    elif taken and command[Command.TIME] < progress[Progress.RETRY]:
        if progress[Progress.NEXT] == 0.0:
            return False
    note_present(elapsed, operation, timing, coefficients, offsets)
    if taken and progress[Progress.ATTEMPT] == 0.0 and progress[Progress.NEXT] == 0.0:
        copy_plan(Slot.REST, Slot.TRIED, timing, coefficients, offsets)
        if prolong_holds(elapsed, operation, known, timing, coefficients, offsets):
            progress[Progress.ATTEMPTS] = progress[Progress.ATTEMPTS] + 1.0
            status = prove_plan(
                operation, limits[0, :, :], known, timing, coefficients, offsets, states, lead,
                work, stack,
            )
            if status == OperationStatus.TAKEN:
                take_plan(0, operation, timing, coefficients, offsets)
                return True
            progress[Progress.REFUSED] = status
    return attempt_plans(
        operation, limits, known, timing, coefficients, offsets, states, cells, lead, work, stack
    )


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


def attempt_plans(
    operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', cells: 'float[:,:,:]',
    lead: 'float[:,:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> bool:
    """Try plans for the aim in turn, until one is taken; as `operate`."""
    progress = operation[Operation.PROGRESS, :]
    aim = operation[Operation.AIM, :]
    first = int(progress[Progress.NEXT])
    failed = int(OperationStatus.TAKEN)
    if first > 0:
        failed = int(progress[Progress.FAILED])
    tries = 0
    progress[Progress.NEXT] = 0.0
    for attempt in range(first, most_attempts()):
        if not is_worth(attempt, failed, aim) or keeps_stopping(attempt, operation):
            continue
        if tries > 0 and not tries < operation[Operation.COMMAND, Command.TRIES]:
            progress[Progress.NEXT] = attempt
            progress[Progress.FAILED] = failed
            progress[Progress.STATUS] = OperationStatus.PENDING
            return False
        tries = tries + 1
        progress[Progress.ATTEMPTS] = progress[Progress.ATTEMPTS] + 1.0
        set_attempt(attempt, operation, limits, known)
        found = False
        if aim[Aim.IS_TARGET] > 0.5 and attempt < first_stop():
            found = seek_target(
                operation, limits, known, timing, coefficients, offsets, states, cells, lead, work
            )
        else:
            for axis in range(3):
                operation[Operation.WISH, axis] = aim[Aim.VALUE + axis]
                operation[Operation.SHARE, axis] = share_of(attempt, axis)
            found = seek_velocity(
                operation, limits[1, :, :], known, timing, coefficients, offsets, states, lead
            )
        status = int(OperationStatus.LIMITS)
        if found:
            status = prove_plan(
                operation, limits[0, :, :], known, timing, coefficients, offsets, states, lead,
                work, stack,
            )
        if status == OperationStatus.TAKEN:
            take_plan(rank(attempt, aim), operation, timing, coefficients, offsets)
            return True
        if failed == OperationStatus.TAKEN:
            # why the command cannot be taken as it is
            progress[Progress.REFUSED] = status
        failed = status
    if failed > 0:
        progress[Progress.STATUS] = progress[Progress.REFUSED]
    note_taken(most_attempts(), operation)
    return False


def rank(attempt: int, aim: 'float[:]') -> int:
    """Number of an attempt, 0 where it is all that the aim (Aim) asks for."""
    if attempt <= 2 or is_stop(aim):
        return 0
    return attempt


def is_stop(aim: 'float[:]') -> bool:
    """Whether an aim (Aim) is to rest."""
    fastest = 0.0
    for axis in range(3):
        fastest = max(fastest, abs(aim[Aim.VALUE + axis]))
    return aim[Aim.IS_TARGET] < 0.5 and fastest == 0.0


def keeps_stopping(attempt: int, operation: 'float[:,:]') -> bool:
    """Whether an attempt is a stop, and the present plan is one already."""
    if attempt < first_stop():
        return False
    stopping = operation[Operation.PROGRESS, Progress.ATTEMPT]
    # after all have failed, the present plan is for something else
    if first_stop() <= stopping < most_attempts():
        return is_aim(Operation.TAKEN, operation)
    return False


def take_plan(
    attempt: int, operation: 'float[:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]',
) -> None:
    """Follow the plan in the slot TRIED from now on."""
    progress = operation[Operation.PROGRESS, :]
    copy_plan(Slot.TRIED, Slot.PRESENT, timing, coefficients, offsets)
    for axis in range(3):
        for i in range(HeldVelocity.SIZE):
            operation[Operation.HELD + axis, i] = operation[Operation.TRIED + axis, i]
    progress[Progress.BEGIN] = operation[Operation.COMMAND, Command.TIME]
    progress[Progress.PLANS] = progress[Progress.PLANS] + 1.0
    progress[Progress.STATUS] = OperationStatus.TAKEN
    if attempt > 0:
        progress[Progress.STATUS] = OperationStatus.REDUCED
    note_taken(attempt, operation)


def note_taken(attempt: int, operation: 'float[:,:]') -> None:
    """Note for what the present plan is, and when to try again if it is not all that."""
    command = operation[Operation.COMMAND, :]
    for i in range(Aim.SIZE):
        operation[Operation.TAKEN, i] = operation[Operation.AIM, i]
    operation[Operation.PROGRESS, Progress.ATTEMPT] = attempt
    retry = command[Command.TIME]
    if not is_stop(operation[Operation.AIM, :]):
        retry = retry + 0.5 * command[Command.HOLD]
    operation[Operation.PROGRESS, Progress.RETRY] = retry
