"""The search for limits within the drives' bounds: looser bounds, and peaks among samples."""

from __future__ import annotations

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


@pytest.fixture(scope="module")
def searches() -> tuple[list[float], list[float]]:
    """Durations as given and with looser bounds, and the shares of exact peaks in samples."""
    shares = []
    look = limit_search.look

    def compared(task: Task, trajectory: Trajectory, *, exact: bool) -> limit_search.Found:
        found = look(task, trajectory, exact=exact)
        if exact:
            shares.append(look(task, trajectory, exact=False).use / found.use)
        return found

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(limit_search, "look", compared)
        durations = [duration(a) for a in ([1.0, 1.0, 1.0], [1.0, 1.25, 1.0], [1.0, 1.0, 1.25])]
    return durations, shares


def test_a_looser_bound_hardly_lengthens_a_plan(searches: tuple[list[float], list[float]]) -> None:
    given, *looser = searches[0]
    assert max(looser) < 1.01 * given


def test_samples_tell_the_peaks_of_plans_on_the_way(
    searches: tuple[list[float], list[float]]
) -> None:
    """Where they do not, the search ends in a plan that its exact peaks slow down."""
    assert len(searches[1]) >= 3
    assert min(searches[1]) > 0.9
