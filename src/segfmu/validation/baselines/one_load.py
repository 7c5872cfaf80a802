"""The gantry crane's feedforward on another crane: all on the rope is one load for it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane import FlatInverse
from segfmu.planning import Trajectory
from segfmu.validation.baselines.course import Course
from segfmu.validation.files.crane_models import model_of
from segfmu.validation.files.keys import DRIVES
from segfmu.validation.files.mission import Mission

# of a gantry crane
PLAN = {name: Mission.model_fields[name].default for name in ("smoothness", "shape")}


@dataclass(frozen=True, eq=False)
class OneLoad(Course):
    """A plan inverted for one load on a rope that ends there.

    Attributes
    ----------
    trajectory : Trajectory
    inverse : FlatInverse
    """

    trajectory: Trajectory
    inverse: FlatInverse

    def _states(self, times: FloatArray) -> FloatArray:
        """States of the crane whose rope ends above the load."""
        state = self.inverse.state(np.clip(times, 0.0, self.duration))
        state[:, 2] -= self.crane.tackle[1]
        return state

    def motion(self, times: FloatArray, derivative: int) -> FloatArray:
        first = 5 * derivative
        return self._states(times)[:, first : first + 3]

    def forces(self, times: FloatArray, accelerations: FloatArray) -> FloatArray:
        middles = 0.5 * (times[1:] + times[:-1])
        return self.inverse.force(np.clip(middles, 0.0, self.duration))

    def reference(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        since = self.begun(times)
        return self._states(since), self.trajectory(np.clip(since, 0.0, self.duration))


def one_load(mission: Mission) -> OneLoad:
    """The course of a mission whose planner ignores what is between rope and load.

    Raises
    ------
    InfeasibleError
        If there is no plan.
    """
    crane = mission.build_crane()
    mass, length = crane.tackle
    rope = {
        name: None if (own := getattr(mission.crane, name)) is None else own + length
        for name in ("rope_min", "rope_max")
    }
    plain = mission.crane.model_copy(update={
        model_of(mission.crane).key: None,
        "payload_mass": mission.crane.payload_mass + mass, **rope,
    })
    ignoring = mission.model_copy(update={"crane": plain, "true_crane": None, **PLAN})
    trajectory = ignoring.plan()
    drives = [getattr(mission.crane, name) for name in DRIVES]
    return OneLoad(
        trajectory.duration, crane, tuple(d.lag or 0.0 for d in drives),
        tuple(d.dead_time or 0.0 for d in drives), trajectory,
        FlatInverse(ignoring.build_crane(), trajectory, ignoring.build_friction()),
    )
