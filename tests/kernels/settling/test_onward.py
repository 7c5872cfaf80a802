"""Leads and the plan behind them in one call: what is done already, what fails, and the rows."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import (
    Axis,
    Cell,
    DelayedState,
    Lower,
    PlanOptions,
    PlanStatus,
    PlanWork,
    Refusal,
    Shape,
    Synchronization,
    WaypointState,
)
from segfmu.kernels.settling.records import (
    Done,
    LeadEnd,
    LeadRows,
    LeadTask,
    LeadWork,
    PlanPart,
)
from segfmu.kernels.trajectory.records import Brake, Judging, Timing

N = 4
LIMITS = np.array([[1.0, 0.5, 10.0, 20.0, 0.0], [0.8, 0.4, 5.0, 30.0, 0.0]])
START = np.array([[0.0, 0.3, 0.1, 0.2, 0.5], [0.0, -0.2, 0.0, 0.1, 0.0]])
TARGET = np.array([1.0, 0.5])
LEAST = 2 * LeadRows.PIECES + LeadRows.ALL


class Motion(NamedTuple):
    """Arrays of `plan_onward` for two axes to rest."""

    states: FloatArray
    axes: FloatArray
    cells: FloatArray
    timing: FloatArray
    coefficients: FloatArray
    offsets: np.ndarray
    times: FloatArray
    lead: FloatArray

    def plan(self, done: int = Done.NOTHING) -> int:
        self.lead[LeadWork.TASK, LeadTask.DONE] = done
        return backend.plan_onward(
            self.states, np.zeros(2), LIMITS, np.zeros((2, Lower.SIZE)), self.axes, self.cells,
            self.timing, self.coefficients, self.offsets, self.times, self.lead,
        )

    def part(self, part: int) -> list[list[float]]:
        """Timing and coefficients of the pieces of a part."""
        used = self.offsets[3 * part + 2]
        rows = np.hstack([self.timing[part, :used], self.coefficients[part, :used]])
        return rows.tolist()

    def at(self, row: int, axis: int) -> FloatArray:
        """Position, velocity and acceleration at the end of a piece of the part WHOLE."""
        length = self.timing[PlanPart.WHOLE, row, Timing.LENGTH]
        polynomial = np.polynomial.Polynomial(self.coefficients[PlanPart.WHOLE, row])
        return np.array([polynomial.deriv(i)(length) for i in range(3)])


def motion(rows: int = LEAST, start: FloatArray = START, brakes: float = 1.0) -> Motion:
    states = np.zeros((4, 2, LeadEnd.SIZE))
    states[0, :, : N + 1] = start
    states[1, :, WaypointState.POSITION] = TARGET
    lead = np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))
    lead[LeadWork.TASK, LeadTask.BRAKES] = brakes
    lead[LeadWork.OPTIONS, : PlanOptions.SIZE] = (
        N, Shape.PLATEAU, Synchronization.WAYPOINTS, 0.0, 0.0
    )
    lead[LeadWork.JUDGING, : Judging.SIZE] = 1e-9, 5e-10
    return Motion(
        states, np.zeros((4, Axis.SIZE)), np.zeros((2, Cell.SIZE, Cell.COLUMNS)),
        np.zeros((PlanPart.COUNT, rows, Timing.SIZE)), np.zeros((PlanPart.COUNT, rows, 2 * N)),
        np.zeros(3 * PlanPart.COUNT, dtype=np.int64), np.zeros((3, 2)), lead,
    )


def test_both_axes_end_at_the_target_together() -> None:
    found = motion()
    assert found.plan() == PlanStatus.PLANNED
    assert found.times[1, 0] == pytest.approx(found.times[1, 1], abs=1e-12)
    for axis in range(2):
        first, last = found.offsets[3 * PlanPart.WHOLE + axis :][:2]
        begin = found.coefficients[PlanPart.WHOLE, first, : N + 1] * [1, 1, 2, 6, 24]
        assert begin == pytest.approx(START[axis], abs=1e-9)
        assert found.at(last - 1, axis) == pytest.approx([TARGET[axis], 0.0, 0.0], abs=1e-9)
        assert found.axes[2 + axis, Brake.UNTIL] == 0.0
    pieces = [len(found.part(i)) for i in (PlanPart.LEADS, PlanPart.BEHIND, PlanPart.WHOLE)]
    assert pieces[0] > 0 and pieces[0] + pieces[1] == pieces[2]


def test_leads_that_are_done_are_taken() -> None:
    """From rest, with leads that last half a second: the plan begins then."""
    found = motion(start=np.zeros((2, N + 1)))
    leads = slice(3 * PlanPart.LEADS, 3 * PlanPart.LEADS + 3)
    found.offsets[leads] = 0, 1, 2
    found.timing[PlanPart.LEADS, :2, Timing.LENGTH] = 0.5
    found.states[2, :, DelayedState.DELAY] = 0.5
    assert found.plan(Done.LEADS) == PlanStatus.PLANNED
    at_once = motion(start=np.zeros((2, N + 1)))
    assert at_once.plan() == PlanStatus.PLANNED
    assert found.times[1] == pytest.approx(at_once.times[1] + 0.5, abs=1e-12)
    assert found.part(PlanPart.WHOLE)[0][: Timing.SIZE] == [0.0, 0.5]


def test_phases_that_are_done_need_more_rows_alone() -> None:
    wide = motion()
    assert wide.plan() == PlanStatus.PLANNED
    # ramps of five derivatives: more pieces than rows
    short = motion()
    short.offsets[2] = 1
    assert short.plan() == PlanStatus.MORE_PIECES
    short.offsets[2] = 0
    assert short.plan() == PlanStatus.PLANNED
    before = short.part(PlanPart.WHOLE)
    short.timing[PlanPart.WHOLE] = short.coefficients[PlanPart.WHOLE] = 0.0
    assert short.plan(Done.PHASES) == PlanStatus.PLANNED
    assert short.part(PlanPart.WHOLE) == before == wide.part(PlanPart.WHOLE)


def test_an_axis_without_lead_is_named() -> None:
    start = START.copy()
    start[1, 1] = 2.0
    found = motion(start=start, brakes=0.0)
    assert found.plan() == PlanStatus.NO_PROFILE
    assert found.lead[LeadWork.TASK, LeadTask.FAILED] == 1.0
    braked = motion(start=start)
    assert braked.plan() == PlanStatus.PLANNED
    assert braked.lead[LeadWork.TASK, LeadTask.FAILED] == -1.0
    assert braked.axes[2:, Brake.UNTIL].tolist()[0] == 0.0 < braked.axes[3, Brake.UNTIL]


def test_a_refusal_of_the_plan_is_reported() -> None:
    """A target velocity beyond the limit; the report has nothing of an earlier one."""
    found = motion()
    found.lead[LeadWork.PLAN + PlanWork.REFUSAL] = 7.0
    found.states[1, 1, WaypointState.VELOCITY] = 0.9
    assert found.plan() < 0
    report = found.lead[LeadWork.PLAN + PlanWork.REFUSAL, : Refusal.SIZE]
    assert 7.0 not in report
