"""The central path of a passage: free states and durations from an interior-point method.

Towards the shortest total time within the limits at all nodes, Newton's method follows the central
path: it minimises theta * (sum of durations) - sum of log(1 - share^2) for rising theta (Boyd and
Vandenberghe, Convex Optimization, ch. 11). The conditions at the waypoints hold by construction, so
every point is a motion. Axes that have time to spare stay in the middle of what they can do. Arrays
as in barrier.py, band as in band.py.
"""

from math import log

from segfmu.kernels.numerics.numbers import FAR, FINE, HALF_DIGITS, HALVINGS, NEVER, SAMPLES, SMALL
from segfmu.kernels.passage.band import band_solve, write_band, write_durations, write_steps
from segfmu.kernels.passage.barrier import (
    barrier_value,
    largest_node_share,
    path_total,
    write_node_shares,
    write_variables,
)
from segfmu.kernels.passage.model import write_model
from segfmu.kernels.passage.records import (
    Free,
    GridColumn,
    GridRow,
    Link,
    Path,
    Point,
    Spot,
    Stretch,
    Track,
)

# by how much the duration of the last point exceeds the shortest one, at most, and how many times
# as much that of each point before it may: the root of ten
LAST_GAP = 0.03
FASTER = 3.1622776601683795
# a path is slowed down by this factor at a time
SLOWING = 1.02
# a gap is reached within this factor
ENOUGH = 1.05
# what steps to the centre promise where they end, of a unit for each limit, and on the way to a
# smaller gap
CENTRED = 0.5
ON_THE_WAY = 20.0
# steps behind which what is reached has to do
CENTRINGS = 30
# one over a duration changes by this share at once, at most
LARGEST_STEP = 0.6


def gap_of(point: int) -> float:
    """By how much the duration at a point (`Point`) may exceed the shortest one, at most."""
    return LAST_GAP * FASTER ** (Point.LAST - point)


def try_move(
    share: float, path: 'float[:]', spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]',
) -> None:
    """Write the tried point: the point of the path plus a share of the step."""
    for i in range(spots.shape[0]):
        for field in range(Free.SIZE):
            change = share * spots[i, Spot.STEP, field] if share > 0.0 else 0.0
            spots[i, Spot.TRIAL, field] = spots[i, Spot.SHARE, field] + change
    for i in range(links.shape[0]):
        for j in range(GridColumn.SIZE):
            change = share * links[i, Link.STEP, j] if share > 0.0 else 0.0
            links[i, Link.TRIAL, j] = links[i, Link.POINT, j] + change
        links[i, Link.TRIAL, GridColumn.DISTANCE] = links[i, Link.POINT, GridColumn.DISTANCE]
    for j in range(spans.shape[0]):
        change = -log(1.0 - share * spans[j, Stretch.STEP]) if share > 0.0 else 0.0
        spans[j, Stretch.TRIAL] = spans[j, Stretch.TIME] + change
    write_variables(False, path, spots, links)


def take_tried(spots: 'float[:,:,:]', links: 'float[:,:,:]', spans: 'float[:,:]') -> None:
    """Make the tried point that of the path."""
    for i in range(spots.shape[0]):
        for field in range(Free.SIZE):
            spots[i, Spot.SHARE, field] = spots[i, Spot.TRIAL, field]
    for i in range(links.shape[0]):
        for j in range(GridColumn.SIZE):
            links[i, Link.POINT, j] = links[i, Link.TRIAL, j]
    for j in range(spans.shape[0]):
        spans[j, Stretch.TIME] = spans[j, Stretch.TRIAL]


def write_step_of(
    theta: float, path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]',
    band: 'float[:,:]',
) -> float:
    """Write Newton's step at the tried point; the decrease it promises, -NEVER: none.

    Where the barrier is not convex, a small part of the diagonal is added to it, then more.
    """
    axes = int(path[Path.AXES])
    ridge = 0.0
    for attempt in range(HALVINGS):
        for i in range(links.shape[0]):
            axis = i % axes
            time = spans[i // axes, Stretch.TRIAL]
            write_model(ridge, path, tracks[axis, :], time, links[i, :, :], grid, square)
        if write_durations(theta, path, links, spans):
            write_band(path, tracks, spots, links, spans, band)
            if band_solve(band):
                return write_steps(path, tracks, spots, links, spans, band, theta)
        ridge = max(ridge / SMALL, SMALL)
    return -NEVER


def centre_path(
    theta: float, accuracy: float, path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]',
    band: 'float[:,:]',
) -> bool:
    """Go to about the minimum of the barrier function; False if none is found.

    accuracy: what the last step promises at most to take off.
    """
    try_move(0.0, path, spots, links, spans)
    value = barrier_value(theta, path, tracks, spots, links, spans, grid, square)
    for attempt in range(CENTRINGS):
        decrease = write_step_of(theta, path, tracks, spots, links, spans, grid, square, band)
        if not -NEVER < decrease < NEVER:
            return False
        longest = LARGEST_STEP
        for j in range(spans.shape[0]):
            longest = max(longest, abs(spans[j, Stretch.STEP]))
        share = LARGEST_STEP / longest
        try_move(share, path, spots, links, spans)
        tried = barrier_value(theta, path, tracks, spots, links, spans, grid, square)
        while not tried <= value:
            share = 0.5 * share
            if share < HALF_DIGITS:
                return False
            try_move(share, path, spots, links, spans)
            tried = barrier_value(theta, path, tracks, spots, links, spans, grid, square)
        take_tried(spots, links, spans)
        value = tried
        if decrease < accuracy:
            break
    return True


