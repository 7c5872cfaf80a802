"""Three slow ramps of a given duration: against polynomials, integration, and cruises."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from segfmu import Limits, Waypoint, plan, verify
from segfmu.kernels.planner.gentle import polynomial_levels, solve_gentle, write_gentle
from segfmu.kernels.planner.records import Cell, Gentle, Phase, Problem
from tests.problems import AxisProblem

LIMITS = (1.0, 1.0, 4.0, 20.0, 0.0)


def timed(problem: AxisProblem, duration: float) -> np.ndarray:
    row = problem.boundary()
    row[Problem.DURATION] = duration
    return row


def degree_five(problem: AxisProblem, duration: float) -> Polynomial:
    """The acceleration of the polynomial between the states."""
    powers = np.arange(6)
    rows = []
    for t in (0.0, duration):
        for d in range(3):
            rows.append([
                float(np.prod(np.arange(p - d + 1, p + 1))) * t ** max(p - d, 0) * (p >= d)
                for p in powers
            ])
    ends = [0.0, problem.v, problem.a, problem.distance, problem.w, problem.b]
    return Polynomial(np.linalg.solve(np.array(rows), ends)).deriv(2)


@pytest.mark.parametrize("seed", range(40))
def test_levels_begin_at_the_extreme_accelerations_of_the_polynomial(seed: int) -> None:
    random = np.random.default_rng(seed)
    v, a, w, b, distance = random.uniform(-0.5, 0.5, 5)
    problem = AxisProblem(4, 1, LIMITS, v, a, w, b, distance)
    duration = float(random.uniform(1.0, 4.0))
    gentle = np.zeros(Gentle.SIZE)
    polynomial_levels(timed(problem, duration), gentle)
    levels = gentle[Gentle.LEVELS : Gentle.LEVELS + 2]
    acceleration = degree_five(problem, duration)
    roots = acceleration.deriv().roots()
    inner = sorted(r.real for r in roots if abs(r.imag) < 1e-9 and 0.0 < r.real < duration)
    for t in inner:
        assert np.abs(levels - acceleration(t)).min() < 1e-9
    if len(inner) == 2:
        assert levels == pytest.approx(acceleration(np.array(inner)), abs=1e-9)


@pytest.mark.parametrize("seed", range(40))
@pytest.mark.parametrize("shape", [0, 1])
def test_what_is_solved_reaches_the_end_in_the_given_time(seed: int, shape: int) -> None:
    random = np.random.default_rng(seed)
    v, a, w, b = random.uniform(-0.4, 0.4, 4)
    problem = AxisProblem(4, shape, LIMITS, v, a, w, b, float(random.uniform(-1.0, 1.0)))
    row, axis, gentle = timed(problem, 4.0), problem.axis(), np.zeros(Gentle.SIZE)
    if not any(solve_gentle(attempt, row, axis, gentle) for attempt in range(6)):
        pytest.fail("no levels found")
    phases = np.zeros((Cell.ABOVE, Phase.SIZE))
    count = write_gentle(phases, row, axis, gentle)
    ramps = phases[:count][phases[:count, Phase.CHANGE] != 0.0]
    stretches = ramps[:, Phase.DURATION] / ramps[:, Phase.BASIS]
    assert stretches == pytest.approx(gentle[Gentle.STRETCH], rel=1e-12)
    # the acceleration is point-symmetric in each phase: exact means
    at, velocity = problem.a, problem.v
    for phase in phases[:count]:
        assert phase[Phase.ACCELERATION] == pytest.approx(at, abs=1e-12)
        at += phase[Phase.CHANGE]
        velocity += (phase[Phase.ACCELERATION] + at) / 2.0 * phase[Phase.DURATION]
    duration, position, *_ = problem.measured(phases[:count])
    assert phases[:count, Phase.DURATION].sum() == pytest.approx(4.0, rel=1e-12)
    assert duration == pytest.approx(4.0, rel=1e-12)
    assert at == pytest.approx(problem.b, abs=1e-12)
    assert velocity == pytest.approx(problem.w, abs=1e-11)
    assert position == pytest.approx(problem.distance, abs=1e-11)


def snap_rms(trajectory) -> float:
    _, lengths, coefficients = trajectory.pieces(0)
    total = 0.0
    for length, row in zip(lengths, coefficients, strict=True):
        snap = Polynomial(row).deriv(4)
        total += float((snap * snap).integ()(length))
    return float(np.sqrt(total / lengths.sum()))


@pytest.mark.parametrize("longer", [1.1, 1.3, 1.7, 2.5])
def test_a_longer_motion_has_less_snap(longer: float) -> None:
    limits = Limits(1.0, 1.0, 4.0, 20.0)
    points = [Waypoint(0.0, 0.2, 0.1), Waypoint(0.8, 0.3, -0.2)]
    shortest = plan(points, limits)
    found = plan(points, limits, duration=longer * shortest.duration)
    assert verify(found).passed
    # the snap falls with the second power of the stretch of the ramps at least
    assert snap_rms(found) < 1.1 * snap_rms(shortest) / longer**2
