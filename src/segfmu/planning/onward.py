"""From any state onward: leads and the plan behind them from one call of the kernels."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    DelayedState,
    PlanOptions,
    PlanStatus,
    PlanWork,
    Refusal,
    WaypointState,
)
from segfmu.kernels.settling.records import Done, LeadEnd, LeadRows, LeadTask, LeadWork, PlanPart
from segfmu.kernels.trajectory.records import Judging, Timing
from segfmu.planning.motion import Motion, Size, usual_rows
from segfmu.planning.pieces import Pieces
from segfmu.planning.problem import Problem
from segfmu.planning.verify import TOLERANCE

# rows of work space that is kept, and sizes of problems that it is kept for
LARGEST = 20_000
KEPT = 8


class Space:
    """Arrays for leads and the plan behind them, for problems of some size.

    size: numbers of waypoints and axes, and the smoothness. room: for so many pieces that leads
    follow.
    """

    def __init__(self, size: Size, room: int) -> None:
        points, axes, smoothness = size
        rows = LeadRows.PIECES * axes + LeadRows.ALL + room + usual_rows(size)
        self.size = size
        self.room = room
        self.states = np.zeros((2 * points, axes, LeadEnd.SIZE))
        self.axes = np.zeros((2 * axes, Axis.SIZE))
        self.cells = np.zeros(((points - 1) * axes, Cell.SIZE, Cell.COLUMNS))
        self.work = np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))
        self.work[LeadWork.JUDGING, Judging.TOLERANCE] = TOLERANCE
        self.work[LeadWork.JUDGING, Judging.JOINTS] = 0.5 * TOLERANCE
        self.timing = np.empty((PlanPart.COUNT, rows, Timing.SIZE))
        self.coefficients = np.empty((PlanPart.COUNT, rows, 2 * smoothness))
        self.offsets = np.zeros((PlanPart.COUNT, axes + 1), dtype=np.int64)

    def put(self, part: int, pieces: Pieces) -> None:
        """Copy pieces to a part."""
        used = pieces.used
        self.timing[part, :used] = pieces.timing[:used]
        self.coefficients[part, :used] = pieces.coefficients[:used]
        self.offsets[part] = pieces.offsets

    def part(self, part: int) -> tuple[FloatArray, FloatArray]:
        """Timing and coefficients of a part, with rows that are not used behind them."""
        return self.timing[part], self.coefficients[part]

    def enlarge(self) -> None:
        """Make room for all pieces of what is planned behind the leads."""
        leads = Pieces(*self.part(PlanPart.LEADS), self.offsets[PlanPart.LEADS])
        rows = self.timing.shape[1] + backend.count_pieces(self.axes[: len(self.axes) // 2],
                                                           self.cells)
        self.timing = np.empty((PlanPart.COUNT, rows, Timing.SIZE))
        self.coefficients = np.empty((PlanPart.COUNT, rows, self.coefficients.shape[2]))
        self.put(PlanPart.LEADS, leads)


# taken out while it is used, so that threads do not share it: new memory takes a tenth of a replan
_spaces: dict[Size, Space] = {}


def take_space(size: Size, pieces: int = 0) -> Space:
    """Work space of a size, with room for leads that follow so many pieces."""
    space = _spaces.pop(size, None)
    return space if space is not None and space.room >= pieces else Space(size, pieces)


def give_space(space: Space) -> None:
    """Keep work space for the next one who needs it."""
    if space.timing.shape[1] <= LARGEST and len(_spaces) < KEPT:
        _spaces[space.size] = space


def plan_onward(
    problem: Problem, start: FloatArray, follow: Pieces, *, brakes: bool
) -> tuple[Motion, int]:
    """Plan from any state; the first axis that has no lead, or -1.

    Parameters
    ----------
    problem : Problem
        All states are numbers.
    start : ndarray, shape (axes, n + 1)
        State of the first waypoint: position and the derivatives 1 .. n.
    follow : Pieces
        Plan that leads may follow.
    brakes : bool
        A state that cannot keep the limits is brought inside first; else it has no lead.
    """
    space = _space_of(problem, start, follow.used)
    space.put(PlanPart.FOLLOWED, follow)
    space.work[LeadWork.TASK, LeadTask.BRAKES] = brakes
    return _plan(space, problem, Done.NOTHING)


def plan_behind(problem: Problem, start: FloatArray, leads: Pieces, ends: FloatArray) -> Motion:
    """Plan behind given leads, which end in states (axes, DelayedState)."""
    space = _space_of(problem, start, leads.used)
    space.put(PlanPart.LEADS, leads)
    space.states[len(problem.dwells), :, : DelayedState.SIZE] = ends
    return _plan(space, problem, Done.LEADS)[0]


def _space_of(problem: Problem, start: FloatArray, pieces: int) -> Space:
    points, axes = problem.states.shape[:2]
    space = take_space((points, axes, problem.options.smoothness), pieces)
    space.states[0, :, : start.shape[1]] = start
    space.states[1:points, :, : WaypointState.SIZE] = problem.states[1:]
    space.work[LeadWork.OPTIONS, : PlanOptions.SIZE] = problem.options.vector
    space.offsets.fill(0)
    return space


def _plan(space: Space, problem: Problem, done: int) -> tuple[Motion, int]:
    points, axes = problem.states.shape[:2]
    times = np.zeros((points + 1, axes))
    status = int(PlanStatus.MORE_PIECES)
    while status == PlanStatus.MORE_PIECES:
        space.work[LeadWork.TASK, LeadTask.DONE] = done
        status = backend.plan_onward(
            space.states, problem.dwells, problem.limits, problem.lower, space.axes, space.cells,
            space.timing, space.coefficients, space.offsets.ravel(), times, space.work,
        )
        if status == PlanStatus.MORE_PIECES:
            space.enlarge()
            done = Done.PHASES
    failed = int(space.work[LeadWork.TASK, LeadTask.FAILED])
    report = None
    if status < 0 and status != PlanStatus.CHECK_FAILED:
        report = space.work[LeadWork.PLAN + PlanWork.REFUSAL, : Refusal.SIZE].copy()
    offsets = space.offsets[PlanPart.WHOLE].copy()
    timing, coefficients = space.part(PlanPart.WHOLE)
    motion = Motion(
        status, report, timing[: offsets[-1]].copy(), coefficients[: offsets[-1]].copy(), offsets,
        times,
    )
    give_space(space)
    return motion, failed


def judge_pieces(problem: Problem, states: FloatArray, pieces: Pieces, times: FloatArray) -> bool:
    """Whether the kernels prove that pieces pass states (waypoints, axes, 3 or more) at times.

    At first they may be outside the limits, while a state is brought inside.
    """
    size = 2, problem.states.shape[1], problem.options.smoothness
    space = take_space(size)
    proved = backend.judge_pieces(
        states, times, pieces.timing, pieces.coefficients, pieces.offsets, problem.limits,
        problem.lower, space.axes[size[1] :], space.work, *space.part(PlanPart.BEHIND),
    )
    give_space(space)
    return proved
