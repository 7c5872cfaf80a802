"""Free states of motions that are mirrored or run backwards are searched for in one order."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from segfmu.kernels import backend
from segfmu.kernels.limits.records import Heading, LimitRow, Unknown
from segfmu.kernels.planner.records import WaypointState

LIMITS = 3 * LimitRow.SIZE
# a few places of an axis, so that ways are often equal, none, or the same at both ends
PLACES = st.lists(
    st.tuples(*3 * [st.sampled_from([-2.0, -0.5, 0.0, 0.5, 1.0, 2.0])]), min_size=3, max_size=5
)


def states_of(places: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Velocities and accelerations that shares stand for, shape (places, 3, 2)."""
    heading = np.zeros(Heading.SIZE)
    backend.write_heading(places, heading)
    count = len(places)
    states = np.zeros((count, 3, WaypointState.SIZE))
    kinds = np.full(LIMITS + shares.size, float(Unknown.STATE))
    unknowns = np.append(np.zeros(LIMITS), shares)
    table = np.ones((3, LimitRow.SIZE))
    backend.write_states(unknowns, kinds, table, np.arange(float(count)), heading, states)
    return states[:, :, 1:]


def is_its_reverse(places: np.ndarray) -> bool:
    """Whether the ways are as long from the last place on as from the first one."""
    ways = np.abs(np.diff(places, axis=0))
    return np.array_equal(ways, ways[::-1])


@given(PLACES, st.integers(0, 999), st.booleans(), st.booleans())
def test_the_same_unknowns_are_the_same_motion(
    rows: list[tuple[float, ...]], seed: int, mirrored: bool, reverse: bool
) -> None:
    places = np.array(rows)
    shares = np.random.default_rng(seed).uniform(-1.0, 1.0, 6 * (len(rows) - 2))
    changed, expected = places, states_of(places, shares)
    if mirrored:
        changed, expected = -changed, -expected
    if reverse and not is_its_reverse(places):
        changed, expected = changed[::-1].copy(), expected[::-1] * [-1.0, 1.0]
    # the others have no states to search for
    moving = np.ptp(places, axis=0) > 0.0
    assert np.array_equal(states_of(changed, shares)[:, moving], expected[:, moving])


@pytest.mark.parametrize("shift", [0.1, 1e-15, -3e-16])
def test_rounding_does_not_turn_a_heading(shift: float) -> None:
    heading = np.zeros((2, Heading.SIZE))
    places = np.array([[0.0, 1.0, -1.0], [0.3, 1.3, -1.0], [0.6, 0.7, -1.1]])
    for row, by in zip(heading, (0.0, shift), strict=True):
        backend.write_heading(places + by, row)
    assert np.array_equal(*heading)
