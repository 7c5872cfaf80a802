"""Refusal of trajectories along which the rope goes slack or leaves its range.

kernels/crane/rope.py does the check.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import RopeFault, RopeWork
from segfmu.kernels.messages import ROPE, ROPE_LIMITS
from segfmu.planning.arrays import FloatArray
from segfmu.planning.messages import text_apart


class LoadTrajectory(Protocol):
    """The interface of a load trajectory that the inverse needs."""

    @property
    def axes(self) -> int:
        """Number of axes."""

    @property
    def duration(self) -> float:
        """Its end [s]."""

    @property
    def smoothness(self) -> int:
        """n: the trajectory is n times continuously differentiable."""

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Value of a derivative, shape (..., axes)."""

    def pieces(self, axis: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Starts (pieces,), lengths (pieces,) and ascending coefficients (pieces, width)."""


def require_rope(crane: Crane, trajectory: LoadTrajectory) -> None:
    """Check that the load stays below the trolley, the rope taut and its length in range.

    Raises
    ------
    InfeasibleError
        With the first time of a violation, and the worst value after it.
    """
    pieces = [trajectory.pieces(axis) for axis in range(3)]
    timing = np.concatenate([np.column_stack(p[:2]) for p in pieces])
    width = max(4, *(p[2].shape[1] for p in pieces))
    coefficients = np.concatenate(
        [np.pad(p[2], ((0, 0), (0, width - p[2].shape[1]))) for p in pieces]
    )
    offsets = np.cumsum([0, *(p[0].size for p in pieces)])
    bounds = np.array([crane.gravity, crane.rope_min or 0.0, crane.rope_max or 0.0])
    report = np.zeros(RopeFault.SIZE)
    status = backend.check_rope(
        timing, coefficients, offsets, bounds, np.zeros((RopeWork.SIZE, 4 * width - 5)), report,
    )
    if status != 0:
        time, worst, bound = report.tolist()
        raise InfeasibleError(
            text_apart(ROPE, status, (time, worst, bound), ("WORST", "BOUND")),
            limit=ROPE_LIMITS[status], value=worst, bound=bound, time=time,
        )
