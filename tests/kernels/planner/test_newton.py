"""The derivatives of a sequence's residuals, against differences of whole runs."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.planner.instant import add_instant
from segfmu.kernels.planner.newton import newton_step
from segfmu.kernels.planner.plateaus import insert_node
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import (
    Cell,
    Equations,
    Node,
    Passing,
    Phase,
    PlanWork,
    Problem,
)
from segfmu.kernels.planner.sequence import is_square, run_sequence
from segfmu.kernels.planner.starts import set_sequence
from tests.problems import packed_axis, work_space


def residuals(problem: np.ndarray, axis: np.ndarray, work: np.ndarray, count: int) -> np.ndarray:
    run_sequence(
        problem, work[PlanWork.PASSING], axis, work[PlanWork.NODES : PlanWork.KEPT],
        work[PlanWork.RESIDUAL],
    )
    return work[PlanWork.RESIDUAL, Equations.VALUES :][:count].copy()


@pytest.mark.parametrize("timed", [False, True])
@pytest.mark.parametrize(("n", "instant"), [(4, 0), (5, 0), (6, 0), (6, 1), (6, 2)])
def test_derivatives_are_those_of_differences(n: int, timed: bool, instant: int) -> None:
    axis = packed_axis(n, 1, [0.9, 1.0, 2.0, 6.0, 30.0, 200.0, 0.0][: n + 1])
    problem = np.zeros(Problem.SIZE)
    problem[[Problem.V, Problem.A, Problem.W, Problem.DISTANCE]] = 0.2, -0.3, 0.4, 3.0
    phases, work = np.zeros((Cell.ABOVE, Phase.SIZE)), work_space()
    # ramps, of which a sequence is made, are those of smoothness 3
    count = shortest_profile(problem, packed_axis(3, 1, [0.9, 1.0, 2.0, 0.0]), phases, work)
    assert count > 0 and set_sequence(0, count, phases, problem, axis, work)
    passing = work[PlanWork.PASSING]
    if instant:
        # one level more, and one derivative that reaches its limit near it
        insert_node(1, 0, -work[PlanWork.NODES, Node.SIGN], 0.3, False, work)
        add_instant(instant, 1.0, 1, passing)
    assert is_square(passing, work[PlanWork.NODES : PlanWork.KEPT])
    if timed:
        passing[Passing.TARGET], passing[Passing.PACE] = 1.1 * passing[Passing.TIME], 0.95
    nodes = int(passing[Passing.COUNT])
    unknowns = nodes + timed

    def moved(column: int, change: float) -> np.ndarray:
        if column == nodes:
            place, field = work[PlanWork.PASSING], Passing.PACE
        else:
            place, field = work[PlanWork.NODES + column], Node.TIME
        kept = place[field]
        place[field] = kept + change
        found = residuals(problem, axis, work, unknowns)
        place[field] = kept
        return found

    expected = np.array([
        (moved(i, 1e-6) - moved(i, -1e-6)) / 2e-6 for i in range(unknowns)
    ]).T
    right = residuals(problem, axis, work, unknowns)
    newton_step(unknowns, problem, axis, work)
    step = work[PlanWork.STEP : PlanWork.STEP + unknowns, 0]
    scale = np.abs(expected).max() * np.abs(step).max()
    assert np.abs(expected @ step + right).max() < 1e-5 * scale
