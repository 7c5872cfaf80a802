"""Waypoints that follow each other and are equal: they are one, in which the load may rest."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend


def united(states: FloatArray) -> tuple[NDArray[np.intp], FloatArray]:
    """The place of every waypoint, equal ones being at one, and the states of the places.

    states : ndarray, shape (waypoints, axes, WaypointState)
        NaN where free. A free state is equal to any other, and becomes that one.

    Returns the places from 0, shape (waypoints,), and the states in the shape given.
    """
    place, found = np.zeros(len(states)), states.copy()
    backend.unite_waypoints(found, place)
    return place.astype(np.intp), found
