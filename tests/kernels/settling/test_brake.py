"""Brakes: those of Ruckig at the smoothness 2, and what they keep at the others."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.planner.records import Lower
from segfmu.kernels.settling.records import Chain, LeadRows, LeadWork
from segfmu.kernels.trajectory.records import Brake
from segfmu.planning.polynomials import derivative_pieces, extrema

LIMITS = np.array([1.0, 1.0, 4.0, 20.0, 400.0, 1e4, 3e5])


def brake(
    state: FloatArray, limits: FloatArray, whole: bool = False,
    lower: tuple[float, float] = (0.0, 0.0),
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """The row BRAKE, the state that is reached, timing and coefficients."""
    n = limits.size - 1
    lead = np.zeros((LeadWork.SIZE, LeadWork.COLUMNS))
    lead[LeadWork.NOW, : n + 1] = state
    lead[LeadWork.LOWER, : Lower.SIZE] = lower
    timing, coefficients = np.zeros((LeadRows.ALL, 2)), np.zeros((LeadRows.ALL, 2 * n))
    count = backend.find_brake(whole, limits, lead, timing, coefficients)
    assert count >= 0
    rows = slice(2 * LeadRows.PIECES, 2 * LeadRows.PIECES + count)
    reached = lead[LeadWork.BRAKED, : Chain.SIZE]
    return lead[LeadWork.BRAKE, : Brake.SIZE], reached, timing[rows], coefficients[rows]


def ruckig_time(v: float, a: float, limits: FloatArray) -> tuple[float, float]:
    """Duration of the brake of Ruckig's brake.cpp, and the velocity at its end."""
    top, most, jerk = limits
    sign = 1.0
    if a < -most or (abs(a) <= most and not _rises(v, a, limits) and _rises(-v, -a, limits)):
        sign, v, a = -1.0, -v, -a
    first, second = 0.0, 0.0
    if a > most:
        to_most, to_zero = (a - most) / jerk, a / jerk
        at_most = v + to_most * (a - jerk * to_most / 2.0)
        if v + to_zero * (a - jerk * to_zero / 2.0) > top:
            first, second = _velocity_brake(v, a, limits)
        elif at_most < -top:
            first = to_most
            second = max(
                min(-(at_most + top) / most, -most / (2.0 * jerk) - (at_most - top) / most), 0.0
            )
        else:
            first = to_most
    elif _rises(v, a, limits):
        first, second = _velocity_brake(v, a, limits)
    # without its first phase a brake has no jerk
    jerk_1 = jerk if first > 0.0 else 0.0
    v += first * (a - jerk_1 * first / 2.0)
    v += second * (a - jerk_1 * first)
    return first + second, sign * v


def _rises(v: float, a: float, limits: FloatArray) -> bool:
    """Whether the velocity is, or gets, above its upper limit and can be brought back."""
    top, _, jerk = limits
    back = a * a / (2.0 * jerk)
    return (v > top and v - back > -top) or (a > 0.0 and v + back > top)


def _velocity_brake(v: float, a: float, limits: FloatArray) -> tuple[float, float]:
    top, most, jerk = limits
    to_least = (a + most) / jerk
    least = min(
        a / jerk + sqrt(a * a + 2.0 * jerk * (v - top)) / jerk,
        a / jerk + sqrt(a * a / 2.0 + jerk * (v + top)) / jerk,
    )
    if to_least >= least:
        return max(least, 0.0), 0.0
    at = v + to_least * (a - jerk * to_least / 2.0)
    return max(to_least, 0.0), max(
        min((at - top) / most, -most / (2.0 * jerk) + (at + top) / most), 0.0
    )


