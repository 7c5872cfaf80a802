"""Plans that begin on other plans: to the same target, to others, to a velocity, to rest."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from benchmarks.replanning import over_optimum, random_plan
from benchmarks.stopping import shortest_stop

from segfmu import (
    InfeasibleError,
    InputError,
    Limits,
    Trajectory,
    Waypoint,
    plan,
    reach_velocity,
    replan,
    stop,
    verify,
)
from segfmu.planning.waypoint import waypoint_of
from tests.campaign import campaign, soaked
from tests.property import soak_replan

TARGET = Waypoint([1.0, 0.5, 0.2])
BOUNDS = (1.0, 1.0, 4.0, 20.0)
LIMITS_BY_HAND = ([1.0, 3.94], [7.96, 0.613], [0.2695, 1.885], [14.41, 0.1247])
TIMES = (0.0, 0.05, 0.37, 0.9, 1.5, 2.2, 2.4)


def first_plan(n: int) -> Trajectory:
    limits = Limits(*BOUNDS[: min(max(n, 3), 4)])
    return plan([Waypoint([0.0, 0.0, 0.0]), TARGET], limits, smoothness=n)


def assert_continues(old: Trajectory, t: float, new: Trajectory) -> None:
    """The new plan begins in the state of the old one, and is sound."""
    assert verify(new).passed
    for derivative in range(old.smoothness + 1):
        low, high = old.extrema(derivative)
        scale = np.maximum(high - low, 1e-3)
        there = (new(0.0, derivative) - old(t, derivative)) / scale
        assert np.abs(there).max() < 1e-9


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("t", TIMES)
def test_a_plan_to_the_same_target_ends_when_the_first_one_would_have(n: int, t: float) -> None:
    old = first_plan(n)
    t = min(t, old.duration)
    new = replan(old, t, TARGET)
    assert_continues(old, t, new)
    assert t + new.duration <= old.duration * (1.0 + 1e-9)


@pytest.mark.parametrize("n", [2, 3, 4, pytest.param(5, marks=pytest.mark.long), *soaked(6)])
def test_replanned_in_cycles_it_arrives_in_time(n: int) -> None:
    first = trajectory = first_plan(n)
    passed = 0.0
    while trajectory.duration > 0.01:
        trajectory = replan(trajectory, 0.01, TARGET)
        passed += 0.01
    assert passed + trajectory.duration <= first.duration * (1.0 + 1e-9)
    assert verify(trajectory).passed
    np.testing.assert_allclose(trajectory(trajectory.duration), TARGET.position, atol=1e-12)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("share", [1e-3, 1e-5, 1e-7, 1e-9])
def test_shortly_before_its_end_a_plan_is_kept(n: int, share: float) -> None:
    # what is left moves by less than the rounding error of the position
    old = first_plan(n)
    rest = old.duration * share
    for new in (replan(old, old.duration - rest, TARGET), stop(old, old.duration - rest)):
        assert verify(new).passed
        assert new.duration <= rest + 1e-14 * old.duration


@pytest.mark.parametrize("velocity", np.linspace(0.5, 13.0, 26))
def test_a_change_of_velocity_may_have_many_pieces(velocity: float) -> None:
    bounds = Limits(13.4, 1.505, 0.908, 0.9916, 15.68, 14.0)
    found = reach_velocity(Waypoint(0.0), velocity, 0.0, bounds, smoothness=6)
    assert verify(found).passed


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("share", [5e-324, 1e-300, 1e-30, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8])
def test_shortly_after_its_start_a_plan_is_left(n: int, share: float) -> None:
    # all that moves is some derivatives of high order, or what rounding leaves of them
    table = LIMITS_BY_HAND if n > 4 else LIMITS_BY_HAND[:3]
    old = plan([Waypoint([0.01377, -0.01119]), Waypoint([0.2, 3.0])], Limits(*table), smoothness=n)
    t = share * old.duration
    stopped = stop(old, t)
    assert verify(stopped).passed
    for derivative in range(1, min(n, 3) + 1):
        there = np.abs(stopped(0.0, derivative) - old(t, derivative))
        assert (there <= 1e-9 * np.array(table[derivative - 1])).all()
    assert stopped.duration <= max(10.0 * t, 1e-13)
    for target in (Waypoint([-1.0, 0.4]), old.waypoints[-1]):
        assert verify(replan(old, t, target)).passed
    assert verify(reach_velocity(old, [0.5, -1.0], t)).passed


@campaign(400, 1500, "cycles")
@pytest.mark.long
def test_in_many_cycles_rounding_errors_do_not_delay_it(cycles: int) -> None:
    bounds = Limits(
        [0.52, 4.96, 19.5], [22.0, 1.0, 0.0967], [0.045, 0.0772, 1.0], [1.18, 22.7, 0.433]
    )
    start, end = [1.04435, -1.95586, 0.154021], Waypoint([-0.068994, -0.0394966, -0.0296224])
    first = trajectory = plan([Waypoint(start), end], bounds, synchronize="total")
    cycle = first.duration / cycles
    passed = 0.0
    while trajectory.duration > 1.5 * cycle:
        trajectory = replan(trajectory, cycle, end)
        passed += cycle
        assert passed + trajectory.duration <= first.duration * (1.0 + 1e-9)
    assert verify(trajectory).passed


@pytest.mark.parametrize("n", [5, 6])
@pytest.mark.parametrize("before", [1.0, 0.5, 0.2, 1e-2, 1e-3, 1e-5])
def test_pieces_of_microseconds_are_kept(n: int, before: float) -> None:
    # limits up to the jerk alone: the rises are short, and those within them shorter
    bounds = Limits([15.0, 2.0, 0.153457], [0.342797, 31.0, 0.03284], [3.0, 0.145234, 14.323235])
    start = Waypoint([0.01706554, 0.03508461, 0.02524318])
    end = Waypoint([0.33725822, -0.15419547, 0.15452832])
    old = plan([start, end], bounds, smoothness=n)
    new = replan(old, old.duration - before, end)
    assert new.duration <= before * (1.0 + 1e-9)
    assert verify(new).passed


def test_behind_the_old_plan_axes_are_at_rest_up_to_the_last_bit() -> None:
    bounds = Limits(
        [1.0, 4.5908], [0.109267, 2.458026], [1.0, 12.0], [1.0, 0.208324], [23.558, 3.0165], 4.0
    )
    points = [
        Waypoint([0.040771628, 0.036045936]),
        Waypoint([2.91544228, -39.2341443], [0.54501965, -0.22180077], [0.0159088, -1.05997271]),
        Waypoint([-0.000666008088, -0.0064477631]),
    ]
    old = plan(points, bounds, smoothness=6, synchronize="total")
    # moving between the states, axes cannot be prolonged to any duration; at rest they can
    for target in ([0.28164337, 0.34703286], [-0.3, 0.2], [0.01, -2.0]):
        new = replan(old, 0.00845083, Waypoint(target))
        assert verify(new).passed


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("t", TIMES)
def test_a_new_target_is_reached_from_any_time(n: int, t: float) -> None:
    old = first_plan(n)
    target = Waypoint([-0.3, 0.8, 0.2], [0.2, 0.0, -0.1])
    new = replan(old, t, [Waypoint([0.5, 0.4, 0.3]), target])
    assert_continues(old, t, new)
    np.testing.assert_allclose(new(new.duration, 1), target.velocity, atol=1e-9)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("t", TIMES)
def test_a_stop_from_any_time_ends_before_the_plan(n: int, t: float) -> None:
    old = first_plan(n)
    t = min(t, old.duration)
    new = stop(old, t)
    assert_continues(old, t, new)
    assert new.duration <= (old.duration - t) * (1.0 + 1e-9)
    for derivative in range(1, n + 1):
        assert np.abs(new(new.duration, derivative)).max() < 1e-9


def test_stops_are_near_the_optimum() -> None:
    random = np.random.default_rng(3)
    ratios = []
    for _ in range(12):
        old = random_plan(random, 4)
        ratio = over_optimum(old, random.uniform(0.0, old.duration))
        if ratio is not None:
            ratios.append(ratio)
    assert len(ratios) > 6
    # the programme is solved to 1e-3
    assert min(ratios) > 0.998
    assert np.median(ratios) < 1.02


@pytest.mark.parametrize(
    ("bounds", "state"),
    [
        ((0.38888, 0.474745, 1.305593, 2.703219), (0.0015523, 0.0306868, 0.4063397, 2.703219)),
        ((1.687, 1.281, 1.045, 1.509), (-0.01029, -0.08916, -0.51853, -1.509)),
        ((1.392, 0.432, 1.485, 0.631), (0.0058464, 0.0454896, 0.2395305, 0.631)),
    ],
)
def test_a_stop_before_a_gap_of_durations(
    bounds: tuple[float, ...], state: tuple[float, ...]
) -> None:
    # it lasts up to 1.33 times as long behind the gap, to which a slow settling of the snap leads
    found = stop(Waypoint(0.0, *state), limits=Limits(*bounds), smoothness=4).duration
    optimum = shortest_stop(np.array(state[:3]), np.array(bounds), 1.02 * found)
    assert optimum is not None
    assert found < 1.05 * optimum


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_a_velocity_is_reached_and_kept(n: int) -> None:
    old = first_plan(n)
    wanted = [0.4, -0.3, 0.0]
    new = reach_velocity(old, wanted, 0.4)
    assert_continues(old, 0.4, new)
    np.testing.assert_allclose(new(new.duration, 1), wanted, atol=1e-9)
    np.testing.assert_allclose(new(new.duration, 2), 0.0, atol=1e-9)
    ends = [new.pieces(axis)[0][-1] for axis in range(3)]
    assert min(ends) < max(ends)


def test_a_state_needs_no_trajectory() -> None:
    old = first_plan(4)
    state = old.state(0.4)
    assert np.abs(state.snap).max() > 0.0
    resting = stop(state, limits=old.limits)
    assert verify(resting).passed
    # without the old plan to follow it may take longer, not less
    assert resting.duration >= stop(old, 0.4).duration * (1.0 - 1e-9)
    beyond = plan([state, TARGET], old.limits)
    assert_continues(old, 0.4, beyond)
    assert beyond.duration < 1.05 * (old.duration - 0.4)


def test_after_its_end_a_plan_stays() -> None:
    old = first_plan(4)
    assert replan(old, old.duration + 1.0, TARGET).duration == 0.0
    assert stop(old, old.duration + 1.0).duration == 0.0
    back = replan(old, old.duration + 1.0, Waypoint([0.0, 0.0, 0.0]))
    assert back.duration == pytest.approx(old.duration, rel=1e-9)


def test_a_target_where_the_plan_is_already_is_reached_at_once() -> None:
    old = first_plan(4)
    for t in (old.duration, old.duration + 1.0):
        new = replan(old, t, Waypoint(TARGET.position, dwell=2.0))
        assert new.duration == pytest.approx(2.0, abs=1e-3)
        assert_continues(old, t, new)
    # one axis has arrived, the other one up to rounding: they do not meet as they are
    bounds = Limits([1.0, 19.286743215453136], [2.06, 0.699], [27.58, 0.07197])
    start, end = Waypoint([0.0, 0.0]), Waypoint([0.00275811, 0.00946269])
    apart = plan([start, end], bounds, smoothness=2, synchronize="none")
    for before in (1e-9, 1e-10, 1e-11, 1e-12):
        new = replan(apart, apart.duration * (1.0 - before), end, synchronize="total")
        assert verify(new).passed
        assert new.duration < 1e-3


def test_what_is_left_keeps_its_dwell() -> None:
    end = Waypoint([1.0], dwell=2.0)
    old = plan([Waypoint([0.0]), Waypoint([0.4], [0.3]), end], Limits(1.0, 1.0, 4.0, 20.0))
    new = replan(old, 0.5, end)
    assert new.duration <= old.duration - 0.5 + 1e-9
    assert new.waypoints[-1].dwell == 2.0
    np.testing.assert_allclose(new(np.linspace(new.duration - 2.0, new.duration, 9)), 1.0)
    assert verify(new).passed
    # to another target with a dwell, and in the middle of the dwell
    assert replan(old, 0.5, Waypoint([1.2], dwell=3.0)).waypoints[-1].dwell == 3.0
    assert replan(old, old.duration - 0.7, end).waypoints[-1].dwell == pytest.approx(0.7)


def test_replanned_in_cycles_a_dwell_ends_in_time() -> None:
    end = Waypoint([1.0, 0.3], dwell=0.5)
    for mode in MODES:
        first = plan([Waypoint([0.0, 0.0]), end], Limits(*BOUNDS), synchronize=mode)
        trajectory, passed = first, 0.0
        while trajectory.duration > 0.05:
            trajectory = replan(trajectory, 0.05, trajectory.waypoints[-1])
            passed += 0.05
            assert verify(trajectory).passed
        assert passed + trajectory.duration == pytest.approx(first.duration, rel=1e-9)


MODES = ("waypoints", "total", "none")


@pytest.mark.parametrize("asked", MODES)
@pytest.mark.parametrize("before", MODES)
@pytest.mark.parametrize("dwell", [0.0, 2.0])
def test_the_rest_is_kept_only_if_axes_meet_as_asked(
    dwell: float, before: str, asked: str
) -> None:
    points = [
        Waypoint([0.0, 0.0]), Waypoint([1.0, 0.1]), Waypoint([1.5, 0.3], dwell=dwell)
    ]
    old = plan(points, Limits(*BOUNDS), synchronize=before)
    arrivals = old.axis_waypoint_times
    # moving, one axis at its end, and both
    for t in (0.5, arrivals[1].mean(), arrivals[2].mean(), arrivals[2].max() + 0.4 * dwell):
        targets = [points[j] for j in (1, 2) if t < arrivals[j].min()] or [points[2]]
        new = replan(old, t, targets, synchronize=asked)
        assert_continues(old, t, new)
        if asked in (before, "none") or (before, asked) == ("waypoints", "total"):
            assert new.duration <= (old.duration - t) * (1.0 + 1e-9)
        if asked != "none":
            assert np.ptp(new.axis_durations) <= 1e-12 * new.duration
        if asked == "waypoints":
            assert np.ptp(new.axis_waypoint_times, axis=1).max() <= 1e-12 * new.duration


def test_tighter_limits_hold_where_the_state_keeps_them() -> None:
    old = first_plan(4)
    tight = Limits(0.8, 0.9, 3.0, 20.0)
    new = replan(old, 0.0, TARGET, tight)
    assert verify(new).passed
    assert new.duration > old.duration
    # the state breaks these
    slow = replan(old, 0.9, TARGET, Limits(0.1, 0.9, 3.0, 20.0))
    assert verify(slow).passed
    assert slow.outside.max() > 0.0


def test_what_cannot_be_is_refused() -> None:
    old = first_plan(4)
    with pytest.raises(InputError, match="time must be"):
        replan(old, -1.0, TARGET)
    with pytest.raises(InputError, match="with limits"):
        replan(TARGET, 0.0, TARGET)
    with pytest.raises(InputError, match="with limits"):
        stop(TARGET)
    with pytest.raises(InputError, match="targets must have at least one"):
        replan(old, 0.1, [])
    with pytest.raises(InputError, match="velocity has 2 values for 3 axes"):
        reach_velocity(old, [1.0, 2.0], 0.1)
    with pytest.raises(InfeasibleError, match=r"axis y: velocity 2 m/s exceeds the limit 1 m/s"):
        reach_velocity(old, [0.0, 2.0, 0.0], 0.1)
    with pytest.raises(InfeasibleError, match="axis x, waypoint 1: no motion"):
        plan([Waypoint(0.0, 0.999, 0.9, 3.0), Waypoint(5.0)], old.limits)
    with pytest.raises(InputError, match="free velocity"):
        stop(Waypoint(0.0, "free"), limits=old.limits)
    with pytest.raises(InputError, match=r"time is 3\.0, but a state has no times"):
        stop(Waypoint(0.0, 0.5), 3.0, old.limits)
    with pytest.raises(InputError, match="dwell of 2 s"):
        stop(Waypoint(0.0, dwell=2.0), limits=old.limits)
    with pytest.raises(InputError, match="waypoint 2: jerk"):
        plan([Waypoint(0.0), Waypoint(1.0, jerk=1.0)], old.limits)
    with pytest.raises(InputError, match="raise smoothness to 5"):
        plan([Waypoint(0.0, crackle=1.0), Waypoint(1.0)], old.limits)
    with pytest.raises(InputError, match="dwell"):
        plan([Waypoint(0.0, jerk=1.0, dwell=1.0), Waypoint(1.0)], old.limits)


@pytest.mark.parametrize("time", [None, True, "1", np.nan, np.inf, -1.0, [], [1.0, 2.0], 1j])
def test_bad_times_are_named(time: object) -> None:
    old = first_plan(4)
    calls = (
        lambda: replan(old, time, TARGET), lambda: stop(old, time),
        lambda: reach_velocity(old, 0.1, time), lambda: stop(old.state(0.4), time, old.limits),
    )
    for call in calls:
        with pytest.raises(InputError, match=r"^time"):
            call()


def test_a_list_of_one_time_is_a_time() -> None:
    old = first_plan(4)
    assert replan(old, [1.0], TARGET).duration == replan(old, 1.0, TARGET).duration


@pytest.mark.parametrize("targets", [5, None, 1.0, [], [3.0], "end", [TARGET, None]])
def test_bad_targets_are_named(targets: object) -> None:
    with pytest.raises(InputError, match=r"targets must|waypoint \d must be"):
        replan(first_plan(4), 1.0, targets)


@pytest.mark.parametrize("mode", ["", "all", 1, ["none"], np.array(["none", "total"])])
def test_bad_modes_are_named(mode: object) -> None:
    with pytest.raises(InputError, match="synchronize must be one of"):
        replan(first_plan(4), 1.0, TARGET, synchronize=mode)


@pytest.mark.parametrize(
    "smoothness", [None, "a", -1, 1, 7, 4.5, np.nan, [4], np.array([4, 4])]
)
def test_bad_smoothness_of_a_stop_is_named(smoothness: object) -> None:
    state, limits = Waypoint(0.0, 0.5), Limits(*BOUNDS)
    with pytest.raises(InputError, match="smoothness must be an integer from 2 to 6"):
        stop(state, limits=limits, smoothness=smoothness)
    assert stop(state, limits=limits, smoothness=4.0).smoothness == 4


@pytest.mark.parametrize("velocity", [None, "fast", True, np.nan, [], [[0.1]], [0.1, None]])
def test_bad_velocities_are_named(velocity: object) -> None:
    old = first_plan(4)
    for start in (old, old.state(0.4)):
        with pytest.raises(InputError, match="velocity"):
            reach_velocity(start, velocity, 0.0, old.limits)


def test_at_its_end_a_plan_that_ends_moving_moves() -> None:
    limits = Limits(1.0, 1.0, 4.0, 20.0)
    ahead = Waypoint(3.0)
    for old in (
        reach_velocity(Waypoint(0.0), [0.5], limits=limits),
        plan([Waypoint(0.0), Waypoint(2.0, 0.5, 0.1)], limits),
    ):
        end = old.duration
        new = replan(old, end, ahead)
        assert new.waypoints[0].velocity == pytest.approx(old.waypoints[-1].velocity, rel=1e-12)
        assert new.duration == pytest.approx(
            replan(old, np.nextafter(end, 0.0), ahead).duration, rel=1e-3
        )
        assert stop(old, end).duration > 0.9
        # behind its end it stays
        assert replan(old, end + 1e-3, ahead).waypoints[0].velocity[0] == 0.0


@pytest.mark.parametrize(
    ("number", "t", "synchronize"),
    [
        (1445, 8.967190861307802, "total"), (247, 74.07870375450193, "total"),
        (6267, 25.273635295188996, "waypoints"),
    ],
)
def test_rounding_of_a_long_motion_before_its_last_nanometres(
    number: int, t: float, synchronize: str
) -> None:
    """One axis has 4e-9 m left; the axes did not have to meet before."""
    random, more = (np.random.default_rng([2026, 4, number, *k]) for k in ((), (1,)))
    old = soak_replan.random_plan(random, more, 4, int(random.integers(1, 4)))
    new = replan(old, t, old.waypoints[-1], synchronize=synchronize)
    assert verify(new).passed


@pytest.mark.parametrize(("time", "limits", "limit"), [
    (0.05, Limits(1.0, 0.8, 4.0, 10.0), "snap"), (0.15, Limits(1.0, 1.0, 1.0, 20.0), "jerk"),
    (0.6, Limits(1.0, 0.8, 4.0, 20.0), "acceleration"),
    (0.6, Limits(0.2, 1.0, 4.0, 20.0), "velocity"),
])
def test_a_refused_first_waypoint_names_the_limit_that_it_breaks(
    time: float, limits: Limits, limit: str
) -> None:
    old = plan([Waypoint(0.0), Waypoint(1.0)], Limits(1.0, 1.0, 4.0, 20.0))
    with pytest.raises(InfeasibleError, match=rf"axis x, waypoint 1: {limit} .* exceeds the limit"):
        plan([old.state(time), Waypoint(2.0)], limits)
    # replanned, it is brought inside
    found = replan(old, time, Waypoint(2.0), limits)
    assert verify(found).passed
    assert found.outside[0] > 0.0


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("synchronize", ["waypoints", "total", "none"])
@campaign(2, 20)
def test_at_the_very_end_of_a_plan_that_ends_moving_nothing_is_left(
    n: int, synchronize: str, count: int
) -> None:
    """Its state there differs from the target by rounding; axes went round a loop."""
    rng = np.random.default_rng(n)
    limits = Limits(*(1.0, 1.0, 4.0, 20.0, 200.0, 2000.0)[: max(n, 3)])
    for _ in range(count):
        target = Waypoint(rng.uniform(-1.0, 1.0, 3), rng.uniform(-0.5, 0.5, 3))
        points = [Waypoint([0.0] * 3), target]
        try:
            old = plan(points, limits, smoothness=n, synchronize=synchronize)
        except InfeasibleError:
            continue
        for before in (0.0, np.spacing(old.duration), 1e-12, 1e-9):
            found = replan(old, old.duration - before, target)
            assert found.duration <= before + 1e-14 * old.duration
            assert verify(found).passed


def test_threads_replan_side_by_side() -> None:
    old = first_plan(4)
    times = np.linspace(0.0, old.duration, 24)

    def durations(run: Callable[..., Iterable[Trajectory]]) -> list[float]:
        found = run(lambda t: replan(old, t, Waypoint([0.4, 1.0, -0.3])), times)
        return [new.duration for new in found]

    alone = durations(map)
    with ThreadPoolExecutor(8) as threads:
        assert durations(threads.map) == alone


@pytest.mark.parametrize("n", [2, 4, 6])
@pytest.mark.parametrize("axes", [1, 3])
def test_a_state_is_the_waypoint_of_its_derivatives(n: int, axes: int) -> None:
    for states in (np.random.default_rng(n).normal(size=(axes, n + 1)), np.zeros((axes, n + 1))):
        found, given = waypoint_of(states), Waypoint(*states.T)
        assert found == given and repr(found) == repr(given)
        assert np.array_equal(found.planned, given.planned)
        assert (found.axes, found.free, found.settled) == (axes, given.free, given.settled)
        with pytest.raises(ValueError, match="read-only"):
            found.jerk[0] = 1.0
