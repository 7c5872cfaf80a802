"""Limits of velocity and acceleration that differ by direction: linear programs, mirrored plans."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from benchmarks.directions import directed
from benchmarks.optimal_control import Transition, earliest

from segfmu import (
    InfeasibleError,
    InputError,
    Limits,
    Trajectory,
    Waypoint,
    plan,
    reach_velocity,
    replan,
    stop,
    verify,
)

HOIST = Limits(1.0, 2.0, 4.0, 20.0, velocity_min=-0.5, acceleration_min=-1.0)


def mirror(limits: Limits, smoothness: int = 4) -> Limits:
    """The same limits with both directions exchanged, of one axis."""
    upper = limits.table(1, smoothness)[0].tolist()
    lower = limits.lower(1)[0].tolist()
    return Limits(
        *lower, *(c or None for c in upper[2:]), velocity_min=-upper[0], acceleration_min=-upper[1]
    )


def ranges(found: Trajectory) -> np.ndarray:
    """Least and largest velocity and acceleration of the first axis, shape (2, 2)."""
    return np.array([np.concatenate(found.extrema(order)) for order in (1, 2)])


@pytest.mark.parametrize("axes", [-1, 10**400, "a", None, 1.5, True, [1]])
def test_lower_limits_of_no_number_of_axes_are_refused(axes: Any) -> None:
    with pytest.raises(InputError, match=r"^axes must be (an integer|from 0 to 1000000), got "):
        HOIST.lower(axes)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_each_direction_keeps_and_reaches_its_own_limit(n: int) -> None:
    limits = HOIST if n > 2 else Limits(1.0, 2.0, 4.0, velocity_min=-0.5, acceleration_min=-1.0)
    up = plan([Waypoint(0.0), Waypoint(30.0)], limits, smoothness=n)
    down = plan([Waypoint(30.0), Waypoint(0.0)], limits, smoothness=n)
    assert verify(up).passed and verify(down).passed
    assert ranges(up)[0] == pytest.approx([0.0, 1.0], abs=1e-9)
    assert ranges(down)[0] == pytest.approx([-0.5, 0.0], abs=1e-9)
    for found in (up, down):
        assert ranges(found)[1, 0] == pytest.approx(-1.0, abs=1e-9)
        assert ranges(found)[1, 1] <= 2.0 * (1.0 + 1e-9)
    assert down.duration > 1.8 * up.duration


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_the_mirrored_problem_takes_as_long(n: int) -> None:
    random = np.random.default_rng(n)
    planned = 0
    for _ in range(20 if n < 5 else 12):
        problem = directed(random, max(n, 3))
        one, two = problem.duration(n), problem.duration(n, mirrored=True)
        assert np.isinf(one) == np.isinf(two)
        if np.isfinite(one):
            planned += 1
            assert two == pytest.approx(one, rel=1e-12)
    assert planned > 1


@pytest.mark.parametrize("n", [3, 4])
def test_plans_are_as_short_as_linear_programs(n: int) -> None:
    random = np.random.default_rng(10 + n)
    tried = 0
    while tried < 3:
        problem = directed(random, n)
        found = problem.duration(n - 1)
        if not np.isfinite(found):
            continue
        tried += 1
        v, a, w, b, y = problem.state.tolist()
        transition = Transition(
            "", (0.0, v, a), (y, w, b), tuple(problem.limits.tolist()),
            (float(problem.lower[0]), float(problem.lower[1])),
        )
        assert found < 1.01 * earliest(transition, found, 60, 2e-3)


def test_the_same_numbers_in_both_directions_are_no_difference() -> None:
    points = [Waypoint(0.0, 0.2), Waypoint(2.0, -0.3, 0.4), Waypoint(1.0)]
    alone = plan(points, Limits(1.0, 2.0, 4.0, 20.0))
    told = Limits(1.0, 2.0, 4.0, 20.0, velocity_min=-1.0, acceleration_min=-2.0)
    assert np.array_equal(plan(points, told).coefficients, alone.coefficients)
    assert "velocity_min=-0.5" in repr(HOIST)
    assert "min" not in repr(Limits(1.0, 2.0, 4.0, 20.0, velocity_min=-np.inf))


@pytest.mark.parametrize("synchronize", ["waypoints", "total", "none"])
def test_axes_of_different_directions_meet(synchronize: str) -> None:
    limits = Limits(
        [1.0, 0.8], 1.0, 4.0, 20.0, velocity_min=[-1.0, -0.3], acceleration_min=[-0.5, -2.0]
    )
    points = [
        Waypoint([0.0, 0.0]), Waypoint([1.0, -1.0], [0.4, -0.2]), Waypoint([0.5, 2.0])
    ]
    found = plan(points, limits, synchronize=synchronize)
    assert verify(found).passed
    assert found.extrema(1)[0][1] >= -0.3 * (1.0 + 1e-9)
    longer = plan(points, limits, duration=1.5 * found.duration)
    assert verify(longer).passed


@pytest.mark.parametrize("field", ["velocity", "acceleration"])
def test_free_states_use_both_directions(field: str) -> None:
    free = {"velocity": "free"} if field == "velocity" else {
        "velocity": "free", "acceleration": "free"
    }
    points = [Waypoint(0.0), Waypoint(2.0, **free), Waypoint(4.0, **free), Waypoint(8.0)]
    limits = Limits(0.2, 1.0, 4.0, 20.0, velocity_min=-1.5, acceleration_min=-2.0)
    back = [Waypoint(-point.position[0], **(free if 0 < i < 3 else {}))
            for i, point in enumerate(points)]
    slow, fast = plan(points, limits), plan(back, limits)
    assert verify(slow).passed and verify(fast).passed
    assert fast.duration < 0.35 * slow.duration
    mirrored = plan(points, mirror(limits))
    assert mirrored.duration == pytest.approx(fast.duration, rel=1e-6)


def test_stops_and_new_targets_keep_both_directions() -> None:
    moving = plan([Waypoint(0.0), Waypoint(6.0)], HOIST)
    for time in (0.3, 1.0, 2.5, 0.9 * moving.duration):
        for found in (
            stop(moving, time), replan(moving, time, [Waypoint(-1.0)]),
            reach_velocity(moving, -0.5, time),
        ):
            assert verify(found).passed
            assert ranges(found)[0, 0] >= -0.5 * (1.0 + 1e-9)
            assert ranges(found)[1, 0] >= -1.0 * (1.0 + 1e-9)
    with pytest.raises(InfeasibleError, match=r"-0.6 m/s exceeds the limit 0.5 .*velocity_min"):
        reach_velocity(moving, -0.6, 1.0)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_a_state_outside_the_limit_of_its_direction_is_brought_inside(n: int) -> None:
    limits = Limits(1.0, 2.0, 4.0, velocity_min=-0.5, acceleration_min=-1.0)
    # within the limit upwards, beyond the one downwards
    for start in (Waypoint(0.0, -0.8), Waypoint(0.0, -0.2, -1.5)):
        for found in (
            stop(start, limits=limits, smoothness=n),
            reach_velocity(start, -0.4, limits=limits, smoothness=n),
            replan(start, 0.0, Waypoint(2.0), limits, smoothness=n),
        ):
            told = verify(found)
            assert told.passed
            assert 0.0 < found.outside[0] <= told.outside[0] * (1.0 + 1e-9)
            after = found.outside[0] * (1.0 + 1e-9) + np.linspace(0.0, found.duration, 500)
            assert float(found(after, 1).min()) >= -0.5 * (1.0 + 1e-8)
            assert float(found(after, 2).min()) >= -1.0 * (1.0 + 1e-8)
    # the same speed upwards is inside
    assert not stop(Waypoint(0.0, 0.8), limits=limits, smoothness=n).outside.any()


def test_refusals_name_the_direction() -> None:
    with pytest.raises(InfeasibleError, match=r"limits\.velocity_min") as found:
        plan([Waypoint(0.0), Waypoint(1.0, -0.6)], HOIST)
    assert found.value.limit == "velocity_min" and found.value.bound == 0.5
    with pytest.raises(InfeasibleError, match=r"limits\.acceleration_min"):
        plan([Waypoint(0.0), Waypoint(1.0, 0.0, -1.5)], HOIST)
    with pytest.raises(InfeasibleError, match=r"limits\.velocity\b(?!_)"):
        plan([Waypoint(0.0), Waypoint(1.0, 1.5)], HOIST)
    with pytest.raises(InfeasibleError, match=r"braking the first .* limits\.velocity_min"):
        plan([Waypoint(0.0, -0.49, -1.0), Waypoint(-3.0)], HOIST)


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("velocity_min", 0.3, "less than 0"), ("acceleration_min", 0.0, "less than 0"),
        ("velocity_min", float("nan"), "less than 0"), ("velocity_min", np.inf, "less than 0"),
        ("velocity_min", [[-1.0]], "shape"), ("acceleration_min", [], "one per axis"),
        ("velocity_min", "slow", "velocity_min"),
    ],
)
def test_limits_in_the_negative_direction_are_below_zero(name, value, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Limits(1.0, 1.0, 1.0, **{name: value})


def test_a_plan_that_breaks_one_direction_is_seen() -> None:
    found = plan([Waypoint(0.0), Waypoint(-3.0)], Limits(1.0, 2.0, 4.0, 20.0))
    told = verify(found)
    assert told.passed
    object.__setattr__(found, "limits", HOIST)
    told = verify(found)
    assert not told.passed
    assert told.usage[0, 0] == pytest.approx(2.0, rel=1e-9)
    assert told.limits[0, 0] == 0.5
