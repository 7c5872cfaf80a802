"""A whole plan from one call of the kernels, in work space that is used again."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import Axis, Cell, PlanOptions, PlanStatus, PlanWork, Refusal
from segfmu.kernels.trajectory.records import Judging, MotionWork, Spare, Timing
from segfmu.planning.problem import Options, Problem
from segfmu.planning.verify import TOLERANCE

# ramps of an axis in an interval whose pieces there are rows for at first
USUAL_RAMPS = 12
# sizes of problems whose work space is kept, and the largest of them
KEPT = 8
LARGEST = 64

# numbers of waypoints and axes, and the smoothness
Size = tuple[int, int, int]


def usual_rows(size: Size) -> int:
    """Rows for the pieces of most plans of a size."""
    points, axes, smoothness = size
    pieces = int(2 ** (smoothness - 1) - 1)
    return Spare.ROWS + USUAL_RAMPS * pieces * (points - 1) * axes


class Motion(NamedTuple):
    """Results of the kernel `plan_motion` (kernels/trajectory/motion.py).

    Attributes
    ----------
    status : int
        Of PlanStatus.
    refusal : ndarray, shape (Refusal,), optional
        Where and why there is no plan.
    timing : ndarray, shape (pieces, 2)
    coefficients : ndarray, shape (pieces, 2 * smoothness)
    offsets : ndarray of int, shape (axes + 1,)
    times : ndarray, shape (waypoints + 1, axes)
    """

    status: int
    refusal: FloatArray | None
    timing: FloatArray
    coefficients: FloatArray
    offsets: NDArray[np.int64]
    times: FloatArray


class Space:
    """Arrays in which a problem of some size is planned."""

    def __init__(self, size: Size) -> None:
        points, axes, smoothness = size
        cells = (points - 1) * axes
        rows = usual_rows(size)
        self.size = size
        self.axes = np.zeros((axes, Axis.SIZE))
        self.cells = np.zeros((cells, Cell.SIZE, Cell.COLUMNS))
        self.work = np.zeros((MotionWork.SIZE, MotionWork.COLUMNS))
        self.chosen: Options | None = None
        self.options = self.work[MotionWork.OPTIONS, : PlanOptions.SIZE]
        self.work[MotionWork.JUDGING, Judging.TOLERANCE] = TOLERANCE
        self.work[MotionWork.JUDGING, Judging.JOINTS] = 0.5 * TOLERANCE
        self.refusal = self.work[MotionWork.PLAN + PlanWork.REFUSAL, : Refusal.SIZE]
        self.timing = np.empty((rows, Timing.SIZE))
        self.coefficients = np.empty((rows, 2 * smoothness))

    def enlarge(self) -> None:
        """Make room for all pieces of what is planned."""
        rows = backend.count_pieces(self.axes, self.cells)
        self.timing = np.empty((rows, Timing.SIZE))
        self.coefficients = np.empty((rows, self.coefficients.shape[1]))


# taken out while it is used, so that threads do not share it
_spaces: dict[Size, Space] = {}


def plan_motion(problem: Problem) -> Motion:
    """Plan, expand and check a problem whose states are numbers."""
    points, axes = problem.states.shape[:2]
    size = points, axes, problem.options.smoothness
    space = _spaces.pop(size, None) or Space(size)
    if space.chosen is not problem.options:
        space.chosen = problem.options
        space.options[:] = problem.options.vector
    offsets, times = np.zeros(axes + 1, dtype=np.int64), np.zeros((points + 1, axes))
    call = problem.states, problem.dwells, problem.limits, problem.lower, space.axes, space.cells
    found = offsets, times, space.work
    status = backend.plan_motion(*call, space.timing, space.coefficients, *found)
    if status == PlanStatus.MORE_PIECES:
        space.enlarge()
        status = backend.expand_motion(*call, space.timing, space.coefficients, *found)
    used = int(offsets[-1])
    report = None
    if status < 0 and status != PlanStatus.CHECK_FAILED:
        report = space.refusal.copy()
    motion = Motion(
        status, report, space.timing[:used].copy(), space.coefficients[:used].copy(), offsets, times
    )
    if points * axes <= LARGEST and len(_spaces) < KEPT:
        _spaces[size] = space
    return motion
