"""Linearisation, gains and the damping of an initial sway, on the nonlinear plant."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane.feedback import Weights, design, linearised
from segfmu.crane.plant import Plant, Setpoints

LAB = (2.2, 1.155, 1.0)


@pytest.mark.parametrize("length", [0.16, 1.0, 20.0])
def test_linearisation_is_the_derivative_of_the_rhs(length: float) -> None:
    crane = Crane(*LAB)
    a, b = linearised(crane, length, driven=False)
    state, force = crane.hanging([0.0, 0.0, -length]), np.array([0.0, 0.0, -9.81])
    h = 1e-6
    for i, unit in enumerate(np.eye(10)):
        numeric = crane.rhs(state + h * unit, force) - crane.rhs(state - h * unit, force)
        assert numeric / (2.0 * h) == pytest.approx(a[:, i], abs=1e-6 / length)
    for i, unit in enumerate(np.eye(3)):
        numeric = crane.rhs(state, force + h * unit) - crane.rhs(state, force - h * unit)
        assert numeric / (2.0 * h) == pytest.approx(b[:, i], abs=1e-6 / length)


def sway_after(masses, length: float, periods: float, *, driven: bool, enabled: bool) -> float:
    """Largest sway angle [deg] in the period after `periods` from 5 degrees in both angles."""
    crane = Crane(*masses)
    period = 2.0 * np.pi * np.sqrt(length / crane.gravity)
    feedback = design(
        crane, sample_time=period / 100.0, shortest=0.5 * length, longest=2.0 * length,
        driven=driven,
    )
    start = crane.hanging([0.0, 0.0, -length])
    hold = Setpoints(
        force=np.array([0.0, 0.0, -masses[2] * crane.gravity]), reference=start.copy()
    )
    start[3:5] = np.radians([5.0, -5.0])
    plant = Plant(crane, start, hold, feedback, driven=driven, enabled=enabled)
    largest = 0.0
    for i in range(int(100 * (periods + 1.0))):
        plant.step(period / 100.0, hold)
        if i >= 100 * periods:
            largest = max(largest, float(np.abs(plant.state[3:5]).max()))
    return float(np.degrees(largest))


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize(
    ("masses", "length"),
    [(LAB, 0.16), (LAB, 0.98), ((2000.0, 500.0, 5000.0), 10.0), ((20000.0, 5000.0, 100.0), 20.0)],
)
def test_sway_of_5_degrees_is_gone_within_four_periods(masses, length, driven: bool) -> None:
    assert sway_after(masses, length, 4.0, driven=driven, enabled=True) < 0.1


def test_without_feedback_the_sway_stays() -> None:
    assert sway_after(LAB, 0.5, 4.0, driven=True, enabled=False) > 4.5


def test_bad_designs_are_refused() -> None:
    crane = Crane(*LAB)
    with pytest.raises(InputError, match="sample_time"):
        design(crane, sample_time=0.0, shortest=0.1, longest=1.0)
    with pytest.raises(InputError, match="rope lengths"):
        design(crane, sample_time=0.01, shortest=2.0, longest=1.0)
    with pytest.raises(InputError, match="weight effort"):
        Weights(effort=0.0)
