"""The motion of a crane by another method than its plan, and the inputs of its FMU for it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.cosim import Change
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.linear import moved_masses
from segfmu.fmu.gantry_crane.interface import STATE
from segfmu.validation.files.keys import AXES, DRIVES


@dataclass(frozen=True, eq=False)
class Course(ABC):
    """The motion of a baseline.

    Attributes
    ----------
    duration : float
        [s], without dead times.
    crane : Crane or HookCrane
    lag, dead_time : tuple of 3 float
        Of the drives as the crane file has them [s].
    """

    duration: float
    crane: AnyCrane
    lag: tuple[float, ...]
    dead_time: tuple[float, ...]

    @abstractmethod
    def motion(self, times: FloatArray, derivative: int) -> FloatArray:
        """Positions [m] or velocities [m/s] of bridge, trolley and rope, shape (times, 3)."""

    @abstractmethod
    def forces(self, times: FloatArray, accelerations: FloatArray) -> FloatArray:
        """Forces of the drives [N] between times, with the mean accelerations [m/s2] there."""

    @abstractmethod
    def reference(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Reference state (times, 10) and place of the load (times, 3) at times [s]."""

    def begun(self, times: FloatArray) -> FloatArray:
        """Times since the motion began: when the longest dead time had passed [s]."""
        return times - max(self.dead_time)

    def setpoints(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Forces [N] and velocities [m/s] that are held from each time to the next one.

        Velocities move the carriages as far as the motion does; known lags are compensated.
        Shapes (times - 1, 3).
        """
        step = np.diff(times)
        forces, velocities = [], []
        for axis, (lag, dead) in enumerate(zip(self.lag, self.dead_time, strict=True)):
            own = self.begun(times) + dead
            speed, gain = (np.diff(self.motion(own, d), axis=0) / step[:, None] for d in (0, 1))
            velocities.append(speed[:, axis] + lag * gain[:, axis])
            forces.append(self.forces(own, gain)[:, axis])
        return np.stack(forces, axis=-1), np.stack(velocities, axis=-1)


def hanging(crane: AnyCrane) -> float:
    """Mass of all that hangs on the rope [kg]."""
    return crane.masses[2] + crane.tackle[0]


def carriages(crane: AnyCrane) -> FloatArray:
    """Masses that the drives of bridge and trolley move, without what hangs on the rope [kg]."""
    bridge, trolley, payload, gravity = crane.masses[:4]
    return moved_masses((bridge, trolley, payload, gravity))[:2]


def changes(own: Course, fmu: str, times: FloatArray) -> list[Change]:
    """Inputs of a crane's FMU at every communication step."""
    forces, velocities = own.setpoints(times)
    states, loads = own.reference(times)
    names = [f"{kind}.{drive}" for kind in ("force", "velocity") for drive in DRIVES]
    names += [f"reference.{name}" for name in STATE]
    names += [f"reference.load.position.{axis}" for axis in AXES]
    table = np.hstack([forces, velocities, states[:-1], loads[:-1]])
    found, before = [], None
    for time, row in zip(times.tolist(), table.tolist(), strict=False):
        if row != before:
            found.append(Change(time, fmu, dict(zip(names, row, strict=True))))
        before = row
    return found
