"""The estimate of the rope sensor's offset, on loads that swing by Newton's laws."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import product

import numpy as np
import pytest

from segfmu.kernels.control.offset import (
    offset_decide,
    offset_estimate,
    offset_filter,
    offset_noise,
    offset_sum,
)
from segfmu.kernels.control.records import (
    OffsetEstimate,
    OffsetMemory,
    OffsetSums,
    Tracking,
)
from tests.campaign import campaign, soaked, soaked_rows
from tests.crane.newton import accelerations

T, GRAVITY, LENGTH = 0.01, 9.81, 0.8
MASSES = (2.2, 1.155, 1.0, GRAVITY)
STEP = 2.0 * np.pi / 4096.0
BANDWIDTH = 4.0 * np.sqrt(GRAVITY / LENGTH)
Course = Callable[[float], np.ndarray]


def parameters(share: float = 0.05) -> np.ndarray:
    """What of the tracking controller's the estimate reads."""
    found = np.zeros(Tracking.SIZE)
    found[Tracking.PERIOD], found[Tracking.GRAVITY] = T, GRAVITY
    found[Tracking.DECAY] = np.exp(-T / 0.1)
    found[Tracking.OFFSET_EXPECTED : Tracking.DELAY] = (
        share, BANDWIDTH, STEP**2 / 12.0, 1e-4**2 / 12.0
    )
    return found


def new_memory() -> np.ndarray:
    return np.zeros((OffsetMemory.SIZE, OffsetMemory.COLUMNS))


def swing(
    carriage: Course, duration: float, *, rope: Course | None = None, wind: Course | None = None,
    length: float = LENGTH, start: tuple[float, float] = (0.0, 0.0), payload: float = 1.0,
) -> np.ndarray:
    """States (ticks, 10) of a load under accelerations of bridge, trolley and rope.

    The forces that give these accelerations follow from Newton's equations, which are linear in
    them.
    """
    masses = (*MASSES[:2], payload, GRAVITY)

    def slope(time: float, state: np.ndarray) -> np.ndarray:
        blow = np.zeros(3) if wind is None else wind(time)
        wanted = np.append(carriage(time), 0.0 if rope is None else rope(time))
        base = accelerations(state, np.zeros(3), blow, *masses)
        columns = [accelerations(state, f, blow, *masses) - base for f in np.eye(3)]
        forces = np.linalg.solve(np.array(columns).T[:3], wanted - base[:3])
        return np.append(state[5:], base + np.array(columns).T @ forces)

    state = np.array([0.0, 0.0, length, *start, 0.0, 0.0, 0.0, 0.0, 0.0])
    found, h = [state], T
    for i in range(round(duration / T)):
        a = slope(i * h, state)
        b = slope(i * h + h / 2.0, state + h / 2.0 * a)
        c = slope(i * h + h / 2.0, state + h / 2.0 * b)
        d = slope(i * h + h, state + h * c)
        state = state + h / 6.0 * (a + 2.0 * b + 2.0 * c + d)
        found.append(state)
    return np.array(found)


def estimates(
    signals: np.ndarray, planned: np.ndarray, share: float = 0.05
) -> tuple[np.ndarray, np.ndarray]:
    """Offsets in use, and the memory at the end."""
    given, memory = parameters(share), new_memory()
    pairs = zip(signals, planned, strict=True)
    return np.array([offset_estimate(given, m, r, memory) for m, r in pairs]), memory


def push(time: float) -> np.ndarray:
    """A move of about half a metre: there and back with smooth accelerations."""
    return np.array([0.6, -0.4]) * np.sin(2.0 * np.pi * time / 3.0) ** 3 * (time < 3.0)


def lift(time: float) -> float:
    return -0.3 * np.sin(2.0 * np.pi * time / 2.0) ** 3 * (time < 2.0)


@cache
def planned() -> np.ndarray:
    return swing(push, 5.0, rope=lift)


