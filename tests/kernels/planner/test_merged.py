"""Profiles without cruise whose peak of velocity the limit decides."""

from __future__ import annotations

import pytest

from segfmu import Limits, Trajectory, Waypoint, plan, verify

pytestmark = pytest.mark.interpreted

# limits of velocity, acceleration, jerk and snap; v, a -> w, b over a distance
TOUCHING = [
    ((0.2527563, 0.40575217, 2.0, 0.43820065), (-0.08464547, 0.31082352, 0.0, 0.31082352, 0.0)),
    ((12.9112266, 27.66044251, None, 4.84200341), (0.0, 0.0, 0.0, 0.0, -48.23829319)),
    (
        (0.03466304, 0.0320989, None, 2.35598645, 1.0),
        (-8.66576046e-03, 8.15477166e-10, -4.74436685e-03, 8.15477166e-10, -7.5e-2),
    ),
]


def planned(limits: tuple[float | None, ...], state: tuple[float, ...]) -> Trajectory:
    v, a, w, b, distance = state
    points = [Waypoint([0.0], [v], [a]), Waypoint([distance], [w], [b])]
    return plan(points, Limits(*limits))


@pytest.mark.parametrize(("limits", "state"), TOUCHING)
def test_the_peak_of_velocity_comes_up_to_its_limit(limits, state) -> None:
    trajectory = planned(limits, state)
    assert verify(trajectory).passed
    low, high = trajectory.extrema(1)
    assert max(-low[0], high[0]) > limits[0] * (1.0 - 1e-8)
    # no cruise holds the velocity: the limit is touched in passing
    _, lengths, coefficients = trajectory.pieces(0)
    assert coefficients[lengths > 1e-6, 2:].any(axis=1).all()
