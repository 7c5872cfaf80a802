"""A crane with hook and sling by Newton's laws in space: places of hook and load, two tensions.

Shares nothing with the product. The unknowns are the accelerations of hook, load and carriages in
space and the tensions of rope and sling; coordinates follow from the places, by geometry.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tests.crane.newton import direction


class Found(NamedTuple):
    """Second derivatives of the seven coordinates, drive forces, tension of the sling."""

    coordinates: np.ndarray
    force: np.ndarray
    tension: float


def direction_rate(angles, rates) -> np.ndarray:
    """Derivative of `direction` by time."""
    sx, cx, sy, cy = np.sin(angles[0]), np.cos(angles[0]), np.sin(angles[1]), np.cos(angles[1])
    x = np.array([cx, sx * sy, sx * cy])
    return x * rates[0] + np.array([0.0, -cx * cy, cx * sy]) * rates[1]


def forced(state, force, wind, masses) -> Found:
    """Under given forces of the drives."""
    e = direction(*state[3:5])
    rows = np.zeros((3, 11))
    # the rope pulls the carriages towards the hook
    rows[0, 6], rows[0, 9] = masses[0] + masses[1], -e[0]
    rows[1, 7], rows[1, 9] = masses[1], -e[1]
    rows[2, 9] = -1.0
    return _solved(state, wind, masses, rows, force)


def driven(state, carriage, wind, masses) -> Found:
    """With given accelerations of bridge, trolley and rope."""
    rows = np.zeros((3, 11))
    rows[:, 6:9] = np.eye(3)
    return _solved(state, wind, masses, rows, carriage)


def _solved(state, wind, masses, rows, given) -> Found:
    """Unknowns: hook (3), load (3), bridge, trolley, l'', tensions of rope and sling.

    The last three equations are rows (3, 11), with given right sides.
    """
    bridge, trolley, payload, gravity, hook, sling = masses
    length, rope_rate = state[2], state[9]
    e, u = direction(*state[3:5]), direction(*state[5:7])
    below = length * direction_rate(state[3:5], state[10:12]) + rope_rate * e
    lowest = sling * direction_rate(state[5:7], state[12:14])
    system, right = np.zeros((11, 11)), np.zeros(11)
    for i in range(3):
        system[i, i], system[i, 9], system[i, 10] = hook, e[i], -u[i]
        system[3 + i, 3 + i], system[3 + i, 10] = payload, u[i]
        right[3 + i] = wind[i]
    right[[2, 5]] -= gravity * hook, gravity * payload
    # the sling keeps its length, and the rope's second derivative is that of |hook - trolley|
    system[6, 3:6], system[6, :3], right[6] = u, -u, -(lowest @ lowest) / sling
    system[7, :3], system[7, 6:8], system[7, 8] = e, -e[:2], -1.0
    right[7] = -(below @ below - (below @ e) ** 2) / length
    system[8:], right[8:] = rows, given
    x = np.linalg.solve(system, right)
    rope = _angles(length * e, below, x[:3] - np.array([x[6], x[7], 0.0]))
    hanging = _angles(sling * u, lowest, x[3:6] - x[:3])
    force = np.array(
        [(bridge + trolley) * x[6] - x[9] * e[0], trolley * x[7] - x[9] * e[1], -x[9]]
    )
    return Found(np.array([x[6], x[7], x[8], *rope, *hanging]), force, x[10])


def _angles(place, velocity, acceleration) -> tuple[float, float]:
    """Second derivatives of atan2(x, r) and atan2(-y, -z), r the distance from the x-axis."""
    x, dx, ddx = place[0], velocity[0], acceleration[0]
    a, b = -place[1:]
    da, db = -velocity[1:]
    dda, ddb = -acceleration[1:]
    r = np.hypot(a, b)
    dr = (a * da + b * db) / r
    ddr = (da**2 + db**2 + a * dda + b * ddb - dr**2) / r
    square = x**2 + r**2
    rate_x, rate_y = (dx * r - x * dr) / square, (da * b - a * db) / r**2
    second_x = (ddx * r - x * ddr) / square - 2.0 * rate_x * (x * dx + r * dr) / square
    return second_x, (dda * b - a * ddb) / r**2 - 2.0 * rate_y * dr / r
