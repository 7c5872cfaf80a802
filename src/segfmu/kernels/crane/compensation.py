"""Feedforward compensation of what is known: drive lag and friction."""

from math import tanh


def compensate_setpoints(
    velocity: 'float[:]',
    acceleration: 'float[:]',
    lag: 'float[:]',
    viscous: 'float[:]',
    coulomb: 'float[:]',
    width: float,
    force: 'float[:]',
    setpoint: 'float[:]',
) -> None:
    """Velocity setpoints, and forces in place, of bridge, trolley and hoist (3 each).

    velocity and acceleration [m/s], [m/s2] are those that shall happen. A lag v' = (v* - v) / T
    follows v exactly under v* = v + T v'; friction viscous v + coulomb tanh(v / width) is added
    to the forces.
    """
    for i in range(3):
        setpoint[i] = velocity[i] + lag[i] * acceleration[i]
        force[i] = force[i] + viscous[i] * velocity[i] + coulomb[i] * tanh(velocity[i] / width)
