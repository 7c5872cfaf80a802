"""Events of plans against the bounds of all their pieces."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from segfmu import Limits, Trajectory, Waypoint, plan
from segfmu.kernels.trajectory.breaks import next_plan_event, right_of_break, same_break

LIMITS = Limits([1.0, 0.4, 0.3], [1.0, 0.5, 0.5], [1.0, 0.5, 0.5], [10.0, 5.0, 5.0])


def trajectory(smoothness: int, shape: str) -> Trajectory:
    points = [
        Waypoint([0.0, 0.0, -0.5], dwell=0.3),
        Waypoint([0.3, 0.2, -0.4], velocity=[0.2, 0.1, 0.0]),
        Waypoint([0.6, 0.2, -0.4], dwell=0.2),
        Waypoint([0.7, 0.2, -0.6], dwell=0.1),
    ]
    limits = LIMITS if smoothness > 2 else Limits(LIMITS.velocity, LIMITS.acceleration, LIMITS.jerk)
    return plan(points, limits, smoothness=smoothness, shape=shape)


def bounds(found: Trajectory) -> np.ndarray:
    axes = [np.append(found.pieces(a)[0], found.axis_durations[a]) for a in range(found.axes)]
    return np.unique(np.concatenate(axes))


@pytest.mark.parametrize("smoothness", [2, 4, 6])
@pytest.mark.parametrize("shape", ["plateau", "smoothstep"])
def test_events_are_all_bounds_of_pieces(smoothness: int, shape: str) -> None:
    found = trajectory(smoothness, shape)
    events, times = found.events, bounds(found)
    assert (np.diff(events) > same_break(events[-1])).all()
    for time in times:
        assert np.abs(events - time).min() <= 2.0 * same_break(time)
    for event in events:
        assert np.abs(times - event).min() == 0.0
    # arrivals are events to the last bit
    assert set(found.waypoint_times[1:]) | {found.duration} <= set(events)


def test_between_events_all_derivatives_are_continuous() -> None:
    found = trajectory(4, "plateau")
    at = np.concatenate([
        np.linspace(a, b, 7)[1:-1]
        for a, b in itertools.pairwise(found.events)
    ])
    for order in range(5, 8):
        near = [found(at + side * 1e-9, order) for side in (-1.0, 1.0)]
        size = 2e-9 * np.abs(found(at, order + 1)).max() + 1e-6 * np.abs(near[0]).max()
        assert np.abs(near[1] - near[0]).max() <= size


def test_next_event() -> None:
    found = trajectory(4, "smoothstep")
    events = found.events
    assert found.next_event(-1.0) == events[0] == 0.0
    for before, after in itertools.pairwise(events):
        assert found.next_event(before) == found.next_event(0.5 * (before + after)) == after
        assert found.next_event(np.nextafter(before, -1.0)) == after
    assert found.next_event(found.duration) == np.inf


@pytest.mark.parametrize("start", [0.0, 0.37, 1e4])
def test_right_of_a_break_every_axis_is_on_its_next_piece(start: float) -> None:
    found = trajectory(4, "plateau")
    arrays = found.timing, found.offsets, found.axis_durations
    for event in found.events:
        for time in (event, np.nextafter(event, -1.0), np.nextafter(event, 9.0)):
            local = right_of_break(start + time, start, *arrays)
            assert 0.0 < local - event < 3.0 * same_break(start + time)
            ahead = found(event + 1e-5, 5)
            assert found(local, 5) == pytest.approx(ahead, rel=0.1, abs=0.1)
    assert right_of_break(start + 0.123, start, *arrays) == start + 0.123 - start


@pytest.mark.parametrize("start", [0.0, 5.0, -5.0, 1e17, -1e17, 1e300, -1e300])
def test_events_come_after_the_present_wherever_the_plan_begins(start: float) -> None:
    found = trajectory(4, "plateau")
    for time in (0.0, 1.0, 1e3, start):
        event = next_plan_event(
            time, start, found.timing, found.offsets, found.axis_durations,
            found.axis_waypoint_times,
        )
        assert event > time or event == 1e300
