"""Where the crane starts on PythonFMU: kernels/rig/start.py with its messages."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane import Crane
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Axes, PlantStatus, State
from segfmu.kernels.messages import START
from segfmu.kernels.rig.records import StartFault, StartStatus

ROPE = State.POSITION + Axes.ROPE


class Start:
    """The state at the start, and how far it is from its reference.

    Parameters
    ----------
    own, held : ndarray, shape (10,)
        Start values of the state, and those of the reference.
    on_reference : bool
        Whether the reference at initialisation puts the crane in its place.
    """

    def __init__(self, own: FloatArray, held: FloatArray, on_reference: bool) -> None:
        self._own, self._held, self._on_reference = own, held, on_reference
        self._state, self._reference = own, held
        # whether anybody gave a reference to judge the start by
        self._given = False
        self._fault = np.zeros(StartFault.SIZE)

    def state(self, reference: FloatArray, given: bool) -> FloatArray:
        """The state at the start, shape (10,), under a reference, which somebody gave or not.

        Raises
        ------
        InputError
            For a rope without length, and a load that does not hang below the trolley.
        """
        state = self._own.copy()
        if self._on_reference:
            backend.start_state(self._own, self._held, reference, state)
        status = backend.check_start(state, reference, self._fault)
        if status != StartStatus.FITS:
            raise InputError(self._text(status))
        self._state, self._reference, self._given = state, reference, given
        return state

    def is_late(self, reference: FloatArray, step: float) -> bool:
        """Whether the first step [s] has a reference that is to be followed to another start."""
        if not backend.is_elsewhere(self._reference, reference, step):
            return False
        self._reference, self._given = reference, True
        return self._on_reference

    def warning(self, crane: Crane, enabled: bool) -> str | None:
        """What the user ought to know of the start; feedback that is enabled corrects at once."""
        if not self._given:
            return None
        status = self._judged(crane)
        if not enabled or status == StartStatus.FITS:
            status = backend.check_start_rope(
                float(self._state[ROPE]), crane.rope_min or 0.0, crane.rope_max or 0.0, self._fault
            )
        return None if status == StartStatus.FITS else self._text(status)

    def failure(self, crane: Crane, status: int, time: float, since: float) -> str | None:
        """The message of a failure at a time [s] that a start far from the reference explains."""
        swing = 2.0 * pi * sqrt(self._state[ROPE] / crane.gravity)
        if (
            status >= PlantStatus.BELOW_TRAVEL or since >= swing
            or self._judged(crane) == StartStatus.FITS
        ):
            return None
        self._fault[StartFault.TIME] = time
        return self._text(StartStatus.FAILED)

    def _judged(self, crane: Crane) -> int:
        if not self._given:
            return StartStatus.FITS
        return backend.judge_start(self._state, self._reference, crane.gravity, self._fault)

    def _text(self, status: int) -> str:
        text: str = START.text(status, self._fault.tolist())
        return text
