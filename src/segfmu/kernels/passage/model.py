"""Slope and curvature of the barrier by the variables of a link; its components are eliminated.

Durations change as T / (1 - s), s being the step: so a step never makes one negative. The model is
that of the tried point.
"""

from segfmu.kernels.numerics.matrices import matrix_solve
from segfmu.kernels.passage.barrier import write_node_shares
from segfmu.kernels.passage.records import (
    Free,
    GridColumn,
    GridRow,
    Link,
    Pair,
    Path,
    Solved,
    Square,
)


def row_change(
    row: int, count: int, grid: 'float[:,:]', square: 'float[:,:]'
) -> 'tuple[float, float]':
    """Slope and curvature of a share by the logarithm of the duration.

    A column has a power of the duration, and the share that of its derivative less.
    """
    derivative = int(grid[row, GridRow.ORDER])
    slope, bend = 0.0, 0.0
    for power in range(3):
        part = 0.0
        if power == 0:
            part = grid[row, GridRow.BY] * square[Square.PART, GridColumn.DISTANCE]
        else:
            for end in range(2):
                j = GridColumn.ENDS + end * Free.SIZE + power - 1
                part = part + grid[row, GridRow.BY + j] * square[Square.PART, j]
        exponent = power - derivative
        slope = slope + part * exponent
        bend = bend + part * exponent * (exponent + 1)
    part = 0.0
    for j in range(int(GridColumn.COMPONENTS), count):
        part = part + grid[row, GridRow.BY + j] * square[Square.PART, j]
    exponent = int(square[Square.POWER, GridColumn.COMPONENTS]) - derivative
    slope = slope + part * exponent
    bend = bend + part * exponent * (exponent + 1)
    scale = square[Square.SCALE, derivative]
    return scale * slope, scale * bend


def add_share(
    row: int, count: int, link: 'float[:,:]', grid: 'float[:,:]', square: 'float[:,:]'
) -> float:
    """Add the barrier of a share to Hessian and gradient, but for the units of their columns.

    Returns its part of the curvature by the duration.
    """
    derivative = int(grid[row, GridRow.ORDER])
    slope, bend = row_change(row, count, grid, square)
    share = grid[row, GridRow.SHARE]
    inner = (1.0 - share) * (1.0 + share)
    first = 2.0 * share / inner
    second = 2.0 * (1.0 + share * share) / (inner * inner)
    scale = square[Square.SCALE, derivative]
    pull = first * scale
    crossed = (second * slope - first * derivative) * scale
    curve = second * scale * scale
    for j in range(int(GridColumn.ENDS), count):
        by = grid[row, GridRow.BY + j]
        link[Link.GRADIENT, j] = link[Link.GRADIENT, j] + pull * by
        square[Square.CROSS, j] = square[Square.CROSS, j] + crossed * by
    # in one pass: loops over the short rows of the Hessian take several times as long
    for place in range(pair_place(count, GridColumn.ENDS)):
        added = curve * grid[row, GridRow.PRODUCT + place]
        square[Square.HESSIAN, place] = square[Square.HESSIAN, place] + added
    link[Link.GRADIENT, GridColumn.TIME] = link[Link.GRADIENT, GridColumn.TIME] + first * slope
    square[Square.CROSS, GridColumn.TIME] = square[Square.CROSS, GridColumn.TIME] + first * bend
    return second * slope * slope


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
    curvature = 0.0
    for i in range(int(path[Path.ROWS])):
        if link[Link.SCALE, int(grid[i, GridRow.ORDER])] > 0.0:
            curvature = curvature + add_share(i, count, link, grid, square)
    give_units(count, link, square)
    for j in range(int(GridColumn.ENDS), GridColumn.COMPONENTS):
        place = pair_place(j, j)
        square[Square.HESSIAN, place] = (1.0 + ridge) * square[Square.HESSIAN, place]
    curvature = (1.0 + ridge) * curvature
    square[Square.CROSS, GridColumn.TIME] = curvature + square[Square.CROSS, GridColumn.TIME]
    eliminate(int(path[Path.COMPONENTS]), link, square)


def hessian_entry(one: int, other: int, square: 'float[:,:]') -> float:
    """An entry of the Hessian, that of the duration included."""
    first = max(one, other)
    second = min(one, other)
    if first == GridColumn.TIME:
        return square[Square.CROSS, second]
    return square[Square.HESSIAN, pair_place(first, second)]


def outer_column(place: int) -> int:
    """The column (GridColumn) of a state at an end or the duration, by its place in Solved."""
    return int(GridColumn.TIME) if place == Solved.TIME else int(GridColumn.ENDS + place)


def eliminate(count: int, link: 'float[:,:]', square: 'float[:,:]') -> None:
    """Write the components by what is around them, and what is left of slope and curvature."""
    own, coupled = square[Square.OWN:Square.RIGHT, :], square[Square.RIGHT:Square.BASIS, :]
    solved = link[Link.SOLVED:Link.KEPT, :]
    for i in range(count):
        for j in range(count):
            own[i, j] = hessian_entry(GridColumn.COMPONENTS + i, GridColumn.COMPONENTS + j, square)
        for j in range(Solved.ALONE):
            coupled[i, j] = hessian_entry(GridColumn.COMPONENTS + i, outer_column(j), square)
            solved[i, j] = coupled[i, j]
        solved[i, Solved.ALONE] = link[Link.GRADIENT, GridColumn.COMPONENTS + i]
    matrix_solve(count, int(Solved.SIZE), own, solved)
    for j in range(Solved.ALONE):
        column = outer_column(j)
        slope = link[Link.GRADIENT, column]
        for i in range(count):
            slope = slope - coupled[i, j] * solved[i, Solved.ALONE]
        link[Link.SLOPE, j] = slope
        for k in range(Solved.ALONE):
            value = hessian_entry(column, outer_column(k), square)
            for i in range(count):
                value = value - coupled[i, j] * solved[i, k]
            link[Link.CURVE + j, k] = value
