"""GantryFeedforward as a model to build."""

from __future__ import annotations

from functools import cache

from segfmu.fmu.feedforward.model import RECORDS
from segfmu.fmu.gantry_feedforward.interface import MOST_WAYPOINTS, native_spec, spec
from segfmu.fmu.model import Model
from segfmu.kernels.crane.records import Feedforward
from segfmu.kernels.operation.records import Command, DriveBrakes

GANTRY_FEEDFORWARD = Model(
    name="GantryFeedforward",
    package="segfmu.fmu.gantry_feedforward",
    spec=spec,
    native_spec=native_spec,
    largest=cache(lambda: native_spec(spec(MOST_WAYPOINTS))),
    records=(*RECORDS, Feedforward, Command, DriveBrakes),
    shared=("segfmu.fmu.feedforward",),
    slave="segfmu.fmu.gantry_feedforward.slave:FeedforwardSlave",
)
