"""Velocities that are held behind leads, until a time, and the stops behind them."""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.aim import standstill
from segfmu.kernels.operation.plans import has_room, plan_pieces
from segfmu.kernels.operation.records import (
    Command,
    HeldVelocity,
    Operation,
    OperationRows,
    Slot,
    Way,
)
from segfmu.kernels.settling.records import LeadEnd
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.pieces import clear_piece
from segfmu.kernels.trajectory.records import Piece, Timing


def way_left(velocity: float, rest: float, way: 'float[:]') -> float:
    """Way [m] from where an axis stops [m] to the end of its `Way` in the direction of a velocity.
    """
    if velocity > 0.0:
        return way[Way.HIGH] - rest
    if velocity < 0.0:
        return rest - way[Way.LOW]
    return NEVER


def room_left(axis: int, operation: 'float[:,:]') -> float:
    """The same of a plan that does not hold its velocity."""
    return way_left(
        operation[Operation.LEAD_ENDS + axis, LeadEnd.VELOCITY],
        operation[Operation.STOP_ENDS + axis, LeadEnd.POSITION],
        operation[Operation.TRIED_WAYS + axis, :],
    )


def usual_hold(operation: 'float[:,:]') -> float:
    """Until when a velocity is held at least [s], so that the next command finds it held."""
    return operation[Operation.COMMAND, Command.STEP] + operation[Operation.COMMAND, Command.HOLD]


def hold_shares(until: float, operation: 'float[:,:]') -> None:
    """Let each axis hold its share of the velocity until a time [s] at most: the rows TRIED."""
    for axis in range(3):
        held = operation[Operation.TRIED + axis, :]
        velocity = operation[Operation.WISH, axis] * operation[Operation.SHARE, axis]
        delay = operation[Operation.LEAD_ENDS + axis, LeadEnd.DELAY]
        held[HeldVelocity.VELOCITY] = velocity
        held[HeldVelocity.UNTIL] = delay
        held[HeldVelocity.FREE] = 0.0
        if abs(velocity) > 0.0:
            room = max(room_left(axis, operation), 0.0)
            hold = max(until - delay, 0.0)
            # in this order, as the room of what hardly moves has no end
            if hold * abs(velocity) < room:
                held[HeldVelocity.FREE] = 1.0
            else:
                hold = room / abs(velocity)
            held[HeldVelocity.UNTIL] = delay + hold


def join_held(
    operation: 'float[:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]',
) -> bool:
    """Join leads, held velocities and stops in the slot TRIED; False for too many pieces."""
    rows = plan_pieces(Slot.LEADS, offsets) + plan_pieces(Slot.BEHIND, offsets) + 3
    if rows > OperationRows.KEPT:
        return False
    tried = Slot.TRIED * Slot.OFFSETS
    target = 0
    for axis in range(3):
        offsets[tried + axis] = target
        reached = operation[Operation.LEAD_ENDS + axis, :]
        held = operation[Operation.TRIED + axis, :]
        hold = held[HeldVelocity.UNTIL] - reached[LeadEnd.DELAY]
        leads = Slot.LEADS * Slot.OFFSETS + axis
        for row in range(offsets[leads], offsets[leads + 1]):
            copy_piece(
                timing[Slot.LEADS, :, :], coefficients[Slot.LEADS, :, :], row,
                timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :], target,
            )
            target = target + 1
        clear_piece(coefficients[Slot.TRIED, :, :], target)
        coefficients[Slot.TRIED, target, Piece.POSITION] = reached[LeadEnd.POSITION]
        coefficients[Slot.TRIED, target, Piece.VELOCITY] = reached[LeadEnd.VELOCITY]
        timing[Slot.TRIED, target, Timing.START] = reached[LeadEnd.DELAY]
        timing[Slot.TRIED, target, Timing.LENGTH] = hold
        target = target + 1
        behind = Slot.BEHIND * Slot.OFFSETS + axis
        held[HeldVelocity.BEHIND] = offsets[behind + 1] - offsets[behind]
        way = reached[LeadEnd.VELOCITY] * hold
        for row in range(offsets[behind], offsets[behind + 1]):
            copy_piece(
                timing[Slot.BEHIND, :, :], coefficients[Slot.BEHIND, :, :], row,
                timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :], target,
            )
            shift_row(target, held[HeldVelocity.UNTIL], way, timing, coefficients)
            target = target + 1
    offsets[tried + Slot.AXES] = target
    return True


def shift_row(
    row: int, later: float, way: float, timing: 'float[:,:,:]', coefficients: 'float[:,:,:]'
) -> None:
    """Shift a piece of the plan in TRIED by a time [s] and a way [m]."""
    timing[Slot.TRIED, row, Timing.START] = timing[Slot.TRIED, row, Timing.START] + later
    coefficients[Slot.TRIED, row, Piece.POSITION] = (
        coefficients[Slot.TRIED, row, Piece.POSITION] + way
    )


def holds_long_enough(elapsed: float, operation: 'float[:,:]') -> bool:
    """Whether no axis stops before the next command but one whose way ends; s since the start."""
    command = operation[Operation.COMMAND, :]
    # a little more than what `next_operation` waits for, whatever the clock rounds
    until = elapsed + command[Command.STEP] + 0.501 * command[Command.HOLD]
    for axis in range(3):
        held = operation[Operation.HELD + axis, :]
        if held[HeldVelocity.FREE] > 0.5 and held[HeldVelocity.UNTIL] < until:
            return False
    return True


def prolong_holds(
    elapsed: float, operation: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]',
) -> bool:
    """Try to hold velocities longer: the rest of the present plan, with later stops, in TRIED.

    False if an axis has begun to stop.
    """
    until = usual_hold(operation)
    if not has_room(Slot.TRIED, offsets):
        return False
    for axis in range(3):
        held = operation[Operation.TRIED + axis, :]
        for i in range(HeldVelocity.SIZE):
            held[i] = operation[Operation.HELD + axis, i]
        for i in range(Way.SIZE):
            operation[Operation.TRIED_WAYS + axis, i] = operation[Operation.WAYS + axis, i]
        before = held[HeldVelocity.UNTIL] - elapsed
        held[HeldVelocity.UNTIL] = before
        if held[HeldVelocity.FREE] > 0.5:
            if before <= 0.0:
                return False
            velocity = held[HeldVelocity.VELOCITY]
            last = offsets[Slot.TRIED * Slot.OFFSETS + axis + 1]
            first = last - int(held[HeldVelocity.BEHIND])
            rest = standstill(Slot.TRIED, axis, timing, coefficients, offsets)
            way = operation[Operation.TRIED_WAYS + axis, :]
            longest = max(way_left(velocity, rest, way), 0.0) / abs(velocity)
            longer = max(until - before, 0.0)
            if longest <= longer:
                longer = longest
                held[HeldVelocity.FREE] = 0.0
            timing[Slot.TRIED, first - 1, Timing.LENGTH] = (
                timing[Slot.TRIED, first - 1, Timing.LENGTH] + longer
            )
            held[HeldVelocity.UNTIL] = before + longer
            for row in range(first, last):
                shift_row(row, longer, velocity * longer, timing, coefficients)
    return True
