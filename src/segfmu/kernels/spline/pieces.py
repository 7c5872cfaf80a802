"""The polynomial pieces of a spline: one for each cell, in which the highest derivative is held."""

from math import sqrt

from segfmu.kernels.spline.basis import rise_factor
from segfmu.kernels.spline.motion import scale_states
from segfmu.kernels.spline.records import ControlPoint, Level, Mesh, Program, SplineWork
from segfmu.kernels.trajectory.pieces import append_piece, clear_piece, set_held

# corrections of the end by rounding errors
CORRECTIONS = 3


def cell_levels(work: 'float[:,:]') -> None:
    """Write the highest derivative in each cell, from the control points of the position."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    points = work[SplineWork.POINTS:SplineWork.BOUNDS, :]
    for i in range(Mesh.CELLS + degree):
        points[i, ControlPoint.STEP] = points[i, ControlPoint.VALUE]
    for order in range(1, degree + 1):
        for i in range(Mesh.CELLS + degree - order):
            change = points[i + 1, ControlPoint.STEP] - points[i, ControlPoint.STEP]
            points[i, ControlPoint.STEP] = change * rise_factor(order, i, degree)
    for cell in range(Mesh.CELLS):
        work[SplineWork.LEVELS + cell, Level.VALUE] = points[cell, ControlPoint.STEP]


def end_gain(power: int, cell: int) -> float:
    """By what a level of 1 in a cell changes the derivative `power` orders below at the end."""
    before = 1.0 - cell / float(Mesh.CELLS)
    after = 1.0 - (cell + 1) / float(Mesh.CELLS)
    gain, first, last = 1.0, 1.0, 1.0
    for k in range(1, power + 1):
        first = first * before / k
        last = last * after / k
        gain = first - last
    return gain


def write_gains(work: 'float[:,:]') -> None:
    """Write orthogonal levels of norm 1: the first i of them span what i derivatives follow."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    levels = work[SplineWork.LEVELS:SplineWork.SIZE, :]
    for i in range(degree):
        own = Level.GAIN + i
        for cell in range(Mesh.CELLS):
            levels[cell, own] = end_gain(i + 1, cell)
        # twice, as the first time leaves rounding errors of what is taken away
        for sweep in range(2):
            for k in range(i):
                other = Level.GAIN + k
                total = 0.0
                for cell in range(Mesh.CELLS):
                    total = total + levels[cell, own] * levels[cell, other]
                for cell in range(Mesh.CELLS):
                    levels[cell, own] = levels[cell, own] - total * levels[cell, other]
        norm = 0.0
        for cell in range(Mesh.CELLS):
            norm = norm + levels[cell, own] * levels[cell, own]
        for cell in range(Mesh.CELLS):
            levels[cell, own] = levels[cell, own] / sqrt(norm)


def write_missed(work: 'float[:,:]') -> None:
    """Write what the levels miss of the state at the end."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    missed = work[SplineWork.MISSED, :]
    for order in range(degree):
        missed[order] = work[SplineWork.BEGIN, order]
    for cell in range(Mesh.CELLS):
        level = work[SplineWork.LEVELS + cell, Level.VALUE]
        for order in range(degree):
            factor = 1.0
            total = missed[order]
            for k in range(1, degree - order + 1):
                factor = factor / (Mesh.CELLS * float(k))
                above = level
                if order + k < degree:
                    above = missed[order + k]
                total = total + above * factor
            missed[order] = total
    for order in range(degree):
        missed[order] = work[SplineWork.END, order] - missed[order]


def correct_end(work: 'float[:,:]') -> None:
    """Change the levels as little as possible so that they lead to the end."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    levels = work[SplineWork.LEVELS:SplineWork.SIZE, :]
    write_missed(work)
    for i in range(degree):
        own = Level.GAIN + i
        by = 0.0
        for cell in range(Mesh.CELLS):
            by = by + levels[cell, own] * end_gain(i + 1, cell)
        amount = work[SplineWork.MISSED, degree - 1 - i] / by
        for cell in range(Mesh.CELLS):
            levels[cell, Level.VALUE] = levels[cell, Level.VALUE] + amount * levels[cell, own]
        # the derivatives below follow as well
        for order in range(degree - 1 - i):
            effect = 0.0
            for cell in range(Mesh.CELLS):
                effect = effect + levels[cell, own] * end_gain(degree - order, cell)
            missed = work[SplineWork.MISSED, order]
            work[SplineWork.MISSED, order] = missed - amount * effect


def end_levels(
    duration: float, first: 'float[:]', last: 'float[:]', work: 'float[:,:]'
) -> float:
    """Write the levels of the motion found by `spline_share`; by what to multiply them.

    duration, first and last are as there.
    """
    unit = scale_states(duration, first, last, work)
    cell_levels(work)
    write_gains(work)
    for correction in range(CORRECTIONS):
        correct_end(work)
    scale = unit
    for order in range(int(work[SplineWork.PROGRAM, Program.DEGREE])):
        scale = scale / duration
    return scale


def append_spline(
    duration: float, first: 'float[:]', last: 'float[:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]', row: int, state: 'float[:]', work: 'float[:,:]',
) -> int:
    """Write the pieces of the motion found by `spline_share` from `row` on; the row after them.

    duration, first and last are as there. state (PieceState): that at the start of the motion,
    which is advanced to its end.
    """
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    scale = end_levels(duration, first, last, work)
    for cell in range(Mesh.CELLS):
        set_held(degree - 2, scale * work[SplineWork.LEVELS + cell, Level.VALUE], state)
        clear_piece(coefficients, row)
        row = append_piece(duration / float(Mesh.CELLS), timing, coefficients, row, state)
    return row
