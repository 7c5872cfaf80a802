"""GantryCrane as a model to build."""

from __future__ import annotations

from functools import cache

from segfmu.fmu.gantry_crane.interface import native_spec, spec
from segfmu.fmu.model import Model
from segfmu.kernels.control.records import Estimates, FlatDesign, GainsRow, Tracking, TrackingDesign
from segfmu.kernels.crane.records import Plant, State
from segfmu.kernels.rig.records import (
    Accelerations,
    Loop,
    Outputs,
    PayloadChange,
    Sensors,
    Setpoints,
    Target,
    Turbulence,
    WindNoise,
)

GANTRY_CRANE = Model(
    name="GantryCrane",
    package="segfmu.fmu.gantry_crane",
    spec=spec,
    native_spec=native_spec,
    largest=cache(native_spec),
    records=(
        Loop, Sensors, Plant, State, Setpoints, Target, PayloadChange, WindNoise, Turbulence,
        Tracking, TrackingDesign, Outputs, Accelerations, Estimates, FlatDesign, GainsRow,
    ),
    shared=("segfmu.fmu.crane",),
    slave="segfmu.fmu.gantry_crane.slave:CraneSlave",
)
