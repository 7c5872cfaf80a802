"""Evaluation of the gain-scheduled sway feedback, and the gains of the flatness-based one."""

from math import sqrt


def table_row(value: float, nodes: 'float[:]') -> int:
    """Row of an ascending table before which or at which a value lies; 0 .. rows - 2."""
    row = 0
    while row + 2 < nodes.shape[0] and value > nodes[row + 1]:
        row = row + 1
    return row


def table_share(value: float, nodes: 'float[:]', row: int) -> float:
    """Weight of the row after `row` in a linear interpolation; constant outside the table."""
    if nodes.shape[0] < 2:
        return 0.0
    return min(max((value - nodes[row]) / (nodes[row + 1] - nodes[row]), 0.0), 1.0)


def feedback_correction(
    state: 'float[:]',
    reference: 'float[:]',
    lengths: 'float[:]',
    gains: 'float[:,:,:]',
    correction: 'float[:]',
) -> None:
    """-K(l) (x - x*), K interpolated linearly over rope length, constant outside the table.

    state and reference hold 10 numbers, lengths (rows,), gains (rows, 3, 10), correction 3.
    """
    row = table_row(state[2], lengths)
    share = table_share(state[2], lengths, row)
    following = min(row + 1, lengths.shape[0] - 1)
    for i in range(3):
        total = 0.0
        for j in range(10):
            k = (1.0 - share) * gains[row, i, j] + share * gains[following, i, j]
            total = total + k * (state[j] - reference[j])
        correction[i] = -total


def feedback_bandwidth(
    ratio: float, length: float, gravity: float, delay: float, largest: float
) -> float:
    """Bandwidth [rad/s]: `ratio` pendulum frequencies, at most `largest` radians in a delay [s]."""
    return min(ratio * sqrt(gravity / length), largest / delay)


def feedback_gains(
    driven: bool,
    length: float,
    bridge_mass: float,
    trolley_mass: float,
    payload_mass: float,
    gravity: float,
    bandwidth: float,
    hoist_bandwidth: float,
    damping: float,
    gains: 'float[:,:]',
) -> None:
    """Gains (3, 10) that give the flat output's error chosen poles; closed form.

    About the load hanging at rest, with the sway angle counted such that the load is at
    p = x_t + l phi: p'' = -g phi and p'''' = (g / l) (g phi + a) under the carriage's
    acceleration a. The error of p is given the characteristic polynomial
    (s^2 + 2 D w s + w^2)^2, that of the rope s^2 + 2 D w s + w^2, each with its bandwidth w
    [rad/s], and the damping D. The corrections are accelerations if driven; otherwise forces, which
    also cancel the rope's pull on the carriage.
    """
    k0 = bandwidth * bandwidth * bandwidth * bandwidth
    k1 = 4.0 * damping * bandwidth * bandwidth * bandwidth
    k2 = (2.0 + 4.0 * damping * damping) * bandwidth * bandwidth
    k3 = 4.0 * damping * bandwidth
    for i in range(3):
        for j in range(10):
            gains[i, j] = 0.0
    for i in range(2):
        sign = 1.0 - 2.0 * i
        scale = 1.0
        pull = 0.0
        if not driven:
            scale = trolley_mass
            if i == 0:
                scale = bridge_mass + trolley_mass
            pull = payload_mass * gravity
        ratio = length / gravity
        gains[i, i] = scale * ratio * k0
        gains[i, 3 + i] = sign * (scale * (ratio * length * k0 - length * k2 + gravity) + pull)
        gains[i, 5 + i] = scale * ratio * k1
        gains[i, 8 + i] = sign * scale * (ratio * length * k1 - length * k3)
    weight = 1.0
    if not driven:
        weight = payload_mass
    gains[2, 2] = weight * hoist_bandwidth * hoist_bandwidth
    gains[2, 7] = weight * 2.0 * damping * hoist_bandwidth
