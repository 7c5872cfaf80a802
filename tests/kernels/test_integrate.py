"""The embedded Runge-Kutta pair: order conditions, and the choice of the next step."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.integrate import error_weights, next_step, stage_row


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


def test_next_step_aims_at_the_tolerance_within_bounds() -> None:
    assert next_step(1e-10, 1e-10) == pytest.approx(0.9)
    assert next_step(32e-10, 1e-10) == pytest.approx(0.45)
    assert next_step(0.0, 1e-10) == next_step(1e-30, 1e-10) == 5.0
    assert next_step(1e100, 1e-10) == 0.2
