"""Plans that reach velocities, hold them, and stop.

Each axis reaches its velocity as soon as it can, holds it until a time, and comes to rest as soon
as it can, but before the end of its way. The time is so late that the next command finds the
velocity held; then it is prolonged. So whatever happens, the load stops by a plan that has been
checked.
"""

from segfmu.kernels.operation.held import hold_shares, join_held, room_left
from segfmu.kernels.operation.plans import clear_plan
from segfmu.kernels.operation.records import Operation, Slot
from segfmu.kernels.planner.records import Shape, WaypointState
from segfmu.kernels.settling.attempt import part_hull
from segfmu.kernels.settling.leads import find_leads
from segfmu.kernels.settling.records import LeadEnd, LeadStage, LeadTask, LeadWork
from segfmu.kernels.trajectory.records import Check, Timing

# parts of a piece in which its velocity is bounded
PARTS = 8


def lead_to_velocity(lead: 'float[:,:]') -> None:
    """Search for leads to velocities, see `LeadTask`."""
    lead[LeadWork.TASK, LeadTask.ORDER] = LeadStage.VELOCITY
    lead[LeadWork.TASK, LeadTask.MEETING] = -1.0
    lead[LeadWork.TASK, LeadTask.SHAPE] = Shape.PLATEAU
    lead[LeadWork.TASK, LeadTask.BRAKES] = 1.0


