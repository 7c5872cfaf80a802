"""Equations of the control points: a banded matrix, as a bound concerns few that are neighbours."""

from segfmu.kernels.numerics.banded import band_factor, band_substitute
from segfmu.kernels.spline.records import Bound, ControlPoint, Mesh, Program, SplineWork


def spread_by(bound: 'float[:]', amount: float, column: int, work: 'float[:,:]') -> None:
    """Add an amount, by a bound's dependences, to a column of the control points."""
    for k in range(int(bound[Bound.COUNT])):
        place = SplineWork.POINTS + int(bound[Bound.FIRST]) + k
        work[place, column] = work[place, column] + amount * bound[Bound.BY + k]


def sum_by(bound: 'float[:]', column: int, work: 'float[:,:]') -> float:
    """Sum of a column of the control points by a bound's dependences."""
    total = 0.0
    for k in range(int(bound[Bound.COUNT])):
        place = SplineWork.POINTS + int(bound[Bound.FIRST]) + k
        total = total + bound[Bound.BY + k] * work[place, column]
    return total


def clear_column(column: int, work: 'float[:,:]') -> None:
    """Set a column of the control points to zero."""
    for i in range(Mesh.POINTS):
        work[SplineWork.POINTS + i, column] = 0.0


def add_square(bound: 'float[:]', weight: float, work: 'float[:,:]') -> None:
    """Add the square of a bound's dependences to the matrix."""
    for k in range(int(bound[Bound.COUNT])):
        place = SplineWork.POINTS + int(bound[Bound.FIRST]) + k
        by = weight * bound[Bound.BY + k]
        for i in range(k + 1):
            column = ControlPoint.BAND + i
            work[place, column] = work[place, column] + by * bound[Bound.BY + k - i]


def clear_matrix(work: 'float[:,:]') -> None:
    """Set the matrix to zero, and to one for control points that are given."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    for i in range(Mesh.POINTS):
        for k in range(degree + 1):
            work[SplineWork.POINTS + i, ControlPoint.BAND + k] = 0.0
        if i < degree or i >= Mesh.CELLS:
            work[SplineWork.POINTS + i, ControlPoint.BAND] = 1.0


def solve_points(column: int, work: 'float[:,:]') -> None:
    """Replace a column of the control points by the solution for it."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    points = work[SplineWork.POINTS:SplineWork.BOUNDS, :]
    band_substitute(degree + 1, ControlPoint.BAND, column, points)


def factor_matrix(work: 'float[:,:]') -> bool:
    """Factor the matrix; False if it is not positive definite."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    points = work[SplineWork.POINTS:SplineWork.BOUNDS, :]
    return band_factor(degree + 1, ControlPoint.BAND, points)


def begin_smoothly(order: int, work: 'float[:,:]') -> bool:
    """Set the control points that have the least sum of squares of the derivative of an order."""
    clear_matrix(work)
    clear_column(ControlPoint.STEP, work)
    for i in range(int(work[SplineWork.PROGRAM, Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        if int(bound[Bound.ORDER]) == order:
            add_square(bound, 1.0, work)
            spread_by(bound, -bound[Bound.GIVEN], ControlPoint.STEP, work)
    if not factor_matrix(work):
        return False
    solve_points(ControlPoint.STEP, work)
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    for i in range(degree, int(Mesh.CELLS)):
        point = work[SplineWork.POINTS + i, :]
        point[ControlPoint.VALUE] = point[ControlPoint.STEP]
    return True
