"""Plans to a target at rest, by the planner behind leads."""

from segfmu.kernels.operation.aim import limited_velocity
from segfmu.kernels.operation.attempts import set_lower_of
from segfmu.kernels.operation.plans import has_room
from segfmu.kernels.operation.records import (
    Aim,
    HeldVelocity,
    Known,
    Operation,
    OperationWork,
    Slot,
    Way,
)
from segfmu.kernels.operation.velocity import lead_between, reach_velocities, set_motion
from segfmu.kernels.planner.plan import plan_phases
from segfmu.kernels.planner.records import (
    DelayedState,
    Lower,
    PlanOptions,
    PlanStatus,
    WaypointState,
)
from segfmu.kernels.settling.onward import join_behind, lead_to_plan
from segfmu.kernels.settling.records import LeadTask, LeadWork


def set_ends(operation: 'float[:,:]', states: 'float[:,:,:]') -> None:
    """Begin where leads end."""
    for axis in range(3):
        for i in range(states.shape[2]):
            states[0, axis, i] = 0.0
        for i in range(DelayedState.SIZE):
            states[0, axis, i] = operation[Operation.LEAD_ENDS + axis, i]
    set_place(operation, states)


def set_place(operation: 'float[:,:]', states: 'float[:,:,:]') -> None:
    """Set the target of AIM, at rest."""
    for axis in range(3):
        for i in range(states.shape[2]):
            states[1, axis, i] = 0.0
        states[1, axis, WaypointState.POSITION] = operation[Operation.AIM, Aim.VALUE + axis]


def set_options(known: 'float[:,:]', lead: 'float[:,:]', work: 'float[:,:]') -> None:
    """A target is reached as soon as possible."""
    for i in range(PlanOptions.SIZE):
        lead[LeadWork.OPTIONS, i] = known[Known.OPTIONS, i]
    lead[LeadWork.OPTIONS, PlanOptions.SAMPLE_TIME] = 0.0
    lead[LeadWork.OPTIONS, PlanOptions.DURATION] = 0.0
    for i in range(2):
        work[OperationWork.DWELLS, i] = 0.0


def seek_target(
    operation: 'float[:,:]', limits: 'float[:,:,:]', known: 'float[:,:]',
    timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]',
    states: 'float[:,:,:]', cells: 'float[:,:,:]', lead: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """Try a plan to the target AIM in the slot TRIED; False if there is none.

    limits as those of `operate`. A load that is faster than they permit slows down to them first,
    or farther, so that it can stop before the target: else it would have to come back.
    """
    set_options(known, lead, work)
    found = False
    if is_too_fast(operation, limits):
        set_lower_of(0, operation, limits, known)
        end_ways_at_target(operation)
        found = reach_velocities(
            False, operation, limits[0, :, :], timing, coefficients, offsets, states, lead
        )
        set_lower_of(1, operation, limits, known)
    else:
        found = lead_to_target(
            operation, limits[1, :, :], timing, coefficients, offsets, states, lead
        )
    if not found:
        return False
    set_ends(operation, states)
    found = plan_target(
        limits[1, :, :], operation[Operation.LOWER:Operation.LEAD_ENDS, :], timing, coefficients,
        offsets, states, cells, lead, work,
    )
    if not found or not has_room(Slot.TRIED, offsets):
        return False
    for axis in range(3):
        for i in range(HeldVelocity.SIZE):
            operation[Operation.TRIED + axis, i] = 0.0
    return True


def is_too_fast(operation: 'float[:,:]', limits: 'float[:,:,:]') -> bool:
    """Whether an axis is faster than its limits, or will be; WISH becomes velocities within them.

    limits as those of `operate`.
    """
    faster = False
    for axis in range(3):
        velocity = coming_velocity(axis, operation, limits[0, :, :])
        slowed = limited_velocity(
            velocity, 1.0, limits[1, axis, 0], operation[Operation.LOWER + axis, Lower.VELOCITY]
        )
        operation[Operation.WISH, axis] = slowed
        operation[Operation.SHARE, axis] = 1.0
        if abs(velocity - slowed) > 1e-9 * limits[1, axis, 0]:
            faster = True
    return faster


def coming_velocity(axis: int, operation: 'float[:,:]', limits: 'float[:,:]') -> float:
    """The velocity of an axis [m/s] after its acceleration, if that raises it, has been left."""
    now = operation[Operation.NOW + axis, :]
    velocity = now[WaypointState.VELOCITY]
    acceleration = now[WaypointState.ACCELERATION]
    if velocity * acceleration <= 0.0:
        return velocity
    # jerk, and where it is limited snap, take their time
    time = 0.0
    before = abs(acceleration)
    for order in range(2, min(limits.shape[1], 4)):
        if limits[axis, order] > 0.0:
            time = time + before / limits[axis, order]
            before = limits[axis, order]
    return velocity + 0.5 * acceleration * time


def end_ways_at_target(operation: 'float[:,:]') -> None:
    """Let ways to be tried end at the target of AIM, whatever their direction."""
    for axis in range(3):
        for i in range(Way.SIZE):
            operation[Operation.TRIED_WAYS + axis, i] = operation[Operation.AIM, Aim.VALUE + axis]


def lead_to_target(
    operation: 'float[:,:]', limits: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
) -> bool:
    """Find leads to where the planner takes over."""
    set_motion(operation, states)
    set_place(operation, states)
    lead_to_plan(lead)
    lead[LeadWork.TASK, LeadTask.BRAKES] = 1.0
    return lead_between(
        Slot.REST, Slot.LEADS, operation[Operation.LEAD_ENDS:Operation.STOP_ENDS, :], limits,
        operation[Operation.LOWER:Operation.LEAD_ENDS, :], timing, coefficients, offsets, states,
        lead,
    )


def plan_target(
    limits: 'float[:,:]', lower: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]',
    cells: 'float[:,:,:]', lead: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """Plan from the ends of leads to the target in `states`, and join both in the slot TRIED."""
    dwells = work[OperationWork.DWELLS, :]
    axes = work[OperationWork.AXES:OperationWork.PIECE, :]
    status = plan_phases(
        states, dwells, limits, lower, lead[LeadWork.OPTIONS, :], axes, cells,
        lead[LeadWork.PLAN:LeadWork.EXPANSION, :],
    )
    if status < PlanStatus.PLANNED:
        return False
    # the slots REST to TRIED are in the order of `PlanPart`
    first = Slot.REST * Slot.OFFSETS
    last = Slot.NONE * Slot.OFFSETS
    return join_behind(
        states, dwells, axes, cells, timing[Slot.REST:Slot.NONE, :, :],
        coefficients[Slot.REST:Slot.NONE, :, :], offsets[first:last],
        work[OperationWork.TIMES:OperationWork.DWELLS, :], lead,
    )
