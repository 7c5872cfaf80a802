"""The C entry points, compiled from the sources that ship and called with plain pointers."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from segfmu import Limits, Waypoint
from segfmu.codegen.native import TARGET
from tests.compiler import CC, STRICT

NAMES = ("replan.c", "velocity.c", "lead.c", "plan.c")
REPORT = 5
# doubles behind the work space that nothing may write, and what it has from earlier use
GUARD, USED = 16, 1e3
Pointer = ctypes.POINTER(ctypes.c_double)


class Problem(ctypes.Structure):
    """`segfmu_problem` of segfmu.h."""

    _fields_ = [
        *((name, ctypes.c_int64)
          for name in ("points", "axes", "smoothness", "shape", "synchronization")),
        *((name, ctypes.c_double) for name in ("sample_time", "duration")),
        *((name, ctypes.c_void_p)
          for name in ("positions", "velocities", "accelerations", "dwells", "limits", "lower")),
    ]


class Trajectory(ctypes.Structure):
    """`segfmu_trajectory` of segfmu.h."""

    _fields_ = [
        *((name, ctypes.c_int64) for name in ("points", "axes", "smoothness", "pieces")),
        ("duration", ctypes.c_double),
        *((name, Pointer) for name in ("timing", "coefficients")),
        ("offsets", ctypes.POINTER(ctypes.c_int64)),
        *((name, Pointer) for name in ("times", "ends", "outside")),
        ("report", ctypes.c_double * REPORT),
    ]


class Result:
    """What one call gives."""

    def __init__(self, library: ctypes.CDLL, size: int) -> None:
        self.status = 1
        self.trajectory = Trajectory()
        self.library = library
        self.shown: object = None
        self.space = np.full(size + GUARD, USED)

    def call(self, name: str, *arguments: Any) -> Result:
        """Call an entry point whose last arguments are work space and trajectory."""
        self.status = getattr(self.library, name)(
            *arguments, ctypes.c_void_p(self.space.ctypes.data), ctypes.byref(self.trajectory)
        )
        assert (self.space[-GUARD:] == USED).all()
        return self

    @property
    def report(self) -> list[float]:
        """Axis, interval, value, bound and side of a refusal."""
        return list(self.trajectory.report)

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return float(self.trajectory.duration)

    @property
    def ends(self) -> list[float]:
        """End of each axis [s]."""
        return list(self.trajectory.ends[: self.trajectory.axes])

    @property
    def arrivals(self) -> list[float]:
        """Arrival of each axis at the last waypoint [s]."""
        axes, points = self.trajectory.axes, self.trajectory.points
        return list(self.trajectory.times[(points - 1) * axes : points * axes])

    def __call__(self, t: float, derivative: int = 0) -> np.ndarray:
        """Values of a derivative of all axes."""
        values = np.empty(self.trajectory.axes)
        self.library.segfmu_value(
            ctypes.byref(self.trajectory), ctypes.c_double(t), ctypes.c_int64(derivative),
            ctypes.c_void_p(values.ctypes.data),
        )
        return values


class Asked:
    """A problem and its arrays; `changes` are fields of the structure, numbers or arrays."""

    def __init__(
        self, points: Sequence[Waypoint], limits: Limits, smoothness: int = 4, /, **changes: Any
    ) -> None:
        axes = points[0].axes
        fields = {
            "points": len(points), "axes": axes, "smoothness": smoothness, "shape": 1,
            "synchronization": 1, "sample_time": 0.0, "duration": 0.0,
            "positions": [p.position for p in points], "velocities": [p.velocity for p in points],
            "accelerations": [p.acceleration for p in points], "dwells": [p.dwell for p in points],
            "limits": limits.table(axes, smoothness), "lower": limits.lower(axes), **changes,
        }
        self.arrays = {
            name: np.array(fields[name], dtype=float)
            for name, kind in Problem._fields_ if kind is ctypes.c_void_p
        }
        self.problem = Problem(**fields | {n: a.ctypes.data for n, a in self.arrays.items()})


def compiled(target: Path, kernels: Path, *more: str | Path) -> Path:
    """Compile the entry points, with kernels as source or object, further sources and options."""
    sources = [TARGET / name for name in NAMES]
    subprocess.run(
        [CC, *STRICT, "-O1", f"-I{TARGET}", *more, *sources, kernels, "-lm", "-o", target],
        check=True,
    )
    return target


class Planner:
    """The entry points, compiled into a folder that does not have them yet."""

    def __init__(self, folder: Path, kernels: Path = TARGET / "kernels.c") -> None:
        path = folder / "planner.so"
        if not path.exists():
            compiled(path, kernels, "-fPIC", "-shared")
        self.library = ctypes.CDLL(str(path))
        for name in ("segfmu_plan_size", "segfmu_replan_size"):
            getattr(self.library, name).restype = ctypes.c_size_t

    def plan(self, asked: Asked) -> Result:
        """`segfmu_plan`."""
        return Result(self.library, self._size("plan", asked.problem)).call(
            "segfmu_plan", ctypes.byref(asked.problem)
        )

    def replan(self, old: Result, time: float, asked: Asked) -> Result:
        """`segfmu_replan`."""
        size = self._size("replan", asked.problem, old.trajectory.pieces)
        return Result(self.library, size).call(
            "segfmu_replan", ctypes.byref(old.trajectory), ctypes.c_double(time),
            ctypes.byref(asked.problem),
        )

    def reach(
        self, old: Result, time: float, velocities: Any, limits: np.ndarray,
        lower: np.ndarray | None = None,
    ) -> Result:
        """`segfmu_reach_velocity`."""
        given = [np.array(a, dtype=float) for a in (velocities, limits)]
        given += [] if lower is None else [np.array(lower, dtype=float)]
        form = Trajectory(axes=old.trajectory.axes, smoothness=old.trajectory.smoothness, points=2)
        size = self._size("replan", form, old.trajectory.pieces)
        return Result(self.library, size).call(
            "segfmu_reach_velocity", ctypes.byref(old.trajectory), ctypes.c_double(time),
            *(ctypes.c_void_p(a.ctypes.data) for a in given),
            *([ctypes.c_void_p()] if lower is None else []),
        )

    def _size(self, name: str, form: Problem | Trajectory, *more: int) -> int:
        # sizes out of range are refused before the space is used
        sizes = (max(form.points, 2), max(form.axes, 1), min(max(form.smoothness, 2), 6), *more)
        found: int = getattr(self.library, f"segfmu_{name}_size")(*map(ctypes.c_int64, sizes))
        return found
