"""Random waypoints of three axes."""

from __future__ import annotations

import numpy as np

from segfmu import Waypoint


def route(random: np.random.Generator) -> list[Waypoint]:
    """Waypoints at rest, moving, free and with dwells."""
    points = []
    for place in np.cumsum(random.uniform(0.1, 0.6, (5, 3)), axis=0) - [0.0, 0.0, 4.0]:
        kind = random.integers(4)
        if kind == 0 or len(points) in (0, 4):
            points.append(Waypoint(place))
        elif kind == 1:
            points.append(Waypoint(place, random.uniform(0.0, 0.3, 3)))
        elif kind == 2:
            points.append(Waypoint(place, "free", "free"))
        else:
            points.append(Waypoint(place, dwell=random.uniform(0.1, 1.0)))
    return points
