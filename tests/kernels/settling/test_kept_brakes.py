"""Brakes that are kept are those that would be found anew, and only where all is the same."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import Lower
from segfmu.kernels.settling.records import KeptBrake, LeadRows, LeadTask, LeadWork

LIMITS = np.array([1.0, 1.0, 4.0, 20.0, 0.0])
# outside: the velocity, with accelerations that come inside at once or gently
STATES = np.array([[0.1, v, a, j, 0.0] for v, a, j in (
    (1.4, 1.3, 2.0), (-1.6, 0.4, -3.0), (0.9, 1.9, 5.0), (1.2, -2.1, 1.0), (-0.2, -1.5, -4.5),
    (2.5, 0.9, 0.0),
)])
CHANGES = (
    {"whole": True}, {"state": STATES[0] + [0.0, 0.0, 0.0, 1e-9, 0.0]},
    {"limits": LIMITS * [0.9, 1.0, 1.0, 1.0, 1.0]}, {"lower": (0.7, 0.0)}, {"lower": (0.0, 0.8)},
    {"state": STATES[0, :4], "limits": LIMITS[:4]},
)


def found(
    lead: FloatArray, state: FloatArray, limits: FloatArray = LIMITS, whole: bool = False,
    lower: tuple[float, float] = (0.0, 0.0),
) -> list[list[float]]:
    """What `find_brake` writes: its report, the state that is reached, timing and pieces."""
    width = limits.size
    lead[LeadWork.NOW] = 0.0
    lead[LeadWork.NOW, :width] = state
    lead[LeadWork.LOWER, : Lower.SIZE] = lower
    timing, coefficients = np.zeros((LeadRows.ALL, 2)), np.zeros((LeadRows.ALL, 2 * width - 2))
    count = backend.find_brake(whole, limits, lead, timing, coefficients)
    rows = slice(2 * LeadRows.PIECES, 2 * LeadRows.PIECES + max(count, 0))
    written = lead[[LeadWork.BRAKE, LeadWork.BRAKED]], timing[rows], coefficients[rows]
    return [[float(count)], *(array.ravel().tolist() for array in written)]


def work_space() -> FloatArray:
    return np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))


def test_kept_brakes_are_those_found_anew() -> None:
    lead = work_space()
    for state in (*STATES, *STATES[::-1], STATES[0], *STATES):
        assert found(lead, state) == found(work_space(), state)


@pytest.mark.parametrize("change", CHANGES)
def test_a_brake_is_kept_for_the_same_request_alone(change: dict) -> None:
    lead = work_space()
    found(lead, STATES[0])
    request = {"state": STATES[0]} | change
    assert found(lead, **request) == found(work_space(), **request) != found(lead, STATES[0])


def test_the_last_brakes_are_kept() -> None:
    lead = work_space()
    kept = lead[LeadWork.KEPT : LeadWork.NOW]
    for i, state in enumerate(STATES):
        found(lead, state)
        place = i % len(kept)
        assert kept[place, KeptBrake.STATE : KeptBrake.STATE + 5].tolist() == state.tolist()
        assert lead[LeadWork.TASK, LeadTask.OLDEST] == (i + 1) % len(kept)
    before = kept.copy()
    for state in STATES[-len(kept) :]:
        found(lead, state)
    assert (kept == before).all()


def test_a_state_without_brake_is_kept_as_such() -> None:
    lead = work_space()
    # a velocity far beyond its limit, and an acceleration that takes a minute to turn round
    limits = np.array([25.0, 0.1, 0.2, 40.0, 40.0, 40.0, 2.6])
    state = np.array([0.0, -157.0, 1060.0, -6580.0, 0.6, 26.0, 2980.0])
    for _ in range(2):
        assert found(lead, state, limits)[0] == [-1.0]
    assert lead[LeadWork.KEPT, KeptBrake.KIND] == limits.size
    assert lead[LeadWork.KEPT, KeptBrake.STEEP] == 0.0
