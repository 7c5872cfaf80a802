"""The planner's durations with states, and whether it leaves the boxes.

Cells, axes and work as for `plan_motion`; all axes meet in the waypoints. timing (rows, Timing) and
coefficients (rows, 2 n) hold the pieces of a cell and the spare rows. Rises are the usual ones:
steeper ones would be those of the whole axis.
"""

from math import exp

from segfmu.kernels.clearance.excursion import pieces_beyond
from segfmu.kernels.numerics.numbers import EQUAL, NEVER
from segfmu.kernels.passage.records import Link, Path, Stretch
from segfmu.kernels.planner.intervals import common_duration, set_duration, set_shortest
from segfmu.kernels.planner.parameters import axis_limits, ramp_parameters, usual_share
from segfmu.kernels.planner.plan import set_problems
from segfmu.kernels.planner.plan_axis import note_shortest
from segfmu.kernels.planner.records import Cell, Interval, Place, PlanOptions, WaypointState
from segfmu.kernels.planner.sides import set_lower
from segfmu.kernels.trajectory.expand import expand_cell
from segfmu.kernels.trajectory.records import MotionWork

# a profile keeps up with the path if it takes at most this much longer
KEPT_UP = 1.005


def set_axes(
    limits: 'float[:,:]', lower: 'float[:,:]', axes: 'float[:,:]', work: 'float[:,:]'
) -> bool:
    """Write the parameters of all axes; False if a ramp has no limit."""
    planner = work[MotionWork.PLAN:MotionWork.EXPANSION, :]
    smoothness = int(work[MotionWork.OPTIONS, PlanOptions.SMOOTHNESS])
    shape = int(work[MotionWork.OPTIONS, PlanOptions.SHAPE])
    for axis in range(axes.shape[0]):
        axis_limits(smoothness, shape, limits[axis, :], axes[axis, :])
        set_lower(lower[axis, :], axes[axis, :])
        if not ramp_parameters(usual_share(axes[axis, :]), axes[axis, :], planner):
            return False
    return True


