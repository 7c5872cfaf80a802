"""A valid call of every entry point of the kernels, with arrays that are as large or larger."""

from __future__ import annotations

from dataclasses import astuple
from typing import Any

import numpy as np

from segfmu import Limits, Waypoint, plan
from segfmu.crane import Rig
from segfmu.crane.flat_model import GANTRY
from segfmu.crane.hook import HookCrane, HookWeights, design_hook
from segfmu.crane.observer import Uncertainty
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import (
    Box,
    Collision,
    Excursion,
    Part,
    Ranges,
    Space,
    SpaceFault,
    SpaceLimits,
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
)
from segfmu.kernels.crane.records import (
    BoundFault,
    BoundUses,
    Compensation,
    Contact,
    ContactWork,
    CranePartials,
    Demand,
    DemandPeaks,
    DemandWork,
    DriveBounds,
    FlatInverse,
    FlatSeries,
    FrictionSeries,
    LoadPartials,
    Plant,
    PlantFault,
    PlantState,
    PlantStatus,
    Report,
    Resistance,
    RopeBounds,
    RopeFault,
    RopeWork,
    State,
    Work,
)
from segfmu.kernels.hook.records import (
    HookAxis,
    HookDesign,
    HookFrequencies,
    HookInverse,
    HookLinks,
    HookMotion,
    HookOutputs,
    HookPath,
    HookState,
    SlingSeries,
)
from segfmu.kernels.limits.records import (
    AxisTask,
    Heading,
    LimitFault,
    LimitRow,
    Pace,
    Search,
    SearchValues,
    Starts,
    Unknown,
    Values,
)
from segfmu.kernels.numerics.records import RangeFault, Sinusoid
from segfmu.kernels.operation.records import (
    Command,
    Known,
    Operation,
    OperationMode,
    OperationRows,
    OperationWork,
    ReadyFault,
    Slot,
)
from segfmu.kernels.passage.records import Block, Link, Path, Spot, Stretch, Tools, Track
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
    Corrector,
    Energies,
    Loop,
    Memory,
    Outputs,
    RigPartials,
    RigVariables,
    Sensors,
    Setpoints,
    Settings,
    SetupFault,
    StartFault,
)
from segfmu.kernels.settling.records import LeadEnd, LeadRows, LeadTask, LeadWork, PlanPart
from segfmu.kernels.spline.records import Derivatives, Mesh, SplineWork
from segfmu.kernels.trajectory.records import (
    Brake,
    Expansion,
    Judging,
    MotionWork,
    PieceState,
    Spare,
    Timing,
)
from tests.kernels.rigs import HANGING, LAB, everything, feedback, observer, tracking
from tests.problems import packed_axis

Call = tuple[Any, ...]
SMOOTHNESS = 4


def zeros(*shape: int) -> np.ndarray:
    return np.zeros(shape)


def calls() -> dict[str, Call]:
    """The arguments by the names of the entry points."""
    return (
        planner_calls() | trajectory_calls() | crane_calls() | limit_calls() | passage_calls()
        | operation_calls()
        | control_calls() | rig_calls()
    )


def operation_calls() -> dict[str, Call]:
    """A stop of a plan that is for no command yet."""
    found = plan([Waypoint([0.0, 0.0, -1.0]), Waypoint([0.5, 0.3, -0.6])], Limits(1.0, 1.0, 5.0))
    used, width = int(found.offsets[-1]), 2 * SMOOTHNESS
    known, operation = zeros(Known.SIZE, Known.COLUMNS), zeros(Operation.SIZE, Operation.COLUMNS)
    known[Known.CRANE, :4] = LAB.masses
    known[Known.ROPE, RopeBounds.GRAVITY] = known[Known.SPACE, Space.GRAVITY] = 9.81
    known[Known.BOUNDS, DriveBounds.VELOCITY_MAX] = 2.0
    known[Known.BOUNDS, DriveBounds.ACCELERATION_MAX : DriveBounds.POWER_MAX] = 1.0
    known[Known.SPACE, Space.WORKSPACE_MIN : Space.WORKSPACE_MAX] = -2.0
    known[Known.SPACE, Space.WORKSPACE_MAX : Space.LOAD_SIZE] = 2.0
    backend.begin_operation(0.0, operation)
    operation[Operation.COMMAND, [Command.TIME, Command.MODE]] = 0.4, OperationMode.STOP
    limits = np.stack([found.limits.table(3, SMOOTHNESS)] * 2)
    timing = zeros(Slot.COUNT, OperationRows.ALL, Timing.SIZE)
    coefficients = zeros(Slot.COUNT, OperationRows.ALL, width)
    offsets = np.zeros(Slot.COUNT * Slot.OFFSETS, dtype=np.int64)
    timing[Slot.PRESENT, :used], coefficients[Slot.PRESENT, :used] = (
        found.timing, found.coefficients
    )
    offsets[: Slot.OFFSETS] = found.offsets
    work = zeros(OperationWork.SIZE, OperationWork.COLUMNS)
    swinging = operation.copy()
    swinging[Operation.COMMAND, Command.MEASURED : Command.SIZE] = [
        0.1, 0.2, 0.5, 0.1,
        -0.1,
        0.1, 0.0, 0.05, 0.2, 0.1,
    ]
    return {
        "begin_operation": (0.0, operation.copy()),
        "operate": (
            operation, limits, known, timing, coefficients, offsets,
            zeros(2, 3, SMOOTHNESS + 1), zeros(3, Cell.SIZE, Cell.COLUMNS),
            zeros(LeadWork.SIZE, LeadWork.COLUMNS), work.copy(),
            zeros(Stack.ROWS, Span.SIZE, 2 * width - 3),
        ),
        "take_over_measured": (
            swinging, known, timing.copy(), coefficients.copy(), offsets.copy(), work.copy(),
            zeros(Stack.ROWS, Span.SIZE, 2 * width - 3),
        ),
        "foresee_emergency": (operation, known, timing, coefficients, offsets, work.copy()),
        "check_ready": (
            zeros(Compensation.SIZE), zeros(Resistance.SIZE), 9, zeros(ReadyFault.SIZE),
        ),
        "next_operation": (operation,),
        "keeps_drives": (found.timing, found.coefficients, found.offsets, known, work),
    }


