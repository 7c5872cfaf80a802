"""Profiles of prescribed duration: durations, distances and limits."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from segfmu import Limits, Waypoint, plan, verify
from segfmu.kernels.planner.intervals import round_up
from segfmu.kernels.planner.phases import stretch_phases
from segfmu.kernels.planner.records import Cell, Nearest, Phase, PlanWork, Problem
from segfmu.kernels.planner.synchronize import timed_profile
from tests.campaign import SOAK, campaign
from tests.problems import AxisProblem, axis_problems, work_space


def timed(problem: AxisProblem, target: float):
    """Weight of the mean (-1: infeasible), and duration, distance and velocities of both parts."""
    cell, work = np.zeros((Cell.SIZE, Cell.COLUMNS)), work_space()
    cell[Cell.PROBLEM, : Problem.SIZE] = problem.boundary()
    weight = timed_profile(target, problem.axis(), cell, work)
    below, above = work[PlanWork.NEAREST, [Nearest.BELOW_COUNT, Nearest.ABOVE_COUNT]].astype(int)
    parts = [
        problem.measured(cell[Cell.BELOW :][:below]), problem.measured(cell[Cell.ABOVE :][:above])
    ]
    return weight, parts


def shortest(problem: AxisProblem) -> float:
    count, phases = problem.shortest()
    return -1.0 if count < 0 else float(phases[:, Phase.DURATION].sum())


@pytest.mark.soak
@settings(max_examples=60 if SOAK else 25, deadline=None)
@given(axis_problems(), st.sampled_from([1.0001, 1.1, 1.5, 3.0, 20.0]))
def test_mean_of_two_profiles_meets_the_boundary(problem: AxisProblem, factor: float) -> None:
    least = shortest(problem)
    if least <= 0.0:
        return
    target = least * factor
    weight, parts = timed(problem, target)
    if weight < 0.0:
        return
    assert 0.0 <= weight <= 1.0
    distance = 0.0
    for share, (duration, y, end, lowest, highest) in zip(
        (1.0 - weight, weight), parts, strict=True
    ):
        distance += share * y
        if share > 0.0:
            assert duration == pytest.approx(target, rel=1e-9)
            assert end == pytest.approx(problem.w, abs=1e-9 * problem.limits[0])
            assert max(-lowest, highest) <= problem.limits[0] * (1.0 + 1e-9)
    reach = abs(problem.distance) + problem.limits[0] * target
    assert abs(distance - problem.distance) <= 1e-9 * reach


def test_long_durations_are_always_feasible() -> None:
    problem = AxisProblem(4, 1, (1.0, 1.0, 2.0, 10.0, 0.0), 0.5, 0.2, -0.3, 0.1, 0.4)
    for target in (20.0, 50.0, 1000.0):
        assert timed(problem, target)[0] >= 0.0


def test_gap_of_errata_e10() -> None:
    """Two moving points, 0.3 m apart at 0.5 m/s: about 0.6 s, or more than 2.8 s."""
    problem = AxisProblem(4, 1, (1.0, 1.0, 2.0, 10.0, 0.0), 0.5, 0.0, 0.5, 0.0, 0.3)
    tried = [*np.arange(0.58, 0.8, 0.02), *np.arange(0.8, 4.0, 0.2)]
    feasible = [t for t in tried if timed(problem, t)[0] >= 0.0]
    assert min(feasible) < 0.62
    assert not [t for t in feasible if 0.8 < t < 2.8]
    assert [t for t in feasible if t > 3.3] == [t for t in tried if t > 3.3]


def test_stretching_keeps_the_distance() -> None:
    problem = AxisProblem(5, 1, (1.0, 1.0, 2.0, 10.0, 90.0, 0.0), 0.0, 0.0, 0.0, 0.0, 0.7)
    count, phases = problem.shortest()
    before = problem.measured(phases)
    stretch_phases(phases, count, 2.5)
    after = problem.measured(phases)
    assert after[0] == pytest.approx(2.5 * before[0])
    assert after[1] == pytest.approx(0.7)
    assert after[4] == pytest.approx(before[4] / 2.5)


@pytest.mark.parametrize(
    "problem",
    [
        AxisProblem(
            6, 1, (0.77214, 2.88543, 1.94765, 0.72618, 0.47188, 0.60954, 0.0),
            -0.06119, -0.32268, 0.43414, 0.0, -0.45489,
        ),
        AxisProblem(
            6, 1, (0.38853, 0.55953, 3.32279, 0.67355, 0.60386, 0.23595, 0.0),
            0.0, 0.16786, -0.04133, 0.08784, 0.48107,
        ),
    ],
)
@campaign(16, 80)
def test_no_duration_is_lost_where_few_levels_keep_the_velocity_limit(
    problem: AxisProblem, count: int
) -> None:
    # a level has to be low enough for the limit and high enough for the duration
    least = shortest(problem)
    for target in np.linspace(1.001, 1.6, count) * least:
        assert timed(problem, float(target))[0] >= 0.0, target


def test_an_axis_that_has_nothing_to_do_may_move() -> None:
    points = [Waypoint([0.0, 0.0], [0.5, 0.5]), Waypoint([0.0, 1.0], [0.5, 0.5])]
    trajectory = plan(points, Limits(1.0, 1.0, 4.0, 20.0), synchronize="none")
    assert trajectory.axis_durations[0] == 0.0
    assert trajectory(0.0, 1).tolist() == [0.5, 0.5]


def test_time_goes_to_the_intervals_that_can_take_it() -> None:
    # in proportion, the first interval of y would come to lie in a gap
    found = 0
    random = np.random.default_rng(1)
    for _ in range(25):
        steps = np.cumsum(random.uniform(-0.5, 1.5, (4, 2)), 0)
        points = [Waypoint(steps[0])]
        for p in steps[1:-1]:
            points.append(Waypoint(p, random.uniform(-0.6, 0.6, 2), random.uniform(-0.5, 0.5, 2)))
        points.append(Waypoint(steps[-1]))
        trajectory = plan(points, Limits(1.0, 1.0, 4.0, 20.0), synchronize="total")
        assert np.ptp(trajectory.axis_durations) <= 1e-9 * trajectory.duration
        found += int(np.ptp(trajectory.axis_waypoint_times[1]) > 1e-6)
    assert found > 20


def test_a_prolonged_cruise_has_slower_ramps() -> None:
    points = [Waypoint([0.0], [0.2], [0.05]), Waypoint([1.0], [0.1], [-0.05])]
    limits = Limits(1.0, 1.0, 4.0, 20.0)
    shortest = plan(points, limits)
    slower = plan(points, limits, duration=1.5 * shortest.duration)
    assert verify(slower).passed
    # a ramp that is stretched by f has f^-4 of its snap
    assert np.abs(slower.extrema(4)).max() < 0.5 * np.abs(shortest.extrema(4)).max()


@pytest.mark.parametrize(("duration", "sample_time", "expected"), [
    (2.34, 0.1, 2.4), (2.4, 0.1, 2.4), (4e301, 1e-3, 4e301), (1e308, 1e-9, 1e308),
])
def test_a_duration_of_any_size_is_rounded_up(
    duration: float, sample_time: float, expected: float
) -> None:
    """Beyond all integers of the machine it stays what it is."""
    assert round_up(duration, sample_time) == pytest.approx(expected, rel=1e-15)


def test_rounding_of_a_duration_decides_nothing() -> None:
    """Of two profiles beside the distance one is enough; the other one turned back, or did not."""
    points = [
        Waypoint([0.4462425236693913], [0.0], [0.0]), Waypoint([2.5233248320848953], [0.33001178])
    ]
    limits = Limits(1.09594855, 0.31671211, 0.14422336, 0.1055181)
    peaks = [
        plan(points, limits, duration=13.866594439403634 * (1.0 + k * 1e-14)).extrema(2)[1][0]
        for k in range(-10, 11)
    ]
    assert np.ptp(peaks) < 1e-6 * max(peaks)
