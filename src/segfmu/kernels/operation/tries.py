"""Plans that are tried for an aim in turn, until one is taken."""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.aim import is_aim
from segfmu.kernels.operation.apart import (
    choose_apart,
    goes_apart,
    goes_on,
    has_ended,
    rests_at_target,
    retry_later,
)
from segfmu.kernels.operation.attempts import (
    CALMER,
    ease_of,
    is_apart,
    is_slower,
    is_worth,
    note_ease,
    set_attempt,
    share_of,
    stop_as_before,
)
from segfmu.kernels.operation.held import holds_long_enough, prolong_holds, usual_hold
from segfmu.kernels.operation.pace import ease_within
from segfmu.kernels.operation.plans import copy_plan
from segfmu.kernels.operation.proof import prove_plan
from segfmu.kernels.operation.records import (
    Aim,
    Attempt,
    Command,
    HeldVelocity,
    Operation,
    OperationStatus,
    Progress,
    Slot,
)
from segfmu.kernels.operation.target import seek_target
from segfmu.kernels.operation.velocity import seek_velocity
from segfmu.kernels.operation.ways import (
    are_ways_kept,
    end_before_obstacle,
    keep_ways,
    open_ways,
    rests_short,
)


def is_prolonged(operation: 'float[:,:]') -> bool:
    """Whether the present plan is for the aim, and its velocities may be held longer."""
    progress = operation[Operation.PROGRESS, :]
    attempt = int(progress[Progress.ATTEMPT])
    if progress[Progress.NEXT] > 0.0 or not is_aim(Operation.TAKEN, operation):
        return False
    return attempt == Attempt.FULL or attempt == Attempt.BLOCKED


def choose_ease(
    attempt: int, status: int, operation: 'float[:,:]', limits: 'float[:,:]',
    known: 'float[:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    work: 'float[:,:]',
) -> None:
    """Choose how slow a slower attempt is after one that failed by a status.

    limits (3, n + 1): those of the one that failed.
    """
    if attempt != Attempt.FULL and not is_slower(attempt + 1):
        return
    if attempt == Attempt.APART:
        # what is in its way may not be in that of all axes at once
        if not (status == OperationStatus.DRIVES or tells_rope(attempt, status, operation, known)):
            return
        operation[Operation.PROGRESS, Progress.APART] = 1.0
    pace = 1.0
    steepness = 1.0
    speed = 1.0
    if status == OperationStatus.DRIVES or tells_rope(attempt, status, operation, known):
        first = Slot.TRIED * Slot.OFFSETS
        pace, steepness, speed = ease_within(
            limits, timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :],
            offsets[first:first + Slot.OFFSETS], known, work,
        )
    note_ease(attempt, pace, steepness, speed, operation)
    if attempt == Attempt.STOP:
        stop_as_before(operation)


def tells_rope(
    attempt: int, status: int, operation: 'float[:,:]', known: 'float[:,:]'
) -> bool:
    """Whether it is of use how slow a plan that failed by a status would have to be for the rope.

    A velocity is rather had along some axes than built up that slowly.
    """
    if not (status == OperationStatus.ROPE or status == OperationStatus.TRAVEL):
        return False
    if attempt >= Attempt.STOP:
        return True
    return operation[Operation.AIM, Aim.IS_TARGET] > 0.5 and rests_at_target(operation, known)


def keeps_blocked(operation: 'float[:,:]') -> bool:
    """Whether nothing is gained beside the present plan, which ends before the same obstacle."""
    if not is_prolonged(operation) or not are_ways_kept(operation):
        return False
    return not rests_short(operation)


