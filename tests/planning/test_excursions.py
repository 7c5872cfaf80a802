"""Excursions: each is that of samples, and the first one is found among all."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, excursions, plan
from segfmu.planning.excursions import excursion, first_excursion


def moves(count: int) -> list[Trajectory]:
    random = np.random.default_rng(7)
    found = []
    while len(found) < count:
        size = 10.0 ** random.uniform(-1.0, 2.0)
        places = np.cumsum(random.uniform(-0.2, 1.0, (3, 2)), axis=0) * size
        limits = Limits(size, size, 4.0 * size, 40.0 * size)
        speed = size * random.uniform(-0.6, 0.9, 2)
        points = [Waypoint(places[0]), Waypoint(places[1], speed), Waypoint(places[2])]
        try:
            found.append(plan(points, limits))
        except InfeasibleError:
            continue
    return found


@pytest.mark.parametrize("trajectory", moves(40), ids=lambda t: f"{t.duration:.3f}")
def test_every_answer_is_that_of_samples(trajectory: Trajectory) -> None:
    every = {(found.interval, found.axis) for found in excursions(trajectory)}
    for interval in (1, 2):
        for axis in range(2):
            ends = [w.position[axis] for w in trajectory.waypoints[interval - 1 : interval + 1]]
            times = np.linspace(*trajectory.waypoint_times[interval - 1 : interval + 1], 20_001)
            values = trajectory(times)[:, axis]
            off = max(min(ends) - values.min(), values.max() - max(ends))
            found = excursion(trajectory, interval, axis)
            assert ((interval, axis) in every) == (found is not None)
            if found is None:
                assert off < 2e-6 * abs(ends[1] - ends[0]) + 1e-8 * np.abs(values).max()
            else:
                assert found.distance == pytest.approx(off, rel=1e-4, abs=1e-9 * np.ptp(values))
                # what is less than this is none
                small = max(1e-6 * abs(ends[1] - ends[0]), 1e-9 * np.abs(values).max())
                away = (values < min(ends) - small) | (values > max(ends) + small)
                first = times[away.argmax()] if away.any() else times[-1]
                assert first - 1.1 * (times[1] - times[0]) <= found.time <= first


def test_the_first_is_that_beside_waypoints_that_count() -> None:
    found = told = 0
    for trajectory in moves(40):
        for led in (np.eye(3)[:, :2], np.ones((3, 2)), np.eye(3, 2)[[1, 1, 0]]):
            near = (led[:-1] + led[1:] > 0.0).tolist()
            every = [e for e in excursions(trajectory) if near[e.interval - 1][e.axis]]
            first = first_excursion(trajectory, np.ascontiguousarray(led))
            assert first == (every[0] if every else None)
            found, told = found + 1, told + bool(every)
    assert 0 < told < found
