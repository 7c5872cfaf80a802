"""The least share of limits against another solver's, on matrices that SciPy makes."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.optimize import linprog

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.numerics.numbers import HALF_DIGITS, NEVER
from segfmu.kernels.planner.records import Axis, Lower
from segfmu.kernels.spline.records import Derivatives, Mesh, SplineWork

FREE = np.array([-inf, inf])


def matrices(degree: int) -> list[FloatArray]:
    """Control points of the derivatives from those of the position."""
    knots = np.concatenate([
        np.zeros(degree), np.linspace(0.0, 1.0, Mesh.CELLS + 1), np.ones(degree)
    ])
    found: list[FloatArray] = [np.eye(Mesh.CELLS + degree)]
    for order in range(degree):
        # the derivative of each basis function, from its control points
        splines = [BSpline(knots, row, degree).derivative(order + 1) for row in found[0]]
        size = Mesh.CELLS + degree - order - 1
        found.append(np.stack([spline.c[:size] for spline in splines], axis=1))
    return found


def least_share(
    highest: bool, duration: float, first: FloatArray, last: FloatArray, allowed: FloatArray,
    limits: FloatArray, lower: FloatArray,
) -> float:
    """The share by the kernel."""
    n = first.size - 1
    axis = np.zeros(Axis.SIZE)
    axis[Axis.SMOOTHNESS] = n
    axis[Axis.VELOCITY : Axis.VELOCITY + n + 1] = limits
    axis[Axis.LOWER : Axis.LOWER + Lower.SIZE] = lower
    begin, end = np.zeros((2, Derivatives.SIZE))
    begin[: n + 1], end[: n + 1] = first, last
    work = np.zeros((SplineWork.SIZE, SplineWork.COLUMNS))
    return float(backend.spline_share(highest, duration, begin, end, allowed, axis, work))


def share_of_matrices(
    highest: bool, duration: float, first: FloatArray, last: FloatArray, allowed: FloatArray,
    limits: FloatArray, lower: FloatArray,
) -> float:
    """The same by HiGHS, with all control points as unknowns."""
    degree = first.size
    own, finer = matrices(degree), _finer(degree)
    powers = duration ** np.arange(degree + 1.0)
    count = own[0].shape[1]
    orders = np.flatnonzero(limits) + 1
    rows, rooms = [], []
    for order in orders:
        shared = not highest or order == orders[-1]
        for sign in (1.0, -1.0):
            limit = limits[order - 1]
            if sign < 0.0 and order <= Lower.SIZE:
                limit = lower[order - 1]
            limit *= 1.0 - HALF_DIGITS
            # what the ends give alone is not to be chosen
            kept = own[order][degree - order : Mesh.CELLS]
            share = np.full((len(kept), 1), -float(shared))
            rows.append(np.hstack([sign / powers[order] / limit * kept, share]))
            rooms.append(np.full(len(kept), 1.0 - shared))
    if np.isfinite(allowed).all() and highest:
        for sign, edge in ((1.0, allowed[1]), (-1.0, -allowed[0])):
            rows.append(np.hstack([sign * finer, np.zeros((len(finer), 1))]))
            rooms.append(np.full(len(finer), edge))
    ends = np.vstack([own[k][[0, -1]] / powers[k] for k in range(degree)])
    states = np.stack([first, last], axis=1).ravel()
    found = linprog(
        np.eye(count + 1)[-1], np.vstack(rows), np.concatenate(rooms),
        np.hstack([ends, np.zeros((len(ends), 1))]), states, (None, None), method="highs",
    )
    return float(found.fun) if found.success else inf


def _finer(degree: int) -> FloatArray:
    """Control points of the spline with more knots, but those that the ends give alone."""
    def knots(cells: int) -> FloatArray:
        return np.concatenate([np.zeros(degree), np.linspace(0.0, 1.0, cells + 1), np.ones(degree)])

    own, fine = knots(Mesh.CELLS), knots(Mesh.CELLS * Mesh.FINER)
    points = np.array([fine[i + 1 : i + degree + 1].mean() for i in range(fine.size - degree - 1)])
    finer = np.linalg.solve(
        BSpline.design_matrix(points, fine, degree).toarray(),
        BSpline.design_matrix(points, own, degree).toarray(),
    )
    return np.asarray(finer[np.abs(finer[:, degree : Mesh.CELLS]).max(axis=1) > 1e-9])


@pytest.mark.parametrize("highest", [False, True])
@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("seed", range(6))
def test_the_share_is_that_of_another_solver(seed: int, n: int, highest: bool) -> None:
    random = np.random.default_rng((n, seed))
    first, last = np.zeros((2, n + 1))
    first[:3], last[:3] = random.uniform(-1.0, 1.0, (2, 3))
    allowed = FREE
    if highest and seed % 2:
        ends = first[0], last[0]
        allowed = np.array([min(ends) - 0.5, max(ends) + 0.5])
    limits = 4.0 ** np.arange(1, n + 2)
    limits[4:] = 0.0
    problem = (
        highest, random.uniform(2.0, 5.0), first, last, allowed, limits,
        limits[: Lower.SIZE] * random.uniform(0.6, 1.0, Lower.SIZE),
    )
    truth, found = share_of_matrices(*problem), least_share(*problem)
    if highest and truth > 1.0:
        assert found > 1.0
    else:
        assert found == pytest.approx(truth, rel=1e-5)


@pytest.mark.parametrize("n", [2, 4, 6])
def test_the_same_in_other_units_mirrored_and_reversed_needs_the_same_share(n: int) -> None:
    limits = 4.0 ** np.arange(1, n + 2)
    first, last = np.zeros((2, n + 1))
    first[:3], last[:3] = (0.0, 0.5, -1.0), (1.0, -0.3, 0.2)
    allowed, time = np.array([-0.5, 1.5]), 3.0
    share = least_share(True, time, first, last, allowed, limits, limits[:2])
    assert 0.0 < share < 1.0
    signs = -((-1.0) ** np.arange(n + 1))
    for length, second in ((1e-6, 1.0), (1e6, 1e3), (1.0, 1e-3)):
        rates = length / second ** np.arange(n + 2.0)
        for start, end, edges in (
            (first, last, allowed), (-first, -last, -allowed[::-1]),
            (signs * last, signs * first, -allowed[::-1]),
        ):
            found = least_share(
                True, time * second, start * rates[:-1], end * rates[:-1], edges * length,
                limits * rates[1:], limits[:2] * rates[1:3],
            )
            assert found == pytest.approx(share, rel=1e-6)


def test_what_has_no_motion_has_no_share() -> None:
    limits = np.array([1.0, 1.0, 1.0])
    first, last = np.zeros(3), np.array([1.0, 0.0, 0.0])
    # no time for the distance, within the limits and at all scales
    assert least_share(True, 0.5, first, last, FREE, limits, limits[:2]) > 1.0
    assert least_share(False, 1e-200, first, last, FREE, limits, limits[:2]) > 1e100
    assert least_share(True, 3.0, first, first, FREE, limits, limits[:2]) == NEVER
    # an end outside
    allowed = np.array([0.2, 2.0])
    assert least_share(True, 9.0, first, last, allowed, limits, limits[:2]) > 1.0
