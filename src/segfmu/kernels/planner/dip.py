"""A dip: an acceleration goes past zero and comes back without all that ramps bring to zero.

A ramp of the acceleration past zero reaches its steepest point in its middle. Beside a limit of the
pop the snap is zero there, so the acceleration crosses zero late. In a dip it passes its lowest
value, where the jerk is zero, with a snap: two levels of the jerk, of which the second one has the
other sign, or three of the snap. The limit of the acceleration leaves room for a steeper crossing.

The first level determines the others, because jerk and acceleration are zero at the end. The dips
begin with the ramp to zero, whose last level is zero; the more time the first level takes, the less
velocity is gained, and the lower the acceleration falls.
"""

from segfmu.kernels.numerics.numbers import EQUAL, FINE, HALVINGS, NEVER
from segfmu.kernels.numerics.roots import next_bracket, next_point
from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.parameters import ramps_suffice
from segfmu.kernels.planner.phases import append_phase, boundary_value, mirror_phases
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Axis, Dip, Excess, Node, Passing, PlanWork
from segfmu.kernels.planner.sequence import advance, pass_node, sequence_duration, set_level
from segfmu.kernels.planner.sides import mirror_axis, side_limit

# how accurately the deepest dip is found, as a share of it
DEEPEST = 0.01
# velocity that a motion gains at least while it brings an acceleration to zero, as a share of the
# acceleration times the duration of one ramp: that gains 0.5, and every motion 0.4, with a limit of
# the pop alone
LEAST_GAIN = 0.37
# the least dip begins at this share of that duration
LEAST = 0.02


def begin_dip(above: int, v: float, a: float, work: 'float[:,:]') -> None:
    """Set a sequence (sequence.py) of levels of the derivative 2 + above, from the state (v, a)."""
    passing = work[PlanWork.PASSING, :]
    passing[Passing.COUNT] = above + 1
    passing[Passing.ABOVE] = above
    passing[Passing.PACE] = 1.0
    passing[Passing.START] = 0.0
    sign = -1.0
    for i in range(above + 2):
        work[PlanWork.NODES + i, :] = 0.0
        work[PlanWork.NODES + i, Node.SIGN] = sign
        sign = -sign
    work[PlanWork.NODES, Node.STATE + 1] = v
    work[PlanWork.NODES, Node.STATE + 2] = a


def follow_dip(order: int, axis: 'float[:]', work: 'float[:,:]') -> float:
    """Follow a dip from level to level; the derivative of an order at its end."""
    passing, nodes = work[PlanWork.PASSING, :], work[PlanWork.NODES:PlanWork.KEPT, :]
    above = int(passing[Passing.ABOVE])
    for i in range(above + 2):
        if i <= above:
            set_level(nodes[i, :], passing, axis)
        pass_node(i, passing, axis, nodes)
        if nodes[i, Node.HOLD] > 0.0:
            hold = nodes[i, Node.HOLD]
            advance(hold, nodes[i, Node.LEVEL], 0.0, 0.0, 0.0, above, nodes[i + 1, :])
    return nodes[above + 2, Node.STATE + order]


def last_jerk(second: float, axis: 'float[:]', work: 'float[:,:]') -> float:
    """The jerk at the end of a dip of three levels, of which the second one takes `second` [s]."""
    work[PlanWork.NODES + 1, Node.TIME] = second
    return follow_dip(3, axis, work)


def balance_jerk(axis: 'float[:]', work: 'float[:,:]') -> None:
    """Set the second of three levels so that the jerk ends at zero."""
    newest = work[PlanWork.NODES, Node.TIME]
    e_newest = last_jerk(newest, axis, work)
    if e_newest >= 0.0:
        # without a last level, up to rounding
        return
    other = 2.0 * newest
    e_other = last_jerk(other, axis, work)
    for i in range(HALVINGS):
        if e_other >= 0.0:
            break
        newest = other
        e_newest = e_other
        other = 2.0 * other
        e_other = last_jerk(other, axis, work)
    before = other
    e_before = e_other
    for i in range(HALVINGS):
        second = next_point(newest, other, before, e_newest, e_other, e_before)
        if second == newest or second == other or e_newest == 0.0:
            break
        error = last_jerk(second, axis, work)
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            error * e_newest <= 0.0, second, error, newest, other, e_newest, e_other
        )
    work[PlanWork.NODES + 1, Node.TIME] = newest


def last_excess(time: float, end: float, axis: 'float[:]', work: 'float[:,:]') -> float:
    """The acceleration at the end of a dip whose last level takes `time` [s], less `end`."""
    above = int(work[PlanWork.PASSING, Passing.ABOVE])
    work[PlanWork.NODES + above, Node.TIME] = time
    if above == 2:
        balance_jerk(axis, work)
    return follow_dip(2, axis, work) - end


