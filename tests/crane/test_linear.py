"""Sampling, drive lags and the rope lengths of a schedule; the matrices are in test_feedback.py."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Crane, InputError
from segfmu.crane.feedback import design
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.linear import (
    lagged,
    linearised,
    matrices,
    sampled,
    scheduled_lengths,
    usual_sample_time,
)
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.stability import largest_eigenvalue
from segfmu.crane.tracking import TrackingController

LAB = Crane(2.2, 1.155, 1.0)


@pytest.mark.parametrize("driven", [False, True])
def test_sampled_is_a_zero_order_hold(driven: bool) -> None:
    # takes half a second, which collection would take in each process
    from scipy.signal import cont2discrete

    a, b = linearised(LAB, 0.5, driven)
    found = sampled(a, b, 0.03)
    expected = cont2discrete((a, b, np.eye(10), np.zeros((10, 3))), 0.03)[:2]
    for one, other in zip(found, expected, strict=True):
        assert one == pytest.approx(other, abs=1e-12)


def test_lag_of_the_drives() -> None:
    """Against the nonlinear crane's own pendulum equation for small angles."""
    lag, length, gravity = np.array([0.3, 0.0, 0.2]), 0.5, 9.81
    a, b = lagged(*linearised(LAB, length, driven=True), lag, driven=True)
    asked = np.array([0.4, -0.2, 0.1])

    def slope(t: float, s: np.ndarray) -> np.ndarray:
        commands = asked * t
        x_rate, y_rate, rope_rate = s[5:8]
        x_2 = (commands[0] - x_rate) / lag[0]
        y_2 = asked[1]
        rope_2 = (commands[2] - rope_rate) / lag[2]
        sway = [-(gravity * s[3] + x_2) / length, -(gravity * s[4] - y_2) / length]
        return np.array([*s[5:10], x_2, y_2, rope_2, *sway])

    expected = solve_ivp(slope, (0.0, 1.0), np.zeros(10), rtol=1e-10, atol=1e-12).y[:, -1]
    _, inputs = sampled(a, b, 1.0)
    assert (inputs @ asked)[:10] == pytest.approx(expected, abs=1e-8)
    assert (inputs @ asked)[[10, 12]] == pytest.approx(asked[[0, 2]])


def test_in_force_mode_a_lag_has_no_effect() -> None:
    a, b = linearised(LAB, 0.5, driven=False)
    found = lagged(a, b, np.full(3, 0.1), driven=False)
    assert found[0][:10, :10] == pytest.approx(a)
    assert found[1][:10] == pytest.approx(b)
    assert not found[0][10:].any()
    assert not found[1][10:].any()


def test_without_a_load_the_carriages_feel_nothing() -> None:
    a, b = matrices((2.2, 1.155, 0.0, 9.81), 0.5, driven=False)
    assert not a[5:8].any()
    assert b[5:8].diagonal() == pytest.approx([1.0 / 3.355, 1.0 / 1.155, 0.0])
    # a pendulum that hangs from a carriage nobody pushes keeps its frequency
    assert a[8, 3] == pytest.approx(-9.81 / 0.5)


def test_lengths_are_in_equal_ratios() -> None:
    lengths = scheduled_lengths(0.16, 0.98, 5)
    assert lengths[[0, -1]] == pytest.approx([0.16, 0.98])
    assert np.ptp(lengths[1:] / lengths[:-1]) < 1e-12
    assert scheduled_lengths(0.5, 0.5).tolist() == [0.5]


@pytest.mark.parametrize("ends", [(0.0, 1.0), (-1.0, 1.0), (1.0, 0.5), (1.0, np.inf)])
def test_bad_lengths_are_refused(ends) -> None:
    with pytest.raises(InputError, match="rope lengths must be positive and ascending"):
        scheduled_lengths(*ends)


@pytest.mark.parametrize("shortest", [0.02, 0.16, 1.0, 8.0, 40.0])
@pytest.mark.parametrize("lag", [0.0, 0.5])
def test_the_usual_sample_time_suits_any_crane(shortest: float, lag: float) -> None:
    """Signals three samples late, ropes up to ten times as long."""
    crane, period = Crane(5.0, 2.0, 1.0), usual_sample_time(9.81, shortest)
    assert 0.03 < period / np.sqrt(shortest / 9.81) <= 0.08
    ranges = {
        "sample_time": period, "shortest": shortest, "longest": 10.0 * shortest, "driven": True,
    }
    observer = design_observer(
        crane, lag=(lag,) * 3, delayed=3.0, uncertainty=Uncertainty(wake=0.0), **ranges
    )
    for make in (design, design_flat):
        gains = make(crane, lag=lag, dead_time=3.0 * period, **ranges)
        loop = TrackingController(observer, gains)
        for length in (shortest, 3.0 * shortest, 10.0 * shortest):
            assert largest_eigenvalue(loop, length, 1.0, (lag,) * 3) < 1.0


def test_a_usual_sample_time_is_whole_samples_of_the_sensors() -> None:
    assert usual_sample_time(9.81, 0.16, 0.004) == pytest.approx(0.008)
    # slower signals have no more to say
    assert usual_sample_time(9.81, 0.16, 0.02) == pytest.approx(0.02)
