"""GantryFeedforward on PythonFMU: plans at the end of initialisation, then evaluates."""

from __future__ import annotations

from math import inf
from typing import Any

import numpy as np

from segfmu.crane import Crane, FlatInverse, Friction
from segfmu.crane.equipment import FRICTION
from segfmu.crane.inverse import DRIVE_ACCELERATION, FORCE, ORDERS, VELOCITY
from segfmu.crane.variables import build
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.python.slave import SpecSlave
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Compensation, Feedforward, LoadMotion
from segfmu.kernels.planner.records import LoadLimits, LowerLimits, PlanOptions
from segfmu.planning import Limits, Trajectory, Waypoint, plan

AXES = ("x", "y", "z")
# that of the sway is no matter of the drives
KNOWN = {name: fed for name, fed in FRICTION.items() if name != "sway"}


class FeedforwardSlave(SpecSlave):
    """The slave; its outputs depend only on time and parameters."""

    spec = gantry_feedforward.spec()

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._inverse: FlatInverse | None = None
        self._trajectory: Trajectory | None = None
        self._initialising = self._planned = False

    def enter_initialization_mode(self) -> None:
        self._initialising = True

    def initialise(self) -> None:
        """Plan and invert; from here on the outputs are ahead by the lead."""
        self._plan()
        self._initialising = False
        self._evaluate(self.start_time)

    def advance(self, time: float, step: float) -> None:
        """Evaluate at the end of the step."""
        self._evaluate(time + step)

    def _get(self, kind: str, references: list[int]) -> list[Any]:
        """Plan if the importer asks for outputs in initialisation mode."""
        asked = (self.spec.variables[r - 1] for r in references if 0 < r <= self._size)
        causalities = {v.causality for v in asked}
        if self._initialising and not causalities.isdisjoint({"output", "calculatedParameter"}):
            self.compute(self._plan)
        return super()._get(kind, references)

    def _set(self, kind: str, references: list[int], values: list[Any]) -> None:
        self._planned = False
        super()._set(kind, references, values)

    @property
    def _size(self) -> int:
        return len(self.spec.variables)

    def _plan(self) -> None:
        """Plan, unless nothing was set since the last time."""
        if self._planned:
            return
        options = self.filled(PlanOptions)
        trajectory = plan(
            self._waypoints(),
            self._limits(),
            smoothness=int(options[PlanOptions.SMOOTHNESS]),
            shape=gantry_feedforward.SHAPES.items[int(options[PlanOptions.SHAPE])],
            synchronize=gantry_feedforward.SYNCHRONIZATIONS.items[
                int(options[PlanOptions.SYNCHRONIZATION])
            ],
            sample_time=float(options[PlanOptions.SAMPLE_TIME]) or None,
            duration=float(options[PlanOptions.DURATION]) or None,
            axis_names=AXES,
        )
        friction = build(Friction, KNOWN, self.value)
        self._inverse = FlatInverse(Crane.of(self.value), trajectory, friction)
        self._trajectory = trajectory
        self.assign(("plan.duration",), (trajectory.duration,))
        self._evaluate(self.start_time)
        self._planned = True

    def _limits(self) -> Limits:
        velocity, acceleration, *others = self.filled(LoadLimits).reshape(len(AXES), -1).T
        least = self.filled(LowerLimits).reshape(len(AXES), -1).T
        velocity_min, acceleration_min = np.where(least < 0.0, least, [-velocity, -acceleration])
        return Limits(
            velocity, acceleration, *(np.where(c > 0.0, c, inf) for c in others),
            velocity_min=velocity_min, acceleration_min=acceleration_min,
        )

    def _waypoints(self) -> list[Waypoint]:
        count = int(self.value("waypoint.count"))
        columns = [
            np.array([float(self.value(n)) for n in array.members[: count * array.columns]])
            for array in gantry_feedforward.arrays(count)
        ]
        rows = (c.reshape(count, -1).tolist() for c in columns)
        return [Waypoint(p, v, a, dwell=dwell) for p, v, a, (dwell,) in zip(*rows, strict=True)]

    def _evaluate(self, time: float) -> None:
        inverse, trajectory = self._inverse, self._trajectory
        if inverse is None or trajectory is None:
            raise AssertionError("a step before the end of initialisation")
        lead = 0.0 if self._initialising else float(self.value("setpoint.lead"))
        known = self.filled(Compensation)
        lags = known[Compensation.LAG : Compensation.DEAD_TIME]
        dead = known[Compensation.DEAD_TIME :].tolist()
        given = float(self.value("planner.start_time"))
        start = backend.begin_time(given, self.start_time) - lead + max(dead)
        t = time - start
        found = {d: inverse.evaluate(t + d) for d in {0.0, *dead}}
        values, early = found[0.0].copy(), [found[d] for d in dead]
        values[FORCE] = [v[FORCE][i] for i, v in enumerate(early)]
        setpoints = [
            v[VELOCITY][i] + lags[i] * v[DRIVE_ACCELERATION][i] for i, v in enumerate(early)
        ]
        self.show(Feedforward, np.concatenate([values, setpoints]))
        self.show(LoadMotion, np.concatenate([trajectory(t, order) for order in range(ORDERS)]))
        self.assign(
            ("plan.interval", "plan.done"), (trajectory.interval(t), t >= trajectory.duration)
        )
        events = [trajectory.next_event(t + d) - d for d in (0.0, *dead)]
        events += [inverse.contacts.next_event(t + d, i) - d for i, d in enumerate(dead)]
        self.assign(("plan.next_event",), (start + min(*events, trajectory.duration),))
