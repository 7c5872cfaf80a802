"""The kernels that other layers and C programs may call, and the extents of their arrays.

An extent is an integer, a name, or an expression of names. A name takes its value from the first
dimension that has it; other dimensions of the same name must have the same extent. Integers,
integer arguments and expressions are what a dimension has at least. The compiled
extension checks them, so that an array that is too small raises IndexError, as the interpreted
kernel does, and is not overrun.
"""

from __future__ import annotations

from dataclasses import dataclass

from segfmu.kernels.crane.records import FlatInverse, FlatSeries, Masses, RopeBounds, RopeWork
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Phase,
    PlanOptions,
    PlanWork,
    Problem,
    WaypointState,
)
from segfmu.kernels.trajectory.records import Check, Expansion, Timing

Extent = int | str


@dataclass(frozen=True)
class EntryPoint:
    """Module below `segfmu.kernels`, name, and extents of the array arguments by their names."""

    module: str
    name: str
    extents: dict[str, tuple[Extent, ...]]


def entry(module: str, name: str, /, **extents: Extent | tuple[Extent, ...]) -> EntryPoint:
    """Declare an entry point; the extent of a vector stands alone."""
    return EntryPoint(
        module, name, {n: e if isinstance(e, tuple) else (e,) for n, e in extents.items()}
    )


ENTRY_POINTS = (
    entry("planner.parameters", "axis_limits", limits="smoothness + 1", axis=Axis.SIZE),
    entry("planner.parameters", "ramp_parameters", axis=Axis.SIZE, work=(2, 12)),
    entry("planner.ramp", "ramp_duration", axis=Axis.SIZE),
    entry("planner.phases", "measure_phases", phases=("count", Phase.SIZE), axis=Axis.SIZE),
    entry(
        "planner.profile", "shortest_profile", problem=Problem.SIZE, axis=Axis.SIZE,
        phases=(Cell.ABOVE, Phase.SIZE), work=(PlanWork.SIZE, PlanWork.COLUMNS),
    ),
    entry(
        "planner.synchronize", "timed_profile", axis=Axis.SIZE, cell=(Cell.SIZE, Cell.COLUMNS),
        work=(PlanWork.SIZE, PlanWork.COLUMNS),
    ),
    entry(
        "planner.plan", "plan_phases", states=("points", "axes", WaypointState.SIZE),
        dwells="points", limits=("axes", 3), options=PlanOptions.SIZE, axes=("axes", Axis.SIZE),
        cells=("(points - 1) * axes", Cell.SIZE, Cell.COLUMNS),
        work=(PlanWork.SIZE, PlanWork.COLUMNS),
    ),
    entry(
        "trajectory.expand", "count_pieces", axes=("axes", Axis.SIZE),
        cells=("cells", Cell.SIZE, Cell.COLUMNS),
    ),
    entry(
        "trajectory.pieces", "expand_phases", phases=("count", Phase.SIZE), axis=Axis.SIZE,
        timing=("rows", Timing.SIZE), coefficients=("rows", 4),
        work=(Expansion.SIZE, Expansion.COLUMNS),
    ),
    entry(
        "trajectory.expand", "expand_plan", states=("points", "axes", WaypointState.SIZE),
        dwells="points", axes=("axes", Axis.SIZE),
        cells=("(points - 1) * axes", Cell.SIZE, Cell.COLUMNS), timing=("rows", Timing.SIZE),
        coefficients=("rows", 4), offsets="axes + 1", times=("points + 1", "axes"),
        work=(Expansion.SIZE, Expansion.COLUMNS),
    ),
    entry(
        "trajectory.check", "check_plan", states=("points", "axes", WaypointState.SIZE),
        times=("points + 1", "axes"), timing=("rows", Timing.SIZE), coefficients=("rows", 4),
        offsets="axes + 1", limits=("axes", 3), work=(Check.SIZE, Check.COLUMNS),
    ),
    entry(
        "crane.rope", "check_rope", timing=("pieces", 2), coefficients=("pieces", "width"),
        offsets=4, bounds=RopeBounds.SIZE, work=(RopeWork.SIZE, "4 * width - 5"), report=3,
    ),
    entry("trajectory.evaluate", "evaluate"),
    entry("trajectory.evaluate", "evaluate_orders"),
    entry("trajectory.breaks", "next_plan_event"),
    entry("trajectory.breaks", "right_of_break"),
    entry("trajectory.breaks", "same_break"),
    entry("control.feedback", "feedback_correction"),
    entry("control.feedback", "feedback_bandwidth"),
    entry("control.feedback", "feedback_gains"),
    entry("control.kalman", "observer_design"),
    entry("control.observer", "observer_predict"),
    entry("control.observer", "observer_correct"),
    entry("control.tracking", "track_setpoint"),
    entry("crane.compensation", "compensate_setpoints"),
    entry("crane._crane", "crane_rhs"),
    entry("crane._crane", "crane_driven"),
    entry("crane._crane", "crane_flat_inverse"),
    entry(
        "crane._series", "flat_derivatives", flat=("order + 5", 3), masses=Masses.SIZE,
        work=(FlatSeries.SIZE, "order + 3"), found=FlatInverse.SIZE,
    ),
    entry("crane._crane", "crane_load"),
    entry("crane._crane", "crane_energy"),
    entry("crane.plant", "plant_advance"),
    entry("numerics.noise", "seed_numbers"),
    entry("numerics.noise", "next_uniform"),
    entry("numerics.noise", "noise_components"),
    entry("rig.sensing", "measure_state"),
    entry("rig.loop", "switch_correction"),
    entry("rig.rig", "rig_rows"),
    entry("rig.rig", "rig_start"),
    entry("rig.rig", "rig_step"),
    entry("rig.rig", "rig_balance"),
    entry("rig.rig", "rig_imbalance"),
    entry("rig.exchange", "rig_next_event"),
    entry("rig.exchange", "rig_event"),
    entry("rig.exchange", "rig_signals"),
    entry("rig.exchange", "rig_rates"),
    entry("rig.partials", "rig_partials"),
    entry("crane._partials", "crane_load_partials"),
    entry("crane._partials", "crane_energy_partials"),
)
