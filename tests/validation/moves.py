"""Small missions that the campaign's tests share."""

from __future__ import annotations

from segfmu.validation.files.mission import Mission

CRANE = {"bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0}


def mission(
    *points: tuple[float, float, float],
    velocity: float = 0.3,
    acceleration: float = 0.6,
    settle: float = 2.0,
    step: float = 0.002,
    **crane: float,
) -> Mission:
    """A mission through points at rest, the same limits on every axis."""
    limits = {"velocity": velocity, "acceleration": acceleration, "jerk": 4.0, "snap": 60.0}
    return Mission.model_validate(
        {
            "crane": {**CRANE, **crane},
            "limits": dict.fromkeys("xyz", limits),
            "waypoints": [{"position": list(point)} for point in points],
            "simulation": {"step": step, "settle": settle},
        }
    )


STRAIGHT = mission((0.0, 0.0, -0.5), (0.4, 0.0, -0.5))
DIAGONAL = mission((0.0, 0.0, -0.5), (0.3, 0.2, -0.4), rope_min=0.2, rope_max=0.8)
