"""Where derivatives are zero within a piece, and what plans follow from it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from segfmu import Limits, Waypoint, plan
from segfmu.kernels.planner.excess import taylor_value, zero_time
from segfmu.planning.limits import NAMES

SIXTH = (
    0.9302846304540899, 0.8938130019309124, 3.765164603033461, 21.019906315954657,
    210.19906315954657, 2101.990631595466,
)


@pytest.mark.parametrize(("start", "slope"), [(1.0, -1.0), (-3.0, 3.0), (0.3, -0.3)])
def test_a_zero_that_is_met_exactly_is_kept(start: float, slope: float) -> None:
    """The first point tried, the middle, is the zero."""
    state = np.array([start, slope, 0.0])
    assert zero_time(0, 1, 2.0, state) == 1.0


@pytest.mark.parametrize("place", np.linspace(0.01, 0.99, 15))
def test_zeros_are_known_to_rounding(place: float) -> None:
    """Of 1 - (t / place)^3, which bends."""
    state = np.array([1.0, 0.0, 0.0, -6.0 / place**3])
    found = zero_time(0, 3, 1.0, state)
    assert abs(taylor_value(0, 3, found, state)) < 1e-12


@pytest.mark.parametrize(("length", "time"), [(3.0, 1.0), (0.7, 1.0), (1.0, 3.0), (1.3, 0.7)])
def test_limits_reached_for_an_instant_do_not_depend_on_units(length: float, time: float) -> None:
    """What a velocity exceeds its limit by was wrong by 2e-10, more than rounding may leave."""
    assert _duration(length, time) == pytest.approx(_duration(1.0, 1.0) * time, rel=1e-9)


def _duration(length: float, time: float) -> float:
    first: list[Any] = [0.8799471418995578, 0.0, 0.0]
    last: list[Any] = [1.8109060366003609, 0.87113513044902768, -0.20019850998388228]
    points = [
        Waypoint(*([value * length / time**i] for i, value in enumerate(state)))
        for state in (first, last)
    ]
    limits = {
        name: value * length / time ** (i + 1)
        for i, (name, value) in enumerate(zip(NAMES, SIXTH, strict=True))
    }
    return plan(points, Limits(**limits), smoothness=6).duration
