"""How a state is brought inside its limits: what the first moments of a plan may exceed."""

from __future__ import annotations

import numpy as np

from segfmu.kernels import backend
from segfmu.kernels.planner.records import Lower
from segfmu.kernels.settling.records import LeadRows, LeadWork
from segfmu.kernels.trajectory.records import Brake, Timing
from segfmu.planning.arrays import FloatArray


def find_brakes(start: FloatArray, limits: FloatArray, lower: FloatArray) -> FloatArray:
    """The brake of every axis, zeros where the state can stay inside.

    Parameters
    ----------
    start : ndarray, shape (axes, n + 1)
        Position and the derivatives 1 .. n.
    limits : ndarray, shape (axes, n + 1)
        As from `Limits.table`.
    lower : ndarray, shape (axes, 2)
        As from `Limits.lower`.

    Returns
    -------
    ndarray, shape (axes, Brake)
    """
    axes, width = start.shape
    work = np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))
    timing = np.zeros((LeadRows.ALL, Timing.SIZE))
    coefficients = np.zeros((LeadRows.ALL, 2 * (width - 1)))
    brakes = np.zeros((axes, Brake.SIZE))
    for axis in range(axes):
        work[LeadWork.NOW] = 0.0
        work[LeadWork.NOW, :width] = start[axis]
        work[LeadWork.LOWER, : Lower.SIZE] = lower[axis]
        if backend.find_brake(False, limits[axis], work, timing, coefficients) > 0:
            brakes[axis] = work[LeadWork.BRAKE, : Brake.SIZE]
    return brakes
