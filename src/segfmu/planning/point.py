"""A point of the central path (central.py): free states, durations and controls.

Variables are the free states over their limits, the logarithms of the durations, and for each axis
in each interval the components of the control that change nothing at its ends.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from segfmu.planning.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class Point:
    """A point of the path, or a step.

    Attributes
    ----------
    states : ndarray, shape (waypoints, axes, 2)
        Velocity and acceleration over their limits.
    times : ndarray, shape (intervals,)
        Logarithm of the durations [s].
    components : ndarray, shape (intervals, axes, components)
        Of the control, over its limit.
    """

    states: FloatArray
    times: FloatArray
    components: FloatArray

    def moved(self, step: Point, share: float) -> Point:
        """This point plus a share of a step, whose `times` are those of 1 / duration, negative."""
        return Point(self.states + share * step.states,
                     self.times - np.log1p(-share * step.times),
                     self.components + share * step.components)

    @property
    def total(self) -> float:
        """Sum of the durations [s]."""
        return float(np.exp(self.times).sum())
