"""Minimum-time transitions of one axis without a planner: casadi with ipopt, and HiGHS.

Both discretise the integrator chain position .. jerk with snap constant on a uniform grid, which is
exact; velocity and acceleration are bounded at the nodes only, jerk and snap everywhere.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import factorial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog, nnls

FloatArray = NDArray[np.float64]
ORDER = 4


@dataclass(frozen=True)
class Transition:
    """One axis between two waypoints; the jerk is zero at both.

    Attributes
    ----------
    start, end : tuple of float
        Position, velocity, acceleration.
    limits : tuple of float
        Velocity, acceleration, jerk, snap; for linear programs also those above.
    lower : tuple of float, optional
        For linear programs: magnitudes of the limits of velocity and acceleration in the negative
        direction, where these differ.
    """

    name: str
    start: tuple[float, float, float]
    end: tuple[float, float, float]
    limits: tuple[float, ...]
    lower: tuple[float, float] | None = None

    @property
    def slow(self) -> float:
        """A time that surely suffices between points of one direction [s]: rises and a cruise."""
        velocity, acceleration, jerk, snap = self.limits[:ORDER]
        distance = abs(self.end[0] - self.start[0])
        rises = velocity / acceleration + acceleration / jerk + jerk / snap
        return distance / velocity + 2.0 * rises


class ShootingProblem:
    """Multiple shooting with a free duration, for ipopt: built once, solved for any transition."""

    def __init__(self, intervals: int) -> None:
        import casadi as ca

        self._intervals = intervals
        duration = ca.SX.sym("duration")
        states = ca.SX.sym("states", ORDER, intervals + 1)
        snap = ca.SX.sym("snap", intervals)
        h = duration / intervals
        gaps = []
        for k in range(intervals):
            for i in range(ORDER):
                taylor = sum(
                    (states[i + j, k] * h**j / factorial(j) for j in range(ORDER - i)), ca.SX(0)
                )
                rest = snap[k] * h ** (ORDER - i) / factorial(ORDER - i)
                gaps.append(states[i, k + 1] - taylor - rest)
        program: Any = {
            "x": ca.vertcat(duration, ca.vec(states), snap), "f": duration, "g": ca.vertcat(*gaps),
        }
        ipopt = {"print_level": 0, "sb": "yes", "max_iter": 1000}
        quiet: Any = {"print_time": False, "ipopt": ipopt}
        self._solver: Any = ca.nlpsol("transition", "ipopt", program, quiet)

    def solve(self, transition: Transition) -> float | None:
        """Shortest duration found [s]; None where ipopt does not converge."""
        nodes = self._intervals + 1
        lower, upper = np.full((2, nodes, ORDER), np.inf) * np.array([-1.0, 1.0])[:, None, None]
        lower[:, 1:] = -np.array(transition.limits[:3])
        upper[:, 1:] = transition.limits[:3]
        ends = np.array([[*transition.start, 0.0], [*transition.end, 0.0]])
        lower[[0, -1]] = upper[[0, -1]] = ends
        guess = ends[0] + np.linspace(0.0, 1.0, nodes)[:, None] * (ends[1] - ends[0])
        snap = np.full(self._intervals, transition.limits[3])
        found = self._solver(
            x0=np.concatenate([[transition.slow], guess.ravel(), 0.0 * snap]),
            lbx=np.concatenate([[1e-3], lower.ravel(), -snap]),
            ubx=np.concatenate([[np.inf], upper.ravel(), snap]),
            lbg=0.0, ubg=0.0,
        )
        return float(found["f"]) if self._solver.stats()["success"] else None


def linear_program(
    transition: Transition, intervals: int, tolerance: float
) -> tuple[float, int]:
    """Shortest feasible duration [s] by bisection to a relative tolerance, and the programs solved.

    For a given duration everything is linear in the highest derivative that is limited.
    """
    low, high, solved = 0.0, transition.slow, 1
    while not feasible(transition, high, intervals):
        low, high, solved = high, 2.0 * high, solved + 1
    high, further = _bisect(transition, low, high, intervals, tolerance)
    return high, solved + further


def earliest(transition: Transition, known: float, intervals: int, tolerance: float) -> float:
    """The shortest feasible duration [s] up to one that is known, also before a gap of them."""
    low = 0.0
    for high in known * np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97, 1.01]):
        if feasible(transition, float(high), intervals):
            return _bisect(transition, low, float(high), intervals, tolerance)[0]
        low = float(high)
    return known


def _bisect(
    transition: Transition, low: float, high: float, intervals: int, tolerance: float
) -> tuple[float, int]:
    solved = 0
    while high - low > tolerance * high:
        middle = 0.5 * (low + high)
        solved += 1
        if feasible(transition, middle, intervals):
            high = middle
        else:
            low = middle
    return high, solved


def integrators(order: int, h: float) -> tuple[FloatArray, FloatArray]:
    """Integrators over h [s]: the matrix of their state, and what a constant input adds."""
    step = np.array([
        [h ** (j - i) / factorial(j - i) if j >= i else 0.0 for j in range(order)]
        for i in range(order)
    ])
    return step, np.array([h ** (order - i) / factorial(order - i) for i in range(order)])


def feasible(transition: Transition, duration: float, intervals: int) -> bool:
    """Whether a motion lasts `duration` [s]; the highest limited derivative may jump."""
    rows, room, ends, reached = _conditions(transition, duration, intervals)
    found = linprog(
        np.zeros(intervals), A_ub=rows, b_ub=room, A_eq=ends, b_eq=reached, bounds=(-1.0, 1.0),
        method="highs",
    )
    return bool(found.status == 0)


def smoothest(transition: Transition, duration: float, intervals: int) -> float:
    """Least RMS of the highest limited derivative of a motion that lasts `duration` [s].

    A quadratic program over cells in which that derivative is constant; NaN where no motion keeps
    the limits. With the conditions at the end eliminated it is one of least distance, which
    non-negative least squares solve (Lawson and Hanson, Solving Least Squares Problems, ch. 23).
    """
    rows, room, ends, reached = _conditions(transition, duration, intervals)
    rows = np.vstack([rows, np.eye(intervals), -np.eye(intervals)])
    room = np.concatenate([room, np.ones(2 * intervals)])
    least = np.linalg.lstsq(ends, reached, rcond=None)[0]
    free = np.linalg.svd(ends)[2][len(ends) :].T
    scale = np.abs(least).max()
    dual = np.vstack([-scale * (rows @ free).T, rows @ least - room])
    target = np.eye(1, len(dual), len(dual) - 1)[0]
    residual = dual @ nnls(dual, target, maxiter=100 * intervals)[0] - target
    if np.abs(residual).max() < 1e-12:
        return float("nan")
    found = least - scale * free @ (residual[:-1] / residual[-1])
    return float(np.sqrt(np.mean(found * found)) * transition.limits[-1])


def _conditions(
    transition: Transition, duration: float, intervals: int
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """What the highest derivative u over its limit, by cells, has to fulfil.

    rows @ u <= room: the limits of lower derivatives at the nodes; ends @ u = reached: the end.
    """
    limits = np.array(transition.limits)
    order = len(limits)
    h = duration / intervals
    step, gain = integrators(order, h)
    # states[k] = effect[k] @ u + free[k]
    effect = np.zeros((intervals + 1, order, intervals))
    free = np.zeros((intervals + 1, order))
    free[0, :3] = transition.start
    for k in range(intervals):
        effect[k + 1] = step @ effect[k]
        effect[k + 1, :, k] += gain * limits[-1]
        free[k + 1] = step @ free[k]
    inner = (effect[1:-1, 1:] / limits[:-1, None]).reshape(-1, intervals)
    offset = (free[1:-1, 1:] / limits[:-1]).ravel()
    scale = np.array([limits[0] * duration, *limits[:-1]])
    lower = np.array([*(transition.lower or limits[:2]), *limits[2:-1]])[: order - 1] / limits[:-1]
    return (
        np.vstack([inner, -inner]),
        np.concatenate([1.0 - offset, np.tile(lower, intervals - 1) + offset]),
        effect[-1] / scale[:, None],
        (np.array([*transition.end, *(order - 3) * (0.0,)]) - free[-1]) / scale,
    )
