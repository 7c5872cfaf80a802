"""Steps of the search beside SciPy's linear programs."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linprog

from segfmu.kernels.limits.records import Search, SearchState, SearchValues, Values
from segfmu.kernels.limits.step import write_step
from tests.campaign import soaked


@pytest.mark.parametrize("seed", [*range(4), *soaked(*range(4, 12))])
@pytest.mark.parametrize("size", [1, 4, 12])
def test_a_step_is_that_of_the_linear_program(seed: int, size: int) -> None:
    rng = np.random.default_rng(seed)
    search, values = np.zeros((Search.SIZE, 24)), np.zeros((SearchValues.SIZE, Values.SIZE))
    slopes = rng.normal(size=(size, Values.SIZE))
    # uses from none to all
    centre = values[SearchValues.CENTRE, Values.USE :]
    centre[:] = rng.choice([0.0, 0.4, 0.9, 0.9999], centre.size)
    search[Search.FREE, :size] = rng.random(size) < 0.8
    state = search[Search.STATE]
    state[SearchState.UNKNOWNS], state[SearchState.RADIUS] = size, 0.3
    write_step(search, values, slopes, np.zeros((2 * size, max(size, 2))))
    step, free = search[Search.STEP, :size], search[Search.FREE, :size] > 0.0
    use = values[SearchValues.CENTRE, Values.USE :]
    near = use > 0.3
    assert (np.abs(step) <= 0.3).all()
    assert step[~free] == pytest.approx(0.0, abs=1e-9)
    assert ((use + slopes[:, Values.USE :].T @ (free * step))[near] <= 1.0).all()
    gradient = free * slopes[:, Values.DURATION]
    best = linprog(
        gradient, slopes[:, Values.USE :].T[near] * free, 1.0 - use[near], bounds=(-0.3, 0.3)
    )
    promised = -float(gradient @ step)
    assert promised == pytest.approx(state[SearchState.PREDICTED], abs=1e-12)
    # a little remains to the bounds, at most this share of what could be gained anywhere
    assert -best.fun - 1e-3 * 0.3 * np.abs(gradient).sum() <= promised <= -best.fun + 1e-9