def measured(states: np.ndarray, offset: float = 0.0, noise: float = 0.0) -> np.ndarray:
    """Signals (ticks, 5) of a sensor that shows the length less an offset."""
    signals = states[:, :5] - [0.0, 0.0, offset, 0.0, 0.0]
    if noise:
        signals[:, 3:] += np.random.default_rng(7).normal(0.0, noise, (len(signals), 2))
    return signals


MOVED = [(-0.08, 0.5), (0.02, 1.0), (0.08, 0.5)]


@pytest.mark.parametrize(("offset", "payload"), [
    *MOVED, *soaked_rows(*(
        case for case in product((-0.08, -0.04, 0.02, 0.04, 0.08), (0.5, 1.0)) if case not in MOVED
    )),
])
def test_the_offset_is_found_in_a_move_with_hoisting(offset: float, payload: float) -> None:
    true = swing(push, 5.0, rope=lift, length=LENGTH + offset, payload=payload)
    found, _ = estimates(measured(true, offset), planned())
    assert not found[:30].any()
    assert found[-1] == pytest.approx(offset, rel=0.04)
    # at rest nothing is learnt, and nothing drifts
    assert np.ptp(found[-50:]) < 1e-3


def test_the_offset_is_found_from_rounded_signals_of_a_swaying_load() -> None:
    true = swing(push, 5.0, rope=lift, length=LENGTH + 0.04, start=(0.05, -0.03))
    signals = measured(true, 0.04)
    signals[:, 3:] = np.round(signals[:, 3:] / STEP) * STEP
    found, _ = estimates(signals, planned())
    assert found[-1] == pytest.approx(0.04, rel=0.2)


@pytest.mark.parametrize("noise", [0.0, STEP / np.sqrt(12.0)])
def test_without_an_offset_none_is_used(noise: float) -> None:
    signals = measured(swing(push, 5.0, rope=lift), noise=noise)
    found, memory = estimates(signals, planned())
    assert not found.any()
    assert abs(memory[OffsetMemory.ESTIMATE, OffsetEstimate.FOUND]) < (0.02 if noise else 1e-6)


@pytest.mark.parametrize("start", [0.02, 0.1])
def test_initial_sway_is_no_offset(start: float) -> None:
    found, memory = estimates(measured(swing(push, 5.0, rope=lift, start=(start, 0.0))), planned())
    assert not found.any()
    assert abs(memory[OffsetMemory.ESTIMATE, OffsetEstimate.FOUND]) < 4e-3


@pytest.mark.parametrize("begin", [0.0, 1.5, *soaked(0.6, 3.5)])
def test_a_gust_is_no_offset(begin: float) -> None:
    def blow(time: float) -> np.ndarray:
        share = (time - begin) / 0.5
        force = 0.5 * (1.0 - np.cos(2.0 * np.pi * share)) * (0.0 < share < 1.0)
        return force * np.array([1.0, 0.6, 0.0])

    found, _ = estimates(measured(swing(push, 5.0, rope=lift, wind=blow)), planned())
    assert not found.any()


@pytest.mark.parametrize("wind", [0.05, 0.2])
def test_constant_wind_is_no_offset_and_moves_no_estimate(wind: float) -> None:
    def blow(time: float) -> np.ndarray:
        return np.array([wind, -wind, 0.0])

    found, memory = estimates(measured(swing(push, 5.0, rope=lift, wind=blow)), planned())
    assert not found.any()
    assert abs(memory[OffsetMemory.ESTIMATE, OffsetEstimate.FOUND]) < 2e-3
    true = swing(push, 5.0, rope=lift, wind=blow, length=LENGTH + 0.04)
    found, memory = estimates(measured(true, 0.04), planned())
    assert memory[OffsetMemory.ESTIMATE, OffsetEstimate.FOUND] == pytest.approx(0.04, rel=0.03)
    # in use where the wind's beginning, which is like a gust, is soon forgotten
    assert found[-1] == pytest.approx(0.04 if wind < 0.1 else 0.0, rel=0.03)


