"""What the compensated setpoints do to drives and masses that SciPy integrates."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu.kernels.crane.compensation import compensate_setpoints

# dead times are the caller's: they change the time, not the setpoint at it
LAG, DEAD = np.array([0.025, 0.0, 0.3]), np.full(3, 7.0)
VISCOUS, COULOMB, WIDTH = np.array([100.0, 82.0, 75.0]), np.array([5.0, 7.5, 10.0]), 0.01


def motion(t: float) -> tuple[float, float, float]:
    """Position, velocity and acceleration of a move that reverses."""
    return np.sin(2.0 * t), 2.0 * np.cos(2.0 * t), -4.0 * np.sin(2.0 * t)


def compensated(velocity, acceleration, force) -> tuple[np.ndarray, np.ndarray]:
    forces, setpoints = np.array(force), np.zeros(3)
    known = np.array([*LAG, *DEAD, *VISCOUS, *COULOMB, WIDTH])
    compensate_setpoints(
        np.full(3, velocity), np.full(3, acceleration), known, forces, setpoints
    )
    return forces, setpoints


@pytest.mark.parametrize("axis", [0, 2])
def test_a_lagging_drive_follows(axis: int) -> None:
    def follow(t: float, v: np.ndarray) -> np.ndarray:
        _, velocity, acceleration = motion(t)
        return (compensated(velocity, acceleration, np.zeros(3))[1][axis] - v) / LAG[axis]

    found = solve_ivp(follow, (0.0, 2.0), [motion(0.0)[1]], method="LSODA", rtol=1e-9, atol=1e-10)
    assert found.y[0, -1] == pytest.approx(motion(2.0)[1], abs=1e-7)


def test_a_drive_without_lag_gets_its_velocity() -> None:
    assert compensated(0.3, 7.0, np.zeros(3))[1][1] == 0.3


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_mass_with_friction_follows(axis: int) -> None:
    mass = 2.5

    def slope(t: float, state: np.ndarray) -> list[float]:
        _, velocity, acceleration = motion(t)
        force = compensated(velocity, acceleration, np.full(3, mass * acceleration))[0][axis]
        friction = VISCOUS[axis] * state[1] + COULOMB[axis] * np.tanh(state[1] / WIDTH)
        return [state[1], (force - friction) / mass]

    found = solve_ivp(slope, (0.0, 2.0), motion(0.0)[:2], method="LSODA", rtol=1e-9, atol=1e-10)
    assert found.y[0, -1] == pytest.approx(motion(2.0)[0], abs=1e-6)
