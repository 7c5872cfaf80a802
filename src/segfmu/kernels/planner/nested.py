"""The pieces of a plateau ramp (ramp.py), one after the other.

A rise consists of the rise of the next derivative, a hold at its peak, and that rise run down. So
the pieces are the nodes of a binary tree in order: odd numbers are the smallest rises, in which the
derivative n + 1 is constant, and a number divisible by 2^j once holds j derivatives lower.
"""

from segfmu.kernels.planner.ramp import inner_rise
from segfmu.kernels.planner.records import Axis


def rise_pieces(boxes: int) -> int:
    """Number of polynomial pieces of a rise by `boxes` boxes."""
    count = 0
    for i in range(boxes):
        count = 2 * count + 1
    return count


def ramp_pieces(axis: 'float[:]') -> int:
    """Number of polynomial pieces of a ramp."""
    if axis[Axis.PLATEAU] == 0.0:
        return 1
    return rise_pieces(int(axis[Axis.SMOOTHNESS]) - 1)


def held_level(piece: int, boxes: int) -> 'tuple[int, float]':
    """Which derivative piece 1 .. of a rise by `boxes` boxes holds (0: its slope), and the sign."""
    level = boxes - 1
    rest = piece
    while rest % 2 == 0:
        level = level - 1
        rest = rest // 2
    # each descent of the derivatives below changes the sign
    sign = 1.0
    rest = rest // 2
    while rest > 0:
        if rest % 2 == 1:
            sign = -sign
        rest = rest // 2
    return level, sign


def held_peak(
    level: int, first: int, rise: float, peak: float, stretch: float, axis: 'float[:]'
) -> 'tuple[float, float, float]':
    """How long a rise holds the derivative `level` above it [s], its value, and the next rise.

    Of the derivative below, by `peak` within `rise`; first and stretch as in `piece_peak`.
    """
    inner = 0.0
    if level < int(axis[Axis.SMOOTHNESS]) - 2 - first:
        inner = inner_rise(rise, first + level, axis)
    return (rise - 2.0 * inner) * stretch, peak / ((rise - inner) * stretch), inner


def piece_peak(
    level: int, first: int, change: float, duration: float, basis: float, axis: 'float[:]'
) -> 'tuple[float, float]':
    """Duration of the pieces of a rise that hold a derivative (0: its slope) [s], and its value.

    It is a rise of the derivative 2 + first, 0 for a ramp. One that lasts longer than `basis` is
    the fastest one of that duration, stretched.
    """
    stretch = duration / basis
    rise = basis
    peak = change
    length = 0.0
    for i in range(level + 1):
        length, peak, rise = held_peak(i, first, rise, peak, stretch, axis)
    return length, peak
