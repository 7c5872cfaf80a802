"""GantryFeedforward as a model to build."""

from __future__ import annotations

from functools import cache

from segfmu.fmu.gantry_feedforward.interface import MOST_WAYPOINTS, native_spec, spec
from segfmu.fmu.model import Model
from segfmu.kernels.clearance.records import ObstacleRow, Space
from segfmu.kernels.crane.records import (
    BoundUses,
    Compensation,
    DriveBounds,
    Feedforward,
    LoadMotion,
    Resistance,
    RopeBounds,
)
from segfmu.kernels.limits.records import Pace, PlanLimits
from segfmu.kernels.operation.records import Command
from segfmu.kernels.planner.records import LoadLimits, LowerLimits, PlanOptions

GANTRY_FEEDFORWARD = Model(
    name="GantryFeedforward",
    package="segfmu.fmu.gantry_feedforward",
    spec=spec,
    native_spec=native_spec,
    largest=cache(lambda: native_spec(spec(MOST_WAYPOINTS))),
    records=(
        Resistance, RopeBounds, PlanOptions, LoadLimits, LowerLimits, LoadMotion, Feedforward,
        Compensation, DriveBounds, BoundUses, Space, ObstacleRow, Pace, PlanLimits, Command,
    ),
    slave="segfmu.fmu.gantry_feedforward.slave:FeedforwardSlave",
)
