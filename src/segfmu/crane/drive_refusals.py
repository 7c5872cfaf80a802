"""Why there is no plan within the bounds of the drives."""

from __future__ import annotations

from itertools import product

import numpy as np

from segfmu.crane.bounds import DRIVES, ActuatorBounds, BoundUse, uses
from segfmu.crane.demand import peaks
from segfmu.crane.drive_task import Task
from segfmu.crane.limit_search import LimitSearch
from segfmu.errors import InfeasibleError
from segfmu.kernels.crane.records import (
    AXES,
    Axes,
    BoundFault,
    BoundStatus,
    Demand,
    RopeDemand,
)
from segfmu.kernels.crane.rope import least_depth
from segfmu.kernels.limits.records import AxisTask
from segfmu.kernels.messages import BOUND, ROPE_LIMITS
from segfmu.planning.messages import told_apart

BELOW = RopeDemand.BELOW_TROLLEY
# a bound nearer to the weight than this leaves no room that could be measured
WEIGHTLESS = 1e-6


def refused(task: Task, search: LimitSearch, bounds: ActuatorBounds) -> InfeasibleError:
    """What the plan that comes closest exceeds; the planner's own reason if there is no plan."""
    reason, closest = search.reason(), search.closest
    if reason is not None:
        return reason
    if closest is None:
        raise AssertionError("a search without a plan and without a refusal")
    found = uses(bounds, *peaks(task.crane, closest.trajectory, task.friction, bounds.lag))
    worst = max(found, key=lambda use: use.use)
    return exceeded("", worst, f"even the slowest plan, at {worst.time:.3f} s")


def require_below(task: Task) -> None:
    """Refuse a waypoint that is not below the trolley."""
    for number, height in enumerate(task.positions[:, Axes.ROPE].tolist(), 1):
        if height > -least_depth():
            raise InfeasibleError(
                f"waypoint {number}: position z {height + 0.0:g} m must be below the trolley, "
                f"z <= {-least_depth():g}; lower the waypoint",
                axis=Axes.ROPE, interval=max(number - 1, 1), limit=ROPE_LIMITS[BELOW],
                value=height, bound=-least_depth(),
            )


def require_start(task: Task, bounds: ActuatorBounds) -> None:
    """Refuse a drive that cannot move off, or can only just hold the load: any motion needs more.

    A hoist below the load's weight is refused by the search, which tells what a plan needs.
    """
    table = bounds.table
    for i, side in product(range(len(DRIVES)), range(2)):
        sticking, held = task.axes[i, AxisTask.HELD : AxisTask.HELD + 2].tolist()
        # what the rope carries pulls against the drive or, where it pays out, with it
        weight = held if side else 0.0
        friction = sticking if task.axes[i, AxisTask.GOES + side] else 0.0
        friction = friction if side else max(friction - held, 0.0)
        bound = float(table[side, Demand.FORCE + i])
        least = weight + friction
        if friction == 0.0 and bound < least * (1.0 - WEIGHTLESS):
            continue
        if least > 0.0 and bound <= least * (1.0 + WEIGHTLESS):
            parts = {"the load's weight": weight, "its friction": friction}
            what = " and ".join(text for text, force in parts.items() if force)
            remedy = {"lower the load's mass": weight, "lower the friction": friction}
            others = " or ".join(text for text, force in remedy.items() if force)
            directed = side and bound != float(table[0, Demand.FORCE + i])
            name = f"{DRIVES[i]} force_min" if directed else f"{DRIVES[i]} force"
            raise InfeasibleError(
                f"{name} needs more than {least:.9g} N, {what}, for any motion; "
                f"the bound is {bound:.9g} N; raise the bound or {others}",
                limit=name, value=least, bound=bound,
            )


def exceeded(where: str, found: BoundUse, what: str) -> InfeasibleError:
    """The error for a bound: where it is exceeded, and what needs more than it."""
    if found.unit == "m":
        return beyond_stop(found)
    digits = told_apart(found.peak, found.bound, 6)
    # the load's mass changes neither the motion of the drives nor the sway
    mass = "the load's mass or " if found.unit in ("N", "W") else ""
    peak, bound = (_told(value, found.unit, digits) for value in (found.peak, found.bound))
    return InfeasibleError(
        f"{where}{found.name} needs {peak} for {what}; the bound is {bound}; raise the bound, or "
        f"lower {mass}the waypoints' velocities and accelerations",
        limit=found.name, value=found.peak, bound=found.bound, time=found.time,
    )


def beyond_stop(found: BoundUse) -> InfeasibleError:
    """The error for an end stop, as the FMU has it."""
    fault = np.zeros(BoundFault.SIZE)
    axis = AXES.index(found.name.split()[0])
    for field in (BoundFault.DRIVE, BoundFault.AXIS, BoundFault.STOPPED):
        fault[field] = axis
    fault[BoundFault.SIDE] = found.name.endswith("_min")
    fault[BoundFault.VALUE], fault[BoundFault.BOUND] = found.peak, found.bound
    fault[BoundFault.TIME] = found.time
    return InfeasibleError(
        BOUND.text(BoundStatus.TRAVEL, fault.tolist()), axis=axis, limit=found.name,
        value=found.peak, bound=found.bound, time=found.time,
    )


def _told(value: float, unit: str, digits: int) -> str:
    """A value with its unit; angles in degrees as well."""
    degrees = f" ({np.degrees(value):.{digits}g} deg)" if unit == "rad" else ""
    return f"{value:.{digits}g} {unit}{degrees}"
