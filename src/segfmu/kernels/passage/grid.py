"""A motion between two waypoints on a grid: the control is constant in each of its cells.

The control is the derivative of the order r. What the ends require of it, and what changes nothing
there, are separated, so all conditions at the ends hold by construction. Time runs from 0 to 1.
grid (12 r + 12 - r or more, GridRow); square (Square rows, Square columns).
"""

from math import sqrt

from segfmu.kernels.numerics.matrices import matrix_solve
from segfmu.kernels.passage.records import Cells, GridColumn, GridRow, Square


def power_over_factorial(base: float, exponent: int) -> float:
    """base^exponent / exponent!; 0 for an exponent below 0."""
    if exponent < 0:
        return 0.0
    value = 1.0
    for i in range(exponent):
        value = value * base / (i + 1)
    return value


def control_effect(order: int, derivative: int, cell: int, node: int) -> float:
    """What the control in a cell adds to a derivative at a node after it."""
    if node <= cell:
        return 0.0
    count = float(Cells.COUNT)
    begin = power_over_factorial((node - cell) / count, order - derivative)
    return begin - power_over_factorial((node - cell - 1) / count, order - derivative)


def end_effect(derivative: int, column: int, time: float) -> float:
    """What velocity or acceleration at the start adds to a derivative; 0 for other columns."""
    state = column - GridColumn.DISTANCE
    if state == 1 or state == 2:
        return power_over_factorial(time, state - derivative)
    return 0.0


def is_required(derivative: int, column: int) -> bool:
    """Whether a column is the value of a derivative at the end: distance, velocity, acceleration"""
    if derivative == 0:
        return column == GridColumn.DISTANCE
    return derivative < 3 and column == GridColumn.ENDS + derivative + 1


def write_grid(order: int, grid: 'float[:,:]', square: 'float[:,:]') -> None:
    """Write how the derivatives up to the control's order depend on the columns."""
    first = order * Cells.INNER
    # rows that this order does not use count for nothing
    grid[:, :] = 0.0
    for i in range(first + Cells.COUNT):
        grid[i, GridRow.ORDER] = min(i // Cells.INNER, order)
    write_least_controls(order, first, grid, square)
    write_free_controls(order, first, grid, square)
    for i in range(first):
        derivative = i // Cells.INNER
        node = i % Cells.INNER + 1
        for j in range(GridColumn.TIME):
            total = end_effect(derivative, j, node / float(Cells.COUNT))
            for cell in range(node):
                effect = control_effect(order, derivative, cell, node)
                total = total + effect * grid[first + cell, GridRow.BY + j]
            grid[i, GridRow.BY + j] = total
    for i in range(first + Cells.COUNT):
        write_products(grid[i, :])


def write_products(row: 'float[:]') -> None:
    """Write the products of a row's dependences: a model of the barrier takes them often."""
    place = int(GridRow.PRODUCT)
    for j in range(int(GridColumn.ENDS), GridColumn.TIME):
        for k in range(int(GridColumn.ENDS), j + 1):
            row[place] = row[GridRow.BY + j] * row[GridRow.BY + k]
            place = place + 1


def write_least_controls(order: int, first: int, grid: 'float[:,:]', square: 'float[:,:]') -> None:
    """Write the controls of least norm that meet the conditions at the end."""
    own, right = square[Square.OWN:Square.RIGHT, :], square[Square.RIGHT:Square.BASIS, :]
    for i in range(order):
        for j in range(order):
            own[i, j] = 0.0
            for cell in range(Cells.COUNT):
                effect = control_effect(order, i, cell, Cells.COUNT)
                own[i, j] = own[i, j] + effect * control_effect(order, j, cell, Cells.COUNT)
        for j in range(GridColumn.COMPONENTS):
            right[i, j] = -end_effect(i, j, 1.0)
            if is_required(i, j):
                right[i, j] = right[i, j] + 1.0
    matrix_solve(order, int(GridColumn.COMPONENTS), own, right)
    for cell in range(Cells.COUNT):
        for j in range(GridColumn.COMPONENTS):
            total = 0.0
            for i in range(order):
                total = total + control_effect(order, i, cell, Cells.COUNT) * right[i, j]
            grid[first + cell, GridRow.BY + j] = total


def write_free_controls(order: int, first: int, grid: 'float[:,:]', square: 'float[:,:]') -> None:
    """Write orthogonal controls that change nothing at the ends, of the norm of a control of 1.

    Differences of the control's order sum every polynomial below that order to zero.
    """
    basis = square[Square.BASIS:Square.SIZE, :]
    for i in range(Cells.COUNT - order):
        for cell in range(Cells.COUNT):
            basis[i, cell] = 0.0
        value = 1.0
        for k in range(order + 1):
            basis[i, i + k] = value
            value = -value * (order - k) / (k + 1)
        # twice, as the first time leaves rounding errors of what is taken away
        for sweep in range(2):
            for other in range(i):
                project_out(other, i, basis)
        norm = 0.0
        for cell in range(Cells.COUNT):
            norm = norm + basis[i, cell] * basis[i, cell]
        for cell in range(Cells.COUNT):
            basis[i, cell] = basis[i, cell] / sqrt(norm)
            value = basis[i, cell] * sqrt(float(Cells.COUNT))
            grid[first + cell, GridRow.BY + GridColumn.COMPONENTS + i] = value


def project_out(unit: int, row: int, basis: 'float[:,:]') -> None:
    """Take the part along a unit vector out of a row."""
    total = 0.0
    for cell in range(Cells.COUNT):
        total = total + basis[unit, cell] * basis[row, cell]
    for cell in range(Cells.COUNT):
        basis[row, cell] = basis[row, cell] - total * basis[unit, cell]
