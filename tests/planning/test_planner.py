"""Plans over several points and axes: limits, waypoints, smoothness, durations, errors."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, nan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from segfmu import (
    Clearance,
    InfeasibleError,
    InputError,
    Limits,
    Waypoint,
    excursions,
    plan,
    verify,
)
from tests.problems import degenerate_share

LIMITS = Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0])
PAPER = [
    Waypoint([0.0, 0.0]),
    Waypoint([0.07, 0.055], [0.2, 0.17], [0.34, 0.27]),
    Waypoint([1.0, 0.8]),
]


def sampled_peaks(trajectory, derivative: int, samples: int = 20001) -> np.ndarray:
    times = np.linspace(0.0, trajectory.duration, samples)
    return np.abs(trajectory(times, derivative)).max(axis=0)


@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
@pytest.mark.parametrize("synchronize", ["waypoints", "total", "none"])
@pytest.mark.parametrize("smoothness", [4, 5, 6])
def test_paper_mission_keeps_everything(shape: str, synchronize: str, smoothness: int) -> None:
    trajectory = plan(
        PAPER, LIMITS, smoothness=smoothness, shape=shape, synchronize=synchronize
    )
    found = verify(trajectory)
    assert found.passed
    assert found.usage.max() <= 1.0 + 1e-9
    assert found.jumps.max() < 1e-9
    # the same by plain sampling, which shares nothing with the judge
    for order, limit in enumerate(([1.0, 0.4], [1.0, 0.5], [1.0, 0.5], [10.0, 5.0]), 1):
        assert (sampled_peaks(trajectory, order) <= np.array(limit) * (1.0 + 1e-9)).all()
    for j, waypoint in enumerate(PAPER):
        for axis in range(2):
            time = trajectory.axis_waypoint_times[j, axis]
            for order, name in enumerate(("position", "velocity", "acceleration")):
                value = trajectory(time, order)[axis]
                assert value == pytest.approx(getattr(waypoint, name)[axis], abs=1e-9)


def test_errata_e12_snap_may_be_left_out() -> None:
    free = Limits([1.0, 0.4], [1.0, 0.5], [1.0, 0.5])
    for shape in ("plateau", "smoothstep"):
        trajectory = plan(PAPER, free, shape=shape)
        assert verify(trajectory).passed
        assert trajectory.duration < plan(PAPER, LIMITS, shape=shape).duration


def test_errata_e9_one_ramp_alone() -> None:
    for velocity, acceleration in ((0.2, 0.34), (0.17, 0.27)):
        time = 2.0 * velocity / acceleration
        points = [
            Waypoint([0.0]),
            Waypoint([acceleration * time**2 / 7.0], [velocity], [acceleration]),
            Waypoint([1.0]),
        ]
        limits = Limits(1.0, 1.0, 1.875 * acceleration / time)
        trajectory = plan(points, limits, shape="smoothstep")
        assert trajectory.waypoint_times[1] == pytest.approx(time, rel=1e-12)
        starts, _, _ = trajectory.pieces(0)
        assert np.count_nonzero(starts < time * (1.0 - 1e-12)) == 1


def test_axes_meet_where_asked() -> None:
    times = {
        mode: plan(PAPER, LIMITS, synchronize=mode).axis_waypoint_times
        for mode in ("none", "waypoints", "total")
    }
    assert np.ptp(times["waypoints"], axis=1).max() == 0.0
    assert np.ptp(times["total"][-1]) < 1e-12
    assert np.ptp(times["total"][1]) > 0.0
    assert (times["waypoints"][-1] >= times["none"][-1].max()).all()


@pytest.mark.parametrize("synchronize", ["waypoints", "total", "none"])
def test_requested_duration_is_met(synchronize: str) -> None:
    trajectory = plan(PAPER, LIMITS, duration=9.5, synchronize=synchronize)
    assert trajectory.duration == pytest.approx(9.5, rel=1e-12)
    assert verify(trajectory).passed


@pytest.mark.parametrize("synchronize", ["waypoints", "total"])
@pytest.mark.parametrize("dwell", [0.3, 17.1, 5990.975837694747, 71234.56])
def test_a_duration_of_a_plan_is_feasible_beside_long_dwells(
    dwell: float, synchronize: str
) -> None:
    limits = Limits(100.0, 1e4, 1e6)
    points = [
        Waypoint([0.0, 0.0], dwell=dwell), Waypoint([2e-3, 1e-3], dwell=0.7 * dwell),
        Waypoint([3e-3, 7e-3]),
    ]
    shortest = plan(points, limits, smoothness=2).duration
    asked = plan(points, limits, smoothness=2, duration=shortest, synchronize=synchronize)
    assert asked.duration == pytest.approx(shortest, rel=1e-13)
    with pytest.raises(InfeasibleError, match="shorter than the shortest plan"):
        plan(points, limits, smoothness=2, duration=shortest * (1.0 - 1e-9))


@pytest.mark.parametrize("sample_time", [1e-3, 0.01, 0.25])
def test_intervals_are_multiples_of_the_sample_time(sample_time: float) -> None:
    trajectory = plan(PAPER, LIMITS, sample_time=sample_time)
    counts = trajectory.waypoint_times / sample_time
    assert counts == pytest.approx(np.round(counts), abs=1e-6)
    assert verify(trajectory).passed
    # never by more than a sample an interval, but where a gap has to be passed
    assert trajectory.duration >= plan(PAPER, LIMITS).duration - 1e-12


def test_gap_of_the_design_is_jumped() -> None:
    """(0, .5, 0) -> (.3, .5, 0) with limits 1, 1, 2, 10: near 0.6 s, not again before 2.9 s."""
    limits = Limits(1.0, 1.0, 2.0, 10.0)
    points = [Waypoint([0.0], [0.5]), Waypoint([0.3], [0.5])]
    assert plan(points, limits).duration < 0.65
    with pytest.raises(InfeasibleError, match="cannot be prolonged to exactly"):
        plan(points, limits, duration=1.5)
    assert plan(points, limits, duration=4.0).duration == pytest.approx(4.0)
    slow = [Waypoint([0.0, 0.0], [0.5, 0.0]), Waypoint([0.3, 0.6], [0.5, 0.0])]
    both = plan(slow, limits)
    assert 2.8 < both.duration < 3.4
    assert verify(both).passed


def test_dwell_is_kept() -> None:
    points = [Waypoint([0.0], dwell=0.5), Waypoint([1.0], dwell=0.25), Waypoint([0.0], dwell=1.0)]
    limits = Limits(1.0, 1.0, 1.0, 10.0)
    trajectory = plan(points, limits)
    single = plan([Waypoint([0.0]), Waypoint([1.0])], limits).duration
    assert trajectory.duration == pytest.approx(2.0 * single + 1.75)
    assert trajectory.waypoint_times == pytest.approx([0.0, 0.5 + single, 0.75 + 2.0 * single])
    assert trajectory(0.3, 0)[0] == 0.0
    assert trajectory(0.6 + single, 0)[0] == pytest.approx(1.0)
    assert verify(trajectory).passed


@st.composite
def missions(draw: st.DrawFn):
    axes = draw(st.integers(1, 3))
    n = draw(st.integers(2, 6))
    bounds = [[draw(st.floats(0.2, 3.0)) for _ in range(axes)] for _ in range(4)]
    bounds[2] = [20.0 * b for b in bounds[2]]
    limits = Limits(bounds[0], bounds[1], bounds[2], [400.0 * b for b in bounds[3]] if n > 2
                    else None)
    points = []
    for i in range(draw(st.integers(2, 4))):
        rest = draw(st.booleans())
        share = [0.0 if rest else 0.8 * degenerate_share(draw) for _ in range(2 * axes)]
        velocity = [s * b for s, b in zip(share, bounds[0], strict=False)]
        acceleration = [0.5 * s * b for s, b in zip(share[axes:], bounds[1], strict=True)]
        position = [2.0 * degenerate_share(draw) + 1e-3 * i for _ in range(axes)]
        points.append(Waypoint(position, velocity, acceleration))
    return points, limits, n


@settings(max_examples=60, deadline=None)
@given(
    missions(), st.sampled_from(["plateau", "smoothstep"]), st.sampled_from(["waypoints", "total"])
)
def test_random_missions_are_valid_or_refused_by_name(mission, shape: str, mode: str) -> None:
    points, limits, n = mission
    try:
        trajectory = plan(points, limits, smoothness=n, shape=shape, synchronize=mode)
    except InfeasibleError as error:
        assert error.limit == "velocity"
        assert "braking the first" in str(error) or "building up the last" in str(error)
        return
    assert verify(trajectory).passed
    for order in range(1, 3):
        bound = (limits.velocity, limits.acceleration)[order - 1]
        assert (sampled_peaks(trajectory, order, 999) <= bound * (1.0 + 1e-9)).all()


def test_position_bounds_are_checked() -> None:
    points = [Waypoint([0.0], [-0.5]), Waypoint([1.0])]
    limits = Limits(1.0, 1.0, 2.0, 10.0)
    with pytest.raises(InfeasibleError, match=r"^axis x, waypoints 1 -> 2: .*_min") as caught:
        plan(points, limits, position_min=0.0)
    error = caught.value
    assert (error.axis, error.interval) == (0, 1)
    trajectory = plan(points, limits)
    assert trajectory(error.time)[0] == pytest.approx(error.value, abs=1e-12)
    assert trajectory(error.time, 1)[0] == pytest.approx(0.0, abs=1e-9)
    with pytest.raises(InfeasibleError, match=r"^axis y, waypoints 2 -> 3: .*_max") as caught:
        plan(PAPER, LIMITS, position_max=[1.0, 0.7], synchronize="none")
    assert (caught.value.axis, caught.value.interval) == (1, 2)
    assert plan(points, limits, position_min=-0.5, position_max=1.0).duration > 0.0


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"smoothness": 1}, "smoothness"),
        ({"smoothness": 7}, "smoothness"),
        ({"smoothness": "4"}, "smoothness"),
        ({"smoothness": np.array([4, 4])}, "smoothness"),
        ({"smoothness": 4 + 0j}, "smoothness"),
        ({"shape": "round"}, "shape"),
        ({"shape": np.array(["plateau", "smoothstep"])}, "shape"),
        ({"shape": ["plateau"]}, "shape"),
        ({"synchronize": None}, "synchronize"),
        ({"synchronize": np.array(["none", "total"])}, "synchronize"),
        ({"sample_time": -1.0}, "sample_time"),
        ({"sample_time": nan}, "sample_time"),
        ({"duration": 0.0}, "duration"),
        ({"duration": inf}, "duration"),
        ({"axis_names": ["x"]}, "axis_names"),
        ({"axis_names": 3}, "axis_names"),
        ({"axis_names": [1, 2]}, "axis_names"),
        ({"overshoot": "1"}, "overshoot"),
        ({"overshoot": True}, "overshoot"),
        ({"overshoot": nan}, "overshoot"),
        ({"overshoot": 10**400}, "overshoot"),
        ({"progress": 3}, "progress"),
        ({"waypoints": PAPER[:1]}, "at least 2"),
        ({"waypoints": [PAPER[0], 3.0]}, "waypoint 2"),
        ({"waypoints": None}, "waypoints"),
        ({"waypoints": [PAPER[0], Waypoint([1.0])]}, "axes"),
        ({"limits": 3.0}, "limits"),
        ({"limits": Limits([1.0, 1.0, 1.0], 1.0, 1.0)}, "axes"),
        ({"smoothness": 2}, "limits.snap"),
    ],
)
def test_bad_arguments_are_named(change, words: str) -> None:
    arguments = {"waypoints": PAPER, "limits": LIMITS, **change}
    points, limits = arguments.pop("waypoints"), arguments.pop("limits")
    with pytest.raises(InputError, match=words):
        plan(points, limits, **arguments)


@pytest.mark.parametrize("derivative", [-1, 1.5, True, "velocity", None, np.timedelta64(1, "s")])
def test_bad_derivatives_are_named(derivative: object) -> None:
    trajectory = plan(PAPER, LIMITS)
    for call in (lambda: trajectory(0.0, derivative), lambda: trajectory.extrema(derivative)):
        with pytest.raises(InputError, match="derivative must be"):
            call()


@pytest.mark.parametrize("judge", [verify, excursions, Clearance().require])
def test_only_plans_are_judged(judge: Callable) -> None:
    with pytest.raises(InputError, match="trajectory must be a plan, got NoneType"):
        judge(None)


@pytest.mark.parametrize("t", [nan, inf, -inf, None, True, "1", 1j, [], [0.1, 0.2], [[0.1]]])
def test_bad_times_are_named(t: object) -> None:
    trajectory = plan(PAPER, LIMITS)
    for call in (trajectory.state, trajectory.next_event, trajectory.interval):
        with pytest.raises(InputError, match=r"^t must be"):
            call(t)


@pytest.mark.parametrize("t", [True, "1", ["1"], 1j, [1j], [0.1, [0.2]], [inf]])
def test_bad_arrays_of_times_are_named(t: object) -> None:
    with pytest.raises(InputError, match=r"^t must be"):
        plan(PAPER, LIMITS)(t)


@pytest.mark.parametrize("index", [-1, 7, 0.5, None, "x", [0]])
def test_bad_axes_and_orders_are_named(index: object) -> None:
    calls = {
        "axis must be": plan(PAPER, LIMITS).pieces, "order must be": PAPER[0].state,
        "for 7 axes|axes must be": lambda axes: LIMITS.table(axes, 4),
        "smoothness must be": lambda smoothness: LIMITS.table(2, smoothness),
    }
    for words, call in calls.items():
        with pytest.raises(InputError, match=words):
            call(index)


def test_messages_are_one_short_line() -> None:
    with pytest.raises(InputError) as caught:
        Waypoint(np.full((9, 9), "a"))
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 120


@pytest.mark.parametrize("value", [nan, inf, "1", None, [[1.0]], []])
def test_bad_waypoints_are_named(value: object) -> None:
    with pytest.raises(InputError, match="position"):
        Waypoint(value)


@pytest.mark.parametrize("value", [0.0, -1.0, nan, inf, "1", [1.0, 0.0]])
def test_bad_limits_are_named(value: object) -> None:
    with pytest.raises(InputError, match=r"limits\.velocity"):
        Limits(value, 1.0, 1.0)


@pytest.mark.parametrize(
    ("points", "limits", "words", "interval"),
    [
        ([[0.0, 1.2, 0.0], [1.0, 0.0, 0.0]], (1.0, 1.0, 1.0), "exceeds the limit 1 m/s", 1),
        ([[0.0, 0.0, 0.0], [1.0, 0.0, 1.5]], (1.0, 1.0, 1.0), "exceeds the limit 1 m/s2", 1),
        ([[0.0, 0.9, 1.0], [1.0, 0.0, 0.0]], (1.0, 1.0, 1.0), "braking the first", 1),
        ([[0.0, 0.0, 0.0], [1.0, 0.9, -1.0]], (1.0, 1.0, 1.0), "building up the last", 1),
        ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]], (1.0, 1.0), "limits.jerk", None),
    ],
)
def test_infeasible_plans_say_where_and_why(points, limits, words: str, interval) -> None:
    waypoints = [Waypoint([y], [v], [a]) for y, v, a in points]
    with pytest.raises(InfeasibleError, match=words) as caught:
        plan(waypoints, Limits(*limits))
    assert caught.value.axis == 0
    assert caught.value.interval == interval


def test_evaluation_clamps_and_keeps_shapes() -> None:
    trajectory = plan(PAPER, LIMITS)
    assert trajectory([[0.0, 1.0], [2.0, 3.0]], 1).shape == (2, 2, 2)
    assert trajectory(-1.0).tolist() == [0.0, 0.0]
    assert trajectory(99.0) == pytest.approx([1.0, 0.8])
    assert trajectory(99.0, 1).tolist() == [0.0, 0.0]
    assert trajectory(1.0, 20).tolist() == [0.0, 0.0]
    assert [trajectory.interval(t) for t in (-1.0, 0.1, 3.0, 99.0)] == [1, 1, 2, 2]
    for bad in (nan, "a", None):
        with pytest.raises(InputError):
            trajectory(bad)
    with pytest.raises(InputError, match="derivative"):
        trajectory(0.0, -1)


def test_an_axis_that_never_moves_waits_for_the_others() -> None:
    points = [Waypoint([0.0, 1.0]), Waypoint([0.5, 1.0]), Waypoint([1.0, 1.0])]
    for options in ({"synchronize": "total"}, {"synchronize": "none", "duration": 20.0}):
        trajectory = plan(points, Limits(1.0, 1.0, 1.0, 10.0), **options)
        assert np.ptp(trajectory.axis_waypoint_times[-1]) < 1e-9
        assert not np.ptp(trajectory(np.linspace(0.0, 20.0, 50))[:, 1])


@pytest.mark.parametrize("sample_time", [1e-300, 1e-20, 1e9, 1e300])
def test_sample_times_that_doubles_cannot_count_are_refused(sample_time: float) -> None:
    points = [Waypoint(0.0), Waypoint(0.3, 0.1), Waypoint(1.0)]
    with pytest.raises(InputError, match=r"sample_time must be from 1e-9 to 1e6 s"):
        plan(points, Limits(1.0, 1.0, 4.0, 20.0), sample_time=sample_time)
