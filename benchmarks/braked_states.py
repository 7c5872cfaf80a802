"""Problems whose states can barely be braked within the velocity limit.

Their shortest motions can be in gaps of feasible durations, where a search is most likely to fail.
"""

from __future__ import annotations

import numpy as np

from benchmarks.problems import FloatArray
from segfmu import InfeasibleError, Limits, Waypoint, plan


def barely_braked(
    random: np.random.Generator, limits: FloatArray, state: FloatArray
) -> FloatArray:
    """v, a, w, b, distance with velocities within a fifth of the limit of what can be braked."""
    room = 0.2 * random.random(2) ** 3 * limits[0]
    v, a, w, b, distance = state
    v = _fastest(limits, a) - np.sign(a) * room[0]
    # the motion reversed in time
    w = _fastest(limits, -b) + np.sign(b) * room[1]
    return np.array([*np.clip([v, a, w, b], *_ends(limits)), distance])


def _ends(limits: FloatArray) -> tuple[FloatArray, FloatArray]:
    most = limits[[0, 1, 0, 1]]
    return -most, most


def _fastest(limits: FloatArray, a: float) -> float:
    """The velocity of the acceleration's sign from which that can just be braked [m/s]."""
    sign = float(np.sign(a))
    low, high = -limits[0], limits[0]
    for _ in range(12):
        middle = 0.5 * (low + high)
        if _brakes(limits, sign * middle, a):
            low = middle
        else:
            high = middle
    return float(sign * low)


def _brakes(limits: FloatArray, v: float, a: float) -> bool:
    """Whether a plan leads from v, a to rest far away."""
    given = [float(limit) for limit in limits if limit > 0.0]
    points = [Waypoint(0.0, v, a), Waypoint(float(np.sign(a)) * 500.0)]
    try:
        plan(points, Limits(*given), smoothness=len(given))
    except InfeasibleError:
        return False
    return True
