"""States on central paths that the planner can keep up with.

The states of the central path are nearly optimal, but the planner's profiles are not all motions:
between some states they take longer than the path. Where they do, the path is found again with
smaller shares of the jerk and snap limits in that interval, until the planner keeps up. What counts
is the planner's own duration. Arrays as in path.py and judge.py.
"""

from math import floor, sqrt

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.passage.boxes import is_moving
from segfmu.kernels.passage.judge import offer_states
from segfmu.kernels.passage.path import (
    ENOUGH,
    begin_path,
    follow_path,
    gap_of,
    path_total,
    slow_path,
)
from segfmu.kernels.passage.records import (
    Block,
    Cells,
    Free,
    GridColumn,
    Link,
    Path,
    Point,
    Spot,
    Stretch,
    Tools,
    Track,
)
from segfmu.kernels.planner.records import Axis, PlanOptions, Shape, WaypointState
from segfmu.kernels.trajectory.records import MotionWork

# the snap that a limit of the jerk leaves, over that of a jerk that rises all the time
STEEP = 10.0
# shares of the limits of jerk and snap that a path uses, for each degree of tightness, and what
# smoothsteps use of them, about
JERK_SHARE = 0.93
SNAP_SHARE = 0.75
SMOOTHSTEP_JERK = 0.6
SMOOTHSTEP_SNAP = 0.5
# degrees of an interval that is slow: the first one, and the next ones from the last; between one
# that is slow and one that is not, closer ones are not told apart
TIGHTER = 0.5
TIGHTENING = 1.4
TIGHT_ENOUGH = 0.4
# paths, until none is tried; in the last quarter all intervals get tighter: sooner, a long mission
# would become slow as a whole for a few intervals that take several paths
SWEEPS = 20
# states are multiples of their limit over this
DIGITS = 65536.0


def write_tracks(
    limits: 'float[:,:]', lower: 'float[:,:]', path: 'float[:]', tracks: 'float[:,:]'
) -> None:
    """Write limits up to the order of the control.

    If a limit above the snap alone bounds it, the snap is about what the ramp to the acceleration
    limit needs.
    """
    path[Path.ORDER] = 3.0
    for axis in range(limits.shape[0]):
        for field in range(Free.SIZE):
            half = 0.5 * (limits[axis, field] + lower[axis, field])
            tracks[axis, Track.LIMIT + field] = half
            tracks[axis, Track.MIDDLE + field] = limits[axis, field] - half
        acceleration = tracks[axis, Track.LIMIT + 1]
        jerk = limit_of(2, axis, limits)
        snap = limit_of(3, axis, limits)
        crackle = limit_of(4, axis, limits)
        if crackle < NEVER:
            snap = min(snap, (crackle * crackle * acceleration) ** (1.0 / 3.0))
        pop = limit_of(5, axis, limits)
        if pop < NEVER:
            snap = min(snap, sqrt(pop * acceleration))
        if snap < NEVER:
            path[Path.ORDER] = 4.0
        if jerk < NEVER:
            snap = min(snap, STEEP * jerk * jerk / acceleration)
        tracks[axis, Track.JERK_LIMIT] = jerk
        tracks[axis, Track.SNAP_LIMIT] = snap
    path[Path.COMPONENTS] = Cells.COUNT - path[Path.ORDER]
    path[Path.ROWS] = path[Path.ORDER] * Cells.INNER + Cells.COUNT


def limit_of(place: int, axis: int, limits: 'float[:,:]') -> float:
    """A limit, from the velocity on; NEVER where there is none."""
    if place < limits.shape[1]:
        if limits[axis, place] > 0.0:
            return min(limits[axis, place], NEVER)
    return NEVER


def limit_share(order: int, degree: float, smoothstep: bool) -> float:
    """Share of a limit that a path may use in an interval, for a degree of tightness."""
    share = 1.0
    if order == 3:
        share = JERK_SHARE**degree
        if smoothstep:
            share = SMOOTHSTEP_JERK * share
    elif order == 4:
        share = SNAP_SHARE**degree
        if smoothstep:
            share = SMOOTHSTEP_SNAP * share
    return share


