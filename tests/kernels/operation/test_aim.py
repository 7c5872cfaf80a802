"""Ends of the load's range: the nearest one of workspace, rope and end stops."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import ActuatorBounds
from segfmu.kernels.clearance.records import Space
from segfmu.kernels.crane.records import RopeBounds
from segfmu.kernels.operation.aim import high_end, low_end
from segfmu.kernels.operation.records import Known

REACH = 1e-8


def known_of(rope: tuple[float, float], travel: tuple[float, float]) -> np.ndarray:
    """A load that a workspace of 100 m does not hold."""
    bounds = ActuatorBounds(
        travel_min=[-3.0, -4.0, travel[0]], travel=[7.0, 9.0, travel[1]]
    )
    known = np.zeros((Known.SIZE, Known.COLUMNS))
    known[Known.BOUNDS, : bounds.record.size] = bounds.record
    known[Known.ROPE, [RopeBounds.SHORTEST, RopeBounds.LONGEST]] = rope
    known[Known.SPACE, Space.WORKSPACE_MIN : Space.WORKSPACE_MIN + 3] = -100.0
    known[Known.SPACE, Space.WORKSPACE_MAX : Space.WORKSPACE_MAX + 3] = 100.0
    return known


@pytest.mark.parametrize(
    ("rope", "travel", "low", "high"),
    [
        ((1.0, 30.0), (2.0, 20.0), -20.0, -2.0),
        ((2.5, 18.0), (2.0, 20.0), -18.0, -2.5),
    ],
)
def test_a_long_rope_is_a_low_load(
    rope: tuple[float, float], travel: tuple[float, float], low: float, high: float
) -> None:
    known = known_of(rope, travel)
    assert low_end(2, known) == pytest.approx(low, abs=REACH)
    assert high_end(2, known) == pytest.approx(high, abs=REACH)


def test_bridge_and_trolley_end_at_their_stops() -> None:
    known = known_of((1.0, 30.0), (2.0, 20.0))
    ends = [(low_end(axis, known), high_end(axis, known)) for axis in range(2)]
    np.testing.assert_allclose(ends, [(-3.0, 7.0), (-4.0, 9.0)], atol=REACH)
