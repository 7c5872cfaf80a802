"""Proof that a plan keeps all that a crane and its space ask for, up to its standstill."""

from segfmu.kernels.clearance.records import SpaceStatus
from segfmu.kernels.clearance.space import space_contact
from segfmu.kernels.crane.records import Demand
from segfmu.kernels.crane.rope import keeps_rope
from segfmu.kernels.operation.aim import standstill
from segfmu.kernels.operation.drives import keeps_demands
from segfmu.kernels.operation.plans import plan_end
from segfmu.kernels.operation.records import (
    Known,
    Operation,
    OperationStatus,
    OperationWork,
    Slot,
)
from segfmu.kernels.planner.records import WaypointState
from segfmu.kernels.settling.records import LeadWork
from segfmu.kernels.trajectory.check import check_plan


def prove_plan(
    operation: 'float[:,:]', limits: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
    work: 'float[:,:]', stack: 'float[:,:,:]',
) -> int:
    """TAKEN, or what the plan in the slot TRIED is not proved to keep (OperationStatus)."""
    if not keeps_limits(
        operation, limits, known, timing, coefficients, offsets, states, lead, work
    ):
        return OperationStatus.LIMITS
    return prove_crane(Demand.SIZE, known, timing, coefficients, offsets, work, stack)


def prove_crane(
    demands: int, known: 'float[:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]', work: 'float[:,:]', stack: 'float[:,:,:]',
) -> int:
    """The same without the limits of the load; of the demands the first ones count."""
    first = Slot.TRIED * Slot.OFFSETS
    pieces = offsets[first:first + Slot.OFFSETS]
    if not keeps_rope(
        timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :], pieces, known[Known.ROPE, :],
        work[OperationWork.ROPE:OperationWork.BOXES, :], work[OperationWork.FAULT, :],
    ):
        return OperationStatus.ROPE
    contact = space_contact(
        timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :], pieces, known[Known.SPACE, :],
        known[Known.OBSTACLES:Known.SIZE, :], work[OperationWork.BOXES:OperationWork.RANGES, :],
        work[OperationWork.ROPE:OperationWork.BOXES, :], stack,
        work[OperationWork.RANGES:OperationWork.FAULT, :], False, work[OperationWork.FAULT, :],
    )
    if contact == SpaceStatus.WORKSPACE:
        return OperationStatus.WORKSPACE
    if contact != SpaceStatus.CLEAR:
        return OperationStatus.OBSTACLE
    if not keeps_demands(
        Demand.PLACE, Demand.SWAY, timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :],
        pieces, known, work,
    ):
        return OperationStatus.TRAVEL
    if not keeps_demands(
        0, demands, timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :], pieces, known, work
    ):
        return OperationStatus.DRIVES
    return OperationStatus.TAKEN


def keeps_limits(
    operation: 'float[:,:]', limits: 'float[:,:]', known: 'float[:,:]', timing: 'float[:,:,:]',
    coefficients: 'float[:,:,:]', offsets: 'int[:]', states: 'float[:,:,:]', lead: 'float[:,:]',
    work: 'float[:,:]',
) -> bool:
    """Whether the plan in TRIED begins in the present state, keeps the limits and comes to rest."""
    first = Slot.TRIED * Slot.OFFSETS
    times = work[OperationWork.TIMES:OperationWork.DWELLS, :]
    for axis in range(3):
        for i in range(states.shape[2]):
            states[0, axis, i] = operation[Operation.NOW + axis, i]
            states[1, axis, i] = 0.0
        states[1, axis, WaypointState.POSITION] = standstill(
            Slot.TRIED, axis, timing, coefficients, offsets
        )
        times[0, axis] = 0.0
        for j in range(1, states.shape[0] + 1):
            times[j, axis] = plan_end(Slot.TRIED, axis, timing, offsets)
    # as nothing judges it once more, nearly all of the tolerance 1e-9 is used
    return check_plan(
        states, times, timing[Slot.TRIED, :, :], coefficients[Slot.TRIED, :, :],
        offsets[first:first + Slot.OFFSETS], limits, known[Known.LOWER:Known.OBSTACLES, :],
        1e-9, 0.95e-9, lead[LeadWork.CHECK:LeadWork.SIZE, :],
    ) == 0
