"""GantryFeedforward on PythonFMU: plans at the end of initialisation, then evaluates."""

from __future__ import annotations

from math import inf
from typing import Any

from segfmu.crane import Crane, FlatInverse
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.python.slave import SpecSlave
from segfmu.planning import Limits, Trajectory, Waypoint, plan

AXES = ("x", "y", "z")
DERIVATIVES = ("position", "velocity", "acceleration", "jerk", "snap")

FORCE = tuple(f"force.{d}" for d in ("bridge", "trolley", "hoist"))
VELOCITY = tuple(f"velocity.{d}" for d in ("bridge", "trolley", "hoist"))
STATE = (
    "reference.bridge.position", "reference.trolley.position", "reference.rope.length",
    "reference.sway.x.angle", "reference.sway.y.angle",
    "reference.bridge.velocity", "reference.trolley.velocity", "reference.rope.velocity",
    "reference.sway.x.rate", "reference.sway.y.rate",
)
ACCELERATION = tuple(f"reference.{p}.acceleration" for p in ("bridge", "trolley", "rope"))
LOAD = tuple(tuple(f"reference.load.{d}.{a}" for a in AXES) for d in DERIVATIVES)


class FeedforwardSlave(SpecSlave):
    """The slave; its outputs are functions of time and parameters alone."""

    spec = gantry_feedforward.spec()

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._inverse: FlatInverse | None = None
        self._trajectory: Trajectory | None = None
        self._initialising = False

    def enter_initialization_mode(self) -> None:
        self._initialising = True

    def initialise(self) -> None:
        """Plan and invert; the outputs take their values at the start time."""
        self._plan()
        self._initialising = False

    def advance(self, time: float, step: float) -> None:
        """Evaluate at the end of the step."""
        self._evaluate(time + step)

    def _get(self, kind: str, references: list[int]) -> list[Any]:
        """In initialisation mode an importer may ask for outputs: plan when it does."""
        asked = (self.spec.variables[r - 1] for r in references if 0 < r <= self._size)
        causalities = {v.causality for v in asked}
        if self._initialising and not causalities.isdisjoint({"output", "calculatedParameter"}):
            self._plan()
        return super()._get(kind, references)

    @property
    def _size(self) -> int:
        return len(self.spec.variables)

    def _plan(self) -> None:
        count = int(self.value("waypoint.count"))
        names = gantry_feedforward.SHAPES.items, gantry_feedforward.SYNCHRONIZATIONS.items
        trajectory = plan(
            [self._waypoint(i) for i in range(1, count + 1)],
            self._limits(),
            smoothness=int(self.value("planner.smoothness")),
            shape=names[0][int(self.value("planner.shape")) - 1],
            synchronize=names[1][int(self.value("planner.synchronization")) - 1],
            sample_time=float(self.value("planner.sample_time")) or None,
            duration=float(self.value("planner.duration")) or None,
            axis_names=AXES,
        )
        self._inverse = FlatInverse(Crane.of(self.value), trajectory)
        self._trajectory = trajectory
        self.assign(("plan.duration",), (trajectory.duration,))
        self._evaluate(self.start_time)

    def _limits(self) -> Limits:
        velocity, acceleration = (self._vector(f"limits.{{}}.{d}") for d in DERIVATIVES[1:3])
        jerk, snap = (
            [v or inf for v in self._vector(f"limits.{{}}.{d}")] for d in DERIVATIVES[3:]
        )
        return Limits(velocity, acceleration, jerk, snap)

    def _waypoint(self, i: int) -> Waypoint:
        position, velocity, acceleration = (
            self._vector(f"waypoint[{i}].{d}.{{}}") for d in DERIVATIVES[:3]
        )
        dwell = float(self.value(f"waypoint[{i}].dwell"))
        return Waypoint(position, velocity, acceleration, dwell)

    def _vector(self, pattern: str) -> list[float]:
        return [float(self.value(pattern.format(a))) for a in AXES]

    def _evaluate(self, time: float) -> None:
        inverse, trajectory = self._inverse, self._trajectory
        if inverse is None or trajectory is None:
            raise AssertionError("a step before the end of initialisation")
        start = float(self.value("planner.start_time"))
        t = time - start
        values = inverse.evaluate(t)
        self.assign(FORCE, values[:3])
        self.assign(STATE, values[3:13])
        self.assign(VELOCITY, values[8:11])
        self.assign(ACCELERATION, values[13:16])
        for order, names in enumerate(LOAD):
            self.assign(names, trajectory(t, order))
        self.assign(
            ("plan.interval", "plan.done"), (trajectory.interval(t), t >= trajectory.duration)
        )
        upcoming = min(trajectory.next_event(t), trajectory.duration)
        self.assign(("plan.next_event",), (start + upcoming,))
