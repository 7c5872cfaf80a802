"""Limits that come down to what they are, while a sequence keeps them (active_set.py).

From the sequence without the limits below the levels, Newton's method can lead astray where these
are exceeded by far. So they come down in steps where a single one fails.
"""

from segfmu.kernels.numerics.numbers import SMALL
from segfmu.kernels.planner.active_set import compares_levels, follow
from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.plateaus import keep_sequence
from segfmu.kernels.planner.records import Axis, Excess, Passing, PlanWork, Tighten
from segfmu.kernels.planner.sequence import sequence_duration

# Newton's steps that a sequence may take in all and each time that limits come down; with ramps
# that take much longer there is more to gain, also by less than a small part of an excess at once,
# and where levels are compared there is more to do
ALL = 150.0
EACH = 40.0
LONGER = 1.4
ALL_LONGER = 400.0
LEAST_LONGER = 0.02
EACH_COMPARED = 200.0


def loosen(share: float, axis: 'float[:]', work: 'float[:,:]') -> None:
    """Write the axis with limits that lie between those asked for (1) and what is taken (0)."""
    loose = work[PlanWork.LOOSE, :]
    for i in range(Axis.SIZE):
        loose[i] = axis[i]
    for order in range(1, int(work[PlanWork.PASSING, Passing.ABOVE]) + 2):
        i = Axis.VELOCITY + order - 1
        excess = work[PlanWork.TIGHTEN, Tighten.SHARE + order]
        factor = (1.0 + excess) ** (1.0 - share)
        loose[i] = axis[i] * factor
        if order <= 2:
            lower = Axis.LOWER + order - 1
            loose[lower] = axis[lower] * factor


def tighten(longest: float, problem: 'float[:]', axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Bring the limits of a solved sequence down to those of its axis, in as few steps as possible.

    It is that in the rows SOLVED of `work`. False if that fails, or takes `longest` [s] or more.
    """
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    steps = work[PlanWork.TIGHTEN, :]
    measure_excess(axis, work)
    for order in range(1, int(passing[Passing.ABOVE]) + 2):
        steps[Tighten.SHARE + order] = work[PlanWork.EXCESS + order, Excess.SHARE]
    # the ramps that it started from can take much longer
    passing[Passing.TIME] = sequence_duration(passing, nodes)
    keep_sequence(PlanWork.SOLVED, work)
    most, each, least = ALL, EACH, SMALL
    if longest > LONGER * passing[Passing.TIME]:
        most, least = ALL_LONGER, LEAST_LONGER
    if compares_levels(axis):
        most = most + ALL_LONGER
        each = EACH_COMPARED
    steps[Tighten.STEPS] = 0.0
    steps[Tighten.MOVING] = 0.0
    target = passing[Passing.TARGET]
    reached, step = 0.0, 1.0
    while step > least and steps[Tighten.STEPS] < most:
        steps[Tighten.MOST] = min(steps[Tighten.STEPS] + each, most)
        share = min(reached + step, 1.0)
        loosen(share, axis, work)
        if follow(target, problem, work[PlanWork.LOOSE, :], work):
            if sequence_duration(passing, nodes) >= longest:
                return False
            if share == 1.0:
                return True
            keep_sequence(PlanWork.SOLVED, work)
            reached = share
        else:
            step = 0.5 * step
    return False
