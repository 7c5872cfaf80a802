"""The planning problem as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels.planner.records import Shape, Synchronization

SHAPES = tuple(name.lower() for name in Shape.items())
SYNCHRONIZATIONS = tuple(name.lower() for name in Synchronization.items())


@dataclass(frozen=True)
class Options:
    """Options of the planner; sample_time and duration [s] are 0 if not requested."""

    smoothness: int
    shape: str
    synchronize: str
    sample_time: float
    duration: float

    @cached_property
    def vector(self) -> FloatArray:
        """As the kernels take them (PlanOptions)."""
        vector = np.array([
            self.smoothness, SHAPES.index(self.shape), SYNCHRONIZATIONS.index(self.synchronize),
            self.sample_time, self.duration,
        ])
        vector.flags.writeable = False
        return vector


@lru_cache(maxsize=64)
def options(
    smoothness: int, shape: str, synchronize: str, sample_time: float, duration: float
) -> Options:
    """The options of these values; usual ones are made once."""
    return Options(smoothness, shape, synchronize, sample_time, duration)


class Problem(NamedTuple):
    """What to plan.

    Attributes
    ----------
    states : ndarray, shape (waypoints, axes, 3)
        Position, velocity and acceleration [m, m/s, m/s2] (WaypointState); NaN where free.
    dwells : ndarray, shape (waypoints,)
        Times to stay [s].
    limits : ndarray, shape (axes, smoothness + 1)
        As from `Limits.table`.
    lower : ndarray, shape (axes, 2)
        As from `Limits.lower`.
    options : Options
    """

    states: FloatArray
    dwells: FloatArray
    limits: FloatArray
    lower: FloatArray
    options: Options
