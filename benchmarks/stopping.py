"""The shortest motion of one axis from any state to rest, by linear programming."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from benchmarks.optimal_control import integrators

FloatArray = NDArray[np.float64]


def shortest_stop(
    state: FloatArray, limits: FloatArray, longest: float, intervals: int = 50,
    tolerance: float = 1e-3,
) -> float | None:
    """Shortest time [s] to the velocity 0, by bisection to a relative tolerance; None: not known.

    Parameters
    ----------
    state : ndarray
        Velocity and the derivatives above, below the highest limited one: that one is constant on
        each interval, and may jump.
    limits : ndarray
        One more than the state, 0 where absent; kept at the ends of the intervals.
    longest : float
        A time that suffices [s].
    """
    return _shortest(state, limits, _scale(limits, longest), longest, intervals, tolerance)


def shortest_motion(
    distance: float, state: FloatArray, limits: FloatArray, longest: float, intervals: int = 50,
    tolerance: float = 1e-3,
) -> float | None:
    """`shortest_stop` that covers a distance [m]."""
    return _shortest(
        np.array([-distance, *state]), np.array([0.0, *limits]),
        np.array([max(abs(distance), 1e-9), *_scale(limits, longest)]), longest, intervals,
        tolerance,
    )


def _scale(limits: FloatArray, longest: float) -> FloatArray:
    """What each state is measured in: its limit, or less where the motion is too short for that.

    The program's tolerance would take a state of a millionth of its limit for rest.
    """
    reached: FloatArray = limits[-1] * longest ** np.arange(limits.size - 1.0, 0.0, -1.0)
    return np.where(limits[:-1] > 0.0, np.minimum(limits[:-1], reached), reached)


def _shortest(
    state: FloatArray, limits: FloatArray, scale: FloatArray, longest: float, intervals: int,
    tolerance: float,
) -> float | None:
    if not _feasible(state, limits, scale, longest, intervals):
        return None
    low, high = 0.0, longest
    while high - low > tolerance * high:
        middle = 0.5 * (low + high)
        if _feasible(state, limits, scale, middle, intervals):
            high = middle
        else:
            low = middle
    return high


def _feasible(
    state: FloatArray, limits: FloatArray, scale: FloatArray, duration: float, intervals: int
) -> bool:
    order = state.size
    h = duration / intervals
    step, gain = integrators(order, h)
    gain *= limits[-1]
    effect, free = np.zeros((intervals + 1, order, intervals)), np.zeros((intervals + 1, order))
    free[0] = state
    for k in range(intervals):
        effect[k + 1] = step @ effect[k]
        effect[k + 1, :, k] += gain
        free[k + 1] = step @ free[k]
    rows, bounds = [], []
    for i in np.flatnonzero(limits[:-1] > 0.0):
        inner, offset = effect[1:-1, i] / limits[i], free[1:-1, i] / limits[i]
        rows += [inner, -inner]
        bounds += [1.0 - offset, 1.0 + offset]
    found = linprog(
        np.zeros(intervals), A_ub=np.vstack(rows), b_ub=np.concatenate(bounds),
        A_eq=effect[-1] / scale[:, None], b_eq=-free[-1] / scale, bounds=(-1.0, 1.0),
        method="highs",
    )
    return bool(found.status == 0)
