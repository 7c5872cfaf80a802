"""Free waypoint states: chosen within the limits, and never slower than stopping."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize

from segfmu import InfeasibleError, InputError, Limits, Waypoint, plan, verify

LIMITS = Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0])
STAIRS = [[0.0, 0.0], [0.5, 0.2], [1.0, 0.5], [1.4, 0.8]]


def via(places, **options) -> tuple[float, float]:
    """Durations with rest at the inner points, and with free states there."""
    ends = Waypoint(places[0]), Waypoint(places[-1])
    inner = places[1:-1]
    resting = plan([ends[0], *(Waypoint(p) for p in inner), ends[1]], LIMITS, **options)
    passing = plan(
        [ends[0], *(Waypoint(p, "free", "free") for p in inner), ends[1]], LIMITS, **options
    )
    assert verify(passing).passed
    return resting.duration, passing.duration


@pytest.mark.parametrize("synchronize", ["waypoints", "total", "none"])
@pytest.mark.parametrize("smoothness", [3, 4])
def test_passing_is_much_faster_than_stopping(synchronize: str, smoothness: int) -> None:
    resting, passing = via(STAIRS, synchronize=synchronize, smoothness=smoothness)
    assert passing < 0.7 * resting


def test_points_on_a_line_cost_almost_nothing() -> None:
    # passing halfway is a detour of the limits only: the plan without the point is a lower bound
    direct = plan([Waypoint([0.0]), Waypoint([2.0])], Limits(1.0, 1.0, 1.0, 10.0)).duration
    points = [Waypoint([0.0]), Waypoint([1.0], "free", "free"), Waypoint([2.0])]
    through = plan(points, Limits(1.0, 1.0, 1.0, 10.0)).duration
    assert direct <= through * (1.0 + 1e-9)
    assert through < 1.01 * direct


def test_given_states_stay() -> None:
    points = [
        Waypoint([0.0, 0.0]), Waypoint([0.5, 0.2], [0.3, None], [0.0, None]), Waypoint([1.0, 0.5])
    ]
    chosen = plan(points, LIMITS).waypoints[1]
    assert chosen.velocity[0] == 0.3
    assert chosen.acceleration[0] == 0.0
    assert np.isfinite(chosen.velocity[1])


def test_ends_and_dwells_rest() -> None:
    points = [
        Waypoint([0.0, 0.0], "free"), Waypoint([0.5, 0.2], "free", "free", dwell=1.0),
        Waypoint([1.0, 0.5], "free", "free"),
    ]
    for point in plan(points, LIMITS).waypoints:
        assert not point.velocity.any()
        assert not point.acceleration.any()


@settings(max_examples=15, deadline=None)
@given(
    st.lists(
        st.tuples(st.sampled_from([0.0, 0.5, 1.0]) | st.floats(-1.0, 2.0), st.floats(-1.0, 1.0)),
        min_size=3, max_size=5, unique=True,
    ),
    st.sampled_from(["waypoints", "total", "none"]),
)
def test_never_slower_than_stopping(places, synchronize: str) -> None:
    steps = np.abs(np.diff(np.array(places), axis=0)).max(axis=1)
    assume(steps.min() > 1e-9)
    resting, passing = via([list(p) for p in places], synchronize=synchronize)
    assert passing <= resting * (1.0 + 1e-9)


@pytest.mark.parametrize("given", ["fast", [None, "free"], [None], ["free", 1.0]])
def test_other_words_are_refused(given) -> None:
    with pytest.raises(InputError, match="velocity"):
        Waypoint([0.0, 0.0], given)


@pytest.mark.parametrize(
    "places",
    [
        [[0.0, 0.0], [0.2, 0.1], [2.0, 0.8]],
        [[0.27, 0.93], [-0.02, 1.85], [-0.05, 1.98]],
        [[-0.01, 0.68], [-0.05, 0.86], [-0.35, 0.97]],
    ],
)
def test_free_states_are_near_the_best_that_another_search_finds(places) -> None:
    """Nelder and Mead's simplex over the four free numbers, from several starts."""
    bounds = np.concatenate([LIMITS.velocity, LIMITS.acceleration])

    def duration(shares: np.ndarray) -> float:
        state = np.clip(shares, -1.0, 1.0) * bounds
        middle = Waypoint(places[1], state[:2], state[2:])
        try:
            return plan([Waypoint(places[0]), middle, Waypoint(places[2])], LIMITS).duration
        except InfeasibleError:
            return 1e3

    random = np.random.default_rng(0)
    starts = random.uniform(-0.5, 0.5, (4, 4))
    starts[:, :2] += 0.3 * np.sign(np.subtract(places[2], places[0]))
    options = {"xatol": 1e-3, "fatol": 1e-4, "maxfev": 200}
    best = min(
        minimize(duration, start, method="Nelder-Mead", options=options).fun for start in starts
    )
    _, passing = via(places)
    assert passing < 1.015 * best
