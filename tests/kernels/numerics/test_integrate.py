"""The embedded Runge-Kutta pair: order conditions, and the choice of the next step."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.kernels.numerics.integrate import next_step, stage_node, stage_state, step_error

pytestmark = pytest.mark.interpreted

# derivatives of seven components that each are 1 in one stage: the sums are the coefficients
ONE_EACH = np.vstack([np.eye(7), np.zeros((1, 7))])


def coefficients() -> tuple[np.ndarray, np.ndarray]:
    """Nodes c (7,) and rows a (7, 7) of the pair."""
    rows = np.zeros((7, 7))
    for stage in range(1, 7):
        stage_state(stage, 1.0, 7, np.zeros(7), ONE_EACH, rows[stage])
    return np.array([stage_node(stage) for stage in range(7)]), rows


def differences() -> np.ndarray:
    """Sizes of the differences of the two orders' weights (7,)."""
    return np.array([
        step_error(1.0, 1, np.zeros(1), np.zeros(1), np.ascontiguousarray(ONE_EACH[:, [j]]))
        for j in range(7)
    ])


def test_weights_satisfy_the_order_conditions() -> None:
    nodes, rows = coefficients()
    np.testing.assert_allclose(rows.sum(axis=1), nodes, rtol=0.0, atol=1e-14)
    for power in range(5):
        assert rows[6] @ nodes**power == pytest.approx(1.0 / (power + 1), abs=1e-14)
    # one of the conditions that look behind the stages
    assert rows[6] @ rows @ nodes == pytest.approx(1.0 / 6.0, abs=1e-14)


def test_error_is_that_of_weights_of_order_4() -> None:
    nodes, _ = coefficients()
    # stages with these derivatives: those of t^power at the nodes, which both orders integrate
    for power in range(4):
        k = np.vstack([(nodes**power)[:, None], np.zeros((1, 1))])
        assert step_error(1.0, 1, np.zeros(1), np.zeros(1), k) == pytest.approx(0.0, abs=1e-15)
    assert differences() == pytest.approx(
        [71 / 57600, 0.0, 71 / 16695, 71 / 1920, 17253 / 339200, 22 / 525, 1 / 40]
    )


def test_error_counts_relative_to_large_states_and_only_the_first_components() -> None:
    k = np.zeros((7, 3))
    k[6] = [4.0, 8.0, 1e6]
    start, end = np.array([0.0, -3.0, 0.0]), np.array([0.0, 1.0, 0.0])
    assert step_error(0.5, 1, start, end, k) == pytest.approx(0.5 * 4.0 / 40.0)
    # (0.5 * 8 / 40) / (1 + 3) is less than the first one's
    assert step_error(0.5, 2, start, end, k) == pytest.approx(0.5 * 4.0 / 40.0)
    assert step_error(0.5, 2, start, 10.0 * end, 1e300 * k) == 1e100


def test_states_start_from_the_given_one_and_scale_with_the_step() -> None:
    random = np.random.default_rng(3)
    state, k = random.normal(size=4), random.normal(size=(7, 4))
    _, rows = coefficients()
    for stage in range(1, 7):
        trial = np.full(4, 9.0)
        size = stage_state(stage, 0.3, 3, state, k, trial)
        np.testing.assert_allclose(trial[:3], (state + 0.3 * rows[stage] @ k)[:3], rtol=1e-14)
        assert trial[3] == 9.0
        assert size == pytest.approx(np.abs(trial[:3]).sum(), rel=1e-14)


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf, -1e200])
def test_a_state_beyond_all_bounds_is_told_by_its_size(wrong: float) -> None:
    for stage in range(1, 7):
        state = np.array([1.0, wrong, -2.0])
        assert not stage_state(stage, 0.3, 3, state, np.zeros((7, 3)), np.zeros(3)) < 1e100


def test_next_step_aims_at_the_tolerance_within_bounds() -> None:
    assert next_step(1e-10, 1e-10) == pytest.approx(0.9)
    assert next_step(32e-10, 1e-10) == pytest.approx(0.45)
    assert next_step(0.0, 1e-10) == next_step(1e-30, 1e-10) == 5.0
    # where the short cut begins, the rule gives the greatest factor as well
    assert next_step(1e-10 / 5299.0, 1e-10) == next_step(1e-10 / 5301.0, 1e-10) == 5.0
    assert next_step(1e-10 / 5000.0, 1e-10) == pytest.approx(0.9 * 5000.0**0.2)
    assert next_step(1e100, 1e-10) == 0.2
