"""Searches for the first member of the canonical family (levels.py), by distance or by duration.

BY_TIME of a family (Family) selects one of them, TARGET is its value.
"""

from segfmu.kernels.numerics.numbers import (
    COARSE,
    COVERED,
    GOLDEN,
    HALVINGS,
    LAST_DIGIT,
    NEARLY,
    ROUNDED,
    SECTIONS,
)
from segfmu.kernels.numerics.roots import next_bracket, next_point
from segfmu.kernels.planner.levels import canonical_member, has_member, level_gain
from segfmu.kernels.planner.parameters import saving
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Axis, Family, Rises


def window_edge(inside: float, outside: float, family: 'float[:]', axis: 'float[:]') -> float:
    """Bisect between a parameter that has a canonical member and one that has none."""
    for i in range(HALVINGS):
        middle = 0.5 * (inside + outside)
        if abs(inside - outside) <= NEARLY * middle:
            break
        if has_member(middle, family, axis):
            inside = middle
        else:
            outside = middle
    return inside


def canonical_value(p: float, family: 'float[:]', axis: 'float[:]') -> 'tuple[float, float]':
    """The searched quantity (duration or distance) of a member, and its duration or -1."""
    duration, y = canonical_member(p, family, axis)
    if family[Family.BY_TIME] != 0.0:
        return duration, duration
    return y, duration


def bracketed_root(
    lower: float, upper: float, f_lower: float, f_upper: float, family: 'float[:]', axis: 'float[:]'
) -> float:
    """Parameter of the member with the target value; f_lower < target <= f_upper.

    `lower` and `upper` name the values, not the order of the parameters.
    """
    target = family[Family.TARGET]
    newest = upper
    e_newest = f_upper - target
    other = lower
    e_other = f_lower - target
    before = lower
    e_before = e_other
    speed = 0.0 if family[Family.BY_TIME] != 0.0 else abs(family[Family.V]) + abs(family[Family.W])
    for i in range(HALVINGS):
        if e_newest == 0.0 or abs(newest - other) <= LAST_DIGIT * abs(newest):
            break
        p = next_point(newest, other, before, e_newest, e_other, e_before)
        value, duration = canonical_value(p, family, axis)
        error = value - target
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            error * e_newest < 0.0, p, error, newest, other, e_newest, e_other
        )
        # rounding error of a sum whose terms may cancel
        if abs(error) <= ROUNDED * (abs(target) + speed * duration):
            break
    return other if abs(e_other) < abs(e_newest) else newest


def rising_member(f_start: float, end: float, family: 'float[:]', axis: 'float[:]') -> float:
    """Parameter in (0, end) of a member up to which the distance rises to the target; -1: none.

    It may fall again, even between two samples. f_start is the value of the first member.
    """
    target = family[Family.TARGET]
    # more samples take more time than the few plans gain that they shorten
    step = end / COARSE
    before = f_start
    f_lower = f_start
    for i in range(1, COARSE + 1):
        value, duration = canonical_value(i * step, family, axis)
        if value >= target and value > f_lower:
            return bracketed_root((i - 1) * step, i * step, f_lower, value, family, axis)
        bend = 2.0 * f_lower - before - value
        if i > 1 and f_lower >= max(before, value) and target <= f_lower + 0.25 * bend:
            # by a parabola, the highest value of these three is at most an eighth of that higher
            p, highest = highest_member((i - 2) * step, i * step, family, axis)
            if highest >= target and highest > before:
                return bracketed_root((i - 2) * step, p, before, highest, family, axis)
        before = f_lower
        f_lower = value
    return -1.0


def highest_member(
    lower: float, upper: float, family: 'float[:]', axis: 'float[:]'
) -> 'tuple[float, float]':
    """Parameter and value of the member of the highest value between two, by golden section."""
    p = upper - GOLDEN * (upper - lower)
    q = lower + GOLDEN * (upper - lower)
    f_p, duration = canonical_value(p, family, axis)
    f_q, duration = canonical_value(q, family, axis)
    for i in range(SECTIONS):
        if max(f_p, f_q) >= family[Family.TARGET]:
            break
        if f_p >= f_q:
            upper = q
            q = p
            f_q = f_p
            p = upper - GOLDEN * (upper - lower)
            f_p, duration = canonical_value(p, family, axis)
        else:
            lower = p
            p = q
            f_p = f_q
            q = lower + GOLDEN * (upper - lower)
            f_q, duration = canonical_value(q, family, axis)
    if f_p >= f_q:
        return p, f_p
    return q, f_q


def first_window(
    f_start: float, t_zero: float, family: 'float[:]', axis: 'float[:]'
) -> 'tuple[float, float]':
    """Search the members whose second level lies between the end acceleration and zero.

    f_start is the value of the first member, t_zero the parameter at which the second level is
    zero. Returns the parameter or -1, and t_zero if the family continues there, else -1: a positive
    second level gains velocity, so there may be no first level. If the motion starts backwards, the
    distance can rise and fall again, so the members between are searched too.
    """
    target = family[Family.TARGET]
    value, duration = canonical_value(t_zero, family, axis)
    end = t_zero
    going_on = t_zero
    if duration < 0.0:
        end = window_edge(0.0, t_zero, family, axis)
        value, duration = canonical_value(end, family, axis)
        going_on = -1.0
    if family[Family.V] < 0.0:
        p = rising_member(f_start, end, family, axis)
        if p >= 0.0:
            return p, going_on
    if value >= target and value > f_start:
        p = bracketed_root(0.0, end, f_start, value, family, axis)
        return p, going_on
    if going_on < 0.0:
        note_near(value, duration, family, axis)
    return -1.0, going_on


