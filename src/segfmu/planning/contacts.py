"""When the load of a trajectory, or its rope, meets boxes: the kernels of kernels/clearance."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.clearance.records import Collision, Ranges, Span, Stack
from segfmu.kernels.crane.records import RopeWork
from segfmu.planning.trajectory import Trajectory

# rows for intervals of contact at first
USUAL_CONTACTS = 16
# until the end of the trajectory
EVER = np.inf


class Path:
    """The motion of load and rope along a trajectory of x, y and z.

    gravity [m/s2] gives the direction of the rope.

    Attributes
    ----------
    ranges : ndarray, shape (Ranges, 3)
        What load and rope never leave [m].
    """

    def __init__(self, trajectory: Trajectory, gravity: float) -> None:
        self._trajectory, self._gravity = trajectory, gravity
        self.ranges = np.empty((Ranges.SIZE, 3))
        backend.path_ranges(
            trajectory.timing, trajectory.coefficients, trajectory.offsets, gravity,
            np.empty((2, trajectory.coefficients.shape[1])), self.ranges,
        )

    @property
    def rounding(self) -> float:
        """Distance [m] below which a touch is rounding: 1e-9 of the largest coordinate."""
        return 1e-9 * float(np.abs(self.ranges[: Ranges.ROPE_LOW]).max())

    def times(self, part: int, box: FloatArray) -> FloatArray:
        """Intervals [s] in which a part (Part) meets a box (Box), shape (intervals, 2)."""
        spans, stack, rows = self._spans(), self._stack(), USUAL_CONTACTS
        while True:
            times = np.empty((rows, 2))
            count = backend.contact_times(
                part, EVER, len(spans), box, spans, stack, times, np.empty(3)
            )
            if count <= rows:
                return times[:count]
            rows = count

    def first(self, boxes: FloatArray) -> tuple[int, FloatArray]:
        """What meets one of the boxes (boxes, Box) first (Part), and how (Collision)."""
        report, trajectory = np.zeros(Collision.SIZE), self._trajectory
        part = backend.first_contact(
            trajectory.timing, trajectory.coefficients, trajectory.offsets, self._gravity,
            boxes.copy(), self._work(), self._stack(), self.ranges.copy(), True, report,
        )
        return part, report

    def _spans(self) -> FloatArray:
        """What moves between changes of piece (spans, Span, columns)."""
        pieces = len(self._trajectory.timing)
        spans = np.empty((pieces + 1, *self._stack().shape[1:]))
        count = backend.clearance_spans(
            self._trajectory.timing, self._trajectory.coefficients, self._trajectory.offsets,
            self._gravity, self._work(), spans,
        )
        return spans[:count]

    def _work(self) -> FloatArray:
        return np.zeros((RopeWork.SIZE, 4 * self._trajectory.coefficients.shape[1] - 5))

    def _stack(self) -> FloatArray:
        """Work space for halves of spans."""
        width = self._trajectory.coefficients.shape[1]
        return np.empty((Stack.ROWS, Span.SIZE, 2 * width - 3))