def attempt_plans(
    operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', cells: 'float[:,:,:]',
    lead: 'float[:,:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> bool:
    """Try plans for the aim in turn, until one is taken; as `operate`."""
    progress = operation[Operation.PROGRESS, :]
    attempt, failed = first_attempt(operation, known, timing, offsets)
    going = goes_on(operation, timing, offsets)
    tries = 0
    while attempt < Attempt.NONE:
        if is_passed_over(attempt, failed, going, operation, known):
            attempt = attempt + 1
            continue
        if tries > 0 and not tries < operation[Operation.COMMAND, Command.TRIES]:
            put_off(attempt, failed, operation)
            return False
        tries = tries + 1
        progress[Progress.ATTEMPTS] = progress[Progress.ATTEMPTS] + 1.0
        status = int(OperationStatus.LIMITS)
        if seek_plan(
            attempt, operation, limits, known, timing, coefficients, offsets, states, cells, lead,
            work,
        ):
            status = prove_plan(
                operation, limits[0, :, :], known, timing, coefficients, offsets, states, lead,
                work, stack,
            )
        if status == OperationStatus.TAKEN:
            progress[Progress.KEPT_PACE] = ease_of(attempt, Progress.PACE, operation)
            progress[Progress.KEPT_STEEPNESS] = ease_of(attempt, Progress.STEEPNESS, operation)
            take_plan(rank(attempt, operation), operation, timing, coefficients, offsets)
            return True
        if failed == OperationStatus.TAKEN and progress[Progress.BLOCKS] == 0.0:
            # why the command cannot be taken as it is
            progress[Progress.REFUSED] = status
        choose_ease(
            attempt, status, operation, limits[1, :, :], known, timing, coefficients, offsets, work
        )
        if not (status == OperationStatus.OBSTACLE and blocks(attempt, operation, known, work)):
            failed = status
            attempt = attempt + 1
        elif keeps_blocked(operation):
            progress[Progress.STATUS] = OperationStatus.REDUCED
            note_taken(int(Attempt.BLOCKED), operation)
            if holds_until_next(operation):
                return False
            if renew_holds(
                operation, limits[0, :, :], known, timing, coefficients, offsets, states, lead,
                work, stack,
            ):
                return True
    if going:
        note_taken(int(Attempt.APART), operation)
        retry_later(operation, timing, offsets)
        return False
    if failed > 0:
        progress[Progress.STATUS] = progress[Progress.REFUSED]
    note_taken(int(Attempt.NONE), operation)
    return False


def first_attempt(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]', offsets: 'int[:]'
) -> 'tuple[int, int]':
    """The attempt to begin with, and why the one before failed: those that were put off, or none.

    A command that is new begins with open ways.
    """
    progress = operation[Operation.PROGRESS, :]
    following = int(progress[Progress.NEXT])
    progress[Progress.NEXT] = 0.0
    if following > 0:
        return following - 1, int(progress[Progress.FAILED])
    open_ways(operation, known)
    progress[Progress.RESTED] = -1.0
    if has_ended(operation, timing, offsets):
        progress[Progress.RESTED] = operation[Operation.COMMAND, Command.STEP]
    progress[Progress.BLOCKS] = 0.0
    progress[Progress.SPEED] = 1.0
    progress[Progress.APART] = 0.0
    return int(Attempt.FULL), int(OperationStatus.TAKEN)


def is_passed_over(
    attempt: int, failed: int, going: bool, operation: 'float[:,:]', known: 'float[:,:]'
) -> bool:
    """Whether an attempt is not tried, after one that failed by a status; going: `goes_on`."""
    if going and attempt > Attempt.FULL and not is_nearly_full(attempt, operation):
        return True
    if keeps_stopping(attempt, operation):
        return True
    if attempt == Attempt.APART:
        return not (tells_rope(attempt, failed, operation, known) and goes_apart(operation))
    return not is_worth(attempt, failed, operation[Operation.AIM, :])


def is_nearly_full(attempt: int, operation: 'float[:,:]') -> bool:
    """Whether an attempt is built up hardly more slowly than the limits permit."""
    if attempt >= Attempt.STOP or not is_slower(attempt):
        return False
    return operation[Operation.PROGRESS, Progress.PACE] > CALMER


def put_off(attempt: int, failed: int, operation: 'float[:,:]') -> None:
    """Let the next step begin with an attempt; failed: why the one before did.

    A command that is tried once more has a status already.
    """
    progress = operation[Operation.PROGRESS, :]
    progress[Progress.NEXT] = 1 + attempt
    progress[Progress.FAILED] = failed
    if not is_aim(Operation.TAKEN, operation):
        progress[Progress.STATUS] = OperationStatus.PENDING


