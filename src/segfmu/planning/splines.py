"""Motions of one axis within a range of positions, as splines found by linear programming.

The profiles of the planner rest where time is left. Beside the end of a range this can lead too
far: to stay inside, an axis may have to turn back at once. A spline of degree n + 1 is in C^n. Its
derivatives are splines as well and lie in the hull of their control points (de Boor), so limits and
range are linear in the control points of the position.
"""

from __future__ import annotations

from functools import lru_cache
from math import factorial, inf, sqrt
from typing import NamedTuple

import numpy as np

from segfmu.arrays import FloatArray

CELLS = 60
# knots of the spline whose control points keep the range, for each of its own: the closer hull is
# within 1e-4 of the range
FINER = 8
# of a limit, for the tolerance of the linear program
KEPT = 1.0 - 1e-7
TOLERANCE = 1e-9
# weights of control points that are none
ROUNDED = 1e-12
# corrections of the end by rounding errors
CORRECTIONS = 3


class AxisBounds(NamedTuple):
    """What one axis keeps.

    Attributes
    ----------
    upper, lower : ndarray, shape (n + 1,)
        Limits of the derivatives 1 .. n + 1 and their magnitudes in the negative direction,
        infinite where absent.
    allowed : ndarray, shape (2,)
        Range of the positions [m], infinite for no bound.
    """

    upper: FloatArray
    lower: FloatArray
    allowed: FloatArray


class _Basis(NamedTuple):
    """Matrices from control points of the position, in the time s from 0 to 1."""

    # control points of the derivatives 0 .. n + 1
    derivatives: tuple[FloatArray, ...]
    # control points of the same spline with FINER times as many knots
    finer: FloatArray
    # derivatives 0 .. n at the end from the derivative n + 1 in the cells
    gains: FloatArray


@lru_cache(maxsize=8)
def _basis(degree: int) -> _Basis:
    from scipy.interpolate import BSpline

    def knots(cells: int) -> FloatArray:
        return np.concatenate([np.zeros(degree), np.linspace(0.0, 1.0, cells + 1), np.ones(degree)])

    own, fine = knots(CELLS), knots(FINER * CELLS)
    derivatives = [np.eye(CELLS + degree)]
    for order in range(degree):
        width = degree - order
        inner = own[order + 1 : own.size - order - 1]
        rise = np.diff(derivatives[-1], axis=0)
        derivatives.append(rise * (width / (inner[width:] - inner[:-width]))[:, None])
    # both splines are the same polynomials: equal in as many points as one has control points
    points = np.array([fine[i + 1 : i + degree + 1].mean() for i in range(fine.size - degree - 1)])
    finer = np.linalg.solve(
        BSpline.design_matrix(points, fine, degree).toarray(),
        BSpline.design_matrix(points, own, degree).toarray(),
    )
    finer[np.abs(finer) < ROUNDED] = 0.0
    left = 1.0 - np.linspace(0.0, 1.0, CELLS + 1)
    gains = [-np.diff(left ** k) / factorial(k) for k in range(degree, 0, -1)]
    return _Basis(tuple(derivatives), finer, np.array(gains))


def spline_motion(
    first: FloatArray, last: FloatArray, bounds: AxisBounds, duration: float
) -> FloatArray | None:
    """The motion between two states that uses least of its highest limit; None if none is found.

    Parameters
    ----------
    first, last : ndarray, shape (n + 1,)
        Position and the derivatives 1 .. n [m, m/s, ...].
    bounds : AxisBounds
    duration : float
        Of the motion [s].

    Returns
    -------
    ndarray, shape (CELLS, 2 n)
        Position in the local time of equally long pieces, ascending powers.
    """
    problem = _problem(first, last, duration)
    share, control = _least_share(problem, bounds, highest=True)
    return _pieces(problem, control) if share <= 1.0 else None


