"""GantryFeedforward on PythonFMU: plans at the end of initialisation, then evaluates."""

from __future__ import annotations

from typing import Any

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane import Crane, FlatInverse, Friction
from segfmu.crane.demand import peaks
from segfmu.crane.drive_task import Task
from segfmu.crane.equipment import FRICTION
from segfmu.crane.flat_models import model_of
from segfmu.crane.inverse import (
    ACCELERATION,
    DRIVE_ACCELERATION,
    FORCE,
    ORDERS,
    POSITION,
    STATE,
    VELOCITY,
)
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.limit_search import FULL, LimitSearch
from segfmu.crane.variables import build
from segfmu.errors import InfeasibleError, InputError, SegfmuError
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.gantry_feedforward.commands import Commands
from segfmu.fmu.gantry_feedforward.given import AXES, Given
from segfmu.fmu.python.slave import SpecSlave
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import (
    Box,
    ObstacleRow,
    Ranges,
    Space,
    SpaceFault,
    SpaceLimits,
    SpaceStatus,
    Span,
    Stack,
)
from segfmu.kernels.crane.records import (
    Axes,
    BoundFault,
    BoundStatus,
    BoundUses,
    Compensation,
    Demand,
    DriveBounds,
    Feedforward,
    LoadMotion,
    RopeWork,
)
from segfmu.kernels.limits.records import LimitRow, Pace, PlanLimits
from segfmu.kernels.messages import BOUND, SETUP, SPACE
from segfmu.kernels.records import Record
from segfmu.kernels.rig.records import SetupFault, SetupStatus
from segfmu.planning import Limits, Trajectory, plan

# that of the sway is no matter of the drives
KNOWN = {name: fed for name, fed in FRICTION.items() if name != "sway"}


class _Path:
    """What the parameters say of workspace and obstacles."""

    def __init__(self, slave: FeedforwardSlave) -> None:
        self.require = lambda trajectory, _: slave.require_space(trajectory)


