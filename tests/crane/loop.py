"""A crane under a sampled controller, by Newton's laws: the loop that the controllers' tests close.

Shares nothing with the product but the controller that is tested: dynamics of newton.py, classical
Runge-Kutta steps, quantised and delayed signals.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tests.crane.newton import accelerations, swings

Signal = Callable[[float], np.ndarray]


def nothing(time: float) -> np.ndarray:
    return np.zeros(3)


@dataclass
class Rig:
    """The true crane: masses as `Crane.masses`, and what disturbs it."""

    masses: tuple[float, float, float, float]
    driven: bool = False
    lag: tuple[float, float, float] = (0.0, 0.0, 0.0)
    wind: Signal = nothing
    viscous: tuple[float, float, float] = (0.0, 0.0, 0.0)
    coulomb: tuple[float, float, float] = (0.0, 0.0, 0.0)
    resolution: tuple[float, ...] = (0.0,) * 5
    offset: tuple[float, ...] = (0.0,) * 5
    delayed: bool = False
    bound: float = np.inf
    substeps: int = 1

    def measure(self, state: np.ndarray) -> np.ndarray:
        steps, values = np.array(self.resolution), state[:5] + self.offset
        return np.where(steps > 0.0, np.round(values / np.where(steps, steps, 1.0)) * steps, values)

    def derivative(self, time: float, state: np.ndarray, drive: np.ndarray, rate: np.ndarray):
        """Of state (10) and velocity commands (3)."""
        wind, speed = self.wind(time), state[5:8]
        found = np.zeros(13)
        found[:5] = state[5:10]
        if self.driven:
            lag = np.array(self.lag)
            follow = (state[10:] - speed) / np.where(lag > 0.0, lag, 1.0)
            found[5:10] = self.prescribed(state, np.where(lag > 0.0, follow, rate), wind)
            found[10:] = rate
        else:
            friction = np.array(self.viscous) * speed
            friction += np.array(self.coulomb) * np.tanh(speed / 1e-3)
            force = np.clip(drive, -self.bound, self.bound) - friction
            found[5:10] = accelerations(state[:10], force, wind, *self.masses)
        return found

    def prescribed(self, state: np.ndarray, wanted: np.ndarray, wind: np.ndarray) -> np.ndarray:
        """Accelerations where those of bridge, trolley and rope are given; forces follow."""
        _, *swung = swings(state[:10], wanted[0], wanted[1], wind, *self.masses[2:])
        return np.array([*wanted, *swung])


def simulate(
    rig: Rig,
    controller,
    start: np.ndarray,
    duration: float,
    reference: Signal,
    feedforward: Signal = nothing,
    before: Callable[[int], None] = lambda tick: None,
) -> tuple[np.ndarray, np.ndarray]:
    """States (ticks + 1, 10) at the ticks, and corrections (ticks, 3).

    feedforward gives forces, or accelerations of bridge, trolley and rope if driven; `before` is
    called with the number of every tick.
    """
    period = controller.sample_time
    state = np.concatenate([start, start[5:8]])
    states, corrections, last = [state[:10]], [], rig.measure(state)
    for tick in range(round(duration / period)):
        time = tick * period
        before(tick)
        signals = rig.measure(state)
        measured = last if rig.delayed else signals
        last = signals
        given = feedforward(time)
        correction = controller.sample(time, measured, reference(time), given)
        corrections.append(correction)
        h = period / rig.substeps
        for i in range(rig.substeps):
            state = _step(rig, time + i * h, state, h, feedforward, correction)
        states.append(state[:10])
    return np.array(states), np.array(corrections)


def _step(rig: Rig, time: float, state, h: float, feedforward: Signal, correction):
    def slope(t: float, x: np.ndarray) -> np.ndarray:
        value = feedforward(t) + correction
        return rig.derivative(t, x, value, value)

    a = slope(time, state)
    b = slope(time + h / 2.0, state + h / 2.0 * a)
    c = slope(time + h / 2.0, state + h / 2.0 * b)
    d = slope(time + h, state + h * c)
    return state + h / 6.0 * (a + 2.0 * b + 2.0 * c + d)