def test_the_instrument_is_blind_to_what_noise_and_wind_do_to_the_factor() -> None:
    """Residuals that go with what is measured alone, as wind's do, are no offset."""
    random, sums = np.random.default_rng(5), np.zeros(OffsetSums.SIZE)
    for _ in range(20000):
        planned, wind = random.normal(0.0, 1.0, 2)
        offset_sum(1.0, np.array([0.04 * planned + wind, planned + wind, planned]), sums)
    assert sums[OffsetSums.ZR] / sums[OffsetSums.ZF] == pytest.approx(0.04, abs=0.03)
    assert sums[OffsetSums.ZZRF] / sums[OffsetSums.ZZFF] > 0.2


@pytest.mark.parametrize("bandwidth", [0.3, 2.0, *soaked(1.0)])
def test_noisy_wind_is_seldom_five_deviations(bandwidth: float) -> None:
    """Sums of white noise through a lag of any bandwidth [Hz] against a plan's swinging."""
    share, found = 2.0 * np.pi * bandwidth * T, []
    swinging = 0.3 * np.sin(6.0 * T * np.arange(400))
    for seed in range(60):
        memory, wind = new_memory(), np.zeros(2)
        noise = np.random.default_rng(seed).normal(0.0, 0.1, (400, 2))
        for planned, blow in zip(swinging, noise, strict=True):
            wind += share * (blow - wind)
            for axis in range(2):
                values = np.array([wind[axis], planned, planned])
                offset_sum(1.0, values, memory[OffsetMemory.SUMS])
        estimate = memory[OffsetMemory.ESTIMATE]
        offset_decide(parameters(), LENGTH, 0.0, memory[OffsetMemory.SUMS], estimate)
        found.append(estimate[OffsetEstimate.FOUND] / estimate[OffsetEstimate.DEVIATION])
    assert np.max(np.abs(found)) < 5.0
    assert np.std(found) < 2.0


def test_noise_at_rest_teaches_nothing() -> None:
    """The noise of the angles is in both sides of the equation, and alone means D = -l."""
    still = np.tile([0.0, 0.0, LENGTH, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], (3000, 1))
    _, memory = estimates(measured(still, noise=STEP / np.sqrt(12.0)), still)
    assert not memory[OffsetMemory.ESTIMATE].any() and not memory[OffsetMemory.SUMS].any()


def test_a_share_of_zero_turns_it_off() -> None:
    found, memory = estimates(measured(swing(push, 3.0, length=0.84), 0.04), planned()[:301], 0.0)
    assert not found.any() and not memory.any()


def test_the_filter_is_three_lags() -> None:
    """A ramp is late by three time constants; second derivatives are differences of the lags."""
    share, states = 0.5 * BANDWIDTH * T, np.zeros((4, 7))
    for i in range(400):
        signals = np.full(7, i * T)
        signals[1] = (i * T) ** 2
        offset_filter(i == 0, share, signals, states)
    late = 399 * T - np.arange(4) / BANDWIDTH
    assert states[:, 0] == pytest.approx(late, rel=1e-9)
    second = BANDWIDTH**2 * (states[1] - 2.0 * states[2] + states[3])
    assert second[:2] == pytest.approx([0.0, 2.0], abs=1e-6)


@campaign(10_000, 40_000)
def test_the_variances_are_those_of_filtered_white_noise(count: int) -> None:
    given, states = parameters(), np.zeros((4, 7))
    random, found = np.random.default_rng(3), []
    for i in range(count):
        angle, place = random.normal(0.0, np.sqrt(given[Tracking.ANGLE_VARIANCE : Tracking.DELAY]))
        signals = np.array([LENGTH * angle + place, angle, 0.0, 0.0, 0.0, 0.0, 0.0])
        offset_filter(i == 0, 0.5 * BANDWIDTH * T, signals, states)
        second = BANDWIDTH**2 * (states[1, :2] - 2.0 * states[2, :2] + states[3, :2])
        found.append([second[0] + GRAVITY * states[3, 1], second[1]])
    residual, factor = offset_noise(given, LENGTH)
    # of continuous noise, so without what is cut off above half the sampling frequency
    assert np.var(np.array(found), axis=0) == pytest.approx([residual, factor], rel=0.25)
    assert (np.var(np.array(found), axis=0) < [residual, factor]).all()
