"""Choice of free waypoint velocities and accelerations.

The states of the central path (central.py) are nearly optimal, but the planner's profiles are not
all motions: between some states they take longer than the path. Where they do, the path is found
again for smaller shares of the jerk and snap limits in that interval, until the planner keeps up.
What counts is the planner's own duration. Rest at the free waypoints and free velocities without
acceleration are candidates as well, so the choice is never slower than these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from segfmu.kernels import backend
from segfmu.kernels.planner.records import WaypointState
from segfmu.planning.arrays import FloatArray
from segfmu.planning.central import CentralPath
from segfmu.planning.passage import Passage, passages
from segfmu.planning.problem import Problem
from segfmu.planning.repeats import united
from segfmu.planning.request import Request, with_states

Progress = Callable[[int, int], None]

# share of the range of its neighbours by which an axis may leave it
OVERSHOOT = 0.25
ROUNDS = 10
# points of the path: by how much its duration may exceed the shortest one, at most
GAPS = (0.3, 0.1, 0.03)
# by how much the duration may exceed the shortest one where a path begins: at rest, and if given
# states move; the motion found there depends on it, so each is tried
STARTS_AT_REST = (10.0,)
STARTS = (3.0, 100.0)
# a path this much longer than the best plan holds nothing faster
HOPELESS = 1.03
# a profile keeps up with the path if it takes at most this much longer
KEEPS_UP = 1.005
# of the last search, in units of the limits, and the least gain that counts
STEPS = (0.03, 0.01, 0.003, 0.001)
SHORTER = 1.0 - 1e-6
# states are multiples of the limit over this: linear algebra differs by up to 1e-12 of the limit
# from processor to processor, so one number in a million would be rounded in another way
GRID = 2.0**16
# durations that differ by a smaller share are equal
ALIKE = 1e-6
# factors of velocity, acceleration, jerk and snap limits for each degree of tightness
TIGHTER = np.array([1.0, 1.0, 0.93, 0.75])
# a limit of so many times about the largest value of a motion is none
REACH = 4.0
# what smoothsteps use of the limits of velocity .. snap, about
SMOOTHSTEP = np.array([1.0, 1.0, 0.6, 0.5])


def choose_states(
    request: Request, overshoot: float = OVERSHOOT, progress: Progress | None = None,
    allowed: FloatArray | None = None,
) -> Request:
    """A request with numbers for its free velocities and accelerations (NaN).

    Free states of the first and the last waypoint, and of those with a dwell, become rest.

    allowed : ndarray, shape (axes, 2), optional
        Range of the positions [m].
    """
    if not request.free:
        return request
    if allowed is None:
        allowed = np.tile([-np.inf, np.inf], (len(request.axis_names), 1))
    place, states = united(request.problem.states)
    kept = np.unique(place, return_index=True)[1]
    free = np.isnan(states[kept])
    chosen = request.problem._replace(
        states=np.where(free, 0.0, states[kept]),
        dwells=np.add.reduceat(request.problem.dwells, kept),
    )
    limits, lower = reachable(chosen)
    chosen = chosen._replace(limits=limits, lower=lower)
    free[[0, -1]] = False
    free[chosen.dwells > 0.0] = False
    states = chosen.states
    # with more room the search may end elsewhere, and later
    rooms = (overshoot, OVERSHOOT) if overshoot > OVERSHOOT else (overshoot,)
    parts = [
        list(passages(chosen, free[:, :, WaypointState.VELOCITY:], room, allowed))
        for room in rooms
    ]
    for done, (part, *others) in enumerate(zip(*parts, strict=True)):
        found = [_fastest(p) for p in (part, *others)]
        states[part.waypoints, part.axes, WaypointState.VELOCITY:] = min(
            found, key=lambda s: part.durations(s).sum()
        )
        if progress is not None:
            progress(done + 1, len(parts[0]))
    return _with_states(request, states[place])


def reachable(problem: Problem) -> tuple[FloatArray, FloatArray]:
    """Both limits, those of velocity and acceleration a few times what is reached at most.

    A limit that is meant as none would be a useless unit of the central path.
    """
    limits, lower = problem.limits.copy(), problem.lower.copy()
    either = limits.copy()
    either[:, :2] = np.maximum(limits[:, :2], lower)
    for order in range(2):
        reached = backend.motion_scale(order, problem.states, either)
        if reached > 0.0:
            for table in (limits, lower):
                table[:, order] = np.minimum(table[:, order], REACH * reached)
    return limits, lower


def at_rest(request: Request) -> Request:
    """A request whose free velocities and accelerations are zero."""
    _, states = united(request.problem.states)
    return _with_states(request, np.where(np.isnan(states), 0.0, states))


def _with_states(request: Request, states: FloatArray) -> Request:
    problem = request.problem._replace(states=states)
    return request._replace(
        waypoints=with_states(request.waypoints, states, problem.dwells), problem=problem
    )


def _fastest(part: Passage) -> FloatArray:
    """Velocities and accelerations (waypoints, axes, 2) of the fastest plan found."""
    best = _searched(part)
    candidates = [best]
    if part.free[:, :, 1].any():
        velocities = part.free.copy()
        velocities[:, :, 1] = False
        alone = _searched(replace(part, free=velocities), best.total)
        if alone.total < best.total:
            best.states, best.total = alone.states.copy(), alone.total
        # polished on its own, as if velocities alone were free: from `best` it may end elsewhere
        candidates.append(alone)
    for candidate in candidates:
        candidate.polish()
    return min(candidates, key=lambda candidate: candidate.total).states


def _searched(part: Passage, known: float = np.inf) -> _Best:
    """The fastest states on central paths, of interest beside a plan of known duration."""
    best = _Best(part)
    moving = part.problem.states[:, :, WaypointState.VELOCITY:].any()
    for start in STARTS if moving else STARTS_AT_REST:
        _Search(part, start).improve(best, known)
    return best


class _Best:
    """The fastest states so far; first of all, rest."""

    def __init__(self, part: Passage) -> None:
        self.part = part
        self.states = part.problem.states[:, :, WaypointState.VELOCITY:].copy()
        self.total = float(part.durations(self.states).sum())

    def offer(self, states: FloatArray, times: FloatArray) -> NDArray[np.bool_]:
        """Take states if they are faster; returns in which intervals they fail.

        They fail where the plan takes longer than the path, or leaves the range of the positions.
        """
        least = self.part.least_durations(states).max(axis=1)
        if not least.sum() < self.total:
            return np.asarray(~(least <= KEEPS_UP * times))
        durations = self.part.durations(states)
        slow = np.asarray(~(durations <= KEEPS_UP * times))
        if durations.sum() < self.total:
            beyond = self.part.beyond(states)
            if not beyond.any():
                self.states, self.total = states, float(durations.sum())
            slow |= beyond
        return slow

    def polish(self) -> None:
        """Move one free state after the other while the two intervals next to it get shorter.

        The points in the order of the longer first interval, so that a path and its reverse end
        alike.
        """
        for step in STEPS:
            places = np.argwhere(self.part.free)
            if self._runs_backwards():
                places = places[np.argsort(-places[:, 0], kind="stable")]
            for point, axis, field in places.tolist():
                self._polish(point, axis, field, step)
        self.total = float(self.part.durations(self.states).sum())

    def _runs_backwards(self) -> bool:
        """Whether the last intervals are longer than the first ones."""
        durations = self.part.durations(self.states)
        ahead = durations - durations[::-1]
        apart = ahead[np.abs(ahead) > ALIKE * durations.max()]
        return bool(apart.size > 0 and apart[0] < 0.0)

    def _polish(self, point: int, axis: int, field: int, step: float) -> None:
        """Move a state in the direction that gains more, as long as it gains."""
        near = self.part.around(point)
        low, high = -near.problem.lower[axis, field], near.problem.limits[axis, field]

        def moved(states: FloatArray, move: float) -> tuple[float, FloatArray]:
            trial = states.copy()
            trial[1, axis, field] = np.clip(trial[1, axis, field] + move, low, high)
            total = near.quick_total(trial, least * SHORTER)
            gains = total < least * SHORTER and not near.beyond(trial).any()
            return (total if gains else np.inf), trial

        window = self.states[point - 1:point + 2].copy()
        least = float(near.durations(window).sum())
        size = step * 0.5 * float(high - low)
        ways = [(*moved(window, move), move) for move in (size, -size)]
        reached, trial, move = min(ways, key=lambda way: way[0])
        while reached < np.inf:
            window, least = trial, reached
            reached, trial = moved(window, move)
        self.states[point] = window[1]


class _Search:
    """Central paths of a passage, tighter where the planner does not keep up."""

    def __init__(self, part: Passage, start: float) -> None:
        self.part = part
        self.start = start
        self.limits = _control_limits(part.problem)
        self.total = 0.0

    def improve(self, best: _Best, known: float) -> None:
        """Offer states on central paths until they cannot be faster."""
        # degrees of tightness: in use, the highest that failed, and those that did not
        degree = np.zeros(len(self.part.box))
        failed, good = degree - 1.0, degree + np.inf
        for _ in range(ROUNDS):
            slow = self._try(degree, best)
            if slow is None or self.total > min(best.total, known) * HOPELESS:
                return
            failed[slow] = np.maximum(failed[slow], degree[slow])
            if not slow.any():
                good = degree
            # an interval that failed gets tighter; if none did, those that once failed get looser
            retried = slow if slow.any() else (failed >= 0.0) & (good - failed > 0.4)
            if not retried.any():
                return
            tighter = np.where(np.isfinite(good), 0.5 * (failed + good), 1.0 + 1.25 * failed)
            degree = np.where(retried, tighter, degree)

    def _try(self, degree: FloatArray, best: _Best) -> NDArray[np.bool_] | None:
        """Offer the states on one central path; the intervals in which the best of them fail."""
        slow = None
        for states, times in self._path(degree):
            self.total = float(times.sum())
            found = best.offer(states, times)
            if slow is None or found.sum() < slow.sum():
                slow = found
        return slow

    def _path(self, degree: FloatArray) -> Iterator[tuple[FloatArray, FloatArray]]:
        """States (waypoints, axes, 2) and durations (intervals,) [s] on the central path."""
        problem = self.part.problem
        used = TIGHTER[None, :self.limits.shape[1]] ** degree[:, None]
        if problem.options.shape == "smoothstep":
            used = used * SMOOTHSTEP[:self.limits.shape[1]]
        path = CentralPath(
            problem.states[:, :, WaypointState.POSITION],
            problem.states[:, :, WaypointState.VELOCITY:], self.part.free, self.limits,
            problem.limits[:, :2] - self.limits[:, :2], used, self.part.box,
        )
        point = path.start(self.start)
        if point is None:
            return
        theta = path.constraints / (self.start * point.total)
        for gap in GAPS:
            reached = np.inf
            while reached > 1.05 * gap:
                centred = path.centre(point, theta)
                if centred is None:
                    return
                point = centred
                reached = path.constraints / (theta * point.total)
                theta *= min(4.0, max(1.0, reached / gap))
            yield self._rounded(point.states), np.exp(point.times)

    def _rounded(self, shares: FloatArray) -> FloatArray:
        """States without the last digits, which depend on the processor: all plan the same."""
        problem = self.part.problem
        digits = np.round(shares * GRID) / GRID * self.limits[None, :, :2]
        return np.where(self.part.free, digits, problem.states[:, :, WaypointState.VELOCITY:])


def _half_range(problem: Problem) -> FloatArray:
    """Half of the range of velocity and acceleration, shape (axes, 2)."""
    half: FloatArray = 0.5 * (problem.limits[:, :2] + problem.lower)
    return half


def _control_limits(problem: Problem) -> FloatArray:
    """Limits up to the order of the control; infinite where absent.

    If a limit above the snap alone bounds it, the snap is about what the ramp to the acceleration
    limit needs.
    """
    known = problem.limits[:, :6].copy()
    known[:, :2] = _half_range(problem)
    table = np.zeros((len(known), 6))
    table[:, :known.shape[1]] = known
    table[table == 0.0] = np.inf
    acceleration, jerk, snap, crackle, pop = table[:, 1:].T
    snap = np.minimum(snap, np.minimum(
        np.cbrt(crackle * crackle * acceleration), np.sqrt(pop * acceleration)
    ))
    if not np.isfinite(snap).any():
        return table[:, :3]
    snap = np.minimum(snap, 10.0 * jerk * jerk / acceleration)
    return np.column_stack([table[:, :3], snap])
