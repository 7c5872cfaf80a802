"""The least share of limits that a spline needs: a linear program, by an interior-point method.

Bounds are linear in the free control points and in the share. Each has a slack and a price, whose
product goes to zero by Mehrotra's predictor and corrector (Wright, Primal-Dual Interior-Point
Methods, 1997, ch. 10). A step needs one banded system, of as many rows as there are control points:
a bound concerns few that lie next to each other.
"""

from segfmu.kernels.numerics.numbers import HALF_DIGITS, NEARLY, NEVER, SMALL, WORTH
from segfmu.kernels.spline.equations import (
    add_square,
    clear_column,
    clear_matrix,
    factor_matrix,
    solve_points,
    spread_by,
    sum_by,
)
from segfmu.kernels.spline.records import Bound, ControlPoint, Mesh, Program, SplineWork

# steps after which there is no solution
STEPS = 60
# of the way to where a slack or a price would be zero
BACK = 0.995


def begin_program(work: 'float[:,:]') -> None:
    """Set shares, slacks and prices at the start; limits are measured in what is used there."""
    program = work[SplineWork.PROGRAM, :]
    count = int(program[Program.COUNT])
    largest = 0.0
    for i in range(count):
        bound = work[SplineWork.BOUNDS + i, :]
        bound[Bound.VALUE] = sum_by(bound, ControlPoint.VALUE, work)
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER and bound[Bound.PART + side] > 0.0:
                sign = 1.0 - 2.0 * side
                used = sign * bound[Bound.VALUE] - bound[Bound.ROOM + side]
                largest = max(largest, used / bound[Bound.PART + side])
    program[Program.SCALE] = largest
    if largest <= 0.0:
        return
    program[Program.SHARE] = 1.0 + SMALL
    total = 0.0
    for i in range(count):
        bound = work[SplineWork.BOUNDS + i, :]
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                part = bound[Bound.PART + side] * program[Program.SCALE]
                bound[Bound.PART + side] = part
                slack = bound[Bound.ROOM + side] + part * program[Program.SHARE]
                slack = slack - (1.0 - 2.0 * side) * bound[Bound.VALUE]
                bound[Bound.SLACK + side] = max(slack, SMALL * max(part, SMALL))
                total = total + part / bound[Bound.SLACK + side]
    for i in range(count):
        bound = work[SplineWork.BOUNDS + i, :]
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                bound[Bound.PRICE + side] = 1.0 / (total * bound[Bound.SLACK + side])


def measure_gap(work: 'float[:,:]') -> 'tuple[float, float]':
    """The mean product of slack and price (Program.GAP), and the largest miss of a bound."""
    program = work[SplineWork.PROGRAM, :]
    product, terms, miss = 0.0, 0, 0.0
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        bound[Bound.VALUE] = sum_by(bound, ControlPoint.VALUE, work)
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                product = product + bound[Bound.SLACK + side] * bound[Bound.PRICE + side]
                terms = terms + 1
                miss = max(miss, abs(bound_miss(side, bound, program)))
    program[Program.GAP] = product / max(terms, 1)
    return product, miss


def bound_miss(side: int, bound: 'float[:]', program: 'float[:]') -> float:
    """What the slack of a bound is too large by, with the opposite sign."""
    given = bound[Bound.ROOM + side] + bound[Bound.PART + side] * program[Program.SHARE]
    return given - (1.0 - 2.0 * side) * bound[Bound.VALUE] - bound[Bound.SLACK + side]


def weigh_bounds(work: 'float[:,:]') -> bool:
    """Write and factor the equations of a step; False if that fails."""
    program = work[SplineWork.PROGRAM, :]
    program[Program.WEIGHT] = 0.0
    clear_matrix(work)
    clear_column(ControlPoint.SHARED, work)
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        square, crossed = 0.0, 0.0
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                weight = bound[Bound.PRICE + side] / bound[Bound.SLACK + side]
                part = weight * bound[Bound.PART + side]
                square = square + weight
                crossed = crossed + (1.0 - 2.0 * side) * part
                weight = part * bound[Bound.PART + side]
                program[Program.WEIGHT] = program[Program.WEIGHT] + weight
        add_square(bound, square, work)
        if crossed != 0.0:
            spread_by(bound, crossed, ControlPoint.SHARED, work)
    if not factor_matrix(work):
        return False
    # the share's own row, without the control points
    for i in range(Mesh.POINTS):
        point = work[SplineWork.POINTS + i, :]
        point[ControlPoint.STEP] = point[ControlPoint.SHARED]
    solve_points(ControlPoint.SHARED, work)
    for i in range(Mesh.POINTS):
        point = work[SplineWork.POINTS + i, :]
        product = point[ControlPoint.STEP] * point[ControlPoint.SHARED]
        program[Program.WEIGHT] = program[Program.WEIGHT] - product
    return program[Program.WEIGHT] > 0.0


def wanted_product(side: int, aim: float, corrected: bool, bound: 'float[:]') -> float:
    """What slack times price has to change by, to first order, so that it becomes `aim`."""
    product = aim - bound[Bound.SLACK + side] * bound[Bound.PRICE + side]
    if corrected:
        product = product - bound[Bound.SLACK_STEP + side] * bound[Bound.PRICE_STEP + side]
    return product


