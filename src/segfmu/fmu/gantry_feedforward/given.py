"""What the parameters of GantryFeedforward say of a plan."""

from __future__ import annotations

from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.crane.variables import Value, filled
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.kernels.limits.records import LimitRow
from segfmu.kernels.planner.records import LoadLimits, LowerLimits, PlanOptions, WaypointState
from segfmu.planning import Limits, Waypoint
from segfmu.planning.request import with_states

AXES = ("x", "y", "z")
# what of the waypoints is found
FREE = ("waypoint.velocity_free", "waypoint.acceleration_free")


class Given:
    """Waypoints, limits and options of a plan; value: gives variables by name."""

    def __init__(self, value: Value) -> None:
        self._value = value

    @property
    def has_limits(self) -> bool:
        """Whether limits are given with which a motion can be planned."""
        return bool(self.table()[:, : LimitRow.JERK].all())

    def options(self) -> dict[str, Any]:
        """Arguments of `plan`."""
        options = filled(PlanOptions, self._value)
        return {
            "smoothness": int(options[PlanOptions.SMOOTHNESS]),
            "shape": gantry_feedforward.SHAPES.items[int(options[PlanOptions.SHAPE])],
            "synchronize": gantry_feedforward.SYNCHRONIZATIONS.items[
                int(options[PlanOptions.SYNCHRONIZATION])
            ],
            "sample_time": float(options[PlanOptions.SAMPLE_TIME]) or None,
            "duration": float(options[PlanOptions.DURATION]) or None,
            "axis_names": AXES,
        }

    def table(self) -> FloatArray:
        """Given limits of velocity to snap, shape (3, 4); 0: none."""
        return filled(LoadLimits, self._value).reshape(len(AXES), -1)

    def least(self) -> FloatArray:
        """Magnitudes of given velocities and accelerations backwards, shape (3, 2)."""
        least = filled(LowerLimits, self._value).reshape(len(AXES), -1)
        return np.where(least < 0.0, -least, self.table()[:, : LimitRow.JERK])

    def limits(self, pace: float) -> Limits:
        """Given limits, at a pace."""
        given = self.table().T
        powers = pace ** np.arange(1.0, len(given) + 1.0)
        velocity, acceleration, *others = powers[:, None] * given
        velocity_min, acceleration_min = -powers[:2, None] * self.least().T
        return Limits(
            velocity, acceleration, *(np.where(c > 0.0, c, inf) for c in others),
            velocity_min=velocity_min, acceleration_min=acceleration_min,
        )

    def waypoints(self, pace: float) -> tuple[Waypoint, ...]:
        """Given waypoints, at a pace; what of their states is free is NaN."""
        count = int(self._value("waypoint.count"))
        position, velocity, acceleration, dwell = (
            np.array([float(self._value(n)) for n in array.members[: count * array.columns]])
            .reshape(count, -1)
            for array in gantry_feedforward.arrays(count) if array.name not in FREE
        )
        states = np.stack([position, pace * velocity, pace**2 * acceleration], axis=2)
        states[:, :, WaypointState.VELOCITY :][self._free()] = np.nan
        return with_states(tuple(map(Waypoint, position)), states, dwell[:, 0])

    def _free(self) -> NDArray[np.bool_]:
        """Which velocities and accelerations are free, shape (waypoints, 3, 2)."""
        rows = range(1, int(self._value("waypoint.count")) + 1)
        names = ("velocity_free", "acceleration_free")
        return np.array([
            [[self._value(f"waypoint[{i}].{n}.{a}") for n in names] for a in AXES] for i in rows
        ], dtype=np.bool_)
