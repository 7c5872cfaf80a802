"""Lagrange's equations against a Newtonian derivation, and conservation of energy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu.crane import Crane
from segfmu.kernels.crane._crane import crane_driven, crane_energy, crane_rhs
from tests.crane.newton import accelerations

RNG = np.random.default_rng(20240229)
MASSES = (2.2, 1.155, 1.0, 9.81)


def random_case() -> tuple[np.ndarray, np.ndarray, np.ndarray, tuple[float, ...]]:
    state = np.concatenate(
        [
            RNG.uniform(-3.0, 3.0, 2), RNG.uniform(0.1, 20.0, 1), RNG.uniform(-1.3, 1.3, 2),
            RNG.uniform(-3.0, 3.0, 5),
        ]
    )
    masses = (*10.0 ** RNG.uniform(-1.0, 3.0, 3), RNG.uniform(1.0, 20.0))
    return state, RNG.uniform(-50.0, 50.0, 3), RNG.uniform(-5.0, 5.0, 3), masses


def test_rhs_agrees_with_newton_at_1000_states() -> None:
    for _ in range(1000):
        state, force, wind, masses = random_case()
        found = Crane(*masses).rhs(state, force, wind)
        expected = accelerations(state, force, wind, *masses)
        scale = np.abs(expected).max()
        assert np.abs(found[5:] - expected).max() <= 1e-12 * scale
        assert found[:5].tolist() == state[5:].tolist()


def test_driven_form_is_the_inverse_of_the_rhs() -> None:
    for _ in range(200):
        state, force, wind, masses = random_case()
        generalized, derivative = np.append(force, [0.3, -0.2]), np.zeros(10)
        crane_rhs(state, generalized, wind, np.array(masses), derivative)
        again, needed = np.zeros(10), np.zeros(3)
        carriage = derivative[5:8].copy()
        crane_driven(state, carriage, generalized, wind, np.array(masses), again, needed)
        assert again == pytest.approx(derivative, rel=1e-9, abs=1e-9)
        assert needed == pytest.approx(force, rel=1e-8, abs=1e-8)


def test_energy_minus_work_of_constant_forces_is_conserved() -> None:
    crane = Crane(*MASSES)
    force = np.array([0.8, -0.5, -9.9])
    start = np.array([0.0, 0.0, 2.0, 0.3, -0.2, 0.1, 0.2, 0.05, 0.1, -0.3])

    def energy(state: np.ndarray) -> float:
        values = np.zeros(2)
        crane_energy(state, np.array(MASSES), values)
        return float(values.sum())

    run = solve_ivp(
        lambda _, x: crane.rhs(x, force), (0.0, 10.0), start, method="DOP853", rtol=1e-12,
        atol=1e-13,
    )
    work = np.array([force @ (x[:3] - start[:3]) for x in run.y.T])
    energies = np.array([energy(x) for x in run.y.T])
    drift = np.abs(energies - energies[0] - work).max()
    assert drift <= 1e-9 * np.abs(energies).max()


def test_equilibrium_needs_the_weight_as_tension() -> None:
    crane = Crane(*MASSES)
    at_rest = np.array([1.0, 2.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    assert crane.rhs(at_rest, [0.0, 0.0, -9.81]) == pytest.approx(np.zeros(10), abs=1e-15)
    # more tension lifts: the rope shortens
    assert crane.rhs(at_rest, [0.0, 0.0, -12.0])[7] < 0.0