def begin_path(
    path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]', band: 'float[:,:]',
) -> bool:
    """Begin at rest in the free states, with durations that keep half of the limits, or nearly.

    If given states exceed the limits there, a point within them is found; False if there is none.
    """
    path[Path.ROOM] = 1.0
    write_variables(False, path, spots, links)
    write_times(path, tracks, links, spans, grid, square)
    used = largest_node_share(path, tracks, links, spans, grid, square)
    take_tried(spots, links, spans)
    if used < 1.0:
        return True
    path[Path.ROOM] = 2.0 * used
    return retreat(path, tracks, spots, links, spans, grid, square, band)


def slow_path(
    gap: float, path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]',
) -> float:
    """Begin at the point of the last path, slowed down as a whole; the weight of time from there.

    There is one with which nothing is gained by slowing down further. It belongs to a duration that
    exceeds the shortest one by `gap` or more, and grows at once. The states at the ends are at
    rest, so this is a motion. -1 if it never keeps its limits.
    """
    path[Path.ROOM] = 1.0
    before = NEVER
    for attempt in range(HALVINGS):
        try_move(0.0, path, spots, links, spans)
        value = barrier_value(0.0, path, tracks, spots, links, spans, grid, square)
        total = path_total(Stretch.TIME, spans)
        if before < NEVER:
            theta = (before - value) / (total * (1.0 - 1.0 / SLOWING))
            if theta * gap * total <= path[Path.TERMS]:
                return FASTER * theta
        before = value
        for i in range(spots.shape[0]):
            for field in range(Free.SIZE):
                spots[i, Spot.SHARE, field] = spots[i, Spot.SHARE, field] / SLOWING ** (field + 1)
        power = SLOWING ** int(path[Path.ORDER])
        for i in range(links.shape[0]):
            for j in range(int(GridColumn.COMPONENTS), GridColumn.TIME):
                links[i, Link.POINT, j] = links[i, Link.POINT, j] / power
        for j in range(spans.shape[0]):
            spans[j, Stretch.TIME] = spans[j, Stretch.TIME] + log(SLOWING)
    return -1.0


def write_times(
    path: 'float[:]', tracks: 'float[:,:]', links: 'float[:,:,:]', spans: 'float[:,:]',
    grid: 'float[:,:]', square: 'float[:,:]',
) -> None:
    """Write durations of the tried point: the least of some that keeps half of the limits."""
    axes = int(path[Path.AXES])
    least, reach = 0.0, 0.0
    for axis in range(axes):
        limit = tracks[axis, Track.LIMIT]
        least = max(least, limit / tracks[axis, Track.LIMIT + 1])
        for j in range(spans.shape[0]):
            distance = links[j * axes + axis, Link.TRIAL, GridColumn.DISTANCE]
            reach = max(reach, abs(distance) / limit)
    first = log(1.0 / FAR * least)
    growth = (log(FAR * (least + reach)) - first) / SAMPLES
    for j in range(spans.shape[0]):
        fits = NEVER
        for k in range(SAMPLES + 1):
            used = 0.0
            for axis in range(axes):
                link = links[j * axes + axis, :, :]
                write_node_shares(path, tracks[axis, :], first + growth * k, link, grid, square)
                for row in range(int(path[Path.ROWS])):
                    if grid[row, GridRow.ORDER] != 0.0:
                        used = max(used, abs(grid[row, GridRow.SHARE]))
            if used < fits:
                fits = used
                spans[j, Stretch.TRIAL] = first + growth * k
            if used <= 0.5:
                break


def retreat(
    path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]', band: 'float[:,:]',
) -> bool:
    """Take back step by step what given states exceed the limits by; False if that fails.

    Where time counts much, short durations push against the limits, and what can be taken back
    gets small. Where it counts little, the motion may turn into a detour.
    """
    for attempt in range(HALVINGS):
        theta = path[Path.TERMS] / (path[Path.START] * path_total(Stretch.TIME, spans))
        if not centre_path(theta, CENTRED, path, tracks, spots, links, spans, grid, square, band):
            return False
        try_move(0.0, path, spots, links, spans)
        used = largest_node_share(path, tracks, links, spans, grid, square)
        if used > 1.0 - FINE:
            return False
        # a small part of what could be taken back at once is left
        path[Path.ROOM] = max(1.0, path[Path.ROOM] * (used + SMALL * (1.0 - used)))
        if path[Path.ROOM] == 1.0:
            return True
    return False


def follow_path(
    theta: float, gap: float, path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]',
    band: 'float[:,:]',
) -> float:
    """Follow the path until its duration exceeds the shortest one by `gap`; the theta there.

    -1 where it ends.
    """
    reached = NEVER
    while reached > ENOUGH * gap:
        accuracy = CENTRED
        if path[Path.TERMS] > ENOUGH * gap * theta * path_total(Stretch.TIME, spans):
            accuracy = ON_THE_WAY
        if not centre_path(theta, accuracy, path, tracks, spots, links, spans, grid, square, band):
            return -1.0
        reached = path[Path.TERMS] / (theta * path_total(Stretch.TIME, spans))
        theta = theta * min(FASTER, max(1.0, reached / gap))
    return theta
