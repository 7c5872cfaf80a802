"""Why there is no plan within the bounds of the drives."""

from __future__ import annotations

from collections.abc import Sequence

from segfmu.crane.bounds import ActuatorBounds, BoundUse, uses
from segfmu.crane.demand import peaks
from segfmu.crane.drive_task import Task
from segfmu.crane.limit_search import ROUGH, just_kept
from segfmu.errors import InfeasibleError
from segfmu.planning.arrays import FloatArray
from segfmu.planning.messages import told_apart


def refused(
    starts: Sequence[tuple[Task, FloatArray]], bounds: ActuatorBounds
) -> InfeasibleError:
    """What the plan that comes closest exceeds; the planner's own reason if there is no plan."""
    tried = [found for found in (just_kept(*start, ROUGH) for start in starts) if found]
    if not tried:
        try:
            task, table = starts[0]
            task.require_path(task.plan(table))
        except InfeasibleError as error:
            return error
    closest = min(tried, key=lambda found: found.use)
    found = uses(bounds, *peaks(closest.task.crane, closest.trajectory))
    worst = max(found, key=lambda use: use.use)
    return exceeded("", worst, f"even the slowest plan, at {worst.time:.3f} s")


def exceeded(where: str, found: BoundUse, what: str) -> InfeasibleError:
    """The error for a bound: where it is exceeded, and what needs more than it."""
    digits = told_apart(found.peak, found.bound, 6)
    return InfeasibleError(
        f"{where}{found.name} needs {found.peak:.{digits}g} {found.unit} for {what}; the bound is "
        f"{found.bound:.{digits}g} {found.unit}; raise the bound, or lower the load's mass or the "
        "waypoints' velocities and accelerations",
        limit=found.name, value=found.peak, bound=found.bound, time=found.time,
    )
