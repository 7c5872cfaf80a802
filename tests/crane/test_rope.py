"""Refusal of plans that the rope cannot carry: when, what, and never missed between samples."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from segfmu import (
    Crane,
    FlatInverse,
    InfeasibleError,
    InputError,
    Limits,
    Trajectory,
    Waypoint,
    plan,
)
from segfmu.crane import ActuatorBounds, plan_actuated
from segfmu.crane.rope import require_rope

LIMITS = Limits([1.0, 0.4, 0.5], [1.0, 0.5, 0.8], [1.0, 0.5, 4.0], [10.0, 5.0, 30.0])
FAST = Limits(20.0, [20.0, 20.0, 15.0], 400.0, 9000.0)
HOISTING = [
    Waypoint([0.0, 0.0, -1.2]),
    Waypoint([0.5, 0.3, -0.6], [0.4, 0.2, 0.1]),
    Waypoint([1.0, 0.5, -1.0]),
]


def crane(rope_min: float | None = None, rope_max: float | None = None) -> Crane:
    return Crane(2.2, 1.155, 1.0, rope_min=rope_min, rope_max=rope_max)


def refusal(used: Crane, trajectory: Trajectory) -> InfeasibleError:
    with pytest.raises(InfeasibleError) as caught:
        FlatInverse(used, trajectory)
    assert str(caught.value).startswith(f"at {caught.value.time:.3f} s: ")
    return caught.value


def length(trajectory: Trajectory, t: np.ndarray) -> np.ndarray:
    """Rope length from the geometry: the rope is parallel to p'' + g e_z and ends at z = 0."""
    pull = trajectory(t, 2) + np.array([0.0, 0.0, 9.81])
    return -trajectory(t)[:, 2] * np.linalg.norm(pull / pull[:, 2:], axis=1)


def test_slack_rope_is_refused_when_it_begins() -> None:
    points = [Waypoint([0.0, 0.0, -1.0]), Waypoint([0.0, 0.0, -9.0])]
    trajectory = plan(points, FAST)
    error = refusal(crane(), trajectory)
    assert "downward acceleration of the load passes gravity" in str(error)
    assert error.value == pytest.approx(15.0, rel=1e-3)
    assert trajectory(error.time, 2)[2] == pytest.approx(-9.81, abs=1e-5)


@pytest.mark.parametrize("dwell", [0.0, 17.0, 4000.0])
def test_a_short_violation_in_a_long_mission_is_found(dwell: float) -> None:
    points = [
        Waypoint([0.0, 0.0, -1.0]), Waypoint([0.0, 0.0, -1.5], dwell=dwell),
        Waypoint([0.0, 0.0, -9.0], dwell=dwell), Waypoint([0.0, 0.0, -8.0]),
    ]
    error = refusal(crane(), plan(points, FAST))
    assert "slack" in str(error)


@pytest.mark.parametrize("height", [-6e-17, -1e-9, 0.0])
def test_a_load_at_the_trolley_has_no_rope(height: float) -> None:
    points = [Waypoint([0.0, 0.0, height]), Waypoint([1.0, 1.0, height])]
    with pytest.raises(InfeasibleError, match="load height z passes the trolley's height, -1e-06"):
        require_rope(crane(), plan(points, LIMITS))
    with pytest.raises(InputError, match="must be below the trolley, z <= -1e-06"):
        crane().hanging([0.0, 0.0, height])
    with pytest.raises(InfeasibleError, match="must be below the trolley, z <= -1e-06"):
        plan_actuated(crane(), points, None, ActuatorBounds(force=100.0, velocity=1.0))
    require_rope(crane(), plan([Waypoint([0.0, 0.0, -1e-6])] * 2, LIMITS))


def test_load_above_the_trolley_is_refused() -> None:
    points = [Waypoint([0.0, 0.0, -0.5]), Waypoint([0.0, 0.0, 0.5])]
    trajectory = plan(points, LIMITS)
    error = refusal(crane(), trajectory)
    assert "load height z passes the trolley's height" in str(error)
    assert error.value == pytest.approx(0.5)
    assert trajectory(error.time)[2] == pytest.approx(-1e-6, abs=1e-9)


def test_load_that_starts_above_the_trolley_is_refused_at_once() -> None:
    points = [Waypoint([0.0, 0.0, 0.5]), Waypoint([0.0, 0.0, -0.5])]
    assert refusal(crane(), plan(points, LIMITS)).time == 0.0


@pytest.mark.parametrize(("bounds", "name"), [((None, 1.0), "rope_max"), ((0.7, None), "rope_min")])
def test_rope_out_of_range_is_refused_when_it_begins(bounds, name: str) -> None:
    trajectory = plan(HOISTING, LIMITS)
    error = refusal(crane(*bounds), trajectory)
    assert f"rope length passes {name}" in str(error)
    bound = bounds[0] or bounds[1]
    if error.time > 0.0:
        assert length(trajectory, np.array([error.time])) == pytest.approx(bound, abs=1e-6)
    else:
        assert length(trajectory, np.zeros(1))[0] > bound


def test_rope_may_rest_at_its_bounds() -> None:
    points = [Waypoint([0.0, 0.0, -0.4]), Waypoint([0.0, 0.0, -1.0], dwell=2.0),
              Waypoint([0.3, 0.0, -0.4])]
    trajectory = plan(points, LIMITS)
    FlatInverse(crane(0.4, 1.05), trajectory)
    lifted = plan(points[:2], LIMITS)
    FlatInverse(crane(0.4, 1.0), lifted)


@pytest.mark.parametrize("axis", [0, 1])
def test_swaying_out_lengthens_the_rope(axis: int) -> None:
    away = [0.0, 0.0, -0.5]
    away[axis] = 1.0
    trajectory = plan([Waypoint([0.0, 0.0, -0.5]), Waypoint(away)], LIMITS)
    assert "rope_max" in str(refusal(crane(rope_max=0.5), trajectory))
    FlatInverse(crane(rope_min=0.5), trajectory)


heights = st.floats(-3.0, -0.2)
places = st.floats(-2.0, 2.0)


@settings(max_examples=20, deadline=None)
@given(
    st.lists(st.tuples(places, places, heights), min_size=2, max_size=4),
    st.sampled_from([4, 5, 6]), st.sampled_from(["plateau", "smoothstep"]),
    st.sampled_from(["waypoints", "none"]), st.floats(-1e-3, 1e-3),
)
def test_verdict_is_that_of_dense_samples(points, smoothness, shape, synchronize, offset) -> None:
    limits = Limits([3.0, 2.0, 2.0], [6.0, 4.0, 5.0], [40.0, 30.0, 60.0])
    assume(all(np.ptp([a, b], axis=0).max() > 1e-9 for a, b in pairwise(points)))
    trajectory = plan(
        [Waypoint(list(p)) for p in points], limits, smoothness=smoothness, shape=shape,
        synchronize=synchronize,
    )
    t = np.linspace(0.0, trajectory.duration, 20001)
    lengths = length(trajectory, t)
    longest, shortest = float(lengths.max()), float(lengths.min())
    for bounds, excess in (
        ((None, longest + offset), -offset), ((shortest + offset, None), offset),
    ):
        if excess > 1e-5:
            error = refusal(crane(*bounds), trajectory)
            past = (lengths - (bounds[0] or bounds[1])) * (1.0 if bounds[0] is None else -1.0) > 0.0
            assert error.time <= t[past][0] + 1e-9
            assert error.time == pytest.approx(t[past][0], abs=2.0 * t[1] + 1e-6)
        elif excess < -1e-5:
            FlatInverse(crane(*bounds), trajectory)
