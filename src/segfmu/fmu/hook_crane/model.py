"""HookCrane as a model to build."""

from __future__ import annotations

from functools import cache

from segfmu.fmu.gantry_crane.model import GANTRY_CRANE
from segfmu.fmu.hook_crane.interface import native_spec, spec
from segfmu.fmu.model import Model
from segfmu.kernels.hook.records import (
    HookMasses,
    HookOutputs,
    HookWeighing,
    Sling,
    SlingAccelerations,
    SlingReference,
)

HOOK_CRANE = Model(
    name="HookCrane",
    package="segfmu.fmu.hook_crane",
    spec=spec,
    native_spec=native_spec,
    largest=cache(native_spec),
    records=(
        *GANTRY_CRANE.records, HookMasses, HookWeighing, Sling, SlingReference,
        SlingAccelerations, HookOutputs,
    ),
    shared=GANTRY_CRANE.shared,
    slave="segfmu.fmu.hook_crane.slave:HookCraneSlave",
)
