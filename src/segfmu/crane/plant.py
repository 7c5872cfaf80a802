"""The controlled crane as a stepping object: controller, drives, dynamics, sensors.

One class serves the pure Python simulation and the FMU. Setpoints and references are given at
the end of each step and taken as linear in time since the end of the step before. The integration
stops exactly at the ticks of controller and sensors, at payload changes and at the ends of a gust,
so that nothing depends on the steps.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from segfmu.crane.controller import Controller, StateFeedback
from segfmu.crane.energy import EnergyBalance
from segfmu.crane.failures import failure
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.parameters import Crane
from segfmu.crane.rig import Rig
from segfmu.crane.sensors import Readings
from segfmu.errors import SimulationError
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

TOLERANCE = 1e-10


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
        Force on the load [N] beside the wind of the rig, held over the step.
    """

    force: FloatArray = field(default_factory=lambda: np.zeros(3))
    velocity: FloatArray = field(default_factory=lambda: np.zeros(3))
    reference: FloatArray = field(default_factory=lambda: np.zeros(10))
    wind: FloatArray = field(default_factory=lambda: np.zeros(3))


class Plant:
    """A crane with drives, a sampled controller, and sensors.

    Parameters
    ----------
    crane : Crane
        The true crane.
    state : array_like, shape (10,)
        Initial state.
    setpoints : Setpoints
        Setpoints at the start.
    controller : Controller or SwayFeedback
        Gains act on the true state; any other controller gets the measured signals.
    driven : bool
        Velocity drives: bridge, trolley and rope follow the velocity setpoints.
    enabled : bool
        Whether the correction acts; may be changed between steps.
    rig : Rig, optional
        What is not ideal; everything is by default.
    start_time : float
        [s]

    Attributes
    ----------
    drive_force : ndarray, shape (3,)
        Forces [N] that the drives apply, friction included.
    saturated : ndarray of bool, shape (3,)
        Which drives were at a bound during the last step.
    rope_force : float
        Force on the rope [N], tension is negative.
    wind_power, friction_power : float
        Power of the wind and power that friction dissipates [W].
    """

    def __init__(
        self,
        crane: Crane,
        state: FloatArray,
        setpoints: Setpoints,
        controller: Controller | SwayFeedback,
        *,
        driven: bool = False,
        enabled: bool = True,
        rig: Rig | None = None,
        start_time: float = 0.0,
    ) -> None:
        self._rig = rig or Rig()
        self.enabled = enabled
        self.drive_force = np.array(setpoints.force, dtype=np.float64)
        self.saturated: NDArray[np.bool_] = np.zeros(3, dtype=np.bool_)
        self.rope_force = float(setpoints.force[2])
        self.wind_power = self.friction_power = 0.0
        self._state = np.append(np.array(state, dtype=np.float64), np.zeros(3))
        self._last = setpoints
        self._controller = (
            StateFeedback(controller, self._state)
            if isinstance(controller, SwayFeedback) else controller
        )
        self._driven = driven
        self._parameters = self._rig.parameters(crane, driven)
        self._start = start_time
        self._correction = np.zeros(3)
        self._offset = np.zeros(3)
        self._elapsed = 0.0
        self._ticks = 0
        self._work, self._report = np.zeros((16, 13)), np.zeros(10)
        self._edges = [t - start_time for t in self._rig.edges if t > start_time]
        self._change_payload(start_time)
        self._initial = float(self.energy.sum())
        self._payload_energy = 0.0
        self._readings = Readings(self._rig.sensors, self._state)

    @property
    def time(self) -> float:
        """Time reached [s]."""
        return self._start + self._elapsed

    @property
    def state(self) -> FloatArray:
        """The ten components of the state; a copy."""
        return self._state[:10].copy()

    @property
    def measured(self) -> FloatArray:
        """Signals of the sensors, shape (5,)."""
        return self._readings.at(self._elapsed, self._state)

    @property
    def payload_mass(self) -> float:
        """Present mass of the load [kg]."""
        return float(self._parameters[2])

    @property
    def work(self) -> float:
        """Work of drives and wind since the start [J]."""
        return float(self._state[10] + self._state[11])

    @property
    def load(self) -> FloatArray:
        """Position and velocity of the load, shape (2, 3)."""
        load = np.zeros((2, 3))
        backend.crane_load(self._state, load)
        return load

    @property
    def drive_power(self) -> FloatArray:
        """Power of the drives [W], shape (3,)."""
        power: FloatArray = self.drive_force * self._state[5:8]
        return power

    @property
    def energy(self) -> FloatArray:
        """Kinetic and potential energy [J]."""
        energy = np.zeros(2)
        backend.crane_energy(self._state, *map(float, self._parameters[:4]), energy)
        return energy

    @property
    def balance(self) -> EnergyBalance:
        """Energies and works since the start."""
        values = (*self.energy, self._initial, *self._state[10:12], self._payload_energy,
                  self._state[12])
        return EnergyBalance(*map(float, values))

    def step(self, duration: float, setpoints: Setpoints) -> None:
        """Advance by a duration [s] to the given setpoints.

        Raises
        ------
        SimulationError
            When the crane reaches an end stop or leaves the range of its equations; names what
            happened and when. The plant stays at the last state before.
        """
        self.saturated[:] = False
        done = 0.0
        while done < duration:
            self._control(setpoints, done, duration)
            until = self._next_event(done, duration)
            self._advance(setpoints, duration, done, until)
            done = until
            self._observe(self._elapsed + done)
        self._elapsed += duration
        self._last = setpoints

    def _control(self, setpoints: Setpoints, done: float, duration: float) -> None:
        """Sample the controller if its tick is due."""
        time = self._elapsed + done
        if self._ticks * self._controller.sample_time > time + self._instant:
            return
        self._ticks += 1
        share = done / duration
        reference = _between(self._last.reference, setpoints.reference, share)
        if self._driven:
            feedforward = (setpoints.velocity - self._last.velocity) / duration
        else:
            feedforward = _between(self._last.force, setpoints.force, share)
        found = self._controller.sample(
            self._start + time, self._readings.at(time, self._state), reference, feedforward
        )
        self._correction[:] = found if self.enabled else 0.0

    @property
    def _instant(self) -> float:
        """Times that differ by less are the same; sums of steps are rounded."""
        return 1e-9 * self._controller.sample_time

    def _next_event(self, done: float, duration: float) -> float:
        """Time within the step of the next event, or the step's end."""
        times = [self._ticks * self._controller.sample_time, self._readings.next_tick]
        times += self._edges[:1]
        until = min(times) - self._elapsed
        return duration if until >= duration - self._instant else until

    def _observe(self, time: float) -> None:
        """Take the samples and change the payload if they are due."""
        while self._readings.next_tick <= time + self._instant:
            self._readings.sample(self._state)
        while self._edges and self._edges[0] <= time + self._instant:
            self._edges.pop(0)
            before = self.energy.sum()
            self._change_payload(self._start + time)
            self._payload_energy += float(self.energy.sum() - before)

    def _change_payload(self, time: float) -> None:
        """Give the load the mass that it has from a time on."""
        due = [c for c in self._rig.payload if c.time <= time + self._instant]
        if due:
            self._parameters[2] = max(due, key=lambda change: change.time).mass

    def _advance(
        self, setpoints: Setpoints, duration: float, done: float, until: float
    ) -> None:
        length = until - done
        command, rate = self._command(setpoints, duration, done, until)
        status = backend.plant_advance(
            self._parameters, self._rig.wind.components, self._start + self._elapsed + done,
            self._state, command, rate, setpoints.wind, length, TOLERANCE, self._work,
            self._report,
        )
        self.drive_force[:] = self._report[:3]
        self.saturated |= self._report[3:6] > 0.0
        self.rope_force, self.wind_power, self.friction_power = map(float, self._report[6:9])
        if status != 0:
            time = self._start + self._elapsed + done + self._report[9]
            raise SimulationError(failure(status, time, self._state, self._parameters))

    def _command(
        self, setpoints: Setpoints, duration: float, done: float, until: float
    ) -> tuple[FloatArray, FloatArray]:
        """Commands of the drives at the time done, and their rates until the next event."""
        length = until - done
        if not self._driven:
            force = _between(self._last.force, setpoints.force, done / duration)
            return force + self._correction, (setpoints.force - self._last.force) / duration
        command = _between(self._last.velocity, setpoints.velocity, done / duration) + self._offset
        rate = (setpoints.velocity - self._last.velocity) / duration + self._correction
        self._offset += self._correction * length
        aim = _between(self._last.velocity, setpoints.velocity, until / duration) + self._offset
        for i, drive in enumerate(self._rig.drives):
            if drive.lag == 0.0:
                # at the end it has its setpoint, wherever a bound has left it before
                command[i], rate[i] = (aim[i] - self._state[5 + i]) / length, 0.0
        return command, rate


def _between(start: FloatArray, end: FloatArray, share: float) -> FloatArray:
    return start + (end - start) * share
