"""Motions whose velocity touches its limit at an end, in a gap of durations, over the optimum.

The optima are those of programs over 160 cells.
"""

from __future__ import annotations

import pytest

from segfmu import Limits, Waypoint, plan, verify

# limits; v, a -> w, b over a distance; the optimum [s]
TOUCHING = [
    (
        (3.75265108, 3.31651782, 4.23512914, 1.20135749, 0.74331329),
        (1.50106043, 1.32660713, -1.50106043, 1.32660713, 4.61658577), 16.594,
    ),
    (
        (0.924, 0.781, 1.17, 0.52, 1.38, 0.559), (-0.369, -0.312, -0.369, -0.312, -4.01), 9.31,
    ),
]


@pytest.mark.parametrize(("limits", "state", "optimum"), TOUCHING)
def test_the_velocity_touches_its_limit_near_the_optimum(limits, state, optimum) -> None:
    v, a, w, b, distance = state
    for sign in (1.0, -1.0):
        points = [Waypoint([0.0], [sign * v], [sign * a]),
                  Waypoint([sign * distance], [sign * w], [sign * b])]
        trajectory = plan(points, Limits(*limits), smoothness=len(limits))
        assert verify(trajectory).passed
        assert trajectory.duration < 1.02 * optimum
