"""Some hundreds of the states that `soak_outside` takes by the thousand, and a sample of optima."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.coming_inside import ratios

from tests.campaign import soaked_rows
from tests.kernels.planner.c_planner import Planner
from tests.property.soak_outside import try_ruckig, try_states


@pytest.mark.parametrize(("n", "count"), [
    (2, 30), (3, 30), (4, 20), (5, 4), (6, 2),
    *soaked_rows((2, 60), (3, 60), (4, 40), (5, 8), (6, 4)),
])
def test_no_state_is_refused_and_none_is_outside_after_the_told_time(
    n: int, count: int, planner: Planner
) -> None:
    tally = try_states(n, count, 7, planner)
    assert tally.outside > count
    assert tally.refused == []
    assert tally.wrong == []


def test_no_problem_of_the_recipe_of_ruckig_is_refused() -> None:
    tally = try_ruckig(300, 7)
    assert tally.outside > 10
    assert tally.refused == []
    assert tally.wrong == []


@pytest.mark.parametrize(("n", "worst"), [(3, 1.02), *soaked_rows((2, 1.002), (4, 1.02))])
def test_states_come_inside_in_about_the_least_time(n: int, worst: float) -> None:
    found = ratios(n, 8, 7)
    assert np.max(found) < worst
