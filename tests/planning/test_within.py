"""Plans within a range of positions that profiles leave."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.position_ranges import SEED, Moving, random_problem

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan, replan, verify
from segfmu.planning.limits import NAMES
from segfmu.planning.within import NEAR, first_share

# smoothness and number of the problems of `python -m benchmarks --only y` whose profiles leave the
# range; of the shortest duration, the least one of DURATIONS for which splines keep it
CASES = [
    (2, 430, 1.01), (3, 25, 1.0005), (3, 131, 1.01), (3, 415, 2.0), (3, 437, 2.0), (4, 24, 1.0005),
    (4, 48, 1.01), (4, 74, 1.5), (4, 143, 1.01), (4, 325, 1.05), (4, 484, 1.0005),
]


def case(n: int, number: int) -> Moving:
    random = np.random.default_rng((SEED, n))
    return [random_problem(n, random) for _ in range(number + 1)][-1]


def points_of(problem: Moving, scale: float = 1.0) -> tuple[list[Waypoint], Limits]:
    rows = zip(problem.positions, problem.velocities, problem.accelerations, strict=True)
    table = abs(scale) * problem.limits.T
    limits = Limits(**dict(zip(NAMES, table, strict=False)))
    return [Waypoint(*(scale * row for row in point)) for point in rows], limits


def within(problem: Moving, scale: float = 1.0, **options: object) -> Trajectory:
    points, limits = points_of(problem, scale)
    low, high = np.sort(scale * problem.allowed, axis=0)
    return plan(
        points, limits, smoothness=problem.limits.shape[1] - 1, position_min=low,
        position_max=high, **options,
    )


@pytest.mark.parametrize(("n", "number", "share"), CASES)
def test_what_linear_programs_find_is_planned(n: int, number: int, share: float) -> None:
    problem = case(n, number)
    found = within(problem)
    assert verify(found).passed
    low, high = problem.allowed
    positions = found(np.linspace(0.0, found.duration, 20_001))
    size = (high - low).min()
    assert (positions >= low - 1e-9 * size).all() and (positions <= high + 1e-9 * size).all()
    free = problem.planned()
    assert free is not None
    shortest = free.duration
    assert shortest <= found.duration <= share * shortest


@pytest.mark.parametrize(("n", "number"), [(2, 430), (3, 415), (4, 325)])
def test_mirrored_and_in_other_units_it_is_the_same(n: int, number: int) -> None:
    problem = case(n, number)
    duration = within(problem).duration
    for scale in (-1.0, 1e-3, 300.0, 1e60):
        assert within(problem, scale).duration == pytest.approx(duration, rel=1e-9)


@pytest.mark.parametrize("synchronize", ["none", "waypoints", "total"])
def test_only_what_leaves_the_range_changes(synchronize: str) -> None:
    problem = case(4, 143)
    (first, last), limits = points_of(problem)
    low, high = problem.allowed
    # within the range from rest to the first state, and a dwell before a way that needs none
    before = Waypoint(first.position + np.array([0.0, 0.3]))
    points = [before, first, Waypoint(last.position, dwell=0.7), before]
    options = {"smoothness": 4, "synchronize": synchronize}
    free = plan(points, limits, **options)
    assert free.extrema(0)[1][0] > high[0]
    wide = np.array([low[0] - 9.0, -9.0])
    found = plan(
        points, limits, position_min=wide, position_max=[high[0], 9.0], **options
    )
    assert verify(found).passed and found.extrema(0)[1][0] <= high[0] + 1e-12
    assert found.duration == pytest.approx(free.duration, rel=1e-12)
    # an axis that need not meet the other one takes longer
    same = slice(1 if synchronize == "none" else 0, 2)
    np.testing.assert_allclose(
        found.axis_waypoint_times[:, same], free.axis_waypoint_times[:, same], rtol=1e-12
    )
    times = np.linspace(0.0, found.duration, 501)
    away = (times > found.axis_waypoint_times[2, 0]) | (times < found.axis_waypoint_times[1, 0])
    np.testing.assert_allclose(found(times)[away, same], free(times)[away, same], atol=1e-9)
    after = replan(found, 0.5 * found.duration, [Waypoint(last.position)])
    assert verify(after).passed


def test_a_longer_interval_moves_what_follows() -> None:
    problem = case(4, 74)
    (first, last), limits = points_of(problem)
    _, high = problem.allowed
    points = [first, Waypoint(last.position, dwell=0.5), Waypoint(last.position - 0.1)]
    options = {"smoothness": 4, "position_max": high, "sample_time": 0.01}
    found = plan(points, limits, **options)
    free = plan(points, limits, smoothness=4, sample_time=0.01)
    assert verify(found).passed and (found.extrema(0)[1] <= high + 1e-12).all()
    later = found.waypoint_times - free.waypoint_times
    assert later[0] == 0.0 and later[1] > 0.1 and later[2] == pytest.approx(later[1])
    assert found.duration / 0.01 == pytest.approx(round(found.duration / 0.01), abs=1e-9)
    assert found.axis_durations == pytest.approx(free.axis_durations + later[1])


@pytest.mark.parametrize(
    ("length", "time"),
    [(1e-200, 1e-20), (1e-120, 1e30), (1e120, 1e-20), (1e120, 1e40), (1e200, 1e40)],
)
def test_the_ends_of_all_scales_are_planned_or_refused(length: float, time: float) -> None:
    problem = case(4, 24)
    powers = length / time ** np.arange(problem.limits.shape[1] + 1.0)
    changed = Moving(
        length * problem.positions, powers[1] * problem.velocities,
        powers[2] * problem.accelerations, powers[1:] * problem.limits,
    )
    found = changed.planned(*changed.allowed)
    assert found is None or found.duration > 0.0


def test_a_given_duration_is_kept_or_refused() -> None:
    problem = case(4, 74)
    free = problem.planned()
    assert free is not None
    shortest = free.duration
    assert within(problem, duration=1.5 * shortest).duration == pytest.approx(1.5 * shortest)
    with pytest.raises(InfeasibleError, match=r"axis y, waypoints 1 -> 2: position reaches"):
        within(problem, duration=1.05 * shortest)


def test_what_no_motion_keeps_is_refused() -> None:
    limits = Limits(1.0, 1.0, 5.0, 50.0)
    points = [Waypoint(0.0, 0.9), Waypoint(0.1)]
    with pytest.raises(InfeasibleError, match=r"position_max is 0\.2 m"):
        plan(points, limits, position_max=0.2)
    with pytest.raises(InfeasibleError, match=r"position_min is 0\.05 m"):
        plan(points, limits, position_min=0.05)


@pytest.mark.parametrize("edge", [0.03, 0.9])
def test_the_first_duration_with_a_use_of_one_is_found(edge: float) -> None:
    def use(share: float) -> float:
        # a gap ends at the edge
        return 1.0 + (edge - share) if share < edge else 0.9

    found = first_share(use)
    assert found is not None and edge <= found <= 1.3 * edge


def test_a_window_between_two_durations_is_found() -> None:
    found = first_share(lambda share: 0.99 + abs(share - 0.06))
    assert found == pytest.approx(0.06, abs=0.011)
    assert first_share(lambda share: 1.01 + abs(share - 0.06)) is None
    assert first_share(lambda share: NEAR + 1.0 + share) is None
