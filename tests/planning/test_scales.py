"""Limits that mean none, and states that differ by rounding."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from segfmu import InfeasibleError, Limits, Waypoint, plan, verify


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


def moving(random: np.random.Generator, smoothness: int) -> tuple[np.ndarray, list[Waypoint]]:
    """Limits c_1 .. that may bound the motion, and two waypoints that move."""
    limits = 10.0 ** random.uniform(-0.5, 1.0, max(smoothness, 3))
    share = random.uniform(-1.0, 1.0, (2, 2))
    share[random.random((2, 2)) < 0.3] = 0.0
    states = share * limits[:2]
    distance = random.normal() * 10.0 ** random.uniform(-2.0, 1.0)
    return limits, [Waypoint(0.0, *states[0]), Waypoint(distance, *states[1])]


@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
@pytest.mark.parametrize("smoothness", [2, 3, 4])
@pytest.mark.parametrize("absent", [[0], [1], [0, 1]])
def test_limits_that_are_none_change_no_plan(
    smoothness: int, shape: str, absent: list[int]
) -> None:
    random = np.random.default_rng((smoothness, len(absent), absent[0]))
    planned = 0
    for _ in range(20):
        limits, points = moving(random, smoothness)
        near, far = limits.copy(), limits.copy()
        near[absent] *= 1e4
        far[absent] *= 10.0 ** random.uniform(6.0, 12.0)
        try:
            expected = plan(points, Limits(*near), smoothness=smoothness, shape=shape)
        except InfeasibleError:
            continue
        planned += 1
        found = plan(points, Limits(*far), smoothness=smoothness, shape=shape)
        assert found.duration == pytest.approx(expected.duration, rel=1e-9)
        for given, point in zip(points, found.waypoints, strict=True):
            assert np.array_equal(given.planned, point.planned)
        target = 3.0 * found.duration
        longer = plan(points, Limits(*far), smoothness=smoothness, shape=shape, duration=target)
        assert longer.duration == pytest.approx(target, rel=1e-12)
        assert verify(longer).passed
    assert planned >= 10


def test_axes_meet_beside_limits_that_are_none() -> None:
    points = [
        Waypoint([0.0, 0.0, 0.0], [0.4, 0.0, -0.2], [0.1, 0.0, 0.0]),
        Waypoint([2.0, 0.3, 1.0], [0.0, 0.1, 0.0], [0.0, 0.2, 0.0]),
    ]
    expected = plan(points, Limits(100.0, 100.0, 4.0, 20.0))
    found = plan(points, Limits(1e9, 1e7, 4.0, 20.0))
    assert found.duration == pytest.approx(expected.duration, rel=1e-9)
    assert verify(found).passed


def test_states_are_zero_by_the_scale_of_the_motion() -> None:
    # of the velocity limit 1e-9 is more than the velocity of x, of the motion it is not
    points = [Waypoint([0.0, 0.0], [0.5, 1e-12]), Waypoint([3.0, 0.0])]
    found = plan(points, Limits(1e9, 1.0, 2.0, 5.0))
    assert found(0.0, 1).tolist() == [0.5, 0.0]
    alone = plan([Waypoint(0.0, 1e-12), Waypoint(1e-12)], Limits(1e9, 1.0, 2.0, 5.0))
    assert alone(0.0, 1).tolist() == [1e-12]


def test_a_wrong_velocity_is_seen_beside_a_velocity_limit_that_is_none() -> None:
    found = plan([Waypoint(0.0, 0.5), Waypoint(3.0)], Limits(1e6, 1.0, 2.0, 5.0))
    assert verify(found).passed
    asked = (Waypoint(0.0, 0.5 + 1e-6), found.waypoints[1])
    assert not verify(replace(found, waypoints=asked)).passed


def test_an_acceleration_is_braked_past_zero_beside_an_acceleration_limit_that_is_none() -> None:
    # one ramp to zero exceeds the velocity limit by 4 %; one past zero and back does not
    points = [Waypoint(0.0, 0.0, 0.525), Waypoint(1.0)]
    for acceleration in (0.55, 5.5, 1e6, 1e12):
        assert verify(plan(points, Limits(0.4, acceleration, 10.0, 0.87))).passed


@pytest.mark.parametrize("place", [0.0, 2.0, -7.3])
@pytest.mark.parametrize("unit", [0.3, 0.7, 1.0, 3.0])
def test_a_motion_that_just_reaches_its_velocity_limit_is_its_own_reverse(
    unit: float, place: float
) -> None:
    """From rest to rest; with one level in each direction, which is lower, it takes 4.588 s."""
    values = np.array([1.861121, 1.222928, 2.0883, 7.0861])
    here = plan([Waypoint([0.0]), Waypoint([3.99686])], Limits(*values))
    least, most = (float(found[0]) for found in here.extrema(2))
    assert here.duration < 4.5631 and most == pytest.approx(-least, rel=1e-9)
    scaled = Limits(*(unit * values))
    there = plan([Waypoint([unit * place]), Waypoint([unit * (place + 3.99686)])], scaled)
    assert there.extrema(2)[1] == pytest.approx(unit * most, rel=1e-6)


def test_times_beyond_all_scales_have_few_digits() -> None:
    """They were told with three hundred digits in front of the point."""
    with pytest.raises(InfeasibleError, match="choose limits and distances of") as told:
        plan([Waypoint([0.0]), Waypoint([1.0])], Limits(1e-300, 1.0, 1.0))
    assert "at 1e+300 s" in str(told.value)


@pytest.mark.parametrize(("way", "velocity"), [
    ([0.0, 1e301], 1.0), ([0.0, -1e305], 1.0), ([0.0, 1.0], 1e-302),
])
def test_ways_beyond_all_scales_are_told_as_such(way: list[float], velocity: float) -> None:
    """They were refused as axes that have no common duration."""
    points = [Waypoint([0.0, 0.0]), Waypoint(way)]
    with pytest.raises(InfeasibleError, match="limits and distances of similar size") as told:
        plan(points, Limits(velocity, 1.0, 1.0, 1.0))
    assert str(told.value).startswith("axis y, waypoints 1 -> 2: ")
    assert (told.value.axis, told.value.interval) == (1, 1)
