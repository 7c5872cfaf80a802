"""Limits of velocity and acceleration by their direction, and the larger of both.

A motion mirrored, or reversed in time, has them exchanged. All limits here are magnitudes.
"""

from segfmu.kernels.planner.records import Axis, Lower


def side_limit(order: int, sign: float, axis: 'float[:]') -> float:
    """The limit of the derivative of an order, from 1 on, in the direction of a sign."""
    if order <= 2 and sign < 0.0:
        return axis[Axis.LOWER + order - 1]
    return axis[Axis.VELOCITY + order - 1]


def own_side(order: int, sign: float, axis: 'float[:]') -> float:
    """1 where that limit is one of the negative direction alone, else 0."""
    if sign < 0.0 and abs(side_limit(order, sign, axis) - side_limit(order, 1.0, axis)) > 0.0:
        return 1.0
    return 0.0


def set_lower(lower: 'float[:]', axis: 'float[:]') -> None:
    """Set the limits in the negative direction (Lower) of an axis whose other limits are set."""
    for i in range(Lower.SIZE):
        if lower[i] > 0.0:
            axis[Axis.LOWER + i] = lower[i]


def fastest_velocity(axis: 'float[:]') -> float:
    """The larger velocity limit [m/s]."""
    return max(axis[Axis.VELOCITY], axis[Axis.LOWER])


def slowest_velocity(axis: 'float[:]') -> float:
    """The smaller velocity limit [m/s]: a velocity within it is allowed in both directions."""
    return min(axis[Axis.VELOCITY], axis[Axis.LOWER])


def top_acceleration(axis: 'float[:]') -> float:
    """The larger acceleration limit [m/s2]."""
    return max(axis[Axis.ACCELERATION], axis[Axis.LOWER + 1])


def is_beyond(low: float, high: float, share: float, axis: 'float[:]') -> bool:
    """Whether velocities between two exceed a limit times `share`."""
    return low < -axis[Axis.LOWER] * share or high > axis[Axis.VELOCITY] * share


def exchange_sides(order: int, axis: 'float[:]') -> None:
    """Exchange the limits of velocity (1) or acceleration (2) in both directions."""
    kept = axis[Axis.VELOCITY + order - 1]
    axis[Axis.VELOCITY + order - 1] = axis[Axis.LOWER + order - 1]
    axis[Axis.LOWER + order - 1] = kept


def reverse_axis(axis: 'float[:]') -> None:
    """The limits of motions reversed in time, velocities kept: accelerations change their sign."""
    exchange_sides(2, axis)


def mirror_axis(axis: 'float[:]') -> None:
    """The limits of motions in the other direction."""
    exchange_sides(1, axis)
    exchange_sides(2, axis)
