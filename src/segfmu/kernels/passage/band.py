"""Newton's step: states at the waypoints from a banded system, then durations and components.

band (2 k m, 4 k + 1): a row for each state, in the order of waypoint, axis and field; its entries
are those of the matrix from the diagonal to the left, and the right-hand side in the last column.
"""

from math import exp

from segfmu.kernels.numerics.banded import band_factor, band_substitute
from segfmu.kernels.passage.barrier import state_offset, write_variables
from segfmu.kernels.passage.records import Free, GridColumn, Link, Outer, Path, Spot, Stretch


def band_solve(band: 'float[:,:]') -> bool:
    """Solve the system, in place; False if its matrix is not positive definite."""
    width = band.shape[1] - 1
    if not band_factor(width, 0, band):
        return False
    band_substitute(width, 0, width, band)
    return True


def end_row(i: int, place: int, axes: int) -> int:
    """Row of the band of a state at an end (Outer.ENDS + place) of a link."""
    spot = i + place // Free.SIZE * axes
    return spot * Free.SIZE + place % Free.SIZE


def write_durations(
    theta: float, path: 'float[:]', links: 'float[:,:,:]', spans: 'float[:,:]'
) -> bool:
    """Write slope and curvature by the durations; False where they do not bend upwards."""
    axes = int(path[Path.AXES])
    for j in range(spans.shape[0]):
        duration = theta * exp(spans[j, Stretch.TRIAL])
        spans[j, Stretch.PULL] = duration
        spans[j, Stretch.BEND] = 2.0 * duration
        for axis in range(axes):
            link = links[j * axes + axis, :, :]
            last = Link.CURVE + Outer.TIME
            spans[j, Stretch.PULL] = spans[j, Stretch.PULL] + link[Link.SLOPE, GridColumn.TIME]
            spans[j, Stretch.BEND] = spans[j, Stretch.BEND] + link[last, Outer.TIME]
        if not spans[j, Stretch.BEND] > 0.0:
            return False
    return True


def write_band(
    path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', band: 'float[:,:]',
) -> None:
    """Write the system of the states; those that are not chosen do not change."""
    axes = int(path[Path.AXES])
    width = band.shape[1] - 1
    for i in range(band.shape[0]):
        for j in range(width + 1):
            band[i, j] = 0.0
        place = i // Free.SIZE
        axis = place % axes
        field = i % Free.SIZE
        band[i, 0] = 1.0
        if spots[place, Spot.CHOSEN, field] != 0.0:
            share = state_offset(spots[place, :, :], Spot.TRIAL, field, tracks[axis, :])
            inner = (1.0 - share) * (1.0 + share)
            band[i, 0] = 2.0 * (1.0 + share * share) / (inner * inner)
            band[i, width] = -2.0 * share / inner
    for i in range(links.shape[0]):
        for other in range(axes):
            add_link(i, i - i % axes + other, axes, spots, links, spans, band)


def add_link(
    i: int, other: int, axes: int, spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', band: 'float[:,:]',
) -> None:
    """Add what a link, with another one of its interval, is to the system of the states."""
    width = band.shape[1] - 1
    pull = spans[i // axes, Stretch.PULL]
    bend = spans[i // axes, Stretch.BEND]
    for place in range(Outer.TIME):
        row = end_row(i, place, axes)
        own = links[i, Link.CURVE + place, Outer.TIME]
        if spots[row // Free.SIZE, Spot.CHOSEN, row % Free.SIZE] == 0.0:
            continue
        if other == i:
            slope = links[i, Link.SLOPE, GridColumn.ENDS + place] - own * pull / bend
            band[row, width] = band[row, width] - slope
        for beside in range(Outer.TIME):
            column = end_row(other, beside, axes)
            if spots[column // Free.SIZE, Spot.CHOSEN, column % Free.SIZE] == 0.0:
                continue
            if column <= row:
                value = -own * links[other, Link.CURVE + beside, Outer.TIME] / bend
                if other == i:
                    value = value + links[i, Link.CURVE + place, beside]
                band[row, row - column] = band[row, row - column] + value


def write_steps(
    path: 'float[:]', tracks: 'float[:,:]', spots: 'float[:,:,:]', links: 'float[:,:,:]',
    spans: 'float[:,:]', band: 'float[:,:]', theta: float,
) -> float:
    """Write Newton's step of all variables from that of the states; the decrease it promises."""
    axes = int(path[Path.AXES])
    promised = 0.0
    for i in range(spots.shape[0]):
        axis = i % axes
        for field in range(Free.SIZE):
            step = band[i * Free.SIZE + field, band.shape[1] - 1]
            spots[i, Spot.STEP, field] = step
            if spots[i, Spot.CHOSEN, field] != 0.0:
                share = state_offset(spots[i, :, :], Spot.TRIAL, field, tracks[axis, :])
                promised = promised + 2.0 * share / ((1.0 - share) * (1.0 + share)) * step
    write_variables(True, path, spots, links)
    for j in range(spans.shape[0]):
        total = spans[j, Stretch.PULL]
        for axis in range(axes):
            link = links[j * axes + axis, :, :]
            for place in range(Outer.TIME):
                end = GridColumn.ENDS + place
                total = total + link[Link.CURVE + place, Outer.TIME] * link[Link.STEP, end]
        spans[j, Stretch.STEP] = -total / spans[j, Stretch.BEND]
        promised = promised + theta * exp(spans[j, Stretch.TRIAL]) * spans[j, Stretch.STEP]
    for i in range(links.shape[0]):
        links[i, Link.STEP, GridColumn.TIME] = spans[i // axes, Stretch.STEP]
        write_components(int(path[Path.COMPONENTS]), links[i, :, :])
        for column in range(int(GridColumn.ENDS), GridColumn.SIZE):
            promised = promised + links[i, Link.GRADIENT, column] * links[i, Link.STEP, column]
    return -promised


def write_components(count: int, link: 'float[:,:]') -> None:
    """Write the step of the components, each of which follows from what is before it."""
    for i in range(GridColumn.TIME - GridColumn.COMPONENTS):
        column = GridColumn.COMPONENTS + i
        step = 0.0
        if i < count:
            step = -link[Link.SLOPE, column]
            for j in range(int(GridColumn.ENDS), column):
                step = step - link[Link.SOLVED + i, j] * link[Link.STEP, j]
            step = step - link[Link.SOLVED + i, GridColumn.TIME] * link[Link.STEP, GridColumn.TIME]
        link[Link.STEP, column] = step
