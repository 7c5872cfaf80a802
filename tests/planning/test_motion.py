"""The work space of whole plans: never too small, and of one plan at a time."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan
from segfmu.planning import motion

LIMITS = Limits([1.0, 0.4, 0.5], [1.0, 0.5, 0.8], [1.0, 0.5, 4.0], [10.0, 5.0, 30.0])


def mission(distance: float, smoothness: int = 4) -> Trajectory:
    points = [
        Waypoint([0.0, 0.0, -1.0]), Waypoint([distance, 0.055, -0.9], [0.2, 0.1, 0.0]),
        Waypoint([1.0, 0.8, -0.5], dwell=0.3),
    ]
    return plan(points, LIMITS, smoothness=smoothness)


def same(one: Trajectory, other: Trajectory) -> bool:
    arrays = ("timing", "coefficients", "offsets", "axis_waypoint_times", "axis_durations")
    return all(np.array_equal(getattr(one, a), getattr(other, a)) for a in arrays)


@pytest.mark.parametrize("smoothness", [3, 4, 6])
def test_more_pieces_than_rows(monkeypatch: pytest.MonkeyPatch, smoothness: int) -> None:
    usual = mission(0.1, smoothness)
    monkeypatch.setattr(motion, "USUAL_RAMPS", 0)
    monkeypatch.setattr(motion, "_spaces", {})
    assert same(mission(0.1, smoothness), usual)
    assert same(mission(0.1, smoothness), usual)


def test_plans_keep_their_arrays() -> None:
    first = mission(0.1)
    kept = [first.timing.copy(), first.coefficients.copy()]
    second = mission(0.3)
    assert not same(first, second)
    assert np.array_equal(first.timing, kept[0])
    assert np.array_equal(first.coefficients, kept[1])
    # no larger than its pieces
    assert first.coefficients.base is None


def test_threads_plan_side_by_side() -> None:
    distances = np.linspace(0.05, 0.5, 40)
    alone = [mission(d) for d in distances]
    with ThreadPoolExecutor(8) as threads:
        together = list(threads.map(mission, distances))
    assert all(same(a, b) for a, b in zip(alone, together, strict=True))


def test_spaces_of_many_sizes_are_not_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(motion, "_spaces", {})
    for count in range(2, 40):
        plan([Waypoint([0.1 * i] * 3) for i in range(count)], LIMITS)
    assert len(motion._spaces) == motion.KEPT
    assert all(points * axes <= motion.LARGEST for points, axes, _ in motion._spaces)


def test_a_refusal_leaves_the_space_in_order() -> None:
    usual = mission(0.1)
    with pytest.raises(InfeasibleError, match="exceeds the limit"):
        plan([Waypoint([0.0] * 3), Waypoint([0.5] * 3, [9.0] * 3), Waypoint([1.0] * 3)], LIMITS)
    assert same(mission(0.1), usual)
