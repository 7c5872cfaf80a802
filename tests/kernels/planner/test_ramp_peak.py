"""Bounds of the velocity inside a ramp that crosses zero, against the exact extreme."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.ramp_peak import extreme_gain, ramp_extreme_velocity
from tests.problems import packed_axis

LIMITS = (1.0, 1.0, 2.0, 9.0, 60.0, 500.0, 5000.0)


@pytest.mark.parametrize("stretch", [1.0, 1.7])
@pytest.mark.parametrize("shape", [0, 1])
@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_the_bound_of_an_extreme_velocity(n: int, shape: int, stretch: float) -> None:
    axis = packed_axis(n, shape, list(LIMITS[: n + 1]))
    random = np.random.default_rng(n)
    closest = np.inf
    for _ in range(300):
        a, b = random.uniform(-1.0, 1.0, 2) * 10.0 ** random.uniform(-6.0, 0.0, 2)
        if a * b >= 0.0:
            b = -b
        basis, _ = ramp_duration(abs(b - a), axis)
        duration = stretch * basis
        extreme = ramp_extreme_velocity(0.3, a, b, duration, basis, axis)
        near = 0.3 if abs(a) <= abs(b) else 0.3 + 0.5 * (a + b) * duration
        gain = extreme_gain(a, b, duration, basis, axis)
        # up to rounding of the sum
        reached = abs(extreme - near)
        assert reached <= gain * (1.0 + 1e-9) + 1e-15
        assert (extreme - near) * a >= -1e-15
        if reached > 1e-6:
            closest = min(closest, gain / reached)
    assert closest < (2.1 if shape == 0 else 1.0001 if n == 2 else 1.3)
