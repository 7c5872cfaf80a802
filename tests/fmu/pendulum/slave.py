"""Pendulum on PythonFMU."""

from __future__ import annotations

from math import sin
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from segfmu.fmu.python.slave import SpecSlave
from tests.fmu.pendulum.equation import rates
from tests.fmu.pendulum.interface import INPUTS, spec


class PendulumSlave(SpecSlave):
    """Inputs are linear in time between the ends of two steps."""

    spec = spec()

    def initialise(self) -> None:
        self._before = self._inputs()
        self._show(self._state())

    def advance(self, time: float, step: float) -> None:
        before, after = self._before, self._inputs()
        gravity = self.value("crane.gravity")
        solved = solve_ivp(
            lambda t, s: rates(s, before + (after - before) * t / step, gravity),
            (0.0, step), self._state(), rtol=1e-10, atol=1e-12,
        )
        self._before = after
        self._show(solved.y[:, -1])

    def _inputs(self) -> Any:
        return np.array([self.value(name) for name, *_ in INPUTS])

    def _state(self) -> tuple[float, float]:
        return self.value("sway.angle"), self.value("sway.rate")

    def _show(self, state: Any) -> None:
        offset = self.value("reference.rope.length") * sin(state[0])
        self.assign(("sway.angle", "sway.rate", "load.offset"), (*map(float, state), offset))
