"""Step-by-step simulation of the controlled crane: controller, drives, dynamics, sensors.

One class serves the Python simulation and the FMU on PythonFMU. Setpoints and references are given
for the end of each step; within a step they are linear in time. The integration stops exactly at
the ticks of controller and sensors, at payload changes and at the ends of a gust, so the result
does not depend on the step. The computation is in kernels/rig/rig.py; this class holds its arrays.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray, as_flag, as_index, require_callable, sized, table_of
from segfmu.crane.checks import (
    require_finite,
    require_kind,
    require_not_negative,
    require_number,
    require_positive,
)
from segfmu.crane.controller import Controller
from segfmu.crane.energy import EnergyBalance
from segfmu.crane.failures import failure
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.flat_models import model_of
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.rig import Rig, require_fitting
from segfmu.crane.setpoints import Setpoints
from segfmu.crane.tracking import FADE, TrackingController
from segfmu.errors import InputError, SimulationError
from segfmu.kernels import backend
from segfmu.kernels.control.records import Acting, Correction, Gains, Observer, Tracker, Tracking
from segfmu.kernels.crane.records import (
    Axes,
    Coordinates,
    PlantState,
    PlantStatus,
    Report,
    State,
    Vector,
    Work,
)
from segfmu.kernels.crane.records import Plant as Parameters
from segfmu.kernels.rig.records import (
    Balance,
    Clock,
    Corrector,
    Loop,
    Memory,
    Outputs,
    RigStatus,
    Sensors,
    Settings,
)
from segfmu.kernels.rig.records import Setpoints as Record

TOLERANCE = 1e-10

# stands for tables and memory of a controller without them
NO_OBSERVER = np.zeros((1, Observer.SIZE, Observer.COLUMNS))
NO_GAINS = np.zeros((1, Gains.SIZE, Gains.COLUMNS))
NO_TRACKER = np.zeros((Tracker.SIZE, Tracker.COLUMNS))


class Plant:
    """A crane with drives, a sampled controller, and sensors.

    Parameters
    ----------
    crane : Crane or HookCrane
        The true crane.
    state : array_like, shape (10,), or (14,) with a hook
        Initial state, a `State` or a `HookState`.
    setpoints : Setpoints
        Setpoints at the start.
    controller : Controller or SwayFeedback
        Gains act on the true state, within what the drives can do; any other controller gets the
        measured signals.
    driven : bool
        Velocity drives: bridge, trolley and rope follow the velocity setpoints.
    enabled : bool
        Whether the correction acts; may be changed between steps.
    fade : float
        Time constant [s] of a change of `enabled` or of gains; with 0 the correction jumps.
    rig : Rig, optional
        Real equipment and disturbances; ideal by default.
    start_time : float
        [s]

    Raises
    ------
    InputError
        If the controller's sample time is not positive, the fade is negative, a dead time of the
        drives is too many of the controller's periods, a rope with a hook may slacken, or the state
        has another size.
    """

    def __init__(
        self,
        crane: AnyCrane,
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
        model = model_of(crane)
        require_positive("controller sample_time", getattr(controller, "sample_time", None))
        require_kind("setpoints", setpoints, Setpoints)
        require_finite("start_time", start_time)
        rig = Rig() if rig is None else rig
        require_kind("rig", rig, Rig)
        self._controller = controller
        self._status: int = PlantStatus.DONE
        self._settings = np.zeros((Settings.SIZE, Settings.COLUMNS))
        self._loop = self._settings[Settings.LOOP, : Loop.SIZE]
        self._loop[Loop.CORRECTOR] = _corrector(controller)
        self._loop[Loop.PERIOD] = controller.sample_time
        self.enabled = enabled
        self._loop[Loop.TOLERANCE] = TOLERANCE
        self.fade = fade
        self._settings[Settings.SENSORS, : Sensors.SIZE] = rig.sensors.vector
        self._settings[Settings.PLANT, : Parameters.SIZE] = rig.parameters(crane, driven)
        self._changes, self._components = rig.changes, rig.wind.components
        if isinstance(controller, SwayFeedback):
            known = self._settings[Settings.TRACKING]
            known[Tracking.PERIOD] = controller.sample_time
            backend.set_drives(self._settings[Settings.PLANT], known)
        require_fitting(self._settings[Settings.PLANT], controller.sample_time)
        self._places = model.places
        self._memory = np.zeros((backend.rig_rows(self._settings), Memory.COLUMNS))
        backend.rig_start(
            self._settings, self._components, self._changes,
            model.kept(sized("state", state, model.state.SIZE)), setpoints.vector, start_time,
            self._memory,
        )

    @property
    def enabled(self) -> bool:
        """Whether the correction acts."""
        return bool(self._loop[Loop.ENABLED])

    @enabled.setter
    def enabled(self, value: bool) -> None:
        self._loop[Loop.ENABLED] = as_flag("enabled", value)

    @property
    def fade(self) -> float:
        """Time constant [s] of changes by switching; may be changed between steps."""
        return float(self._loop[Loop.FADE])

    @fade.setter
    def fade(self, value: float) -> None:
        require_not_negative("fade", value)
        self._loop[Loop.FADE] = value

    def retune(self, feedback: SwayFeedback) -> None:
        """Replace the gains on the true state.

        Raises
        ------
        InputError
            For another period, and if the controller is not a SwayFeedback.
        """
        own = self._controller
        require_kind("feedback", feedback, SwayFeedback)
        if not isinstance(own, SwayFeedback) or own.sample_time != feedback.sample_time:
            raise InputError(
                "retune needs a SwayFeedback controller and gains of its sample_time; got gains of "
                f"{feedback.sample_time} s, the {type(own).__name__} has {own.sample_time} s"
            )
        self._controller = feedback
        correction = self._memory[Memory.CORRECTION]
        if correction[Correction.ACTED] != Acting.NO_TICK:
            correction[Correction.ACTED] = Acting.RETUNED

    @property
    def time(self) -> float:
        """Time reached [s]."""
        clock = self._memory[Memory.CLOCK]
        return float(clock[Clock.START] + clock[Clock.REACHED])

    @property
    def ending(self) -> tuple[int, float]:
        """The `PlantStatus` of the last step, and when [s] it was met where it is not DONE."""
        return self._status, float(self._memory[Memory.CLOCK, Clock.EVENT])

    @property
    def state(self) -> FloatArray:
        """State (10,), with a hook (14,); a copy."""
        state = self._memory[Memory.STATE, : PlantState.SIZE]
        found: FloatArray = state[self._places]
        return found

    @property
    def measured(self) -> FloatArray:
        """Signals of the sensors, shape (5,)."""
        return self._memory[Memory.SIGNALS, : Coordinates.SIZE].copy()

    @property
    def drive_force(self) -> FloatArray:
        """Forces [N] that the drives apply, friction included, shape (3,)."""
        return self._report(Report.FORCE)

    @property
    def saturated(self) -> NDArray[np.bool_]:
        """Which drives were at a bound during the last step, shape (3,)."""
        flags: NDArray[np.bool_] = self._report(Report.STEP_SATURATED) > 0.0
        return flags

    @property
    def rope_force(self) -> float:
        """Force on the rope [N]; tension is negative."""
        return float(self._memory[Memory.REPORT, Report.ROPE_FORCE])

    @property
    def wind_power(self) -> float:
        """Power of the wind [W]."""
        return float(self._memory[Memory.REPORT, Report.WIND_POWER])

    @property
    def friction_power(self) -> float:
        """Power dissipated by friction [W]."""
        return float(self._memory[Memory.REPORT, Report.FRICTION_POWER])

    @property
    def payload_mass(self) -> float:
        """Present mass of the load [kg]."""
        return float(self._memory[Memory.PLANT, Parameters.PAYLOAD_MASS])

    @property
    def work(self) -> float:
        """Work of drives and wind since the start [J]."""
        state = self._memory[Memory.STATE]
        return float(state[PlantState.DRIVE_WORK] + state[PlantState.WIND_WORK])

    @property
    def load(self) -> FloatArray:
        """Position and velocity of the load, shape (2, 3)."""
        found = self.outputs(np.zeros(Vector.SIZE))
        return found[Outputs.LOAD_POSITION : Outputs.LOAD_SPEED].reshape(2, 3)

    @property
    def sling_tension(self) -> float:
        """Tension of the sling [N]; 0 without a hook."""
        return float(self._memory[Memory.REPORT, Report.SLING_TENSION])

    @property
    def drive_power(self) -> FloatArray:
        """Power of the drives [W], shape (3,)."""
        return self.outputs(np.zeros(Vector.SIZE))[Outputs.POWER : Outputs.POWER + Axes.SIZE]

    @property
    def energy(self) -> FloatArray:
        """Kinetic and potential energy [J]."""
        balance = self.balance
        return np.array([balance.kinetic, balance.potential])

    @property
    def balance(self) -> EnergyBalance:
        """Energies and works since the start."""
        values = np.zeros(Balance.SIZE)
        backend.rig_balance(self._memory, values)
        return EnergyBalance(*values.tolist())

    def outputs(self, target: FloatArray) -> FloatArray:
        """The kernels' `Outputs`; target: reference position of the load (3,) [m]."""
        place, found = sized("target", target, Vector.SIZE), np.zeros(Outputs.SIZE)
        backend.rig_outputs(place, self._memory, np.zeros(Balance.SIZE), found)
        return found

    def told(self, kernel: Callable[[FloatArray, FloatArray], None], size: int) -> FloatArray:
        """What a kernel of a model writes of the rig's memory, shape (size,)."""
        require_callable("kernel", kernel)
        found = np.zeros(as_index("size", size, self._memory.size))
        kernel(self._memory, found)
        return found

    def step(self, duration: float, setpoints: Setpoints) -> None:
        """Advance by a duration [s] to the given setpoints.

        Raises
        ------
        SimulationError
            If the crane reaches an end stop or leaves the range of its equations; the message says
            what happened and when. The plant keeps the last valid state.
        """
        require_number("duration", duration)
        require_kind("setpoints", setpoints, Setpoints)
        self._advance(duration, setpoints.vector, self._tables())

    def follow(
        self, durations: FloatArray, setpoints: FloatArray, *, most: float = np.inf
    ) -> FloatArray:
        """Take many steps: the signals of the sensors after each, shape (steps, 5).

        Parameters
        ----------
        durations : ndarray, shape (steps,)
            [s].
        setpoints : ndarray, shape (steps, 19)
            A kernel's `Setpoints` a row.
        most : float
            Steps of the integration for each of these steps, on average.

        Raises
        ------
        SimulationError
            As `step` does, and if the integration would take more steps: it is stiff then.
        InputError
            For arrays of other shapes, and a `most` that is not positive.
        """
        durations = table_of("durations", durations, None)
        setpoints = table_of("setpoints", setpoints, durations.size, Record.SIZE)
        if not (isinstance(most, float) and most == np.inf):
            require_positive("most", most)
        tables, signals = self._tables(), self._memory[Memory.SIGNALS, : Coordinates.SIZE]
        integration, left = self._memory[Memory.WORK + Work.STEP], most * durations.size
        found = np.empty((durations.size, Coordinates.SIZE))
        rig, step = (self._settings, self._components, self._changes, *tables), backend.rig_step
        # without the calls of `_advance`, which take a quarter of the time
        self._status = PlantStatus.DONE
        for row, duration, own in zip(found, durations.tolist(), setpoints, strict=True):
            while (status := step(*rig, own, duration, self._memory)) == RigStatus.TICK:
                self._sample()
            if status != PlantStatus.DONE:
                self._end(status)
            row[:] = signals
            left -= duration / integration[0]
            if left < 0.0:
                self._end(PlantStatus.STEP_TOO_SMALL)
        return found

    def _advance(
        self, duration: float, setpoints: FloatArray,
        tables: tuple[FloatArray, FloatArray, FloatArray],
    ) -> None:
        status = RigStatus.TICK
        while status == RigStatus.TICK:
            status = backend.rig_step(
                self._settings, self._components, self._changes, *tables, setpoints, duration,
                self._memory,
            )
            if status == RigStatus.TICK:
                self._sample()
        self._end(status)

    def _end(self, status: int) -> None:
        """Note how a step has ended; raises if it failed."""
        self._status = status
        if status != PlantStatus.DONE:
            memory = self._memory
            _, time = self.ending
            raise SimulationError(
                failure(status, time, memory[Memory.STATE], memory[Memory.PLANT])
            )

    def _sample(self) -> None:
        """Get the correction of a controller written in Python."""
        memory = self._memory
        assert not isinstance(self._controller, SwayFeedback)
        value = self._controller.sample(
            float(memory[Memory.CLOCK, Clock.EVENT]),
            memory[Memory.SIGNALS, : Coordinates.SIZE].copy(),
            memory[Memory.REFERENCE, : State.SIZE].copy(),
            memory[Memory.ADDED_TO, : Axes.SIZE].copy(),
        )
        memory[Memory.CORRECTION, Correction.VALUE : Correction.FADING] = value
        backend.switch_correction(self._settings, memory)

    def _report(self, place: int) -> FloatArray:
        """A triple of the kernel's report; a copy."""
        return self._memory[Memory.REPORT, place : place + Axes.SIZE].copy()

    def _tables(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """The observer's table, the gains and the tracking controller's memory, or empty arrays.

        Also copies the parameters of a tracking controller to the rig, as they may have changed.
        """
        own = self._controller
        if type(own) is TrackingController:
            parameters, table, gains, tracker = own.arrays
            self._settings[Settings.TRACKING, : parameters.size] = parameters
            return table, gains, tracker
        gains = own.table if isinstance(own, SwayFeedback) else NO_GAINS
        return NO_OBSERVER, gains, NO_TRACKER


def _corrector(controller: Controller | SwayFeedback) -> int:
    """The kernel's code for this controller; a subclass counts as the caller's own."""
    if isinstance(controller, SwayFeedback):
        return Corrector.STATE
    return Corrector.TRACKING if type(controller) is TrackingController else Corrector.CALLER
