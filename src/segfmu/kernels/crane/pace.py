"""How fast a motion may be so that it just keeps the bounds of the drives.

The i-th derivatives of all limits and waypoints times pace^i are the same motion in time / pace.
Its demands fall with the pace, but for what holds the load and for Coulomb friction.
"""

from math import exp, log, sqrt

from segfmu.kernels.crane.records import Pace


def begin_pace(pace: 'float[:]') -> None:
    """Begin a search (Pace) at the motion as it is given, which is never made faster."""
    pace[Pace.PACE] = 1.0
    pace[Pace.KEEPS] = 0.0
    pace[Pace.EXCEEDS] = 1.0
    pace[Pace.KEPT_USE] = 0.0
    pace[Pace.EXCEEDED_USE] = 0.0
    pace[Pace.TRIALS] = 0.0


def next_pace(use: float, pace: 'float[:]') -> bool:
    """Whether another pace has to be tried, `pace[Pace.PACE]`, after the largest use at the last.

    The last one that is tried is the result: it keeps the bounds, or no pace does.
    """
    last = pace[Pace.PACE]
    if use <= 1.0 + 1e-9:
        pace[Pace.KEEPS] = last
        pace[Pace.KEPT_USE] = use
        if last >= 1.0 or use >= 1.0 - 1e-6 or pace[Pace.TRIALS] >= 40.0:
            return False
    else:
        pace[Pace.EXCEEDS] = last
        pace[Pace.EXCEEDED_USE] = use
        if last <= 1e-3:
            return False
    pace[Pace.TRIALS] = pace[Pace.TRIALS] + 1.0
    pace[Pace.PACE] = pace_between(pace)
    if pace[Pace.TRIALS] >= 40.0:
        pace[Pace.PACE] = pace[Pace.KEEPS]
    return pace[Pace.PACE] > 0.0


def pace_between(pace: 'float[:]') -> float:
    """A pace between one that keeps the bounds, if one is known, and one that exceeds them.

    Where the use would reach the bounds by a power of the pace; the middle where that is no better.
    """
    lower = pace[Pace.KEEPS]
    upper = pace[Pace.EXCEEDS]
    aim = 1.0 - 5e-7
    if lower <= 0.0:
        # most demands grow with the square of the pace; where others matter, halves are soon slow
        slower = min(sqrt(aim / pace[Pace.EXCEEDED_USE]), 0.999)
        if pace[Pace.TRIALS] > 2.5:
            slower = 0.5
        return max(slower * upper, 1e-3)
    share = 0.5
    rise = pace[Pace.EXCEEDED_USE] / pace[Pace.KEPT_USE]
    if int(pace[Pace.TRIALS]) % 3 > 0:
        share = log(aim / pace[Pace.KEPT_USE]) / log(rise)
    share = min(max(share, 0.001), 0.999)
    return lower * exp(share * log(upper / lower))