def planner_calls() -> dict[str, Call]:
    bounds = [1.0, 0.5, 10.0, 20.0, 0.0]
    axis = packed_axis(SMOOTHNESS, 1, bounds)
    boundary, work = zeros(Problem.SIZE), zeros(PlanWork.SIZE, PlanWork.COLUMNS)
    boundary[Problem.DISTANCE] = 1.0
    phases = zeros(Cell.ABOVE, Phase.SIZE)
    count = backend.shortest_profile(boundary, axis, phases, work)
    duration = float(phases[:, Phase.DURATION].sum())
    cell = zeros(Cell.SIZE, Cell.COLUMNS)
    cell[Cell.PROBLEM, : Problem.SIZE] = boundary
    states, dwells, limits = moves()
    options, axes, cells = plan_arrays()
    refusal = zeros(Refusal.SIZE)
    rows, width = 7 * count, 2 * SMOOTHNESS
    expansion = zeros(Expansion.SIZE, Expansion.COLUMNS)
    planned = axes.copy(), cells.copy()
    lower = 0.8 * limits[:, : Lower.SIZE]
    backend.plan_phases(states, dwells, limits, lower, options, *planned, work)
    pieces = backend.count_pieces(*planned)
    motion = zeros(MotionWork.SIZE, MotionWork.COLUMNS)
    motion[MotionWork.OPTIONS, : PlanOptions.SIZE] = options
    motion[MotionWork.JUDGING, : Judging.SIZE] = 1e-9, 5e-10
    written = (
        zeros(pieces, Timing.SIZE), zeros(pieces, width), np.zeros(3, dtype=np.int64),
        zeros(4, 2), motion,
    )
    return {
        "plan_motion": (states, dwells, limits, lower, axes.copy(), cells.copy(), *written),
        "expand_motion": (states, dwells, limits, lower, *planned, *written),
        "axis_limits": (SMOOTHNESS, 1, np.array(bounds), zeros(Axis.SIZE)),
        "ramp_parameters": (0.1, axis.copy(), zeros(2, 12)),
        "ramp_duration": (0.3, axis),
        "ramp_pieces": (axis,),
        "measure_phases": (phases, count, 0.0, 0.0, axis),
        "shortest_profile": (boundary, axis, zeros(Cell.ABOVE, Phase.SIZE), work.copy()),
        "timed_profile": (2.0 * duration, axis, cell, work.copy()),
        "check_problem": (states, limits, refusal),
        "motion_scale": (0, states.copy(), limits),
        "settle_states": (0, states.copy(), limits, lower),
        "settle_dwells": (0.1, dwells.copy()),
        "plan_phases": (states, dwells, limits, lower, options, axes, cells, work.copy()),
        "count_pieces": planned,
        "expand_phases": (
            phases, count, axis, zeros(rows, Timing.SIZE), zeros(rows, width), 0, expansion,
        ),
        **spline_calls(axis),
    }


def spline_calls(axis: np.ndarray) -> dict[str, Call]:
    """Calls of the kernels of splines."""
    first, last = np.zeros((2, Derivatives.SIZE))
    first[WaypointState.VELOCITY], last[WaypointState.POSITION] = -0.1, 0.3
    search = 3.0, first, last
    sought = zeros(SplineWork.SIZE, SplineWork.COLUMNS)
    found = sought.copy()
    share = backend.spline_share(True, *search, np.array([-0.2, 0.5]), axis, found)
    assert share < 1.0
    state = zeros(PieceState.SIZE)
    state[: SMOOTHNESS + 1] = first[: SMOOTHNESS + 1]
    pieces = zeros(Mesh.CELLS, Timing.SIZE), zeros(Mesh.CELLS, 2 * SMOOTHNESS)
    return {
        "spline_share": (True, *search, np.array([-0.2, 0.5]), axis, sought),
        "append_spline": (*search, *pieces, 0, state, found),
    }


