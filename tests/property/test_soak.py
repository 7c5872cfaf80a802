"""Some of the problems that the modules beside take by the million."""

from __future__ import annotations

import pytest

from segfmu.kernels.backend import COMPILED
from tests.campaign import campaign
from tests.property.soak import soak
from tests.property.soak_axes import soak_axes
from tests.property.soak_replan import soak as soak_replan

# of n = 4 a few motions take half a minute interpreted
FEW = [pytest.param(n, marks=pytest.mark.interpreted) for n in (2, 3)]

# the interpreted kernels take a hundred times as long
SHARE = 1 if COMPILED else 50


@campaign(500, 30_000)
@pytest.mark.interpreted
@pytest.mark.parametrize("shape", [0, 1])
@pytest.mark.parametrize("smoothness", [2, 3, 4, 5, 6])
def test_plans_are_valid(smoothness: int, shape: int, count: int) -> None:
    problems = max(count // SHARE, 20)
    tally = soak(smoothness, shape, problems, seed=7)
    assert tally.planned > problems / 4
    assert tally.invalid == []


@campaign(150, 3000)
@pytest.mark.interpreted
def test_axes_meet_as_early_as_they_can(count: int) -> None:
    planned, _, wrong = soak_axes(count // SHARE, seed=7)
    assert planned > (count / 3 if COMPILED else 0)
    assert wrong == []


@pytest.mark.parametrize("smoothness", [*FEW, 4, 5, 6])
@pytest.mark.parametrize("ends", [False, True])
@campaign(64, 2000)
def test_plans_are_replanned_and_stopped_anywhere(
    smoothness: int, ends: bool, count: int
) -> None:
    states = count if COMPILED else 2
    tally = soak_replan(smoothness, states, seed=7, ends=ends)
    assert tally.states >= states
    assert tally.refused == []
    assert tally.invalid == []
    assert tally.late == []
