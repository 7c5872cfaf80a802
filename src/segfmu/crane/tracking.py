"""The tracking controller: from measured signals to corrections of the setpoints, sampled.

Observer, scheduled feedback, rejection of the estimated disturbances (the integral action), limits
without windup, and bumpless switching. The kernel `track_setpoint` computes a tick.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, as_flag, shown, sized
from segfmu.crane.checks import require_kind, require_not_negative, require_positive
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.linear import SIGNS
from segfmu.crane.observer import Observer
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.control.records import (
    Correction,
    Estimate,
    Estimates,
    Fading,
    OffsetEstimate,
    OffsetMemory,
    Tick,
    Tracker,
    Tracking,
    TrackingDesign,
    Uncertainty,
    VelocityCommand,
)
from segfmu.kernels.crane.records import Axes, Coordinates, Plant, State

# parameters, the observer's table, gains and memory of the kernel
Arrays = tuple[FloatArray, FloatArray, FloatArray, FloatArray]

Cause = Literal["wind", "sensor"]
CAUSES: tuple[Cause, ...] = ("wind", "sensor")

# s
FADE = 0.1
PAYLOAD_TIME = 2.0

# rows of the kernel's memory, and entries of its parameters
ESTIMATE = slice(Tracker.ESTIMATE, Tracker.COMMAND)
PRESENT = slice(Tracker.PRESENT, Tracker.AHEAD)
VELOCITIES = slice(Tracking.VELOCITY_MAX, Tracking.VELOCITY_MIN)
LEAST_VELOCITIES = slice(Tracking.VELOCITY_MIN, Tracking.POWER_MAX)
POWERS = slice(Tracking.POWER_MAX, Tracking.OFFSET_CAUSE)
REJECTED = slice(Tracking.REJECTED_DRIFT, Tracking.ENABLED)


class TrackingController:
    """Corrections (3,) that keep a crane at its reference, from measured signals only.

    The correction is a force [N] to add to the force setpoints or, if the observer is for velocity
    drives, an acceleration [m/s2] whose integral is added to the velocity setpoints.

    Parameters
    ----------
    observer : Observer
    feedback : SwayFeedback
        Gains, of the same period.
    rejection : tuple of 2 float
        Rejected shares, 0 to 1, of the estimated disturbances: of carriages and rope, and of the
        load. 1 leaves no lasting error of the load's position, 0 is the plain feedback.
    lower, upper : array_like, shape (3,), optional
        Least and greatest setpoint, feedforward included [N] or [m/s2]. The hoist leaves at least
        a tenth of the load's weight on the rope, whatever is given.
    velocity_max : array_like, shape (3,), optional
        Bounds of the velocity setpoints with what corrections add [m/s]; 0: none.
    velocity_min : array_like, shape (3,), optional
        The same of negative ones, not above 0; 0: as `velocity_max`.
    power_max : array_like, shape (3,), optional
        Largest powers of the drives [W], driving or braking; 0: none.
    fade : float
        Time constant [s] of the transition after switching; with 0 the correction jumps.
    payload_time : float
        Time constant [s] of the payload's estimate, in force mode.
    offset_cause : {"wind", "sensor"}
        What a lasting deviation of a sway angle is: wind, for which the carriage makes room, or the
        zero of the angle's sensor, for which it stays. Signals do not tell.
    rope_offset : bool
        Correct the rope's measured length by the estimated offset of its sensor.
    enabled : bool

    Raises
    ------
    InputError
        For different periods, shares outside 0 to 1, empty limits, a `velocity_min` above 0 or a
        negative fade.
    """

    def __init__(
        self,
        observer: Observer,
        feedback: SwayFeedback,
        *,
        rejection: tuple[float, float] = (1.0, 1.0),
        lower: ArrayLike | None = None,
        upper: ArrayLike | None = None,
        velocity_max: ArrayLike | None = None,
        velocity_min: ArrayLike | None = None,
        power_max: ArrayLike | None = None,
        fade: float = FADE,
        payload_time: float = PAYLOAD_TIME,
        offset_cause: Cause = "wind",
        rope_offset: bool = False,
        enabled: bool = True,
    ) -> None:
        require_kind("observer", observer, Observer)
        require_positive("payload_time", payload_time)
        if not isinstance(offset_cause, str) or offset_cause not in CAUSES:
            raise InputError(f"offset_cause must be wind or sensor, got {shown(offset_cause)}")
        period = observer.sample_time
        self.observer = observer
        own = np.zeros(Tracking.SIZE)
        own[Tracking.PERIOD] = period
        design = np.zeros(TrackingDesign.SIZE)
        design[: Uncertainty.SIZE] = observer.uncertainty.vector
        design[TrackingDesign.DEAD_TIME] = observer.delayed * period
        design[TrackingDesign.PAYLOAD_TIME] = payload_time
        plant = observer.crane.plant(observer.driven)
        plant[Plant.DEAD_TIME : Plant.DEAD_TIME + Axes.SIZE] = observer.dead_time
        backend.set_tracking(plant, design, float(observer.lengths[-1]), own)
        own[Tracking.OFFSET_CAUSE] = CAUSES.index(offset_cause)
        own[Tracking.OFFSET_ACTS] = as_flag("rope_offset", rope_offset)
        if velocity_max is not None:
            own[VELOCITIES] = sized("velocity_max", velocity_max, 3)
        if velocity_min is not None:
            own[LEAST_VELOCITIES] = sized("velocity_min", velocity_min, 3)
            if (own[LEAST_VELOCITIES] > 0.0).any():
                raise InputError(
                    f"velocity_min must not be above 0, got {own[LEAST_VELOCITIES].tolist()}"
                )
        if power_max is not None:
            own[POWERS] = sized("power_max", power_max, 3)
        limits = own[Tracking.LEAST : Tracking.GAINS_PAYLOAD].reshape(2, Axes.SIZE)
        least, greatest = _limits("lower", lower, limits[0]), _limits("upper", upper, limits[1])
        if (least > greatest).any():
            raise InputError(
                f"lower must not be above upper, got {least.tolist()} and {greatest.tolist()}"
            )
        # the hoist cannot push, whatever is given
        pull = max(float(limits[1, Axes.ROPE]), float(least[Axes.ROPE]))
        limits[0], limits[1] = least, greatest
        limits[1, Axes.ROPE] = min(limits[1, Axes.ROPE], pull)
        self._parameters = own
        self._memory = np.zeros((Tracker.SIZE, Tracker.COLUMNS))
        self.fade = fade
        self.rejection = rejection
        self.feedback = feedback
        self.enabled = enabled
        self.reset()

    @property
    def sample_time(self) -> float:
        """Period [s]."""
        return self.observer.sample_time

    @property
    def parameters(self) -> FloatArray:
        """The kernels' `Tracking`; a copy."""
        return self._parameters.copy()

    @property
    def arrays(self) -> Arrays:
        """Parameters, the observer's table, gains and memory of the kernel; not copies."""
        return self._parameters, self.observer.table, self._feedback.table, self._memory

    @property
    def enabled(self) -> bool:
        """Whether corrections act; the observer always runs."""
        return bool(self._parameters[Tracking.ENABLED])

    @enabled.setter
    def enabled(self, value: bool) -> None:
        acts = as_flag("enabled", value)
        if acts != self.enabled:
            self._parameters[Tracking.ENABLED] = acts
            self._switch()

    @property
    def fade(self) -> float:
        """Time constant [s] of the transition after switching; may be changed while running."""
        return float(self._parameters[Tracking.FADE])

    @fade.setter
    def fade(self, value: float) -> None:
        require_not_negative("fade", value)
        self._parameters[Tracking.FADE] = value
        backend.set_fading(self._parameters)

    @property
    def feedback(self) -> SwayFeedback:
        """Gains; may be replaced while running."""
        return self._feedback

    @feedback.setter
    def feedback(self, value: SwayFeedback) -> None:
        require_kind("feedback", value, SwayFeedback)
        if value.sample_time != self.sample_time:
            raise InputError(
                f"feedback has a period of {value.sample_time} s and the observer of "
                f"{self.sample_time} s; design both for one sample_time"
            )
        self._feedback = value
        self._parameters[Tracking.GAINS_PAYLOAD] = value.payload
        self._switch()

    @property
    def rejection(self) -> tuple[float, float]:
        """Rejected shares of the disturbances; may be changed while running."""
        drift, wind = self._parameters[REJECTED].tolist()
        return drift, wind

    @rejection.setter
    def rejection(self, value: tuple[float, float]) -> None:
        shares = sized("rejection", value, 2)
        if (shares < 0.0).any() or (shares > 1.0).any():
            raise InputError(f"rejection must be shares from 0 to 1, got {shares.tolist()}")
        self._parameters[REJECTED] = shares
        self._switch()

    @property
    def deviation(self) -> FloatArray:
        """Estimated state minus its reference at the last tick, shape (10,)."""
        estimate, found = self._memory[PRESENT], np.zeros(State.SIZE)
        found[State.POSITION : State.ANGLE] = estimate[:, Estimate.POSITION]
        found[State.ANGLE : State.VELOCITY] = SIGNS * estimate[:2, Estimate.ANGLE]
        found[State.VELOCITY : State.RATE] = estimate[:, Estimate.VELOCITY]
        found[State.RATE : State.SIZE] = SIGNS * estimate[:2, Estimate.RATE]
        return found

    @property
    def disturbance(self) -> FloatArray:
        """Estimated unknown accelerations of carriages and rope, and of the load; (2, 3) [m/s2]."""
        found: FloatArray = self._memory[PRESENT, Estimate.DRIFT : Estimate.SIZE].T.copy()
        return found

    @property
    def payload(self) -> float:
        """Estimated payload [kg]; in velocity mode the nominal one."""
        nominal = self._parameters[Tracking.MASSES + Axes.ROPE]
        return float(nominal * (1.0 + self._memory[Tracker.FADING, Fading.PAYLOAD]))

    @property
    def offset(self) -> float:
        """Estimated correction of the measured rope length [m]; it acts only with `rope_offset`."""
        offset = self._memory[Tracker.OFFSET + OffsetMemory.ESTIMATE, OffsetEstimate.USED]
        return float(offset)

    @property
    def estimates(self) -> FloatArray:
        """The kernels' `Estimates`."""
        found = np.zeros(Estimates.SIZE)
        backend.tracking_estimates(self._parameters, self._memory, found)
        return found

    @property
    def holding(self) -> FloatArray:
        """Setpoints (3,) that hold the nominal load at rest [N] or [m/s2]."""
        weight = self._parameters[Tracking.MASSES + Axes.ROPE] * self._parameters[Tracking.GRAVITY]
        return np.array([0.0, 0.0, 0.0 if self.observer.driven else -weight])

    def reset(self, deviation: ArrayLike | None = None) -> None:
        """Reset the memory.

        Positions and angles start at the first measured values, velocities and rates at those of
        `deviation` (10,), the deviation of the state, if given.
        """
        self._memory[:] = 0.0
        if deviation is not None:
            value = sized("deviation", deviation, 10)
            estimate = self._memory[ESTIMATE]
            estimate[:, Estimate.VELOCITY] = value[State.VELOCITY : State.RATE]
            estimate[:2, Estimate.RATE] = SIGNS * value[State.RATE : State.SIZE]
            self._memory[PRESENT, : Estimate.SIZE] = estimate[:, : Estimate.SIZE]

    def _switch(self) -> None:
        """Mark a switch, so that the kernel lets the change fade in."""
        self._memory[Tracker.COMMAND, VelocityCommand.SWITCHED] = 1.0

    def sample(
        self,
        time: float,
        measured: FloatArray,
        reference: FloatArray,
        feedforward: FloatArray | None = None,
    ) -> FloatArray:
        """Correction at a tick, shape (3,), held until the next one.

        Parameters
        ----------
        time : float
            [s]; ticks are a period apart.
        measured : ndarray, shape (5,)
            Bridge, trolley, rope length and the two sway angles, as old as the observer expects.
        reference : ndarray, shape (10,)
            Reference state at this tick.
        feedforward : ndarray, shape (3,), optional
            Forces [N] or accelerations [m/s2] to which the correction is added; only the limits use
            it. By default those that hold the nominal load.
        """
        tick = np.zeros((Tick.SIZE, Tick.COLUMNS))
        tick[Tick.SIGNALS, : Coordinates.SIZE] = sized("measured", measured, Coordinates.SIZE)
        tick[Tick.REFERENCE, : State.SIZE] = sized("reference", reference, State.SIZE)
        added = self.holding if feedforward is None else feedforward
        tick[Tick.ADDED_TO, : Axes.SIZE] = sized("feedforward", added, Axes.SIZE)
        parameters, table, gains, memory = self.arrays
        backend.track_setpoint(parameters, table, gains, tick, memory)
        return tick[Tick.CORRECTION, Correction.VALUE : Correction.FADING].copy()


def _limits(name: str, value: ArrayLike | None, default: FloatArray) -> FloatArray:
    return default if value is None else sized(name, value, 3)
