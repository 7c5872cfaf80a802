"""Slope and curvature of the barrier by the variables of a link; its components are eliminated.

Durations change as T / (1 - s), s being the step: so a step never makes one negative. The model is
that of the tried point.
"""

from segfmu.kernels.passage.barrier import write_node_shares
from segfmu.kernels.passage.records import (
    Cells,
    GridColumn,
    GridRow,
    Link,
    Outer,
    Pair,
    Path,
    Square,
)


def weigh_row(
    row: int, path: 'float[:]', grid: 'float[:,:]', square: 'float[:,:]'
) -> 'tuple[float, float, float]':
    """Write by how much a share adds to the barrier's derivatives by two columns (`add_rows`).

    Returned: its part of slope, and of curvature, by the logarithm of the duration. A column has a
    power of the duration, and the share that of its derivative less.
    """
    derivative = int(grid[row, GridRow.ORDER])
    scale = square[Square.SCALE, derivative]
    slope, bend = 0.0, 0.0
    for group in range(GridRow.CONTROL_PART - GridRow.PART + 1):
        exponent = group - derivative
        if group == GridRow.CONTROL_PART - GridRow.PART:
            exponent = int(path[Path.ORDER]) - derivative
        part = scale * grid[row, GridRow.PART + group] * exponent
        slope = slope + part
        bend = bend + part * (exponent + 1)
    share = grid[row, GridRow.SHARE]
    inner = (1.0 - share) * (1.0 + share)
    first = 2.0 * share / inner
    second = 2.0 * (1.0 + share * share) / (inner * inner)
    grid[row, GridRow.PULL] = first * scale
    grid[row, GridRow.CROSSED] = (second * slope - first * derivative) * scale
    grid[row, GridRow.CURVE] = second * scale * scale
    return first * slope, first * bend, second * slope * slope


def add_rows(
    row: int, count: int, link: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]'
) -> None:
    """Add four rows to gradient and Hessian, but for the units of their columns.

    Each is passed through once for four rows: the sums cost more to fetch than to make.
    """
    last = row + 3
    one, two, three, four = grid[row, :], grid[row + 1, :], grid[row + 2, :], grid[last, :]
    for j in range(int(GridColumn.ENDS), count):
        by = GridRow.BY + j
        pull = one[GridRow.PULL] * one[by] + two[GridRow.PULL] * two[by]
        pull = pull + three[GridRow.PULL] * three[by] + four[GridRow.PULL] * four[by]
        link[Link.GRADIENT, j] = link[Link.GRADIENT, j] + pull
        crossed = one[GridRow.CROSSED] * one[by] + two[GridRow.CROSSED] * two[by]
        crossed = crossed + three[GridRow.CROSSED] * three[by] + four[GridRow.CROSSED] * four[by]
        square[Square.CROSS, j] = square[Square.CROSS, j] + crossed
    first, second = one[GridRow.CURVE], two[GridRow.CURVE]
    third, fourth = three[GridRow.CURVE], four[GridRow.CURVE]
    for place in range(pair_place(count, GridColumn.ENDS)):
        product = GridRow.PRODUCT + place
        added = first * one[product] + second * two[product]
        added = added + third * three[product] + fourth * four[product]
        square[Square.HESSIAN, place] = square[Square.HESSIAN, place] + added


def pair_place(one: int, other: int) -> int:
    """Where two columns, `one` no sooner than `other`, have their entry (Pair)."""
    row = one - GridColumn.ENDS
    place = row * (row + 1) // 2
    return place + other - GridColumn.ENDS


def give_units(count: int, link: 'float[:,:]', square: 'float[:,:]') -> None:
    """Multiply Hessian and gradient by the units of their columns."""
    place = 0
    for j in range(int(GridColumn.ENDS), count):
        unit = square[Square.UNIT, j]
        power = square[Square.POWER, j]
        link[Link.GRADIENT, j] = unit * link[Link.GRADIENT, j]
        crossed = unit * square[Square.CROSS, j]
        square[Square.CROSS, j] = crossed + power * link[Link.GRADIENT, j]
        for k in range(int(GridColumn.ENDS), j + 1):
            value = unit * square[Square.UNIT, k] * square[Square.HESSIAN, place]
            square[Square.HESSIAN, place] = value
            place = place + 1


