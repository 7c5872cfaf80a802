"""The kernels that other layers and C programs may call, and the extents of their arrays.

Every array argument has an extent for each of its dimensions: an integer, a name, or an expression
of names. A name takes its value from the first dimension that has it, which is not empty unless
`MAY_BE_EMPTY` has it; other dimensions of the same name must have the same extent. Integers,
integer arguments and expressions are what a dimension has at least; an expression may call an entry
point and use entries of arrays. Arrays of integers that a kernel reads are the first pieces of each
axis and the end of the last one: they ascend from 0 to `pieces` at most. The compiled extension
checks all this, so that an array that is too small raises IndexError, as the interpreted kernel
does, and is not overrun.

A room of a further model has an `entry_points.py` of its own, which is found.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from segfmu.kernels.clearance.records import (
    Box,
    Collision,
    Excursion,
    ObstacleRow,
    Ranges,
    Space,
    SpaceFault,
    Span,
    Stack,
)
from segfmu.kernels.control.records import (
    AxisModel,
    Estimate,
    Estimates,
    Expected,
    FlatDesign,
    Gains,
    Kalman,
    LoopWork,
    Observer,
    RopeRange,
    Tick,
    Tracker,
    Tracking,
    TrackingDesign,
    Uncertainty,
)
from segfmu.kernels.crane.records import (
    Axes,
    BoundFault,
    BoundUses,
    Compensation,
    Contact,
    ContactWork,
    Coordinates,
    CranePartials,
    Demand,
    DemandPeaks,
    DemandWork,
    DriveBounds,
    FlatInverse,
    FlatSeries,
    FrictionSeries,
    GeneralisedForce,
    Load,
    LoadPartials,
    Masses,
    Plant,
    PlantFault,
    PlantState,
    Report,
    Resistance,
    RopeBounds,
    RopeFault,
    RopeWork,
    State,
    Vector,
    Work,
)
from segfmu.kernels.entry_point import EntryPoint, Extent, entry
from segfmu.kernels.limits.records import (
    AxisTask,
    Heading,
    LimitFault,
    LimitRow,
    Pace,
    Search,
    SearchState,
    SearchValues,
    Starts,
    Values,
)
from segfmu.kernels.numerics.records import (
    RandomState,
    RangeFault,
    Sinusoid,
)
from segfmu.kernels.operation.records import (
    Known,
    Operation,
    OperationRows,
    OperationWork,
    ReadyFault,
    Slot,
)
from segfmu.kernels.passage.records import Block, Link, Spot, Stretch, Tools, Track
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    DelayedState,
    Lower,
    Phase,
    PlanOptions,
    PlanWork,
    Problem,
    Refusal,
    WaypointState,
)
from segfmu.kernels.rig.records import (
    Balance,
    Energies,
    Memory,
    Outputs,
    PayloadChange,
    RigPartials,
    RigVariables,
    Sensors,
    Setpoints,
    Settings,
    SetupFault,
    StartFault,
    Target,
)
from segfmu.kernels.settling.records import LeadEnd, LeadRows, LeadWork, PlanPart
from segfmu.kernels.spline.records import Derivatives, Mesh, SplineWork
from segfmu.kernels.trajectory.records import (
    Brake,
    Expansion,
    MotionWork,
    PieceState,
    Spare,
    Timing,
)

# without noise, changes of the payload, times, or obstacles
MAY_BE_EMPTY = ("sines", "changes", "samples", "boxes")

# first pieces of axes that may have none
MAY_LACK_PIECES = ("lead_offsets", "plan_offsets")


# unknowns of a search: limits of all axes, then the states of inner waypoints
UNKNOWNS = f"search[{Search.STATE}, {SearchState.UNKNOWNS}]"
STATES_TOO = f"{Vector.SIZE * LimitRow.SIZE} + {2 * Vector.SIZE} * (points - 2)"
STATES_OF = f"{Vector.SIZE * LimitRow.SIZE} + {2 * Vector.SIZE} * (place[points - 1] - 1)"
# what an axis of the smoothness in `axis` or `options` has
AXIS_WIDTH = f"2 * axis[{Axis.SMOOTHNESS}]"
PLAN_LIMITS = f"options[{PlanOptions.SMOOTHNESS}] + 1"
MOTION_SMOOTHNESS = f"work[{MotionWork.OPTIONS}, {PlanOptions.SMOOTHNESS}]"
RIG_ROWS = "rig_rows(settings)"
LEAD_ROWS = f"pieces + {LeadRows.PIECES} * axes + {LeadRows.ALL}"
ONWARD_ROWS = f"{LeadRows.PIECES} * axes + {LeadRows.ALL}"

MOTION: dict[str, Extent | tuple[Extent, ...]] = {
    "states": ("points", "axes", WaypointState.SIZE), "dwells": "points",
    "limits": ("axes", f"{MOTION_SMOOTHNESS} + 1"), "lower": ("axes", Lower.SIZE),
    "axes": ("axes", Axis.SIZE),
    "cells": ("(points - 1) * axes", Cell.SIZE, Cell.COLUMNS),
    "timing": ("rows", Timing.SIZE), "coefficients": ("rows", f"2 * {MOTION_SMOOTHNESS}"),
    "offsets": "axes + 1", "times": ("points + 1", "axes"),
    "work": (MotionWork.SIZE, MotionWork.COLUMNS),
}

CHOICE: dict[str, Extent | tuple[Extent, ...]] = {
    "choice": (f"{Block.COUNT} * points", "axes", WaypointState.SIZE),
    "tools": (Tools.SIZE, Tools.COLUMNS), "axes": ("axes", Track.SIZE),
    "spots": ("points * axes", Spot.SIZE, Spot.COLUMNS),
    "work": (MotionWork.SIZE, MotionWork.COLUMNS),
}

_COMMON = (
    entry("planner.parameters", "axis_limits", limits="smoothness + 1", axis=Axis.SIZE),
    entry("planner.parameters", "ramp_parameters", axis=Axis.SIZE, work=(2, 12)),
    entry("planner.ramp", "ramp_duration", axis=Axis.SIZE),
    entry("planner.nested", "ramp_pieces", axis=Axis.SIZE),
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
        "planner.problem", "check_problem", states=("points", "axes", WaypointState.SIZE),
        limits=("axes", 2), report=Refusal.SIZE,
    ),
    entry(
        "planner.problem", "motion_scale", states=("points", "axes", WaypointState.SIZE),
        limits=("axes", 2),
    ),
    entry(
        "planner.problem", "settle_states", states=("points", "axes", WaypointState.SIZE),
        limits=("axes", 2),
        lower=("axes", Lower.SIZE),
    ),
    entry("planner.problem", "settle_dwells", dwells="points"),
    entry(
        "planner.plan", "plan_phases", states=("points", "axes", WaypointState.SIZE),
        dwells="points", limits=("axes", PLAN_LIMITS), lower=("axes", Lower.SIZE),
        options=PlanOptions.SIZE,
        axes=("axes", Axis.SIZE),
        cells=("(points - 1) * axes", Cell.SIZE, Cell.COLUMNS),
        work=(PlanWork.SIZE, PlanWork.COLUMNS),
    ),
    entry(
        "trajectory.expand", "count_pieces", axes=("axes", Axis.SIZE),
        cells=("cells", Cell.SIZE, Cell.COLUMNS),
    ),
    entry(
        "trajectory.pieces", "expand_phases", phases=("count", Phase.SIZE), axis=Axis.SIZE,
        timing=("row + ramp_pieces(axis) * count", Timing.SIZE),
        coefficients=("row + ramp_pieces(axis) * count", AXIS_WIDTH),
        work=(Expansion.SIZE, Expansion.COLUMNS),
    ),
    entry(
        "spline.motion", "spline_share", first=Derivatives.SIZE, last=Derivatives.SIZE, allowed=2,
        axis=Axis.SIZE, work=(SplineWork.SIZE, SplineWork.COLUMNS),
    ),
    entry(
        "spline.pieces", "append_spline", first=Derivatives.SIZE, last=Derivatives.SIZE,
        timing=(f"row + {Mesh.CELLS}", Timing.SIZE),
        coefficients=(f"row + {Mesh.CELLS}", f"2 * work[{SplineWork.PROGRAM}, 0] - 2"),
        state=PieceState.SIZE, work=(SplineWork.SIZE, SplineWork.COLUMNS),
    ),
    entry("trajectory.check", "state_scale", limits="order + 2"),
    entry("trajectory.motion", "plan_motion", **MOTION),
    entry("trajectory.motion", "expand_motion", **MOTION),
    entry(
        "settling.leads", "find_leads", states=(2, "axes", "states"), limits=("axes", "states"),
        lower=("axes", Lower.SIZE), plan_offsets="axes + 1", plan_timing=("pieces", Timing.SIZE),
        plan_coefficients=("pieces", "width"), ends=("axes", LeadEnd.SIZE),
        lead=(LeadWork.SIZE, LeadWork.COLUMNS), timing=(LEAD_ROWS, Timing.SIZE),
        coefficients=(LEAD_ROWS, "width"), offsets="axes + 1",
    ),
    entry(
        "settling.onward", "plan_onward", states=("2 * points", "axes", LeadEnd.SIZE),
        dwells="points", limits=("axes", "orders"), lower=("axes", Lower.SIZE),
        axes=("2 * axes", Axis.SIZE), cells=("(points - 1) * axes", Cell.SIZE, Cell.COLUMNS),
        timing=(PlanPart.COUNT, ONWARD_ROWS, Timing.SIZE),
        coefficients=(PlanPart.COUNT, ONWARD_ROWS, "2 * orders - 2"),
        offsets=f"{PlanPart.COUNT} * (axes + 1)", times=("points + 1", "axes"),
        lead=(LeadWork.SIZE, LeadWork.COLUMNS),
    ),
    entry(
        "settling.onward", "judge_pieces", states=("points", "axes", WaypointState.SIZE),
        times=("points + 1", "axes"), timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "2 * orders - 2"), offsets="axes + 1", limits=("axes", "orders"),
        lower=("axes", Lower.SIZE), brakes=("axes", Brake.SIZE),
        lead=(LeadWork.SIZE, LeadWork.COLUMNS), spare_timing=(LeadRows.ALL, Timing.SIZE),
        spare_coefficients=(LeadRows.ALL, "2 * orders - 2"),
    ),
    entry(
        "settling.ends", "plan_ends", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets="axes + 1", ends=("axes", DelayedState.SIZE),
    ),
    entry(
        "settling.ends", "are_at_velocities", targets=("axes", WaypointState.VELOCITY + 1),
        limits=("axes", 2), ends=("axes", DelayedState.SIZE),
    ),
    entry(
        "settling.leads", "find_brakes", start=("axes", "states"), limits=("axes", "states"),
        lower=("axes", Lower.SIZE), brakes=("axes", Brake.SIZE),
        lead=(LeadWork.SIZE, LeadWork.COLUMNS), timing=(LeadRows.ALL, Timing.SIZE),
        coefficients=(LeadRows.ALL, "width"),
    ),
    entry(
        "settling.brake", "find_brake", limits="limits", lead=(LeadWork.SIZE, LeadWork.COLUMNS),
        timing=(LeadRows.ALL, Timing.SIZE), coefficients=(LeadRows.ALL, "width"),
    ),
    entry(
        "trajectory.cut", "cut_plan", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets="bounds",
        cut_timing=("pieces + bounds", Timing.SIZE), cut_coefficients=("pieces + bounds", "width"),
        cut_offsets="bounds",
    ),
    entry(
        "trajectory.cut", "anchor_plan", ends=("axes", 1), limits=("axes", 1),
        timing=("pieces", Timing.SIZE), coefficients=("pieces", 4), offsets="axes + 1",
    ),
    entry("trajectory.cut", "meet_ends", timing=("pieces", Timing.SIZE), offsets="bounds"),
    entry(
        "trajectory.cut", "join_plans", lead_timing=("pieces", Timing.SIZE),
        lead_coefficients=("pieces", "width"), lead_offsets="bounds",
        timing=("pieces", Timing.SIZE), coefficients=("pieces", "width"), offsets="bounds",
        joined_timing=("2 * pieces", Timing.SIZE),
        joined_coefficients=("2 * pieces", "width"), joined_offsets="bounds",
    ),
    entry(
        "crane.rope", "check_rope", timing=("pieces", 2), coefficients=("pieces", "width"),
        offsets=4, bounds=RopeBounds.SIZE, work=(RopeWork.SIZE, "4 * width - 5"),
        report=RopeFault.SIZE,
    ),
    entry(
        "clearance.ranges", "path_ranges", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets=4, work=(2, "width"), ranges=(Ranges.SIZE, 3),
    ),
    entry(
        "clearance.spans", "clearance_spans", timing=("pieces", 2),
        coefficients=("pieces", "width"), offsets=4, work=(RopeWork.SIZE, "4 * width - 5"),
        spans=("pieces + 1", Span.SIZE, "2 * width - 3"),
    ),
    entry(
        "clearance.contact", "contact_times", box=Box.SIZE, spans=("count", Span.SIZE, "columns"),
        stack=(Stack.ROWS, Span.SIZE, "columns"), times=("rows", 2), place=3,
    ),
    entry(
        "clearance.path", "first_contact", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets=4, boxes=("boxes", Box.SIZE),
        work=(RopeWork.SIZE, "4 * width - 5"), stack=(Stack.ROWS, Span.SIZE, "2 * width - 3"),
        ranges=(Ranges.SIZE, 3), report=Collision.SIZE,
    ),
    entry(
        "clearance.path", "shrink_boxes", boxes=("boxes", Box.SIZE),
    ),
    entry(
        "clearance.excursion", "path_excursion", led=("points", "axes"),
        positions=("points", "axes"), times=("points", "axes"), timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets="axes + 1",
        work=(RopeWork.SIZE, "4 * width - 5"), excursion=Excursion.SIZE,
    ),
    entry(
        "clearance.excursion", "leaves_range", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets="axis + 2",
        work=(RopeWork.SIZE, "4 * width - 5"), excursion=Excursion.SIZE,
    ),
    entry(
        "clearance.space", "write_box", space=Space.SIZE, obstacle=ObstacleRow.SIZE, box=Box.SIZE,
    ),
    entry(
        "clearance.space", "space_contact", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets=4, space=Space.SIZE,
        obstacles=("obstacles", ObstacleRow.SIZE), boxes=("obstacles + 6", Box.SIZE),
        work=(RopeWork.SIZE, "4 * width - 5"), stack=(Stack.ROWS, Span.SIZE, "2 * width - 3"),
        ranges=(Ranges.SIZE, 3), fault=SpaceFault.SIZE,
    ),
    entry(
        "operation.operate", "begin_operation", operation=(Operation.SIZE, Operation.COLUMNS)
    ),
    entry(
        "operation.operate", "operate", operation=(Operation.SIZE, Operation.COLUMNS),
        limits=(2, Vector.SIZE, "orders"), known=(Known.SIZE, Known.COLUMNS),
        timing=(Slot.COUNT, OperationRows.ALL, Timing.SIZE),
        coefficients=(Slot.COUNT, OperationRows.ALL, "2 * orders - 2"),
        offsets=Slot.COUNT * Slot.OFFSETS, states=(2, Vector.SIZE, "orders"),
        cells=(Vector.SIZE, Cell.SIZE, Cell.COLUMNS), lead=(LeadWork.SIZE, LeadWork.COLUMNS),
        work=(OperationWork.SIZE, OperationWork.COLUMNS),
        stack=(Stack.ROWS, Span.SIZE, "4 * orders - 7"),
    ),
    entry(
        "operation.emergency", "foresee_emergency", operation=(Operation.SIZE, Operation.COLUMNS),
        known=(Known.SIZE, Known.COLUMNS), timing=(Slot.COUNT, OperationRows.ALL, Timing.SIZE),
        coefficients=(Slot.COUNT, OperationRows.ALL, "width"),
        offsets=Slot.COUNT * Slot.OFFSETS, work=(OperationWork.SIZE, OperationWork.COLUMNS),
    ),
    entry(
        "operation.measured",
        "take_over_measured",
        operation=(Operation.SIZE, Operation.COLUMNS),
        known=(Known.SIZE, Known.COLUMNS),
        timing=(Slot.COUNT, OperationRows.ALL, Timing.SIZE),
        coefficients=(Slot.COUNT, OperationRows.ALL, "width"),
        offsets=Slot.COUNT * Slot.OFFSETS, work=(OperationWork.SIZE, OperationWork.COLUMNS),
        stack=(Stack.ROWS, Span.SIZE, "2 * width - 3"),
    ),
    entry(
        "operation.ready", "check_ready", compensation=Compensation.SIZE,
        resistance=Resistance.SIZE, fault=ReadyFault.SIZE,
    ),
    entry(
        "operation.ready", "next_operation", operation=(Operation.SIZE, Operation.COLUMNS)
    ),
    entry(
        "operation.drives", "keeps_drives", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets=4, known=(Known.SIZE, Known.COLUMNS),
        work=(OperationWork.SIZE, OperationWork.COLUMNS),
    ),
    entry(
        "crane.failure", "plant_failure", state=PlantState.SIZE, plant=Plant.SIZE,
        fault=PlantFault.SIZE,
    ),
    entry(
        "trajectory.evaluate", "evaluate", times="samples", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets="axes + 1", ends="axes",
        values=("samples", "axes"),
    ),
    entry(
        "trajectory.evaluate", "evaluate_orders", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets="axes + 1", ends="axes",
        values=("orders", "axes"),
    ),
    entry(
        "trajectory.breaks", "next_plan_event", timing=("pieces", Timing.SIZE),
        offsets="axes + 1", ends="axes", times=("points", "axes"),
    ),
    entry(
        "trajectory.breaks", "right_of_break", timing=("pieces", Timing.SIZE),
        offsets="axes + 1", ends="axes",
    ),
    entry("trajectory.breaks", "same_break"),
    entry(
        "control.feedback", "feedback_correction", state=State.SIZE, reference=State.SIZE,
        added=Axes.SIZE, gains=("lengths", Gains.SIZE, Gains.COLUMNS), correction=Axes.SIZE,
    ),
    entry("control.feedback", "feedback_bandwidth"),
    entry("control.design", "rope_range", found=RopeRange.SIZE),
    entry("control.design", "table_lengths", lengths="rows"),
    entry(
        "control.design", "flat_table", plant=Plant.SIZE, design=FlatDesign.SIZE, lengths="rows",
        table=("rows", Gains.SIZE, Gains.COLUMNS),
    ),
    entry(
        "control.design", "observer_table", plant=Plant.FORCE_MAX, uncertainty=Uncertainty.SIZE,
        lengths="rows", expected=Expected.SIZE, work=(Kalman.SIZE, 2 * AxisModel.SIZE),
        table=("rows", Observer.SIZE, Observer.COLUMNS),
    ),
    entry(
        "control.stability", "check_gains", plant=Plant.SIZE, ends=2,
        table=("rows", Gains.SIZE, Gains.COLUMNS), work=(LoopWork.SIZE, LoopWork.COLUMNS),
        fault=SetupFault.SIZE,
    ),
    entry("control.setting", "nominal_payload"),
    entry("control.setting", "set_drives", plant=Plant.SIZE, tracking=Tracking.SIZE),
    entry("control.setting", "set_walks", plant=Plant.SIZE, uncertainty=Uncertainty.SIZE),
    entry("control.design", "set_steps", sensors=Sensors.SIZE, uncertainty=Uncertainty.SIZE),
    entry("control.setting", "signal_age"),
    entry("control.setting", "drive_bound", plant=Plant.SIZE),
    entry(
        "control.setting", "set_tracking", plant=Plant.SIZE, design=TrackingDesign.SIZE,
        tracking=Tracking.SIZE,
    ),
    entry("control.setting", "set_fading", tracking=Tracking.SIZE),
    entry(
        "control.feedback", "feedback_gains", plant=Plant.FORCE_MAX,
        gains=(Gains.SIZE, Gains.COLUMNS),
    ),
    entry(
        "control.kalman", "observer_design", plant=Plant.FORCE_MAX, expected=Expected.SIZE,
        work=(Kalman.SIZE, 2 * AxisModel.SIZE), table=(Observer.SIZE, Observer.COLUMNS),
    ),
    entry(
        "control.observer", "observer_predict", table=("nodes", Observer.SIZE, Observer.COLUMNS),
        estimate=Estimate.SIZE, scratch=AxisModel.SIZE,
    ),
    entry(
        "control.observer", "observer_correct", table=("nodes", Observer.SIZE, Observer.COLUMNS),
        measured=Coordinates.SIZE, reference=Coordinates.SIZE, estimate=(Axes.SIZE, Estimate.SIZE),
    ),
    entry(
        "control.tracking", "track_setpoint", parameters=Tracking.SIZE,
        table=("nodes", Observer.SIZE, Observer.COLUMNS),
        gains=("lengths", Gains.SIZE, Gains.COLUMNS), tick=(Tick.SIZE, Tick.COLUMNS),
        memory=(Tracker.SIZE, Tracker.COLUMNS),
    ),
    entry(
        "crane._crane", "crane_rhs", state=State.SIZE, generalized_force=GeneralisedForce.SIZE,
        load_force=Vector.SIZE, masses=Masses.SIZE, derivative=State.SIZE,
    ),
    entry(
        "crane._crane", "crane_driven", state=State.SIZE, carriage=Axes.SIZE,
        generalized_force=GeneralisedForce.SIZE, load_force=Vector.SIZE, masses=Masses.SIZE,
        derivative=State.SIZE, force=Axes.SIZE,
    ),
    entry(
        "crane._crane", "crane_flat_inverse", flat=(5, Vector.SIZE), masses=Masses.SIZE,
        force=Axes.SIZE, state=State.SIZE, acceleration=Coordinates.SIZE,
    ),
    entry("crane.suspension", "flat_orders", resistance=Resistance.SIZE),
    entry(
        "crane.demand", "drive_demands",
        flat=("motions", "flat_orders(resistance)", Vector.SIZE), times=("motions",),
        resistance=Resistance.SIZE, contacts=(Axes.SIZE, "contacts", Contact.SIZE),
        work=(DemandWork.SIZE, DemandWork.COLUMNS), demands=("motions", Demand.SIZE),
    ),
    entry(
        "crane.peaks", "demand_peaks", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets=Vector.SIZE + 1, ends=Vector.SIZE,
        resistance=Resistance.SIZE, contacts=(Axes.SIZE, "contacts", Contact.SIZE),
        work=(DemandPeaks.SIZE, DemandPeaks.COLUMNS), peaks=(2, Demand.SIZE),
        times=(2, Demand.SIZE),
    ),
    entry(
        "crane.uses", "bound_uses", peaks=(2, Demand.SIZE), times=(2, Demand.SIZE),
        bounds=DriveBounds.SIZE, uses=BoundUses.SIZE, fault=BoundFault.SIZE,
    ),
    entry("crane.uses", "has_bounds", bounds=DriveBounds.SIZE),
    entry("crane.uses", "paced_use", uses=BoundUses.SIZE),
    entry(
        "crane.peaks", "demand_samples", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets=Vector.SIZE + 1, ends=Vector.SIZE,
        resistance=Resistance.SIZE, contacts=(Axes.SIZE, "contacts", Contact.SIZE),
        work=(DemandPeaks.SIZE, DemandPeaks.COLUMNS), peaks=(2, Demand.SIZE),
        times=(2, Demand.SIZE),
    ),
    entry("limits.pace", "begin_pace", pace=Pace.SIZE),
    entry("limits.pace", "next_pace", pace=Pace.SIZE),
    entry(
        "limits.task", "write_axes", positions=("points", Vector.SIZE),
        velocities=("points", Vector.SIZE), accelerations=("points", Vector.SIZE),
        bounds=DriveBounds.SIZE, caps=(Vector.SIZE, LimitRow.SIZE), resistance=Resistance.SIZE,
        axes=(Vector.SIZE, AxisTask.SIZE),
    ),
    entry(
        "limits.task", "narrow_bounds", bounds=DriveBounds.SIZE,
        caps=(Vector.SIZE, LimitRow.SIZE),
    ),
    entry(
        "limits.task", "write_kinds", axes=(Vector.SIZE, AxisTask.SIZE),
        kinds=Vector.SIZE * LimitRow.SIZE,
    ),
    entry(
        "limits.task", "write_limits", unknowns=Vector.SIZE * LimitRow.SIZE,
        axes=(Vector.SIZE, AxisTask.SIZE), table=(Vector.SIZE, LimitRow.SIZE),
    ),
    entry(
        "limits.task", "write_shares", peaks=(2, Demand.SIZE), bounds=DriveBounds.SIZE,
        axes=(Vector.SIZE, AxisTask.SIZE), uses=2 * Demand.SIZE,
    ),
    entry(
        "limits.starts", "write_starts", bounds=DriveBounds.SIZE, resistance=Resistance.SIZE,
        axes=(Vector.SIZE, AxisTask.SIZE), starts=(Starts.COUNT, Vector.SIZE * LimitRow.SIZE),
        fault=LimitFault.SIZE,
    ),
    entry(
        "limits.starts", "write_passing", positions=("points", Vector.SIZE), kinds=STATES_TOO,
        axes=(Vector.SIZE, AxisTask.SIZE), heading=Heading.SIZE, start=STATES_TOO,
    ),
    entry(
        "limits.heading", "write_heading", places=("places", Vector.SIZE), heading=Heading.SIZE,
    ),
    entry(
        "limits.places", "unite_waypoints", states=("points", "axes", WaypointState.SIZE),
        place="points",
    ),
    entry("passage.choose", "usual_room"),
    entry(
        "passage.choose", "begin_choice", states=("points", "axes", WaypointState.SIZE),
        dwells="points", limits=("axes", f"{MOTION_SMOOTHNESS} + 1"), lower=("axes", Lower.SIZE),
        allowed=("axes", 2), place="points", **CHOICE,
    ),
    entry(
        "passage.choose", "next_passage", tools=(Tools.SIZE, Tools.COLUMNS),
        spots=("spots", Spot.SIZE, Spot.COLUMNS),
    ),
    entry(
        "passage.choose", "choose_passage", links=("(points - 1) * axes", Link.SIZE, Link.COLUMNS),
        spans=("points", Stretch.SIZE), band=("2 * points * axes", "4 * axes + 1"),
        cells=("(points - 1) * axes", Cell.SIZE, Cell.COLUMNS),
        timing=(2 * Spare.ROWS, Timing.SIZE),
        coefficients=(2 * Spare.ROWS, f"2 * {MOTION_SMOOTHNESS}"), **CHOICE,
    ),
    entry(
        "passage.choose", "end_choice", states=("points", "axes", WaypointState.SIZE),
        place="points", choice=("5 * points", "axes", WaypointState.SIZE),
        tools=(Tools.SIZE, Tools.COLUMNS),
        axes=("axes", Track.SIZE),
    ),
    entry(
        "limits.places", "write_free", states=("points", Vector.SIZE, WaypointState.SIZE),
        place="points", dwells="points", heading=Heading.SIZE, kinds=STATES_OF,
        led=("points", Vector.SIZE),
    ),
    entry(
        "limits.places", "write_states", unknowns=STATES_OF, kinds=STATES_OF,
        table=(Vector.SIZE, LimitRow.SIZE), place="points", heading=Heading.SIZE,
        states=("points", Vector.SIZE, WaypointState.SIZE),
    ),
    entry(
        "limits.search", "begin_limits", starts=("starts", "unknowns"), kinds=("unknowns",),
        search=(Search.SIZE, "columns"),
    ),
    entry("limits.trials", "is_judged", uses=2 * Demand.SIZE, search=(Search.SIZE, "columns")),
    entry(
        "limits.trials", "cap_best", axes=(Vector.SIZE, AxisTask.SIZE),
        search=(Search.SIZE, UNKNOWNS),
    ),
    entry("limits.trials", "write_best", search=(Search.SIZE, UNKNOWNS)),
    entry("limits.trials", "keep_best", search=(Search.SIZE, UNKNOWNS)),
    entry(
        "limits.search", "next_limits", uses=2 * Demand.SIZE, starts=("starts", UNKNOWNS),
        search=(Search.SIZE, "columns"), values=(SearchValues.SIZE, Values.SIZE),
        slopes=(UNKNOWNS, Values.SIZE), newton=(f"2 * {UNKNOWNS}", UNKNOWNS),
    ),
    entry(
        "crane.contact", "contact_history", timing=("pieces", Timing.SIZE),
        coefficients=("pieces", "width"), offsets=Vector.SIZE + 1, ends=Vector.SIZE,
        resistance=Resistance.SIZE, work=(ContactWork.SIZE, ContactWork.COLUMNS),
        contacts=("contacts", Contact.SIZE),
    ),
    entry(
        "crane.contact", "planned_friction", resistance=Resistance.SIZE,
        contacts=("contacts", Contact.SIZE),
    ),
    entry("crane.contact", "resists", resistance=Resistance.SIZE),
    entry("crane.contact", "next_contact_event", contacts=("contacts", Contact.SIZE)),
    entry(
        "crane.friction_series", "friction_derivative", resistance=Resistance.SIZE,
        motion="order + 2", contacts=("contacts", Contact.SIZE),
        work=(FrictionSeries.SIZE, "order + 1"),
    ),
    entry(
        "crane._series", "flat_derivatives", flat=("order + 5", 3), masses=Masses.SIZE,
        work=(FlatSeries.SIZE, "order + 3"), found=FlatInverse.SIZE,
    ),
    entry("crane._crane", "crane_load", state=State.SIZE, load=(Load.SIZE, Load.COLUMNS)),
    entry(
        "crane._crane", "crane_energy", state=State.SIZE, masses=Masses.SIZE, energy=Energies.SIZE,
    ),
    entry(
        "crane.plant", "plant_advance", plant=Plant.SIZE, components=("sines", Sinusoid.SIZE),
        state=PlantState.SIZE, work=(Work.SIZE, Work.COLUMNS), report=Report.SIZE,
    ),
    entry(
        "rig.setup", "check_travel", least=Axes.SIZE, greatest=Axes.SIZE, fault=SetupFault.SIZE
    ),
    entry("rig.setup", "check_lags", plant=Plant.SIZE, fault=SetupFault.SIZE),
    entry(
        "rig.setup", "check_friction", static=Axes.SIZE, coulomb=Axes.SIZE, fault=SetupFault.SIZE
    ),
    entry("rig.setup", "wind_speed", speed=Vector.SIZE),
    entry(
        "rig.setup", "check_turbulence", speed=Vector.SIZE, deviation=Vector.SIZE,
        fault=SetupFault.SIZE,
    ),
    entry(
        "rig.setup", "check_changes", changes=("changes", PayloadChange.SIZE),
        fault=SetupFault.SIZE,
    ),
    entry("rig.setup", "check_slack", plant=Plant.SIZE, fault=SetupFault.SIZE),
    entry("rig.setup", "check_delays", plant=Plant.SIZE, fault=SetupFault.SIZE),
    entry("rig.setup", "check_sensors", sensors=Sensors.SIZE, fault=SetupFault.SIZE),
    entry("rig.setup", "check_rope_bounds", fault=SetupFault.SIZE),
    entry("rig.setup", "check_lengths", lengths=RopeRange.SIZE, fault=SetupFault.SIZE),
    entry("numerics.range", "check_range", fault=RangeFault.SIZE),
    entry("numerics.times", "begin_time"),
    entry(
        "rig.start", "start_state", own=State.SIZE, held=State.SIZE, reference=State.SIZE,
        state=State.SIZE,
    ),
    entry(
        "rig.start", "check_start", state=State.SIZE, reference=State.SIZE, fault=StartFault.SIZE
    ),
    entry(
        "rig.start", "judge_start", state=State.SIZE, reference=State.SIZE, fault=StartFault.SIZE
    ),
    entry("rig.start", "check_start_rope", fault=StartFault.SIZE),
    entry("rig.start", "is_elsewhere", before=State.SIZE, reference=State.SIZE),
    entry("numerics.noise", "seed_numbers", numbers=RandomState.SIZE),
    entry("numerics.noise", "next_uniform", numbers=RandomState.SIZE),
    entry(
        "numerics.noise", "turbulence_components", deviation=Vector.SIZE,
        numbers=RandomState.SIZE, components=("sines", Sinusoid.SIZE),
    ),
    entry(
        "numerics.noise", "noise_components", deviation=Vector.SIZE, numbers=RandomState.SIZE,
        components=("sines", Sinusoid.SIZE),
    ),
    entry(
        "rig.sensing", "measure_state", state=Coordinates.SIZE, sensors=Sensors.SIZE,
        numbers=RandomState.SIZE, measured=Coordinates.SIZE,
    ),
    entry(
        "rig.loop", "switch_correction", settings=(Settings.SIZE, Settings.COLUMNS),
        memory=(Memory.SIZE, Memory.COLUMNS),
    ),
    entry("rig.rig", "rig_rows", settings=(Settings.SIZE, Settings.COLUMNS)),
    entry(
        "rig.rig", "rig_start", settings=(Settings.SIZE, Settings.COLUMNS),
        components=("sines", Sinusoid.SIZE), changes=("changes", PayloadChange.SIZE),
        state=PlantState.SIZE, setpoints=Setpoints.SIZE, memory=(RIG_ROWS, Memory.COLUMNS),
    ),
    entry(
        "rig.rig", "rig_step", settings=(Settings.SIZE, Settings.COLUMNS),
        components=("sines", Sinusoid.SIZE), changes=("changes", PayloadChange.SIZE),
        table=("nodes", Observer.SIZE, Observer.COLUMNS),
        gains=("lengths", Gains.SIZE, Gains.COLUMNS), tracker=(Tracker.SIZE, Tracker.COLUMNS),
        setpoints=Setpoints.SIZE, memory=(RIG_ROWS, Memory.COLUMNS),
    ),
    entry(
        "rig.outputs", "rig_outputs", target=Target.SIZE, memory=(Memory.SIZE, Memory.COLUMNS),
        balance=Balance.SIZE, outputs=Outputs.SIZE,
    ),
    entry(
        "rig.outputs", "tracking_estimates", parameters=Tracking.SIZE,
        tracker=(Tracker.SIZE, Tracker.COLUMNS), estimates=Estimates.SIZE,
    ),
    entry("rig.rig", "rig_balance", memory=(Memory.SIZE, Memory.COLUMNS), balance=Balance.SIZE),
    entry("rig.rig", "rig_imbalance", balance=Balance.SIZE),
    entry(
        "rig.events", "rig_next_event", settings=(Settings.SIZE, Settings.COLUMNS),
        memory=(Memory.SIZE, Memory.COLUMNS),
    ),
    entry(
        "rig.exchange", "rig_event", settings=(Settings.SIZE, Settings.COLUMNS),
        changes=("changes", PayloadChange.SIZE), table=("nodes", Observer.SIZE, Observer.COLUMNS),
        gains=("lengths", Gains.SIZE, Gains.COLUMNS), tracker=(Tracker.SIZE, Tracker.COLUMNS),
        setpoints=Setpoints.SIZE, memory=(RIG_ROWS, Memory.COLUMNS),
    ),
    entry(
        "rig.exchange", "rig_signals", settings=(Settings.SIZE, Settings.COLUMNS),
        memory=(RIG_ROWS, Memory.COLUMNS),
    ),
    entry(
        "rig.exchange", "rig_rates", components=("sines", Sinusoid.SIZE), setpoints=Setpoints.SIZE,
        memory=(Memory.SIZE, Memory.COLUMNS), derivative=PlantState.SIZE,
    ),
    entry(
        "rig.partials", "rig_partials", components=("sines", Sinusoid.SIZE),
        memory=(Memory.SIZE, Memory.COLUMNS), work=(LoadPartials.SIZE, CranePartials.SIZE),
        partials=(RigPartials.SIZE, RigVariables.SIZE),
    ),
    entry(
        "crane._partials", "crane_load_partials", state=State.SIZE,
        partials=(LoadPartials.SIZE, State.SIZE),
    ),
    entry(
        "crane._partials", "crane_energy_partials", state=State.SIZE, masses=Masses.SIZE,
        partials=(Energies.SIZE, State.SIZE),
    ),
)


def _of_rooms() -> tuple[EntryPoint, ...]:
    """Those that rooms declare themselves."""
    rooms = sorted(p.parent.name for p in Path(__file__).parent.glob("*/entry_points.py"))
    modules = [import_module(f"segfmu.kernels.{room}.entry_points") for room in rooms]
    return tuple(point for module in modules for point in module.ENTRY_POINTS)


ENTRY_POINTS = (*_COMMON, *_of_rooms())