class FeedforwardSlave(SpecSlave):
    """The slave; its outputs depend only on time and parameters.

    One of another model has its own interface, results and crane.
    """

    spec = gantry_feedforward.spec()
    results: type[Record] = Feedforward

    def crane(self) -> AnyCrane:
        """The crane that the parameters describe."""
        return Crane.of(self.value)

    def require_taut(self, crane: AnyCrane, trajectory: Trajectory) -> None:
        """Refuse a plan along which what pulls goes slack or leaves its range."""
        model_of(crane).require_taut(crane, trajectory)

    @property
    def takes_commands(self) -> bool:
        """Whether commands can be followed."""
        return bool(self.value("command.enabled"))

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self._given = Given(self.value)
        self._inverse: FlatInverse | None = None
        self._trajectory: Trajectory | None = None
        self._commands: Commands | None = None
        self._initialising = self._planned = False

    def enter_initialization_mode(self) -> None:
        self._initialising = True

    def initialise(self) -> None:
        """Plan and invert; from here on the outputs are ahead by the lead."""
        self._plan()
        self._initialising = False
        self._evaluate(self.start_time)

    def advance(self, time: float, step: float) -> None:
        """Follow the command, and evaluate at the end of the step."""
        if self._commands is not None:
            self._commands.follow(time + self._ahead, step)
        self._foresee(time + step)
        self._evaluate(time + step)

    def _foresee(self, time: float) -> None:
        """Tell what an emergency stop would come to."""
        if self._commands is not None:
            found = self._commands.foresee(time + self._ahead)
            self.assign(("plan.emergency.duration", "plan.emergency.sway"), found)

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
        crane, friction = self.crane(), build(Friction, KNOWN, self.value)
        self._require_travel()
        self.assign(("plan.pace",), (1.0,))
        if self.value("planner.finds_limits"):
            trajectory = self._as_found(crane, friction)
        else:
            trajectory = self._as_given(crane, friction)
        self._inverse, self._trajectory = FlatInverse(crane, trajectory, friction), trajectory
        self._show_limits(trajectory.limits)
        self._commands = None
        if self.takes_commands:
            self._commands = Commands(self.value, trajectory, self._begin)
        self.assign(("plan.duration",), (trajectory.duration,))
        self._foresee(self.start_time)
        self._evaluate(self.start_time)
        self._planned = True

    def _as_given(self, crane: AnyCrane, friction: Friction) -> Trajectory:
        """The plan with the given limits, slower if it may be."""
        slows = self.value("planner.slows_down") and not self.value("planner.finds_limits")
        pace = np.zeros(Pace.SIZE)
        backend.begin_pace(1.0, FULL, pace)
        while True:
            trajectory = self._planned_at(float(pace[Pace.PACE]))
            self.require_taut(crane, trajectory)
            self.require_space(trajectory)
            status, uses, fault = self._uses(crane, trajectory, friction)
            if not slows or not backend.next_pace(backend.paced_use(uses), pace):
                break
        self.show(Pace, pace)
        self._keep(status, uses, fault)
        return trajectory

    def _as_found(self, crane: AnyCrane, friction: Friction) -> Trajectory:
        """The plan with limits that are found where those given do not keep the bounds."""
        refusal: SegfmuError | None = None
        if self._given.has_limits:
            try:
                return self._as_given(crane, friction)
            except SegfmuError as error:
                refusal = error
        options = self._given.options()
        points = self._given.waypoints(1.0)
        timing = {name: options.pop(name) for name in ("sample_time", "duration")}
        caps = np.hstack([self._given.table(), self._given.least()])
        task = Task(
            crane, points, self.filled(DriveBounds), caps, {}, options, _Path(self), friction,
            self._lags,
        )
        try:
            found = self._search(task, timing)
        except SegfmuError as error:
            raise refusal or error from None
        self._keep(*self._uses(crane, found, friction))
        return found

    def _search(self, task: Task, timing: dict[str, Any]) -> Trajectory:
        search = LimitSearch(task)
        found = search.run(timing)
        if found is not None:
            return found.trajectory
        reason = search.reason()
        if reason is None and search.closest is not None:
            # what it exceeds is told
            return search.closest.trajectory
        raise reason or AssertionError("a search without a plan and without a refusal")

    def _keep(self, status: int, uses: FloatArray, fault: FloatArray) -> None:
        """Show what a plan uses of the bounds; refuse one that exceeds them."""
        if status != BoundStatus.KEPT:
            raise InfeasibleError(BOUND.text(status, fault))
        self.show(BoundUses, uses)

    def _planned_at(self, pace: float) -> Trajectory:
        """The plan at a pace."""
        return plan(self._given.waypoints(pace), self._given.limits(pace), **self._given.options())

    def _uses(
        self, crane: AnyCrane, trajectory: Trajectory, friction: Friction
    ) -> tuple[int, FloatArray, FloatArray]:
        """What a plan uses of the drives' bounds: BoundStatus, BoundUses and BoundFault."""
        bounds, uses = self.filled(DriveBounds), np.zeros(BoundUses.SIZE)
        found, times = np.zeros((2, 2, Demand.SIZE))
        if backend.has_bounds(0, Demand.SIZE, bounds):
            found, times = peaks(crane, trajectory, friction, self._lags)
        fault = np.zeros(BoundFault.SIZE)
        return backend.bound_uses(found, times, bounds, uses, fault), uses, fault

    def _require_travel(self) -> None:
        """Refuse an axis without room between its end stops."""
        bounds, fault = self.filled(DriveBounds), np.zeros(SetupFault.SIZE)
        least, greatest = (
            bounds[first : first + Axes.SIZE].copy()
            for first in (DriveBounds.TRAVEL_MIN, DriveBounds.TRAVEL_MAX)
        )
        status = backend.check_travel(least, greatest, fault)
        if status != SetupStatus.FITS:
            raise InputError(SETUP.text(status, fault))

    def require_space(self, trajectory: Trajectory) -> None:
        """Refuse a plan that leaves the workspace or meets an obstacle."""
        space, fault = self.filled(Space), np.zeros(SpaceFault.SIZE)
        obstacles = np.zeros((SpaceLimits.OBSTACLES, ObstacleRow.SIZE))
        for i, row in enumerate(obstacles, 1):
            ObstacleRow.fill(row, self.value, i)
        width = trajectory.coefficients.shape[1]
        status = backend.space_contact(
            trajectory.timing, trajectory.coefficients, trajectory.offsets, space, obstacles,
            np.zeros((SpaceLimits.FACES + len(obstacles), Box.SIZE)),
            np.zeros((RopeWork.SIZE, 4 * width - 5)),
            np.zeros((Stack.ROWS, Span.SIZE, 2 * width - 3)), np.zeros((Ranges.SIZE, len(AXES))),
            True, fault,
        )
        if status != SpaceStatus.CLEAR:
            raise InfeasibleError(SPACE.text(status, fault))

    def _show_limits(self, limits: Limits) -> None:
        table = limits.table(len(AXES), LimitRow.VELOCITY_MIN)[:, : LimitRow.VELOCITY_MIN]
        self.show(PlanLimits, np.hstack([table, -limits.lower(len(AXES))]).ravel())

    @property
    def _begin(self) -> float:
        """Time at which the plan begins, without lead and dead times [s]."""
        given = float(self.value("planner.start_time"))
        return float(backend.begin_time(given, self.start_time))

    @property
    def _lags(self) -> FloatArray:
        """Of the velocity loops [s], shape (3,)."""
        return self.filled(Compensation)[Compensation.LAG : Compensation.DEAD_TIME]

    @property
    def _ahead(self) -> float:
        """By how much the reference is ahead of the simulation's clock [s]."""
        lead = 0.0 if self._initialising else float(self.value("setpoint.lead"))
        return lead - float(self.filled(Compensation)[Compensation.DEAD_TIME :].max())

    def _evaluate(self, time: float) -> None:
        inverse, trajectory = self._inverse, self._trajectory
        if inverse is None or trajectory is None:
            raise AssertionError("a step before the end of initialisation")
        if self._commands is not None and self._commands.acts:
            self._show_commanded(time, self._commands, inverse)
            return
        known, lags = self.filled(Compensation), self._lags
        dead = known[Compensation.DEAD_TIME :].tolist()
        start = self._begin - self._ahead
        t = time - start
        found = {d: inverse.evaluate(t + d) for d in {0.0, *dead}}
        values, early = found[0.0].copy(), [found[d] for d in dead]
        columns = inverse.model.columns
        values[columns.force] = [v[columns.force][i] for i, v in enumerate(early)]
        setpoints = [
            v[columns.velocity][i] + lags[i] * v[columns.drive_acceleration][i]
            for i, v in enumerate(early)
        ]
        self.show(self.results, np.concatenate([values, setpoints]))
        self.show(LoadMotion, np.concatenate([trajectory(t, order) for order in range(ORDERS)]))
        self.assign(
            ("plan.interval", "plan.done"), (trajectory.interval(t), t >= trajectory.duration)
        )
        events = [trajectory.next_event(t + d) - d for d in (0.0, *dead)]
        events += [inverse.contacts.next_event(t + d, i) - d for i, d in enumerate(dead)]
        self.assign(("plan.next_event",), (start + min(*events, trajectory.duration),))

    def _show_commanded(self, time: float, commands: Commands, inverse: FlatInverse) -> None:
        """Evaluate the plan of the last command."""
        motion, masses = commands.motion, inverse.crane.masses
        load, values = motion.motion(time + self._ahead, ORDERS), np.zeros(Feedforward.VELOCITY)
        backend.crane_flat_inverse(
            load, np.array(masses), values[FORCE], values[STATE], values[ACCELERATION]
        )
        start = motion.begins - self._ahead
        for axis, (x, v) in enumerate(zip(values[POSITION], values[VELOCITY], strict=True)):
            values[axis] += inverse.contacts.friction(axis, time - start, x, v)
        setpoints = values[VELOCITY] + self._lags * values[DRIVE_ACCELERATION]
        self.show(Feedforward, np.concatenate([values, setpoints]))
        self.show(LoadMotion, load.ravel())
        end = commands.stops - self._ahead
        following = commands.next_event(time, start)
        self.assign(
            ("plan.interval", "plan.done", "plan.next_event", "plan.status", "plan.refused"),
            (1, end <= time + backend.same_break(time), min(following, end), motion.status,
             motion.refused),
        )
