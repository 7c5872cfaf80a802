"""Plans that reach velocities, hold them, and stop.

Each axis reaches its velocity as soon as it can, holds it until a time, and comes to rest as soon
as it can, but before the end of its way. The time is so late that the next command finds the
velocity held; then it is prolonged. So whatever happens, the load stops by a plan that has been
checked.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.operation.aim import high_end, low_end, standstill
from segfmu.kernels.operation.plans import clear_plan, has_room, plan_pieces
from segfmu.kernels.operation.records import (
    Command,
    HeldVelocity,
    Operation,
    OperationRows,
    Slot,
)
from segfmu.kernels.planner.records import Shape, WaypointState
from segfmu.kernels.settling.leads import find_leads
from segfmu.kernels.settling.records import LeadEnd, LeadStage, LeadTask, LeadWork
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.pieces import clear_piece
from segfmu.kernels.trajectory.records import Piece, Timing


def clear_lead(lead: 'float[:,:]') -> None:
    """Clear the work space, so that nothing depends on what was before."""
    for row in range(lead.shape[0]):
        for i in range(lead.shape[1]):
            lead[row, i] = 0.0


def set_lead(order: int, shape: int, meeting: float, lead: 'float[:,:]') -> None:
    """Set what leads are searched for, see `LeadTask`."""
    clear_lead(lead)
    lead[LeadWork.TASK, LeadTask.ORDER] = order
    lead[LeadWork.TASK, LeadTask.MEETING] = meeting
    lead[LeadWork.TASK, LeadTask.SHAPE] = shape
    lead[LeadWork.TASK, LeadTask.BRAKES] = 1.0


def lead_between(
    source: int, slot: int, ends: 'float[:,:]', limits: 'float[:,:]', lower: 'float[:,:]',
    timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find leads between the `states` into a slot; False if an axis has none.

    They may follow the plan in the slot `source`. `set_lead` tells what they are.
    """
    first = source * Slot.OFFSETS
    place = slot * Slot.OFFSETS
    failed = find_leads(
        states, limits, lower, offsets[first:first + Slot.OFFSETS], timing[source, :, :],
        coefficients[source, :, :], ends, lead, timing[slot, :, :], coefficients[slot, :, :],
        offsets[place:place + Slot.OFFSETS],
    )
    return failed < 0


def set_motion(operation: 'float[:,:]', states: 'float[:,:,:]') -> None:
    """Begin in the present state, and leave the target free."""
    for axis in range(3):
        for i in range(states.shape[2]):
            states[0, axis, i] = operation[Operation.NOW + axis, i]
            states[1, axis, i] = 0.0


