"""The controlled crane as a stepping object: controller, drives, dynamics, sensors.

One class serves the pure Python simulation and the FMU. Setpoints and references are given at
the end of each step and taken as linear in time since the end of the step before. The integration
stops exactly at the ticks of controller and sensors, at payload changes and at the ends of a gust,
so that nothing depends on the steps. All of it is kernels/rig/rig.py; here are its arrays.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from segfmu.crane.checks import require_not_negative, require_positive
from segfmu.crane.controller import Controller
from segfmu.crane.energy import EnergyBalance
from segfmu.crane.failures import failure
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.parameters import Crane
from segfmu.crane.rig import Rig
from segfmu.crane.tracking import FADE, Arrays, TrackingController
from segfmu.errors import InputError, SimulationError
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

TOLERANCE = 1e-10

# who corrects, and the status that asks the caller to
CALLER, STATE, TRACKING = range(3)
TICK = -1

# what the kernel's memory says of the tick before where the gains were others
RETUNED = 3.0

# rows of the kernel's memory
CRANE, PARAMETERS, CLOCK, LAST, REPORT, SIGNALS, REFERENCE, ADDED_TO, CORRECTION = range(9)


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

    @property
    def vector(self) -> FloatArray:
        """As kernels/rig/rig.py takes them, shape (19,)."""
        parts = (self.force, self.velocity, self.reference, self.wind)
        return np.concatenate(parts, dtype=np.float64)


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
    fade : float
        Time constant [s] with which such a change, or other gains, fade in; 0 lets the correction
        jump.
    rig : Rig, optional
        What is not ideal; everything is by default.
    start_time : float
        [s]

    Raises
    ------
    InputError
        For a controller's sample time that is not positive and a negative fade.
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
        fade: float = FADE,
        rig: Rig | None = None,
        start_time: float = 0.0,
    ) -> None:
        require_positive("controller sample_time", controller.sample_time)
        rig = rig or Rig()
        self._controller = controller
        self._loop = np.array(
            [_corrector(controller), controller.sample_time, enabled, TOLERANCE, 0.0]
        )
        self.fade = fade
        self._sensors, self._changes = rig.sensors.vector, rig.changes
        self._components = rig.wind.components
        rows = backend.rig_rows(rig.sensors.sample_time, rig.sensors.dead_time)
        self._memory = np.zeros((rows, 40))
        backend.rig_start(
            self._loop, self._sensors, self._changes, rig.parameters(crane, driven),
            np.array(state, dtype=np.float64), setpoints.vector, start_time, self._memory,
        )

    @property
    def enabled(self) -> bool:
        """Whether the correction acts."""
        return bool(self._loop[2])

    @enabled.setter
    def enabled(self, value: bool) -> None:
        self._loop[2] = bool(value)

    @property
    def fade(self) -> float:
        """Time constant [s] of changes by switching; may be changed between steps."""
        return float(self._loop[4])

    @fade.setter
    def fade(self, value: float) -> None:
        require_not_negative("fade", value)
        self._loop[4] = value

    def retune(self, feedback: SwayFeedback) -> None:
        """Go on with other gains on the true state.

        Raises
        ------
        InputError
            For another period, and where another controller corrects.
        """
        own = self._controller
        if not isinstance(own, SwayFeedback) or own.sample_time != feedback.sample_time:
            raise InputError(
                "retune replaces gains on the true state by gains of the same period, got "
                f"{feedback.sample_time} s and {own.sample_time} s of {type(own).__name__}"
            )
        self._controller = feedback
        if self._memory[CORRECTION, 6] > 0.0:
            self._memory[CORRECTION, 6] = RETUNED

    @property
    def time(self) -> float:
        """Time reached [s]."""
        return float(self._memory[CLOCK, 0] + self._memory[CLOCK, 1])

    @property
    def state(self) -> FloatArray:
        """The ten components of the state; a copy."""
        return self._memory[CRANE, :10].copy()

    @property
    def measured(self) -> FloatArray:
        """Signals of the sensors, shape (5,)."""
        return self._memory[SIGNALS, :5].copy()

    @property
    def drive_force(self) -> FloatArray:
        """Forces [N] that the drives apply, friction included, shape (3,)."""
        return self._memory[REPORT, :3].copy()

    @property
    def saturated(self) -> NDArray[np.bool_]:
        """Which drives were at a bound during the last step, shape (3,)."""
        flags: NDArray[np.bool_] = self._memory[REPORT, 10:13] > 0.0
        return flags

    @property
    def rope_force(self) -> float:
        """Force on the rope [N], tension is negative."""
        return float(self._memory[REPORT, 6])

    @property
    def wind_power(self) -> float:
        """Power of the wind [W]."""
        return float(self._memory[REPORT, 7])

    @property
    def friction_power(self) -> float:
        """Power that friction dissipates [W]."""
        return float(self._memory[REPORT, 8])

    @property
    def payload_mass(self) -> float:
        """Present mass of the load [kg]."""
        return float(self._memory[PARAMETERS, 2])

    @property
    def work(self) -> float:
        """Work of drives and wind since the start [J]."""
        return float(self._memory[CRANE, 10] + self._memory[CRANE, 11])

    @property
    def load(self) -> FloatArray:
        """Position and velocity of the load, shape (2, 3)."""
        load = np.zeros((2, 3))
        backend.crane_load(self._memory[CRANE], load)
        return load

    @property
    def drive_power(self) -> FloatArray:
        """Power of the drives [W], shape (3,)."""
        power: FloatArray = self._memory[REPORT, :3] * self._memory[CRANE, 5:8]
        return power

    @property
    def energy(self) -> FloatArray:
        """Kinetic and potential energy [J]."""
        balance = self.balance
        return np.array([balance.kinetic, balance.potential])

    @property
    def balance(self) -> EnergyBalance:
        """Energies and works since the start."""
        values = np.zeros(7)
        backend.rig_balance(self._memory, values)
        return EnergyBalance(*values.tolist())

    def step(self, duration: float, setpoints: Setpoints) -> None:
        """Advance by a duration [s] to the given setpoints.

        Raises
        ------
        SimulationError
            When the crane reaches an end stop or leaves the range of its equations; names what
            happened and when. The plant stays at the last state before.
        """
        controller = _arrays(self._controller)
        vector = setpoints.vector
        status = TICK
        while status == TICK:
            status = backend.rig_step(
                self._loop, self._sensors, self._components, self._changes, *controller, vector,
                duration, self._memory,
            )
            if status == TICK:
                self._sample()
        if status != 0:
            memory = self._memory
            time = float(memory[CLOCK, 7])
            raise SimulationError(failure(status, time, memory[CRANE], memory[PARAMETERS]))

    def _sample(self) -> None:
        """Ask a controller that is no kernel for its correction."""
        memory = self._memory
        assert not isinstance(self._controller, SwayFeedback)
        found = self._controller.sample(
            float(memory[CLOCK, 7]), memory[SIGNALS, :5].copy(), memory[REFERENCE, :10].copy(),
            memory[ADDED_TO, :3].copy(),
        )
        memory[CORRECTION, :3] = found
        backend.switch_correction(self._loop, memory)


def _corrector(controller: Controller | SwayFeedback) -> int:
    """Which of the kernel's controllers this one is; what a class derives may be anything."""
    if isinstance(controller, SwayFeedback):
        return STATE
    return TRACKING if type(controller) is TrackingController else CALLER


def _arrays(controller: Controller | SwayFeedback) -> Arrays:
    """Parameters, tables and memory of the kernel's controllers; empty where there is none."""
    if type(controller) is TrackingController:
        return controller.arrays
    vector, table = np.zeros(1), np.zeros((1, 1, 1))
    if isinstance(controller, SwayFeedback):
        return vector, vector, table, controller.lengths, controller.gains, np.zeros((1, 1))
    return vector, vector, table, vector, table, np.zeros((1, 1))
