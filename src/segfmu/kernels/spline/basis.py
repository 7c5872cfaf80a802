"""The control points of a spline's derivatives, and those of the same spline over more knots.

A spline of degree p has p knots at either end, and equal cells between. Its derivatives are splines
as well, whose control points are differences of those of the next lower order (de Boor, A Practical
Guide to Splines, ch. X). All depend on the control points of the position, whose first and last p
follow from the states at the ends. The time is that over the duration, from 0 to 1.
"""

from segfmu.kernels.numerics.numbers import EQUAL
from segfmu.kernels.spline.records import Bound, ControlPoint, Mesh, Program, SplineWork


def cell_knot(i: int, degree: int) -> float:
    """The knot in a place; those of the ends are repeated."""
    return min(max((i - degree) / float(Mesh.CELLS), 0.0), 1.0)


def fine_knot(i: int, degree: int) -> float:
    """The same of the finer spline."""
    return min(max((i - degree) / float(Mesh.CELLS * Mesh.FINER), 0.0), 1.0)


def rise_factor(order: int, j: int, degree: int) -> float:
    """By what a difference of control points is multiplied in the derivative of an order."""
    span = cell_knot(j + degree + 1, degree) - cell_knot(j + order, degree)
    return (degree - order + 1) / span


def write_end_points(work: 'float[:,:]') -> None:
    """Write the control points that follow from the states at both ends, which are overwritten."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    begin, end = work[SplineWork.BEGIN, :], work[SplineWork.END, :]
    last = Mesh.CELLS + degree - 1
    for i in range(degree):
        # begin and end have the derivatives of all orders, each i places from the end
        work[SplineWork.POINTS + i, ControlPoint.VALUE] = begin[0]
        place = last - i
        work[SplineWork.POINTS + place, ControlPoint.VALUE] = end[0]
        for order in range(1, degree - i):
            begin[order - 1] = begin[order - 1] + begin[order] / rise_factor(order, i, degree)
            j = place - order
            end[order - 1] = end[order - 1] - end[order] / rise_factor(order, j, degree)


def keep_row(order: int, first: int, count: int, work: 'float[:,:]') -> None:
    """Keep the row after the last bound, which depends on control points from `first` on.

    What the ends give is summed up. Nothing is kept where they give all but for rounding.
    """
    program = work[SplineWork.PROGRAM, :]
    degree = int(program[Program.DEGREE])
    row = SplineWork.BOUNDS + int(program[Program.COUNT])
    bound = work[row, :]
    bound[Bound.GIVEN] = 0.0
    used, weight = 0, 0.0
    begin = max(first, degree)
    for k in range(count):
        by = bound[Bound.BY + k]
        place = SplineWork.POINTS + first + k
        if first + k < degree or first + k >= Mesh.CELLS:
            bound[Bound.GIVEN] = bound[Bound.GIVEN] + by * work[place, ControlPoint.VALUE]
        else:
            bound[Bound.BY + used] = by
            used = used + 1
            weight = weight + abs(by)
    bound[Bound.FIRST] = begin
    bound[Bound.COUNT] = used
    bound[Bound.ORDER] = order
    if weight > EQUAL:
        program[Program.COUNT] = program[Program.COUNT] + 1.0


def derivative_rows(order: int, work: 'float[:,:]') -> None:
    """Add the control points of the derivative of an order, from 1 on, to the bounds."""
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    for j in range(Mesh.CELLS + degree - order):
        row = SplineWork.BOUNDS + int(work[SplineWork.PROGRAM, Program.COUNT])
        bound = work[row, :]
        for k in range(degree + 1):
            bound[Bound.BY + k] = 0.0
        bound[Bound.BY] = 1.0
        # weights of control points of the next lower order, down to the position
        for step in range(order):
            lower = order - step
            for k in range(step + 1):
                i = step - k
                weight = bound[Bound.BY + i] * rise_factor(lower, j + i, degree)
                bound[Bound.BY + i + 1] = bound[Bound.BY + i + 1] + weight
                bound[Bound.BY + i] = -weight
        keep_row(order, j, order + 1, work)


def finer_rows(work: 'float[:,:]') -> None:
    """Add the control points of the finer spline to the bounds, by the Oslo algorithm.

    (Cohen, Lyche, Riesenfeld, Discrete B-splines, 1980)
    """
    degree = int(work[SplineWork.PROGRAM, Program.DEGREE])
    for j in range(Mesh.CELLS * Mesh.FINER + degree):
        row = SplineWork.BOUNDS + int(work[SplineWork.PROGRAM, Program.COUNT])
        bound = work[row, :]
        cell = min(max(j - degree, 0) // Mesh.FINER, Mesh.CELLS - 1)
        last = cell + degree
        bound[Bound.BY] = 1.0
        for k in range(1, degree + 1):
            t = fine_knot(j + k, degree)
            kept = 0.0
            for r in range(k):
                right = cell_knot(last + r + 1, degree)
                left = cell_knot(last + r + 1 - k, degree)
                part = bound[Bound.BY + r] / (right - left)
                bound[Bound.BY + r] = kept + (right - t) * part
                kept = (t - left) * part
            bound[Bound.BY + k] = kept
        keep_row(0, cell, degree + 1, work)
