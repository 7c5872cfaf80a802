"""Axes that have time stay near their path; ranges of positions are kept."""

import numpy as np
import pytest
from benchmarks.position_ranges import random_problem

from segfmu import InfeasibleError, Limits, Waypoint, plan, stop, verify
from segfmu.planning.limits import NAMES


def test_a_motion_that_has_time_does_not_swing_past_its_target() -> None:
    points = [Waypoint(0.0, 0.409), Waypoint(0.338, 0.089)]
    limits = Limits(0.8, 0.8, 3.0, 15.0)
    found = plan(points, limits, duration=4.338, position_min=0.0, position_max=0.374)
    assert verify(found).passed
    # motions within the waypoints exist: it stops in between
    assert found.extrema(0)[0][0] >= 0.0 and found.extrema(0)[1][0] <= 0.338 * (1.0 + 1e-9)


@pytest.mark.parametrize("n", [2, 3])
@pytest.mark.parametrize("seed", range(12))
def test_an_axis_that_has_time_goes_no_farther_than_to_stop(n: int, seed: int) -> None:
    random = np.random.default_rng((n, seed))
    problem = random_problem(n, random)
    limits = Limits(**dict(zip(NAMES, problem.limits.T, strict=False)))
    rows = list(zip(problem.positions, problem.velocities, problem.accelerations, strict=True))
    points = [Waypoint(*row) for row in rows]
    try:
        shortest = plan(points, limits, smoothness=n)
    except InfeasibleError:
        # a state that cannot be braked
        return
    (p, v, a), (q, w, b) = rows
    # the last state reversed in time stops where a motion to it can begin from rest
    first = stop(Waypoint(p, v, a), limits=limits, smoothness=n).extrema(0)
    last = stop(Waypoint(-q, w, -b), limits=limits, smoothness=n).extrema(0)
    low, high = np.minimum(first[0], -last[1]), np.maximum(first[1], -last[0])
    small = 1e-6 * (high - low)
    for longer in (2.0, 5.0):
        found = plan(points, limits, smoothness=n, duration=longer * shortest.duration)
        assert verify(found).passed
        assert (found.extrema(0)[0] >= low - small).all()
        assert (found.extrema(0)[1] <= high + small).all()


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_an_axis_with_an_end_at_rest_goes_no_farther_than_its_shortest_profile(n: int) -> None:
    random = np.random.default_rng(n)
    turned = straight = slow = 0
    for _ in range(60):
        problem = random_problem(n, random)
        still = random.integers(2)
        velocities, accelerations = problem.velocities[:, 0], problem.accelerations[:, 0]
        velocities[still] = accelerations[still] = 0.0
        limits = Limits(**dict(zip(NAMES, problem.limits[0], strict=False)))
        rows = zip(problem.positions[:, 0], velocities, accelerations, strict=True)
        points = [Waypoint(*row) for row in rows]
        try:
            shortest = plan(points, limits, smoothness=n)
        except InfeasibleError:
            # a state that cannot be braked
            continue
        low, high = (float(edge[0]) for edge in shortest.extrema(0))
        if np.ptp(problem.positions[:, 0]) >= (high - low) * (1.0 - 1e-9):
            # it goes there straight on, and slowly unless its first acceleration makes it fast
            found = plan(points, limits, smoothness=n, duration=3.0 * shortest.duration)
            fastest = [np.abs(motion.extrema(1)).max() for motion in (found, shortest)]
            straight += 1
            slow += fastest[0] <= max(0.7 * fastest[1], np.abs(velocities).max() * (1.0 + 1e-9))
            continue
        turned += 1
        for longer in (1.0 + 1e-6, 1.1, 3.0):
            found = plan(points, limits, smoothness=n, duration=longer * shortest.duration)
            assert verify(found).passed
            assert found.extrema(0)[0][0] >= low - 0.01 * (high - low)
            assert found.extrema(0)[1][0] <= high + 0.01 * (high - low)
    assert turned > 10 and slow > 0.8 * straight > 8
