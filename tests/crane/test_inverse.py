"""The flat inverse: a plant under its forces follows the plan; wrong trajectories are refused."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Crane, FlatInverse, InputError, Limits, Waypoint, plan
from tests.crane.newton import accelerations

CRANE = Crane(2.2, 1.155, 1.0)
LIMITS = Limits([1.0, 0.4, 0.5], [1.0, 0.5, 0.8], [1.0, 0.5, 4.0], [10.0, 5.0, 30.0])
PAPER = [
    Waypoint([0.0, 0.0, -0.5]),
    Waypoint([0.07, 0.055, -0.5], [0.2, 0.17, 0.0], [0.34, 0.27, 0.0]),
    Waypoint([1.0, 0.8, -0.5]),
]
HOISTING = [
    Waypoint([0.0, 0.0, -1.2]),
    Waypoint([0.5, 0.3, -0.6], [0.4, 0.2, 0.1]),
    Waypoint([1.0, 0.5, -1.0]),
]


@pytest.mark.parametrize(
    ("points", "smoothness"), [(PAPER, 5), (HOISTING, 4)], ids=["paper", "hoisting"]
)
def test_plant_under_feedforward_follows_the_plan(points, smoothness: int) -> None:
    trajectory = plan(points, LIMITS, smoothness=smoothness)
    inverse = FlatInverse(CRANE, trajectory)

    def rate(t: float, state: np.ndarray) -> np.ndarray:
        force = inverse.force(t)
        return np.append(state[5:], accelerations(state, force, np.zeros(3), *CRANE.masses))

    state = inverse.state(0.0)
    # from one switching time to the next: across them forces are not smooth, and steps get small
    times = np.concatenate([trajectory.pieces(axis)[0] for axis in range(3)])
    for span in pairwise(np.unique(np.round([*times, trajectory.duration], 12))):
        run = solve_ivp(rate, span, state, method="DOP853", rtol=1e-11, atol=1e-12)
        state = run.y[:, -1]
        error = [CRANE.load(x)[0] - trajectory(t) for t, x in zip(run.t, run.y.T, strict=True)]
        assert np.abs(error).max() < 1e-7


def test_rates_and_accelerations_are_derivatives() -> None:
    inverse = FlatInverse(CRANE, plan(HOISTING, LIMITS))
    # away from switching times, where the fifth derivative jumps
    times = np.linspace(0.05, inverse.trajectory.duration - 0.05, 40)
    h = 1e-5
    numeric = (inverse.state(times + h) - inverse.state(times - h)) / (2.0 * h)
    assert numeric[:, :5] == pytest.approx(inverse.state(times)[:, 5:], abs=1e-8)
    assert numeric[:, 5:] == pytest.approx(inverse.acceleration(times), abs=1e-4)
    assert inverse.velocity(times) == pytest.approx(inverse.state(times)[:, 5:8])


def test_shapes_follow_the_times() -> None:
    inverse = FlatInverse(CRANE, plan(PAPER, LIMITS))
    assert inverse.force(0.3).shape == (3,)
    assert inverse.state([[0.1, 0.2, 0.3]]).shape == (1, 3, 10)


def test_heavier_load_needs_more_force() -> None:
    trajectory = plan(PAPER, LIMITS)
    light, heavy = (FlatInverse(Crane(2.2, 1.155, m), trajectory) for m in (1.0, 2.0))
    assert heavy.force(0.5)[2] == pytest.approx(2.0 * light.force(0.5)[2])
    times = np.linspace(0.0, trajectory.duration, 500)
    assert np.abs(heavy.force(times)[:, 0]).max() > np.abs(light.force(times)[:, 0]).max()


def test_wrong_trajectories_are_refused() -> None:
    flat = plan([Waypoint([0.0, 0.0]), Waypoint([1.0, 1.0])], Limits(1.0, 1.0, 1.0, 1.0))
    with pytest.raises(InputError, match="trajectory must be a plan, got NoneType"):
        FlatInverse(CRANE, None)
    with pytest.raises(InputError, match="HookCrane, got NoneType"):
        FlatInverse(None, flat)
    with pytest.raises(InputError, match="axes x, y, z"):
        FlatInverse(CRANE, flat)
    with pytest.raises(InputError, match="smoothness 4"):
        FlatInverse(CRANE, plan(PAPER[::2], Limits(1.0, 1.0, 1.0, 9.0), smoothness=3))
