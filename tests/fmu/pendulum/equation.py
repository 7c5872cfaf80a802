"""The pendulum's equation of motion, l phi'' + 2 l' phi' + g sin phi = -a cos phi."""

from __future__ import annotations

from math import cos, sin
from typing import Any


def rates(state: Any, inputs: Any, gravity: float) -> tuple[float, float]:
    """Derivatives of angle and rate; inputs are acceleration, rope length and velocity."""
    angle, rate = state
    acceleration, length, velocity = inputs
    pull = gravity * sin(angle) + acceleration * cos(angle) + 2.0 * velocity * rate
    return rate, -pull / length
