"""Leads and brakes of all axes.

Each axis settles as soon as it can. Axes that shall meet at the target do not all have to: only
those that are late make haste, so that the planner can slow the others down.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.records import DelayedState, Lower, Problem, WaypointState
from segfmu.kernels.settling.brake import find_brake
from segfmu.kernels.settling.ends import is_at_velocity, write_end
from segfmu.kernels.settling.lead import find_lead
from segfmu.kernels.settling.records import (
    Chain,
    Lead,
    LeadEnd,
    LeadRows,
    LeadStage,
    LeadTask,
    LeadWork,
)
from segfmu.kernels.trajectory.cut import copy_piece
from segfmu.kernels.trajectory.records import Brake


def clear_search(lead: 'float[:,:]') -> None:
    """Clear what a search writes before it reads, so that nothing depends on what was before."""
    for row in range(LeadWork.NOW, LeadWork.SPLINE):
        lead[row, :] = 0.0


def set_start(axis: int, start: 'float[:,:]', lower: 'float[:,:]', lead: 'float[:,:]') -> None:
    """Set the state of an axis, and its limits in the negative direction, in the work space."""
    lead[LeadWork.NOW, :] = 0.0
    for i in range(min(start.shape[1], Chain.SIZE)):
        lead[LeadWork.NOW, i] = start[axis, i]
    for i in range(Lower.SIZE):
        lead[LeadWork.LOWER, i] = lower[axis, i]


def latest_axis(ends: 'float[:,:]') -> int:
    """The axis that takes the longest time to the target, of those that make no haste; -1: none."""
    latest, longest = -1, -1.0
    for axis in range(ends.shape[0]):
        if ends[axis, LeadEnd.HASTY] == 0.0 and ends[axis, LeadEnd.TIME] > longest:
            latest = axis
            longest = ends[axis, LeadEnd.TIME]
    return latest


def take_lead(
    first: int, end: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Copy a lead from the last LeadRows.ALL rows to those from `first` on; number of its pieces.

    Written as well: where it ends (LeadEnd).
    """
    for i in range(WaypointState.SIZE):
        end[i] = lead[LeadWork.REACHED, i]
    end[LeadEnd.DELAY] = lead[LeadWork.REACHED, Chain.TIME]
    end[LeadEnd.TIME] = lead[LeadWork.BEST, Lead.TIME]
    end[LeadEnd.FOLLOWS] = 0.0
    found = timing.shape[0] - LeadRows.ALL
    count = int(lead[LeadWork.BEST, Lead.COUNT])
    for row in range(count):
        copy_piece(timing, coefficients, found + row, timing, coefficients, first + row)
    return count


def follow_whole(
    axis: int, limits: 'float[:]', plan_offsets: 'int[:]', plan_timing: 'float[:,:]',
    plan_coefficients: 'float[:,:]', end: 'float[:]', lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', offsets: 'int[:]',
) -> None:
    """Take the whole plan of an axis for its lead, if that ends at the velocity and sooner."""
    first = plan_offsets[axis]
    last = plan_offsets[axis + 1]
    if last == first:
        return
    reached = lead[LeadWork.STATE, :]
    write_end(last - 1, plan_timing, plan_coefficients, reached)
    velocity = lead[LeadWork.TARGET, Problem.W]
    if not reached[DelayedState.DELAY] < end[LeadEnd.TIME]:
        return
    if not is_at_velocity(velocity, limits, reached):
        return
    for i in range(DelayedState.SIZE):
        end[i] = reached[i]
    end[LeadEnd.TIME] = end[LeadEnd.DELAY]
    end[LeadEnd.FOLLOWS] = 1.0
    for row in range(first, last):
        target = row + axis * LeadRows.PIECES
        copy_piece(plan_timing, plan_coefficients, row, timing, coefficients, target)
    offsets[axis + 1] = last - first


def pack_leads(
    plan_offsets: 'int[:]', timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]'
) -> None:
    """Move the pieces of all axes together; offsets has their numbers behind its first entry."""
    used = 0
    offsets[0] = 0
    for axis in range(offsets.shape[0] - 1):
        first = plan_offsets[axis] + axis * LeadRows.PIECES
        for row in range(offsets[axis + 1]):
            copy_piece(timing, coefficients, first + row, timing, coefficients, used)
            used = used + 1
        offsets[axis + 1] = used


