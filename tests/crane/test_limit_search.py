"""The search for limits within the drives' bounds: looser bounds, and peaks among samples."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from segfmu import ActuatorBounds, Crane, HookCrane, Waypoint, plan_actuated
from segfmu.crane import limit_search
from segfmu.crane.drive_task import Task
from segfmu.planning.trajectory import Trajectory

HOOK = HookCrane(Crane(2.2, 1.155, 1.0), hook_mass=0.1, sling=0.3)
WAY = [
    Waypoint([0.0, 0.0, -1.1]),
    Waypoint([0.5, 0.2, -0.7], "free", "free"),
    Waypoint([1.2, 0.6, -1.0]),
]
DRIVES = ActuatorBounds(velocity=[0.8, 0.6, 0.4], acceleration=[1.0, 1.0, 1.0])


def duration(accelerations: list[float]) -> float:
    bounds = replace(DRIVES, acceleration=accelerations)
    plan = plan_actuated(HOOK, WAY, None, bounds, smoothness=6, shape="smoothstep")
    return float(plan.trajectory.duration)


def test_a_looser_bound_hardly_lengthens_a_plan() -> None:
    given = duration([1.0, 1.0, 1.0])
    assert duration([1.0, 1.25, 1.0]) < 1.01 * given
    assert duration([1.0, 1.0, 1.25]) < 1.01 * given


def test_samples_tell_the_peaks_of_plans_on_the_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where they do not, the search ends in a plan that its exact peaks slow down."""
    shares = []

    def compared(
        look: Callable[..., limit_search.Found]
    ) -> Callable[..., limit_search.Found]:
        def inner(task: Task, trajectory: Trajectory, *, exact: bool) -> limit_search.Found:
            found = look(task, trajectory, exact=exact)
            if exact:
                shares.append(look(task, trajectory, exact=False).use / found.use)
            return found

        return inner

    monkeypatch.setattr(limit_search, "look", compared(limit_search.look))
    duration([1.0, 1.25, 1.0])
    duration([1.0, 1.0, 1.25])
    assert min(shares) > 0.9