def blocks(
    attempt: int, operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Whether an attempt that meets an obstacle may be tried with a way that ends before it."""
    progress = operation[Operation.PROGRESS, :]
    if attempt >= Attempt.STOP or operation[Operation.AIM, Aim.IS_TARGET] > 0.5:
        return False
    # an end for each axis
    if not progress[Progress.BLOCKS] < 3.0:
        return False
    if not end_before_obstacle(operation, known, work):
        return False
    progress[Progress.BLOCKS] = progress[Progress.BLOCKS] + 1.0
    return True


def holds_until_next(operation: 'float[:,:]') -> bool:
    """Whether the present plan holds its velocities until the next command."""
    begin = operation[Operation.PROGRESS, Progress.BEGIN]
    return holds_long_enough(operation[Operation.COMMAND, Command.TIME] - begin, operation)


def renew_holds(
    operation: 'float[:,:]', limits: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
    work: 'float[:,:]', stack: 'float[:,:,:]',
) -> bool:
    """Hold the velocities of the present plan longer, if that is proved to keep everything."""
    progress = operation[Operation.PROGRESS, :]
    elapsed = operation[Operation.COMMAND, Command.TIME] - progress[Progress.BEGIN]
    copy_plan(Slot.REST, Slot.TRIED, timing, coefficients, offsets)
    if not prolong_holds(elapsed, operation, timing, coefficients, offsets):
        return False
    progress[Progress.ATTEMPTS] = progress[Progress.ATTEMPTS] + 1.0
    status = prove_plan(
        operation, limits, known, timing, coefficients, offsets, states, lead, work, stack
    )
    if status != OperationStatus.TAKEN:
        progress[Progress.REFUSED] = status
        return False
    retry = progress[Progress.RETRY]
    take_plan(int(progress[Progress.ATTEMPT]), operation, timing, coefficients, offsets)
    # so that other plans are tried in time
    progress[Progress.RETRY] = retry
    return True


def seek_plan(
    attempt: int, operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]',
    timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    states: 'float[:,:,:]', cells: 'float[:,:,:]', lead: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """Write the plan of an attempt to the slot TRIED; False if there is none."""
    aim = operation[Operation.AIM, :]
    set_attempt(attempt, operation, limits, known)
    slow = is_slower(attempt) and attempt < Attempt.STOP
    if is_apart(attempt, operation):
        choose_apart(ease_of(attempt, Progress.SPEED, operation), operation, limits, known)
        return seek_velocity(
            slow, NEVER, operation, limits[1, :, :], timing, coefficients, offsets, states, lead
        )
    if aim[Aim.IS_TARGET] > 0.5 and attempt < Attempt.STOP:
        return seek_target(
            operation, limits, known, timing, coefficients, offsets, states, cells, lead, work
        )
    for axis in range(3):
        operation[Operation.WISH, axis] = aim[Aim.VALUE + axis]
        operation[Operation.SHARE, axis] = share_of(attempt, axis, operation)
    return seek_velocity(
        slow, usual_hold(operation), operation, limits[1, :, :], timing, coefficients, offsets,
        states, lead,
    )


def rank(attempt: int, operation: 'float[:,:]') -> int:
    """An attempt that is taken, FULL where it is all that the aim asks for."""
    if is_stop(operation[Operation.AIM, :]):
        return Attempt.FULL
    if is_apart(attempt, operation):
        return Attempt.APART
    if attempt <= Attempt.SLOWEST:
        if operation[Operation.PROGRESS, Progress.BLOCKS] > 0.0:
            return Attempt.BLOCKED
        return Attempt.FULL
    return attempt


def is_stop(aim: 'float[:]') -> bool:
    """Whether an aim (Aim) is to rest."""
    fastest = 0.0
    for axis in range(3):
        fastest = max(fastest, abs(aim[Aim.VALUE + axis]))
    return aim[Aim.IS_TARGET] < 0.5 and fastest == 0.0


def is_slowed(operation: 'float[:,:]') -> bool:
    """Whether the plan in TRIED is for a part of the velocity that the aim asks for."""
    aim = operation[Operation.AIM, :]
    if aim[Aim.IS_TARGET] > 0.5 or is_stop(aim):
        return False
    return operation[Operation.PROGRESS, Progress.SPEED] < 1.0


def keeps_stopping(attempt: int, operation: 'float[:,:]') -> bool:
    """Whether an attempt is a stop, and the present plan is one already."""
    if attempt < Attempt.STOP:
        return False
    stopping = operation[Operation.PROGRESS, Progress.ATTEMPT]
    # after all have failed, the present plan is for something else
    if Attempt.STOP <= stopping < Attempt.NONE:
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
    keep_ways(operation)
    progress[Progress.BEGIN] = operation[Operation.COMMAND, Command.TIME]
    progress[Progress.PLANS] = progress[Progress.PLANS] + 1.0
    progress[Progress.STATUS] = OperationStatus.TAKEN
    if attempt > 0 or is_slowed(operation):
        progress[Progress.STATUS] = OperationStatus.REDUCED
    note_taken(attempt, operation)
    if attempt == Attempt.APART:
        retry_later(operation, timing, offsets)


def note_taken(attempt: int, operation: 'float[:,:]') -> None:
    """Note for what the present plan is, and when to try again if it is not all that."""
    command = operation[Operation.COMMAND, :]
    for i in range(Aim.SIZE):
        operation[Operation.TAKEN, i] = operation[Operation.AIM, i]
    operation[Operation.PROGRESS, Progress.ATTEMPT] = attempt
    retry = command[Command.TIME]
    if not is_stop(operation[Operation.AIM, :]):
        # no multiple of usual steps: a clock that rounds otherwise would try at another one
        retry = retry + 0.499 * command[Command.HOLD]
    operation[Operation.PROGRESS, Progress.RETRY] = retry
