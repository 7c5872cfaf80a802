"""Records that every model of planner and flat inverse fills from variables, or shows."""

from __future__ import annotations

from segfmu.kernels.clearance.records import ObstacleRow, Space
from segfmu.kernels.crane.records import (
    BoundUses,
    Compensation,
    DriveBounds,
    LoadMotion,
    Resistance,
    RopeBounds,
)
from segfmu.kernels.limits.records import Pace, PlanLimits
from segfmu.kernels.planner.records import LoadLimits, LowerLimits, PlanOptions

RECORDS = (
    Resistance, RopeBounds, PlanOptions, LoadLimits, LowerLimits, LoadMotion, Compensation,
    DriveBounds, BoundUses, Space, ObstacleRow, Pace, PlanLimits,
)
