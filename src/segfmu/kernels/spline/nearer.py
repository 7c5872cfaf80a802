"""Axes that have time stay near the path of their shortest profile.

An axis that moves at both waypoints and has time may have to turn back. Its ramps then lead farther
from the waypoints than its shortest profile does. A spline of the same duration need not.
"""

from segfmu.kernels.clearance.excursion import pieces_beyond
from segfmu.kernels.numerics.numbers import SAME
from segfmu.kernels.planner.phases import append_phase, is_resting, measure_phases
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import Axis, Cell, Interval, Place, Problem, WaypointState
from segfmu.kernels.planner.smoothly import is_turning
from segfmu.kernels.spline.motion import spline_share
from segfmu.kernels.spline.pieces import end_levels
from segfmu.kernels.spline.records import Derivatives, Level, Mesh, SplineWork
from segfmu.kernels.trajectory.expand import begin_state, expand_cell
from segfmu.kernels.trajectory.pieces import expand_phases

# of the path of the shortest profile, by which an axis may go farther
FARTHER = 0.01


def stay_near(
    axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]',
    planner: 'float[:,:]', expansion: 'float[:,:]', spline: 'float[:,:]',
) -> None:
    """Replace profiles of a plan that go farther than the shortest ones by splines, if any do not.

    axes and cells as `plan_phases` writes them; timing and coefficients are work space, as are
    planner (PlanWork rows), expansion (Expansion rows) and spline (SplineWork rows).
    """
    for i in range(cells.shape[0]):
        cell = cells[i, :, :]
        row = i % axes.shape[0]
        shortest = cell[Cell.RESULT, Interval.SHORTEST]
        if cell[Cell.RESULT, Interval.DURATION] <= shortest * (1.0 + SAME):
            continue
        if not is_resting(cell[Cell.PROBLEM, :], axes[row, :]) and may_turn(cell, axes[row, :]):
            bring_nearer(cell, axes[row, :], timing, coefficients, planner, expansion, spline)


def may_turn(cell: 'float[:,:]', axis: 'float[:]') -> bool:
    """Whether a profile of a cell, of two if it has two, goes both ways."""
    v = cell[Cell.PROBLEM, Problem.V]
    count = int(cell[Cell.RESULT, Interval.BELOW_COUNT])
    time, y, end, low, high = measure_phases(cell[Cell.BELOW:Cell.ABOVE, :], count, v, 0.0, axis)
    if is_turning(low, high):
        return True
    count = int(cell[Cell.RESULT, Interval.ABOVE_COUNT])
    time, y, end, low, high = measure_phases(cell[Cell.ABOVE:Cell.PROBLEM, :], count, v, 0.0, axis)
    return is_turning(low, high)


def bring_nearer(
    cell: 'float[:,:]', axis: 'float[:]', timing: 'float[:,:]', coefficients: 'float[:,:]',
    planner: 'float[:,:]', expansion: 'float[:,:]', spline: 'float[:,:]',
) -> None:
    """Replace the profile of a cell that goes farther than the shortest one by a spline, if any."""
    distance = cell[Cell.PROBLEM, Problem.DISTANCE]
    low = min(distance, 0.0)
    high = max(distance, 0.0)
    cell[Cell.PLACE, Place.POSITION] = 0.0
    cell[Cell.PLACE, Place.START] = 0.0
    count = expand_cell(cell, axis, timing, coefficients, 0, expansion)
    above = pieces_beyond(0, low, high, count, timing, coefficients, planner)
    below = pieces_beyond(1, low, high, count, timing, coefficients, planner)
    if max(above, below) <= FARTHER * (high - low):
        return
    # free until a spline is sought
    phases = spline[SplineWork.LEVELS:SplineWork.SIZE, :]
    count = shortest_profile(cell[Cell.PROBLEM, :], axis, phases, planner)
    if count <= 0:
        return
    begin_state(cell, expansion)
    count = expand_phases(phases, count, axis, timing, coefficients, 0, expansion)
    own_above = pieces_beyond(0, low, high, count, timing, coefficients, planner)
    own_below = pieces_beyond(1, low, high, count, timing, coefficients, planner)
    path = high - low + own_above + own_below
    if max(above - own_above, below - own_below) <= FARTHER * path:
        return
    first, last = spline[SplineWork.FIRST, :], spline[SplineWork.LAST, :]
    allowed = spline[SplineWork.ALLOWED, :]
    write_edges(cell, first, last)
    duration = cell[Cell.RESULT, Interval.DURATION] - cell[Cell.PLACE, Place.DELAY]
    # if possible, to neither side farther than the profile that is replaced
    for attempt in range(2):
        allowed[0] = low - own_below - FARTHER * path
        allowed[1] = high + own_above + FARTHER * path
        if attempt == 0:
            allowed[0] = max(allowed[0], low - max(own_below, below))
            allowed[1] = min(allowed[1], high + max(own_above, above))
        if spline_share(True, duration, first, last, allowed, axis, spline) <= 1.0:
            write_phases(duration, cell, axis, spline)
            return


def write_edges(cell: 'float[:,:]', first: 'float[:]', last: 'float[:]') -> None:
    """Write the states at both ends of a cell (Derivatives), from the first position on."""
    for i in range(Derivatives.SIZE):
        first[i] = 0.0
        last[i] = 0.0
    first[WaypointState.VELOCITY] = cell[Cell.PROBLEM, Problem.V]
    first[WaypointState.ACCELERATION] = cell[Cell.PROBLEM, Problem.A]
    last[WaypointState.POSITION] = cell[Cell.PROBLEM, Problem.DISTANCE]
    last[WaypointState.VELOCITY] = cell[Cell.PROBLEM, Problem.W]
    last[WaypointState.ACCELERATION] = cell[Cell.PROBLEM, Problem.B]


def write_phases(
    duration: float, cell: 'float[:,:]', axis: 'float[:]', spline: 'float[:,:]'
) -> None:
    """Write the spline as the phases of a cell, which take the room of two profiles."""
    scale = end_levels(duration, spline[SplineWork.FIRST, :], spline[SplineWork.LAST, :], spline)
    above = axis[Axis.SMOOTHNESS] - 1.0
    used = 0
    for i in range(Mesh.CELLS):
        level = scale * spline[SplineWork.LEVELS + i, Level.VALUE]
        used = append_phase(
            cell[Cell.BELOW:Cell.PROBLEM, :], used, duration / float(Mesh.CELLS), 0.0, level, 0.0,
            above,
        )
    cell[Cell.RESULT, Interval.BELOW_COUNT] = used
    cell[Cell.RESULT, Interval.ABOVE_COUNT] = 0.0
    cell[Cell.RESULT, Interval.WEIGHT] = 0.0