def find_leads(
    states: 'float[:,:,:]', limits: 'float[:,:]', lower: 'float[:,:]', plan_offsets: 'int[:]',
    plan_timing: 'float[:,:]', plan_coefficients: 'float[:,:]', ends: 'float[:,:]',
    lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]',
) -> int:
    """Find the shortest lead of every axis; the first axis that has none, or -1.

    k axes: states (2, k, n + 1): now, and the targets, of which a lead to a velocity takes this
    alone; limits (k, n + 1), 0 where absent, lower (k, Lower). The caller sets the row TASK of
    `lead` (LeadWork). The plan to follow has no pieces where there is none; its times count from
    now on.

    Written: ends (k, LeadEnd), and the pieces of all axes with their offsets (k + 1,). timing and
    coefficients have LeadRows.PIECES rows for each axis beside those of the plan, and LeadRows.ALL
    rows of work space behind them.
    """
    axes = limits.shape[0]
    order = int(LeadStage.ACCELERATION)
    if lead[LeadWork.TASK, LeadTask.ORDER] == LeadStage.VELOCITY:
        order = int(LeadStage.VELOCITY)
    latest = lead[LeadWork.TASK, LeadTask.MEETING]
    waits = latest >= 0.0 and axes > 1
    rows = timing.shape[0]
    found = rows - LeadRows.ALL
    longest = max(latest, 0.0)
    clear_search(lead)
    if waits:
        longest = NEVER
    for attempt in range(2 * axes):
        axis = attempt
        if attempt >= axes:
            axis = latest_axis(ends)
            if not waits or axis < 0 or ends[axis, LeadEnd.TIME] <= latest:
                break
            longest = latest
        else:
            ends[axis, LeadEnd.HASTY] = 0.0
        set_start(axis, states[0, :, :], lower, lead)
        lead[LeadWork.TARGET, Problem.DISTANCE] = states[1, axis, WaypointState.POSITION]
        lead[LeadWork.TARGET, Problem.W] = states[1, axis, WaypointState.VELOCITY]
        lead[LeadWork.TARGET, Problem.B] = states[1, axis, WaypointState.ACCELERATION]
        if find_lead(
            order, longest, axis, plan_offsets, plan_timing, plan_coefficients, limits[axis, :],
            lead, timing[found:rows, :], coefficients[found:rows, :],
        ):
            first = plan_offsets[axis] + axis * LeadRows.PIECES
            offsets[axis + 1] = take_lead(first, ends[axis, :], lead, timing, coefficients)
        elif attempt < axes:
            offsets[axis + 1] = 0
            ends[axis, LeadEnd.TIME] = NEVER
        if order == LeadStage.VELOCITY:
            follow_whole(
                axis, limits[axis, :], plan_offsets, plan_timing, plan_coefficients, ends[axis, :],
                lead, timing, coefficients, offsets,
            )
        if ends[axis, LeadEnd.TIME] == NEVER:
            return axis
        if attempt >= axes:
            latest = max(latest, ends[axis, LeadEnd.TIME])
            ends[axis, LeadEnd.HASTY] = 1.0
    pack_leads(plan_offsets, timing, coefficients, offsets)
    return -1


def find_brakes(
    start: 'float[:,:]', limits: 'float[:,:]', lower: 'float[:,:]', brakes: 'float[:,:]',
    lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]',
) -> bool:
    """Find the brakes of all axes from their states; whether there is one.

    k axes: start (k, n + 1), limits (k, n + 1), 0 where absent, lower (k, Lower). Written: brakes
    (k, Brake), zeros where the state can stay inside its limits or no brake was found. lead
    (LeadWork), timing and coefficients (LeadRows.ALL rows) are work space.
    """
    found = False
    clear_search(lead)
    for axis in range(start.shape[0]):
        set_start(axis, start, lower, lead)
        count = find_brake(False, limits[axis, :], lead, timing, coefficients)
        for i in range(Brake.SIZE):
            brakes[axis, i] = lead[LeadWork.BRAKE, i] if count > 0 else 0.0
        if brakes[axis, Brake.UNTIL] > 0.0:
            found = True
    return found
