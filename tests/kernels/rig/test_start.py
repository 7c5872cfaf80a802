"""Where the crane starts, and when its reference is elsewhere: scales of a lab rig and of 40 t."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

from segfmu.kernels.crane.records import Axes, State
from segfmu.kernels.rig.records import StartFault, StartStatus
from segfmu.kernels.rig.start import (
    check_start,
    check_start_rope,
    is_elsewhere,
    judge_start,
    start_state,
)

ROPE = State.POSITION + Axes.ROPE
LENGTHS = pytest.mark.parametrize("length", [0.5, 30.0])


def hanging(length: float) -> np.ndarray:
    found = np.zeros(State.SIZE)
    found[ROPE] = length
    return found


def farthest(place: int, length: float) -> float:
    """A quarter of the rope, 0.8 rad, and these by the pendulum's time."""
    own = 0.8 if State.ANGLE <= place < State.VELOCITY or place >= State.RATE else 0.25 * length
    return own if place < State.VELOCITY else own / sqrt(length / 9.81)


@LENGTHS
@pytest.mark.parametrize("place", range(State.SIZE))
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_what_is_far_is_told_on_the_cranes_own_scale(place: int, sign: float, length) -> None:
    fault = np.zeros(StartFault.SIZE)
    reference, state = hanging(length), hanging(length)
    state[place] += 0.99 * sign * farthest(place, length)
    assert judge_start(state, reference, 9.81, fault) == StartStatus.FITS
    state[place] += 0.02 * sign * farthest(place, length)
    assert judge_start(state, reference, 9.81, fault) == StartStatus.FAR
    told = fault[[StartFault.PLACE, StartFault.VALUE, StartFault.BOUND]]
    assert told.tolist() == [place, state[place], reference[place]]
    reference[ROPE] = 0.0
    assert judge_start(state, reference, 9.81, fault) == StartStatus.FITS


def test_the_farthest_one_is_told() -> None:
    fault, state = np.zeros(StartFault.SIZE), hanging(1.0)
    state[0], state[1], state[State.ANGLE] = 0.5, -0.9, 1.0
    assert judge_start(state, hanging(1.0), 9.81, fault) == StartStatus.FAR
    assert fault[StartFault.PLACE] == 1


@pytest.mark.parametrize(
    ("length", "shortest", "longest", "bound"),
    [(0.5, 0.2, 1.0, None), (0.5, 0.0, 0.0, None), (0.1, 0.2, 0.0, 0.2), (1.01, 0.2, 1.0, 1.0),
     (0.1, 0.2, 1.0, 0.2), (1.0, 1.0, 1.0, None)],
)
def test_the_rope_starts_within_its_bounds(length, shortest, longest, bound) -> None:
    fault = np.zeros(StartFault.SIZE)
    found = check_start_rope(length, shortest, longest, fault)
    assert found == (StartStatus.FITS if bound is None else StartStatus.RANGE)
    if bound is not None:
        assert fault[[StartFault.PLACE, StartFault.VALUE, StartFault.BOUND]].tolist() == [
            ROPE, length, bound,
        ]


@LENGTHS
@pytest.mark.parametrize("axis", range(Axes.SIZE))
def test_a_reference_that_moves_is_not_elsewhere(axis: int, length: float) -> None:
    """In a step it goes at most twice as far as its velocity at the end has it, but for 1/1000."""
    before, reference = hanging(length), hanging(length)
    reference[State.VELOCITY + axis] = -0.4
    for share in (0.0, 0.98, -0.98, 1.02, -1.02):
        reference[axis] = before[axis] + share * (2.0 * 0.05 * 0.4 + 1e-3 * length)
        assert is_elsewhere(before, reference, 0.05) == (abs(share) > 1.0)
    reference[ROPE] = 0.0
    assert is_elsewhere(before, reference, 0.05) == 0


def test_start_values_are_deviations_from_the_reference() -> None:
    own, held, reference, state = hanging(0.55), hanging(0.5), hanging(0.8), np.zeros(State.SIZE)
    own[0], reference[0], reference[1] = 0.1, 2.0, 3.0
    start_state(own, held, reference, state)
    # beyond the reference's own start values by 0.05 m and 0.1 m
    assert state[[0, 1, ROPE]] == pytest.approx([2.1, 3.0, 0.85])
    start_state(own, held, own, state)
    assert np.array_equal(state, own)
    reference[ROPE] = 0.0
    start_state(own, held, reference, state)
    assert np.array_equal(state, own)


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_load_hangs_below_the_trolley(sign: float) -> None:
    fault, state = np.zeros(StartFault.SIZE), hanging(0.5)
    for place in (State.ANGLE, State.ANGLE + 1):
        state[place] = 1.57 * sign
        assert check_start(state, hanging(0.5), fault) == StartStatus.FITS
        state[place] = 1.571 * sign
        assert check_start(state, hanging(0.5), fault) == StartStatus.SWAY
        assert fault[StartFault.PLACE] == place
        state[place] = 0.0
    assert check_start(hanging(0.0), hanging(0.5), fault) == StartStatus.NO_ROPE
