"""The tracking controller: from measured signals to corrections of the setpoints, sampled.

Observer, scheduled feedback, rejection of the estimated disturbances (which is the integral
action), limits without windup, and switching without a bump; the tick itself is the kernel
`track_setpoint`.
"""

from __future__ import annotations

from math import exp

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.checks import require_not_negative, require_positive, sized
from segfmu.crane.feedback import SwayFeedback
from segfmu.crane.linear import SIGNS, moved_masses
from segfmu.crane.observer import Observer
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray

# the first five arguments of the kernel, and its memory
Arrays = tuple[FloatArray, FloatArray, FloatArray, FloatArray, FloatArray, FloatArray]

UNLIMITED = 1e99
# s
FADE = 0.1
PAYLOAD_TIME = 2.0
# of the kernel's memory
MEMORY = 22, 10


class TrackingController:
    """Corrections (3,) that keep a crane at its reference, from measured signals alone.

    The correction is a force [N] to add to the force setpoints or, where the observer is for
    velocity drives, an acceleration [m/s2] whose integral is added to the velocity setpoints.

    Parameters
    ----------
    observer : Observer
    feedback : SwayFeedback
        Gains, of the same period.
    rejection : tuple of 2 float
        Shares, 0 to 1, of the estimated disturbance of carriages and rope, and of the load, that
        are rejected. 1 leaves no lasting error of the load's position, 0 is the plain feedback.
    lower, upper : array_like, shape (3,), optional
        Least and greatest setpoint, feedforward included [N] or [m/s2].
    fade : float
        Time constant [s] of changes by switching; 0 lets the correction jump.
    payload_time : float
        Time constant [s] of the payload's estimate, in force mode.
    enabled : bool

    Raises
    ------
    InputError
        For periods that differ, shares outside 0 to 1, empty limits or a negative fade.
    """

    def __init__(
        self,
        observer: Observer,
        feedback: SwayFeedback,
        *,
        rejection: tuple[float, float] = (1.0, 1.0),
        lower: ArrayLike | None = None,
        upper: ArrayLike | None = None,
        fade: float = FADE,
        payload_time: float = PAYLOAD_TIME,
        enabled: bool = True,
    ) -> None:
        require_positive("payload_time", payload_time)
        period = observer.sample_time
        self.observer = observer
        self._parameters = np.zeros(27)
        self._parameters[:3] = observer.driven, period, observer.delayed
        self._parameters[3:6] = moved_masses(observer.crane.masses)
        self._parameters[6] = observer.crane.gravity
        self._parameters[19] = period / payload_time
        self._parameters[20:23], self._parameters[23:] = observer.tolerances, observer.offset
        least, greatest = _limits("lower", lower, -UNLIMITED), _limits("upper", upper, UNLIMITED)
        if (least > greatest).any():
            raise InputError(
                f"lower must not be above upper, got {least.tolist()} and {greatest.tolist()}"
            )
        self._parameters[12:15], self._parameters[15:18] = least, greatest
        self._memory = np.zeros(MEMORY)
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
        """What kernels/control/tracking.py calls `parameters`; a copy."""
        return self._parameters.copy()

    @property
    def arrays(self) -> Arrays:
        """The first five arguments of the kernel, and its memory; not copies."""
        return (
            self._parameters, self.observer.lengths, self.observer.table, self._feedback.lengths,
            self._feedback.gains, self._memory,
        )

    @property
    def enabled(self) -> bool:
        """Whether corrections are made; the observer always goes on."""
        return bool(self._parameters[9])

    @enabled.setter
    def enabled(self, value: bool) -> None:
        if bool(value) != self.enabled:
            self._parameters[9] = bool(value)
            self._memory[3, 4] = 1.0

    @property
    def fade(self) -> float:
        """Time constant [s] of changes by switching; may be changed while running."""
        return float(self._parameters[10])

    @fade.setter
    def fade(self, value: float) -> None:
        require_not_negative("fade", value)
        self._parameters[10] = value
        self._parameters[11] = exp(-self.sample_time / value) if value > 0.0 else 0.0

    @property
    def feedback(self) -> SwayFeedback:
        """Gains; may be replaced while running."""
        return self._feedback

    @feedback.setter
    def feedback(self, value: SwayFeedback) -> None:
        if value.sample_time != self.sample_time:
            raise InputError(
                f"feedback has a period of {value.sample_time} s and the observer of "
                f"{self.sample_time} s; design both for one sample_time"
            )
        self._feedback = value
        self._parameters[18] = value.payload
        self._memory[3, 4] = 1.0

    @property
    def rejection(self) -> tuple[float, float]:
        """Shares of the disturbances that are rejected; may be changed while running."""
        return float(self._parameters[7]), float(self._parameters[8])

    @rejection.setter
    def rejection(self, value: tuple[float, float]) -> None:
        shares = sized("rejection", value, 2)
        if (shares < 0.0).any() or (shares > 1.0).any():
            raise InputError(f"rejection must be shares from 0 to 1, got {shares.tolist()}")
        self._parameters[7:9] = shares
        self._memory[3, 4] = 1.0

    @property
    def deviation(self) -> FloatArray:
        """Estimated state minus its reference at the last tick, shape (10,)."""
        found = np.zeros(10)
        found[:3], found[5:8] = self._memory[:3, 0], self._memory[:3, 2]
        found[3:5], found[8:10] = SIGNS * self._memory[:2, 1], SIGNS * self._memory[:2, 3]
        return found

    @property
    def disturbance(self) -> FloatArray:
        """Estimated unknown accelerations of carriages and rope, and of the load; (2, 3) [m/s2]."""
        found: FloatArray = self._memory[:3, 4:6].T.copy()
        return found

    @property
    def payload(self) -> float:
        """Estimated payload [kg]; in velocity mode the nominal one."""
        return float(self._parameters[5] * (1.0 + self._memory[5, 3]))

    @property
    def offset(self) -> float:
        """What is added to the measured length of the rope [m]."""
        return float(self._memory[18, 5])

    def reset(self, deviation: ArrayLike | None = None) -> None:
        """Forget the past.

        Positions and angles start at the first measured ones, velocities and rates at those of a
        deviation of the state, (10,), if it is given.
        """
        self._memory[:] = 0.0
        if deviation is not None:
            value = sized("deviation", deviation, 10)
            self._memory[:3, 2] = value[5:8]
            self._memory[:2, 3] = SIGNS * value[8:10]

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
            Bridge, trolley, rope length and the two sway angles; one sample old if the observer
            is for that.
        reference : ndarray, shape (10,)
            Reference state at this tick.
        feedforward : ndarray, shape (3,), optional
            What the correction is added to, forces [N] or accelerations [m/s2]; it counts for the
            limits alone.
        """
        correction = np.zeros(3)
        given = np.zeros(3) if feedforward is None else feedforward
        parameters, lengths, table, gain_lengths, gains, memory = self.arrays
        backend.track_setpoint(
            parameters, lengths, table, gain_lengths, gains, measured, reference, given, memory,
            correction,
        )
        return correction


def _limits(name: str, value: ArrayLike | None, default: float) -> FloatArray:
    return np.full(3, default) if value is None else sized(name, value, 3)