def plan_alone(
    place: int, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> bool:
    """Write the shortest profile of an axis in an interval; False if it has none."""
    cell = cells[place * axes.shape[0] + axis, :, :]
    planner = work[MotionWork.PLAN:MotionWork.EXPANSION, :]
    status, duration = set_shortest(cell, axes[axis, :], planner)
    if status < 0:
        return False
    note_shortest(duration, axes[axis, :], cell)
    return True


def least_length(
    place: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> float:
    """The longest of the axes' shortest durations in an interval [s]; NEVER: one has none."""
    longest = 0.0
    for axis in range(axes.shape[0]):
        if not plan_alone(place, axis, axes, cells, work):
            return NEVER
        longest = max(longest, shortest_of(place, axis, axes, cells))
    return longest


def common_length(
    most: float, place: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> float:
    """The duration of an interval [s], whose shortest ones are known; NEVER: none up to `most`."""
    first = place * axes.shape[0]
    planner = work[MotionWork.PLAN:MotionWork.EXPANSION, :]
    found = common_duration(0.0, most, 0.0, first, first + axes.shape[0], axes, cells, planner)
    return NEVER if found < 0.0 else found


def meet_at(
    duration: float, place: int, axes: 'float[:,:]', cells: 'float[:,:,:]', work: 'float[:,:]'
) -> bool:
    """Whether all axes can take a duration [s] in an interval; their profiles are written."""
    planner = work[MotionWork.PLAN:MotionWork.EXPANSION, :]
    for axis in range(axes.shape[0]):
        cell = cells[place * axes.shape[0] + axis, :, :]
        if not set_duration(duration, cell, axes[axis, :], planner):
            return False
    return True


def plan_lengths(
    states: 'float[:,:,:]', spans: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]',
    work: 'float[:,:]',
) -> float:
    """Write the durations of all intervals with states; their sum [s], or NEVER."""
    set_problems(states, cells)
    total = 0.0
    for j in range(spans.shape[0]):
        spans[j, Stretch.LENGTH] = least_length(j, axes, cells, work)
        if spans[j, Stretch.LENGTH] < NEVER:
            spans[j, Stretch.LENGTH] = common_length(NEVER, j, axes, cells, work)
        total = total + spans[j, Stretch.LENGTH]
    return min(total, NEVER)


def farthest_beyond(
    side: int, low: float, high: float, first: float, cell: 'float[:,:]', axis: 'float[:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', work: 'float[:,:]',
) -> float:
    """How far a planned cell, which begins at `first` [m], leaves a range above (0) or below."""
    cell[Cell.PLACE, Place.POSITION] = first
    cell[Cell.PLACE, Place.START] = 0.0
    expansion = work[MotionWork.EXPANSION:MotionWork.CHECK, :]
    count = expand_cell(cell, axis, timing, coefficients, 0, expansion)
    # free between two plans
    hulls = work[MotionWork.PLAN:MotionWork.EXPANSION, :]
    return pieces_beyond(side, low, high, count, timing, coefficients, hulls)


def leaves_box(
    place: int, states: 'float[:,:,:]', path: 'float[:]', links: 'float[:,:,:]', axes: 'float[:,:]',
    cells: 'float[:,:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """Whether a planned interval leaves its boxes by more than the margin."""
    for axis in range(axes.shape[0]):
        i = place * axes.shape[0] + axis
        low = links[i, Link.BOX, 0]
        high = links[i, Link.BOX, 1]
        first = states[place, axis, WaypointState.POSITION]
        if high - low < NEVER:
            for side in range(2):
                beyond = farthest_beyond(
                    side, low, high, first, cells[i, :, :], axes[axis, :], timing, coefficients,
                    work,
                )
                if beyond > path[Path.MARGIN]:
                    return True
    return False


def offer_states(
    tried: 'float[:,:,:]', best: 'float[:,:,:]', path: 'float[:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', work: 'float[:,:]',
) -> int:
    """Take states if their plan is shorter; writes which intervals are slow, and counts them.

    An interval is slow if its plan takes longer than the path, or leaves its box.
    """
    set_problems(tried, cells)
    total = 0.0
    for j in range(spans.shape[0]):
        spans[j, Stretch.LENGTH] = least_length(j, axes, cells, work)
        total = total + spans[j, Stretch.LENGTH]
    shorter = total < path[Path.BEST]
    if shorter:
        for j in range(spans.shape[0]):
            least = spans[j, Stretch.LENGTH]
            # what takes longer is of no use; all that has no gap is found
            most = max(path[Path.BEST] - (total - least), (1.0 + EQUAL) * least)
            spans[j, Stretch.LENGTH] = common_length(most, j, axes, cells, work)
            total = total + (spans[j, Stretch.LENGTH] - least)
        shorter = total < path[Path.BEST]
    count, beyond = 0, False
    for j in range(spans.shape[0]):
        slow = not spans[j, Stretch.LENGTH] <= KEPT_UP * exp(spans[j, Stretch.TIME])
        if shorter and leaves_box(j, tried, path, links, axes, cells, timing, coefficients, work):
            slow, beyond = True, True
        spans[j, Stretch.TRIED_SLOW] = slow
        if slow:
            count = count + 1
    if shorter and not beyond:
        path[Path.BEST] = total
        copy_states(tried, best)
    return count


def copy_states(source: 'float[:,:,:]', target: 'float[:,:,:]') -> None:
    """target = source."""
    for point in range(source.shape[0]):
        for axis in range(source.shape[1]):
            for i in range(WaypointState.SIZE):
                target[point, axis, i] = source[point, axis, i]


def shortest_of(place: int, axis: int, axes: 'float[:,:]', cells: 'float[:,:,:]') -> float:
    """The shortest duration of an axis in an interval, which is planned [s]."""
    from_cell = place * axes.shape[0] + axis
    return cells[from_cell, Cell.RESULT, Interval.SHORTEST]
