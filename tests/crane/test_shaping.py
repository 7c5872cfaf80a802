"""Baselines: the trapezoid, the sway it leaves, and what shapers leave of that."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from segfmu import Crane, InputError
from segfmu.crane import Plant, Setpoints
from segfmu.crane.feedback import design
from segfmu.crane.shaping import Shaped, Trapezoid, zv, zvd

GRAVITY = 9.81
# rope [m], distance [m], velocity [m/s], acceleration [m/s2], residual sway [deg] as published
SWAY = [
    (0.5, 0.4, 0.3, 0.6, 2.363), (0.7, 0.4, 0.3, 0.6, 6.791),
    (0.5, 1.0, 1.0, 1.0, 14.914), (0.7, 1.0, 1.0, 1.0, 21.295),
]


def residual(motion, length: float) -> float:
    """Amplitude of the sway after a motion [deg]: a pendulum with a moved pivot, by SciPy."""

    def slope(t: float, state: np.ndarray, acceleration: float) -> list[float]:
        angle, rate = state
        return [rate, -(GRAVITY * np.sin(angle) + acceleration * np.cos(angle)) / length]

    times = np.append(np.arange(0.0, motion.duration, 1e-3), motion.duration)
    jumps = times[:-1][np.diff(motion(times[:-1], 2), prepend=np.inf) != 0.0]
    edges = np.unique(np.append(jumps, motion.duration))
    state = np.zeros(2)
    for start, end in pairwise(edges):
        acceleration = float(motion(0.5 * (start + end), 2))
        state = solve_ivp(
            slope, (start, end), state, args=(acceleration,), rtol=1e-10, atol=1e-12
        ).y[:, -1]
    energy = 0.5 * (length * state[1]) ** 2 + GRAVITY * length * (1.0 - np.cos(state[0]))
    return float(np.degrees(np.arccos(1.0 - energy / (GRAVITY * length))))


@pytest.mark.parametrize(("length", "distance", "velocity", "acceleration", "expected"), SWAY)
def test_residual_sway_of_the_trapezoid(
    length: float, distance: float, velocity: float, acceleration: float, expected: float
) -> None:
    motion = Trapezoid(distance, velocity, acceleration)
    # the edges of the acceleration are found to 1 ms
    assert residual(motion, length) == pytest.approx(expected, rel=0.01)
    plant, largest = swaying(motion, length), 0.0
    for _ in range(2000):
        plant.step(1e-3, Setpoints(velocity=np.zeros(3)))
        largest = max(largest, abs(float(plant.state[3])))
    assert np.degrees(largest) == pytest.approx(expected, rel=0.01)


def swaying(motion, length: float) -> Plant:
    """A crane with ideal velocity drives after a motion of its bridge."""
    crane = Crane(2.2, 1.155, 1.0)
    feedback = design(crane, sample_time=1.0, shortest=0.3, longest=1.0, rows=2)
    plant = Plant(
        crane, crane.hanging([0.0, 0.0, -length]), Setpoints(), feedback, driven=True,
        enabled=False,
    )
    steps = int(np.ceil(motion.duration / 1e-3))
    for i in range(1, steps + 1):
        velocity = np.array([float(motion(i * 1e-3, 1)), 0.0, 0.0])
        plant.step(1e-3, Setpoints(velocity=velocity))
    return plant


@pytest.mark.parametrize(("length", "acceleration"), [(0.5, 0.01), (0.7, 0.02), (0.3, 0.005)])
def test_small_sway_is_the_closed_form(length: float, acceleration: float) -> None:
    """(4 a / g) |sin(w t_a / 2) sin(w (t_a + t_c) / 2)|."""
    motion, frequency = Trapezoid(0.4, 0.1, acceleration), np.sqrt(GRAVITY / length)
    product = np.sin(0.5 * frequency * motion.ramp)
    product *= np.sin(0.5 * frequency * (motion.ramp + motion.cruise))
    expected = np.degrees(4.0 * acceleration / GRAVITY * abs(product))
    assert residual(motion, length) == pytest.approx(expected, abs=2e-3 * acceleration)


@pytest.mark.parametrize("distance", [1.0, -0.2, 0.02, 0.0])
def test_the_trapezoid_is_a_motion_within_its_limits(distance: float) -> None:
    motion = Trapezoid(distance, 0.3, 0.6, start=0.5)
    times = np.linspace(-0.1, motion.duration + 0.1, 20001)
    position, velocity, acceleration = (motion(times, d) for d in range(3))
    assert position[0] == 0.5
    assert position[-1] == pytest.approx(0.5 + distance, abs=1e-12)
    assert np.abs(velocity).max(initial=0.0) <= 0.3 + 1e-12
    assert np.abs(acceleration).max() <= 0.6 + 1e-12
    step = times[1] - times[0]
    assert np.gradient(position, times) == pytest.approx(velocity, abs=step)
    moved = np.cumsum(0.5 * (acceleration[1:] + acceleration[:-1])) * step
    assert moved == pytest.approx(velocity[1:], abs=5.0 * step)
    assert velocity[-1] == pytest.approx(0.0, abs=1e-15)
    assert not acceleration[-1]


def test_long_after_its_end_a_trapezoid_rests_in_its_place() -> None:
    motion = Trapezoid(1.0, 0.3, 0.7, start=0.5)
    assert float(motion(motion.duration, 0)) == pytest.approx(1.5, abs=1e-15)
    assert motion([10.0, 1e6], 0).tolist() == [float(motion(motion.duration, 0))] * 2
    assert motion([10.0, 1e6], 1).tolist() == [float(motion(motion.duration, 1))] * 2


def test_the_trapezoid_takes_the_least_time() -> None:
    assert Trapezoid(1.0, 0.5, 1.0).duration == pytest.approx(2.0 + 0.5)
    assert Trapezoid(0.04, 0.5, 1.0).duration == pytest.approx(0.4)


@pytest.mark.parametrize("damping", [0.0, 0.1])
@pytest.mark.parametrize("shaper", [zv, zvd])
def test_a_shaper_leaves_no_vibration_at_its_frequency(shaper, damping: float) -> None:
    frequency, found = 4.0, shaper(4.0, damping)
    assert found.shares.sum() == pytest.approx(1.0)
    rest = residual_step(found, frequency, damping)
    assert rest < 1e-9
    slope = residual_step(found, 1.001 * frequency, damping) / 1e-3
    assert (slope < 0.01) == (shaper is zvd)
    assert found.residual(frequency, damping) < 1e-12


def residual_step(shaper, frequency: float, damping: float) -> float:
    """Amplitude that an oscillator at rest keeps after the shaper's steps, in closed form."""
    root = np.sqrt(1.0 - damping**2)
    pole = frequency * (-damping + 1j * root)
    total = sum(
        share * np.exp(pole * (shaper.times[-1] - at))
        for at, share in zip(shaper.times, shaper.shares, strict=True)
    )
    return float(abs(total))


