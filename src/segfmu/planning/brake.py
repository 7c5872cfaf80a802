"""How a state is brought inside its limits: what the first moments of a plan may exceed."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.settling.records import LeadRows, LeadWork
from segfmu.kernels.trajectory.records import Brake, Timing


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
    brakes = np.zeros((axes, Brake.SIZE))
    backend.find_brakes(
        start, limits, lower, brakes, np.zeros((LeadWork.SIZE, LeadWork.COLUMNS)),
        np.empty((LeadRows.ALL, Timing.SIZE)), np.empty((LeadRows.ALL, 2 * (width - 1))),
    )
    return brakes