def test_brakes_at_smoothness_2_are_those_of_ruckig() -> None:
    random = np.random.default_rng(3)
    compared = 0
    for _ in range(400):
        limits = random.uniform(0.08, 16.0, 3)
        v, a = random.uniform(-3.0, 3.0, 2) * limits[:2]
        expected, end = ruckig_time(v, a, limits)
        # in a narrow range of velocities Ruckig's brake may end outside
        if abs(end) <= limits[0] * (1.0 + 1e-9):
            compared += expected > 0.0
            found = brake(np.array([0.0, v, a]), limits)[0][Brake.UNTIL]
            assert found == pytest.approx(expected, rel=1e-9, abs=1e-9)
    assert compared > 150


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("beyond", [1e-9, 0.3, 2.0])
@pytest.mark.parametrize("whole", [False, True])
def test_one_derivative_comes_inside_and_the_others_stay(
    n: int, beyond: float, whole: bool
) -> None:
    limits = LIMITS[: n + 1]
    for order in range(1, n + 1):
        state = np.zeros(n + 1)
        state[order] = -limits[order - 1] * (1.0 + beyond)
        told, reached, timing, coefficients = brake(state, limits, whole)
        assert told[Brake.UNTIL] > 0.0
        assert (np.abs(reached[1 : n + 1]) <= limits[:n] * (1.0 + 1e-12)).all()
        if whole:
            assert np.abs(reached[2 : n + 1]).max(initial=0.0) == 0.0
        for d in range(1, n + 2):
            low, high = extrema(coefficients, timing[:, 1], d)
            most = max(limits[d - 1], abs(state[min(d, n)]) if d == order else 0.0)
            # those below may be carried outside
            assert d < order or max(-low, high) <= most * (1.0 + 1e-9)
        for d in range(n + 1):
            piece = derivative_pieces(coefficients, d)
            right = np.sum(piece * timing[:, 1:] ** np.arange(piece.shape[1]), axis=1)
            scale = max(np.abs(piece[:, 0]).max(), 1e-12)
            np.testing.assert_allclose(right[:-1], piece[1:, 0], atol=1e-9 * scale)


def test_limits_by_direction_at_smoothness_2_are_those_of_the_closed_form() -> None:
    # downwards 0.5 and 0.7, upwards 1.0 and 2.0: what is too fast downwards is braked upwards
    limits, lower, jerk = np.array([1.0, 2.0, 4.0]), (0.5, 0.7), 4.0
    rise = 2.0 / jerk
    held = (3.0 - 0.5 - 0.5 * rise * 2.0) / 2.0
    down = brake(np.array([0.0, -3.0, 0.0]), limits, False, lower)[0]
    assert down[Brake.UNTIL] == pytest.approx(rise + held, rel=1e-9)
    assert down[Brake.HIGHEST + 2] == pytest.approx(2.0, rel=1e-9)
    rise = 0.7 / jerk
    held = (3.0 - 1.0 - 0.5 * rise * 0.7) / 0.7
    up = brake(np.array([0.0, 3.0, 0.0]), limits, False, lower)[0]
    assert up[Brake.UNTIL] == pytest.approx(rise + held, rel=1e-9)
    assert up[Brake.LOWEST + 2] == pytest.approx(-0.7, rel=1e-9)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_a_mirrored_state_comes_inside_mirrored_limits_as_soon(n: int) -> None:
    random = np.random.default_rng(n)
    compared = 0
    for _ in range(30):
        limits = LIMITS[: n + 1].copy()
        state = np.array([0.0, *(random.uniform(-2.0, 2.0, n) * limits[:n])])
        other = limits.copy()
        other[:2] = random.uniform(0.3, 3.0, 2) * limits[:2]
        one = brake(state, limits, False, tuple(other[:2]))[0]
        two = brake(-state, other, False, tuple(limits[:2]))[0]
        compared += one[Brake.UNTIL] > 0.0
        assert two[Brake.UNTIL] == pytest.approx(one[Brake.UNTIL], rel=1e-9)
    assert compared > 10


def test_a_state_that_can_stay_inside_needs_no_brake() -> None:
    told, _, timing, _ = brake(np.array([0.0, 0.5, 0.5, 1.0, 0.0]), LIMITS[:5])
    assert told[Brake.UNTIL] == 0.0
    assert timing.size == 0


def test_a_jerk_far_beyond_its_limit_does_not_carry_the_velocity_away() -> None:
    # a motion slowed down ten times: its snap has to be a ten-thousandth
    limits = np.array([0.1, 0.01, 0.004, 0.002, 0.0])
    state = np.array([0.0, 0.3957, 0.2986, -0.1904, -1.899])
    told = brake(state, limits)[0]
    # the acceleration comes inside with the jerk as it is, and then brakes within its limit
    assert told[Brake.HIGHEST + 1] < 2.0 * state[1]
    assert told[Brake.UNTIL] < 1.1 * (told[Brake.HIGHEST + 1] - limits[0]) / limits[1]


def test_all_derivatives_slightly_outside_come_inside() -> None:
    # brought inside at once, the acceleration leaves the velocity no way to follow
    limits = np.array([1.6595476, 0.50387635, 5.8506225, 11.753606, 398.80876, 14282.492, 0.0])
    shares = np.array([-1.00000015, 1.00008445, -1.00374033, -1.0127474, 1.00000682, 1.01074009])
    told, reached, _, _ = brake(np.array([0.0, *(shares * limits[:6])]), limits)
    assert 0.0 < told[Brake.UNTIL] < 5.0
    assert (np.abs(reached[1:7]) <= limits[:6] * (1.0 + 1e-12)).all()
