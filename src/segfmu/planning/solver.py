"""Waypoints as arrays through the kernels: durations alone, or the whole trajectory."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from segfmu.kernels import backend
from segfmu.planning.arrays import FloatArray
from segfmu.planning.limits import Limits
from segfmu.planning.messages import infeasible
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.verify import TOLERANCE, require
from segfmu.planning.waypoint import Waypoint

SHAPES = ("smoothstep", "plateau")
SYNCHRONIZATIONS = ("none", "waypoints", "total")


@dataclass(frozen=True)
class Options:
    """How to plan; sample_time and duration are 0 where not asked for."""

    smoothness: int
    shape: str
    synchronize: str
    sample_time: float
    duration: float

    @property
    def codes(self) -> tuple[int, int, int, float, float]:
        """As the kernels take them."""
        return (
            self.smoothness, SHAPES.index(self.shape), SYNCHRONIZATIONS.index(self.synchronize),
            self.sample_time, self.duration,
        )


@dataclass(frozen=True, eq=False)
class Phases:
    """What `plan_phases` writes; shapes as in kernels/planner/plan.py."""

    status: int
    report: FloatArray
    ramps: FloatArray
    phases: FloatArray
    counts: NDArray[np.int64]
    weights: FloatArray
    durations: FloatArray


def states(points: tuple[Waypoint, ...]) -> FloatArray:
    """Positions, velocities and accelerations of all waypoints, shape (3, waypoints, axes)."""
    table = np.array([(p.position, p.velocity, p.acceleration) for p in points])
    return np.ascontiguousarray(table.transpose(1, 0, 2))


def plan_phases(
    state: FloatArray, dwells: FloatArray, table: FloatArray, options: Options
) -> Phases:
    """Plan the phases through waypoints: state as from `states`, limits as `Limits.table`."""
    points, axes = state.shape[1:]
    intervals = points - 1
    cells = axes * intervals
    found = Phases(
        0, np.zeros(4), np.zeros((axes, 48)), np.empty((2 * cells, 13, 4)),
        np.zeros(2 * cells, dtype=np.int64), np.zeros(cells), np.zeros((intervals, axes)),
    )
    status = backend.plan_phases(
        state[0], state[1], state[2], dwells, table, *options.codes,
        found.ramps, found.phases, found.counts, found.weights, np.zeros((intervals, axes)),
        found.durations, np.zeros(intervals, dtype=np.int64),
        np.zeros((43, 4 + 2 * options.smoothness)), found.report,
    )
    object.__setattr__(found, "status", status)
    return found


def solve(
    points: tuple[Waypoint, ...], limits: Limits, options: Options, names: tuple[str, ...]
) -> Trajectory:
    """Plan, expand and judge a trajectory; all waypoint states are numbers.

    Raises
    ------
    InfeasibleError
        When the limits do not admit the plan.
    """
    state = states(points)
    table = limits.table(state.shape[2], options.smoothness)
    dwells = np.array([p.dwell for p in points])
    found = plan_phases(state, dwells, table, options)
    if found.status < 0:
        raise infeasible(found.status, found.report, points, table, names)
    arrays = _expand(state, dwells, options, found)
    for array in arrays:
        array.flags.writeable = False
    timing, coefficients, offsets, times, ends = arrays
    trajectory = Trajectory(
        points, limits, options.smoothness, options.shape, names,
        timing, coefficients, offsets, times, ends,
    )
    if backend.check_plan(
        state[0], state[1], state[2], times, timing, coefficients, offsets, ends, table,
        TOLERANCE, np.empty((43, 14)),
    ):
        require(trajectory)
    return trajectory


def _expand(
    state: FloatArray, dwells: FloatArray, options: Options, found: Phases
) -> tuple[FloatArray, FloatArray, NDArray[np.int64], FloatArray, FloatArray]:
    points, axes = state.shape[1:]
    rows = backend.count_pieces(found.counts, axes * (points - 1)) + axes * (points + 1)
    timing = np.empty((rows, 2))
    coefficients = np.empty((rows, 2 * options.smoothness))
    offsets = np.zeros(axes + 1, dtype=np.int64)
    times = np.zeros((points, axes))
    used = backend.expand_plan(
        state[0], state[1], dwells, *options.codes[:2], found.phases, found.counts,
        found.weights, found.durations, found.ramps, np.empty((200, 2)), np.empty((200, 16)),
        timing, coefficients, offsets, times,
    )
    return timing[:used], coefficients[:used], offsets, times, times[-1] + dwells[-1]


def total_duration(
    state: FloatArray, dwells: FloatArray, table: FloatArray, options: Options
) -> float:
    """Sum of all intervals' durations, over all axes unless they meet; infinite if infeasible."""
    found = plan_phases(state, dwells, table, options)
    if found.status < 0:
        return float("inf")
    meet = options.synchronize == "waypoints"
    return float(found.durations[:, 0].sum() if meet else found.durations.sum())