def only_farther(family: 'float[:]') -> bool:
    """Whether all members beyond the one that is written cover more distance.

    Their ramps take longer and reach farther, so the velocity is higher at the same time from the
    start, and from the end. The time that is added lies between those two velocities, which the
    peak between the levels bounds if they are not below zero. With a second level above zero a
    farther member can be shorter.
    """
    if family[Family.B] > 0.0:
        return False
    gain = 0.5 * (family[Family.A] + family[Family.FIRST_LEVEL]) * family[Family.FIRST_TIME]
    gain = gain + family[Family.FIRST_LEVEL] * family[Family.FIRST_HOLD]
    loss = 0.5 * (family[Family.SECOND_LEVEL] + family[Family.B]) * family[Family.LAST_TIME]
    loss = loss + family[Family.SECOND_LEVEL] * family[Family.SECOND_HOLD]
    return family[Family.V] + gain >= 0.0 or family[Family.W] - loss >= 0.0


def shorter_member(f_start: float, family: 'float[:]', axis: 'float[:]') -> float:
    """Parameter of a member that covers the target, which is less than f_start of the first one.

    -1 if there is none. A longer motion covers less distance while the velocity in between is
    negative.
    """
    span = max(family[Family.LAST_RAMP], axis[Axis.FULL_RAMP])
    for i in range(1, COARSE + 1):
        if only_farther(family):
            return -1.0
        p = span * i * i / (COARSE * COARSE)
        value, duration = canonical_value(p, family, axis)
        if duration < 0.0:
            return -1.0
        if value <= family[Family.TARGET]:
            return bracketed_root(p, 0.0, value, f_start, family, axis)
    return -1.0


def note_near(y: float, duration: float, family: 'float[:]', axis: 'float[:]') -> None:
    """Note whether the distance y of a member may be the target with steeper rises."""
    speed = abs(family[Family.V]) + abs(family[Family.W])
    speed = speed + (abs(family[Family.A]) + abs(family[Family.B])) * duration
    if abs(y - family[Family.TARGET]) <= saving(axis) * speed * duration:
        family[Family.MISSED] = Rises.STEEPEST


def note_near_gain(family: 'float[:]', axis: 'float[:]') -> None:
    """Note whether the first member may exist with steeper rises."""
    a, b = family[Family.A], family[Family.B]
    low = max(0.0, max(a, b))
    first, least = level_gain(low, a, b, axis)
    if family[Family.W] - family[Family.V] >= (1.0 - saving(axis)) * least:
        family[Family.MISSED] = Rises.STEEPEST


def canonical_search(family: 'float[:]', axis: 'float[:]') -> float:
    """Parameter of the first canonical member that covers the target distance, or -1."""
    target, v, w = family[Family.TARGET], family[Family.V], family[Family.W]
    f_lower, duration = canonical_value(0.0, family, axis)
    if duration < 0.0:
        note_near_gain(family, axis)
        return -1.0
    # the first member covers the target up to rounding
    if abs(f_lower - target) <= COVERED * (abs(target) + (abs(v) + abs(w)) * duration):
        return 0.0
    if f_lower > target:
        note_near(f_lower, duration, family, axis)
        if v >= 0.0 and w >= 0.0:
            return -1.0
        return shorter_member(f_lower, family, axis)
    lower = 0.0
    if family[Family.B] > 0.0:
        t_zero, slope = ramp_duration(family[Family.B], axis)
        p, lower = first_window(f_lower, t_zero, family, axis)
        if p >= 0.0:
            return p
        if lower < 0.0:
            lower = second_window(t_zero, family, axis)
        f_lower, duration = canonical_value(lower, family, axis)
        if f_lower > target:
            return -1.0
    return farther_member(lower, f_lower, family, axis)


def second_window(t_zero: float, family: 'float[:]', axis: 'float[:]') -> float:
    """First parameter beyond t_zero with a member, if t_zero has none."""
    upper = family[Family.LAST_RAMP]
    value, duration = canonical_value(upper, family, axis)
    for i in range(HALVINGS):
        if duration >= 0.0:
            break
        upper = 2.0 * upper
        value, duration = canonical_value(upper, family, axis)
    return window_edge(upper, t_zero, family, axis)


def farther_member(lower: float, f_lower: float, family: 'float[:]', axis: 'float[:]') -> float:
    """Parameter beyond `lower` that covers the target, or -1; `lower` covers f_lower."""
    # if the last acceleration is at its limit, the last ramp cannot scale the family
    upper = max(family[Family.LAST_RAMP], axis[Axis.FULL_RAMP])
    if upper <= lower:
        upper = 2.0 * lower
    for i in range(HALVINGS):
        f_upper, duration = canonical_value(upper, family, axis)
        if f_upper >= family[Family.TARGET]:
            return bracketed_root(lower, upper, f_lower, f_upper, family, axis)
        lower = upper
        f_lower = f_upper
        upper = 2.0 * upper
    return -1.0
