"""The crane integrator against SciPy's, and its status codes."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu.kernels.integrate import crane_advance, error_weights, stage_row
from tests.crane.newton import accelerations

MASSES = (2.2, 1.155, 1.0, 9.81)
START = np.array([0.1, -0.2, 0.7, 0.2, -0.3, 0.3, -0.1, 0.1, 0.4, -0.2, 0.0])


def advance(state, drive, rate, duration, *, driven=False, wind=(0.0, 0.0, 0.0), tolerance=1e-11):
    result, work = np.array(state), np.zeros((16, 11))
    status = crane_advance(
        driven, result, np.array(drive), np.array(rate), np.zeros(2), np.array(wind), *MASSES,
        duration, tolerance, work,
    )
    return status, result, work[10, :3]


@pytest.mark.parametrize("duration", [1e-3, 0.5, 2.0])
def test_forces_linear_in_time_against_scipy(duration: float) -> None:
    drive, rate, wind = np.array([1.0, -0.5, -10.0]), np.array([0.5, 0.4, -0.3]), (0.1, 0.2, -0.3)

    def right(t: float, x: np.ndarray) -> np.ndarray:
        force = drive + t * rate
        second = accelerations(x[:10], force, wind, *MASSES)
        load = np.array([x[5] + x[7] * np.sin(x[3]) + x[2] * np.cos(x[3]) * x[8], 0.0, 0.0])
        sx, cx, sy, cy = np.sin(x[3]), np.cos(x[3]), np.sin(x[4]), np.cos(x[4])
        load[1] = x[6] - x[7] * cx * sy + x[2] * (sx * sy * x[8] - cx * cy * x[9])
        load[2] = -x[7] * cx * cy + x[2] * (sx * cy * x[8] + cx * sy * x[9])
        return np.concatenate([x[5:10], second, [force @ x[5:8] + np.dot(wind, load)]])

    expected = solve_ivp(
        right, (0.0, duration), START, method="DOP853", rtol=1e-12, atol=1e-13
    ).y[:, -1]
    status, found, force = advance(START, drive, rate, duration, wind=wind)
    assert status == 0
    assert found == pytest.approx(expected, rel=1e-8, abs=1e-8)
    assert force == pytest.approx(drive + duration * rate)


def test_driven_carriage_moves_as_prescribed() -> None:
    status, found, _ = advance(START, [0.4, -0.2, 0.1], [0.0] * 3, 0.5, driven=True)
    assert status == 0
    assert found[5:8] == pytest.approx(START[5:8] + 0.5 * np.array([0.4, -0.2, 0.1]))
    assert found[0] == pytest.approx(0.1 + 0.3 * 0.5 + 0.5 * 0.4 * 0.25)


def test_weights_satisfy_the_order_conditions() -> None:
    row, weights = np.zeros(11), np.zeros(11)
    nodes, rows = [], []
    for stage in range(7):
        nodes.append(stage_row(stage, row))
        rows.append(row[:7].copy())
        assert rows[-1].sum() == pytest.approx(nodes[-1], abs=1e-14)
    for power in range(5):
        assert rows[6] @ np.array(nodes) ** power == pytest.approx(1.0 / (power + 1), abs=1e-14)
    error_weights(weights)
    for power in range(4):
        assert weights[:7] @ np.array(nodes) ** power == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize(
    ("state", "drive", "status"),
    [
        ({3: 1.5, 8: 5.0}, [0.0, 0.0, -10.0], 1),
        ({2: 0.05, 3: 0.0, 4: 0.0, 7: -1.0, 8: 0.0, 9: 0.0}, [0.0, 0.0, -20.0], 2),
        ({0: np.nan}, [0.0, 0.0, -10.0], 4),
        ({}, [np.inf, 0.0, 0.0], 4),
    ],
)
def test_failures_are_reported_by_code(state, drive, status: int) -> None:
    start = START.copy()
    for i, value in state.items():
        start[i] = value
    assert advance(start, drive, [0.0] * 3, 0.2)[0] == status