@pytest.mark.parametrize("actual", [3.0, 3.7, 4.5])
def test_the_residual_is_that_of_an_oscillator(actual: float) -> None:
    for shaper in (zv(4.0), zvd(4.0)):
        assert shaper.residual(actual) == pytest.approx(residual_step(shaper, actual, 0.0))


@pytest.mark.parametrize(("length", "distance", "velocity", "acceleration", "unshaped"), SWAY)
def test_shaped_moves_leave_little_sway(
    length: float, distance: float, velocity: float, acceleration: float, unshaped: float
) -> None:
    frequency, motion = np.sqrt(GRAVITY / length), Trapezoid(distance, velocity, acceleration)
    shaped = Shaped(motion, zv(frequency))
    assert shaped.duration == pytest.approx(motion.duration + np.pi / frequency)
    assert shaped(shaped.duration) == pytest.approx(distance)
    # what is left are the nonlinearity of the pendulum and edges found to 1 ms
    assert residual(shaped, length) < 0.1 * unshaped
    wrong = 1.1 * length
    assert residual(Shaped(motion, zvd(frequency)), wrong) < residual(shaped, wrong)


def test_bad_values_are_refused() -> None:
    for arguments in ((np.nan, 1.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, -1.0)):
        with pytest.raises(InputError):
            Trapezoid(*arguments)
    with pytest.raises(InputError, match="derivative"):
        Trapezoid(1.0, 1.0, 1.0)(0.0, 3)
    with pytest.raises(InputError, match="damping"):
        zv(1.0, 1.0)
    with pytest.raises(InputError, match="frequency"):
        zvd(0.0)


def test_two_shapers_leave_nothing_at_both_frequencies() -> None:
    both = zv(1.0).then(zvd(9.2))
    assert both.times.size == both.shares.size == 6
    assert (np.diff(both.times) >= 0.0).all()
    assert both.shares.sum() == pytest.approx(1.0, rel=1e-14)
    assert both.times[-1] == pytest.approx(zv(1.0).times[-1] + zvd(9.2).times[-1], rel=1e-14)
    for frequency in (1.0, 9.2):
        assert both.residual(frequency) == pytest.approx(0.0, abs=1e-14)
    # between them, the product of both
    assert both.residual(4.0) == pytest.approx(zv(1.0).residual(4.0) * zvd(9.2).residual(4.0))
