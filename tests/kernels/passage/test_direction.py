"""A mission and its reverse have the same free states."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.free_missions import missions

from segfmu import Limits, Trajectory, Waypoint, plan
from segfmu.kernels.passage.direction import reverse_places, reverse_spots, runs_backwards
from segfmu.kernels.passage.records import Spot
from segfmu.kernels.planner.records import WaypointState
from segfmu.planning.limits import NAMES

MISSIONS = list(missions(6, (4, 7), 8))


def planned(points: np.ndarray, ends: np.ndarray, limits: np.ndarray, back: float) -> Trajectory:
    """Plan through points (m, k) with velocities at both ends (2, k), free in between.

    back: of its limit, that of the velocity in the negative direction.
    """
    inner = [Waypoint(point, "free", "free") for point in points[1:-1]]
    given = [Waypoint(points[0], ends[0]), *inner, Waypoint(points[-1], ends[1])]
    bounds = dict(zip(NAMES, limits.T, strict=False))
    return plan(given, Limits(**bounds, velocity_min=-back * limits[:, 0]), smoothness=4)


@pytest.mark.parametrize("number", range(6))
def test_free_states_of_the_reverse_are_the_same(number: int) -> None:
    mission = MISSIONS[number]
    limits = mission.limits
    ends = 0.3 * np.random.default_rng(number).uniform(-1.0, 1.0, (2, limits.shape[0]))
    ends = ends * limits[:, 0] * (number % 2)
    forth = planned(mission.positions, ends, limits, 0.7)
    # run back along the mirrored path: velocities stay
    back = planned(-mission.positions[::-1], ends[::-1], limits, 0.7)
    assert back.duration == pytest.approx(forth.duration, rel=1e-9)
    for one, other in zip(forth.waypoints, back.waypoints[::-1], strict=True):
        np.testing.assert_allclose(one.velocity, other.velocity, rtol=1e-9, atol=0.0)
        np.testing.assert_allclose(one.acceleration, -other.acceleration, rtol=1e-9, atol=0.0)


def test_one_of_both_directions_is_backwards() -> None:
    random = np.random.default_rng(3)
    for places in range(2, 7):
        choice, spots = random.uniform(-1.0, 1.0, (places, 2, WaypointState.SIZE)), no_spots(places)
        choice[0, :, WaypointState.POSITION] = 0.0
        found = [runs_backwards(places, choice, spots)]
        reverse_places(places, choice)
        found.append(runs_backwards(places, choice, spots))
        assert sorted(found) == [False, True]


def test_free_states_decide_where_steps_do_not() -> None:
    choice, spots = np.zeros((4, 1, WaypointState.SIZE)), no_spots(4, 1)
    choice[:, 0, WaypointState.POSITION] = 0.0, 1.0, 2.0, 3.0
    assert not runs_backwards(4, choice, spots)
    spots[2, Spot.FREE, 0] = 1.0
    assert runs_backwards(4, choice, spots)
    reverse_spots(4, 1, spots)
    assert spots[1, Spot.FREE, 0] == 1.0 and spots[2, Spot.FREE, 0] == 0.0
    assert not runs_backwards(4, choice, spots)


def test_twice_reversed_is_as_before() -> None:
    random = np.random.default_rng(5)
    choice = random.integers(-9, 10, (5, 3, WaypointState.SIZE)) / 8.0
    choice[0, :, WaypointState.POSITION] = 0.0
    kept = choice.copy()
    reverse_places(5, choice)
    assert not np.array_equal(choice, kept)
    reverse_places(5, choice)
    np.testing.assert_array_equal(choice, kept)


def no_spots(places: int, axes: int = 2) -> np.ndarray:
    return np.zeros((places * axes, Spot.SIZE, Spot.COLUMNS))
