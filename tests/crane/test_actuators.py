"""Plans within the bounds of the drives: met exactly, and never slower than needed."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import (
    ActuatorBounds,
    Crane,
    FlatInverse,
    InfeasibleError,
    InputError,
    Limits,
    Waypoint,
    plan,
    plan_actuated,
)

CRANE = Crane(2.2, 1.155, 1.0)
LIMITS = Limits([1.0, 0.8, 0.5], [1.0, 0.8, 0.8], [4.0, 4.0, 4.0], [30.0, 30.0, 30.0])
MOVE = [Waypoint([0.0, 0.0, -1.0]), Waypoint([1.0, 0.8, -0.7])]


def test_generous_bounds_change_nothing() -> None:
    found = plan_actuated(CRANE, MOVE, LIMITS, ActuatorBounds(force=100.0, sway_angle=1.0))
    assert found.scale == 1.0
    assert found.active is None
    assert found.trajectory.duration == plan(MOVE, LIMITS).duration


@pytest.mark.parametrize(
    ("bounds", "active", "column"),
    [
        (ActuatorBounds(force=[1.5, 100.0, 100.0]), "bridge force", 0),
        (ActuatorBounds(force=[100.0, 0.8, 100.0]), "trolley force", 1),
        (ActuatorBounds(velocity=[0.5, np.inf, np.inf]), "bridge velocity", 8),
        (ActuatorBounds(velocity=[np.inf, np.inf, 0.1]), "hoist velocity", 10),
        (ActuatorBounds(acceleration=[np.inf, 0.3, np.inf]), "trolley acceleration", 14),
        (ActuatorBounds(sway_angle=[0.02, np.inf]), "sway angle x", 6),
        (ActuatorBounds(sway_angle=np.deg2rad(1.0)), None, None),
    ],
)
def test_the_bound_is_met_and_used(bounds, active, column) -> None:
    found = plan_actuated(CRANE, MOVE, LIMITS, bounds)
    assert 0.0 < found.scale < 1.0
    assert found.usage.max() <= 1.0 + 1e-8
    # slower than needed by no more than the search's resolution
    assert found.usage.max() > 0.995
    if active is not None:
        assert found.active == active
        times = np.linspace(0.0, found.trajectory.duration, 9001)
        peak = np.abs(FlatInverse(CRANE, found.trajectory).evaluate(times)[:, column]).max()
        bound = bounds.vector[np.isfinite(bounds.vector)].min()
        assert peak == pytest.approx(bound, rel=6e-3)
        assert peak <= bound * (1.0 + 1e-6)


def test_a_tighter_bound_takes_longer() -> None:
    durations = [
        plan_actuated(CRANE, MOVE, LIMITS, ActuatorBounds(sway_angle=a)).trajectory.duration
        for a in (0.05, 0.03, 0.01)
    ]
    assert durations == sorted(durations)
    assert durations[2] > 1.3 * durations[0]


def test_the_static_force_cannot_be_slowed_down() -> None:
    with pytest.raises(InfeasibleError, match=r"hoist force needs .* N at .* bound is 9 N") as info:
        plan_actuated(CRANE, MOVE, LIMITS, ActuatorBounds(force=[100.0, 100.0, 9.0]))
    assert info.value.limit == "hoist force"


def test_moving_waypoints_set_the_slowest_plan() -> None:
    points = [MOVE[0], Waypoint([0.5, 0.4, -0.8], [0.8, 0.5, 0.0]), MOVE[1]]
    with pytest.raises(InfeasibleError, match=r"bridge velocity.*slower plans are infeasible"):
        plan_actuated(CRANE, points, LIMITS, ActuatorBounds(velocity=[0.3, 1.0, 1.0]))


@pytest.mark.parametrize("given", [[1.0, 2.0], 0.0, -1.0, "strong", [[1.0]]])
def test_wrong_bounds_are_refused(given) -> None:
    with pytest.raises(InputError, match="force"):
        ActuatorBounds(force=given)


def test_bounds_of_another_type_are_refused() -> None:
    with pytest.raises(InputError, match="bounds must be an ActuatorBounds, got NoneType"):
        plan_actuated(CRANE, MOVE, LIMITS, None)
