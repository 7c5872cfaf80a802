"""Tables for the terminal."""

from __future__ import annotations

import numpy as np
from rich.markup import escape
from rich.table import Table

from segfmu.planning import Trajectory
from segfmu.planning.limits import NAMES, UNITS
from segfmu.planning.verify import Verification
from segfmu.validation.criteria import DRIVES, Criteria
from segfmu.validation.units import labelled, resting, shown


def plan_table(
    name: str, trajectory: Trajectory, found: Verification, given: bool = True
) -> Table:
    """Peaks of every derivative against the limits, per axis.

    given: whether the limits are the mission's, not those of the search within the drives' bounds.
    """
    times = ", ".join(f"{t:.3f}" for t in trajectory.waypoint_times)
    table = Table(title=f"{escape(name)}: {trajectory.duration:.3f} s, waypoints at {times} s")
    table.add_column("peak")
    if not given:
        table.caption = "the mission has no limits: these were found for the bounds of the drives"
    for axis in trajectory.axis_names:
        table.add_column(f"{axis}, of its limit", justify="right")
    for order, (quantity, unit) in enumerate(zip(NAMES, UNITS, strict=True)):
        if order < min(trajectory.smoothness, 4):
            cells = [
                # for an axis that rests none are searched for
                "rests" if rest and not given
                else f"{peak:.4g} of {limit:.4g}" if np.isfinite(limit) else f"{peak:.4g}, free"
                for peak, limit, rest in zip(
                    found.peaks[order], found.limits[order], resting(trajectory), strict=True
                )
            ]
            table.add_row(escape(labelled(quantity, unit)), *cells)
    return table


def run_table(name: str, found: Criteria) -> Table:
    """Duration, peaks, tracking error, residual sway and the verdict."""
    table = Table(title=escape(name), show_header=False)
    table.add_column("quantity")
    table.add_column("value", justify="right")
    table.add_row("duration", f"{found.duration:.3f} s")
    for drive in DRIVES:
        (force,), unit = shown((found.peak_force[drive],), "N")
        table.add_row(f"peak force, {drive}", f"{force:.4g} {unit}")
        table.add_row(f"peak velocity, {drive}", f"{found.peak_velocity[drive]:.4g} m/s")
    for row in found.rows:
        colour = "" if row.passed else "red"
        table.add_row(row.name, f"{row}{'' if row.passed else ', failed'}", style=colour)
    table.add_row("verdict", "[green]passed[/]" if found.passed else "[red]failed[/]")
    return table
