"""Use of the drives' bounds: of a plan exactly, of a run from its rows; as tables."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from rich.table import Table

from segfmu.arrays import FloatArray
from segfmu.crane.bounds import DRIVES, ActuatorBounds, BoundUse, sides, uses
from segfmu.validation.units import shown

RATES = ("bridge.velocity", "trolley.velocity", "rope.velocity")
PLACES = ("bridge.position", "trolley.position", "rope.length")
SWAYS = ("sway.x.angle", "sway.y.angle")
# a run may use this more of a bound than all of it: the feedback acts beside the plan
RUN_MARGIN = 0.01


def run_uses(rows: NDArray[np.void], bounds: ActuatorBounds) -> tuple[BoundUse, ...]:
    """Use of every bound in the rows of a co-simulation."""
    found = run_demands(rows)
    at = np.array([found.argmax(axis=0), found.argmin(axis=0)])
    return uses(bounds, sides(found), rows["time"][at])


def run_demands(rows: NDArray[np.void]) -> FloatArray:
    """What a co-simulation asks of the drives, (rows, 17); accelerations by differences."""
    time = rows["time"]
    force = np.column_stack([rows[f"drive.{drive}.force"] for drive in DRIVES])
    velocity = np.column_stack([rows[rate] for rate in RATES])
    place = np.column_stack([rows[name] for name in PLACES])
    sway = np.column_stack([rows[angle] for angle in SWAYS])
    acceleration = np.gradient(velocity, time, axis=0) if time.size > 1 else 0.0 * velocity
    return np.hstack([force, velocity, acceleration, force * velocity, place, sway])


def bound_table(found: Sequence[BoundUse]) -> Table:
    """Every known bound with its peak, its use and when; those in full use first."""
    table = Table(title="use of the drives' bounds")
    table.add_column("bound")
    for heading in ("peak", "of", "use", "at"):
        table.add_column(heading, justify="right")
    known = [use for use in found if np.isfinite(use.bound)]
    for use in sorted(known, key=lambda use: -use.use):
        (peak, bound), unit = shown((use.peak, use.bound), use.unit)
        table.add_row(
            use.name, f"{peak:.4g} {unit}", f"{bound:.4g} {unit}", f"{100.0 * use.use:.2f} %",
            f"{use.time:.3f} s",
        )
    return table
