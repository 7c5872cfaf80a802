"""A dip: an acceleration goes past zero and comes back without all that ramps bring to zero.

A ramp of the acceleration past zero reaches its steepest point in its middle. Beside a limit of the
pop the snap is zero there, so the acceleration crosses zero late. In a dip it passes its lowest
value, where the jerk is zero, with a snap: two levels of the jerk, of which the second one has the
other sign, or three of the snap. The limit of the acceleration leaves room for a steeper crossing.

The first level determines the others, because jerk and acceleration are zero at the end. The dips
begin with the ramp to zero, whose last level is zero; the more time the first level takes, the less
velocity is gained, and the lower the acceleration falls.
"""

from segfmu.kernels.numerics.roots import next_bracket, root_share
from segfmu.kernels.planner.excess import measure_excess
from segfmu.kernels.planner.phases import append_hold, mirror_phases
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Axis, Excess, Node, Passing, Phase, PlanWork
from segfmu.kernels.planner.sequence import advance, pass_node, sequence_duration, set_level


def begin_dip(above: int, v: float, a: float, work: 'float[:,:]') -> None:
    """Set a sequence (sequence.py) of levels of the derivative 2 + above, from the state (v, a)."""
    passing = work[PlanWork.PASSING, :]
    passing[Passing.COUNT] = above + 1
    passing[Passing.ABOVE] = above
    passing[Passing.PACE] = 1.0
    passing[Passing.START] = 0.0
    sign = -1.0
    for i in range(above + 2):
        for column in range(Node.SIZE):
            work[PlanWork.NODES + i, column] = 0.0
        work[PlanWork.NODES + i, Node.SIGN] = sign
        sign = -sign
    work[PlanWork.NODES, Node.STATE + 1] = v
    work[PlanWork.NODES, Node.STATE + 2] = a


def follow_dip(order: int, axis: 'float[:]', work: 'float[:,:]') -> float:
    """Follow a dip from level to level; the derivative of an order at its end."""
    passing = work[PlanWork.PASSING, :]
    nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
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
    while e_other < 0.0:
        newest = other
        e_newest = e_other
        other = 2.0 * other
        e_other = last_jerk(other, axis, work)
    before = other
    e_before = e_other
    for i in range(80):
        share = root_share(newest, other, before, e_newest, e_other, e_before)
        second = newest + share * (other - newest)
        if second == newest or second == other or e_newest == 0.0:
            break
        error = last_jerk(second, axis, work)
        crossed = error * e_newest <= 0.0
        other, before, e_other, e_before = next_bracket(crossed, newest, other, e_newest, e_other)
        newest = second
        e_newest = error
    work[PlanWork.NODES + 1, Node.TIME] = newest


def last_acceleration(time: float, axis: 'float[:]', work: 'float[:,:]') -> float:
    """The acceleration at the end of a dip whose last level takes `time` [s]."""
    above = int(work[PlanWork.PASSING, Passing.ABOVE])
    work[PlanWork.NODES + above, Node.TIME] = time
    if above == 2:
        balance_jerk(axis, work)
    return follow_dip(2, axis, work)


def close_dip(first: float, axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Set the dip whose first level takes the time `first` [s]; False: that is less than a ramp."""
    work[PlanWork.NODES, Node.TIME] = first
    newest = 0.0
    e_newest = last_acceleration(newest, axis, work)
    if e_newest > 0.0:
        return False
    # as long a last level leaves the acceleration as it was
    other = first
    e_other = last_acceleration(other, axis, work)
    before = other
    e_before = e_other
    for i in range(80):
        share = root_share(newest, other, before, e_newest, e_other, e_before)
        time = newest + share * (other - newest)
        if time == newest or time == other or e_newest == 0.0:
            break
        error = last_acceleration(time, axis, work)
        crossed = error * e_newest <= 0.0
        other, before, e_other, e_before = next_bracket(crossed, newest, other, e_newest, e_other)
        newest = time
        e_newest = error
    last_acceleration(newest, axis, work)
    return True


def find_dip(least: float, axis: 'float[:]', work: 'float[:,:]') -> bool:
    """Set about the least dip that keeps the limits; False if none does.

    least: its first level takes more time [s].
    """
    excess = work[PlanWork.EXCESS:PlanWork.RESIDUAL, :]
    shallow = least
    deep = 1e300
    found = -1.0
    for i in range(60):
        first = 2.0 * shallow
        if deep < 1e300:
            first = 0.5 * (shallow + deep)
        high = not close_dip(first, axis, work)
        low = False
        if not high and measure_excess(axis, work):
            fast = excess[1, Excess.SHARE] > 0.0
            high = fast and excess[1, Excess.SIGN] > 0.0
            low = fast and not high
            for order in range(2, 4):
                low = low or excess[order, Excess.SHARE] > 0.0
        if high and low:
            break
        if high:
            shallow = first
        else:
            deep = first
            if not low:
                found = first
        if deep - shallow <= 1e-12 * deep or (found > 0.0 and deep - shallow <= 1e-3 * deep):
            break
    if found < 0.0:
        return False
    return close_dip(found, axis, work)


def write_dip(phases: 'float[:,:]', work: 'float[:,:]') -> int:
    """Write a dip as phases; returns their number, at most 7."""
    above = work[PlanWork.PASSING, Passing.ABOVE]
    level = 0.0
    used = 0
    for i in range(int(above) + 2):
        row = PlanWork.NODES + i
        if work[row, Node.RAMP] > 0.0:
            phases[used, Phase.DURATION] = work[row, Node.RAMP]
            phases[used, Phase.BASIS] = work[row, Node.RAMP]
            phases[used, Phase.ACCELERATION] = level
            phases[used, Phase.CHANGE] = work[row, Node.LEVEL] - level
            phases[used, Phase.ABOVE] = above
            used = used + 1
        level = work[row, Node.LEVEL]
        if work[row, Node.HOLD] > 0.0:
            used = append_hold(phases, used, level, work[row, Node.HOLD])
            phases[used - 1, Phase.ABOVE] = above
    return used


def brake_by_dip(
    v: float, a: float, axis: 'float[:]', phases: 'float[:,:]', work: 'float[:,:]'
) -> 'tuple[int, float, float, float]':
    """Phases of a dip from (v, a) to zero acceleration; their number (-1: none keeps the limits).

    Also returns duration, distance and end velocity. Only where passing profiles have levels of the
    snap: else ramps of the acceleration need less than 2 % more than the least velocity.
    """
    limit = axis[Axis.VELOCITY]
    sign = 1.0
    if a < 0.0:
        sign = -1.0
    duration, slope = ramp_duration(abs(a), axis)
    # with the highest limit alone, a ramp gains 0.5 of this, and every motion 0.4
    if axis[Axis.ABOVE] < 1.5 or sign * v + 0.3 * abs(a) * duration > limit:
        return -1, 0.0, 0.0, 0.0
    for above in range(1, 3):
        begin_dip(above, sign * v, abs(a), work)
        if find_dip(0.02 * duration, axis, work):
            nodes = work[PlanWork.NODES:PlanWork.KEPT, :]
            end = nodes[above + 2, Node.STATE + 1]
            if abs(end) > limit * (1.0 + 1e-12):
                continue
            count = write_dip(phases, work)
            if sign < 0.0:
                mirror_phases(phases, count)
            spent = sequence_duration(work[PlanWork.PASSING, :], nodes)
            return count, spent, sign * nodes[above + 2, Node.STATE], sign * end
    return -1, 0.0, 0.0, 0.0
