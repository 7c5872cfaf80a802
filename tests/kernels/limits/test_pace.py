"""The search for a pace on uses whose answer is known."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from segfmu.kernels import backend
from segfmu.kernels.limits.records import Pace

FULL = 1.0 - 1e-6


def searched(use: Callable[[float], float], most: float) -> tuple[float, int]:
    """The pace of the last trial, and how many there were."""
    pace, trials, more = np.zeros(Pace.SIZE), 0, True
    backend.begin_pace(most, FULL, pace)
    while more:
        last, trials = float(pace[Pace.PACE]), trials + 1
        more = backend.next_pace(use(last), pace)
    return last, trials


@pytest.mark.parametrize("power", [1.0, 2.0, 3.0])
@pytest.mark.parametrize("at", [1e-2, 0.3, 0.999, 1.0, 1.001, 40.0])
def test_powers_of_the_pace(power: float, at: float) -> None:
    found, trials = searched(lambda pace: (pace / at) ** power, 1e3)
    assert (found / at) ** power == pytest.approx(1.0, abs=1e-6)
    assert found <= at * (1.0 + 1e-9) and trials <= 12


def test_the_motion_is_never_faster_than_it_may_be() -> None:
    assert searched(lambda pace: 0.1 * pace, 1.0) == (1.0, 1)
    found, _ = searched(lambda pace: 0.1 * pace, 3.0)
    assert found == 3.0


@pytest.mark.parametrize("held", [0.5, 0.9, 0.999])
def test_a_part_that_no_pace_reduces(held: float) -> None:
    found, _ = searched(lambda pace: held + pace**2, 1.0)
    assert held + found**2 == pytest.approx(1.0, abs=1e-6) and held + found**2 <= 1.0 + 1e-9


def test_no_pace_keeps_the_bounds() -> None:
    for use in (lambda pace: 1.2, lambda pace: 1.0 + 1e-6, lambda pace: 1e300):
        _, trials = searched(use, 1.0)
        assert trials <= 41


def test_faster_motions_that_cannot_be_planned() -> None:
    found, _ = searched(lambda pace: 1e300 if pace > 0.6 else 0.3 * pace, 1.0)
    assert 0.55 < found <= 0.6


@pytest.mark.parametrize("after", [4.0, 1e300])
def test_uses_that_jump(after: float) -> None:
    found, trials = searched(lambda pace: 0.4 * pace if pace < 0.7 else after, 1.0)
    assert 0.7 - 1e-7 < found < 0.7 and trials <= 41
    # rounding of the place of the jump does not decide
    near, _ = searched(lambda pace: 0.4 * pace if pace < 0.7 * (1.0 + 1e-10) else after, 1.0)
    assert near == pytest.approx(found, rel=1e-15)
