"""Bounds of drives at the edge of what plans are made with, and what is said of them."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
import pytest

from segfmu import (
    ActuatorBounds,
    Clearance,
    Crane,
    InfeasibleError,
    InputError,
    Limits,
    Waypoint,
    plan_actuated,
)

CRANE = Crane(2.2, 1.155, 1.0)
MOVE = [Waypoint([0, 0, -0.5]), Waypoint([0.5, 0.3, -0.4])]
CALM = ActuatorBounds(velocity=0.3, acceleration=0.5)


@pytest.mark.parametrize("height", [0.0, -0.0, 0.5])
@pytest.mark.parametrize("limits", [None, Limits(1, 1, 2, 20)])
def test_waypoints_are_below_the_trolley(height: float, limits: Limits | None) -> None:
    points = [Waypoint([0, 0, height]), Waypoint([1, 0, height])]
    with pytest.raises(InfeasibleError, match=r"waypoint 1: position z 0.* m must be") as info:
        plan_actuated(CRANE, points, limits, CALM)
    assert (info.value.axis, info.value.value, info.value.bound) == (2, height, -1e-6)


def test_a_drive_that_is_too_weak_names_the_force() -> None:
    for mass in (1e300, 1e-10):
        with pytest.raises(InputError, match="bridge_mass must be from 1e-9 to 1e9, got 1e"):
            Crane(mass, 1, 1)
    with pytest.raises(InfeasibleError, match=r"bridge force needs .* bound is 1e-300 N; raise"):
        plan_actuated(CRANE, MOVE, None, ActuatorBounds(force=[1e-300, 10, 20]))


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("bounds", [
    ActuatorBounds(velocity=1e6, acceleration=1e6), ActuatorBounds(force=1e300),
])
def test_bounds_that_hardly_bound_leave_the_rope_taut(bounds: ActuatorBounds) -> None:
    found = plan_actuated(CRANE, MOVE, None, bounds)
    low, _ = found.trajectory.extrema(2)
    assert low[2] > -CRANE.gravity and found.passed


def test_the_weight_alone_exceeds_the_force() -> None:
    with pytest.raises(InfeasibleError) as info:
        plan_actuated(CRANE, MOVE, None, ActuatorBounds(force=[10, 10, 1]))
    assert "hoist force needs 9.81 N for its state alone; the bound is 1 N;" in str(info.value)
    assert "or lower the load's mass" in str(info.value)


def test_a_weight_just_above_the_bound_reads_so() -> None:
    bounds = ActuatorBounds(force=[10, 10, 9.81 * (1.0 - 1e-8)])
    with pytest.raises(InfeasibleError, match=r"needs 9.81 N for .* the bound is 9.8099999 N"):
        plan_actuated(CRANE, MOVE, None, bounds)


def test_a_rope_just_too_long_reads_so() -> None:
    crane = replace(CRANE, rope_max=0.5 - 1e-7)
    lift = [MOVE[0], Waypoint([0, 0, -0.4])]
    with pytest.raises(InfeasibleError, match=r"rope_max, 0.4999999 m, and reaches 0.5 m"):
        plan_actuated(crane, lift, Limits(1, 1, 2, 20), ActuatorBounds())


def test_arguments_of_another_type() -> None:
    with pytest.raises(InputError, match=r"clearance must be a segfmu.Clearance, got str"):
        plan_actuated(CRANE, MOVE, Limits(0.01, 0.01, 0.01, 0.01), CALM, clearance="x")
    with pytest.raises(InputError, match=r"progress must be a function, got 5"):
        plan_actuated(CRANE, MOVE, None, CALM, progress=5)
    assert plan_actuated(CRANE, MOVE, None, CALM, clearance=Clearance()).passed


@pytest.mark.parametrize("velocity", [1e-3, 1e-4, 1e-5])
def test_creeping_drives_are_used_at_once(velocity: float) -> None:
    begin = time.perf_counter()
    found = plan_actuated(
        CRANE, MOVE, None, ActuatorBounds(velocity=velocity, acceleration=0.5)
    )
    # the bound alone takes 0.5 m / velocity
    assert found.passed and found.trajectory.duration < 1.02 * 0.5 / velocity
    assert time.perf_counter() - begin < 20.0


@pytest.mark.parametrize("name", ["velocity", "acceleration"])
def test_drives_that_stand_still_are_refused(name: str) -> None:
    bounds = {"velocity": 1.0, "acceleration": 1.0} | {name: np.array([1.0, 1e-9, 1.0])}
    with pytest.raises(InputError, match=rf"axis y: trolley {name} must have .* 1e-05 m/s.*1e-09"):
        plan_actuated(CRANE, MOVE, None, ActuatorBounds(**bounds))
    # an axis that does not move may have any bound
    plan_actuated(CRANE, [MOVE[0], Waypoint([0.5, 0, -0.4])], None, ActuatorBounds(**bounds))
