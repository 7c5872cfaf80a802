"""The interface between plant and controller."""

from __future__ import annotations

from typing import Protocol

from segfmu.arrays import FloatArray


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
        while the correction is switched off, so that an observer inside keeps running.

        Parameters
        ----------
        time : float
            [s]
        measured : ndarray, shape (5,)
            Signals of the sensors: bridge, trolley, rope length, two sway angles.
        reference : ndarray, shape (10,)
            Reference state.
        feedforward : ndarray, shape (3,)
            Force setpoints, or accelerations that the velocity setpoints alone give the drives; the
            correction is added to them.
        """
