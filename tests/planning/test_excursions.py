"""Excursions: the fast answer is that of the exact search, and both are that of samples."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, excursions, plan
from segfmu.planning.excursions import excursion, leaves


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
            assert leaves(trajectory, interval, axis) == (found is not None)
            assert ((interval, axis) in every) == (found is not None)
            if found is None:
                assert off < 2e-6 * abs(ends[1] - ends[0]) + 1e-8 * np.abs(values).max()
            else:
                assert found.distance == pytest.approx(off, rel=1e-4, abs=1e-9 * np.ptp(values))


def test_both_answers_occur() -> None:
    answers = [leaves(t, i, a) for t in moves(40) for i in (1, 2) for a in (0, 1)]
    assert 10 < sum(answers) < len(answers) - 10
