"""Which of the states on a path are chosen."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Limits, Trajectory, Waypoint, plan
from segfmu.kernels.passage.records import Free
from segfmu.kernels.passage.search import DIGITS, highest_state
from segfmu.planning.limits import NAMES

FIFTH = (0.5697802438599863, 0.5349784030194317, 3.196364959837821, 36.848135636469976,
         368.48135636469976)
PLACES = (1.1855021537870853, 0.5471397146986411, 2.070237833456975, 1.262025278309951)


def test_accelerations_are_chosen_next_to_their_limit() -> None:
    assert highest_state(Free.VELOCITY, 3.0) == 3.0
    assert highest_state(Free.ACCELERATION, 3.0) == 3.0 - 3.0 / DIGITS


def test_free_states_at_a_limit_do_not_depend_on_units() -> None:
    """The load turns at both waypoints, with as much acceleration as it may have."""
    found = _plan(1.0)
    accelerations = np.array([found.state(t).acceleration[0] for t in found.waypoint_times[1:3]])
    np.testing.assert_array_equal(np.abs(accelerations) < FIFTH[1], True)
    np.testing.assert_allclose(np.abs(accelerations), FIFTH[1], rtol=1e-4)
    for length in (3.0, 0.7):
        assert _plan(length).duration == pytest.approx(found.duration, rel=1e-9)


def _plan(length: float) -> Trajectory:
    middle = [Waypoint([length * p], "free", "free") for p in PLACES[1:-1]]
    points = [Waypoint([length * PLACES[0]]), *middle, Waypoint([length * PLACES[-1]])]
    limits = {name: length * value for name, value in zip(NAMES, FIFTH, strict=False)}
    return plan(points, Limits(**limits), smoothness=5)
