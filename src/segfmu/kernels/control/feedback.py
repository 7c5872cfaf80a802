"""Evaluation of the gain-scheduled sway feedback, and the gains of the flatness-based one.

A table over rope length is a stack of blocks in ascending order of the rope length, their first
entry.
"""

from math import sqrt

from segfmu.kernels.control.records import GainInputs, Gains
from segfmu.kernels.crane.bounds import carriage_mass
from segfmu.kernels.crane.records import Axes, DriveMode, Plant, State


def table_row(length: float, table: 'float[:,:,:]') -> int:
    """Last block of a table at or below a rope length; 0 .. blocks - 2."""
    row = 0
    while row + 2 < table.shape[0] and length > table[row + 1, Gains.LENGTH, 0]:
        row = row + 1
    return row


def table_share(length: float, table: 'float[:,:,:]', row: int) -> float:
    """Weight of the block after `row` in a linear interpolation; constant outside the table."""
    if table.shape[0] < 2:
        return 0.0
    first = table[row, Gains.LENGTH, 0]
    return min(max((length - first) / (table[row + 1, Gains.LENGTH, 0] - first), 0.0), 1.0)


def feedback_correction(
    state: 'float[:]',
    reference: 'float[:]',
    added: 'float[:]',
    gains: 'float[:,:,:]',
    correction: 'float[:]',
) -> None:
    """-K(l) (x - x*), K interpolated linearly over rope length, constant outside the table.

    state and reference (10): a `State`; added (3): velocities that corrections have added to the
    setpoints of velocity drives [m/s]; gains (rows, 4, 11): a `Gains` a rope length; correction (3)
    [N] or [m/s2].
    """
    length = state[State.POSITION + Axes.ROPE]
    row = table_row(length, gains)
    share = table_share(length, gains, row)
    following = min(row + 1, gains.shape[0] - 1)
    for i in range(3):
        axis = Gains.AXES + i
        total = 0.0
        for j in range(State.SIZE):
            k = (1.0 - share) * gains[row, axis, j] + share * gains[following, axis, j]
            total = total + k * (state[j] - reference[j])
        k = (1.0 - share) * gains[row, axis, GainInputs.COMMAND]
        k = k + share * gains[following, axis, GainInputs.COMMAND]
        correction[i] = -(total + k * added[i])


def feedback_bandwidth(
    ratio: float, length: float, gravity: float, delay: float, largest: float
) -> float:
    """Bandwidth [rad/s]: `ratio` pendulum frequencies, at most `largest` [rad] over a delay [s]."""
    return min(ratio * sqrt(gravity / length), largest / delay)


def feedback_gains(
    plant: 'float[:]',
    length: float,
    bandwidth: float,
    pendulum: float,
    hoist_bandwidth: float,
    damping: float,
    gains: 'float[:,:]',
) -> None:
    """Gains (4, 11), a `Gains`, that place the poles of the flat output's error; closed form.

    plant: masses, drive mode and lags of a `Plant`. About the load hanging at rest, with the sign
    of the sway angle such that the load is at p = x_t + l phi: p'' = -g phi and p'''' = (g / l) (g
    phi + a) for the carriage's acceleration a. The error of p has the characteristic polynomial
    (s^2 + 2 D w s + w^2) (s^2 + 2 D w s + W^2), with the bandwidth w, the frequency W of the
    pendulum's poles [rad/s] and the damping D; that of the rope is s^2 + 2 D w s + w^2 with its own
    bandwidth. For velocity drives the corrections are accelerations, and each drive keeps the pole
    of its lag; otherwise they are forces, which also cancel the rope's pull on the carriage.
    """
    driven = int(plant[Plant.MODE]) == DriveMode.VELOCITY
    gravity = plant[Plant.GRAVITY]
    slope = 2.0 * damping * bandwidth
    square = bandwidth * bandwidth
    k0 = square * pendulum * pendulum
    k1 = slope * (square + pendulum * pendulum)
    k2 = square + pendulum * pendulum + slope * slope
    k3 = 2.0 * slope
    for i in range(Gains.SIZE):
        for j in range(GainInputs.SIZE):
            gains[i, j] = 0.0
    gains[Gains.LENGTH, 0] = length
    for i in range(2):
        axis = gains[Gains.AXES + i, :]
        sign = 1.0 - 2.0 * i
        scale = 1.0
        pull = 0.0
        if not driven:
            scale = carriage_mass(plant, i)
            pull = plant[Plant.PAYLOAD_MASS] * gravity
        ratio = length / gravity
        angle = scale * (ratio * length * k0 - length * k2 + gravity) + pull
        axis[State.POSITION + i] = scale * ratio * k0
        axis[State.ANGLE + i] = sign * angle
        axis[State.VELOCITY + i] = scale * ratio * k1
        axis[State.RATE + i] = sign * scale * (ratio * length * k1 - length * k3)
    weight = 1.0
    if not driven:
        weight = plant[Plant.PAYLOAD_MASS]
    hoist = gains[Gains.AXES + Axes.ROPE, :]
    hoist[State.POSITION + Axes.ROPE] = weight * hoist_bandwidth * hoist_bandwidth
    hoist[State.VELOCITY + Axes.ROPE] = weight * 2.0 * damping * hoist_bandwidth
    if driven:
        for i in range(Axes.SIZE):
            lead_gains(i, plant[Plant.LAG + i], length, gravity, gains[Gains.AXES + i, :])


def lead_gains(
    axis: int, lag: float, length: float, gravity: float, gains: 'float[:]'
) -> None:
    """Make gains for accelerations those of a drive with a lag [s], a row of `Gains`, in place.

    If the carriage is to have the acceleration a, the command's rate has to be a + T a'. With the
    command c and the velocity v, the present acceleration is (c - v) / T.
    """
    if lag <= 0.0:
        return
    position = gains[State.POSITION + axis]
    velocity = gains[State.VELOCITY + axis]
    # by the present acceleration
    direct = velocity
    if axis != Axes.ROPE:
        sign = 1.0 - 2.0 * axis
        angle = sign * gains[State.ANGLE + axis]
        rate = sign * gains[State.RATE + axis]
        direct = velocity - rate / length
        gains[State.ANGLE + axis] = sign * (angle - lag * rate * gravity / length)
        gains[State.RATE + axis] = sign * (rate + lag * angle)
    gains[State.VELOCITY + axis] = velocity + lag * position - direct
    gains[GainInputs.COMMAND] = direct
