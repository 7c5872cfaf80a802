"""A controller behind a dead band: what quantised signals cannot tell is no deviation.

A signal that is rounded to steps of an encoder differs from its reference by up to half a step
even where the crane is exactly at its reference. Answering that only shakes the crane; so each
deviation is made smaller by half a step, and one below that is none.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.checks import require_not_negative, sized
from segfmu.crane.controller import Controller
from segfmu.planning.arrays import FloatArray


class DeadBand:
    """A controller that sees deviations from the reference less half a quantisation step.

    Parameters
    ----------
    controller : Controller
    resolution : array_like, shape (5,)
        Quantisation steps of bridge, trolley, rope length and the two sway angles [m], [rad]; 0
        leaves a signal as it is.
    delayed : bool
        Whether measured signals are one sample old, and so belong to the reference before.

    Raises
    ------
    InputError
        For negative steps.
    """

    def __init__(
        self, controller: Controller, resolution: ArrayLike, *, delayed: bool = False
    ) -> None:
        steps = sized("dead band resolution", resolution, 5)
        for step in steps:
            require_not_negative("dead band resolution", float(step))
        self._controller = controller
        self._half = 0.5 * steps
        self._delayed = delayed
        self._before: FloatArray | None = None

    @property
    def sample_time(self) -> float:
        """Period [s]."""
        return self._controller.sample_time

    def sample(
        self, time: float, measured: FloatArray, reference: FloatArray, feedforward: FloatArray
    ) -> FloatArray:
        """Correction at a tick; see `Controller.sample`."""
        aim = reference[:5]
        if self._delayed and self._before is not None:
            aim = self._before
        self._before = reference[:5].copy()
        deviation = measured - aim
        beyond = np.maximum(np.abs(deviation) - self._half, 0.0)
        return self._controller.sample(
            time, aim + np.copysign(beyond, deviation), reference, feedforward
        )
