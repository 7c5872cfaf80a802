"""One tick of the observer: estimates the crane's deviation from its reference from the signals.

estimate (3, 6 or more): one `Estimate` per axis. table (rows, 19, 10): one `Observer` per rope
length; for each axis it has one row per entry of the estimate, an `AxisTable`.
"""

from segfmu.kernels.control.feedback import table_row, table_share
from segfmu.kernels.control.records import AxisModel, AxisTable, Estimate, Observer
from segfmu.kernels.crane.records import Axes, Coordinates


def observer_predict(
    axis: int,
    length: float,
    table: 'float[:,:,:]',
    command: float,
    correction: float,
    estimate: 'float[:]',
    scratch: 'float[:]',
) -> None:
    """Advance the estimate of an axis by a sample under a velocity command and a correction."""
    row = table_row(length, table)
    share = table_share(length, table, row)
    following = min(row + 1, table.shape[0] - 1)
    for j in range(Estimate.SIZE):
        scratch[j] = estimate[j]
    scratch[AxisModel.COMMAND] = command
    scratch[AxisModel.CORRECTION] = correction
    for i in range(Estimate.SIZE):
        k = Observer.BRIDGE + Estimate.SIZE * axis + i
        total = 0.0
        for j in range(AxisModel.SIZE):
            entry = (1.0 - share) * table[row, k, j] + share * table[following, k, j]
            total = total + entry * scratch[j]
        estimate[i] = total


def observer_input(
    axis: int,
    length: float,
    table: 'float[:,:,:]',
    period: float,
    correction: float,
    change: 'float[:]',
) -> None:
    """What a correction, held over a sample, changes of an estimate and of the command."""
    row = table_row(length, table)
    share = table_share(length, table, row)
    following = min(row + 1, table.shape[0] - 1)
    for i in range(Estimate.SIZE):
        k = Observer.BRIDGE + Estimate.SIZE * axis + i
        entry = (1.0 - share) * table[row, k, AxisModel.CORRECTION]
        entry = entry + share * table[following, k, AxisModel.CORRECTION]
        change[i] = entry * correction
    change[AxisModel.COMMAND] = period * correction


def observer_bend(
    axis: int,
    length: float,
    table: 'float[:,:,:]',
    factor: float,
    change: 'float[:]',
    estimate: 'float[:]',
) -> None:
    """Add `factor` times how a change, of estimate and command, itself changes in a sample."""
    row = table_row(length, table)
    share = table_share(length, table, row)
    following = min(row + 1, table.shape[0] - 1)
    for i in range(Estimate.SIZE):
        k = Observer.BRIDGE + Estimate.SIZE * axis + i
        total = -change[i]
        for j in range(AxisModel.CORRECTION):
            entry = (1.0 - share) * table[row, k, j] + share * table[following, k, j]
            total = total + entry * change[j]
        estimate[i] = estimate[i] + factor * total


def observer_correct(
    length: float,
    table: 'float[:,:,:]',
    measured: 'float[:]',
    reference: 'float[:]',
    estimate: 'float[:,:]',
) -> None:
    """Correct the estimate by the five measured signals and their references."""
    row = table_row(length, table)
    share = table_share(length, table, row)
    following = min(row + 1, table.shape[0] - 1)
    for axis in range(3):
        first = measured[axis] - reference[axis] - estimate[axis, Estimate.POSITION]
        second = 0.0
        if axis != Axes.ROPE:
            sign = 1.0 - 2.0 * axis
            angle = Coordinates.ANGLE + axis
            deviation = sign * (measured[angle] - reference[angle])
            second = deviation - estimate[axis, Estimate.ANGLE]
        for i in range(Estimate.SIZE):
            k = Observer.BRIDGE + Estimate.SIZE * axis + i
            a = (1.0 - share) * table[row, k, AxisTable.POSITION_GAIN]
            a = a + share * table[following, k, AxisTable.POSITION_GAIN]
            b = (1.0 - share) * table[row, k, AxisTable.ANGLE_GAIN]
            b = b + share * table[following, k, AxisTable.ANGLE_GAIN]
            estimate[axis, i] = estimate[axis, i] + a * first + b * second
