"""Partial derivatives of the rig between events, for kernels/rig/exchange.py's derivatives.

`partials` (12, 17): rows 0:5 accelerations of bridge, trolley, rope and both angles, 5:8 forces of
the drives, 8 force on the rope, 9 power of the drives, 10 of the wind, 11 of friction; columns
0:10 the state, 10:13 commands of the drives (forces or velocities), 13:16 forces on the load, 16
time. `memory` is that of kernels/rig/rig.py after `rig_rates` for the same time and setpoints.
"""

from math import cos, sin, tanh

from segfmu.kernels.crane._partials import (
    crane_driven_partials,
    crane_load_partials,
    crane_rhs_partials,
)
from segfmu.kernels.crane.drives import beyond, friction_force
from segfmu.kernels.numerics.noise import full_circle


def friction_slope(parameters: 'float[:]', axis: int, velocity: float) -> float:
    """Derivative of the friction force of an axis by its velocity."""
    slope = parameters[14 + axis]
    if parameters[17 + axis] > 0.0:
        share = tanh(velocity / parameters[20])
        slope = slope + parameters[17 + axis] * (1.0 - share * share) / parameters[20]
    return slope


def wind_slope(parameters: 'float[:]', components: 'float[:,:]', time: float, axis: int) -> float:
    """Time derivative of the wind's force on the load along an axis."""
    slope = 0.0
    if parameters[32] > 0.0:
        share = (time - parameters[31]) / parameters[32]
        if share > 0.0 and share < 1.0:
            # both shapes are sines of the share: their rate is the shape a quarter on
            angle = full_circle() * share
            if parameters[33] > 0.5:
                rate = 0.5 * full_circle() * cos(0.5 * angle)
            else:
                rate = 0.5 * full_circle() * cos(angle - 0.25 * full_circle())
            slope = rate / parameters[32] * parameters[34 + axis]
    for k in range(components.shape[0]):
        angle = components[k, 0] * time
        sines = components[k, 1 + axis] * cos(angle) - components[k, 4 + axis] * sin(angle)
        slope = slope + components[k, 0] * sines
    return slope


def forced_partials(
    parameters: 'float[:]', state: 'float[:]', rig: 'float[:,:]', work: 'float[:,:]',
    partials: 'float[:,:]',
) -> None:
    """Accelerations and forces under force commands; rig is the plant's work space."""
    crane_rhs_partials(
        state, rig[9, :], rig[11, :], parameters[0], parameters[1], parameters[2], parameters[3],
        work,
    )
    for i in range(5):
        for j in range(10):
            partials[i, j] = work[i, j]
        for j in range(3):
            slope = friction_slope(parameters, j, state[5 + j])
            partials[i, 5 + j] = partials[i, 5 + j] - slope * work[i, 10 + j]
            partials[i, 13 + j] = work[i, 15 + j]
            if rig[10, 3 + j] < 0.5:
                partials[i, 10 + j] = work[i, 10 + j]
        for j in range(2):
            partials[i, 8 + j] = partials[i, 8 + j] - parameters[21] * work[i, 13 + j]
    for j in range(3):
        if rig[10, 3 + j] < 0.5:
            partials[5 + j, 10 + j] = 1.0
    partials[8, 12] = partials[7, 12]
    partials[8, 7] = -friction_slope(parameters, 2, state[7])


def driven_partials(
    parameters: 'float[:]', state: 'float[:]', rig: 'float[:,:]', command: 'float[:]',
    work: 'float[:,:]', partials: 'float[:,:]',
) -> bool:
    """The same under velocity commands; false where a drive is at its largest force."""
    for i in range(3):
        demand = (command[i] - state[5 + i]) / parameters[5 + i]
        if rig[10, 3 + i] > 0.5 and not beyond(demand, parameters[11 + i]):
            return False
        if parameters[8 + i] > 0.0 and abs(rig[10, i]) >= parameters[8 + i] * (1.0 - 1e-9):
            return False
        if not beyond(demand, parameters[11 + i]):
            partials[i, 10 + i] = 1.0 / parameters[5 + i]
            partials[i, 5 + i] = -1.0 / parameters[5 + i]
    crane_driven_partials(
        state, rig[14, :], rig[9, :], rig[11, :], parameters[0], parameters[1], parameters[2],
        parameters[3], work,
    )
    for i in range(5):
        row = 3 + i
        for j in range(10):
            partials[row, j] = work[i, j]
        for j in range(3):
            # through the accelerations of the drives
            partials[row, 5 + j] = partials[row, 5 + j] + work[i, 10 + j] * partials[j, 5 + j]
            partials[row, 10 + j] = work[i, 10 + j] * partials[j, 10 + j]
            partials[row, 13 + j] = work[i, 15 + j]
        for j in range(2):
            partials[row, 8 + j] = partials[row, 8 + j] - parameters[21] * work[i, 13 + j]
    for j in range(17):
        partials[8, j] = partials[7, j]
    for i in range(3):
        slope = friction_slope(parameters, i, state[5 + i])
        partials[5 + i, 5 + i] = partials[5 + i, 5 + i] + slope
    return True


def power_partials(
    parameters: 'float[:]', state: 'float[:]', rig: 'float[:,:]', work: 'float[:,:]',
    partials: 'float[:,:]',
) -> None:
    """Powers of drives, wind and friction."""
    crane_load_partials(state, work)
    for j in range(10):
        for i in range(3):
            partials[10, j] = partials[10, j] + rig[11, i] * work[3 + i, j]
    for i in range(3):
        velocity = state[5 + i]
        for j in range(16):
            partials[9, j] = partials[9, j] + partials[5 + i, j] * velocity
        partials[9, 5 + i] = partials[9, 5 + i] + rig[10, i]
        # the load's velocity is linear in the rates
        for j in range(5):
            partials[10, 13 + i] = partials[10, 13 + i] + work[3 + i, 5 + j] * state[5 + j]
        slope = friction_slope(parameters, i, velocity)
        partials[11, 5 + i] = slope * velocity + friction_force(parameters, i, velocity)
    for i in range(2):
        partials[11, 8 + i] = 2.0 * parameters[21] * state[8 + i]


def rig_partials(
    components: 'float[:,:]', time: float, memory: 'float[:,:]', work: 'float[:,:]',
    partials: 'float[:,:]',
) -> bool:
    """All partial derivatives at a time [s] since the start; work is (6, 18).

    False where a velocity drive is at its largest force: there they jump with its neighbours'.
    """
    parameters = memory[1, :]
    state = memory[0, :]
    for i in range(12):
        for j in range(17):
            partials[i, j] = 0.0
    for i in range(6):
        for j in range(18):
            work[i, j] = 0.0
    rig = memory[14:30, :]
    if parameters[4] > 0.5:
        if not driven_partials(parameters, state, rig, memory[10, :], work, partials):
            return False
    else:
        forced_partials(parameters, state, rig, work, partials)
    power_partials(parameters, state, rig, work, partials)
    for i in range(12):
        for j in range(3):
            slope = wind_slope(parameters, components, memory[2, 0] + time, j)
            partials[i, 16] = partials[i, 16] + partials[i, 13 + j] * slope
            if parameters[4] > 0.5:
                # corrections are integrated into the velocities
                partials[i, 16] = partials[i, 16] + partials[i, 10 + j] * memory[8, j]
    return True
