"""Limits of the load's motion with which a plan is short and keeps the bounds of the drives.

The drives' demands follow from the load's trajectory up to its snap. So the limits that matter are
those of velocity, acceleration, jerk and snap of each axis, at ramp times near the pendulum's
period as much as at the drives' own. Scaling the i-th limit by lambda^i scales time by 1 / lambda
(section 3.2); so every choice of limits has one scale at which it just keeps the bounds, and the
duration there is what the search minimises.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from segfmu.crane.demand import peaks, rough_peaks
from segfmu.crane.drive_task import DIRECTED, SEARCHED, Task
from segfmu.crane.equipment import Friction
from segfmu.crane.evolution import EQUAL, Evolution, precedes, ranked
from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError, InputError
from segfmu.planning.arrays import FloatArray, shown
from segfmu.planning.trajectory import Trajectory

ORDERS = np.array([1, 2, 3, 4, 1, 2])
# of the logarithms of limits: first standard deviation, and farthest from the start
STEP = 0.35
REACH = 5.0
# moves of free states in units of the limit, relative to those of the limits' logarithms
STATE_SHARE = 0.15
# bounds used beyond this are exceeded: what is planned up to a bound uses it but for rounding
KEPT = 1.0 + 1e-9
# slower than this a plan does not keep the bounds either, and limits would vanish
SLOWEST = 1e-6
# paces without a plan, after which limits are given up
FAILURES = 3
# the search ends when so many generations gain less than this share
PATIENCE = 20
GAIN = 5e-4


@dataclass(frozen=True, eq=False)
class Found:
    """A plan on the way.

    Attributes
    ----------
    task : Task
        With the states of its waypoints.
    table : ndarray, shape (3, 6)
        Its limits, see `Task.limits`.
    trajectory : Trajectory
    use : float
        Largest share of a bound, of what it leaves beyond the demand at rest.
    """

    task: Task
    table: FloatArray
    trajectory: Trajectory
    use: float

    @property
    def duration(self) -> float:
        """Duration of the plan [s]."""
        return self.trajectory.duration

    @property
    def allowed(self) -> bool:
        """Whether its path may be taken."""
        return self.task.allows(self.trajectory)

    @property
    def kept(self) -> bool:
        """Whether the bounds hold."""
        return self.use <= KEPT

    @property
    def rank(self) -> tuple[bool, float]:
        """Plans that keep the bounds first, the shortest first; else by their use."""
        return (not self.kept, self.duration if self.kept else self.use)


@dataclass(frozen=True)
class Look:
    """How closely plans are looked at.

    Attributes
    ----------
    peaks : callable
        Greatest magnitudes of all demands in both directions for crane, trajectory and friction,
        shape (2, 14).
    full : float
        A plan with a bound used up to this is fast enough.
    trials : int
        Paces tried.
    """

    peaks: Callable[[Crane, Trajectory, Friction], FloatArray]
    full: float
    trials: int


ROUGH = Look(rough_peaks, 0.98, 6)
EXACT = Look(lambda *motion: peaks(*motion)[0], 1.0 - 1e-6, 40)


def paced(task: Task, table: FloatArray, pace: float) -> FloatArray:
    """A table whose motion is faster by a factor, within caps and floors."""
    scaled = table * pace**ORDERS
    return np.asarray(np.minimum(np.maximum(scaled, task.floors), task.caps))


def attempt(task: Task, table: FloatArray, pace: float, look: Look) -> Found | None:
    """The plan at a pace, None if there is none."""
    moved = task.paced(pace)
    chosen = paced(moved, table, pace)
    try:
        trajectory = moved.plan(chosen)
    except InfeasibleError:
        return None
    found = look.peaks(task.crane, trajectory, task.friction)
    use = float(((found - task.rest) / task.room).max())
    return Found(moved, chosen, trajectory, use)


def just_kept(task: Task, table: FloatArray, look: Look) -> Found | None:
    """The fastest pace at which a table keeps the bounds; if none does, what comes closest."""
    best: Found | None = None
    # paces known to be too slow for the given states or to keep the bounds, and to be too fast
    slow, fast, pace, growth = 0.0, np.inf, 1.0, 2.0
    last: tuple[float, float] | None = None
    failures, unclear = 0, False
    for _ in range(look.trials):
        found = attempt(task, table, pace, look)
        gains = best is None or (found is not None and precedes(found.rank, best.rank))
        # the path is looked at where it may become the result: that takes longer than the plan
        if found is None or (gains and found.kept and not found.allowed):
            failures, unclear = failures + 1, found is not None
            if failures == FAILURES:
                break
            # a plan that lacks room for given states needs more pace, one that lifts the rope less
            slow, fast = (pace, fast) if last is not None and pace < last[0] else (slow, pace)
            pace = _between(slow, fast, pace)
            continue
        if last is not None and min(found.use, last[1]) > 0.0 and _differ(found.use, last[1]):
            rise = np.log(found.use / last[1]) / np.log(pace / last[0])
            growth = min(max(float(rise), 0.5), 4.0)
        last = (pace, found.use)
        if gains:
            best = found
        if found.kept:
            slow = max(slow, pace)
            capped = np.array_equal(found.table, paced(task, table, 2.0 * pace))
            if found.use >= look.full or (capped and not task.free.any()):
                break
        else:
            fast = min(fast, pace)
        aim = 0.5 * (look.full + 1.0)
        pace *= (aim / max(found.use, 1e-3)) ** (1.0 / growth)
        # a pace that was tried is one but for rounding
        if not slow * (1.0 + EQUAL) < pace < fast * (1.0 - EQUAL):
            pace = _between(slow, fast, last[0])
        if pace < SLOWEST:
            break
    # no matter how nearly others keep the bounds, if those that do have no clear path
    return None if unclear and best is not None and not best.kept else best


def _between(slow: float, fast: float, pace: float) -> float:
    """A pace between a slow and a fast one."""
    if not np.isfinite(fast):
        return 2.0 * pace
    return 0.5 * fast if slow == 0.0 else float((slow * fast) ** 0.5)


def shortest(
    starts: Sequence[tuple[Task, FloatArray]], calm: Sequence[tuple[Task, FloatArray]],
    generations: int, progress: Callable[[float], None],
) -> Found | None:
    """The shortest plan that a search from tasks with tables of limits finds; None: no plan.

    With free states the search begins at the best of `calm`, starts that are no extremes.
    """
    if not callable(progress):
        raise InputError(f"progress must be a function, got {shown(progress)}")
    tried = [found for found in (_best(starts), _best(calm)) if found is not None]
    if not tried:
        return None
    best, first = _first(tried), tried[-1]
    coordinates = _Coordinates(first)
    if coordinates.size == 0:
        return best
    evolution = Evolution(np.zeros(coordinates.size), STEP)
    history: list[float] = []

    def judged(place: FloatArray) -> tuple[bool, float] | None:
        nonlocal best
        found = just_kept(*coordinates.at(place), ROUGH)
        if found is None:
            return None
        if precedes(found.rank, best.rank):
            best = found
        return found.rank

    for generation in range(generations):
        evolution.advance(judged)
        progress((generation + 1) / generations)
        history.append(best.rank[1] if not best.rank[0] else np.inf)
        stale = len(history) > PATIENCE and history[-1] > (1.0 - GAIN) * history[-1 - PATIENCE]
        if evolution.settled or (stale and np.isfinite(history[-1 - PATIENCE])):
            break
    return best


def _best(starts: Sequence[tuple[Task, FloatArray]]) -> Found | None:
    tried = [found for found in (just_kept(*start, ROUGH) for start in starts) if found]
    return _first(tried) if tried else None


def _differ(one: float, other: float) -> bool:
    return abs(one - other) > EQUAL * max(one, other)


def _first(tried: Sequence[Found]) -> Found:
    return tried[ranked([found.rank for found in tried])[0]]


class _Coordinates:
    """What is searched: limits of moving axes as logarithms, and free states of waypoints."""

    def __init__(self, start: Found) -> None:
        self.start = start
        self.axes = start.task.moving
        self.free = np.argwhere(start.task.free)
        directed = np.argwhere(start.task.directed)
        self.back = directed[np.isin(directed[:, 0], self.axes)]
        self.size = SEARCHED * self.axes.size + len(self.back) + len(self.free)

    def at(self, place: FloatArray) -> tuple[Task, FloatArray]:
        """Task and table of a place, whose zero is the start."""
        task, table = self.start.task, self.start.table.copy()
        count = SEARCHED * self.axes.size
        last = count + len(self.back)
        factors = np.exp(np.clip(place[:last], -REACH, REACH))
        own = factors[:count].reshape(-1, SEARCHED)
        table[self.axes] *= np.hstack([own, own[:, :DIRECTED]])
        for (axis, order), factor in zip(self.back, factors[count:], strict=True):
            table[axis, SEARCHED + order] = factor * self.start.table[axis, SEARCHED + order]
        states = task.states
        for (point, order, axis), move in zip(self.free, place[last:], strict=True):
            size = task.senses[axis] * self.start.table[axis, order]
            states[point, order, axis] += STATE_SHARE * move * size
        return task.with_states(states), table
