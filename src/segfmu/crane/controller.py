"""What the plant needs of a controller, and the state feedback as one."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from segfmu.crane.feedback import SwayFeedback
from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray


class Controller(Protocol):
    """A sampled correction of the drives' setpoints."""

    @property
    def sample_time(self) -> float:
        """Period [s]."""

    def sample(
        self, time: float, measured: FloatArray, reference: FloatArray, feedforward: FloatArray
    ) -> FloatArray:
        """Correction at a tick, shape (3,), held until the next one.

        It is added to the force setpoints [N]; in velocity mode it is an acceleration [m/s2],
        whose integral is added to the velocity setpoints. The plant calls this at every tick, also
        while the correction is not used, so that an observer inside goes on.

        Parameters
        ----------
        time : float
            [s]
        measured : ndarray, shape (5,)
            Signals of the sensors: bridge, trolley, rope length, two sway angles.
        reference : ndarray, shape (10,)
            Reference state.
        feedforward : ndarray, shape (3,)
            What the correction is added to: force setpoints, or slopes of the velocity setpoints.
        """


class StateFeedback:
    """`SwayFeedback` on the true state, which no sensor gives.

    Parameters
    ----------
    feedback : SwayFeedback
        Gains.
    state : ndarray, shape (10 or more,)
        The true state; a view, read at every sample.
    """

    def __init__(self, feedback: SwayFeedback, state: FloatArray) -> None:
        self.sample_time = feedback.sample_time
        self._feedback = feedback
        self._state = state

    def sample(
        self, time: float, measured: FloatArray, reference: FloatArray, feedforward: FloatArray
    ) -> FloatArray:
        """-K(l) (x - x*); see `Controller.sample`."""
        correction = np.zeros(3)
        backend.feedback_correction(
            self._state, reference, self._feedback.lengths, self._feedback.gains, correction
        )
        return correction
