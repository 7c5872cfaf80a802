"""Pendulum as a model to build."""

from __future__ import annotations

from segfmu.fmu.model import Model
from tests.fmu.pendulum.interface import native_spec, spec

PENDULUM = Model(
    name="Pendulum",
    package="tests.fmu.pendulum",
    spec=spec,
    native_spec=native_spec,
    largest=lambda: native_spec(spec()),
    slave="tests.fmu.pendulum.slave:PendulumSlave",
)
