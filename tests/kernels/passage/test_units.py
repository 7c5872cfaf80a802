"""Free states do not depend on units and places, to the last digits."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.free_missions import missions
from hypothesis import given
from hypothesis import strategies as st

from segfmu import Limits, Waypoint, plan
from segfmu.kernels.passage.units import few_digits
from segfmu.planning.limits import NAMES

DIGITS = 2.0**34
MISSIONS = list(missions(4, (4, 6), 3))
CHANGES = [(3.0, 1.0, 0.0), (1.0, 0.7, 0.0), (1.0, 1.0, 37.1), (-1.0, 1.0, 0.0)]


@given(st.floats(1e-200, 1e200), st.sampled_from([1.0, -1.0]))
def test_few_digits_are_near_and_stay(size: float, sign: float) -> None:
    found = few_digits(sign * size)
    assert abs(found - sign * size) <= size / DIGITS
    assert few_digits(found) == found
    assert few_digits(-sign * size) == -found
    # rounding is all but surely removed
    near = [few_digits(sign * size * (1.0 + k * 2.2e-16)) for k in range(-3, 4)]
    assert len(set(near)) <= 2 and abs(near[0] - near[-1]) <= 2.0 * size / DIGITS


@pytest.mark.parametrize("value", [0.0, 1e300, -1e300, np.inf, -np.inf])
def test_what_is_none_stays(value: float) -> None:
    assert few_digits(value) == value


@pytest.mark.parametrize("number", range(4))
@pytest.mark.parametrize(("length", "time", "place"), CHANGES)
def test_states_scale_with_the_mission(
    number: int, length: float, time: float, place: float
) -> None:
    mission = MISSIONS[number]
    usual = states(mission.positions, mission.limits)
    assert np.count_nonzero(usual) > 0
    powers = time ** np.arange(1.0, mission.limits.shape[1] + 1.0)
    limits = abs(length) * mission.limits / powers
    found = states(length * mission.positions + place, limits)
    found *= np.array([time, time * time])[:, None] / length
    np.testing.assert_allclose(found, usual, rtol=1e-14, atol=0.0)


def states(positions: np.ndarray, limits: np.ndarray) -> np.ndarray:
    """Velocities and accelerations of the plan through positions, shape (points, 2, axes)."""
    inner = [Waypoint(position, "free", "free") for position in positions[1:-1]]
    points = [Waypoint(positions[0]), *inner, Waypoint(positions[-1])]
    bounds = Limits(**dict(zip(NAMES, limits.T, strict=False)))
    found = plan(points, bounds, smoothness=4)
    return np.array([[point.velocity, point.acceleration] for point in found.waypoints])
