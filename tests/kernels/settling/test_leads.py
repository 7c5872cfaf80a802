"""Leads of several axes: which of them hurry, which follow a plan, and what is written."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from segfmu import Limits, Waypoint, plan
from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import DelayedState
from segfmu.kernels.settling.records import LeadEnd, LeadRows, LeadStage, LeadTask, LeadWork

LIMITS = np.array([1.0, 1.0, 4.0, 20.0, 0.0])
NONE = np.zeros((1, 2)), np.zeros((1, 8)), np.zeros(4, dtype=np.int64)
# each axis gains by a lead over a level; the first one takes the longest time
NOW = np.array([
    [0.0, -0.76, -0.02, -2.01, -11.02], [0.0, 0.58, 0.57, 2.62, -10.94],
    [0.0, 0.3, 0.29, 0.82, -9.51],
])
TARGETS = np.array([[place, 0.0, 0.0, 0.0, 0.0] for place in (0.02, 0.82, 0.16)])


class Found(NamedTuple):
    failed: int
    ends: FloatArray
    timing: FloatArray
    coefficients: FloatArray
    offsets: np.ndarray


def leads(
    order: int, meeting: float, now: FloatArray = NOW, targets: FloatArray = TARGETS,
    follow: tuple[FloatArray, FloatArray, np.ndarray] = NONE, brakes: float = 1.0,
) -> Found:
    work = np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))
    work[LeadWork.TASK, : LeadTask.BRAKES + 1] = order, meeting, 1.0, brakes
    axes = len(now)
    rows = len(follow[0]) + axes * LeadRows.PIECES + LeadRows.ALL
    found = np.full((rows, 2), np.nan), np.full((rows, 8), np.nan), np.zeros(axes + 1, np.int64)
    ends = np.zeros((axes, LeadEnd.SIZE))
    failed = backend.find_leads(
        np.stack([now, targets]), np.tile(LIMITS, (axes, 1)), np.zeros((axes, 2)), follow[2],
        follow[0], follow[1], ends, work, *found,
    )
    return Found(failed, ends, *found)


def value(piece: FloatArray, time: float, order: int) -> float:
    return float(np.polynomial.Polynomial(piece).deriv(order)(time)) if order else float(
        np.polynomial.Polynomial(piece)(time)
    )


@pytest.mark.parametrize("order", [LeadStage.VELOCITY, LeadStage.ACCELERATION])
def test_each_lead_goes_from_its_state_to_its_end(order: int) -> None:
    found = leads(order, -1.0)
    assert found.failed == -1
    for axis in range(3):
        first, last = found.offsets[axis], found.offsets[axis + 1]
        assert last > first
        for d in range(5):
            assert value(found.coefficients[first], 0.0, d) == pytest.approx(
                NOW[axis, d], rel=1e-9, abs=1e-9
            )
        start, length = found.timing[last - 1]
        assert start + length == pytest.approx(found.ends[axis, LeadEnd.DELAY])
        for d in range(3):
            assert value(found.coefficients[last - 1], length, d) == pytest.approx(
                found.ends[axis, d], abs=1e-9
            )
        assert found.ends[axis, LeadEnd.FOLLOWS] == 0.0


def test_only_the_axis_that_is_late_hurries() -> None:
    patient, hasty, meeting = (
        leads(LeadStage.ACCELERATION, time).ends for time in (1e3, -1.0, 0.0)
    )
    times = patient[:, LeadEnd.TIME]
    assert (hasty[:, LeadEnd.TIME] < times * (1.0 - 1e-4)).all()
    late = np.arange(3) == times.argmax()
    assert ((meeting[:, LeadEnd.HASTY] == 1.0) == late).all()
    assert (meeting[:, LeadEnd.TIME] == np.where(late, hasty[:, LeadEnd.TIME], times)).all()


def test_an_axis_follows_the_plan_that_ends_sooner() -> None:
    limits = Limits(1.0, 1.0, 4.0, 20.0)
    old = plan([Waypoint([0.0, 0.0, 0.0]), Waypoint([0.5, 0.8, 0.2])], limits)
    # to brake from so fast takes longer than what is left of the plan
    now = np.zeros((3, 5))
    now[:, 1] = 0.9
    found = leads(
        LeadStage.VELOCITY, -1.0, now, np.zeros((3, 5)),
        (old.timing - [0.9 * old.duration, 0.0], old.coefficients, old.offsets),
    )
    assert found.failed == -1
    follows = found.ends[:, LeadEnd.FOLLOWS] == 1.0
    assert follows.any()
    for axis in np.flatnonzero(follows):
        first, last = found.offsets[axis], found.offsets[axis + 1]
        kept = slice(old.offsets[axis], old.offsets[axis + 1])
        np.testing.assert_array_equal(found.coefficients[first:last], old.coefficients[kept])


def test_an_axis_without_a_lead_is_told() -> None:
    now = NOW.copy()
    now[1, 1:3] = 1.5, 1.0
    assert leads(LeadStage.VELOCITY, -1.0, now, brakes=0.0).failed == 1
    assert leads(LeadStage.VELOCITY, -1.0, now).failed == -1


def test_ends_are_those_of_the_last_polynomials() -> None:
    old = plan(
        [Waypoint([0.0, 0.0]), Waypoint([0.5, 0.8], [0.2, -0.1], [0.0, 0.1])],
        Limits(1.0, 1.0, 4.0, 20.0),
    )
    ends = np.zeros((2, DelayedState.SIZE))
    backend.plan_ends(old.timing, old.coefficients, old.offsets, ends)
    expected = [[0.5, 0.2, 0.0, old.duration], [0.8, -0.1, 0.1, old.duration]]
    np.testing.assert_allclose(ends, expected, atol=1e-12)
    bounds = np.ones((2, 2))
    target = np.array([[0.0, 0.2], [0.0, -0.1]])
    # the second axis accelerates at its end
    assert not backend.are_at_velocities(target, bounds, ends)
    assert backend.are_at_velocities(target[:1], bounds[:1], ends[:1])
    assert not backend.are_at_velocities(target[:1] + 1e-6, bounds[:1], ends[:1])
