"""Targets beside a load at the end of its rope, which needs a longer one to go there at once."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import ActuatorBounds, Clearance, Crane, Limits, Operator
from tests.campaign import campaign

GRAVITY = 9.81


def crane_of(mass: float, rope: float) -> Crane:
    return Crane(
        bridge_mass=3.0 * mass, trolley_mass=mass, payload_mass=mass, rope_min=0.1 * rope,
        rope_max=rope,
    )


def limits_of(rope: float, sway: float, snap: float | None) -> Limits:
    """With an acceleration at which a load hangs aslant by `sway` [rad]."""
    period = np.sqrt(rope / GRAVITY)
    acceleration = GRAVITY * sway
    jerk = 3.0 * acceleration / period
    return Limits(
        0.5 * rope / period, acceleration, jerk, None if snap is None else snap * jerk / period
    )


def goes_to(operator: Operator, target: np.ndarray, rope: float) -> float:
    """When it rests there, in sqrt(l / g)."""
    period = np.sqrt(rope / GRAVITY)
    operator.command("target", target=target)
    for _ in range(4000):
        load = operator.step(0.1 * period)
        assert operator.setpoints[5] <= rope * (1.0 + 1e-9)
        if np.abs(load[0] - target).max() < 1e-9 * rope and np.abs(load[1]).max() == 0.0:
            return float(operator.time / period)
    return np.inf


@pytest.mark.parametrize("smoothness", [4, 6])
@pytest.mark.parametrize("room", [0.2, 1e-2, 1e-4])
@pytest.mark.parametrize("rises", [True, False])
def test_the_load_rises_before_it_goes_aside_and_sinks_behind(
    rises: bool, room: float, smoothness: int
) -> None:
    ends = np.array([[0.0, 0.0, -1.0], [2.0, -1.0, -1.0 + room]]) * 9.0
    start, target = ends if rises else ends[::-1]
    operator = Operator(
        crane_of(5e3, 9.0), limits_of(9.0, 0.15, 5.0), start, smoothness=smoothness
    )
    assert goes_to(operator, target, 9.0) < (60.0 if room > 1e-3 else 400.0)


def test_the_travel_of_the_hoist_is_an_end_of_the_rope() -> None:
    travel = ActuatorBounds(travel=[1e3, 1e3, 9.0], travel_min=[-1e3, -1e3, 1.0])
    operator = Operator(
        crane_of(5e3, 20.0), limits_of(9.0, 0.15, 5.0), [0.0, 0.0, -9.0], bounds=travel
    )
    assert goes_to(operator, np.array([18.0, -9.0, -8.0]), 9.0) < 60.0
    assert operator.refused == "travel"


def test_nothing_moves_to_a_target_beyond_the_end_of_the_rope() -> None:
    operator = Operator(crane_of(5e3, 9.0), limits_of(9.0, 0.15, 5.0), [0.0, 0.0, -8.0])
    assert goes_to(operator, np.array([18.0, -9.0, -9.1]), 9.0) == np.inf
    assert operator.status == operator.refused == "rope"
    np.testing.assert_array_equal(operator.load[0], [0.0, 0.0, -8.0])


@campaign(12, 600, "seeds")
def test_no_target_is_refused_for_ever(seeds: int) -> None:
    for seed in range(seeds):
        rng = np.random.default_rng((5, seed))
        mass = 10.0 ** rng.uniform(-1.0, 4.8)
        rope = float(np.clip(0.5 * mass**0.4, 0.3, 50.0))
        wide = rope * rng.uniform(1.0, 6.0)
        limits = limits_of(rope, 10.0 ** rng.uniform(-2.0, -0.5), rng.choice([None, 3.0, 10.0]))
        space = Clearance(
            minimum=[-wide, -wide, -rope], maximum=[wide, wide, -0.1 * rope]
        )
        start, target = rng.uniform(-wide, wide, (2, 3))
        start[0] = rng.choice([wide, start[0]])
        start[2], target[2] = -rope, rope * (10.0 ** rng.uniform(-4.0, -0.1) - 1.0)
        if rng.integers(2):
            start, target = target, start
        operator = Operator(
            crane_of(mass, rope), limits, start, clearance=space,
            smoothness=int(rng.integers(4, 7)),
        )
        assert goes_to(operator, target, rope) < np.inf, seed
