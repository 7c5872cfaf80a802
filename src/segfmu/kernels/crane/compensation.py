"""Feedforward compensation of known drive lag and friction."""

from math import tanh

from segfmu.kernels.crane.records import Compensation


def compensate_setpoints(
    velocity: 'float[:]',
    acceleration: 'float[:]',
    known: 'float[:]',
    force: 'float[:]',
    setpoint: 'float[:]',
) -> None:
    """Velocity setpoints, and forces in place, of bridge, trolley and hoist (3 each).

    velocity and acceleration [m/s], [m/s2] are the planned ones; known: a `Compensation`. A drive
    with lag, v' = (v* - v) / T, follows v exactly if v* = v + T v'; friction viscous v + coulomb
    tanh(v / width) is added to the forces.
    """
    width = known[Compensation.FRICTION_WIDTH]
    for i in range(3):
        setpoint[i] = velocity[i] + known[Compensation.LAG + i] * acceleration[i]
        viscous = known[Compensation.VISCOUS + i] * velocity[i]
        coulomb = known[Compensation.COULOMB + i] * tanh(velocity[i] / width)
        force[i] = force[i] + viscous + coulomb
