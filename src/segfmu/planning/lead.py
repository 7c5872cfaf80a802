"""Leads to velocities, from any state of the axes."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import DelayedState, WaypointState
from segfmu.kernels.settling.records import LeadEnd, LeadStage, LeadTask, LeadWork, PlanPart
from segfmu.planning.onward import give_space, take_space
from segfmu.planning.pieces import Pieces
from segfmu.planning.problem import SHAPES


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


def find_leads(
    velocities: FloatArray, now: FloatArray, limits: FloatArray, lower: FloatArray, shape: str,
    follow: Pieces,
) -> Leads:
    """The shortest lead of every axis to its velocity.

    Parameters
    ----------
    velocities : ndarray, shape (axes,)
    now : ndarray, shape (axes, n + 1)
        Position and the derivatives 1 .. n; a state that cannot keep the limits is brought inside
        first.
    limits : ndarray, shape (axes, n + 1)
    lower : ndarray, shape (axes, 2)
        As from `Limits.lower`.
    follow : Pieces
        Plan that can be followed.
    """
    axes, width = now.shape
    space = take_space((2, axes, width - 1), follow.used)
    space.work[LeadWork.TASK, : LeadTask.BRAKES + 1] = (
        LeadStage.VELOCITY, -1.0, SHAPES.index(shape), 1.0
    )
    states, ends = np.zeros((2, axes, width)), np.zeros((axes, LeadEnd.SIZE))
    states[0], states[1, :, WaypointState.VELOCITY] = now, velocities
    offsets = np.zeros(axes + 1, dtype=np.int64)
    timing, coefficients = space.part(PlanPart.LEADS)
    failed = backend.find_leads(
        states, limits, lower, follow.offsets, follow.timing, follow.coefficients, ends,
        space.work, timing, coefficients, offsets,
    )
    used = max(int(offsets[-1]), 1)
    pieces = follow if failed >= 0 else Pieces(
        timing[:used].copy(), coefficients[:used].copy(), offsets
    )
    give_space(space)
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
