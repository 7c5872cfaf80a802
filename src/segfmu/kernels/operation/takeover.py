"""A swing is taken over: from behind an emergency stop, and on from there to other aims.

While the load comes to rest, an aim is a target of which the scale is 1, or just to rest.
"""

from segfmu.kernels.crane.records import Masses
from segfmu.kernels.operation.aim import is_aim, wanted_mode, write_target
from segfmu.kernels.operation.calming import plan_calm
from segfmu.kernels.operation.controlled import set_knot
from segfmu.kernels.operation.emergency import cover_swing, note_swing
from segfmu.kernels.operation.plans import copy_plan, note_present, plan_end
from segfmu.kernels.operation.records import (
    Aim,
    Command,
    Control,
    HeldVelocity,
    Known,
    Operation,
    OperationMode,
    OperationStatus,
    OperationWork,
    Progress,
    Slot,
    Swing,
)
from segfmu.kernels.operation.swing import advance_swing, resolved_step, stand_time


def is_calming(operation: 'float[:,:]') -> bool:
    """Whether the load of a swing that has been taken over does not rest yet."""
    return operation[Operation.COMMAND, Command.TIME] < operation[Operation.SWING, Swing.CALM]


def note_calming(operation: 'float[:,:]') -> None:
    """Note what a command comes to until the load rests: what is asked, or just to rest."""
    progress = operation[Operation.PROGRESS, :]
    mode = wanted_mode(operation[Operation.COMMAND, :])
    progress[Progress.STATUS] = OperationStatus.REDUCED
    if mode == OperationMode.STOP or (
        mode == OperationMode.TARGET and not aims_elsewhere(operation)
    ):
        progress[Progress.STATUS] = OperationStatus.TAKEN


def wants_calm(operation: 'float[:,:]') -> bool:
    """Whether a command asks to take the swing behind an emergency stop over, now."""
    command = operation[Operation.COMMAND, :]
    mode = wanted_mode(command)
    if mode == OperationMode.EMERGENCY or mode == OperationMode.MISSION:
        return False
    return command[Command.TIME] >= next_calm(operation)


def next_calm(operation: 'float[:,:]') -> float:
    """When the swing behind an emergency stop can be taken over [s]."""
    progress = operation[Operation.PROGRESS, :]
    stands = progress[Progress.BEGIN] + stand_time(operation[Operation.SWING, :])
    return max(stands, progress[Progress.RETRY])


def write_calm_aim(operation: 'float[:,:]') -> None:
    """Write what the command comes to while the load swings."""
    command = operation[Operation.COMMAND, :]
    for i in range(Aim.SIZE):
        operation[Operation.AIM, i] = 0.0
    if int(command[Command.MODE]) == OperationMode.TARGET and command[Command.SCALE] >= 1.0:
        write_target(1.0, operation[Operation.AIM, :], command)


def aims_elsewhere(operation: 'float[:,:]') -> bool:
    """Whether the present plan, which calms the load, does not end in the AIM."""
    if operation[Operation.AIM, Aim.IS_TARGET] > 0.5:
        return not is_aim(Operation.TAKEN, operation)
    return operation[Operation.TAKEN, Aim.IS_TARGET] > 0.5


