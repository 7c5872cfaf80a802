"""The controlled crane as a stepping object: drives, sampled sway feedback, dynamics.

One class serves the pure Python simulation and the FMU. Setpoints and references are given at
the end of each step and taken as linear in time since the end of the step before.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.parameters import Crane
from segfmu.errors import SimulationError
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

TOLERANCE = 1e-10

FAILURES = {
    1: "a sway angle came to 90 degrees",
    2: "the rope's length came to zero",
    3: "the integration step became too small",
    4: "a value is not finite",
}


@dataclass(frozen=True, eq=False)
class Setpoints:
    """What the crane follows at one time.

    Attributes
    ----------
    force, velocity : ndarray, shape (3,)
        Setpoints of bridge, trolley and hoist [N], [m/s].
    reference : ndarray, shape (10,)
        Reference state.
    wind : ndarray, shape (3,)
        Force on the load [N], held over the step.
    """

    force: FloatArray = field(default_factory=lambda: np.zeros(3))
    velocity: FloatArray = field(default_factory=lambda: np.zeros(3))
    reference: FloatArray = field(default_factory=lambda: np.zeros(10))
    wind: FloatArray = field(default_factory=lambda: np.zeros(3))


class Plant:
    """A crane with drives and sampled feedback.

    Parameters
    ----------
    crane : Crane
        The true crane.
    state : array_like, shape (10,)
        Initial state.
    setpoints : Setpoints
        Setpoints at the start.
    feedback : SwayFeedback
        Gains; they correct forces, or accelerations if `driven`.
    driven : bool
        Velocity drives: bridge, trolley and rope follow the velocity setpoints exactly.
    enabled : bool
        Whether the feedback acts; may be changed between steps.
    """

    def __init__(
        self,
        crane: Crane,
        state: FloatArray,
        setpoints: Setpoints,
        feedback: SwayFeedback,
        *,
        driven: bool = False,
        enabled: bool = True,
    ) -> None:
        self.crane = crane
        self.enabled = enabled
        self.drive_force = np.array(setpoints.force, dtype=np.float64)
        self._state = np.append(np.array(state, dtype=np.float64), 0.0)
        self._last = setpoints
        self._feedback = feedback
        self._driven = driven
        self._correction = np.zeros(3)
        self._offset = np.zeros(3)
        self._elapsed = 0.0
        self._ticks = 0
        self._work = np.zeros((16, 11))

    @property
    def state(self) -> FloatArray:
        """The ten components of the state; a copy."""
        return self._state[:10].copy()

    @property
    def work(self) -> float:
        """Work of drives and wind since the start [J]."""
        return float(self._state[10])

    @property
    def load(self) -> FloatArray:
        """Position and velocity of the load, shape (2, 3)."""
        load = np.zeros((2, 3))
        backend.crane_load(self._state, load)
        return load

    @property
    def energy(self) -> FloatArray:
        """Kinetic and potential energy [J]."""
        energy = np.zeros(2)
        backend.crane_energy(self._state, *self.crane.masses, energy)
        return energy

    def step(self, duration: float, setpoints: Setpoints) -> None:
        """Advance by a duration [s] to the given setpoints.

        Raises
        ------
        SimulationError
            When the crane leaves the range of its equations; names what happened and when.
        """
        done = 0.0
        while done < duration:
            period = self._feedback.sample_time
            tick = self._ticks * period - self._elapsed
            if tick <= done + 1e-9 * period:
                self._sample(setpoints, done / duration)
                self._ticks += 1
                tick += period
            until = duration if tick >= duration - 1e-9 * period else tick
            self._advance(setpoints, duration, done, until)
            done = until
        self._elapsed += duration
        self._last = setpoints

    def _sample(self, setpoints: Setpoints, share: float) -> None:
        self._correction[:] = 0.0
        if self.enabled:
            reference = _between(self._last.reference, setpoints.reference, share)
            backend.feedback_correction(
                self._state, reference, self._feedback.lengths, self._feedback.gains,
                self._correction,
            )

    def _advance(
        self, setpoints: Setpoints, duration: float, done: float, until: float
    ) -> None:
        length = until - done
        if self._driven:
            self._offset += self._correction * length
            aim = _between(self._last.velocity, setpoints.velocity, until / duration)
            drive = (aim + self._offset - self._state[5:8]) / length
            rate = np.zeros(3)
        else:
            drive = _between(self._last.force, setpoints.force, done / duration)
            drive = drive + self._correction
            rate = (setpoints.force - self._last.force) / duration
        status = backend.crane_advance(
            self._driven, self._state, drive, rate, np.zeros(2), setpoints.wind,
            *self.crane.masses, length, TOLERANCE, self._work,
        )
        if status != 0:
            raise SimulationError(
                f"at {self._elapsed + until:.3f} s: {FAILURES[status]}; check the setpoints, the "
                "masses and the communication step"
            )
        self.drive_force[:] = self._work[10, :3]


def _between(start: FloatArray, end: FloatArray, share: float) -> FloatArray:
    return start + (end - start) * share
