"""When the load of a trajectory, or its rope, meets boxes: the kernels of kernels/clearance."""

from __future__ import annotations

import numpy as np

from segfmu.kernels import backend
from segfmu.kernels.clearance.records import Collision, Ranges, Span, Stack
from segfmu.kernels.crane.records import RopeWork
from segfmu.planning.arrays import FloatArray
from segfmu.planning.trajectory import Trajectory

# rows for intervals of contact at first
USUAL_CONTACTS = 16
# until the end of the trajectory
EVER = np.inf


class Path:
    """The motion of load and rope along a trajectory of x, y and z.

    gravity [m/s2] gives the direction of the rope.
    """

    def __init__(self, trajectory: Trajectory, gravity: float) -> None:
        pieces, width = trajectory.coefficients.shape
        columns = 2 * width - 3
        self._spans = np.empty((pieces + 1, Span.SIZE, columns))
        self._stack = np.empty((Stack.ROWS, Span.SIZE, columns))
        self._count = backend.clearance_spans(
            trajectory.timing, trajectory.coefficients, trajectory.offsets, gravity,
            np.zeros((RopeWork.SIZE, 4 * width - 5)), self._spans,
        )

    def times(self, part: int, box: FloatArray) -> FloatArray:
        """Intervals [s] in which a part (Part) meets a box (Box), shape (intervals, 2)."""
        rows = USUAL_CONTACTS
        while True:
            times = np.empty((rows, 2))
            count = backend.contact_times(
                part, EVER, self._count, box, self._spans, self._stack, times, np.empty(3)
            )
            if count <= rows:
                return times[:count]
            rows = count

    def first(self, boxes: FloatArray) -> tuple[int, FloatArray]:
        """What meets one of the boxes (boxes, Box) first (Part), and how (Collision)."""
        report = np.zeros(Collision.SIZE)
        part = backend.first_contact(
            self._count, boxes, self._spans, self._stack, np.empty((1, 2)),
            np.empty((Ranges.SIZE, 3)), report,
        )
        return part, report
