"""Buffers at the end stops: a spring and a damper side by side, which never pull.

`plant` is a `Plant`. Resistances are forces against the positive direction of an axis.
"""

from segfmu.kernels.crane.records import Plant


def compression(plant: 'float[:]', axis: int, position: float) -> float:
    """How far [m] an axis is beyond its end stops: negative at the lower one, 0 between them."""
    if position > plant[Plant.TRAVEL_MAX + axis]:
        return position - plant[Plant.TRAVEL_MAX + axis]
    return min(position - plant[Plant.TRAVEL_MIN + axis], 0.0)


def buffer_force(plant: 'float[:]', axis: int, position: float, velocity: float) -> float:
    """Resistance [N] of the buffer that an axis presses, if any."""
    if plant[Plant.STIFFNESS + axis] == 0.0:
        return 0.0
    pressed = compression(plant, axis, position)
    if pressed == 0.0:
        return 0.0
    force = plant[Plant.STIFFNESS + axis] * pressed + plant[Plant.DAMPING + axis] * velocity
    if force * pressed <= 0.0:
        return 0.0
    return force


def buffer_slopes(
    plant: 'float[:]', axis: int, position: float, velocity: float
) -> 'tuple[float, float]':
    """Derivatives of the resistance by position [N/m] and velocity [N s/m]."""
    if buffer_force(plant, axis, position, velocity) == 0.0:
        return 0.0, 0.0
    return plant[Plant.STIFFNESS + axis], plant[Plant.DAMPING + axis]
