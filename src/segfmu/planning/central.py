"""The central path of a mission: free states and durations from an interior-point method.

Between two waypoints the control is constant in each cell of a grid (grid.py). Towards the shortest
total time within the limits at all nodes, Newton's method follows the central path: it minimises

    theta * (sum of durations) - sum of log(1 - share^2)

for rising theta, a share being a derivative over its limit, counted from the middle of its range
where that differs by direction (Boyd and Vandenberghe, Convex
Optimization, ch. 11). The conditions at the waypoints hold by construction, so every point is a
motion. Axes that have time to spare stay in the middle of what they can do.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solveh_banded

from segfmu.planning.arrays import FloatArray
from segfmu.planning.grid import ENDS, grid
from segfmu.planning.point import Point

# shares of the curvature's diagonal that are added until Newton's step leads down
RIDGES = (0.0, 0.1, 1.0, 10.0, 1e2, 1e3, 1e4)
# how often what given states exceed the limits by is taken back, at most
RETREATS = 60
# a larger share than this in use: what the states exceed the limits by is as small as it can be
USED_UP = 0.999


@dataclass(frozen=True, eq=False)
class _Model:
    """Gradient and curvature of the barrier at a point; the components are eliminated.

    Attributes
    ----------
    slope : ndarray, shape (intervals, axes, 5)
        By the states at the ends and the logarithm of the duration.
    curvature : ndarray, shape (intervals, axes, 5, 5)
    solved : ndarray, shape (intervals, axes, components, 6)
        Components by these variables, and without them.
    gradient : ndarray, shape (intervals, axes, 5 + components)
        Before the elimination.
    """

    slope: FloatArray
    curvature: FloatArray
    solved: FloatArray
    gradient: FloatArray


class CentralPath:
    """The barrier function of a mission whose axes meet in every waypoint, and Newton's steps."""

    def __init__(
        self, positions: FloatArray, states: FloatArray, free: NDArray[np.bool_],
        limits: FloatArray, centre: FloatArray, used: FloatArray, box: FloatArray,
    ) -> None:
        """Take a mission.

        Parameters
        ----------
        positions : ndarray, shape (waypoints, axes)
        states : ndarray, shape (waypoints, axes, 2)
            Velocity and acceleration where they are given.
        free : ndarray of bool, shape (waypoints, axes, 2)
        limits : ndarray, shape (axes, order)
            Of the derivatives 1 .. order, the control's included; infinite where absent. Of
            velocity and acceleration half of their range.
        centre : ndarray, shape (axes, 2)
            The middle of that range.
        used : ndarray, shape (intervals, order)
            Share of each limit that may be used in each interval.
        box : ndarray, shape (intervals, axes, 2)
            Range of the positions in each interval; infinite where there is none.
        """
        order = limits.shape[1]
        self.free = free
        self.chords = np.diff(positions, axis=0)
        self._grid = grid(order)
        self._given = np.where(free, 0.0, states / limits[None, :, :2])
        self._middle = np.broadcast_to(centre / limits[:, :2], states.shape)
        self._scales = float((limits[:, 0] / limits[:, 1]).max()), float(
            (np.abs(self.chords) / limits[:, 0]).max()
        )
        units = np.ones((len(limits), self._grid.rows.shape[1]))
        units[:, [1, 3]] = limits[:, 0, None]
        units[:, [2, 4]] = limits[:, 1, None]
        units[:, 1 + ENDS:] = limits[:, order - 1, None]
        half = 0.5 * (box[..., 1] - box[..., 0])
        bounded = np.isfinite(half)
        middle = 0.5 * np.where(bounded[..., None], box, 0.0).sum(axis=2)
        # an axis that may not move has a range all the same, of no size to speak of
        half = np.maximum(half, 1e-9 * np.abs(self.chords).max())
        bounds = np.concatenate([half[..., None], limits[None] * used[:, None]], axis=2)
        maps = self._grid.rows[None] * units[:, None, :]
        self._maps = maps[None] / bounds[:, :, self._grid.orders, None]
        offset = (np.where(bounded, positions[:-1], 0.0) - middle) / half
        orders = self._grid.orders
        self._offsets = np.where(orders == 0, offset[..., None], 0.0)
        for field in range(2):
            self._offsets[:, :, orders == 1 + field] = -self._middle[0, :, field, None]
        # more than 1 while given states exceed what the limits' shares admit
        self.room = 1.0

    @property
    def constraints(self) -> int:
        """Number of terms of the barrier."""
        return int(self._maps[..., 0].size + self.free.sum())

    def start(self, gap: float) -> Point | None:
        """Rest at the free states; durations keep half of the limits, or as near as can be.

        If given states exceed the limits there, a point within them; None if none is found. On the
        way to it constraints / (theta * total) is `gap`.
        """
        intervals, axes = self.chords.shape
        least, reach = self._scales
        choices = np.log(np.geomspace(1e-3 * least, 1e3 * (least + reach), 120))
        components = np.zeros((intervals, axes, self._grid.rows.shape[1] - 1 - ENDS))
        bounded = self._grid.orders > 0
        peaks = np.array([
            np.abs(self._shares(Point(self._given, np.full(intervals, time), components))).max(
                axis=(1, 2), where=bounded, initial=0.0
            )
            for time in choices
        ])
        fitting = peaks <= 0.5
        first = np.where(fitting.any(axis=0), fitting.argmax(axis=0), peaks.argmin(axis=0))
        point = Point(self._given, choices[first], components)
        peak = float(np.abs(self._shares(point)).max())
        if peak < 1.0:
            return point
        self.room = 1.5 * peak
        return self._within(point, gap)

    def _within(self, point: Point, gap: float) -> Point | None:
        """A point within the limits: what given states exceed them by is taken back step by step.

        Where time counts much, short durations push against the limits, and what can be taken back
        gets small. Where it counts little, the motion may turn into a detour.
        """
        for _ in range(RETREATS):
            centred = self.centre(point, self.constraints / (gap * point.total))
            if centred is None:
                return None
            point = centred
            used = float(np.abs(self._shares(point)).max())
            if used > USED_UP:
                return None
            self.room = max(1.0, self.room * (used + 0.1 * (1.0 - used)))
            if self.room == 1.0:
                return point
        return None

    def centre(self, point: Point, theta: float) -> Point | None:
        """The minimum of the barrier function, to about half a unit; None if none is found."""
        for _ in range(30):
            found = self._step(point, theta)
            if found is None:
                return None
            step, decrease = found
            share = min(1.0, 0.6 / float(np.abs(step.times).max(initial=1e-9)))
            value = self._value(point, theta)
            while self._value(point.moved(step, share), theta) > value - 0.1 * share * decrease:
                share *= 0.5
                if share < 1e-6:
                    return None
            point = point.moved(step, share)
            if decrease < 0.5:
                break
        return point

    def _scaled(self, point: Point) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Maps (intervals, axes, rows, columns) at the durations, variables, and shares."""
        times = np.exp(point.times[:, None, None] * self._grid.exponents)
        ends = np.concatenate([point.states[:-1], point.states[1:]], axis=2)
        variables = np.concatenate([self.chords[:, :, None], ends, point.components], axis=2)
        maps = self._maps * (times / self.room)[:, None]
        shares = self._offsets / self.room + (maps @ variables[..., None])[..., 0]
        return maps, variables, shares

    def _shares(self, point: Point) -> FloatArray:
        """Derivatives over their limits, shape (intervals, axes, rows)."""
        return self._scaled(point)[2]

    def _value(self, point: Point, theta: float) -> float:
        """The barrier function; infinite outside the limits."""
        shares = self._shares(point)
        states = (point.states - self._middle)[self.free]
        if not (np.abs(shares).max() < 1.0 and np.abs(states).max(initial=0.0) < 1.0):
            return np.inf
        barrier = np.log1p(-shares * shares).sum() + np.log1p(-states * states).sum()
        return theta * point.total - float(barrier)

    def _step(self, point: Point, theta: float) -> tuple[Point, float] | None:
        """Newton's step and the decrease that it promises.

        Where the function is not convex, a diagonal is added.
        """
        for ridge in RIDGES:
            try:
                return self._solve(point, theta, self._model(point, ridge))
            except np.linalg.LinAlgError:
                continue
        return None

    def _model(self, point: Point, ridge: float) -> _Model:
        """The barrier's model; the diagonal of states and durations grows by a share."""
        # the shares that `_value` found below 1; summed in another order they may round to 1
        maps, variables, shares = self._scaled(point)
        terms = maps * variables[:, :, None, :]
        slopes = (terms * self._grid.exponents).sum(axis=3)
        jacobian = np.concatenate(
            [maps[..., 1:1 + ENDS], slopes[..., None], maps[..., 1 + ENDS:]], axis=3
        )
        inner = 1.0 - shares * shares
        first = 2.0 * shares / inner
        second = 2.0 * (1.0 + shares * shares) / (inner * inner)
        gradient = (first[..., None, :] @ jacobian)[..., 0, :]
        hessian = np.swapaxes(jacobian * second[..., None], 2, 3) @ jacobian
        diagonal = np.arange(1 + ENDS)
        hessian[..., diagonal, diagonal] *= 1.0 + ridge
        weights = first[..., None] * self._grid.exponents
        cross = (weights * maps).sum(axis=2)
        columns = np.r_[:ENDS, ENDS + 1:hessian.shape[3]]
        hessian[..., columns, ENDS] += cross[..., 1:]
        hessian[..., ENDS, columns] += cross[..., 1:]
        bend = weights * (self._grid.exponents + 1.0) * terms
        hessian[..., ENDS, ENDS] += bend.sum(axis=(2, 3))
        own, both = hessian[..., 1 + ENDS:, 1 + ENDS:], hessian[..., :1 + ENDS, 1 + ENDS:]
        right = np.concatenate([np.swapaxes(both, 2, 3), gradient[..., 1 + ENDS:, None]], axis=3)
        solved = np.linalg.solve(own, right)
        reduced = both @ solved
        return _Model(
            gradient[..., :1 + ENDS] - reduced[..., -1],
            hessian[..., :1 + ENDS, :1 + ENDS] - reduced[..., :-1], solved, gradient,
        )

    def _solve(self, point: Point, theta: float, model: _Model) -> tuple[Point, float]:
        """The step to the model's minimum; LinAlgError if it has none."""
        intervals, axes = self.chords.shape
        durations = theta * np.exp(point.times)
        bend = model.curvature[..., ENDS, ENDS].sum(axis=1) + 2.0 * durations
        if not bend.min() > 0.0:
            raise np.linalg.LinAlgError
        pull = model.slope[..., ENDS].sum(axis=1) + durations
        cross = model.curvature[..., :ENDS, ENDS].reshape(intervals, axes * ENDS)
        slopes = model.slope[..., :ENDS].reshape(intervals, -1) - cross * (pull / bend)[:, None]
        blocks = np.zeros((intervals, axes * ENDS, axes * ENDS))
        for axis in range(axes):
            own = slice(axis * ENDS, (axis + 1) * ENDS)
            blocks[:, own, own] = model.curvature[:, axis, :ENDS, :ENDS]
        blocks -= cross[:, :, None] * cross[:, None, :] / bend[:, None, None]
        states = self._solve_states(point, blocks, slopes)
        ends = np.concatenate([states[:-1], states[1:]], axis=2)
        times = -(pull + (cross * ends.reshape(intervals, -1)).sum(axis=1)) / bend
        outer = np.concatenate(
            [ends, np.broadcast_to(times[:, None, None], (intervals, axes, 1))], axis=2
        )
        components = -(model.solved[..., -1] + (model.solved[..., :-1] @ outer[..., None])[..., 0])
        promised = (
            durations @ times + (model.gradient * np.concatenate([outer, components], 2)).sum()
            + (self._state_barrier(point)[0] * states).sum()
        )
        return Point(states, times, components), -float(promised)

    def _state_barrier(self, point: Point) -> tuple[FloatArray, FloatArray]:
        """Gradient and curvature of the barrier of the free states themselves."""
        x = np.where(self.free, point.states - self._middle, 0.0)
        inner = 1.0 - x * x
        return 2.0 * x / inner, 2.0 * (1.0 + x * x) / (inner * inner)

    def _solve_states(self, point: Point, blocks: FloatArray, slopes: FloatArray) -> FloatArray:
        """The step of the states: a system whose band is two waypoints wide."""
        axes = self.chords.shape[1]
        width = 2 * axes
        gradient, curvature = self._state_barrier(point)
        # from axis, end, state to end, axis, state
        order = np.arange(axes * ENDS).reshape(axes, 2, 2).transpose(1, 0, 2).ravel()
        blocks, slopes = blocks[:, order][:, :, order], slopes[:, order]
        right = -gradient.reshape(-1, width)
        right[:-1] -= slopes[:, :width]
        right[1:] -= slopes[:, width:]
        band = np.zeros((2 * width, gradient.size))
        band[0] = curvature.ravel()
        for row in range(2 * width):
            for column in range(row + 1):
                last = gradient.size - 2 * width + column + 1
                band[row - column, column:last:width] += blocks[:, row, column]
        fixed = ~self.free.ravel()
        for offset in range(2 * width):
            coupled = fixed[:gradient.size - offset] | fixed[offset:]
            band[offset, :gradient.size - offset][coupled] = 0.0
        band[0, fixed] = 1.0
        right = np.where(fixed, 0.0, right.ravel())
        solution = solveh_banded(band, right, lower=True, check_finite=False)
        if not np.isfinite(solution).all():
            raise np.linalg.LinAlgError
        return np.asarray(solution).reshape(point.states.shape)
