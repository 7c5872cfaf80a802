"""The planning problem as arrays, and its phases from the kernels."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Interval,
    PlanStatus,
    PlanWork,
    Shape,
    Synchronization,
)
from segfmu.kernels.trajectory.records import Expansion, Timing

SHAPES = tuple(name.lower() for name in Shape.items())
SYNCHRONIZATIONS = tuple(name.lower() for name in Synchronization.items())


@dataclass(frozen=True)
class Options:
    """Options of the planner; sample_time and duration [s] are 0 if not requested."""

    smoothness: int
    shape: str
    synchronize: str
    sample_time: float
    duration: float

    @cached_property
    def vector(self) -> FloatArray:
        """As the kernels take them (PlanOptions)."""
        vector = np.array([
            self.smoothness, SHAPES.index(self.shape), SYNCHRONIZATIONS.index(self.synchronize),
            self.sample_time, self.duration,
        ])
        vector.flags.writeable = False
        return vector


@lru_cache(maxsize=64)
def options(
    smoothness: int, shape: str, synchronize: str, sample_time: float, duration: float
) -> Options:
    """The options of these values; usual ones are made once."""
    return Options(smoothness, shape, synchronize, sample_time, duration)


class Problem(NamedTuple):
    """What to plan.

    Attributes
    ----------
    states : ndarray, shape (waypoints, axes, 3)
        Position, velocity and acceleration [m, m/s, m/s2] (WaypointState); NaN where free.
    dwells : ndarray, shape (waypoints,)
        Times to stay [s].
    limits : ndarray, shape (axes, smoothness + 1)
        As from `Limits.table`.
    lower : ndarray, shape (axes, 2)
        As from `Limits.lower`.
    options : Options
    """

    states: FloatArray
    dwells: FloatArray
    limits: FloatArray
    lower: FloatArray
    options: Options


@dataclass(frozen=True, eq=False)
class Phases:
    """Results of the kernel `plan_phases` (kernels/planner/records.py).

    Attributes
    ----------
    status : int
        Of PlanStatus; below 0 there is no plan.
    axes : ndarray, shape (axes, Axis)
    cells : ndarray, shape (intervals * axes, Cell rows, Cell columns)
    work : ndarray, shape (PlanWork rows, PlanWork columns)
    """

    status: int
    axes: FloatArray
    cells: FloatArray
    work: FloatArray

    @property
    def feasible(self) -> bool:
        """Whether there is a plan."""
        return self.status == PlanStatus.PLANNED

    @property
    def refusal(self) -> FloatArray:
        """Where and why there is no plan (Refusal)."""
        row: FloatArray = self.work[PlanWork.REFUSAL]
        return row

    @property
    def durations(self) -> FloatArray:
        """Duration of every interval of every axis [s], shape (intervals, axes)."""
        return self.cells[:, Cell.RESULT, Interval.DURATION].reshape(-1, len(self.axes))


def plan_phases(problem: Problem) -> Phases:
    """Plan the phases of all axes in all intervals; all states are numbers."""
    points, axes = problem.states.shape[:2]
    table = np.zeros((axes, Axis.SIZE))
    cells = np.zeros(((points - 1) * axes, Cell.SIZE, Cell.COLUMNS))
    work = np.zeros((PlanWork.SIZE, PlanWork.COLUMNS))
    status = backend.plan_phases(
        problem.states, problem.dwells, problem.limits, problem.lower, problem.options.vector,
        table, cells, work,
    )
    return Phases(status, table, cells, work)


def expand_phases(
    problem: Problem, phases: Phases
) -> tuple[FloatArray, FloatArray, NDArray[np.int64], FloatArray]:
    """The polynomial pieces of planned phases, with rows that are not used behind them.

    Returns timing and coefficients of the pieces, the first piece of each axis, and the arrivals
    (waypoints, axes) with the ends of the motion as their last row [s].
    """
    points, axes = problem.states.shape[:2]
    rows = backend.count_pieces(phases.axes, phases.cells)
    timing = np.empty((rows, Timing.SIZE))
    coefficients = np.empty((rows, 2 * problem.options.smoothness))
    offsets = np.zeros(axes + 1, dtype=np.int64)
    times = np.zeros((points + 1, axes))
    backend.expand_plan(
        problem.states, problem.dwells, phases.axes, phases.cells, timing, coefficients, offsets,
        times, np.empty((Expansion.SIZE, Expansion.COLUMNS)),
    )
    return timing, coefficients, offsets, times
