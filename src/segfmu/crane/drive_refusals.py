"""Why there is no plan within the bounds of the drives."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np

from segfmu.crane.bounds import DRIVES, ActuatorBounds, BoundUse, uses
from segfmu.crane.demand import peaks
from segfmu.crane.drive_task import HOIST, WEIGHTLESS, Task
from segfmu.crane.limit_search import ROUGH, just_kept
from segfmu.errors import InfeasibleError
from segfmu.kernels.crane.records import Demand
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
    found = uses(bounds, *peaks(closest.task.crane, closest.trajectory, closest.task.friction))
    worst = max(found, key=lambda use: use.use)
    return exceeded("", worst, f"even the slowest plan, at {worst.time:.3f} s")


def require_start(task: Task) -> None:
    """Refuse a drive that cannot move off, or can only just hold the load: any motion needs more.

    A hoist below the load's weight is refused by the search, which tells what a plan needs.
    """
    for i, side in product(range(len(DRIVES)), range(2)):
        held = task.weight if i == HOIST else 0.0
        # what the rope carries pulls against the drive or, where it pays out, with it
        weight = held if side else 0.0
        friction = float(task.sticking[i]) if task.goes[side, i] else 0.0
        friction = friction if side else max(friction - held, 0.0)
        bound = float(task.bounds[side, Demand.FORCE + i])
        least = weight + friction
        if friction == 0.0 and bound < least * (1.0 - WEIGHTLESS):
            continue
        if least > 0.0 and bound <= least * (1.0 + WEIGHTLESS):
            parts = {"the load's weight": weight, "its friction": friction}
            what = " and ".join(text for text, force in parts.items() if force)
            remedy = {"lower the load's mass": weight, "lower the friction": friction}
            others = " or ".join(text for text, force in remedy.items() if force)
            directed = side and bound != float(task.bounds[0, Demand.FORCE + i])
            name = f"{DRIVES[i]} force_min" if directed else f"{DRIVES[i]} force"
            raise InfeasibleError(
                f"{name} needs more than {least:.9g} N, {what}, for any motion; "
                f"the bound is {bound:.9g} N; raise the bound or {others}",
                limit=name, value=least, bound=bound,
            )


def exceeded(where: str, found: BoundUse, what: str) -> InfeasibleError:
    """The error for a bound: where it is exceeded, and what needs more than it."""
    digits = told_apart(found.peak, found.bound, 6)
    # the load's mass changes neither the motion of the drives nor the sway
    mass = "the load's mass or " if found.unit in ("N", "W") else ""
    peak, bound = (_told(value, found.unit, digits) for value in (found.peak, found.bound))
    return InfeasibleError(
        f"{where}{found.name} needs {peak} for {what}; the bound is {bound}; raise the bound, or "
        f"lower {mass}the waypoints' velocities and accelerations",
        limit=found.name, value=found.peak, bound=found.bound, time=found.time,
    )


def _told(value: float, unit: str, digits: int) -> str:
    """A value with its unit; angles in degrees as well."""
    degrees = f" ({np.degrees(value):.{digits}g} deg)" if unit == "rad" else ""
    return f"{value:.{digits}g} {unit}{degrees}"
