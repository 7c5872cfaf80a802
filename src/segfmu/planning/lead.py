"""Leads: from any state of the axes to states from which the planner goes on, or to velocities."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import DelayedState, WaypointState
from segfmu.kernels.settling.records import LeadEnd, LeadRows, LeadStage, LeadTask, LeadWork
from segfmu.kernels.trajectory.records import Timing
from segfmu.planning.problem import SHAPES

# rows of work space that is kept, at most
LARGEST = 10_000
# what a lead goes to
TO_VELOCITY, TO_PLAN = int(LeadStage.VELOCITY), int(LeadStage.ACCELERATION)


@dataclass(frozen=True, eq=False)
class Pieces:
    """Polynomial pieces of all axes, as in `Trajectory`.

    Attributes
    ----------
    timing : ndarray, shape (rows, 2)
    coefficients : ndarray, shape (rows, 2 * smoothness)
    offsets : ndarray of int, shape (axes + 1,)
    """

    timing: FloatArray
    coefficients: FloatArray
    offsets: NDArray[np.int64]

    @staticmethod
    def none(axes: int, smoothness: int) -> Pieces:
        """No pieces at all."""
        return Pieces(
            np.zeros((1, Timing.SIZE)), np.zeros((1, 2 * smoothness)),
            np.zeros(axes + 1, dtype=np.int64),
        )

    @staticmethod
    def one(timing: FloatArray, coefficients: FloatArray, count: int) -> Pieces:
        """The first `count` pieces as those of one axis."""
        offsets = np.array([0, count], dtype=np.int64)
        return Pieces(timing[:count].copy(), coefficients[:count].copy(), offsets)

    @staticmethod
    def together(parts: list[Pieces], width: int) -> Pieces:
        """Pieces of single axes as those of several."""
        offsets = np.cumsum([0, *(part.used for part in parts)], dtype=np.int64)
        if offsets[-1] == 0:
            return Pieces.none(len(parts), width // 2)
        return Pieces(
            np.concatenate([part.timing for part in parts]),
            np.concatenate([part.coefficients for part in parts]), offsets,
        )

    def axis(self, axis: int) -> Pieces:
        """The pieces of one axis."""
        first, last = self.offsets[axis], self.offsets[axis + 1]
        return Pieces.one(self.timing[first:], self.coefficients[first:], int(last - first))

    def ends(self) -> FloatArray:
        """Where the last piece of every axis ends, and when, shape (axes, DelayedState)."""
        ends = np.zeros((self.offsets.size - 1, DelayedState.SIZE))
        backend.plan_ends(self.timing, self.coefficients, self.offsets, ends)
        return ends

    def stops(self) -> FloatArray:
        """When the last piece of each axis ends [s], shape (axes,)."""
        stops: FloatArray = self.timing[self.offsets[1:] - 1].sum(axis=1)
        return stops

    def resting(self, dwell: float) -> Pieces:
        """The same; each axis rests at its end, in its last piece, for at least `dwell` [s]."""
        timing = self.timing.copy()
        last = self.offsets[1:] - 1
        timing[last, 1] = np.maximum(timing[last, 1], dwell)
        return replace(self, timing=timing)

    def meeting(self, clock: float, dwell: float) -> Pieces:
        """The same; axes that end together up to the rounding of a clock [s] do so without.

        dwell: of the last waypoint [s].
        """
        timing = self.timing.copy()
        backend.meet_ends(clock, dwell, timing, self.offsets)
        return replace(self, timing=timing)

    def anchored(self, ends: FloatArray, limits: FloatArray) -> Pieces:
        """The same, changed by rounding errors: each axis ends exactly in `ends` (axes, ..)."""
        coefficients = self.coefficients.copy()
        backend.anchor_plan(ends, limits, self.timing, coefficients, self.offsets)
        return replace(self, coefficients=coefficients)

    def starts(self) -> FloatArray:
        """Position and the derivatives 1 .. n of every axis at its start, shape (axes, n + 1)."""
        first = self.coefficients[self.offsets[:-1], : self.coefficients.shape[1] // 2 + 1]
        return first * _factorials(first.shape[1])

    @property
    def used(self) -> int:
        """Number of the pieces; there may be more rows."""
        return int(self.offsets[-1])

    def after(self, first: Pieces) -> Pieces:
        """These pieces behind those of `first`, axis by axis; times stay as they are."""
        rows = max(self.used, first.used)
        timing = np.empty((2 * rows, Timing.SIZE))
        coefficients = np.empty((2 * rows, self.coefficients.shape[1]))
        offsets = np.zeros_like(self.offsets)
        used = backend.join_plans(
            *first._padded(rows), *self._padded(rows), timing, coefficients, offsets
        )
        return Pieces(timing[:used], coefficients[:used], offsets)

    def _padded(self, rows: int) -> tuple[FloatArray, FloatArray, NDArray[np.int64]]:
        if len(self.timing) >= rows:
            return self.timing[:rows], self.coefficients[:rows], self.offsets
        timing = np.zeros((rows, Timing.SIZE))
        coefficients = np.zeros((rows, self.coefficients.shape[1]))
        timing[: self.used] = self.timing[: self.used]
        coefficients[: self.used] = self.coefficients[: self.used]
        return timing, coefficients, self.offsets


@lru_cache(maxsize=8)
def _factorials(count: int) -> FloatArray:
    """0! .. (count - 1)!, shape (count,)."""
    return np.cumprod([1.0, *range(1, count)])


@dataclass(frozen=True, eq=False)
class Leads:
    """Leads of all axes.

    Attributes
    ----------
    pieces : Pieces
    states : ndarray, shape (axes, DelayedState)
        Where they end, and after which time.
    failed : int
        First axis without one; -1 if there is none.
    following : ndarray of bool, shape (axes,)
        Axes whose start is that of the pieces, up to rounding that of the axes.
    """

    pieces: Pieces
    states: FloatArray
    failed: int = -1
    following: NDArray[np.bool_] = field(default_factory=lambda: np.zeros(0, dtype=bool))

    def anchored(self, velocity: FloatArray, limits: FloatArray) -> Leads:
        """The same, changed by rounding errors: each axis ends exactly at a velocity (axes,)."""
        parts = [self.pieces.axis(axis) for axis in range(len(self.states))]
        for axis, part in enumerate(parts):
            if part.used > 0:
                end = [[self.states[axis, WaypointState.POSITION], velocity[axis]]]
                parts[axis] = part.anchored(np.array(end), limits[axis : axis + 1])
        pieces = Pieces.together(parts, self.pieces.coefficients.shape[1])
        return replace(self, pieces=pieces, following=np.array([p.used > 0 for p in parts]))


class Space:
    """Arrays in which leads of some number of derivatives are searched for."""

    def __init__(self, rows: int, width: int) -> None:
        self.work = np.empty((LeadWork.SIZE, LeadWork.COLUMNS))
        self.timing = np.empty((rows, Timing.SIZE))
        self.coefficients = np.empty((rows, 2 * (width - 1)))


# taken out while it is used, so that threads do not share it: new memory takes a tenth of a replan
_spaces: dict[int, Space] = {}


def find_leads(
    order: int, now: FloatArray, targets: FloatArray, limits: FloatArray, lower: FloatArray,
    shape: str, follow: Pieces, meeting: float | None = None, *, brakes: bool = True,
) -> Leads:
    """The shortest lead of every axis.

    Parameters
    ----------
    order : {TO_VELOCITY, TO_PLAN}
    now : ndarray, shape (axes, n + 1)
        Position and the derivatives 1 .. n.
    targets : ndarray, shape (axes, 3)
        WaypointState; of a lead to a velocity only this counts.
    limits : ndarray, shape (axes, n + 1)
    lower : ndarray, shape (axes, 2)
        As from `Limits.lower`.
    follow : Pieces
        Plan that can be followed.
    meeting : float, optional
        The axes meet at the target, after this time or later [s]: only those that are late make
        haste, so that the planner can slow the others down.
    brakes : bool
        A state that cannot keep the limits is brought inside first; else it has no lead.
    """
    axes, width = now.shape
    rows = len(follow.timing) + axes * LeadRows.PIECES + LeadRows.ALL
    space = _spaces.pop(width, None)
    if space is None or len(space.timing) < rows:
        space = Space(rows, width)
    work, timing, coefficients = space.work, space.timing, space.coefficients
    work.fill(0.0)
    work[LeadWork.TASK, : LeadTask.SIZE] = (
        order, -1.0 if meeting is None else meeting, SHAPES.index(shape), brakes
    )
    states = np.zeros((2, axes, width))
    states[0], states[1, :, : WaypointState.SIZE] = now, targets
    ends, offsets = np.zeros((axes, LeadEnd.SIZE)), np.zeros(axes + 1, dtype=np.int64)
    failed = backend.find_leads(
        states, limits, lower, follow.offsets, follow.timing, follow.coefficients, ends, work,
        timing, coefficients, offsets,
    )
    used = max(int(offsets[-1]), 1)
    pieces = follow if failed >= 0 else Pieces(
        timing[:used].copy(), coefficients[:used].copy(), offsets
    )
    if rows <= LARGEST:
        _spaces[width] = space
    if failed >= 0:
        return Leads(pieces, np.zeros((axes, DelayedState.SIZE)), failed)
    return Leads(
        pieces, ends[:, : DelayedState.SIZE].copy(), following=ends[:, LeadEnd.FOLLOWS] > 0.0
    )


def following(follow: Pieces, velocity: FloatArray, limits: FloatArray) -> Leads | None:
    """A plan as leads to a velocity (axes,); None if it does not end there."""
    if follow.used == 0:
        return None
    ends = follow.ends()
    targets = np.zeros((len(ends), WaypointState.SIZE))
    targets[:, WaypointState.VELOCITY] = velocity
    if not backend.are_at_velocities(targets, limits, ends):
        return None
    return Leads(follow, ends, following=np.ones(len(ends), dtype=bool))
