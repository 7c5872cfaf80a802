"""Passing profiles that were found before are slowed down without another search."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels import backend
from segfmu.kernels.planner.records import Cell, Interval, Nearest, Phase, PlanWork, Problem, Repeat
from tests.problems import AxisProblem, work_space

LIMITS = (1.0, 0.8, 2.0, 8.0, 60.0, 400.0)
# v, a, w, b, distance: none of them is slowed down by its ramps alone
STATES = [
    (0.12, -0.03, 0.4, 0.31, 0.21), (0.05, -0.09, -0.2, -0.2, -0.05),
    (0.05, 0.27, 0.1, -0.32, 0.12), (-0.18, 0.17, 0.38, 0.42, 0.07),
]
FACTORS = (1.01, 1.03, 1.05)
PLACES = PlanWork.SEARCHED_AXES - PlanWork.SEARCHES


def asked(state: tuple[float, ...], n: int) -> tuple[np.ndarray, np.ndarray, float]:
    """Axis, cell and shortest duration [s] of a problem whose shortest profile is passing."""
    v, a, w, b, distance = state
    problem = AxisProblem(n, 1, LIMITS[: n + 1], v, a, w, b, distance)
    cell = np.zeros((Cell.SIZE, Cell.COLUMNS))
    cell[Cell.PROBLEM, : Problem.SIZE] = problem.boundary()
    count, phases = problem.shortest()
    assert count > 0
    shortest = float(phases[:, Phase.DURATION].sum())
    cell[Cell.RESULT, Interval.SHORTEST] = shortest
    cell[Cell.RESULT, Interval.PASSING] = 1.0
    return problem.axis(), cell, shortest


def timed(target: float, axis: np.ndarray, cell: np.ndarray, work: np.ndarray) -> np.ndarray:
    """The profile of a duration [s]."""
    assert backend.timed_profile(target, axis, cell, work) == 0.0
    count = int(work[PlanWork.NEAREST, Nearest.BELOW_COUNT])
    phases = cell[Cell.BELOW : Cell.BELOW + count, : Phase.SIZE].copy()
    assert phases[:, Phase.ABOVE].any()
    return phases


def searches(work: np.ndarray) -> np.ndarray:
    """Problems of the searches that are kept."""
    rows = work[PlanWork.SEARCHES : PlanWork.SEARCHED_AXES]
    return rows[rows[:, Repeat.USED] > 0.0, : Repeat.USED]


@pytest.mark.parametrize("n", [4, 5])
def test_profiles_are_the_same_with_searches_made_before(n: int) -> None:
    work = work_space()
    for _ in range(2):
        for state in STATES:
            axis, cell, shortest = asked(state, n)
            for factor in FACTORS:
                found = timed(factor * shortest, axis, cell, work)
                fresh = timed(factor * shortest, axis, cell, work_space())
                assert np.array_equal(found, fresh)


def test_further_durations_make_no_search() -> None:
    axis, cell, shortest = asked(STATES[0], 4)
    work = work_space()
    timed(FACTORS[0] * shortest, axis, cell, work)
    made = searches(work)
    assert len(made) == 1
    for factor in FACTORS:
        timed(factor * shortest, axis, cell, work)
    assert np.array_equal(searches(work), made)


def test_a_motion_mirrored_and_reversed_makes_no_search() -> None:
    v, a, w, b, distance = STATES[0]
    work = work_space()
    for state in (STATES[0], (-v, -a, -w, -b, -distance), (w, -b, v, -a, distance)):
        axis, cell, shortest = asked(state, 4)
        found = timed(FACTORS[1] * shortest, axis, cell, work)
        fresh = timed(FACTORS[1] * shortest, axis, cell, work_space())
        assert np.array_equal(found, fresh)
    assert len(searches(work)) == 1


def test_the_search_that_was_not_used_for_longest_is_replaced() -> None:
    work = work_space()
    axis, cell, shortest = asked(STATES[0], 4)
    for i in range(2 * PLACES):
        problem = np.array([0.1, 0.0, 0.2, 0.0, 1.0 + i, 0.0])
        backend.shortest_profile(problem, axis, np.zeros((Cell.ABOVE, Phase.SIZE)), work)
        timed(FACTORS[0] * shortest, axis, cell, work)
    kept = searches(work)
    assert len(kept) == PLACES
    # that of the motion that is slowed down is kept, and the last ones of the others
    assert sorted(kept[:, Problem.DISTANCE])[1:] == [PLACES + 2.0 + i for i in range(PLACES - 1)]