def close_dip(first: float, end: float, axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Set the dip to the acceleration `end` <= 0 whose first level takes the time `first` [s].

    False: that is less than a ramp takes.
    """
    work[PlanWork.NODES, Node.TIME] = first
    newest = 0.0
    e_newest = last_excess(newest, end, axis, work)
    if e_newest > 0.0:
        return False
    # as long a last level leaves the acceleration as it was
    other = first
    e_other = last_excess(other, end, axis, work)
    before = other
    e_before = e_other
    for i in range(HALVINGS):
        time = next_point(newest, other, before, e_newest, e_other, e_before)
        if time == newest or time == other or e_newest == 0.0:
            break
        error = last_excess(time, end, axis, work)
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            error * e_newest <= 0.0, time, error, newest, other, e_newest, e_other
        )
    last_excess(newest, end, axis, work)
    return True


def judge_dip(
    first: float, end: float, axis: 'float[:]', work: 'float[:,:]'
) -> 'tuple[bool, bool]':
    """Set the dip whose first level takes the time `first` [s]: is it too shallow, or too deep."""
    excess = work[PlanWork.EXCESS:PlanWork.RESIDUAL, :]
    if not close_dip(first, end, axis, work):
        return True, False
    if not measure_excess(axis, work):
        return False, False
    fast = excess[1, Excess.SHARE] > 0.0
    shallow = fast and excess[1, Excess.SIGN] > 0.0
    deep = fast and not shallow
    for order in range(2, 4):
        deep = deep or excess[order, Excess.SHARE] > 0.0
    return shallow, deep


def find_edge(
    deepest: bool, lower: float, end: float, axis: 'float[:]', work: 'float[:,:]'
) -> float:
    """The time [s] of the first level of about the least, or the deepest, dip within the limits.

    It is more than `lower`, and the acceleration at its end is `end`. -1: there is none.
    """
    accuracy = DEEPEST if deepest else FINE
    upper, found = NEVER, -1.0
    for i in range(HALVINGS):
        first = 0.5 * (lower + upper) if upper < NEVER else 2.0 * lower
        shallow, deep = judge_dip(first, end, axis, work)
        if shallow and deep:
            break
        if not shallow and not deep:
            found = first
        if shallow or (deepest and not deep):
            lower = first
        else:
            upper = first
        if upper - lower <= EQUAL * upper or (found > 0.0 and upper - lower <= accuracy * upper):
            break
    return found


def find_dips(
    v: float, a: float, end: float, axis: 'float[:]', dips: 'float[:]', work: 'float[:,:]'
) -> bool:
    """Set the least dip (Dip) from (v, a) that keeps the limits; False if there is none.

    At its end the acceleration is -`end`, in the direction of a, and all derivatives above zero.

    With levels of the derivative that passing profiles have, or else of one below. With the snap as
    the highest limit, ramps of the acceleration do the same.
    """
    sign = -1.0 if a < 0.0 else 1.0
    duration, slope = ramp_duration(abs(a), axis)
    gain = LEAST_GAIN * abs(a) * duration
    if ramps_suffice(axis) or sign * v + gain > side_limit(1, sign, axis):
        return False
    dips[Dip.V] = v
    dips[Dip.A] = a
    dips[Dip.END] = -sign * end
    for lower in range(int(axis[Axis.ABOVE])):
        above = int(axis[Axis.ABOVE]) - lower
        begin_dip(above, sign * v, abs(a), work)
        if sign < 0.0:
            mirror_axis(axis)
        least = find_edge(False, LEAST * duration, -end, axis, work)
        if sign < 0.0:
            mirror_axis(axis)
        if least > 0.0:
            dips[Dip.ABOVE] = above
            dips[Dip.LEAST] = least
            dips[Dip.DEEPEST] = least
            return True
    return False


def find_deepest(axis: 'float[:]', dips: 'float[:]', work: 'float[:,:]') -> None:
    """Set the deepest dip, right after `find_dips` set the least one."""
    end = -abs(dips[Dip.END])
    if dips[Dip.A] < 0.0:
        mirror_axis(axis)
    dips[Dip.DEEPEST] = max(find_edge(True, dips[Dip.LEAST], end, axis, work), dips[Dip.LEAST])
    if dips[Dip.A] < 0.0:
        mirror_axis(axis)


def write_levels(phases: 'float[:,:]', work: 'float[:,:]') -> int:
    """Write the levels of a dip as phases; returns their number, at most 7."""
    above = work[PlanWork.PASSING, Passing.ABOVE]
    level, used = 0.0, 0
    for i in range(int(above) + 2):
        row = PlanWork.NODES + i
        ramp = work[row, Node.RAMP]
        used = append_phase(phases, used, ramp, ramp, level, work[row, Node.LEVEL] - level, above)
        level = work[row, Node.LEVEL]
        used = append_phase(phases, used, work[row, Node.HOLD], 0.0, level, 0.0, above)
    return used


def write_dip(
    depth: float, axis: 'float[:]', dips: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> 'tuple[int, float, float, float]':
    """Write the dip between the least (depth 0) and the deepest one (1).

    Returns the number of its phases (0: there are no dips), duration, distance and end velocity.
    """
    above = int(dips[Dip.ABOVE])
    if above == 0:
        return 0, 0.0, 0.0, dips[Dip.V]
    sign = -1.0 if dips[Dip.A] < 0.0 else 1.0
    begin_dip(above, sign * dips[Dip.V], abs(dips[Dip.A]), work)
    first = dips[Dip.LEAST] + depth * (dips[Dip.DEEPEST] - dips[Dip.LEAST])
    close_dip(first, sign * dips[Dip.END], axis, work)
    count = write_levels(phases, work)
    if sign < 0.0:
        mirror_phases(phases, count)
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
    duration = sequence_duration(work[PlanWork.PASSING, :], nodes)
    y = sign * nodes[above + 2, Node.STATE]
    v = sign * nodes[above + 2, Node.STATE + 1]
    v = boundary_value(v, axis[Axis.LOWER], axis[Axis.VELOCITY])
    return count, duration, y, v
