"""Limits that mean none, and states that differ by rounding."""

from __future__ import annotations

from dataclasses import replace

import pytest

from segfmu import Limits, Waypoint, plan, verify


@pytest.mark.parametrize("velocity", [1e6, 1e9, 1e16, 1e40, 1e200])
@pytest.mark.parametrize("distance", [1e-3, 1.0, 1e3])
def test_a_velocity_limit_that_is_none_changes_nothing(velocity: float, distance: float) -> None:
    points = [Waypoint(0.0), Waypoint(distance)]
    expected = plan(points, Limits(100.0, 1.0, 1.0, 1.0))
    found = plan(points, Limits(velocity, 1.0, 1.0, 1.0))
    assert found.duration == pytest.approx(expected.duration, rel=1e-12)
    assert found(0.0)[0] == 0.0
    assert found(found.duration)[0] == pytest.approx(distance, rel=1e-12)


@pytest.mark.parametrize("jerk", [None, 1.0])
def test_a_jump_is_seen_beside_a_velocity_limit_that_is_none(jerk: float | None) -> None:
    found = plan([Waypoint(0.0), Waypoint(1.0)], Limits(1e16, 1.0, jerk, 1.0))
    assert verify(found).passed
    moved = found.coefficients.copy()
    moved[:, 0] += 1e-6
    assert not verify(replace(found, coefficients=moved)).passed


def test_axes_of_different_limits_move() -> None:
    points = [Waypoint([0.0, 0.0]), Waypoint([1.0, 1.0])]
    found = plan(points, Limits([1.0, 1e18], 1.0, 1.0, 1.0))
    assert found(found.duration) == pytest.approx([1.0, 1.0], rel=1e-12)


@pytest.mark.parametrize(
    ("limits", "distance"),
    [((1.0, 1.0, 1.0, 1.0, 1.0, 1.0), 1e-3), ((1.0, 1.0, 4.0, 20.0), 1e-6)],
)
def test_velocities_that_differ_by_rounding_are_the_same(
    limits: tuple[float, ...], distance: float
) -> None:
    assert 0.1 * 3 != 0.3
    points = [Waypoint(0.0, 0.3), Waypoint(distance, 0.1 * 3)]
    found = plan(points, Limits(*limits), smoothness=max(len(limits), 4))
    assert found.duration == pytest.approx(distance / 0.3, rel=1e-12)
    assert verify(found).passed
