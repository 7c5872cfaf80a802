"""The four ways to write a boundary problem are solved as one."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from segfmu.kernels.planner.orientation import as_asked, mirror_search, orient, reverse_search
from segfmu.kernels.planner.profile import shortest_profile
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    Passing,
    Phase,
    PlanStatus,
    PlanWork,
    Problem,
)
from tests.campaign import soaked_rows
from tests.problems import packed_axis, work_space

LIMITS = [0.9, 1.0, 2.0, 6.0, 30.0, 200.0, 0.0]
# velocities and accelerations at start and end, distance: the last four have no distance, or no
# sum of the velocities either
STATES = [
    (0.2, -0.3, 0.4, 0.1, 3.0), (0.4, 0.2, -0.1, 0.5, -2.0), (0.0, 0.0, 0.0, 0.0, -1.0),
    (0.3, 0.1, 0.2, -0.4, 0.0), (-0.3, 0.2, 0.3, 0.1, 0.0), (0.0, 0.2, 0.0, -0.3, 0.0),
    (0.3, 0.2, -0.3, 0.2, 0.0),
]
WAYS = list(product((False, True), repeat=2))


def written(state: tuple[float, ...], mirrored: bool, turned: bool) -> tuple[np.ndarray, ...]:
    """A problem in one of the four ways, and its axis, whose limits differ by direction."""
    problem = np.zeros(Problem.SIZE)
    problem[[Problem.V, Problem.A, Problem.W, Problem.B, Problem.DISTANCE]] = state
    axis = packed_axis(6, 1, LIMITS)
    axis[Axis.LOWER], axis[Axis.LOWER + 1] = 0.7, 0.8
    if mirrored:
        mirror_search(problem, axis)
    if turned:
        reverse_search(problem, axis)
    return problem, axis


@pytest.mark.parametrize("state", STATES)
def test_all_ways_are_the_same_problem_and_come_back(state: tuple[float, ...]) -> None:
    seen = []
    for way in WAYS:
        problem, axis = written(state, *way)
        asked, limits = problem.copy(), axis.copy()
        mirrored, turned = orient(problem, axis)
        seen.append(np.concatenate([problem + 0.0, axis]))
        phases, passing = np.zeros((Cell.ABOVE, Phase.SIZE)), np.zeros(Passing.SIZE)
        assert as_asked(mirrored, turned, 0, phases, problem, axis, passing) == 0
        assert np.array_equal(problem, asked) and np.array_equal(axis, limits)
    for other in seen[1:]:
        assert np.array_equal(seen[0], other)


# of the slow ones one each
KINDS = [*product((2, 3, 4), STATES[:3]), (5, STATES[0]), (6, STATES[1])]


@pytest.mark.parametrize(("n", "state"), [
    *KINDS, *soaked_rows(*(kind for kind in product((5, 6), STATES[:3]) if kind not in KINDS)),
])
def test_profiles_are_the_same_motion(n: int, state: tuple[float, ...]) -> None:
    durations = []
    for way in WAYS:
        problem, _ = written(state, *way)
        phases, work = np.zeros((Cell.ABOVE, Phase.SIZE)), work_space()
        count = shortest_profile(problem, packed_axis(n, 1, LIMITS[: n + 1]), phases, work)
        assert count > 0
        durations.append(phases[:count, Phase.DURATION].sum())
    assert np.ptp(durations) <= 1e-14 * durations[0]


@pytest.mark.parametrize("turned", [0, 1])
def test_a_reversed_refusal_is_that_of_the_other_end(turned: int) -> None:
    problem, axis = written(STATES[0], False, False)
    phases, passing = np.zeros((Cell.ABOVE, Phase.SIZE)), work_space()[PlanWork.PASSING]
    refusals = [PlanStatus.START_BRAKING, PlanStatus.END_BRAKING]
    found = [as_asked(0, turned, s, phases, problem, axis, passing) for s in refusals]
    assert found == (refusals[::-1] if turned else refusals)