def lead_between(
    source: int, slot: int, ends: 'float[:,:]', limits: 'float[:,:]', lower: 'float[:,:]',
    timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find leads between the `states` into a slot; False if an axis has none.

    They may follow the plan in the slot `source`. The row TASK of `lead` tells what they are.
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


def lead_of(
    axis: int, source: int, slot: int, ends: 'float[:,:]', limits: 'float[:,:]',
    lower: 'float[:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find the lead of one axis into a slot, behind those of the axes before; False: none.

    It goes between the `states` of the first axis, and may follow the plan in the slot `source`.
    The row TASK of `lead` tells what it is. ends, limits and lower have the row of the axis alone.
    """
    rows = timing.shape[1]
    first = offsets[source * Slot.OFFSETS + axis]
    last = offsets[source * Slot.OFFSETS + axis + 1]
    followed = Slot.NONE * Slot.OFFSETS
    offsets[followed] = 0
    offsets[followed + 1] = last - first
    place = slot * Slot.OFFSETS + axis
    used = 0
    if axis > 0:
        used = offsets[place]
    plan_timing = timing[source, :, :]
    plan_coefficients = coefficients[source, :, :]
    slot_timing = timing[slot, :, :]
    slot_coefficients = coefficients[slot, :, :]
    failed = find_leads(
        states, limits, lower, offsets[followed:followed + 2], plan_timing[first:last, :],
        plan_coefficients[first:last, :], ends, lead, slot_timing[used:rows, :],
        slot_coefficients[used:rows, :], offsets[place:place + 2],
    )
    offsets[place] = used
    offsets[place + 1] = used + offsets[place + 1]
    return failed < 0


def reach_velocity(
    axis: int, operation: 'float[:,:]', limits: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find the lead of an axis to the share of its velocity WISH that it gets."""
    for i in range(states.shape[2]):
        states[0, 0, i] = operation[Operation.NOW + axis, i]
        states[1, 0, i] = 0.0
    wish = operation[Operation.WISH, axis] * operation[Operation.SHARE, axis]
    states[1, 0, WaypointState.VELOCITY] = wish
    reached = Operation.LEAD_ENDS + axis
    lower = Operation.LOWER + axis
    return lead_of(
        axis, Slot.REST, Slot.LEADS, operation[reached:reached + 1, :], limits[axis:axis + 1, :],
        operation[lower:lower + 1, :], timing, coefficients, offsets, states, lead,
    )


def stop_behind(
    axis: int, operation: 'float[:,:]', limits: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find the stop of an axis from where its lead ends, in the slot BEHIND."""
    reached = operation[Operation.LEAD_ENDS + axis, :]
    for i in range(states.shape[2]):
        states[0, 0, i] = 0.0
        states[1, 0, i] = 0.0
    states[0, 0, WaypointState.POSITION] = reached[LeadEnd.POSITION]
    states[0, 0, WaypointState.VELOCITY] = reached[LeadEnd.VELOCITY]
    stopped = Operation.STOP_ENDS + axis
    lower = Operation.LOWER + axis
    clear_plan(Slot.NONE, offsets)
    return lead_of(
        axis, Slot.NONE, Slot.BEHIND, operation[stopped:stopped + 1, :], limits[axis:axis + 1, :],
        operation[lower:lower + 1, :], timing, coefficients, offsets, states, lead,
    )


def shrink_share(axis: int, last: bool, operation: 'float[:,:]') -> bool:
    """Lower the share of an axis that does not stop before the end of its way; whether it is one.

    The way to rest grows with the square of the velocity at most, and with its power 4 / 3 where
    the snap decides. An axis that is too fast the last time stops at once.
    """
    left = room_left(axis, operation)
    if left >= 0.0:
        return False
    stopping = operation[Operation.STOP_ENDS + axis, LeadEnd.POSITION]
    way = abs(stopping - operation[Operation.NOW + axis, WaypointState.POSITION])
    share = 0.0
    if not last and way + left > 0.0:
        # what this leaves of the way, the hold uses
        ratio = (way + left) / way
        share = 0.95 * ratio ** 0.7
    operation[Operation.SHARE, axis] = share * operation[Operation.SHARE, axis]
    return True


def goes_back(
    axis: int, operation: 'float[:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]', lead: 'float[:,:]',
) -> bool:
    """Whether the lead of an axis moves against its velocity and that which it begins with."""
    now = operation[Operation.NOW + axis, WaypointState.VELOCITY]
    wish = operation[Operation.WISH, axis] * operation[Operation.SHARE, axis]
    if now * wish < 0.0:
        return False
    direction = now + wish
    leads = Slot.LEADS * Slot.OFFSETS + axis
    for row in range(offsets[leads], offsets[leads + 1]):
        step = timing[Slot.LEADS, row, Timing.LENGTH] / PARTS
        for part in range(PARTS):
            # the velocity is within the hull of these values
            count = part_hull(1, row, part * step, step, lead, coefficients[Slot.LEADS, :, :])
            for i in range(count):
                velocity = lead[LeadWork.CHECK + Check.HULLS, i]
                # beyond rounding
                if velocity * direction < -1e-6 * direction * direction:
                    return True
    return False


def reach_velocities(
    slow: bool, operation: 'float[:,:]', limits: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find leads to a share of the velocity WISH of each axis, and stops behind them.

    The row SHARE of `operation` tells which share of it each axis gets; it becomes less where the
    way, TRIED_WAYS, is too short. What is built up slowly must not turn back meanwhile, as it does
    where a quick acceleration can only be left slowly. False if there are none.
    """
    lead_to_velocity(lead)
    tries = 5
    for axis in range(3):
        for i in range(tries):
            if not reach_velocity(
                axis, operation, limits, timing, coefficients, offsets, states, lead
            ):
                return False
            if slow and goes_back(axis, operation, timing, coefficients, offsets, lead):
                return False
            if not stop_behind(
                axis, operation, limits, timing, coefficients, offsets, states, lead
            ):
                return False
            if not shrink_share(axis, i == tries - 2, operation):
                break
    return True


def seek_velocity(
    slow: bool, until: float, operation: 'float[:,:]', limits: 'float[:,:]',
    timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Try a plan for the velocities WISH in the slot TRIED; False if there is none.

    They are held until a time [s] at most.
    """
    if not reach_velocities(
        slow, operation, limits, timing, coefficients, offsets, states, lead
    ):
        return False
    hold_shares(until, operation)
    return join_held(operation, timing, coefficients, offsets)