def spline_use(
    first: FloatArray, last: FloatArray, bounds: AxisBounds, duration: float
) -> float:
    """The least share of all limits and of the range that a motion needs; above 1 there is none.

    Arguments as for `spline_motion`. It is continuous in the duration.
    """
    return _least_share(_problem(first, last, duration), bounds, highest=False)[0]


def overshoots(first: FloatArray, last: FloatArray, bounds: AxisBounds) -> bool:
    """Whether an end alone is out of the range, or leads out of it until the axis turns back.

    A motion that need not turn back does not tell. Limits above the jerk are left out.
    """
    low, high = bounds.allowed.tolist()
    if not all(low <= state[0] <= high for state in (first, last)):
        return True
    if first[1] * last[1] > 0.0:
        return False
    # to its end a motion comes as it leaves it in reversed time
    for state, speed in ((first, float(first[1])), (last, -float(last[1]))):
        place, acceleration = float(state[0]), float(state[2])
        room, brake = high - place, float(bounds.lower[1])
        if speed < 0.0:
            room, brake, acceleration = place - low, float(bounds.upper[1]), -acceleration
        needed = _stopping_distance(abs(speed), acceleration, brake, float(bounds.upper[2]))
        if needed > room + (1.0 - KEPT) * needed:
            return True
    return False


def _stopping_distance(speed: float, acceleration: float, brake: float, jerk: float) -> float:
    """The least distance [m] in which a speed becomes zero, by acceleration and jerk alone."""
    time = 0.0
    if jerk < inf:
        stopped = (acceleration + sqrt(acceleration * acceleration + 2.0 * jerk * speed)) / jerk
        time = max(min(stopped, (acceleration + brake) / jerk), 0.0)
    else:
        jerk = 0.0
    left = speed + (acceleration - 0.5 * jerk * time) * time
    ramp = (speed + (0.5 * acceleration - jerk * time / 6.0) * time) * time
    return ramp + 0.5 * left * left / brake


class _Problem(NamedTuple):
    """Ends of a motion in the time s from 0 to 1, from the first position on, in units of length.

    start : first position [m]; unit [m]: how far the ends alone would lead in the time. powers
    (n + 2,) are those of the duration [s] over the unit; begin, end (n + 1,): states. control
    (CELLS + n + 1,) has the control points that the ends give, and zeros where they are free.
    """

    basis: _Basis
    start: float
    unit: float
    powers: FloatArray
    begin: FloatArray
    end: FloatArray
    control: FloatArray


def _problem(first: FloatArray, last: FloatArray, duration: float) -> _Problem:
    degree = first.size
    basis = _basis(degree)
    start = float(first[0])
    powers = duration ** np.arange(degree + 1.0)
    begin, end = first * powers[:-1], last * powers[:-1]
    begin[0], end[0] = 0.0, last[0] - start
    unit = float(max(np.abs(begin).max(), np.abs(end).max()))
    begin, end, powers = begin / unit, end / unit, powers / unit
    control = np.zeros(CELLS + degree)
    for place, state, row in ((slice(degree), begin, 0), (slice(-degree, None), end, -1)):
        control[place] = np.linalg.solve(
            [matrix[row, place] for matrix in basis.derivatives[:-1]], state
        )
    return _Problem(basis, start, unit, powers, begin, end, control)


def _least_share(
    problem: _Problem, bounds: AxisBounds, *, highest: bool
) -> tuple[float, FloatArray]:
    """The least share of the highest limit, or of all limits and the range.

    Also returns the control points; the share is infinite if there are none.
    """
    from scipy.optimize import linprog
    from scipy.sparse import csr_array

    kept = [make(problem, bounds, highest=highest) for make in (_limit_rows, _range_rows)]
    rows, rooms = (np.concatenate(parts) for parts in zip(*kept, strict=True))
    # scales beyond those of numbers have no motion
    if not (np.isfinite(rows).all() and np.isfinite(rooms).all()):
        return inf, problem.control
    costs = np.zeros(rows.shape[1])
    costs[-1] = 1.0
    found = linprog(
        costs, csr_array(rows), rooms, bounds=[*[(None, None)] * (costs.size - 1), (0.0, None)],
        method="highs-ipm", options={"primal_feasibility_tolerance": TOLERANCE},
    )
    if not found.success:
        return inf, problem.control
    control = problem.control.copy()
    control[_inner(problem)] = found.x[:-1]
    return float(found.x[-1]), control


