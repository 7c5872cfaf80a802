"""One tick of the observer: deviations of the crane from its reference, out of measured ones.

estimate[axis] for bridge, trolley and hoist: position, sway angle, their rates, an unknown
acceleration of the carriage or rope, and an unknown acceleration of the load. The sway angle is
counted such that the load is at position + l * angle. The hoist has no angle and no load.

A table (rows, 18, 10) over rope length has for each axis six rows: the transition of the
estimate over a sample (6 columns), the effect of the velocity command and of the correction that
is held (2), and the gain from the innovation (2).
"""

from segfmu.kernels.control.feedback import table_row, table_share


def observer_predict(
    length: float,
    lengths: 'float[:]',
    table: 'float[:,:,:]',
    command: 'float[:]',
    held: 'float[:]',
    estimate: 'float[:,:]',
    scratch: 'float[:]',
) -> None:
    """Advance the estimate (3, 6 or more) by a sample under command and held correction."""
    row = table_row(length, lengths)
    share = table_share(length, lengths, row)
    following = min(row + 1, lengths.shape[0] - 1)
    for axis in range(3):
        for j in range(6):
            scratch[j] = estimate[axis, j]
        scratch[6] = command[axis]
        scratch[7] = held[axis]
        for i in range(6):
            k = 6 * axis + i
            total = 0.0
            for j in range(8):
                entry = (1.0 - share) * table[row, k, j] + share * table[following, k, j]
                total = total + entry * scratch[j]
            estimate[axis, i] = total


def observer_correct(
    length: float,
    lengths: 'float[:]',
    table: 'float[:,:,:]',
    measured: 'float[:]',
    reference: 'float[:]',
    estimate: 'float[:,:]',
) -> None:
    """Correct the estimate (3, 6 or more) by the five measured signals and their references."""
    row = table_row(length, lengths)
    share = table_share(length, lengths, row)
    following = min(row + 1, lengths.shape[0] - 1)
    for axis in range(3):
        first = measured[axis] - reference[axis] - estimate[axis, 0]
        second = 0.0
        if axis < 2:
            sign = 1.0 - 2.0 * axis
            second = sign * (measured[3 + axis] - reference[3 + axis]) - estimate[axis, 1]
        for i in range(6):
            k = 6 * axis + i
            a = (1.0 - share) * table[row, k, 8] + share * table[following, k, 8]
            b = (1.0 - share) * table[row, k, 9] + share * table[following, k, 9]
            estimate[axis, i] = estimate[axis, i] + a * first + b * second
