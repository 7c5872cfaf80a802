"""Trajectories within a range of positions: splines where profiles leave it.

An interval keeps its duration if the axes that leave the range can stay inside in that time. Else
it becomes longer, in growing steps, until all axes that meet at its end have a motion.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from math import ceil, inf

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.errors import InfeasibleError
from segfmu.kernels.planner.records import WaypointState
from segfmu.kernels.trajectory.records import Timing
from segfmu.planning.demands import position_margin, require, require_positions
from segfmu.planning.motion import plan_motion
from segfmu.planning.polynomials import extrema
from segfmu.planning.problem import options
from segfmu.planning.request import Request
from segfmu.planning.splines import AxisBounds, spline_motion, spline_use
from segfmu.planning.trajectory import Trajectory

# of its duration, by which an interval becomes longer; the one that is found is known to a
# sixteenth of the last step
SHARES = 0.0005 * 4.0 ** np.arange(7)
HALVINGS = 4
# durations that are tried between two, where the use is least, if it is not above NEAR
CLOSER = 12
NEAR = 1.1
# of a sample time, by which times may exceed a multiple
ROUNDED = 1e-9

# lengths (pieces,) and coefficients (pieces, 2 n)
Motion = tuple[FloatArray, FloatArray]


def kept_within(
    trajectory: Trajectory, request: Request, allowed: FloatArray
) -> Trajectory | None:
    """The trajectory with other motions where it leaves the range; None if none are found.

    Parameters
    ----------
    trajectory : Trajectory
        Of the request.
    request : Request
        Without free states.
    allowed : ndarray, shape (axes, 2)
        Range of the positions [m], infinite for no bound.
    """
    changed = _Changed(trajectory, request, allowed)
    groups = [list(range(trajectory.axes))]
    if trajectory.synchronize == "none":
        groups = [[axis] for axis in groups[0]]
    for interval in range(len(trajectory.waypoints) - 1):
        for group in groups:
            if not changed.keep(interval, group):
                return None
    found = changed.trajectory()
    try:
        require(found)
        require_positions(found, allowed)
    except InfeasibleError:
        return None
    return found


def first_share(use: Callable[[float], float]) -> float | None:
    """About the least share of `SHARES` or between them with a use of at most 1; None: none.

    Where it is not found at once it is sought around the least use.
    """
    from scipy.optimize import minimize_scalar

    shares: list[float] = [0.0, *SHARES.tolist()]
    uses = [inf]
    found: float | None = None
    for share in shares[1:]:
        uses.append(use(share))
        if uses[-1] <= 1.0:
            found = share
            break
    best = int(np.argmin(uses))
    if found is None and 0 < best < len(uses) - 1 and uses[best] <= NEAR:
        least = minimize_scalar(
            use, bounds=(shares[best - 1], shares[best + 1]), method="bounded",
            options={"maxiter": CLOSER},
        )
        if least.fun <= 1.0:
            found = float(least.x)
    if found is None:
        return None
    fails = max(share for share in shares if share < found)
    for _ in range(HALVINGS):
        middle = 0.5 * (fails + found)
        if use(middle) <= 1.0:
            found = middle
        else:
            fails = middle
    return found


class _Changed:
    """A trajectory whose motions are replaced, interval after interval."""

    def __init__(self, trajectory: Trajectory, request: Request, allowed: FloatArray) -> None:
        self._old, self._request, self._allowed = trajectory, request, allowed
        self._arrivals = trajectory.axis_waypoint_times.copy()
        self._departures = self._arrivals + request.problem.dwells[:, None]
        self._ends = trajectory.axis_durations.copy()
        self._parts = [self._cut(axis) for axis in range(trajectory.axes)]

    def _cut(self, axis: int) -> list[Motion]:
        """Pieces of an axis: at the first waypoint, to the second one, there, ..., at the last."""
        starts, lengths, coefficients = self._old.pieces(axis)
        edges = np.stack([self._departures[:-1, axis], self._arrivals[1:, axis]], axis=1).ravel()
        part = np.searchsorted(edges, starts + 0.5 * lengths)
        return [(lengths[part == i], coefficients[part == i]) for i in range(edges.size + 1)]

    def keep(self, interval: int, group: list[int]) -> bool:
        """Bring axes that meet inside the range in an interval; False if that fails."""
        part = 2 * interval + 1
        outside = [axis for axis in group if self._leaves(axis, self._parts[axis][part])]
        if not outside:
            return True
        old = (self._arrivals[interval + 1] - self._departures[interval])[group]
        durations = dict(zip(group, old.tolist(), strict=True))
        added = 0.0
        found = self._motions(interval, {axis: durations[axis] for axis in outside}, outside)
        if found is None:
            added, found = self._prolonged(interval, durations)
        if found is None:
            return False
        for axis, motion in found.items():
            self._parts[axis][part] = motion
        self._arrivals[interval + 1 :, group] += added
        self._departures[interval + 1 :, group] += added
        self._ends[group] += added
        return True

    def _prolonged(
        self, interval: int, durations: dict[int, float]
    ) -> tuple[float, dict[int, Motion] | None]:
        """The least time that is found to be enough if it is added [s], and the motions then."""
        given = self._request.problem.options
        if given.duration > 0.0:
            return 0.0, None
        longest = max(durations.values())

        def longer(share: float) -> tuple[float, dict[int, float]]:
            added = share * longest
            if given.sample_time > 0.0:
                added = ceil(added / given.sample_time - ROUNDED) * given.sample_time
            return added, {axis: duration + added for axis, duration in durations.items()}

        share = first_share(lambda share: self._use(interval, longer(share)[1]))
        if share is None:
            return 0.0, None
        added, times = longer(share)
        return added, self._motions(interval, times)

    def _use(self, interval: int, durations: dict[int, float]) -> float:
        """The largest of the axes' least uses of limits and range (`spline_use`), up to NEAR."""
        uses = [0.0]
        for axis, duration in durations.items():
            if uses[-1] > NEAR:
                break
            motion = self._profile(interval, axis, duration)
            if motion is None or self._leaves(axis, motion):
                ends = self._ends_of(interval, axis)
                uses.append(spline_use(*ends, self._bounds(axis), duration))
        return max(uses)

    def _motions(
        self, interval: int, durations: dict[int, float], outside: Collection[int] = ()
    ) -> dict[int, Motion] | None:
        """Motions of some axes within the range; None if one has none.

        outside: axes whose profile of this duration [s] is known to leave it.
        """
        found = {}
        for axis, duration in durations.items():
            motion = None if axis in outside else self._profile(interval, axis, duration)
            if motion is None or self._leaves(axis, motion):
                pieces = spline_motion(
                    *self._ends_of(interval, axis), self._bounds(axis), duration
                )
                if pieces is None:
                    return None
                motion = np.full(len(pieces), duration / len(pieces)), pieces
            found[axis] = motion
        return found

    def _profile(self, interval: int, axis: int, duration: float) -> Motion | None:
        """The planner's own motion of a duration [s]; None if it has none."""
        problem = self._request.problem
        if interval == 0 and not self._request.waypoints[0].settled:
            return None
        chosen = problem.options
        motion = plan_motion(problem._replace(
            states=problem.states[interval : interval + 2, axis : axis + 1].copy(),
            dwells=np.zeros(2), limits=problem.limits[axis : axis + 1],
            lower=problem.lower[axis : axis + 1],
            options=options(chosen.smoothness, chosen.shape, chosen.synchronize, 0.0, duration),
        ))
        if motion.refusal is not None:
            return None
        return motion.timing[:, Timing.LENGTH], motion.coefficients

    def _ends_of(self, interval: int, axis: int) -> tuple[FloatArray, FloatArray]:
        """Position and derivatives 1 .. n of an axis at both ends of an interval."""
        problem = self._request.problem
        states = np.zeros((2, problem.options.smoothness + 1))
        states[:, : WaypointState.SIZE] = problem.states[interval : interval + 2, axis]
        if interval == 0:
            states[0] = self._request.start[axis]
        return states[0], states[1]

    def _bounds(self, axis: int) -> AxisBounds:
        problem = self._request.problem
        return AxisBounds(problem.limits[axis], problem.lower[axis], self._allowed[axis])

    def _leaves(self, axis: int, motion: Motion) -> bool:
        lengths, coefficients = motion
        low, high = extrema(coefficients, lengths, 0)
        least, most = self._allowed[axis].tolist()
        under, over = position_margin(self._allowed[axis]).tolist()
        return not (least - under <= low and high <= most + over)

    def trajectory(self) -> Trajectory:
        """All motions in a row."""
        timing, coefficients = [], []
        for axis, parts in enumerate(self._parts):
            begins = np.stack([self._arrivals[:, axis], self._departures[:, axis]], axis=1).ravel()
            for begin, (lengths, own) in zip(begins, parts, strict=False):
                ends = begin + np.cumsum(lengths)
                timing.append(np.stack([ends - lengths, lengths], axis=1))
                coefficients.append(own)
        rows = [sum(len(lengths) for lengths, _ in parts) for parts in self._parts]
        old = self._old
        return Trajectory(
            old.waypoints, old.limits, old.smoothness, old.shape, old.synchronize, old.axis_names,
            np.concatenate(timing), np.concatenate(coefficients), np.cumsum([0, *rows]),
            self._arrivals, self._ends,
        )