def _inner(problem: _Problem) -> slice:
    """Which control points are free."""
    return slice(problem.begin.size, CELLS)


def _limit_rows(
    problem: _Problem, bounds: AxisBounds, *, highest: bool
) -> tuple[FloatArray, FloatArray]:
    """rows @ (free control points, share) <= rooms for the limits, in units of these."""
    rows, rooms = [], []
    last = int(np.flatnonzero(np.isfinite(np.minimum(bounds.upper, bounds.lower)))[-1]) + 1
    for order, matrix in enumerate(problem.basis.derivatives[1:], 1):
        free = matrix[:, _inner(problem)]
        # what the ends give alone is not to be chosen
        chosen = free.any(axis=1)
        free = free[chosen]
        given = matrix[chosen] @ problem.control
        shared = not highest or order == last
        for sign, limits in ((1.0, bounds.upper), (-1.0, bounds.lower)):
            limit = KEPT * float(limits[order - 1] * problem.powers[order])
            if limit < inf:
                share = np.full((len(free), 1), -float(shared))
                rows.append(np.hstack([sign / limit * free, share]))
                rooms.append(1.0 - shared - sign / limit * given)
    return np.vstack(rows), np.concatenate(rooms)


def _range_rows(
    problem: _Problem, bounds: AxisBounds, *, highest: bool
) -> tuple[FloatArray, FloatArray]:
    """The same for the range, in units of length, or of the range if that is smaller."""
    low, high = ((bounds.allowed - problem.start) / problem.unit).tolist()
    size = high - low if 0.0 < high - low < 1.0 else 1.0
    matrix = problem.basis.finer
    free = matrix[:, _inner(problem)]
    # positions are means of control points; beside the ends few of what counts is free
    weight = free.sum(axis=1, keepdims=True)
    chosen = weight[:, 0] > ROUNDED
    free = free[chosen] / weight[chosen]
    given = (matrix[chosen] @ problem.control)[:, None] / weight[chosen]
    rows, rooms = [np.empty((0, free.shape[1] + 1))], [np.empty(0)]
    for sign, bound in ((1.0, high), (-1.0, -low)):
        if bound < inf:
            share = np.full((len(free), 1), float(highest) - 1.0)
            room = (bound / weight[chosen] - sign * given)[:, 0] / size
            rows.append(np.hstack([sign * free / size, share]))
            rooms.append(room - (1.0 - KEPT) - (0.0 if highest else 1.0))
    return np.vstack(rows), np.concatenate(rooms)


def _pieces(problem: _Problem, control: FloatArray) -> FloatArray:
    """The polynomials of control points, with a highest derivative that is constant in each cell.

    They end exactly but for rounding.
    """
    basis, start, _, powers, begin, end, _ = problem
    highest = basis.derivatives[-1] @ control
    degree = begin.size
    factorials = np.array([factorial(k) for k in range(degree + 1)])
    step = (1.0 / CELLS) ** np.arange(degree + 1) / factorials
    onward = np.array([
        [step[k - i] if k >= i else 0.0 for k in range(degree)] for i in range(degree)
    ])
    states = np.empty((CELLS + 1, degree))
    states[0] = begin
    for _ in range(CORRECTIONS):
        for cell in range(CELLS):
            states[cell + 1] = onward @ states[cell] + step[:0:-1] * highest[cell]
        highest = highest + np.linalg.lstsq(basis.gains, end - states[-1], rcond=None)[0]
    coefficients = np.zeros((CELLS, 2 * (degree - 1)))
    factors = powers * factorials
    coefficients[:, :degree] = states[:-1] / factors[:-1]
    coefficients[:, degree] = highest / factors[-1]
    coefficients[:, 0] += start
    return coefficients
