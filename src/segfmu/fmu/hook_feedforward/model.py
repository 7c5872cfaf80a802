"""HookFeedforward as a model to build."""

from __future__ import annotations

from functools import cache

from segfmu.fmu.feedforward.model import RECORDS
from segfmu.fmu.hook_feedforward.interface import MOST_WAYPOINTS, native_spec, spec
from segfmu.fmu.model import Model
from segfmu.kernels.hook.records import HookFeedforward

HOOK_FEEDFORWARD = Model(
    name="HookFeedforward",
    package="segfmu.fmu.hook_feedforward",
    spec=spec,
    native_spec=native_spec,
    largest=cache(lambda: native_spec(spec(MOST_WAYPOINTS))),
    records=(*RECORDS, HookFeedforward),
    shared=("segfmu.fmu.feedforward",),
    slave="segfmu.fmu.hook_feedforward.slave:HookFeedforwardSlave",
)
