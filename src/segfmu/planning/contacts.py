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

    def is_near(self, boxes: FloatArray) -> bool:
        """Whether load or rope may meet one of the boxes (boxes, Box), from their ranges alone."""
        return bool(backend.is_any_near(boxes, self.ranges))

    def times(self, part: int, box: FloatArray) -> FloatArray:
        """Intervals [s] in which a part (Part) meets a box (Box), shape (intervals, 2)."""
        spans, stack, rows = *self._spans(), USUAL_CONTACTS
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
        spans, stack = self._spans()
        report = np.zeros(Collision.SIZE)
        part = backend.first_contact(
            len(spans), boxes, spans, stack, np.empty((1, 2)), self.ranges.copy(), report
        )
        return part, report

    def _spans(self) -> tuple[FloatArray, FloatArray]:
        """What moves between changes of piece (spans, Span, columns), and work space for halves."""
        pieces, width = self._trajectory.coefficients.shape
        columns = 2 * width - 3
        spans = np.empty((pieces + 1, Span.SIZE, columns))
        count = backend.clearance_spans(
            self._trajectory.timing, self._trajectory.coefficients, self._trajectory.offsets,
            self._gravity, np.zeros((RopeWork.SIZE, 4 * width - 5)), spans,
        )
        return spans[:count], np.empty((Stack.ROWS, Span.SIZE, columns))