def step_towards(aim: float, corrected: bool, work: 'float[:,:]') -> None:
    """Write the step to products of slack and price of `aim`, from the factor of `weigh_bounds`.

    corrected: by the products of the present steps.
    """
    program = work[SplineWork.PROGRAM, :]
    slope = 1.0
    clear_column(ControlPoint.STEP, work)
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        total = 0.0
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                price = wanted_product(side, aim, corrected, bound)
                price = price - bound[Bound.PRICE + side] * bound_miss(side, bound, program)
                price = bound[Bound.PRICE + side] + price / bound[Bound.SLACK + side]
                total = total - (1.0 - 2.0 * side) * price
                slope = slope - bound[Bound.PART + side] * price
        spread_by(bound, total, ControlPoint.STEP, work)
    solve_share(slope, work)
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        change = sum_by(bound, ControlPoint.STEP, work)
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                slack = bound_miss(side, bound, program) - (1.0 - 2.0 * side) * change
                slack = slack + bound[Bound.PART + side] * program[Program.SHARE_STEP]
                price = wanted_product(side, aim, corrected, bound)
                price = price - bound[Bound.PRICE + side] * slack
                bound[Bound.SLACK_STEP + side] = slack
                bound[Bound.PRICE_STEP + side] = price / bound[Bound.SLACK + side]


def solve_share(slope: float, work: 'float[:,:]') -> None:
    """Solve for the steps of share and control points, whose right-hand side is in STEP.

    slope: right-hand side of the share's equation.
    """
    program = work[SplineWork.PROGRAM, :]
    for i in range(Mesh.POINTS):
        point = work[SplineWork.POINTS + i, :]
        slope = slope - point[ControlPoint.STEP] * point[ControlPoint.SHARED]
    step = -slope / program[Program.WEIGHT]
    program[Program.SHARE_STEP] = step
    solve_points(ControlPoint.STEP, work)
    for i in range(Mesh.POINTS):
        point = work[SplineWork.POINTS + i, :]
        point[ControlPoint.STEP] = point[ControlPoint.STEP] + step * point[ControlPoint.SHARED]


def step_lengths(work: 'float[:,:]') -> 'tuple[float, float, float]':
    """How far slacks and prices may go, up to 1, and the mean of their products there."""
    program = work[SplineWork.PROGRAM, :]
    slack, price = 1.0, 1.0
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                if bound[Bound.SLACK + side] < -slack * bound[Bound.SLACK_STEP + side]:
                    slack = -bound[Bound.SLACK + side] / bound[Bound.SLACK_STEP + side]
                if bound[Bound.PRICE + side] < -price * bound[Bound.PRICE_STEP + side]:
                    price = -bound[Bound.PRICE + side] / bound[Bound.PRICE_STEP + side]
    product, terms = 0.0, 0
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                left = bound[Bound.SLACK + side] + slack * bound[Bound.SLACK_STEP + side]
                cost = bound[Bound.PRICE + side] + price * bound[Bound.PRICE_STEP + side]
                product = product + left * cost
                terms = terms + 1
    return slack, price, product / max(terms, 1)


def go_along(slack: float, price: float, work: 'float[:,:]') -> None:
    """Go along the step, with slacks and prices by their own lengths."""
    program = work[SplineWork.PROGRAM, :]
    program[Program.SHARE] = program[Program.SHARE] + slack * program[Program.SHARE_STEP]
    for i in range(Mesh.POINTS):
        point = work[SplineWork.POINTS + i, :]
        point[ControlPoint.VALUE] = point[ControlPoint.VALUE] + slack * point[ControlPoint.STEP]
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                left = bound[Bound.SLACK + side] + slack * bound[Bound.SLACK_STEP + side]
                cost = bound[Bound.PRICE + side] + price * bound[Bound.PRICE_STEP + side]
                bound[Bound.SLACK + side] = left
                bound[Bound.PRICE + side] = cost


def lower_bound(work: 'float[:,:]') -> float:
    """What the share cannot be less than, where the prices are in balance."""
    program = work[SplineWork.PROGRAM, :]
    total = 0.0
    for i in range(int(program[Program.COUNT])):
        bound = work[SplineWork.BOUNDS + i, :]
        for side in range(2):
            if bound[Bound.ROOM + side] < NEVER:
                total = total - bound[Bound.ROOM + side] * bound[Bound.PRICE + side]
    return total * program[Program.SCALE]


def least_share(most: float, work: 'float[:,:]') -> float:
    """The least share of the bounds that have a part of it; 1e300 if none is found.

    most: of interest; of a larger share it is only known that it is above. The control points are
    those that need the share.
    """
    program = work[SplineWork.PROGRAM, :]
    begin_program(work)
    if program[Program.SCALE] <= 0.0:
        return 0.0
    unbalanced = 1.0
    for step in range(STEPS):
        product, miss = measure_gap(work)
        share = program[Program.SHARE] * program[Program.SCALE]
        if miss <= WORTH * max(share, 1.0) and product <= HALF_DIGITS * program[Program.SHARE]:
            return share
        if unbalanced < HALF_DIGITS and lower_bound(work) > most * (1.0 + NEARLY):
            return NEVER
        if not weigh_bounds(work):
            break
        gap = program[Program.GAP]
        step_towards(0.0, False, work)
        slack, price, left = step_lengths(work)
        step_towards(left * left * left / (gap * gap), True, work)
        slack, price, left = step_lengths(work)
        price = min(BACK * price, 1.0)
        go_along(min(BACK * slack, 1.0), price, work)
        unbalanced = unbalanced * (1.0 - price)
    return NEVER
