"""Motions whose velocity touches its limit at an end, in a gap of durations, over the optimum.

The optima are those of programs over 160 cells.
"""

from __future__ import annotations

import pytest

from segfmu import Limits, Waypoint, plan, verify
from tests.problems import shortest_duration

# limits; v, a -> w, b over a distance; the optimum [s]
TOUCHING = [
    (
        (3.75265108, 3.31651782, 4.23512914, 1.20135749, 0.74331329),
        (1.50106043, 1.32660713, -1.50106043, 1.32660713, 4.61658577), 16.597,
    ),
    (
        (0.924, 0.781, 1.17, 0.52, 1.38, 0.559), (-0.369, -0.312, -0.369, -0.312, -4.01), 9.303,
    ),
    (
        (4.130366712, 3.300159802, 2.110831541, 0.723594032),
        (-1.22716554713, 2.245606196927, -0.297110357712, -2.409298563538, 13.6241180242), 6.008,
    ),
    (
        (2.69115098, 3.12014126, 3.530330959, 1.123782217, 4.927545229, 2.074223503),
        (-1.29754033595, 1.98728948459, -1.2244203307, 0.541100241623, -0.332810251288), 8.701,
    ),
    (
        (1.72575917, 0.748852707, 1.08861638, 1.12135993),
        (-1.56817301, -0.314543832, 1.5308203, -0.359005691, 1.20787931), 7.689,
    ),
    (
        (1.2666736, 1.20649068, 0.988810525, 0.50973838),
        (-1.05946608, -0.290157598, -1.19390648, 0.114932836, 3.09548672), 14.463,
    ),
]
# these were once planned after the gap, which ends at these durations [s]
ENDS = [
    (TOUCHING[2], 14.3384), (TOUCHING[3], 13.6813), (TOUCHING[4], 10.86110),
    (TOUCHING[5], 19.01521),
]


def ends(state: tuple[float, ...], sign: float) -> list[Waypoint]:
    """Both waypoints."""
    v, a, w, b, distance = (sign * value for value in state)
    return [Waypoint([0.0], [v], [a]), Waypoint([distance], [w], [b])]


@pytest.mark.parametrize(("limits", "state", "optimum"), TOUCHING)
def test_the_velocity_touches_its_limit_near_the_optimum(limits, state, optimum) -> None:
    for sign in (1.0, -1.0):
        trajectory = plan(ends(state, sign), Limits(*limits), smoothness=len(limits))
        assert verify(trajectory).passed
        assert shortest_duration(trajectory) < 1.025 * optimum


@pytest.mark.parametrize(("problem", "end"), ENDS)
def test_durations_after_the_gap_stay_feasible(problem, end: float) -> None:
    limits, state, _ = problem
    for factor in (1.0001, 1.02, 1.1, 1.3, 2.0):
        trajectory = plan(
            ends(state, 1.0), Limits(*limits), smoothness=len(limits), duration=factor * end
        )
        assert verify(trajectory).passed
        assert trajectory.duration == pytest.approx(factor * end, rel=1e-12)
