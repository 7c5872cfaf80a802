"""A motion between two waypoints on a grid: the control is constant in each of its cells.

The control is the derivative of order r. What the ends require of it, and what changes nothing
there, are separated, so all conditions at the ends hold by construction.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import factorial

import numpy as np
from numpy.typing import NDArray

from segfmu.planning.arrays import FloatArray

CELLS = 12
# velocity and acceleration at both ends of an interval
ENDS = 4


@dataclass(frozen=True, eq=False)
class Grid:
    """Linear map to the derivatives of one axis in one interval, in local time 0 .. 1.

    Attributes
    ----------
    rows : ndarray, shape (rows, 5 + components)
        Position and derivatives at the nodes, by the distance, velocity and acceleration at both
        ends, and the components.
    orders : ndarray of int, shape (rows,)
        Order of the derivative of each row.
    exponents : ndarray, shape (rows, 5 + components)
        Power of the duration of each entry.
    """

    rows: FloatArray
    orders: NDArray[np.int64]
    exponents: FloatArray


@lru_cache(maxsize=2)
def grid(order: int) -> Grid:
    """The map for a control of this order."""
    h = 1.0 / CELLS
    state = np.zeros((order, 1 + ENDS + CELLS))
    state[1, 1] = state[2, 2] = 1.0
    states = [state]
    for k in range(CELLS):
        state = np.array([
            sum(states[-1][d + j] * h**j / factorial(j) for j in range(order - d))
            for d in range(order)
        ])
        for d in range(order):
            state[d, 1 + ENDS + k] += h ** (order - d) / factorial(order - d)
        states.append(state)
    required = np.zeros((order, 1 + ENDS))
    required[0, 0] = required[1, 3] = required[2, 4] = 1.0
    effect = states[-1][:, 1 + ENDS:]
    # the control: what the ends require, of least norm, and what changes nothing there
    least = np.linalg.pinv(effect) @ (required - states[-1][:, :1 + ENDS])
    free = np.linalg.svd(effect)[2][order:].T * np.sqrt(CELLS)
    inner = np.array(states[1:-1]).swapaxes(0, 1).reshape(-1, 1 + ENDS + CELLS)
    by_control = inner[:, 1 + ENDS:]
    rows = np.vstack([
        np.hstack([inner[:, :1 + ENDS] + by_control @ least, by_control @ free]),
        np.hstack([least, free]),
    ])
    orders = np.repeat(np.arange(order + 1), [CELLS - 1] * order + [CELLS])
    powers = np.array([0, 1, 2, 1, 2] + [order] * free.shape[1])
    return Grid(rows, orders, powers[None, :] - orders[:, None].astype(np.float64))
