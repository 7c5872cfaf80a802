"""Limits of the load's motion with which a plan is short and keeps the bounds of the drives.

The drives' demands follow from the load's trajectory up to its snap. So the limits that matter are
those of velocity, acceleration, jerk and snap of each axis, at ramp times near the pendulum's
period as much as at the drives' own. kernels/limits has the search; here its trials are planned.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray, shown
from segfmu.crane.contacts import Contacts
from segfmu.crane.drive_task import Task
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Demand, DemandPeaks
from segfmu.kernels.limits.records import (
    LimitFault,
    LimitRow,
    LimitStatus,
    Pace,
    Search,
    SearchState,
    SearchValues,
    Starts,
    Values,
)
from segfmu.kernels.messages import LIMIT
from segfmu.planning.trajectory import Trajectory

# bounds used beyond this are exceeded: what is planned up to a bound uses it but for rounding
KEPT = 1.0 + 1e-9
# a bound used up to this is used in full
FULL = 1.0 - 1e-6
# the largest pace of a motion relative to that which samples suggest
FASTEST = 1e3
# about so many plans a search takes, for its progress
USUAL = 600


@dataclass(frozen=True, eq=False)
class Found:
    """A plan on the way.

    Attributes
    ----------
    trajectory : Trajectory
    uses : ndarray, shape (34,)
        Of the bounds by motion: what it takes of what they leave beyond weight and dry friction.
    """

    trajectory: Trajectory
    uses: FloatArray

    @property
    def use(self) -> float:
        """The largest one."""
        return float(self.uses.max())

    @property
    def kept(self) -> bool:
        """Whether the bounds hold."""
        return self.use <= KEPT


def look(task: Task, trajectory: Trajectory, *, exact: bool) -> Found:
    """What a plan uses of the bounds: at its exact peaks, or among samples."""
    contacts = Contacts(task.crane, task.friction, trajectory, task.lag)
    peaks, times = np.zeros((2, 2, Demand.SIZE))
    work = np.zeros((DemandPeaks.SIZE, DemandPeaks.COLUMNS))
    plan = (*contacts.pieces, contacts.resistance, contacts.rows, work)
    if exact:
        backend.demand_peaks(*plan, peaks, times)
    else:
        backend.demand_samples(*plan, peaks, times)
    uses = np.zeros(2 * Demand.SIZE)
    backend.write_shares(peaks, task.record, task.axes, uses)
    return Found(trajectory, uses)


class LimitSearch:
    """The search of a task, trial by trial.

    Attributes
    ----------
    closest : Found or None
        Of the last plans the one that uses the bounds least.
    refusal : InfeasibleError or None
        Why the last trial without a plan has none; see `reason`.
    """

    def __init__(self, task: Task) -> None:
        self.task = task
        self.closest: Found | None = None
        self.refusal: InfeasibleError | None = None
        self._trials = 0
        self._rows = np.zeros((Search.SIZE, task.kinds.size))

    def run(
        self, timing: dict[str, Any], progress: Callable[[float], None] = lambda _: None
    ) -> Found | None:
        """The shortest plan that keeps the bounds, by its exact peaks; None if there is none.

        timing: `sample_time` and `duration` as of `plan`.
        """
        if not callable(progress):
            raise InputError(f"progress must be a function, got {shown(progress)}")
        found, best = False, np.zeros(0)
        for task in _narrower(self.task):
            starts = _starts(task)
            if found:
                # so what is allowed in addition never makes the plan longer
                starts[0, : best.size] = best
                starts[0, best.size :] = 0.0
            found = self._searched(task, starts, progress)
            best = self._rows[Search.BEST].copy()
            if task.narrow:
                table = best.reshape(3, LimitRow.SIZE)
                table[:, LimitRow.VELOCITY_MIN :] = table[:, : LimitRow.JERK]
        progress(1.0)
        plan = self._paced(self.task, FASTEST) if found else None
        if plan is not None and any(timing.values()):
            self.closest = self.refusal = None
            # a little slower by then, so it usually keeps the bounds as well
            plan = self._paced(replace(self.task, options=self.task.options | timing), 1.0)
        return plan

    def reason(self) -> InfeasibleError | None:
        """Why no plan may be taken; None if some may, but do not keep the bounds."""
        if self.closest is None:
            return self.refusal
        try:
            self.task.require_taut(self.closest.trajectory)
            if self.closest.kept:
                self.task.require_path(self.closest.trajectory)
        except InfeasibleError as error:
            return error
        return None

    def _searched(
        self, task: Task, starts: FloatArray, progress: Callable[[float], None]
    ) -> bool:
        """Search from starts, by samples; whether there is a plan."""
        self.closest = self.refusal = None
        size = task.kinds.size
        self._rows = np.zeros((Search.SIZE, size))
        work = (
            np.zeros((SearchValues.SIZE, Values.SIZE)), np.zeros((size, Values.SIZE)),
            np.zeros((2 * size, size)),
        )
        backend.begin_limits(starts, task.kinds, self._rows)
        more = True
        while more:
            found = self._tried(task, exact=False)
            duration = -1.0 if found is None else found.trajectory.duration
            uses = np.zeros(2 * Demand.SIZE) if found is None else found.uses
            more = backend.next_limits(duration, uses, starts, self._rows, *work)
            self._trials += 1
            progress(1.0 - 0.5 ** (2.0 * self._trials / USUAL))
        return bool(self._rows[Search.STATE, SearchState.BEST] < 1e300)

    def _paced(self, task: Task, fastest: float) -> Found | None:
        """The plan found at the pace at which it just keeps the bounds, up to a pace.

        It is the base of the next pace.
        """
        pace, best = np.zeros(Pace.SIZE), None
        backend.cap_best(task.axes, self._rows)
        backend.begin_pace(fastest, FULL, pace)
        more = True
        while more:
            backend.write_best(float(pace[Pace.PACE]), self._rows)
            found = self._tried(task, exact=True)
            if found is not None and found.kept:
                best = found
            more = backend.next_pace(1e300 if found is None else found.use, pace)
        if best is not None:
            backend.keep_best(float(pace[Pace.KEEPS]), self._rows)
        return best

    def _tried(self, task: Task, *, exact: bool) -> Found | None:
        """The plan of the row TRIAL, None if there is none or its path may not be taken.

        Paths of plans that would not be kept are not judged.
        """
        try:
            trajectory = task.planned(self._rows[Search.TRIAL])
            found = look(task, trajectory, exact=exact)
            judged = exact or backend.is_judged(trajectory.duration, found.uses, self._rows)
            if judged:
                task.require_taut(trajectory)
        except InfeasibleError as error:
            self.refusal = error
            return None
        if self.closest is None or found.use < self.closest.use:
            self.closest = found
        # free states lead astray
        if judged and (found.kept or task.chooses) and not task.allows(trajectory):
            return None
        return found


def _narrower(task: Task) -> list[Task]:
    """The task with rest at free states and the smaller bounds, with its bounds, and as it is."""
    tasks = [task]
    if task.chooses:
        tasks.insert(0, replace(task, rests=True))
    if tasks[0].directed.any():
        tasks.insert(0, replace(tasks[0], narrow=True))
    return tasks


def _starts(task: Task) -> FloatArray:
    """Starts of the search, shape (16, unknowns).

    Raises
    ------
    InputError
        For an axis that moves although nothing bounds its acceleration, or hardly at all.
    """
    starts = np.zeros((Starts.COUNT, task.kinds.size))
    fault = np.zeros(LimitFault.SIZE)
    rope = float(-task.positions[:, 2].min())
    status = backend.write_starts(rope, task.record, task.resistance, task.axes, starts, fault)
    if status != LimitStatus.FOUND:
        raise InputError(LIMIT.text(status, fault))
    if task.chooses:
        for start in starts:
            backend.write_passing(task.places, task.kinds, task.axes, task.heading, start)
    return starts
