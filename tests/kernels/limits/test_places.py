"""Places of waypoints and free states, against a plain search through lists."""

from __future__ import annotations

import numpy as np

from segfmu.kernels import backend
from segfmu.kernels.limits.records import LimitRow, Unknown

LIMITS = 3 * LimitRow.SIZE


def route(rng) -> tuple[np.ndarray, np.ndarray]:
    """States (points, 3, 3) on a coarse grid, some free and many repeated, and dwells."""
    points = int(rng.integers(2, 9))
    states = rng.integers(0, 3, (points, 3, 3)).astype(float)
    for i in range(1, points):
        if rng.random() < 0.4:
            states[i] = states[i - 1]
    states[:, :, 1:][rng.random((points, 3, 2)) < 0.6] = np.nan
    return states, np.where(rng.random(points) < 0.2, 0.5, 0.0)


def runs(states: np.ndarray) -> list[list[int]]:
    """Waypoints by places; what is known of any waypoint is known of its place."""
    found, known = [[0]], states[0].copy()
    for i, state in enumerate(states[1:], 1):
        both = ~np.isnan(known) & ~np.isnan(state)
        if (known[both] == state[both]).all():
            found[-1].append(i)
            known = np.where(np.isnan(known), state, known)
        else:
            found.append([i])
            known = state.copy()
    return found


def along(places: int) -> np.ndarray:
    """A `Heading` from the first place to the last one, in the positive direction."""
    return np.array([places - 1.0, 1.0, 1.0, 1.0, 1.0])


def test_places_and_what_is_free_in_them() -> None:
    rng = np.random.default_rng(1)
    chosen = 0
    for _ in range(300):
        states, dwells = route(rng)
        given, place = states.copy(), np.zeros(len(states))
        backend.unite_waypoints(given, place)
        expected = runs(states)
        assert place.tolist() == [k for k, run in enumerate(expected) for _ in run]
        kinds = np.full(LIMITS + 6 * max(len(expected) - 2, 0), float(Unknown.LIMIT))
        led = np.zeros((len(states), 3))
        found = given.copy()
        backend.write_free(found, place, dwells, along(len(expected)), kinds, led)
        assert np.array_equal(found, np.nan_to_num(given))
        for k, run in enumerate(expected[1:-1], 1):
            kind = kinds[LIMITS + 6 * (k - 1) : LIMITS + 6 * k].reshape(2, 3)
            here, before, after = (states[i, :, 0] for i in (run[0], run[0] - 1, run[-1] + 1))
            passed = ((here - before) * (after - here) > 0.0) & (dwells[run].sum() == 0.0)
            free = np.isnan(given[run[0], :, 1:]).T & passed
            assert np.array_equal(kind == Unknown.STATE, free)
            assert np.array_equal(led[run] > 0.0, np.tile(free.any(axis=0), (len(run), 1)))
            chosen += int(free.sum())
        assert not led[expected[0]].any() and not led[expected[-1]].any()
    assert chosen > 100


def test_states_are_shares_of_limits() -> None:
    states, place = np.zeros((4, 3, 3)), np.array([0.0, 1.0, 1.0, 2.0])
    kinds = np.full(LIMITS + 6, float(Unknown.STATE))
    kinds[LIMITS + 4] = Unknown.GIVEN
    shares = np.array([0.5, -2.0, 0.1, 1.5, 0.3, -0.2])
    table = np.arange(1.0, 1.0 + 3 * LimitRow.SIZE).reshape(3, LimitRow.SIZE)
    unknowns = np.append(np.zeros(LIMITS), shares)
    backend.write_states(unknowns, kinds, table, place, along(3), states)
    limits = table[:, :2].T
    expected = np.clip(shares, -1.0, 1.0).reshape(2, 3) * limits * [[1, 1, 1], [1, 0, 1]]
    assert np.allclose(states[1, :, 1:].T, expected) and np.array_equal(states[1], states[2])
    assert not states[[0, 3]].any()
