"""The crane by Newton's laws in space: rope tension as an unknown, no generalised coordinates.

Shares nothing with the product. Given the state, the load's acceleration is that of a mass under
rope, weight and wind; bridge and trolley feel the rope's reaction.
"""

from __future__ import annotations

from math import cos, sin

import numpy as np


def direction(phi_x: float, phi_y: float) -> np.ndarray:
    """Unit vector from the trolley to the load."""
    return np.array(
        [np.sin(phi_x), -np.cos(phi_x) * np.sin(phi_y), -np.cos(phi_x) * np.cos(phi_y)]
    )


def accelerations(state, force, wind, bridge, trolley, payload, gravity) -> np.ndarray:
    """Second derivatives of (x_t, y_t, l, phi_x, phi_y).

    In numbers of Python: tests integrate this by the hundred thousand, and arrays of three take
    ten times as long.
    """
    pull_x, pull_y, pull = map(float, force)
    along = sin(state[3]), -cos(state[3]) * sin(state[4])
    # the rope force acts on the load along the rope and on the trolley against it
    x = (pull_x - pull * along[0]) / (bridge + trolley)
    y = (pull_y - pull * along[1]) / trolley
    lifted, swung, turned = swings(state, x, y, wind, payload, gravity)
    return np.array([x, y, lifted + pull / payload, swung, turned])


def swings(state, x, y, wind, payload, gravity) -> tuple[float, float, float]:
    """Those of l, without the rope's force, of phi_x and of phi_y, under a trolley's (x, y).

    The rope's force is along the rope: no other second derivative of the load has a part of it.
    """
    _, _, length, phi_x, phi_y, _, _, rope_rate, rate_x, rate_y = map(float, state)
    sx, cx, sy, cy = sin(phi_x), cos(phi_x), sin(phi_y), cos(phi_y)
    # unit vectors along the rope and, across it, along growing phi_x and phi_y
    along, across, side = (sx, -cx * sy, -cx * cy), (cx, sx * sy, sx * cy), (0.0, -cy, sy)
    a, b, c = (
        float(blown) / payload - moved for blown, moved in zip(wind, (x, y, gravity), strict=True)
    )
    lifted, swung, turned = (a * e + b * f + c * g for e, f, g in (along, across, side))
    # of the position l e(phi_x, phi_y), with e_y = cx side: what its second derivative has without
    # the second derivatives of l, phi_x and phi_y, along these vectors
    lifted += length * (rate_x**2 + (cx * rate_y) ** 2)
    swung -= 2.0 * rope_rate * rate_x + length * sx * cx * rate_y**2
    turned -= 2.0 * rope_rate * cx * rate_y - 2.0 * length * sx * rate_x * rate_y
    return lifted, swung / length, turned / (length * cx)
