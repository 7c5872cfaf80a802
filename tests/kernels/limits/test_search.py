"""The search for limits on plans that are made up, whose shortest one is known."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from segfmu.kernels import backend
from segfmu.kernels.limits.records import (
    LimitRow,
    Search,
    SearchState,
    SearchValues,
    Unknown,
    Values,
)

SIZE, USES = 3 * LimitRow.SIZE, Values.SIZE - Values.USE


def found(
    shorter: NDArray[np.float64], more: NDArray[np.float64], starts: NDArray[np.float64]
) -> float:
    """Logarithm of the duration of the best plan; -shorter @ x is that of a plan, more @ x of uses.

    x are the logarithms of its limits.
    """
    kinds = np.full(SIZE, float(Unknown.LIMIT))
    search, values = np.zeros((Search.SIZE, SIZE)), np.zeros((SearchValues.SIZE, Values.SIZE))
    slopes, newton = np.zeros((SIZE, Values.SIZE)), np.zeros((2 * SIZE, SIZE))
    backend.begin_limits(starts, kinds, search)
    going_on = True
    while going_on:
        trial = search[Search.TRIAL]
        duration, uses = float(np.exp(-shorter @ trial)), np.exp(more @ trial)
        going_on = backend.next_limits(duration, uses, starts, search, values, slopes, newton)
    best = search[Search.BEST]
    assert (more @ best <= 1e-9).all()
    assert search[Search.STATE, SearchState.BEST] == pytest.approx(-shorter @ best, abs=1e-9)
    return float(search[Search.STATE, SearchState.BEST])


@pytest.mark.parametrize("seed", range(4))
def test_the_search_nearly_reaches_the_optimum(seed: int) -> None:
    rng = np.random.default_rng(seed)
    more = rng.uniform(0.0, 0.5, (USES, SIZE))
    # by these multipliers of the uses no plan that keeps the bounds is shorter than 1 s
    shorter = 0.1 * rng.dirichlet(np.ones(6)) @ more[:6]
    starts = rng.uniform(-1.0, 1.0, (4, SIZE))
    # each start at the pace at which it just keeps the bounds
    order = 1.0 + np.arange(SIZE) % LimitRow.SIZE % LimitRow.VELOCITY_MIN
    slower = ((more @ starts.T) / (more @ order)[:, None]).max(axis=0)
    begun = (slower * (shorter @ order) - starts @ shorter).min()
    assert begun > 0.02
    assert -1e-9 <= found(shorter, more, starts) <= 1e-3


def test_the_state_of_a_search_fits_in_its_row() -> None:
    """A search without free states has the fewest columns; what is beyond them is written over."""
    assert SearchState.SIZE <= SIZE
