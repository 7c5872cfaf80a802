"""Braking by a dip, beside a limit of the pop: against linear programs."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan, verify

CASES = (
    # limits from the acceleration on, acceleration, the least velocity that braking it needs from
    # velocity 0, by a linear program over 80 cells in which the pop jumps
    ((0.625, 6.749, 3.068, 8.999, 8.488), 0.390625, 0.3415),
    # the jerk reaches its limit
    ((0.39, 0.365, 0.32, 0.608, 0.101), 0.13806, 0.2814),
    ((1.0, 1.0, 100.0, 100.0, 100.0), 1.0, 0.8400),
)


def braking(case: int, share: float, mirrored: bool, reverse: bool) -> Trajectory:
    """The plan from, or to, an acceleration that needs a share of that velocity limit."""
    limits, first, least = CASES[case]
    sign = -1.0 if mirrored else 1.0
    distance = 20.0 * sign * least * first
    if reverse:
        ends = [Waypoint(0.0), Waypoint(distance, 0.0, -sign * first)]
    else:
        ends = [Waypoint(0.0, 0.0, sign * first), Waypoint(distance)]
    return plan(ends, Limits(share * least, *limits), smoothness=6)


@pytest.mark.parametrize("case", range(len(CASES)))
def test_the_least_velocity_is_near_that_of_linear_programs(case: int) -> None:
    found = braking(case, 1.015, mirrored=False, reverse=False)
    assert verify(found).passed
    with pytest.raises(InfeasibleError, match="velocity"):
        braking(case, 0.99, mirrored=False, reverse=False)


@pytest.mark.parametrize("share", [1.015, 1.04])
@pytest.mark.parametrize("case", range(len(CASES)))
def test_both_directions_of_position_and_time_are_the_same(case: int, share: float) -> None:
    found = [
        braking(case, share, mirrored, reverse).duration
        for mirrored in (False, True) for reverse in (False, True)
    ]
    assert found == pytest.approx([found[0]] * 4, rel=1e-9)


def test_the_sampled_motion_keeps_the_limits() -> None:
    limits, _, least = CASES[0]
    found = braking(0, 1.02, mirrored=False, reverse=False)
    time = np.linspace(0.0, found.duration, 20001)
    bounds = (1.02 * least, *limits)
    for order, bound in enumerate(bounds, 1):
        values = found(time, derivative=order)
        assert np.abs(values).max() <= bound * (1.0 + 1e-9)


def test_another_duration_is_found_too() -> None:
    limits, first, least = CASES[0]
    alone = braking(0, 1.02, mirrored=False, reverse=False)
    velocity = 1.02 * least
    points = [
        Waypoint([0.0, 0.0], [0.0, 0.0], [first, 0.0]),
        Waypoint([20.0 * least * first, 1.5 * velocity * alone.duration]),
    ]
    found = plan(points, Limits(velocity, *limits), smoothness=6)
    assert verify(found).passed
    assert found.duration > 1.5 * alone.duration
