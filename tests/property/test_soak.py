"""A few thousand of the problems that the soak runs take by the million."""

from __future__ import annotations

import pytest

from segfmu.kernels.backend import COMPILED
from tests.property.soak import soak
from tests.property.soak_axes import soak_axes
from tests.property.soak_replan import soak as soak_replan

FEW = [pytest.param(n, marks=pytest.mark.interpreted) for n in (2, 3, 4)]

# the interpreted kernels take a hundred times as long
PROBLEMS = 3000 if COMPILED else 60


@pytest.mark.interpreted
@pytest.mark.parametrize("shape", [0, 1])
@pytest.mark.parametrize("smoothness", [2, 3, 4, 5, 6])
def test_plans_are_valid(smoothness: int, shape: int) -> None:
    tally = soak(smoothness, shape, PROBLEMS, seed=7)
    assert tally.planned > PROBLEMS / 4
    assert tally.invalid == []


@pytest.mark.interpreted
def test_axes_meet_as_early_as_they_can() -> None:
    problems, least = (150, 50) if COMPILED else (3, 0)
    planned, _, wrong = soak_axes(problems, seed=7)
    assert planned > least
    assert wrong == []


@pytest.mark.parametrize("smoothness", [*FEW, 5, 6])
@pytest.mark.parametrize("ends", [False, True])
def test_plans_are_replanned_and_stopped_anywhere(smoothness: int, ends: bool) -> None:
    count = 480 if COMPILED else 4
    tally = soak_replan(smoothness, count, seed=7, ends=ends)
    assert tally.states >= count
    assert tally.refused == []
    assert tally.invalid == []
    assert tally.late == []
