"""Profiles of one axis: boundary states, limits, durations, by plain polynomial algebra."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings

from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.trajectory.pieces import expand_phases
from segfmu.kernels.trajectory.records import Expansion, PieceState
from tests.campaign import SOAK
from tests.problems import AxisProblem, axis_problems

PROBLEMS = json.loads(
    (Path(__file__).parents[2] / "data" / "planner-problems.json").read_text(encoding="utf-8")
)


def sampled(problem: AxisProblem, phases: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """End state (position, velocity, acceleration) and peaks of derivatives 1 .. n + 1."""
    n = problem.smoothness
    rows = 31 * len(phases)
    timing, coefficients = np.zeros((rows, 2)), np.zeros((rows, 2 * n))
    work = np.zeros((Expansion.SIZE, Expansion.COLUMNS))
    state = work[Expansion.STATE]
    state[PieceState.VELOCITY] = problem.v
    state[PieceState.ACCELERATION] = problem.a
    used = expand_phases(phases, len(phases), problem.axis(), timing, coefficients, 0, work)
    peaks = np.zeros(n + 1)
    for length, row in zip(timing[:used, 1], coefficients[:used], strict=True):
        piece = np.polynomial.Polynomial(row)
        times = length * np.linspace(0.0, 1.0, 33)
        for d in range(1, n + 2):
            peaks[d - 1] = max(peaks[d - 1], np.abs(piece.deriv(d)(times)).max())
    return state[:3], peaks


@pytest.mark.soak
@settings(max_examples=400 if SOAK else 100, deadline=None)
@example(AxisProblem(6, 1, (0.5, 0.5, 0.0, 0.5, 0.0, 0.0, 0.0), -0.5, 6e-135, -0.5, 0.0, -1.0))
@example(AxisProblem(6, 0, (0.5, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0), 0.0, 0.0, 6e-135, 0.0, 0.0))
@example(AxisProblem(4, 0, (0.5, 0.03, 0.0, 0.5, 0.0), 0.0, 0.0, 0.0, 0.0, 1.3e-134))
@given(axis_problems())
def test_boundary_is_met_within_every_limit_or_braking_is_impossible(
    problem: AxisProblem,
) -> None:
    count, phases = problem.shortest()
    assert count != -3
    if count < 0:
        assert braking_passes_the_limit(problem)
        return
    end, peaks = sampled(problem, phases)
    duration = phases[:, 0].sum()
    reach = abs(problem.distance) + problem.limits[0] * duration
    assert abs(end[0] - problem.distance) <= 1e-9 * max(reach, 1e-3)
    assert abs(end[1] - problem.w) <= 1e-9 * problem.limits[0]
    assert abs(end[2] - problem.b) <= 1e-9 * problem.limits[1]
    for peak, limit in zip(peaks, problem.limits, strict=True):
        assert limit == 0.0 or peak <= limit * (1.0 + 1e-9)


def braking_passes_the_limit(problem: AxisProblem) -> bool:
    """Whether the fastest ramp to zero acceleration leaves the velocity range at either end."""
    axis = problem.axis()
    first = problem.v + 0.5 * problem.a * ramp_duration(abs(problem.a), axis)[0]
    last = problem.w - 0.5 * problem.b * ramp_duration(abs(problem.b), axis)[0]
    return max(abs(first), abs(last)) > problem.limits[0]


def ratios(shape: int) -> np.ndarray:
    found = []
    for item in PROBLEMS:
        (start, v, a), (end, w, b) = item["start"], item["end"]
        problem = AxisProblem(4, shape, (*item["limits"], 0.0), v, a, w, b, end - start)
        count, phases = problem.shortest()
        assert count > 0, item
        found.append(phases[:, 0].sum() / item["optimal_duration"])
    return np.array(found)


def test_reference_problems_with_plateau() -> None:
    found = ratios(1)
    # the optimum itself is known to about 0.5 %
    assert found.min() > 0.99
    assert np.median(found) < 1.005
    assert np.quantile(found, 0.95) < 1.02
    assert found.max() < 1.21


def test_reference_problems_with_smoothstep() -> None:
    found = ratios(0)
    assert found.min() > 0.99
    assert np.median(found) < 1.09
    # what sequences of ramps can do at all: docs/ramp_bounds.md
    assert np.quantile(found, 0.95) < 1.36
    assert found.max() < 1.80


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_classic_jerk_limited_profile_in_closed_form(sign: float) -> None:
    problem = AxisProblem(2, 1, (2.0, 1.0, 2.0), 0.0, 0.0, 0.0, 0.0, sign * 10.0)
    count, phases = problem.shortest()
    # v / a + a / j for each velocity change and the rest at full speed
    assert phases[:, 0].sum() == pytest.approx(10.0 / 2.0 + 2.0 / 1.0 + 1.0 / 2.0, rel=1e-14)
    assert count == 7


def test_one_ramp_of_the_paper_is_found_as_one_phase() -> None:
    """Errata E9: with the jerk limit at which one ramp is at its limit, only I.1 remains."""
    for velocity, acceleration in ((0.2, 0.34), (0.17, 0.27)):
        time = 2.0 * velocity / acceleration
        limits = (1.0, 1.0, 1.875 * acceleration / time, 0.0, 0.0)
        distance = acceleration * time**2 / 7.0
        problem = AxisProblem(4, 0, limits, 0.0, 0.0, velocity, acceleration, distance)
        count, phases = problem.shortest()
        assert count == 1
        assert phases[0] == pytest.approx([time, time, 0.0, acceleration, 0.0], rel=1e-12)


def test_both_accelerations_are_braked_back_and_forth() -> None:
    # one ramp to zero passes c_1, and so does the way back from beyond zero, at either end
    limits = (0.1870842899176974, 0.5081218743726612, 0.836288400992345, 1.552457181243767)
    v, a = -0.1336826104365626, limits[1]
    problem = AxisProblem(3, 0, limits, v, a, v, -a, 0.02)
    count, phases = problem.shortest()
    assert count >= 11
    end, peaks = sampled(problem, phases)
    np.testing.assert_allclose(end, [0.02, v, -a], atol=1e-12)
    assert (peaks <= np.array(limits) * (1.0 + 1e-9)).all()
