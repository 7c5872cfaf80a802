"""Waypoints that follow each other and are equal: they are one, in which the load may rest."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from segfmu.planning.arrays import FloatArray

# of positions and states, relative to their size or to 1
ROUNDING = 1e-15


def united(states: FloatArray) -> tuple[NDArray[np.intp], FloatArray]:
    """The first waypoint of the run of equal ones that each is in, and the states of the runs.

    states : ndarray, shape (waypoints, axes, WaypointState)
        NaN where free. A free state is equal to any other, and becomes that one.

    Returns the numbers from 0, shape (waypoints,), and the states in the shape given.
    """
    first = np.arange(len(states))
    found = states.copy()
    for j in range(1, len(states)):
        head = first[j - 1]
        if _equal(found[head], states[j]):
            first[j] = head
            found[head] = np.where(np.isnan(found[head]), states[j], found[head])
    return first, found[first]


def _equal(one: FloatArray, other: FloatArray) -> bool:
    # no comparison with NaN is true
    return not (np.abs(one - other) > ROUNDING * np.maximum(np.abs(other), 1.0)).any()
