"""Free waypoint states: chosen within the limits, and never slower than stopping."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.free_missions import Mission, missions
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize

from segfmu import InfeasibleError, InputError, Limits, Waypoint, plan, verify
from tests.campaign import soaked
from tests.planning.routes import route

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


def walk(seed: int, count: int) -> np.ndarray:
    random = np.random.default_rng(seed)
    steps = random.uniform(0.2, 1.5, (count, 1)) * [1.0, 0.5, 0.2]
    return np.cumsum(steps + 0.3 * random.normal(size=(count, 3)), axis=0)


@pytest.mark.parametrize("seed", [0, *soaked(1, 2, 3)])
def test_long_missions_are_planned_and_better_than_with_free_velocities_alone(seed: int) -> None:
    places = walk(seed, 10 + 3 * seed)
    totals = {}
    for acceleration in (None, "free"):
        inner = [Waypoint(p, "free", acceleration) for p in places[1:-1]]
        trajectory = plan([Waypoint(places[0]), *inner, Waypoint(places[-1])], Limits(1, 1, 4, 20))
        assert verify(trajectory).passed
        totals[acceleration] = trajectory.duration
    assert totals["free"] <= totals[None]


def test_a_long_arc_is_shorter_than_its_halves_with_a_stop_between() -> None:
    """In each of its first paths some of the 79 intervals are slow; it took up to twice as long."""
    arc = list(missions(34, (80, 80), 3))[-1]
    whole, *halves = (
        plan(Mission(arc.kind, places, arc.limits).waypoints("free", "free"), arc.bounds)
        for places in (arc.positions, arc.positions[:41], arc.positions[40:])
    )
    assert arc.kind == "arc" and verify(whole).passed
    assert whole.duration < 0.8 * sum(half.duration for half in halves)


def test_polishing_ends_no_later_than_with_free_velocities_alone() -> None:
    places = [
        -9.317405336045531e-07, 1.593867908266418e-05, 1.7253050809908993e-05,
        4.167364750641245e-05,
    ]
    limits = Limits(3.902521434186985e-06, 3.890378125677931e-06, 3.2751451405447502e-06)
    durations = []
    for acceleration in (None, "free"):
        inner = [Waypoint(p, "free", acceleration) for p in places[1:-1]]
        points = [Waypoint(places[0]), *inner, Waypoint(places[-1])]
        durations.append(plan(points, limits, smoothness=3).duration)
    assert durations[1] <= durations[0]


def test_a_moving_start_that_can_hardly_be_braked_is_planned() -> None:
    points = [
        Waypoint([-0.6909, 2.5334], [-0.0235, 0.139], [0.0844, -0.482]),
        Waypoint([-0.6953, 2.5072], "free", "free"), Waypoint([-0.6953, 2.4853]),
    ]
    trajectory = plan(points, Limits([0.61, 0.75], [1.6, 0.7], [0.95, 0.84]), smoothness=3)
    assert verify(trajectory).passed


@pytest.mark.long
def test_the_choice_is_the_same_every_time() -> None:
    places = walk(1, 4)
    points = [Waypoint(places[0]), *(Waypoint(p, "free", "free") for p in places[1:-1]),
              Waypoint(places[-1])]
    first, second = (plan(points, Limits(1, 1, 4, 20)) for _ in range(2))
    assert first.duration == second.duration


@pytest.mark.parametrize("overshoot", [0.0, 0.1, 0.25])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_axes_stay_near_their_waypoints(seed: int, overshoot: float) -> None:
    places = np.random.default_rng(seed).uniform(0.0, 3.0, (6, 3))
    points = [Waypoint(places[0]), *(Waypoint(p, "free", "free") for p in places[1:-1]),
              Waypoint(places[-1])]
    trajectory = plan(points, Limits(1.5, 1.5, 4, 20), overshoot=overshoot)
    times = trajectory.waypoint_times
    for i in range(5):
        near = places[max(i - 1, 0):i + 3]
        beyond = overshoot * np.ptp(near, axis=0) + 1e-8
        path = trajectory(np.linspace(times[i], times[i + 1], 400))
        assert (path >= near.min(axis=0) - beyond).all()
        assert (path <= near.max(axis=0) + beyond).all()


@pytest.mark.parametrize(("points", "seed", "place"), [((4, 8), 1, 80), ((3, 7), 21, 31)])
def test_ramps_of_nanoseconds_do_not_matter(
    points: tuple[int, int], seed: int, place: int
) -> None:
    """A clock of seconds does not tell them: these two missions were refused as badly scaled."""
    mission = list(missions(place + 1, points, seed))[place]
    found = plan(mission.waypoints("free", "free"), mission.bounds, overshoot=0.0)
    assert verify(found).passed


@pytest.mark.parametrize(
    ("smoothness", "seed"), [(4, 170), (4, 188), (5, 112), (5, 197), (6, 188), (6, 197)]
)
def test_ramps_of_microseconds_do_not_matter(smoothness: int, seed: int) -> None:
    """States are chosen near a limit; with averaged profiles these were refused, as badly scaled.

    A switching time that rounding tells apart was a jump of the highest derivative.
    """
    points = route(np.random.default_rng(seed))
    found = plan(points, Limits([1.0, 0.8, 0.5], [1.0, 0.8, 0.8], 4.0), smoothness=smoothness)
    assert verify(found).passed


@pytest.mark.long
def test_more_room_is_never_slower_than_the_usual_room() -> None:
    """Without any bound the search alone ended 28 % later."""
    mission = list(missions(75, (4, 8), 1))[74]
    points = mission.waypoints("free", "free")
    usual = plan(points, mission.bounds).duration
    assert plan(points, mission.bounds, overshoot=np.inf).duration <= usual * (1.0 + 1e-9)


def test_overshoot_is_a_share() -> None:
    points = [Waypoint(0.0), Waypoint(1.0, "free"), Waypoint(0.5)]
    for wrong in (-0.1, np.nan, "much"):
        with pytest.raises(InputError, match="overshoot"):
            plan(points, Limits(1, 1, 4, 20), overshoot=wrong)


@pytest.mark.parametrize("off", [1e-16, 1e-14, 1e-12, 3e-10])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_states_that_nearly_are_at_a_limit(off: float, sign: float) -> None:
    """A ramp over the difference would last nanoseconds."""
    limits = Limits(1.0, 1.0, 4.0, 20.0)
    for velocity, acceleration in ((0.2, 1.0 - off), (1.0 - off, off), (off, -1.0 + off)):
        inner = Waypoint(sign * 0.7, sign * velocity, sign * acceleration)
        trajectory = plan([Waypoint(0.0), inner, Waypoint(sign * 2.0)], limits)
        assert verify(trajectory).passed


@pytest.mark.parametrize(
    "smoothness", [2, 3, 4, *(pytest.param(n, marks=pytest.mark.long) for n in (5, 6))]
)
@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
def test_every_smoothness_and_shape_is_faster_than_stopping(smoothness: int, shape: str) -> None:
    limits = Limits(1.0, 1.0, 3.0, *[20.0, 200.0, 2000.0][:smoothness - 2])
    # a search at n = 6 takes ten times as long as at n = 4
    places = walk(3, 5 if smoothness <= 4 else 3)
    inner = places[1:-1]
    ends = Waypoint(places[0]), Waypoint(places[-1])
    durations = [
        plan([ends[0], *(Waypoint(p, state, state) for p in inner), ends[1]], limits,
             smoothness=smoothness, shape=shape).duration
        for state in (None, "free")
    ]
    assert durations[1] < 0.9 * durations[0]


def test_progress_counts_passages() -> None:
    seen: list[tuple[int, int]] = []
    points = [Waypoint(0.0), Waypoint(0.5, "free"), Waypoint(1.0), Waypoint(1.5, "free"),
              Waypoint(2.0)]
    plan(points, Limits(1, 1, 4, 20), progress=lambda done, all_: seen.append((done, all_)))
    assert seen == [(1, 2), (2, 2)]


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


@pytest.mark.parametrize("overshoot", [0.0, 0.25, np.inf])
@pytest.mark.parametrize("wall", [6.0, 6.0 + 1e-7, 6.01, 6.2, 9.0])
@pytest.mark.long
def test_free_states_keep_the_range_of_the_positions(wall: float, overshoot: float) -> None:
    limits = Limits(1.0, 0.4, 0.4, 0.4)
    points = [Waypoint([0, 0]), Waypoint([6, 2], "free", "free"), Waypoint([5, 6])]
    ranges = {"position_max": [wall, 20.0], "position_min": [-0.01, None]}
    found = plan(points, limits, overshoot=overshoot, **ranges)
    assert found.extrema(0)[1][0] <= wall * (1.0 + 1e-12)
    resting = plan([points[0], Waypoint([6, 2]), points[2]], limits, **ranges)
    assert found.duration < resting.duration
    with pytest.raises(InfeasibleError, match=r"position_max is 5.9 m"):
        plan(points, limits, overshoot=overshoot, position_max=[5.9, None])


def test_rest_is_left_where_given_states_lead_to_the_bound() -> None:
    limits = Limits(1.0, 0.5, 1.0, 4.0)
    end = Waypoint([2.0], [0.5])
    resting = plan([Waypoint([0.0]), Waypoint([1.9]), end], limits)
    bound = resting.extrema(0)[1][0] * (1.0 + 1e-9)
    found = plan([Waypoint([0.0]), Waypoint([1.9], "free", "free"), end], limits,
                 position_max=bound, position_min=resting.extrema(0)[0][0] - 1e-9)
    assert found.duration <= resting.duration * (1.0 + 1e-9)


@pytest.mark.parametrize("absent", [[0], [1], [2], [0, 1, 2]])
@pytest.mark.long
def test_limits_that_are_none_do_not_lengthen_a_mission(absent: list[int]) -> None:
    random = np.random.default_rng(3)
    positions = random.normal(size=(6, 2))
    points = [Waypoint(positions[0])]
    points += [Waypoint(p, [None, None], [None, None]) for p in positions[1:-1]]
    points += [Waypoint(positions[-1])]
    near = np.array([2.0, 1.5, 3.0, 10.0])
    near[absent] *= 20.0
    far = near.copy()
    far[absent] *= 1e8
    found, expected = plan(points, Limits(*far)), plan(points, Limits(*near))
    assert found.duration <= 1.005 * expected.duration
    assert verify(found).passed