def write_model(
    ridge: float, path: 'float[:]', track: 'float[:]', time: float, link: 'float[:,:]',
    grid: 'float[:,:]', square: 'float[:,:]',
) -> None:
    """Write gradient, and slope and curvature without the components, of a link's tried point.

    ridge: share by which the diagonal of states and duration grows.
    """
    write_node_shares(path, track, time, link, grid, square)
    for j in range(GridColumn.SIZE):
        link[Link.GRADIENT, j] = 0.0
        square[Square.CROSS, j] = 0.0
    for place in range(Pair.SIZE):
        square[Square.HESSIAN, place] = 0.0
    count = int(GridColumn.COMPONENTS + path[Path.COMPONENTS])
    slope, bend, curvature = 0.0, 0.0, 0.0
    for i in range(int(path[Path.ROWS])):
        own_slope, own_bend, own_curvature = weigh_row(i, path, grid, square)
        slope = slope + own_slope
        bend = bend + own_bend
        curvature = curvature + own_curvature
    for i in range(0, Cells.ROWS, 4):
        add_rows(i, count, link, grid, square)
    give_units(count, link, square)
    link[Link.GRADIENT, GridColumn.TIME] = slope
    for j in range(int(GridColumn.ENDS), GridColumn.COMPONENTS):
        place = pair_place(j, j)
        square[Square.HESSIAN, place] = (1.0 + ridge) * square[Square.HESSIAN, place]
    square[Square.CROSS, GridColumn.TIME] = (1.0 + ridge) * curvature + bend
    eliminate(int(path[Path.COMPONENTS]), link, square)


def eliminate(count: int, link: 'float[:,:]', square: 'float[:,:]') -> None:
    """Write the components by what is before them, and what is left of slope and curvature.

    The last component goes first (Cholesky's method without roots): each follows from the states
    at the ends, the duration, and the components before it.
    """
    time = int(GridColumn.TIME)
    for j in range(GridColumn.SIZE):
        link[Link.SLOPE, j] = link[Link.GRADIENT, j]
    for step in range(count):
        i = int(GridColumn.COMPONENTS) + count - 1 - step
        own = pair_place(i, int(GridColumn.ENDS))
        curve = square[Square.HESSIAN, pair_place(i, i)]
        row = Link.SOLVED + i - int(GridColumn.COMPONENTS)
        crossed = square[Square.CROSS, i]
        slope = link[Link.SLOPE, i]
        place = 0
        for j in range(int(GridColumn.ENDS), i):
            factor = square[Square.HESSIAN, own + j - int(GridColumn.ENDS)] / curve
            link[row, j] = factor
            for k in range(j - int(GridColumn.ENDS) + 1):
                other = square[Square.HESSIAN, own + k]
                square[Square.HESSIAN, place] = square[Square.HESSIAN, place] - factor * other
                place = place + 1
            square[Square.CROSS, j] = square[Square.CROSS, j] - factor * crossed
            link[Link.SLOPE, j] = link[Link.SLOPE, j] - factor * slope
        link[row, time] = crossed / curve
        square[Square.CROSS, time] = square[Square.CROSS, time] - crossed / curve * crossed
        link[Link.SLOPE, time] = link[Link.SLOPE, time] - crossed / curve * slope
        link[Link.SLOPE, i] = slope / curve
    write_curve(link, square)


def write_curve(link: 'float[:,:]', square: 'float[:,:]') -> None:
    """Copy what is left of the curvature, by the states at the ends and the duration (Outer)."""
    place = 0
    for j in range(Outer.TIME):
        for k in range(j + 1):
            link[Link.CURVE + j, k] = square[Square.HESSIAN, place]
            link[Link.CURVE + k, j] = square[Square.HESSIAN, place]
            place = place + 1
        crossed = square[Square.CROSS, GridColumn.ENDS + j]
        link[Link.CURVE + j, Outer.TIME] = crossed
    last = Link.CURVE + Outer.TIME
    link[last, Outer.TIME] = square[Square.CROSS, GridColumn.TIME]