def take_over(
    elapsed: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> None:
    """Take the swing behind an emergency stop over, or let it swing on; since its start [s]."""
    advance_swing(elapsed, known[Known.CRANE, Masses.GRAVITY], operation[Operation.SWING, :], work)
    cover_swing(operation, known, timing, coefficients, offsets, work)
    write_calm_aim(operation)
    try_calm(True, operation, known, timing, coefficients, offsets, work, stack)


def calm_on(
    elapsed: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> bool:
    """Go on to rest, or to another aim from here; whether there is another plan."""
    write_calm_aim(operation)
    if not aims_elsewhere(operation):
        note_calming(operation)
        return False
    if operation[Operation.COMMAND, Command.TIME] < operation[Operation.PROGRESS, Progress.RETRY]:
        note_calming(operation)
        return False
    put_aside(operation)
    note_calm_state(elapsed, operation, known, timing, coefficients, offsets, work)
    straight = operation[Operation.TAKEN, Aim.IS_TARGET] > 0.5
    if try_calm(straight, operation, known, timing, coefficients, offsets, work, stack):
        return True
    bring_back(operation)
    note_calming(operation)
    return False


def note_calm_state(
    elapsed: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> None:
    """Note the present state of a calming motion in SWING; elapsed: since its start [s]."""
    swing = operation[Operation.SWING, :]
    ahead = operation[Operation.AHEAD, :]
    begin = operation[Operation.PROGRESS, Progress.BEGIN]
    interval = (swing[Swing.CALM] - begin) / Control.INTERVALS
    k = min(max(int(elapsed / interval), 0), Control.INTERVALS - 1)
    set_knot(k, interval, ahead, operation[Operation.SPLINE:Operation.SIZE, :])
    since = elapsed - k * interval
    note_present(elapsed, operation, timing, coefficients, offsets)
    note_swing(operation, known, work)
    for axis in range(3):
        snap = ahead[Swing.SNAP + axis]
        jerk = ahead[Swing.JERK + axis]
        swing[Swing.ACCELERATION + axis] = (
            ahead[Swing.ACCELERATION + axis] + (jerk + 0.5 * snap * since) * since
        )
        swing[Swing.JERK + axis] = jerk + snap * since


def put_aside(operation: 'float[:,:]') -> None:
    """Keep SWING while a motion from another state is tried."""
    for i in range(Swing.SIZE):
        operation[Operation.ASIDE, i] = operation[Operation.SWING, i]


def bring_back(operation: 'float[:,:]') -> None:
    """Bring back what was kept."""
    for i in range(Swing.SIZE):
        operation[Operation.SWING, i] = operation[Operation.ASIDE, i]


def try_calm(
    rests: bool, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]', coefficients:
    'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> bool:
    """Follow a plan from the state SWING to the AIM, if there is one that is proved.

    rests: if there is none to a target, just come to rest.
    """
    progress = operation[Operation.PROGRESS, :]
    aim = operation[Operation.AIM, :]
    # when the swing is another one: after a radian of its phase
    radian = 20.0 * resolved_step(known[Known.CRANE, Masses.GRAVITY], operation[Operation.SWING, :])
    retry = operation[Operation.COMMAND, Command.TIME] + radian
    progress[Progress.ATTEMPTS] = progress[Progress.ATTEMPTS] + 1.0
    status = plan_calm(operation, known, timing, coefficients, offsets, work, stack)
    if status != OperationStatus.TAKEN:
        progress[Progress.REFUSED] = status
        progress[Progress.RETRY] = retry
    if status != OperationStatus.TAKEN and aim[Aim.IS_TARGET] > 0.5 and rests:
        aim[Aim.IS_TARGET] = 0.0
        status = plan_calm(operation, known, timing, coefficients, offsets, work, stack)
    if status != OperationStatus.TAKEN:
        progress[Progress.STATUS] = status
        return False
    follow_calm(operation, timing, coefficients, offsets, work)
    return True


def follow_calm(
    operation: 'float[:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets:
    'int[:]', work: 'float[:,:]',
) -> None:
    """Follow the calming motion in the slot TRIED from now on."""
    command = operation[Operation.COMMAND, :]
    progress = operation[Operation.PROGRESS, :]
    swing = operation[Operation.SWING, :]
    copy_plan(Slot.TRIED, Slot.PRESENT, timing, coefficients, offsets)
    for axis in range(3):
        for i in range(HeldVelocity.SIZE):
            operation[Operation.HELD + axis, i] = 0.0
        for i in range(Control.POINTS):
            operation[Operation.SPLINE + axis, i] = work[OperationWork.CONTROL + axis, i]
    swing[Swing.ACTIVE] = 0.0
    swing[Swing.CALM] = command[Command.TIME] + plan_end(Slot.PRESENT, 0, timing, offsets)
    progress[Progress.BEGIN] = command[Command.TIME]
    progress[Progress.PLANS] = progress[Progress.PLANS] + 1.0
    progress[Progress.ATTEMPT] = 0.0
    progress[Progress.NEXT] = 0.0
    for i in range(Aim.SIZE):
        operation[Operation.TAKEN, i] = operation[Operation.AIM, i]
    if operation[Operation.AIM, Aim.IS_TARGET] < 0.5:
        operation[Operation.TAKEN, Aim.IS_TARGET] = -1.0
    write_calm_aim(operation)
    note_calming(operation)
