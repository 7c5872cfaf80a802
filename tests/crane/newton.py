"""The crane by Newton's laws in space: rope tension as an unknown, no generalised coordinates.

Shares nothing with the product. Given the state, the load's acceleration is that of a mass under
rope, weight and wind; bridge and trolley feel the rope's reaction.
"""

from __future__ import annotations

import numpy as np


def direction(phi_x: float, phi_y: float) -> np.ndarray:
    """Unit vector from the trolley to the load."""
    return np.array(
        [np.sin(phi_x), -np.cos(phi_x) * np.sin(phi_y), -np.cos(phi_x) * np.cos(phi_y)]
    )


def accelerations(state, force, wind, bridge, trolley, payload, gravity) -> np.ndarray:
    """Second derivatives of (x_t, y_t, l, phi_x, phi_y)."""
    _, _, length, phi_x, phi_y, _, _, rope_rate, rate_x, rate_y = state
    e = direction(phi_x, phi_y)
    # the rope force acts on the load along e and on the trolley against it
    rope = force[2] * e
    load = (rope + np.asarray(wind)) / payload + np.array([0.0, 0.0, -gravity])
    x = (force[0] - rope[0]) / (bridge + trolley)
    y = (force[1] - rope[1]) / trolley
    relative = load - np.array([x, y, 0.0])
    # relative = l'' e + 2 l' e' + l e''; along and across e
    sx, cx, sy, cy = np.sin(phi_x), np.cos(phi_x), np.sin(phi_y), np.cos(phi_y)
    ex = np.array([cx, sx * sy, sx * cy])
    ey = np.array([0.0, -cx * cy, cx * sy])
    exx, exy, eyy = -e, np.array([0.0, sx * cy, -sx * sy]), np.array([0.0, cx * sy, cx * cy])
    rate = ex * rate_x + ey * rate_y
    centripetal = exx * rate_x**2 + 2.0 * exy * rate_x * rate_y + eyy * rate_y**2
    rest = relative - 2.0 * rope_rate * rate - length * centripetal
    basis = np.column_stack([e, length * ex, length * ey])
    return np.array([x, y, *np.linalg.solve(basis, rest)])
