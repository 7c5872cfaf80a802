"""Emergency stops: the carriages stop as fast as their drives can, and the load swings on.

Each carriage brakes at the bound of its drive's acceleration. Where forces or powers of the drives,
or the pull of the rope, do not allow that, all brake with the same share of it. A drive that has
tripped is stopped by its brake instead, whose force has no bound.
"""

from segfmu.kernels.crane._crane import crane_flat_inverse
from segfmu.kernels.crane.records import Demand, Masses, State
from segfmu.kernels.crane.uses import bound_magnitude
from segfmu.kernels.operation.plans import note_present
from segfmu.kernels.operation.records import (
    Command,
    DriveBrakes,
    FlatOrder,
    Known,
    Operation,
    OperationStatus,
    OperationWork,
    Progress,
    Swing,
    SwingTerms,
)
from segfmu.kernels.operation.swing import (
    advance_swing,
    expand_swing,
    move_swing,
    resolved_step,
    stand_time,
    sway_amplitude,
    swing_step,
    write_swing,
)


def plan_emergency(
    operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Write the emergency stop from the state NOW to SWING, with the sway that it leaves.

    False if a drive has no bound of its acceleration, or if no share of it keeps the other bounds.
    """
    note_swing(operation, known, work)
    note_trips(operation)
    return plan_brakes(operation, known, work)


def note_trips(operation: 'float[:,:]') -> None:
    """Note in SWING which drives have tripped."""
    for drive in range(3):
        operation[Operation.SWING, Swing.TRIPPED + drive] = operation[
            Operation.COMMAND, Command.TRIPPED + drive
        ]


def plan_brakes(operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]') -> bool:
    """The same from the state in SWING."""
    for drive in range(3):
        if not least_brake(drive, operation[Operation.SWING, :], known) > 0.0:
            return False
    if brakes_with(1.0, operation, known, work):
        return True
    kept = 0.0
    missed = 1.0
    for _ in range(12):
        middle = 0.5 * (kept + missed)
        if brakes_with(middle, operation, known, work):
            kept = middle
        else:
            missed = middle
    return kept > 0.0 and brakes_with(kept, operation, known, work)


def note_swing(operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]') -> None:
    """Note carriages and rope of the state NOW in SWING."""
    flat = work[OperationWork.FLAT:OperationWork.FORCE, :]
    swing = operation[Operation.SWING, :]
    for axis in range(3):
        for order in range(FlatOrder.COUNT):
            flat[order, axis] = operation[Operation.NOW + axis, order]
    invert_flat(known, work)
    state = work[OperationWork.STATE, :]
    for axis in range(3):
        swing[Swing.POSITION + axis] = state[State.POSITION + axis]
        swing[Swing.VELOCITY + axis] = state[State.VELOCITY + axis]
        swing[Swing.PATH + axis] = flat[FlatOrder.POSITION, axis]
        swing[Swing.RATE + axis] = flat[FlatOrder.VELOCITY, axis]
        if axis < 2:
            swing[Swing.PATH + axis] = swing[Swing.PATH + axis] - swing[Swing.POSITION + axis]
            swing[Swing.RATE + axis] = swing[Swing.RATE + axis] - swing[Swing.VELOCITY + axis]


def invert_flat(known: 'float[:,:]', work: 'float[:,:]') -> None:
    """Write forces and state of the crane that belong to FLAT."""
    crane_flat_inverse(
        work[OperationWork.FLAT:OperationWork.FORCE, :], known[Known.CRANE, :],
        work[OperationWork.FORCE, :], work[OperationWork.STATE, :],
        work[OperationWork.ACCELERATION, :],
    )


def brakes_with(
    share: float, operation: 'float[:,:]', known: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Whether a share of the accelerations keeps the other bounds; writes it to SWING."""
    gravity = known[Known.CRANE, Masses.GRAVITY]
    swing = operation[Operation.SWING, :]
    ahead = operation[Operation.AHEAD, :]
    set_brakes(share, swing, known)
    for i in range(Swing.SIZE):
        ahead[i] = swing[i]
    stand = stand_time(swing)
    if not stand < 1e9 * resolved_step(gravity, swing):
        return False
    swing[Swing.STAND] = stand
    # forces of the drives hold the carriages for a swing afterwards
    pieces = 0
    swings = 0
    while stand_time(ahead) > 0.0 or swings < SwingTerms.SWING:
        if stand_time(ahead) == 0.0:
            if swings == 0:
                swing[Swing.SWAY] = sway_amplitude(gravity, ahead)
            swings = swings + 1
        expand_swing(gravity, ahead, work)
        if not is_bearable(ahead, known, work):
            return False
        move_swing(swing_step(2.0 * resolved_step(gravity, ahead), ahead), ahead, work)
        pieces = pieces + 1
        if pieces > SwingTerms.LONGEST:
            return False
    return True


def set_brakes(share: float, swing: 'float[:]', known: 'float[:,:]') -> None:
    """Let each carriage brake with a share of its drive's acceleration, until it rests."""
    for axis in range(3):
        velocity = swing[Swing.VELOCITY + axis]
        swing[Swing.ACCELERATION + axis] = 0.0
        swing[Swing.JERK + axis] = 0.0
        swing[Swing.SNAP + axis] = 0.0
        swing[Swing.LEFT + axis] = 0.0
        if abs(velocity) > 0.0:
            side = 0
            if velocity > 0.0:
                side = 1
            most = brake_of(axis, side, share, swing, known)
            swing[Swing.LEFT + axis] = abs(velocity) / most
            swing[Swing.ACCELERATION + axis] = (1.0 - 2.0 * side) * most


def brake_of(
    drive: int, side: int, share: float, swing: 'float[:]', known: 'float[:,:]'
) -> float:
    """Deceleration [m/s2] of a drive towards a side, with a share of its bound, or of its brake."""
    most = bound_magnitude(Demand.ACCELERATION + drive, side, known[Known.BOUNDS, :])
    if swing[Swing.TRIPPED + drive] > 0.5:
        own = known[Known.BRAKES, DriveBrakes.DECELERATION + drive]
        if own > 0.0:
            return own
        return most
    return share * most


def least_brake(drive: int, swing: 'float[:]', known: 'float[:,:]') -> float:
    """The least deceleration of a drive [m/s2]; 0 if it has no bound."""
    return min(brake_of(drive, 0, 1.0, swing, known), brake_of(drive, 1, 1.0, swing, known))


def is_bearable(swing: 'float[:]', known: 'float[:,:]', work: 'float[:,:]') -> bool:
    """Whether the rope pulls, and forces and powers keep their bounds, in an expanded state."""
    if not work[OperationWork.PULL, SwingTerms.CONSTANT] > 0.0:
        return False
    # the rope hangs below its suspension
    if not swing[Swing.PATH + 2] < 0.0:
        return False
    flat = work[OperationWork.FLAT:OperationWork.FORCE, :]
    for axis in range(3):
        factorial = 1.0
        for order in range(FlatOrder.COUNT):
            factorial = factorial * max(order, 1)
            flat[order, axis] = factorial * work[OperationWork.PATH + axis, order]
        if axis < 2:
            flat[FlatOrder.POSITION, axis] = (
                flat[FlatOrder.POSITION, axis] + swing[Swing.POSITION + axis]
            )
            flat[FlatOrder.VELOCITY, axis] = (
                flat[FlatOrder.VELOCITY, axis] + swing[Swing.VELOCITY + axis]
            )
            flat[FlatOrder.ACCELERATION, axis] = (
                flat[FlatOrder.ACCELERATION, axis] + swing[Swing.ACCELERATION + axis]
            )
    invert_flat(known, work)
    for drive in range(3):
        if swing[Swing.TRIPPED + drive] > 0.5:
            continue
        force = work[OperationWork.FORCE, drive]
        power = force * swing[Swing.VELOCITY + drive]
        if not is_inside(force, Demand.FORCE + drive, known):
            return False
        if not is_inside(power, Demand.POWER + drive, known):
            return False
    return True


def is_inside(value: float, demand: int, known: 'float[:,:]') -> bool:
    """Whether a demand is inside its bound, with a thousandth for the time between two looks."""
    side = 0
    if value < 0.0:
        side = 1
    bound = bound_magnitude(demand, side, known[Known.BOUNDS, :])
    return bound == 0.0 or abs(value) <= 0.999 * bound


def begin_emergency(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> bool:
    """Stop from the state NOW; False where that cannot be, and where all rests already."""
    gravity = known[Known.CRANE, Masses.GRAVITY]
    swing = operation[Operation.SWING, :]
    if not plan_emergency(operation, known, work):
        operation[Operation.PROGRESS, Progress.REFUSED] = OperationStatus.DRIVES
        return False
    # a load that rests needs no motion
    if swing[Swing.STAND] == 0.0 and swing[Swing.SWAY] < 1e-9:
        return False
    # in steps that are longer the pieces are not exact enough
    if covered_time(operation) > 6.0 * SwingTerms.PIECES * resolved_step(gravity, swing):
        return False
    swing[Swing.ACTIVE] = 1.0
    cover_swing(operation, known, timing, coefficients, offsets, work)
    return True


def covered_time(operation: 'float[:,:]') -> float:
    """For how long [s] the motion has to be known."""
    command = operation[Operation.COMMAND, :]
    return command[Command.STEP] + command[Command.HOLD]


def cover_swing(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> None:
    """Write the motion from now on into the slot PRESENT."""
    write_swing(
        covered_time(operation), operation, known, timing, coefficients, offsets, work
    )
    operation[Operation.PROGRESS, Progress.BEGIN] = operation[Operation.COMMAND, Command.TIME]


def prolong_swing(
    elapsed: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> bool:
    """Write more of the motion where needed; whether it was. elapsed: since its start [s]."""
    command = operation[Operation.COMMAND, :]
    swing = operation[Operation.SWING, :]
    # a little more than what `next_operation` waits for, whatever the clock rounds
    if elapsed + command[Command.STEP] + 0.501 * command[Command.HOLD] < swing[Swing.COVERED]:
        return False
    advance_swing(elapsed, known[Known.CRANE, Masses.GRAVITY], swing, work)
    cover_swing(operation, known, timing, coefficients, offsets, work)
    return True


def foresee_emergency(
    operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', work: 'float[:,:]',
) -> bool:
    """Write to SWING what an emergency stop would be at the command's time; False: it cannot be.

    STAND is the time until the carriages rest [s], SWAY the load's sway from then on [rad]. After
    one has begun, they are those of this one.
    """
    command = operation[Operation.COMMAND, :]
    if operation[Operation.SWING, Swing.ACTIVE] > 0.5:
        return True
    elapsed = command[Command.TIME] - operation[Operation.PROGRESS, Progress.BEGIN]
    note_present(elapsed, operation, timing, coefficients, offsets)
    return plan_emergency(operation, known, work)
