"""From a request without free states to its trajectory."""

from __future__ import annotations

import numpy as np

from segfmu.kernels import backend
from segfmu.kernels.trajectory.records import Check, Expansion, Timing
from segfmu.planning.messages import refusal
from segfmu.planning.problem import Phases, plan_phases
from segfmu.planning.request import Request
from segfmu.planning.trajectory import Trajectory


def solve(request: Request, tolerance: float) -> tuple[Trajectory, bool]:
    """Plan and expand a trajectory; True if the kernels prove that it keeps the tolerance.

    Raises
    ------
    InfeasibleError
        If no plan keeps the limits.
    """
    problem = request.problem
    phases = plan_phases(problem)
    if not phases.feasible:
        raise refusal(
            phases.status, phases.refusal, request.axis_names
        )
    return _expand(request, phases, tolerance)


def _expand(
    request: Request, phases: Phases, tolerance: float
) -> tuple[Trajectory, bool]:
    problem = request.problem
    points, axes = problem.states.shape[:2]
    rows = backend.count_pieces(phases.axes, phases.cells)
    timing = np.empty((rows, Timing.SIZE))
    coefficients = np.empty((rows, 2 * problem.options.smoothness))
    offsets = np.zeros(axes + 1, dtype=np.int64)
    times = np.zeros((points + 1, axes))
    used = backend.expand_plan(
        problem.states, problem.dwells, phases.axes, phases.cells, timing, coefficients, offsets,
        times, np.empty((Expansion.SIZE, Expansion.COLUMNS)),
    )
    wrong = backend.check_plan(
        problem.states, times, timing, coefficients, offsets, problem.limits, tolerance,
        np.empty((Check.SIZE, Check.COLUMNS)),
    )
    for array in (timing, coefficients, offsets, times):
        array.flags.writeable = False
    trajectory = Trajectory(
        request.waypoints, request.limits, problem.options.smoothness, problem.options.shape,
        problem.options.synchronize, request.axis_names, timing[:used], coefficients[:used],
        offsets, times[:-1], times[-1],
    )
    return trajectory, wrong == 0
