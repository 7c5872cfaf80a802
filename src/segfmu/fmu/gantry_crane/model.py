"""GantryCrane as a model to build."""

from __future__ import annotations

from segfmu.fmu.gantry_crane.interface import native_spec, spec
from segfmu.fmu.model import Model

GANTRY_CRANE = Model(
    name="GantryCrane",
    package="segfmu.fmu.gantry_crane",
    spec=spec,
    native_spec=native_spec,
    slave="segfmu.fmu.gantry_crane.slave:CraneSlave",
)
