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
    slope = 0.0
    bend = 0.0
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
) -> None:
    """Add the barrier of a share to Hessian and gradient, but for the units of their columns."""
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
        value = curve * by
        for k in range(int(GridColumn.ENDS), j + 1):
            added = value * grid[row, GridRow.BY + k]
            square[Square.HESSIAN + j, k] = square[Square.HESSIAN + j, k] + added
    time = Square.HESSIAN + GridColumn.TIME
    link[Link.GRADIENT, GridColumn.TIME] = link[Link.GRADIENT, GridColumn.TIME] + first * slope
    square[time, GridColumn.TIME] = square[time, GridColumn.TIME] + second * slope * slope
    square[Square.CROSS, GridColumn.TIME] = square[Square.CROSS, GridColumn.TIME] + first * bend


def give_units(count: int, link: 'float[:,:]', square: 'float[:,:]') -> None:
    """Multiply Hessian and gradient by the units of their columns."""
    for j in range(int(GridColumn.ENDS), count):
        unit = square[Square.UNIT, j]
        power = square[Square.POWER, j]
        link[Link.GRADIENT, j] = unit * link[Link.GRADIENT, j]
        crossed = unit * square[Square.CROSS, j]
        square[Square.CROSS, j] = crossed + power * link[Link.GRADIENT, j]
        for k in range(int(GridColumn.ENDS), j + 1):
            value = unit * square[Square.UNIT, k] * square[Square.HESSIAN + j, k]
            square[Square.HESSIAN + j, k] = value


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
        for k in range(GridColumn.SIZE):
            square[Square.HESSIAN + j, k] = 0.0
    count = int(GridColumn.COMPONENTS + path[Path.COMPONENTS])
    for i in range(int(path[Path.ROWS])):
        if link[Link.SCALE, int(grid[i, GridRow.ORDER])] > 0.0:
            add_share(i, count, link, grid, square)
    give_units(count, link, square)
    for j in range(int(GridColumn.ENDS), GridColumn.COMPONENTS):
        diagonal = square[Square.HESSIAN + j, j]
        square[Square.HESSIAN + j, j] = (1.0 + ridge) * diagonal
    row = Square.HESSIAN + GridColumn.TIME
    diagonal = (1.0 + ridge) * square[row, GridColumn.TIME]
    square[row, GridColumn.TIME] = diagonal + square[Square.CROSS, GridColumn.TIME]
    eliminate(int(path[Path.COMPONENTS]), link, square)


def hessian_entry(one: int, other: int, square: 'float[:,:]') -> float:
    """An entry of the Hessian, of which the lower half and the duration's slopes are written."""
    first = max(one, other)
    second = min(one, other)
    if first == GridColumn.TIME and second != first:
        return square[Square.CROSS, second]
    return square[Square.HESSIAN + first, second]


def outer_column(place: int) -> int:
    """The column (GridColumn) of a state at an end or the duration, by its place in Solved."""
    if place == Solved.TIME:
        return int(GridColumn.TIME)
    return int(GridColumn.ENDS + place)


def eliminate(count: int, link: 'float[:,:]', square: 'float[:,:]') -> None:
    """Write the components by what is around them, and what is left of slope and curvature."""
    own = square[Square.OWN:Square.RIGHT, :]
    right = square[Square.RIGHT:Square.BASIS, :]
    for i in range(count):
        for j in range(count):
            own[i, j] = hessian_entry(GridColumn.COMPONENTS + i, GridColumn.COMPONENTS + j, square)
        for j in range(Solved.ALONE):
            right[i, j] = hessian_entry(GridColumn.COMPONENTS + i, outer_column(j), square)
        right[i, Solved.ALONE] = link[Link.GRADIENT, GridColumn.COMPONENTS + i]
    matrix_solve(count, int(Solved.SIZE), own, right)
    for i in range(count):
        for j in range(Solved.SIZE):
            link[Link.SOLVED + i, j] = right[i, j]
    for j in range(Solved.ALONE):
        column = outer_column(j)
        slope = link[Link.GRADIENT, column]
        for i in range(count):
            coupled = hessian_entry(column, GridColumn.COMPONENTS + i, square)
            slope = slope - coupled * right[i, Solved.ALONE]
        link[Link.SLOPE, j] = slope
        for k in range(Solved.ALONE):
            value = hessian_entry(column, outer_column(k), square)
            for i in range(count):
                coupled = hessian_entry(column, GridColumn.COMPONENTS + i, square)
                value = value - coupled * right[i, k]
            link[Link.CURVE + j, k] = value