def reach_velocities(
    operation: 'float[:,:]', limits: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find leads to the share of its velocity WISH that each axis gets."""
    set_motion(operation, states)
    for axis in range(3):
        wish = operation[Operation.WISH, axis] * operation[Operation.SHARE, axis]
        states[1, axis, WaypointState.VELOCITY] = wish
    set_lead(LeadStage.VELOCITY, Shape.PLATEAU, -1.0, lead)
    return lead_between(
        Slot.REST, Slot.LEADS, operation[Operation.LEAD_ENDS:Operation.STOP_ENDS, :], limits,
        operation[Operation.LOWER:Operation.LEAD_ENDS, :], timing, coefficients, offsets, states,
        lead,
    )


def reach_and_stop(
    operation: 'float[:,:]', limits: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """The same, and stops from there, in the slot BEHIND."""
    if not reach_velocities(
        operation, limits, timing, coefficients, offsets, states, lead
    ):
        return False
    reached = operation[Operation.LEAD_ENDS:Operation.STOP_ENDS, :]
    for axis in range(3):
        for i in range(states.shape[2]):
            states[0, axis, i] = 0.0
            states[1, axis, i] = 0.0
        states[0, axis, WaypointState.POSITION] = reached[axis, LeadEnd.POSITION]
        states[0, axis, WaypointState.VELOCITY] = reached[axis, LeadEnd.VELOCITY]
    stopped = operation[Operation.STOP_ENDS:Operation.SWING, :]
    set_lead(LeadStage.VELOCITY, Shape.PLATEAU, -1.0, lead)
    clear_plan(Slot.NONE, offsets)
    return lead_between(
        Slot.NONE, Slot.BEHIND, stopped, limits,
        operation[Operation.LOWER:Operation.LEAD_ENDS, :], timing, coefficients, offsets, states,
        lead,
    )


def way_left(axis: int, velocity: float, rest: float, known: 'float[:,:]') -> float:
    """Way [m] from where an axis stops [m] to the end of its way in the direction of a velocity."""
    if velocity > 0.0:
        return high_end(axis, known) - rest
    if velocity < 0.0:
        return rest - low_end(axis, known)
    return NEVER


def room_left(axis: int, operation: 'float[:,:]', known: 'float[:,:]') -> float:
    """The same of a plan that does not hold its velocity."""
    return way_left(
        axis, operation[Operation.LEAD_ENDS + axis, LeadEnd.VELOCITY],
        operation[Operation.STOP_ENDS + axis, LeadEnd.POSITION], known,
    )


def shrink_shares(last: bool, operation: 'float[:,:]', known: 'float[:,:]') -> bool:
    """Lower the shares of axes that do not stop before the end of their way; whether there are any.

    The way to rest grows with the square of the velocity at most, and with its power 4 / 3 where
    the snap decides. An axis that is too fast the last time stops at once.
    """
    found = False
    for axis in range(3):
        left = room_left(axis, operation, known)
        if left < 0.0:
            found = True
            stopping = operation[Operation.STOP_ENDS + axis, LeadEnd.POSITION]
            way = abs(stopping - operation[Operation.NOW + axis, WaypointState.POSITION])
            share = 0.0
            if not last and way + left > 0.0:
                # what this leaves of the way, the hold uses
                ratio = (way + left) / way
                share = 0.95 * ratio ** 0.7
            operation[Operation.SHARE, axis] = share * operation[Operation.SHARE, axis]
    return found


def seek_velocity(
    operation: 'float[:,:]', limits: 'float[:,:]', known: 'float[:,:]',
    timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Try a plan for the velocities WISH in the slot TRIED; False if there is none.

    The row SHARE of `operation` tells which share of it each axis gets; it becomes less where the
    way is too short.
    """
    tries = 5
    for i in range(tries):
        if not reach_and_stop(
            operation, limits, timing, coefficients, offsets, states, lead
        ):
            return False
        if not shrink_shares(i == tries - 2, operation, known):
            break
    hold_shares(operation, known)
    return join_held(operation, timing, coefficients, offsets)


def hold_shares(operation: 'float[:,:]', known: 'float[:,:]') -> None:
    """Choose how long each axis holds its share of the velocity: the rows TRIED."""
    command = operation[Operation.COMMAND, :]
    until = command[Command.STEP] + command[Command.HOLD]
    for axis in range(3):
        held = operation[Operation.TRIED + axis, :]
        velocity = operation[Operation.WISH, axis] * operation[Operation.SHARE, axis]
        delay = operation[Operation.LEAD_ENDS + axis, LeadEnd.DELAY]
        held[HeldVelocity.VELOCITY] = velocity
        held[HeldVelocity.UNTIL] = delay
        held[HeldVelocity.FREE] = 0.0
        if abs(velocity) > 0.0:
            longest = max(room_left(axis, operation, known), 0.0) / abs(velocity)
            hold = max(until - delay, 0.0)
            if hold < longest:
                held[HeldVelocity.FREE] = 1.0
            held[HeldVelocity.UNTIL] = delay + min(hold, longest)


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
    elapsed: float, operation: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]',
) -> bool:
    """Try to hold velocities longer: the rest of the present plan, with later stops, in TRIED.

    False if an axis has begun to stop.
    """
    command = operation[Operation.COMMAND, :]
    until = command[Command.STEP] + command[Command.HOLD]
    if not has_room(Slot.TRIED, offsets):
        return False
    for axis in range(3):
        held = operation[Operation.TRIED + axis, :]
        for i in range(HeldVelocity.SIZE):
            held[i] = operation[Operation.HELD + axis, i]
        before = held[HeldVelocity.UNTIL] - elapsed
        held[HeldVelocity.UNTIL] = before
        if held[HeldVelocity.FREE] > 0.5:
            if before <= 0.0:
                return False
            velocity = held[HeldVelocity.VELOCITY]
            last = offsets[Slot.TRIED * Slot.OFFSETS + axis + 1]
            first = last - int(held[HeldVelocity.BEHIND])
            rest = standstill(Slot.TRIED, axis, timing, coefficients, offsets)
            longest = max(way_left(axis, velocity, rest, known), 0.0) / abs(velocity)
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
