"""Corrections by the feedback with a hook, from the measured signals at a tick.

The sling is not measured: an observer of each axis has its angle, see kernels/hook/design.py.
"""

from segfmu.kernels.crane.records import Axes, State
from segfmu.kernels.hook.records import HookAxis, HookAxisTable, HookLimits, HookTable


def hook_row(length: float, table: 'float[:,:,:]') -> 'tuple[int, float]':
    """The row of a table before a rope length [m], and the share of the way to the next one."""
    last = table.shape[0] - 1
    row = 0
    while row < last - 1 and length >= table[row + 1, HookTable.LENGTH, 0]:
        row = row + 1
    if last == 0:
        return 0, 0.0
    begin = table[row, HookTable.LENGTH, 0]
    share = (length - begin) / (table[row + 1, HookTable.LENGTH, 0] - begin)
    return row, min(max(share, 0.0), 1.0)


def hook_entry(row: int, share: float, i: int, j: int, table: 'float[:,:,:]') -> float:
    """An entry between two rows of a table."""
    if share == 0.0:
        return table[row, i, j]
    return (1.0 - share) * table[row, i, j] + share * table[row + 1, i, j]


def hook_axis(
    axis: int, row: int, share: float, table: 'float[:,:,:]', seen: float, tilted: float,
    estimate: 'float[:]', work: 'float[:]',
) -> float:
    """What is wanted of the correction of an axis, from what position and angle differ by.

    estimate: `HookAxis` at the last tick, with the correction that acted since, and then at this
    one; work: the same.
    """
    first = HookTable.AXES + axis * HookAxisTable.SIZE
    for i in range(HookAxis.CORRECTION):
        work[i] = 0.0
        for j in range(HookAxis.SIZE):
            entry = hook_entry(row, share, first + HookAxisTable.TRANSITION + i, j, table)
            work[i] = work[i] + entry * estimate[j]
    position = seen - work[HookAxis.POSITION]
    angle = tilted - work[HookAxis.ANGLE]
    wanted = 0.0
    for i in range(HookAxis.CORRECTION):
        gain = hook_entry(row, share, first + HookAxisTable.POSITION_GAIN, i, table)
        estimate[i] = work[i] + gain * position
        gain = hook_entry(row, share, first + HookAxisTable.ANGLE_GAIN, i, table)
        estimate[i] = estimate[i] + gain * angle
        gain = hook_entry(row, share, first + HookAxisTable.GAINS, i, table)
        wanted = wanted - gain * estimate[i]
    return wanted


def hook_kept(
    axis: int, velocity: float, planned: float, wanted: float, limits: 'float[:]'
) -> float:
    """What of a wanted correction keeps the velocity of a drive in its bounds until the next tick.

    A drive beyond them is not turned back: that is the plan's matter.
    """
    period = limits[HookLimits.PERIOD]
    ahead = velocity + period * planned
    room = max(limits[HookLimits.FASTEST + axis] - ahead, 0.0)
    back = min(limits[HookLimits.SLOWEST + axis] - ahead, 0.0)
    return min(max(wanted, back / period), room / period)


def hook_correction(
    table: 'float[:,:,:]', limits: 'float[:]', measured: 'float[:]', reference: 'float[:]',
    feedforward: 'float[:]', estimates: 'float[:,:]', correction: 'float[:]',
) -> None:
    """Corrections of the three setpoints (Axes) at a tick.

    table: a `HookTable` a rope length, ascending; limits: `HookLimits`; measured: `Coordinates`;
    reference: `State`; feedforward: setpoints without correction; estimates: a `HookAxis` an axis,
    and work space behind them; correction: what acted since the last tick, and then the new one.
    """
    row, share = hook_row(measured[Axes.ROPE], table)
    for axis in range(Axes.SIZE):
        tilted = 0.0
        if axis != Axes.ROPE:
            sign = 1.0 - 2.0 * axis
            tilted = sign * (measured[Axes.SIZE + axis] - reference[Axes.SIZE + axis])
        estimate = estimates[axis, :]
        estimate[HookAxis.CORRECTION] = correction[axis]
        wanted = hook_axis(
            axis, row, share, table, measured[axis] - reference[axis], tilted, estimate,
            estimates[Axes.SIZE, :],
        )
        planned = feedforward[axis]
        least = limits[HookLimits.LEAST + axis]
        bounded = min(max(planned + wanted, least), limits[HookLimits.GREATEST + axis])
        velocity = reference[State.VELOCITY + axis] + estimate[HookAxis.VELOCITY]
        correction[axis] = hook_kept(axis, velocity, planned, bounded - planned, limits)
