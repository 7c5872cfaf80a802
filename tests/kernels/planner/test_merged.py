"""Profiles without cruise whose peak of velocity the limit decides."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan, verify
from segfmu.kernels.backend import COMPILED

pytestmark = pytest.mark.interpreted

# limits of velocity, acceleration, jerk and snap; v, a -> w, b over a distance
TOUCHING = [
    ((0.2527563, 0.40575217, 2.0, 0.43820065), (-0.08464547, 0.31082352, 0.0, 0.31082352, 0.0)),
    ((12.9112266, 27.66044251, None, 4.84200341), (0.0, 0.0, 0.0, 0.0, -48.23829319)),
    (
        (0.03348691, 0.05718965, None, 2.8474225, 1.33075115),
        (-0.0122507055, 4.60965117e-10, -0.00633367378, 7.19099818e-10, -0.0619159212),
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


@pytest.mark.parametrize("kind", ["same", "near", "velocity", "acceleration"])
def test_a_smoother_plan_is_not_shorter(kind: str) -> None:
    """Short motions between states of opposite velocities, which have several merged forms."""
    rng = np.random.default_rng(5)
    planned = 0
    problems = 400 if COMPILED else 40
    for _ in range(problems):
        limits = 10.0 ** rng.uniform(-1.0, 1.0, 3)
        v = rng.choice([0.1, 0.5, 0.9]) * limits[0]
        a = rng.choice([-0.5, 0.5, -0.9, 0.7]) * limits[1]
        w, b = -v, a
        if kind == "near":
            w *= 1.0 + rng.uniform(-0.01, 0.01)
        elif kind == "velocity":
            w = rng.uniform(-1.0, 1.0) * limits[0]
        elif kind == "acceleration":
            b = rng.uniform(-1.0, 1.0) * limits[1]
        distance = 10.0 ** rng.uniform(-6.0, 0.0) * rng.choice([-1.0, 1.0]) * limits[0]
        points = [Waypoint(0.0, v, a), Waypoint(distance, w, b)]
        try:
            smooth = plan(points, Limits(*limits.tolist()), smoothness=3)
        except InfeasibleError:
            continue
        planned += 1
        found = plan(points, Limits(*limits.tolist()), smoothness=2)
        assert found.duration <= smooth.duration * (1.0 + 1e-9), points
    assert planned > 0.375 * problems


@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
@pytest.mark.parametrize(
    ("limits", "velocity", "distance"),
    [
        # between the distance at which the limit is touched, and that of a cruise
        ((0.28486187, 0.74177279, 14.27583242, 441.42078495), 0.0, 0.12519671),
        ((1.86112331, 1.22292843, 2.08823284, 7.0861028), 0.0, 3.99686034),
        ((1.86112331, 1.22292843, 2.08823284, 7.0861028), 0.2, 3.99686034),
    ],
)
def test_a_motion_that_could_be_its_own_reverse_is(limits, velocity, distance, shape) -> None:
    points = [Waypoint([0.0], [velocity]), Waypoint([distance], [velocity])]
    trajectory = plan(points, Limits(*limits), shape=shape)
    times = np.linspace(0.0, trajectory.duration, 201)
    way = np.array([trajectory.state(time).position[0] for time in times])
    np.testing.assert_allclose(way, distance - way[::-1], atol=1e-9 * distance)