def write_scales_of(
    smoothstep: bool, given: 'float[:,:,:]', path: 'float[:]', tracks: 'float[:,:]',
    spots: 'float[:,:,:]', links: 'float[:,:,:]', spans: 'float[:,:]',
) -> None:
    """Write what the links are measured in, and the tried point: rest in the free states."""
    count = int(path[Path.AXES])
    path[Path.TERMS] = path[Path.ROWS] * links.shape[0]
    for i in range(spots.shape[0]):
        for field in range(Free.SIZE):
            state = given[i // count, i % count, WaypointState.VELOCITY + field]
            spots[i, Spot.TRIAL, field] = state / tracks[i % count, Track.LIMIT + field]
            if spots[i, Spot.CHOSEN, field] != 0.0:
                spots[i, Spot.TRIAL, field] = 0.0
                path[Path.TERMS] = path[Path.TERMS] + 1.0
    for i in range(links.shape[0]):
        axis = i % count
        first = given[i // count, axis, WaypointState.POSITION]
        for j in range(GridColumn.SIZE):
            links[i, Link.TRIAL, j] = 0.0
        last = given[i // count + 1, axis, WaypointState.POSITION]
        links[i, Link.TRIAL, GridColumn.DISTANCE] = last - first
        write_box_scale(first, links[i, :, :])
        for order in range(1, int(path[Path.ORDER]) + 1):
            limit = tracks[axis, Track.LIMIT + order - 1]
            share = limit_share(order, spans[i // count, Stretch.DEGREE], smoothstep)
            links[i, Link.SCALE, order] = 0.0
            links[i, Link.WHERE, order] = 0.0
            if limit < NEVER:
                links[i, Link.SCALE, order] = 1.0 / (limit * share)
            if order < 3:
                links[i, Link.WHERE, order] = -tracks[axis, Track.MIDDLE + order - 1] / limit


def write_box_scale(first: float, link: 'float[:,:]') -> None:
    """Write what positions are measured in; those of a link begin at `first` [m]."""
    half = 0.5 * (link[Link.BOX, 1] - link[Link.BOX, 0])
    link[Link.SCALE, 0] = 0.0
    link[Link.WHERE, 0] = 0.0
    if half < NEVER:
        # an axis that may not move has a range all the same, of no size to speak of
        half = max(half, link[Link.BOX, 2])
        link[Link.SCALE, 0] = 1.0 / half
        middle = 0.5 * (link[Link.BOX, 0] + link[Link.BOX, 1])
        link[Link.WHERE, 0] = (first - middle) / half


def write_tried(
    given: 'float[:,:,:]', path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]',
    tried: 'float[:,:,:]',
) -> None:
    """Write the states of the path, multiples of the limit over DIGITS.

    Their last digits depend on the processor; without these, all plan the same.
    """
    count = int(path[Path.AXES])
    for i in range(spots.shape[0]):
        point = i // count
        axis = i % count
        for k in range(WaypointState.SIZE):
            tried[point, axis, k] = given[point, axis, k]
        for field in range(Free.SIZE):
            if spots[i, Spot.CHOSEN, field] != 0.0:
                share = spots[i, Spot.SHARE, field]
                digits = floor(DIGITS * abs(share) + 0.5) / DIGITS
                if share < 0.0:
                    digits = -digits
                state = digits * tracks[axis, Track.LIMIT + field]
                high = highest_state(field, tracks[axis, Axis.VELOCITY + field])
                low = -highest_state(field, tracks[axis, Axis.LOWER + field])
                state = min(max(state, low), high)
                tried[point, axis, WaypointState.VELOCITY + field] = state


def highest_state(field: int, limit: float) -> float:
    """The most that is chosen of a limit: all of the velocity's, nearly all of the acceleration's.

    At the limit itself the end of a plateau and that of the interval are one condition, and what
    Newton's method finds then depends on rounding.
    """
    if field == Free.ACCELERATION:
        return limit * (1.0 - 1.0 / DIGITS)
    return limit


def may_beat(known: float, place: int, total: float) -> bool:
    """Whether a path may be shorter than a known one, by the duration of a point (`gap_of`)."""
    return total <= (1.0 + ENOUGH * gap_of(place)) * known


def try_path(
    choice: 'float[:,:,:]', tools: 'float[:,:]', axes: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', band: 'float[:,:]', cells: 'float[:,:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', work: 'float[:,:]',
) -> bool:
    """Offer the states on a path; writes the intervals in which the best of them are slow.

    Between rests the last point alone, which is the shortest. False if the path has none, or none
    that can be faster; the last one is offered all the same, as a ramp can be shorter than a cell.
    """
    path, grid = tools[Tools.PATH, :], tools[Tools.GRID:Tools.SQUARE, :]
    square = tools[Tools.SQUARE:Tools.SIZE, :]
    begin, end = block_rows(Block.GIVEN, path, choice)
    given = choice[begin:end, :, :]
    begin, end = block_rows(Block.TRIED, path, choice)
    tried = choice[begin:end, :, :]
    begin, end = block_rows(int(path[Path.BLOCK]), path, choice)
    best = choice[begin:end, :, :]
    smoothstep = int(work[MotionWork.OPTIONS, PlanOptions.SHAPE]) == Shape.SMOOTHSTEP
    write_scales_of(smoothstep, given, path, axes, spots, links, spans)
    offered = Point.FIRST if is_moving(given) else Point.LAST
    first = Point.FIRST
    if path[Path.FOLLOWED] != 0.0:
        first = Point.LAST
        theta = slow_path(gap_of(Point.SECOND), path, axes, spots, links, spans, grid, square)
        if theta < 0.0:
            return False
    elif begin_path(path, axes, spots, links, spans, grid, square, band):
        theta = path[Path.TERMS] / (path[Path.START] * path_total(int(Stretch.TIME), spans))
    else:
        return False
    fewest = spans.shape[0] + 1
    for place in range(first, Point.LAST + 1):
        theta = follow_path(
            theta, gap_of(place), path, axes, spots, links, spans, grid, square, band
        )
        if theta < 0.0:
            break
        path[Path.TOTAL] = path_total(int(Stretch.TIME), spans)
        hopeful = may_beat(min(path[Path.BEST], path[Path.KNOWN]), place, path[Path.TOTAL])
        last = place == Point.LAST and may_beat(path[Path.KNOWN], place, path[Path.TOTAL])
        if not (hopeful or last):
            return False
        if place < offered:
            continue
        write_tried(given, path, axes, spots, tried)
        slow = offer_states(
            tried, best, path, links, spans, axes, cells, timing, coefficients, work
        )
        if slow < fewest:
            fewest = slow
            for j in range(spans.shape[0]):
                spans[j, Stretch.SLOW] = spans[j, Stretch.TRIED_SLOW]
        if not hopeful:
            return False
    return fewest <= spans.shape[0]


def block_rows(block: int, path: 'float[:]', choice: 'float[:,:,:]') -> 'tuple[int, int]':
    """The first row of a passage in a block (`Block`), and that after its last one."""
    begin = block * (choice.shape[0] // Block.COUNT)
    return begin + int(path[Path.FIRST]), begin + int(path[Path.LAST]) + 1


def search_states(
    choice: 'float[:,:,:]', tools: 'float[:,:]', axes: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', band: 'float[:,:]', cells: 'float[:,:,:]',
    timing: 'float[:,:]', coefficients: 'float[:,:]', work: 'float[:,:]',
) -> None:
    """Offer the states of paths that are as tight as they need to be, until none can be faster."""
    path = tools[Tools.PATH, :]
    for j in range(spans.shape[0]):
        spans[j, Stretch.DEGREE] = 0.0
        spans[j, Stretch.FAILED] = -1.0
        spans[j, Stretch.GOOD] = NEVER
    path[Path.FOLLOWED] = 0.0
    path[Path.TOTAL] = NEVER
    begin, end = block_rows(Block.GIVEN, path, choice)
    resting = not is_moving(choice[begin:end, :, :])
    known = path[Path.BEST]
    for sweep in range(SWEEPS):
        going_on = try_path(
            choice, tools, axes, spots, links, spans, band, cells, timing, coefficients, work
        )
        if sweep == 0:
            path[Path.LOOSEST] = min(path[Path.LOOSEST], path[Path.TOTAL])
        if not going_on:
            return
        if not tighten_path(sweep > 3 * SWEEPS // 4 and path[Path.BEST] >= known, spans):
            return
        # the next path is much like this one
        path[Path.FOLLOWED] = resting


def tighten_path(everywhere: bool, spans: 'float[:,:]') -> bool:
    """Set the degrees of the next path; False if there is none to try.

    An interval that was slow gets tighter, or all do; if none was, those that once were get looser.
    """
    any_slow = False
    for j in range(spans.shape[0]):
        if everywhere:
            spans[j, Stretch.SLOW] = 1.0
        if spans[j, Stretch.SLOW] != 0.0:
            any_slow = True
            degree = spans[j, Stretch.DEGREE]
            spans[j, Stretch.FAILED] = max(spans[j, Stretch.FAILED], degree)
    changed = False
    for j in range(spans.shape[0]):
        failed = spans[j, Stretch.FAILED]
        if not any_slow:
            spans[j, Stretch.GOOD] = spans[j, Stretch.DEGREE]
        retried = spans[j, Stretch.SLOW] != 0.0
        if not any_slow:
            retried = failed >= 0.0 and spans[j, Stretch.GOOD] - failed > TIGHT_ENOUGH
        if retried:
            changed = True
            spans[j, Stretch.DEGREE] = TIGHTER + TIGHTENING * failed
            if spans[j, Stretch.GOOD] < NEVER:
                spans[j, Stretch.DEGREE] = 0.5 * (failed + spans[j, Stretch.GOOD])
    return changed