def moves() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """States, dwells and limits of two axes that pass a waypoint."""
    states = zeros(3, 2, WaypointState.SIZE)
    states[1, :, WaypointState.POSITION] = 0.4, 0.3
    states[1, :, WaypointState.VELOCITY] = 0.2, 0.1
    states[2, :, WaypointState.POSITION] = 1.0, 0.5
    limits = np.array([[1.0, 0.5, 10.0, 20.0, 0.0], [0.8, 0.4, 5.0, 30.0, 0.0]])
    return states, np.array([0.0, 0.0, 0.2]), limits


def plan_arrays() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Options, and axes and cells that are not filled in."""
    options = zeros(PlanOptions.SIZE)
    options[PlanOptions.SMOOTHNESS], options[PlanOptions.SHAPE] = SMOOTHNESS, 1
    options[PlanOptions.SYNCHRONIZATION] = 1
    return options, zeros(2, Axis.SIZE), zeros(4, Cell.SIZE, Cell.COLUMNS)


def onward_calls(lead: np.ndarray) -> dict[str, Call]:
    """Two axes that move, on to a waypoint and to rest; lead as for `judge_pieces`."""
    points, dwells, limits = moves()
    options, _, cells = plan_arrays()
    states = zeros(6, 2, LeadEnd.SIZE)
    states[:3, :, : WaypointState.SIZE] = points
    states[0, :, 1:4] = [0.3, 0.1, 0.2], [-0.2, 0.0, 0.1]
    lead[LeadWork.OPTIONS, : PlanOptions.SIZE] = options
    rows = 2 * LeadRows.PIECES + LeadRows.ALL
    return {
        "plan_onward": (
            states, dwells, limits, zeros(2, Lower.SIZE), zeros(4, Axis.SIZE), cells,
            zeros(PlanPart.COUNT, rows, Timing.SIZE), zeros(PlanPart.COUNT, rows, 2 * SMOOTHNESS),
            np.zeros(3 * PlanPart.COUNT, dtype=np.int64), zeros(4, 2), lead,
        ),
    }


def trajectory_calls() -> dict[str, Call]:
    points = [Waypoint([0.0, 0.0, -1.0]), Waypoint([0.5, 0.3, -0.6]), Waypoint([0.1, 0.0, -0.5])]
    limits = Limits([1.0, 0.4, 0.5], [1.0, 0.5, 12.0], [10.0, 9.0, 400.0])
    found = plan(points, limits, smoothness=SMOOTHNESS)
    pieces = found.timing, found.coefficients, found.offsets
    ends, times = found.axis_durations, found.axis_waypoint_times
    states = zeros(3, 3, WaypointState.SIZE)
    states[:, :, WaypointState.POSITION] = [p.position for p in points]
    bounds = np.stack([limits.velocity, limits.acceleration, limits.jerk], axis=1)
    rope = zeros(RopeWork.SIZE, 8 * SMOOTHNESS - 5)
    rows, width = len(found.timing), 2 * SMOOTHNESS
    spans = zeros(rows + 1, Span.SIZE, 2 * width - 3)
    count = backend.clearance_spans(*pieces, 9.81, rope.copy(), spans)
    stack = zeros(Stack.ROWS, Span.SIZE, 2 * width - 3)
    ranges = zeros(Ranges.SIZE, 3)
    backend.path_ranges(*pieces, 9.81, zeros(2, width), ranges)
    # one is met by the rope alone
    boxes = zeros(2, Box.SIZE)
    boxes[:, Box.LOAD_LOW:Box.ROPE] = np.tile([0.2, 0.0, -0.3, 0.3, 0.3, -0.2], 2)
    boxes[0, Box.LOAD_LOW:Box.ROPE] += 9.0
    boxes[:, Box.ROPE] = 1.0
    space = np.repeat([9.81, -1e9, 1e9, 0.1, 0.0, 2.0], [1, 3, 3, 3, 3, 1])
    obstacles = np.array([[9.0, 9.0, 0.0, 9.5, 9.5, 1.0, 0.1, 1.0], [0.2, 0.0, -0.3, 0.3, 0.3,
                           -0.2, 0.1, 1.0]])
    lead = zeros(LeadWork.SIZE, LeadWork.COLUMNS)
    lead[LeadWork.NOW, 1] = 0.3
    starts = zeros(3, SMOOTHNESS + 1)
    starts[:, 1] = 0.3, -0.2, 0.1
    lead[LeadWork.TASK, : LeadTask.BRAKES + 1] = 1.0, -1.0, 1.0, 1.0
    lead[LeadWork.JUDGING, : Judging.SIZE] = 1e-9, 5e-10
    none = np.zeros(4, dtype=np.int64), zeros(1, Timing.SIZE), zeros(1, width)
    most = 1 + 3 * LeadRows.PIECES + LeadRows.ALL
    leading = np.tile([1.0, 0.5, 10.0, 20.0, 0.0], (3, 1))
    leads = zeros(LeadRows.ALL, Timing.SIZE), zeros(LeadRows.ALL, width)
    return {
        "find_leads": (
            np.stack([starts, zeros(3, SMOOTHNESS + 1)]), leading, zeros(3, Lower.SIZE), *none,
            zeros(3, LeadEnd.SIZE), lead, zeros(most, Timing.SIZE), zeros(most, width),
            np.zeros(4, dtype=np.int64),
        ),
        **onward_calls(lead.copy()),
        "judge_pieces": (
            states, np.vstack([times, ends]), *pieces, found.limits.table(3, SMOOTHNESS),
            zeros(3, Lower.SIZE), zeros(3, Brake.SIZE), lead.copy(),
            *(array.copy() for array in leads),
        ),
        "plan_ends": (*pieces, zeros(3, DelayedState.SIZE)),
        "are_at_velocities": (
            starts, leading, np.hstack([starts[:, :3], zeros(3, DelayedState.SIZE - 3)])
        ),
        "find_brakes": (
            starts, leading, zeros(3, Lower.SIZE), zeros(3, Brake.SIZE), lead.copy(),
            *(array.copy() for array in leads),
        ),
        "find_brake": (
            False, np.array([0.2, 0.5, 10.0, 20.0, 0.0]), lead.copy(),
            *(array.copy() for array in leads),
        ),
        "cut_plan": (
            0.3, *pieces, zeros(rows + 4, Timing.SIZE), zeros(rows + 4, width),
            np.zeros(4, dtype=np.int64),
        ),
        "anchor_plan": (
            zeros(3, 1), bounds, found.timing, found.coefficients.copy(), found.offsets,
        ),
        "meet_ends": (9.0, 0.5, found.timing.copy(), found.offsets),
        "join_plans": (
            *pieces, *pieces, zeros(2 * rows, Timing.SIZE), zeros(2 * rows, width),
            np.zeros(4, dtype=np.int64),
        ),
        "state_scale": (1, 4.0, np.array([1e9, 2.0, 5.0, 20.0, 0.0])),
        "check_rope": (*pieces, np.array([9.81, 0.2, 2.0]), rope, zeros(RopeFault.SIZE)),
        "check_hook": (
            *pieces, np.array([2.0, 2.0, 2.0]), np.array(LAB.masses), 0.2, 0.3,
            np.array([9.81, 0.2, 2.0]), rope.copy(), zeros(HookPath.SIZE, HookPath.COLUMNS),
            zeros(RopeFault.SIZE),
        ),
        "clearance_spans": (*pieces, 9.81, rope.copy(), spans.copy()),
        "contact_times": (
            Part.ROPE, 1e300, count, boxes[1].copy(), spans, stack, zeros(8, 2), zeros(3),
        ),
        "path_ranges": (*pieces, 9.81, zeros(2, width), zeros(Ranges.SIZE, 3)),
        "first_contact": (
            *pieces, 9.81, boxes.copy(), rope.copy(), stack.copy(), ranges.copy(), True,
            zeros(Collision.SIZE),
        ),
        "path_excursion": (
            np.ones((3, 3)), np.array([p.position for p in points]), times, *pieces,
            rope.copy(), zeros(Excursion.SIZE),
        ),
        "leaves_range": (2, 0.1, 0.9, -0.01, 0.01, *pieces, rope.copy(), zeros(Excursion.SIZE)),
        "shrink_boxes": (1e-9, boxes.copy()),
        "write_box": (space, obstacles[0].copy(), zeros(Box.SIZE)),
        "space_contact": (
            *pieces, space, obstacles, zeros(2 + SpaceLimits.FACES, Box.SIZE), rope.copy(),
            stack.copy(), ranges.copy(), True, zeros(SpaceFault.SIZE),
        ),
        "evaluate": (np.linspace(-0.1, 9.0, 20), *pieces, ends, 2, zeros(20, 3)),
        "evaluate_orders": (0.4, *pieces, ends, zeros(5, 3)),
        "next_plan_event": (0.4, 0.1, found.timing, found.offsets, ends, times),
        "right_of_break": (0.4, 0.1, found.timing, found.offsets, ends),
        "same_break": (3.0,),
    }


def limit_calls() -> dict[str, Call]:
    """Of a search for limits from waypoint to waypoint, of which the first one is free."""
    points = np.array([[0.0, 0.0, -1.0], [1.0, 0.5, -0.8], [2.0, 1.5, -1.2]])
    rest, bounds, known = zeros(3, 3), zeros(DriveBounds.SIZE), zeros(Resistance.SIZE)
    bounds[DriveBounds.VELOCITY_MAX : DriveBounds.POWER_MAX] = 0.6
    bounds[DriveBounds.VELOCITY_MIN] = -0.4
    known[: Resistance.VISCOUS] = 2.0, 1.0, 1.0, 9.81
    caps, axes = zeros(3, LimitRow.SIZE), zeros(3, AxisTask.SIZE)
    backend.write_axes(False, points, rest, rest, bounds, caps, known, axes)
    starts, fault = zeros(Starts.COUNT, 24), zeros(LimitFault.SIZE)
    backend.write_starts(1.2, bounds, known, axes, starts, fault)
    kinds = np.repeat([float(Unknown.LIMIT), float(Unknown.STATE)], [18, 6])
    search, peaks = zeros(Search.SIZE, 24), np.linspace(0.0, 0.7, 2 * Demand.SIZE)
    peaks = peaks.reshape(2, -1)
    backend.begin_limits(starts, kinds, search)
    work = zeros(SearchValues.SIZE, Values.SIZE), zeros(24, Values.SIZE), zeros(48, 24)
    states, place = zeros(3, 3, WaypointState.SIZE), np.arange(3.0)
    states[:, :, WaypointState.POSITION] = points
    states[1, :, WaypointState.VELOCITY] = np.nan
    heading = zeros(Heading.SIZE)
    backend.write_heading(points, heading)
    return {
        "begin_pace": (1.0, 0.999, zeros(Pace.SIZE)),
        "next_pace": (1.4, np.array([0.8, 1.0, 0.999, 0.5, 1.0, 0.7, 1.9, 1.0, 1.9, 2.0])),
        "write_axes": (False, points, rest, rest, bounds, caps, known, axes.copy()),
        "narrow_bounds": (bounds.copy(), caps + 1.0),
        "write_kinds": (axes, kinds.copy()),
        "write_limits": (starts[0].copy(), axes, zeros(3, LimitRow.SIZE)),
        "write_shares": (peaks, bounds, axes, zeros(2 * Demand.SIZE)),
        "write_starts": (1.2, bounds, known, axes, starts.copy(), fault),
        "write_passing": (points, kinds, axes, heading, starts[0].copy()),
        "write_heading": (points, heading.copy()),
        "unite_waypoints": (states.copy(), zeros(3)),
        "write_free": (
            states.copy(), place, zeros(3), heading, kinds.copy(), zeros(3, 3),
        ),
        "write_states": (
            starts[0].copy(), kinds, zeros(3, LimitRow.SIZE), place, heading, states.copy(),
        ),
        "begin_limits": (starts, kinds, search.copy()),
        "next_limits": (5.0, peaks.ravel().copy(), starts, search.copy(), *work),
        "is_judged": (5.0, peaks.ravel().copy(), search.copy()),
        "cap_best": (axes, search.copy()),
        "write_best": (0.9, search.copy()),
        "keep_best": (0.9, search.copy()),
    }


def passage_calls() -> dict[str, Call]:
    """Of the choice of a free waypoint between two at rest."""
    points, width = 3, 2 * SMOOTHNESS
    states = zeros(points, 2, WaypointState.SIZE)
    states[:, :, WaypointState.POSITION] = [[0.0, 0.0], [1.0, 0.4], [2.0, 1.0]]
    states[1, :, WaypointState.VELOCITY :] = np.nan
    limits = np.tile([1.0, 1.0, 4.0, 20.0, *[0.0] * (SMOOTHNESS - 3)], (2, 1))
    work, tools = zeros(MotionWork.SIZE, MotionWork.COLUMNS), zeros(Tools.SIZE, Tools.COLUMNS)
    work[MotionWork.OPTIONS, : PlanOptions.SIZE] = SMOOTHNESS, 1.0, 1.0, 0.0, 0.0
    tools[Tools.PATH, Path.SHARE] = 0.25
    choice, place = zeros(Block.COUNT * points, 2, WaypointState.SIZE), zeros(points)
    axes, spots = zeros(2, Track.SIZE), zeros(2 * points, Spot.SIZE, Spot.COLUMNS)
    begun = (
        states, zeros(points), limits, 0.8 * limits[:, : Lower.SIZE],
        np.tile([-9.0, 9.0], (2, 1)), choice, place, tools, axes, spots, work,
    )
    backend.begin_choice(*begun)
    found = tools.copy()
    backend.next_passage(found, spots)
    rows, links = 2 * Spare.ROWS, 2 * (points - 1)
    return {
        "usual_room": (),
        "begin_choice": begun,
        "next_passage": (tools.copy(), spots),
        "choose_passage": (
            choice.copy(), found, axes, spots, zeros(links, Link.SIZE, Link.COLUMNS),
            zeros(points, Stretch.SIZE), zeros(4 * points, 9),
            zeros(links, Cell.SIZE, Cell.COLUMNS), zeros(rows, Timing.SIZE), zeros(rows, width),
            work.copy(),
        ),
        "end_choice": (states.copy(), place, choice, tools.copy(), axes.copy()),
    }


def crane_calls() -> dict[str, Call]:
    rig = everything()
    plant = rig.parameters(LAB, True)
    found = plan([Waypoint([0.0, 0.0, -1.0]), Waypoint([0.5, 0.3, -0.6])], Limits(1.0, 1.0, 5.0))
    planned = found.timing, found.coefficients, found.offsets, found.axis_durations
    rows = zeros(2, Contact.SIZE)
    rows[:, Contact.TIME] = 0.0, 0.3
    rows[:, Contact.SETTLED] = 0.2, 0.9
    masses, state = np.array(LAB.masses), np.append(HANGING, zeros(PlantState.SIZE - State.SIZE))
    state[State.ANGLE] = 0.1
    hook = np.append(masses, [0.2, 0.3])
    flat = zeros(8, 3)
    flat[0], flat[2] = (0.1, 0.2, -1.0), (0.3, 0.2, 0.1)
    work = zeros(Work.SIZE, Work.COLUMNS)
    work[Work.COMMAND, :3] = 0.1
    force, axes, derivative = zeros(5), np.array([0.1, 0.2, 0.3]), zeros(State.SIZE)
    components = rig.wind.components
    return {
        "plant_failure": (
            PlantStatus.BELOW_TRAVEL + 1, 0.5, state, plant, zeros(PlantFault.SIZE),
        ),
        "crane_rhs": (state, force, axes, masses, derivative),
        "crane_driven": (state, axes, force, axes, masses, derivative.copy(), zeros(3)),
        "crane_flat_inverse": (flat, masses, zeros(3), zeros(State.SIZE), zeros(5)),
        "flat_orders": (plant[: Resistance.SIZE].copy(),),
        "drive_demands": (
            np.stack([flat[:5], flat[:5]]), np.array([0.0, 1.0]), plant[: Resistance.SIZE].copy(),
            np.stack([rows] * 3), zeros(DemandWork.SIZE, DemandWork.COLUMNS), zeros(2, Demand.SIZE),
        ),
        **{
            name: (
                *planned, plant[: Resistance.SIZE].copy(), np.stack([rows] * 3),
                zeros(DemandPeaks.SIZE, DemandPeaks.COLUMNS), zeros(2, Demand.SIZE),
                zeros(2, Demand.SIZE),
            )
            for name in ("demand_peaks", "demand_samples")
        },
        "bound_uses": (
            np.linspace(0.0, 2.0, 2 * Demand.SIZE).reshape(2, -1), zeros(2, Demand.SIZE) + 0.5,
            np.where(np.arange(DriveBounds.SIZE) < DriveBounds.FORCE_MIN, 1.1, -0.7),
            zeros(BoundUses.SIZE), zeros(BoundFault.SIZE),
        ),
        "has_bounds": (2, Demand.SIZE, zeros(DriveBounds.SIZE) + 0.5),
        "paced_use": (np.linspace(0.0, 1.0, BoundUses.SIZE),),
        "contact_history": (
            1, *planned, plant[: Resistance.SIZE].copy(),
            zeros(ContactWork.SIZE, ContactWork.COLUMNS), zeros(9, Contact.SIZE),
        ),
        "resists": (plant[: Resistance.SIZE].copy(), 1),
        "planned_friction": (plant[: Resistance.SIZE].copy(), 1, 0.4, 0.3, 0.1, rows),
        "next_contact_event": (0.4, 0.1, rows),
        "friction_derivative": (
            plant[: Resistance.SIZE].copy(), 1, 0.4, np.array([0.3, 1e-3, 0.2, 0.1, 0.5]), 3, rows,
            zeros(FrictionSeries.SIZE, 4),
        ),
        "flat_derivatives": (
            flat, 2, masses, zeros(FlatSeries.SIZE, 5), zeros(FlatInverse.SIZE),
        ),
        "hook_derivatives": (
            flat, 1, masses, 0.2, 0.3, zeros(SlingSeries.SIZE, 6), zeros(HookInverse.SIZE),
        ),
        "hook_frequencies": (0.5, hook, zeros(HookFrequencies.SIZE)),
        "hook_load_motion": (
            np.linspace(0.1, 1.4, HookState.SIZE), np.array([-15.0, 2.0]), hook,
            zeros(HookLinks.SIZE, HookLinks.COLUMNS), zeros(HookMotion.SIZE, HookMotion.COLUMNS),
        ),
        "crane_load": (state, zeros(2, 3)),
        "crane_energy": (state, masses, zeros(Energies.SIZE)),
        "plant_advance": (
            plant, components, 0.0, state.copy(), 0.01, 1e-9, work, zeros(Report.SIZE),
        ),
        "crane_load_partials": (state, zeros(LoadPartials.SIZE, State.SIZE)),
        "crane_energy_partials": (state, masses, zeros(Energies.SIZE, State.SIZE)),
        "seed_numbers": (7, zeros(2)),
        "next_uniform": (np.array([12.0, 34.0]),),
        "turbulence_components": (
            8.0, 1200.0, 1.0, axes, np.array([12.0, 34.0]), zeros(4, Sinusoid.SIZE),
        ),
        "noise_components": (
            2.0, axes, np.array([12.0, 34.0]), zeros(4, Sinusoid.SIZE),
        ),
    }


def control_calls() -> dict[str, Call]:
    watcher, gains = observer(False), feedback(False).table
    controller = tracking(False)
    plant = zeros(Plant.SIZE)
    plant[: len(LAB.masses)] = LAB.masses
    random = np.random.default_rng(2)
    state, estimate = random.uniform(0.1, 0.5, State.SIZE), random.uniform(-0.1, 0.1, (3, 6))
    expected = Uncertainty()
    steps = expected.vector
    steps[:3] = 1e-4, 1e-4, 1e-3
    lengths = np.array([0.3, 0.6])
    tables = zeros(2, Gains.SIZE, Gains.COLUMNS), zeros(2, Observer.SIZE, Observer.COLUMNS)
    kalman = zeros(Kalman.SIZE, 2 * AxisModel.SIZE)
    tracked = zeros(TrackingDesign.SIZE)
    tracked[: expected.vector.size] = expected.vector
    tracked[TrackingDesign.PAYLOAD_TIME] = 3.0
    parameters = zeros(Tracking.SIZE)
    parameters[Tracking.PERIOD] = 0.01
    tick = zeros(Tick.SIZE, Tick.COLUMNS)
    tick[Tick.REFERENCE, : State.SIZE], tick[Tick.SIGNALS, :5] = HANGING, HANGING[:5] + 0.01
    design = np.array([0.01, 1.3, 3.0, 0.8, 0.005])
    assert design.size == FlatDesign.SIZE
    return {
        "feedback_correction": (state, HANGING, zeros(3), gains, zeros(3)),
        "feedback_bandwidth": (1.3, 0.5, 9.81, 0.02, 0.25),
        "set_tracking": (plant, tracked, 1.0, parameters),
        "set_fading": (parameters.copy(),),
        "signal_age": (0.006, 0.01, 0.02),
        "set_steps": (np.linspace(0.0, 1e-3, Sensors.SIZE), 1.0, expected.vector),
        "drive_bound": (plant, 1, -1.0),
        "set_drives": (plant, zeros(Tracking.SIZE)),
        "set_walks": (plant, expected.vector),
        "check_gains": (
            plant, 0.01, 0, np.array([0.3, 0.9]), gains,
            zeros(LoopWork.SIZE, LoopWork.COLUMNS), zeros(SetupFault.SIZE),
        ),
        "rope_range": (0.5, 0.2, 1.0, zeros(RopeRange.SIZE)),
        "table_lengths": (0.2, 1.0, 4, zeros(4)),
        "flat_table": (plant, design, 2, lengths, tables[0]),
        "observer_table": (
            plant, 0.01, steps, 2, lengths, zeros(Expected.SIZE), kalman, tables[1],
        ),
        "feedback_gains": (plant, 0.5, 2.0, 2.5, 9.0, 0.8, zeros(Gains.SIZE, Gains.COLUMNS)),
        "observer_design": (
            plant, 0.01, 0.5, np.array([1e-4, 1e-4, 1e-3, 3.0, 1.0]), kalman.copy(),
            zeros(Observer.SIZE, Observer.COLUMNS),
        ),
        "observer_predict": (
            1, 0.5, watcher.table, 0.2, 0.3, estimate[1].copy(), zeros(AxisModel.SIZE),
        ),
        "observer_correct": (0.5, watcher.table, state, HANGING, estimate[:, : Estimate.SIZE]),
        "track_setpoint": (
            controller.parameters, watcher.table, gains, tick, zeros(Tracker.SIZE, Tracker.COLUMNS),
        ),
        "tracking_estimates": (
            controller.parameters, zeros(Tracker.SIZE, Tracker.COLUMNS), zeros(Estimates.SIZE),
        ),
    }


def rig_calls() -> dict[str, Call]:
    rig, controller = everything(), tracking(True)
    settings = zeros(Settings.SIZE, Settings.COLUMNS)
    settings[Settings.LOOP, Loop.CORRECTOR] = Corrector.TRACKING
    settings[Settings.LOOP, Loop.PERIOD] = controller.sample_time
    settings[Settings.LOOP, Loop.ENABLED] = 1.0
    settings[Settings.LOOP, Loop.TOLERANCE] = 1e-8
    settings[Settings.SENSORS, : Sensors.SIZE] = rig.sensors.vector
    settings[Settings.PLANT, : Plant.SIZE] = rig.parameters(LAB, True)
    # partial derivatives of velocity drives ask for lags
    settings[Settings.PLANT, Plant.LAG : Plant.LAG + 3] = 0.01
    settings[Settings.TRACKING, : Tracking.SIZE] = controller.parameters
    components, changes = rig.wind.components, rig.changes
    memory = zeros(backend.rig_rows(settings), Memory.COLUMNS)
    setpoints = zeros(Setpoints.SIZE)
    setpoints[Setpoints.REFERENCE : Setpoints.REFERENCE + State.SIZE] = HANGING
    start = GANTRY.kept(HANGING)
    backend.rig_start(settings, components, changes, start, setpoints, 0.2, memory)
    _, table, gains, tracker = controller.arrays
    fault, balance = zeros(SetupFault.SIZE), zeros(Balance.SIZE)
    hanging = HookCrane(LAB, 0.1, 0.3)
    hooked = Rig().parameters(hanging, True)
    hook_table = design_hook(hanging, sample_time=0.01, shortest=0.2, longest=1.2).table
    tables = table, gains, tracker
    partials = zeros(RigPartials.SIZE, RigVariables.SIZE)
    return {
        "check_travel": (np.array([-1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0]), fault),
        "nominal_payload": (0.0, 1.0),
        "start_state": (HANGING, HANGING + 0.1, HANGING + 0.2, zeros(State.SIZE)),
        "check_start": (HANGING, HANGING, zeros(StartFault.SIZE)),
        "judge_start": (HANGING, HANGING + 0.3, 9.81, zeros(StartFault.SIZE)),
        "check_start_rope": (0.5, 0.6, 1.0, zeros(StartFault.SIZE)),
        "is_elsewhere": (HANGING, HANGING + 0.1, 0.01),
        "check_lengths": (np.array([0.2, 1.0]), fault.copy()),
        "check_range": (3.0, 1.0, 2.0, zeros(RangeFault.SIZE)),
        "begin_time": (3.0, 1.0),
        "check_lags": (settings[Settings.PLANT].copy(), 1, fault.copy()),
        "check_friction": (np.array([2.0, 0.0, 0.0]), np.ones(3), fault.copy()),
        "wind_speed": (np.array([3.0, 4.0, 0.0]),),
        "check_turbulence": (zeros(3), np.array([0.0, 1.0, 0.0]), fault.copy()),
        "check_changes": (np.array([[1.0, 2.0], [1.0, 3.0]]), fault.copy()),
        "check_slack": (settings[Settings.PLANT].copy(), 1, fault.copy()),
        "check_delays": (settings[Settings.PLANT].copy(), 0.01, 0, fault.copy()),
        "check_sensors": (settings[Settings.SENSORS].copy(), fault.copy()),
        "check_rope_bounds": (1.0, 2.0, 1.5, fault.copy()),
        "measure_state": (HANGING, rig.sensors.vector, np.array([12.0, 34.0]), zeros(5)),
        "switch_correction": (settings, memory),
        "rig_rows": (settings,),
        "rig_start": (settings, components, changes, start, setpoints, 0.2, memory),
        "rig_step": (settings, components, changes, *tables, setpoints, 0.02, memory),
        "rig_outputs": (np.array([0.1, 0.2, -1.0]), memory, balance, zeros(Outputs.SIZE)),
        "hook_design": (
            hooked, 0.01, 0.5, np.array(astuple(HookWeights())),
            zeros(HookDesign.SIZE, 2 * HookAxis.CORRECTION), hook_table[0].copy(),
        ),
        "hook_correction": (
            hook_table, np.append(np.repeat([-1.0, 1.0, -2.0, 2.0], 3), 0.01),
            HANGING[:5] + 0.01, HANGING, zeros(3), zeros(4, HookAxis.SIZE), zeros(3),
        ),
        "hook_outputs": (memory, zeros(HookOutputs.SIZE)),
        "rig_balance": (memory, balance.copy()),
        "rig_imbalance": (np.arange(1.0, 1.0 + Balance.SIZE),),
        "rig_next_event": (settings, memory),
        "rig_event": (settings, changes, *tables, setpoints, 0.0, memory),
        "rig_signals": (settings, 0.01, memory),
        "rig_rates": (components, setpoints, 0.001, memory, zeros(PlantState.SIZE)),
        "rig_partials": (
            components, 0.001, memory, zeros(LoadPartials.SIZE, CranePartials.SIZE), partials,
        ),
    }
