"""Work space of plans from any state: too small at first, shared by threads, of several sizes."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from segfmu import Limits, Trajectory, Waypoint, plan, replan
from segfmu.planning import onward

LIMITS = Limits([1.0, 0.8], [0.5, 0.4], [10.0, 5.0], [50.0, 30.0])
OLD = plan([Waypoint([0.0, 0.0]), Waypoint([1.0, 0.5]), Waypoint([0.2, 0.9])], LIMITS)
TARGETS = [Waypoint([x, 0.3 * x]) for x in (-0.5, 0.1, 0.7, 1.9)]


def pieces(trajectory: Trajectory) -> list:
    return [trajectory.timing.tolist(), trajectory.coefficients.tolist()]


def replanned(count: int = 2) -> list[list]:
    """Plans that leave another one while it has a jerk, by way of so many targets."""
    ways = [[TARGETS[(i + j) % len(TARGETS)] for j in range(count)] for i in range(len(TARGETS))]
    return [pieces(replan(OLD, 0.07, way)) for way in ways]


def test_space_that_is_too_small_is_enlarged(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = replanned(60)
    enlarged = []
    enlarge = onward.Space.enlarge
    monkeypatch.setattr(onward, "_spaces", {})
    monkeypatch.setattr(onward, "usual_rows", lambda size: 0)
    monkeypatch.setattr(
        onward.Space, "enlarge", lambda self: (enlarged.append(self), enlarge(self))
    )
    assert replanned(60) == wanted
    assert enlarged


def test_threads_do_not_share_space() -> None:
    wanted = replanned()
    with ThreadPoolExecutor(4) as pool:
        runs = [pool.submit(replanned) for _ in range(8)]
        assert all(run.result() == wanted for run in runs)


def test_few_spaces_are_kept() -> None:
    for axes in range(1, 2 * onward.KEPT):
        limits = Limits(*(np.full(axes, v) for v in (1.0, 0.5, 10.0, 50.0)))
        old = plan([Waypoint(np.zeros(axes)), Waypoint(np.ones(axes))], limits)
        replan(old, 0.5, Waypoint(-np.ones(axes)))
    assert len(onward._spaces) <= onward.KEPT
    assert all(s.timing.shape[1] <= onward.LARGEST for s in onward._spaces.values())
