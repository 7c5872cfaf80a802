"""Replanning by the C entry points, with the arguments and results of Python's."""

from __future__ import annotations

import ctypes
from dataclasses import replace

import numpy as np

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint
from segfmu.arrays import FloatArray
from segfmu.planning.pieces import Pieces
from segfmu.planning.problem import SHAPES, SYNCHRONIZATIONS
from tests.kernels.planner.c_planner import Asked, Planner, Pointer, Result


class Replanner:
    """The entry points."""

    def __init__(self, planner: Planner) -> None:
        self.planner = planner

    def replan(
        self, old: Trajectory, time: float, targets: tuple[Waypoint, ...], limits: Limits,
        synchronize: str,
    ) -> Trajectory:
        """`replan` in C."""
        # what is said of the first waypoint is not read
        asked = Asked(
            [Waypoint(np.zeros(old.axes)), *targets], limits, old.smoothness,
            shape=SHAPES.index(old.shape), synchronization=SYNCHRONIZATIONS.index(synchronize),
        )
        found = self.planner.replan(given(old, self.planner), time, asked)
        kept = shown(found, old, targets, limits, synchronize)
        # of a dwell that has begun, what is left
        dwell = float(np.max(kept.axis_durations - kept.axis_waypoint_times[-1]))
        last = replace(targets[-1], dwell=dwell if targets[-1].dwell > 0.0 else 0.0)
        return replace(kept, waypoints=(*kept.waypoints[:-1], last))

    def reach_velocity(self, old: Trajectory, velocity: FloatArray, time: float) -> Trajectory:
        """`reach_velocity` in C; its last waypoint is where it ends."""
        table = old.limits.table(old.axes, old.smoothness)
        found = self.planner.reach(
            given(old, self.planner), time, velocity, table, old.limits.lower(old.axes)
        )
        end = found(found.duration)
        return shown(found, old, (Waypoint(end, velocity),), old.limits, "waypoints")


def given(old: Trajectory, planner: Planner) -> Result:
    """A trajectory of Python as one of C, which refers to its numbers."""
    found = Result(planner.library, 0)
    # the arrays live as long as those that refer to them
    found.shown = old
    to = found.trajectory
    to.points, to.axes, to.smoothness = len(old.waypoints), old.axes, old.smoothness
    to.pieces, to.duration = len(old.timing), old.duration
    to.offsets = old.offsets.ctypes.data_as(ctypes.POINTER(ctypes.c_int64))
    for name, numbers in (
        ("timing", old.timing), ("coefficients", old.coefficients),
        ("times", old.axis_waypoint_times), ("ends", old.axis_durations),
    ):
        assert numbers.flags.c_contiguous
        setattr(to, name, numbers.ctypes.data_as(Pointer))
    return found


def shown(
    found: Result, old: Trajectory, targets: tuple[Waypoint, ...], limits: Limits, synchronize: str
) -> Trajectory:
    """A trajectory of C as one of Python, which has its own numbers."""
    if found.status != 0:
        raise InfeasibleError(f"status {found.status} in C")
    to, n, rows = found.trajectory, old.smoothness, np.ctypeslib.as_array
    pieces = Pieces(
        rows(to.timing, (to.pieces, 2)).copy(), rows(to.coefficients, (to.pieces, 2 * n)).copy(),
        rows(to.offsets, (old.axes + 1,)).copy(),
    )
    return Trajectory(
        (Waypoint(*pieces.starts().T), *targets), limits, n, old.shape, synchronize,
        old.axis_names, pieces.timing, pieces.coefficients, pieces.offsets,
        rows(to.times, (to.points, old.axes)).copy(), rows(to.ends, (old.axes,)).copy(),
    )
