"""How fast a motion may be so that it just keeps the bounds of the drives.

The i-th derivatives of all limits and waypoints times pace^i are the same motion in time / pace.
Its demands fall with the pace, but for what holds the load and for Coulomb friction.
"""

from math import exp, log

from segfmu.kernels.limits.records import Pace
from segfmu.kernels.numerics.numbers import NEVER

# trials at most; where the bounds are kept up to a pace at which no plan is found any more, halving
# ends where the two are as near as this: further on rounding would decide
MOST_TRIALS = 40.0
NEAR = 1.0000001


def begin_pace(most: float, full: float, pace: 'float[:]') -> None:
    """Begin a search (Pace) at the motion as it is given, for paces up to `most`.

    It ends where the largest use of a bound is between `full` and 1, or jumps.
    """
    pace[Pace.PACE] = 1.0
    pace[Pace.MOST] = most
    pace[Pace.FULL] = full
    pace[Pace.KEEPS] = 0.0
    pace[Pace.EXCEEDS] = NEVER
    pace[Pace.KEPT_USE] = 0.0
    pace[Pace.EXCEEDED_USE] = NEVER
    pace[Pace.LAST] = 0.0
    pace[Pace.LAST_USE] = 0.0
    pace[Pace.TRIALS] = 0.0


def next_pace(use: float, pace: 'float[:]') -> bool:
    """Whether another pace has to be tried, `pace[Pace.PACE]`, after the largest use at the last.

    The last one that is tried is the result: it keeps the bounds, or no pace does. A use of NEVER
    stands for a motion that cannot be planned.
    """
    tried = pace[Pace.PACE]
    if use <= 1.0 + 1e-9:
        pace[Pace.KEEPS] = tried
        pace[Pace.KEPT_USE] = use
        if tried >= pace[Pace.MOST] or use >= pace[Pace.FULL] or pace[Pace.TRIALS] >= MOST_TRIALS:
            return False
    else:
        pace[Pace.EXCEEDS] = tried
        pace[Pace.EXCEEDED_USE] = use
        if tried <= 1e-3:
            return False
    pace[Pace.PACE] = pace_between(use, pace)
    pace[Pace.LAST] = tried
    pace[Pace.LAST_USE] = use
    pace[Pace.TRIALS] = pace[Pace.TRIALS] + 1.0
    if pace[Pace.EXCEEDS] <= NEAR * pace[Pace.KEEPS]:
        pace[Pace.TRIALS] = MOST_TRIALS
    if pace[Pace.TRIALS] >= MOST_TRIALS:
        pace[Pace.PACE] = pace[Pace.KEEPS]
    return pace[Pace.PACE] > 0.0


def pace_between(use: float, pace: 'float[:]') -> float:
    """The pace at which the use would reach the bounds by a power of the pace.

    The power between a pace that keeps the bounds and one that exceeds them, else that seen last.
    Where that is no pace between the two, and each third time so that the search ends, the middle.
    """
    tried = pace[Pace.PACE]
    lower = max(pace[Pace.KEEPS], 1e-3)
    upper = min(pace[Pace.EXCEEDS], pace[Pace.MOST])
    aim = 0.5 * (1.0 + pace[Pace.FULL])
    if pace[Pace.KEEPS] > 0.0 and pace[Pace.EXCEEDS] < NEVER:
        share = 0.5
        known = pace[Pace.KEPT_USE] > 0.0 and pace[Pace.EXCEEDED_USE] < NEVER
        if known and int(pace[Pace.TRIALS]) % 3 != 2:
            rise = log(pace[Pace.EXCEEDED_USE] / pace[Pace.KEPT_USE])
            share = min(max(log(aim / pace[Pace.KEPT_USE]) / rise, 0.001), 0.999)
        return lower * exp(share * log(upper / lower))
    if use >= NEVER:
        return max(0.5 * tried, lower)
    # most demands grow with the square of the pace
    growth = 2.0
    if 0.0 < pace[Pace.LAST_USE] < NEVER and use > 0.0:
        growth = log(pace[Pace.LAST_USE] / use) / log(pace[Pace.LAST] / tried)
        growth = min(max(growth, 0.5), 4.0)
    found = tried * exp(log(aim / min(max(use, 0.01), 1e6)) / growth)
    if pace[Pace.KEEPS] == 0.0 and pace[Pace.TRIALS] > 2.5:
        # what no pace reduces leaves little to the rest
        found = min(found, 0.5 * tried)
    return min(max(found, lower), upper)
