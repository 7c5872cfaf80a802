"""Boundary problems biased to the places where planners break: zeros, ties and limits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from hypothesis import strategies as st

from segfmu.kernels import backend
from segfmu.kernels.planner.parameters import axis_limits, ramp_parameters, usual_share
from segfmu.kernels.planner.phases import measure_phases
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Interval,
    Phase,
    PlanStatus,
    PlanWork,
    Problem,
)
from segfmu.kernels.trajectory.pieces import expand_phases
from segfmu.kernels.trajectory.records import Expansion, PieceState, Timing
from segfmu.planning.polynomials import derivative_pieces, piece_extrema
from segfmu.planning.problem import Problem as PlanProblem
from segfmu.planning.problem import options
from segfmu.planning.trajectory import Trajectory


def work_space() -> np.ndarray:
    """The planner's work space."""
    return np.zeros((PlanWork.SIZE, PlanWork.COLUMNS))


def packed_axis(smoothness: int, shape: int, limits: tuple[float, ...] | list[float]) -> np.ndarray:
    """Limits and ramp parameters of an axis (Axis)."""
    axis = np.zeros(Axis.SIZE)
    axis_limits(smoothness, shape, np.array(limits), axis)
    assert ramp_parameters(usual_share(axis), axis, work_space())
    return axis


def planned_cells(problem: PlanProblem) -> tuple[np.ndarray, np.ndarray]:
    """The axes (axes, Axis) and cells (intervals * axes, Cell, ..) of a problem with a plan."""
    points, count = problem.states.shape[:2]
    axes = np.zeros((count, Axis.SIZE))
    cells = np.zeros(((points - 1) * count, Cell.SIZE, Cell.COLUMNS))
    assert backend.plan_phases(
        problem.states, problem.dwells, problem.limits, problem.lower, problem.options.vector,
        axes, cells, work_space(),
    ) == PlanStatus.PLANNED
    return axes, cells


def shortest_duration(trajectory: Trajectory) -> float:
    """Duration [s] of the shortest profile found for one axis in one interval.

    A plan with steeper rises than the usual ones may last longer.
    """
    smoothness = trajectory.smoothness
    problem = PlanProblem(
        np.array([point.planned for point in trajectory.waypoints]), np.zeros(2),
        trajectory.limits.table(1, smoothness), trajectory.limits.lower(1),
        options(smoothness, trajectory.shape, trajectory.synchronize, 0.0, 0.0),
    )
    _, cells = planned_cells(problem)
    assert len(cells) == 1
    return float(cells[0, Cell.RESULT, Interval.SHORTEST])


@dataclass(frozen=True)
class AxisProblem:
    """One axis: (0, v, a) -> (distance, w, b) with limits c_1 .. c_{n+1}, 0 where absent."""

    smoothness: int
    shape: int
    limits: tuple[float, ...]
    v: float
    a: float
    w: float
    b: float
    distance: float

    def axis(self) -> np.ndarray:
        """Limits and ramp parameters (Axis)."""
        return packed_axis(self.smoothness, self.shape, self.limits)

    def boundary(self) -> np.ndarray:
        """The boundary problem (Problem)."""
        problem = np.zeros(Problem.SIZE)
        problem[Problem.V], problem[Problem.A] = self.v, self.a
        problem[Problem.W], problem[Problem.B] = self.w, self.b
        problem[Problem.DISTANCE] = self.distance
        return problem

    def shortest(self) -> tuple[int, np.ndarray]:
        """Number of phases, or the status, of the shortest profile, and its phases."""
        phases = np.zeros((Cell.ABOVE, Phase.SIZE))
        count = shortest_profile(self.boundary(), self.axis(), phases, work_space())
        return count, phases[: max(count, 0)]

    def measured(self, phases: np.ndarray) -> tuple[float, float, float, float, float]:
        """Duration, distance, end velocity, lowest and highest velocity of phases."""
        if not phases[:, Phase.ABOVE].any():
            return measure_phases(phases, len(phases), self.v, 0.0, self.axis())
        work = np.zeros((Expansion.SIZE, Expansion.COLUMNS))
        end = work[Expansion.STATE]
        end[PieceState.VELOCITY], end[PieceState.ACCELERATION] = self.v, self.a
        rows = 31 * len(phases)
        timing, pieces = np.zeros((rows, Timing.SIZE)), np.zeros((rows, 2 * self.smoothness))
        used = expand_phases(phases, len(phases), self.axis(), timing, pieces, 0, work)
        velocities = derivative_pieces(pieces[:used], 1)
        extremes = [
            piece_extrema(row, length)
            for row, length in zip(velocities, timing[:used, Timing.LENGTH], strict=True)
        ]
        lowest, highest = min(low for low, _ in extremes), max(high for _, high in extremes)
        return float(timing[:used, Timing.LENGTH].sum()), end[0], end[1], lowest, highest


def degenerate_share(draw: st.DrawFn) -> float:
    """A number in [-1, 1] with a taste for 0, +-1, quarters and tiny values."""
    kind = draw(st.integers(0, 5))
    if kind == 0:
        return 0.0
    if kind == 1:
        return draw(st.sampled_from([-1.0, 1.0]))
    if kind == 2:
        return draw(st.integers(-4, 4)) / 4.0
    if kind == 3:
        return draw(st.sampled_from([-1.0, 1.0])) * 10.0 ** draw(st.integers(-12, -1))
    return draw(st.floats(-1.0, 1.0))


@st.composite
def axis_problems(draw: st.DrawFn, smoothness: int | None = None) -> AxisProblem:
    """Problems of every smoothness and shape, boundary states within the limits."""
    n = smoothness or draw(st.integers(2, 6))
    limits = [
        draw(st.sampled_from([0.5, 1.0, 2.0]) | st.floats(0.03, 30.0)) for _ in range(n)
    ]
    limits.append(draw(st.sampled_from([1.0, 10.0])) if n == 2 else 0.0)
    for i in range(2, n):
        if draw(st.integers(0, 5)) == 0 and any(limits[j] for j in range(2, n + 1) if j != i):
            limits[i] = 0.0
    v, w = (degenerate_share(draw) * limits[0] for _ in range(2))
    a, b = (degenerate_share(draw) * limits[1] for _ in range(2))
    tie = draw(st.integers(0, 7))
    if tie == 0:
        w = v
    elif tie == 1:
        b = a
    elif tie == 2:
        b = -a
    distance = degenerate_share(draw) * 10.0 ** draw(st.integers(-3, 2))
    return AxisProblem(n, draw(st.integers(0, 1)), tuple(limits), v, a, w, b, distance)
