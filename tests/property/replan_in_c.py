"""Replanning by the C entry points, with the arguments and results of Python's."""

from __future__ import annotations

import subprocess
from ctypes import CDLL, POINTER, Structure, byref, c_double, c_int64, c_size_t
from pathlib import Path

import numpy as np

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint
from segfmu.codegen.native import TARGET
from segfmu.planning.arrays import FloatArray
from segfmu.planning.lead import Pieces
from segfmu.planning.problem import SHAPES, SYNCHRONIZATIONS
from tests.compiler import CC

SOURCES = ("replan.c", "velocity.c", "lead.c", "plan.c", "kernels.c")
NUMBERS = POINTER(c_double)


class CProblem(Structure):
    """segfmu_problem."""

    _fields_ = (
        *((name, c_int64)
          for name in ("points", "axes", "smoothness", "shape", "synchronization")),
        ("sample_time", c_double), ("duration", c_double),
        *((name, NUMBERS)
          for name in ("positions", "velocities", "accelerations", "dwells", "limits")),
    )


class CTrajectory(Structure):
    """segfmu_trajectory."""

    _fields_ = (
        *((name, c_int64) for name in ("points", "axes", "smoothness", "pieces")),
        ("duration", c_double), ("timing", NUMBERS), ("coefficients", NUMBERS),
        ("offsets", POINTER(c_int64)), ("times", NUMBERS), ("ends", NUMBERS),
        ("report", c_double * 4),
    )


class Replanner:
    """The C library, compiled into a folder; numbers that it refers to are kept in `arrays`."""

    def __init__(self, folder: Path) -> None:
        path = folder / "replan.so"
        flags = ["-std=c99", "-O1", "-ffp-contract=off", "-shared", "-fPIC", f"-I{TARGET}"]
        sources = [TARGET / name for name in SOURCES]
        subprocess.run([CC, *flags, *sources, "-lm", "-o", path], check=True)
        self.library = CDLL(str(path))
        self.library.segfmu_replan_size.restype = c_size_t
        self.arrays: list[np.ndarray] = []

    def replan(
        self, old: Trajectory, time: float, targets: tuple[Waypoint, ...], limits: Limits,
        synchronize: str,
    ) -> Trajectory:
        """`replan` in C."""
        # what is said of the first waypoint is not read
        points = (Waypoint(np.zeros(old.axes)), *targets)
        states = np.stack([point.state(2) for point in points]).transpose(2, 0, 1)
        problem = CProblem(
            len(points), old.axes, old.smoothness, SHAPES.index(old.shape),
            SYNCHRONIZATIONS.index(synchronize), 0.0, 0.0, *map(self._given, states),
            self._given(np.array([point.dwell for point in points])),
            self._given(limits.table(old.axes, old.smoothness)),
        )
        call = self.library.segfmu_replan, byref(problem)
        return self._called(call, old, time, targets, limits, synchronize)

    def reach_velocity(self, old: Trajectory, velocity: FloatArray, time: float) -> Trajectory:
        """`reach_velocity` in C; its last waypoint is where it ends."""
        table = old.limits.table(old.axes, old.smoothness)
        call = self.library.segfmu_reach_velocity, self._given(velocity), self._given(table)
        return self._called(call, old, time, (), old.limits, "waypoints", velocity)

    def _called(
        self, call: tuple, old: Trajectory, time: float, targets: tuple[Waypoint, ...],
        limits: Limits, synchronize: str, velocity: FloatArray | None = None,
    ) -> Trajectory:
        function, *arguments = call
        n, pieces = old.smoothness, len(old.timing)
        given = CTrajectory(
            len(old.waypoints), old.axes, n, pieces, old.duration, self._given(old.timing),
            self._given(old.coefficients), old.offsets.ctypes.data_as(POINTER(c_int64)),
            self._given(old.axis_waypoint_times), self._given(old.axis_durations),
        )
        sizes = (max(len(targets) + 1, 2), old.axes, n, pieces)
        space = np.zeros(self.library.segfmu_replan_size(*map(c_int64, sizes)))
        found = CTrajectory()
        status = function(
            byref(given), c_double(time), *arguments, space.ctypes.data_as(NUMBERS), byref(found)
        )
        self.arrays.clear()
        if status != 0:
            raise InfeasibleError(f"status {status} in C")
        rows = np.ctypeslib.as_array
        timing = rows(found.timing, (found.pieces, 2)).copy()
        coefficients = rows(found.coefficients, (found.pieces, 2 * n)).copy()
        offsets = rows(found.offsets, (old.axes + 1,)).copy()
        times = rows(found.times, (found.points, old.axes)).copy()
        ends = rows(found.ends, (old.axes,)).copy()
        first = Waypoint(*Pieces(timing, coefficients, offsets).starts().T)
        if velocity is not None:
            last = Pieces(timing, coefficients, offsets).all_ends()
            targets = (Waypoint(last[:, 0], velocity),)
        return Trajectory(
            (first, *targets), limits, n, old.shape, synchronize, old.axis_names, timing,
            coefficients, offsets, times, ends,
        )

    def _given(self, values: FloatArray) -> object:
        self.arrays.append(np.ascontiguousarray(values, dtype=np.float64))
        return self.arrays[-1].ctypes.data_as(NUMBERS)
