"""Splines against closed forms and samples."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest

from segfmu.kernels.spline.records import Mesh
from segfmu.planning.splines import AxisBounds, spline_motion, spline_use

FREE = np.array([-inf, inf])


def rested(position: float, n: int) -> np.ndarray:
    return np.array([position, *np.zeros(n)])


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
def test_the_least_jerk_between_rests_is_the_closed_form(scale: float) -> None:
    # four quarters of constant jerk cover J T^3 / 32
    duration, distance = 2.0, 3.0 * scale
    jerk = 32.0 * distance / duration**3
    limits = np.array([0.0, 0.0, 1.25 * jerk])
    bounds = AxisBounds(limits, limits[:2], FREE)
    ends = rested(scale, 2), rested(scale + distance, 2)
    assert spline_use(*ends, bounds, duration) == pytest.approx(0.8, rel=1e-6)
    pieces = spline_motion(*ends, bounds, duration)
    assert pieces is not None and pieces.shape == (Mesh.CELLS, 4)
    found = 6.0 * pieces[:, 3]
    quarters = np.repeat([1.0, -1.0, 1.0], [Mesh.CELLS // 4, Mesh.CELLS // 2, Mesh.CELLS // 4])
    np.testing.assert_allclose(found, jerk * quarters, rtol=1e-6)
    tight = AxisBounds(limits * 0.79, limits[:2], FREE)
    assert spline_motion(*ends, tight, duration) is None


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("seed", range(4))
def test_a_motion_keeps_its_ends_limits_and_range(n: int, seed: int) -> None:
    random = np.random.default_rng((n, seed))
    first, last = np.zeros((2, n + 1))
    first[:3], last[:3] = random.uniform(-1.0, 1.0, (2, 3))
    duration = random.uniform(2.0, 5.0)
    # limits that the least multiple of others makes feasible, just
    limits = 2.0 ** np.arange(n + 1)
    limits[5:] = 0.0
    use = spline_use(first, last, AxisBounds(limits, 0.7 * limits[:2], FREE), duration)
    # the ends keep them as well
    use = max(use, 1.5)
    bounds = AxisBounds(1.05 * use * limits, 1.05 * 0.7 * use * limits[:2], FREE)
    wide = spline_motion(first, last, bounds._replace(limits=3.0 * bounds.limits), duration)
    assert wide is not None
    times = np.linspace(0.0, duration / Mesh.CELLS, 9)
    reached = np.array([np.polynomial.Polynomial(row)(times) for row in wide])
    allowed = np.array([reached.min() - 0.01, reached.max() + 0.01])
    for own in (bounds, AxisBounds(4.0 * bounds.limits, 2.0 * bounds.lower, allowed)):
        pieces = spline_motion(first, last, own, duration)
        assert pieces is not None
        most = np.where(own.limits > 0.0, own.limits, inf)
        lows = [own.allowed[0], *-own.lower, *-most[2:]]
        highs = [own.allowed[1], *most]
        for order in range(n + 2):
            rows = [np.polynomial.Polynomial(row).deriv(order) for row in pieces]
            values = np.array([row(times) for row in rows])
            size = np.abs(values).max()
            assert values.min() >= lows[order] - 1e-9 * size
            assert values.max() <= highs[order] + 1e-9 * size
            if order <= n:
                np.testing.assert_allclose(values[1:, 0], values[:-1, -1], atol=1e-9 * size)
                assert values[0, 0] == pytest.approx(first[order], abs=1e-12 * size)
                assert values[-1, -1] == pytest.approx(last[order], abs=1e-9 * size)
