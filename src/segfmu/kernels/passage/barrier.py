"""The barrier of a passage: minus the sum of log(1 - share^2) over all limits.

A share is a derivative over its limit at a node, counted from the middle of its range. Arrays of a
passage of m waypoints and k axes: path (Path,), tracks (k, Track), spots (m k, Spot, Free), links
((m - 1) k, Link, GridColumn), spans (m, Stretch), grid and square as in grid.py.
"""

from math import exp, log

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.passage.records import (
    Free,
    GridColumn,
    GridRow,
    Link,
    Path,
    Spot,
    Square,
    Stretch,
    Track,
)


def write_variables(
    step: bool, path: 'float[:]', spots: 'float[:,:,:]', links: 'float[:,:,:]'
) -> None:
    """Write the states of the tried point into its variables; step: those of the step instead."""
    axes = int(path[Path.AXES])
    source = Spot.TRIAL
    target = Link.TRIAL
    if step:
        source = Spot.STEP
        target = Link.STEP
    for i in range(links.shape[0]):
        for field in range(Free.SIZE):
            links[i, target, GridColumn.ENDS + field] = spots[i, source, field]
            end = GridColumn.ENDS + Free.SIZE + field
            links[i, target, end] = spots[i + axes, source, field]


def unit_of(column: int, order: int, track: 'float[:]') -> 'tuple[float, int]':
    """What a column is measured in, and the power of the duration that it has."""
    if column == GridColumn.DISTANCE:
        return 1.0, 0
    if column >= GridColumn.COMPONENTS:
        return track[Track.LIMIT + order - 1], order
    field = (column - GridColumn.ENDS) % Free.SIZE
    return track[Track.LIMIT + field], field + 1


def write_scales(
    path: 'float[:]', track: 'float[:]', time: float, link: 'float[:,:]', square: 'float[:,:]'
) -> None:
    """Write units and parts of the columns, and scales, for a duration of the logarithm `time`."""
    order = int(path[Path.ORDER])
    duration = exp(time)
    for j in range(int(GridColumn.COMPONENTS + path[Path.COMPONENTS])):
        unit, power = unit_of(j, order, track)
        for k in range(power):
            unit = unit * duration
        square[Square.POWER, j] = power
        square[Square.UNIT, j] = unit
        square[Square.PART, j] = link[Link.TRIAL, j] * unit
    whole = path[Path.ROOM]
    for derivative in range(order + 1):
        square[Square.SCALE, derivative] = link[Link.SCALE, derivative] / whole
        whole = whole * duration


def write_node_shares(
    path: 'float[:]', track: 'float[:]', time: float, link: 'float[:,:]', grid: 'float[:,:]',
    square: 'float[:,:]',
) -> None:
    """Write the shares of the tried point of a link, and their parts, with `write_scales`."""
    write_scales(path, track, time, link, square)
    count = int(GridColumn.COMPONENTS + path[Path.COMPONENTS])
    for i in range(int(path[Path.ROWS])):
        derivative = int(grid[i, GridRow.ORDER])
        total = 0.0
        for group in range(3):
            # distance, velocities, accelerations
            part = grid[i, GridRow.BY + group] * square[Square.PART, group]
            if group > 0:
                other = group + Free.SIZE
                part = part + grid[i, GridRow.BY + other] * square[Square.PART, other]
            grid[i, GridRow.PART + group] = part
            total = total + part
        part = 0.0
        for j in range(int(GridColumn.COMPONENTS), count):
            part = part + grid[i, GridRow.BY + j] * square[Square.PART, j]
        grid[i, GridRow.CONTROL_PART] = part
        where = link[Link.WHERE, derivative] / path[Path.ROOM]
        grid[i, GridRow.SHARE] = (total + part) * square[Square.SCALE, derivative] + where


def largest_node_share(
    path: 'float[:]', tracks: 'float[:,:]', links: 'float[:,:,:]', spans: 'float[:,:]',
    grid: 'float[:,:]', square: 'float[:,:]',
) -> float:
    """The largest share of the tried point."""
    axes = int(path[Path.AXES])
    largest = 0.0
    for i in range(links.shape[0]):
        axis = i % axes
        time = spans[i // axes, Stretch.TRIAL]
        write_node_shares(path, tracks[axis, :], time, links[i, :, :], grid, square)
        for row in range(int(path[Path.ROWS])):
            largest = max(largest, abs(grid[row, GridRow.SHARE]))
    return largest


def room_of(share: float) -> float:
    """What a share leaves, whose logarithm is in the barrier; 0 outside."""
    if not abs(share) < 1.0:
        return 0.0
    return (1.0 - share) * (1.0 + share)


def state_offset(spot: 'float[:,:]', row: int, field: int, track: 'float[:]') -> float:
    """A state counted from the middle of its range, over half of that."""
    middle = track[Track.MIDDLE + field] / track[Track.LIMIT + field]
    return spot[row, field] - middle


def barrier_value(
    theta: float, path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]',
    links: 'float[:,:,:]', spans: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]',
) -> float:
    """The barrier of the tried point plus theta times its duration; NEVER outside the limits."""
    axes = int(path[Path.AXES])
    total = theta * path_total(Stretch.TRIAL, spans)
    # one logarithm does for many factors
    for i in range(spots.shape[0]):
        axis = i % axes
        room = 1.0
        for field in range(Free.SIZE):
            if spots[i, Spot.CHOSEN, field] != 0.0:
                share = state_offset(spots[i, :, :], Spot.TRIAL, field, tracks[axis, :])
                room = room * room_of(share)
        if room <= 0.0:
            return NEVER
        total = total - log(room)
    for i in range(links.shape[0]):
        axis = i % axes
        time = spans[i // axes, Stretch.TRIAL]
        write_node_shares(path, tracks[axis, :], time, links[i, :, :], grid, square)
        room = 1.0
        for row in range(int(path[Path.ROWS])):
            room = room * room_of(grid[row, GridRow.SHARE])
        if room <= 0.0:
            return NEVER
        total = total - log(room)
    return total


def path_total(column: int, spans: 'float[:,:]') -> float:
    """Sum of the durations [s] of the point (Stretch.TIME) or the tried one (Stretch.TRIAL)."""
    total = 0.0
    for i in range(spans.shape[0]):
        total = total + exp(spans[i, column])
    return total
