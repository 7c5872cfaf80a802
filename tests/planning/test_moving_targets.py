"""Motions to a target that moves while the plan runs, from states with jerk, snap and more.

The optimum is that of linear programming, which lets the highest limited derivative jump.
"""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.replanning import random_plan
from benchmarks.stopping import shortest_motion

from segfmu import Limits, Trajectory, Waypoint, plan, replan, verify
from tests.campaign import campaign


def moved(random: np.random.Generator, n: int) -> tuple[Trajectory, float, float]:
    """A random plan, a time, and a target near its own one."""
    old = random_plan(random, n)
    positions = [point.position[0] for point in old.waypoints]
    target = positions[-1] + 0.1 * random.uniform(-1.0, 1.0) * np.ptp(positions)
    return old, random.uniform(0.0, old.duration), float(target)


@campaign(1, 12)
@pytest.mark.parametrize(("n", "most"), [(3, 1.05), (4, 1.03), (5, 1.06), (6, 1.1)])
def test_a_moved_target_is_reached_near_the_optimum(n: int, most: float, count: int) -> None:
    random = np.random.default_rng(17)
    ratios = []
    for _ in range(count):
        old, t, target = moved(random, n)
        new = replan(old, t, Waypoint(target))
        assert verify(new).passed
        limits = old.limits.table(1, n)[0]
        highest = int(np.flatnonzero(limits)[-1]) + 1
        state = old.state(t).state(highest - 1)[0]
        optimum = shortest_motion(
            target - state[0], state[1:], limits[:highest], 1.2 * new.duration, intervals=150
        )
        if optimum is not None:
            ratios.append(new.duration / optimum)
    assert len(ratios) > 2 * count // 3
    assert min(ratios) > 0.998
    assert np.quantile(ratios, 0.75) < most


@pytest.mark.parametrize("n", [4, 5, 6])
def test_a_late_axis_alone_makes_haste(n: int) -> None:
    limits = Limits(1.0, 1.0, 4.0, 20.0, *([200.0] if n > 4 else []))
    old = plan([Waypoint([0.0, 0.0]), Waypoint([3.0, 0.3])], limits, smoothness=n)
    target = Waypoint([3.2, 0.35])
    new = replan(old, 1.0, target)
    assert verify(new).passed
    # the second axis needs half of the time, and uses all of it
    apart = replan(old, 1.0, target, synchronize="none")
    ends = [apart.pieces(axis)[0][-1] for axis in range(2)]
    assert ends[1] < 0.7 * ends[0]
    starts, lengths, coefficients = new.pieces(1)
    assert starts[-1] > 0.95 * new.duration or np.abs(coefficients[-1, 1:]).max() > 0.0
    # to a given duration nothing makes haste
    state = old.state(1.0)
    slow = plan([state, target], limits, smoothness=n, duration=2.0 * new.duration)
    for axis in range(2):
        moving = slow(0.9 * slow.duration, 1)[axis]
        assert abs(moving) > 0.0
