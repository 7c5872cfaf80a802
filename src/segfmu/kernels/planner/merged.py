"""The merged form without cruise (levels.py) as phases, on each of its four branches.

Reversal of time and mirroring of the position reduce every branch to the canonical family, which
search.py searches by distance or by duration.
"""

from segfmu.kernels.numerics.numbers import CLOSE, EQUAL, FINE, HALVINGS, NEARLY, SMALL, TRIES
from segfmu.kernels.numerics.roots import root_share
from segfmu.kernels.planner.levels import canonical_member
from segfmu.kernels.planner.members import member_search
from segfmu.kernels.planner.phases import (
    append_change,
    append_hold,
    append_ramp,
    measure_phases,
    mirror_phases,
    reverse_phases,
)
from segfmu.kernels.planner.ramp import ramp_duration
from segfmu.kernels.planner.records import Axis, Family, Phase, Problem
from segfmu.kernels.planner.search import canonical_search
from segfmu.kernels.planner.sides import fastest_velocity, slowest_velocity


def set_family(branch: int, problem: 'float[:]', axis: 'float[:]', family: 'float[:]') -> None:
    """Set the canonical family (Family) of a problem on a branch 0 .. 3, by the distance.

    Reversal (1, 2) exchanges the boundary states, mirroring (2, 3) changes their signs; together
    they reduce every branch to the canonical one. By default the first member that covers the
    distance is searched for, see `set_member`.
    """
    reverse = branch == 1 or branch == 2
    mirror = branch >= 2
    v, a, w, b = problem[Problem.V], problem[Problem.A], problem[Problem.W], problem[Problem.B]
    distance = problem[Problem.DISTANCE]
    family[Family.START_VELOCITY] = v
    if reverse:
        v, a = problem[Problem.W], -problem[Problem.B]
        w, b = problem[Problem.V], -problem[Problem.A]
    if mirror:
        v, a, w, b = -v, -a, -w, -b
        distance = -distance
    top = axis[Axis.ACCELERATION]
    bottom = axis[Axis.LOWER + 1]
    if reverse != mirror:
        top = axis[Axis.LOWER + 1]
        bottom = axis[Axis.ACCELERATION]
    last_ramp, slope = ramp_duration(b + bottom, axis)
    family[Family.V] = v
    family[Family.A] = a
    family[Family.W] = w
    family[Family.B] = b
    family[Family.TOP] = top
    family[Family.BOTTOM] = bottom
    family[Family.LOWEST] = bottom
    family[Family.LAST_RAMP] = last_ramp
    family[Family.REVERSE] = reverse
    family[Family.MIRROR] = mirror
    family[Family.BY_TIME] = 0.0
    family[Family.TARGET] = distance
    family[Family.MEMBER] = -1.0
    family[Family.FIRST_TIME] = -1.0
    family[Family.SCALE] = last_ramp
    family[Family.STRETCH] = 1.0
    family[Family.FLATNESS] = 0.0
    family[Family.LOWERED] = 0.0


def set_member(member: int, time: float, by_time: bool, family: 'float[:]') -> None:
    """Set which of several members to search for: its number, from 0.

    With `by_time` it lasts `time` [s]; else it covers the distance, and `time` scales the search.
    """
    family[Family.MEMBER] = member
    family[Family.SCALE] = min(max(family[Family.LAST_RAMP], SMALL * time), time)
    if by_time:
        family[Family.BY_TIME] = 1.0
        family[Family.TARGET] = time


def same_members(branch: int, problem: 'float[:]', family: 'float[:]') -> bool:
    """Whether a branch has the members of the one before, seen from the other end.

    Both have them all if their levels cannot be limited by the accelerations at the ends. Where
    the first level was lowered (`tempered_form`), that is the level at the other end.
    """
    if branch % 2 == 0 or family[Family.LOWERED] != 0.0:
        return False
    a, b = problem[Problem.A], problem[Problem.B]
    if branch >= 2:
        a = -a
        b = -b
    return a >= 0.0 and b <= 0.0


def merged_form(phases: 'float[:,:]', highest: float, family: 'float[:]', axis: 'float[:]') -> int:
    """Write the member of a family that is searched for; its number of phases, -1 if none.

    highest [m/s2] bounds the first level; the second one alike if the problem is its own reverse.
    """
    family[Family.HIGHEST] = highest
    lowest = family[Family.BOTTOM]
    if family[Family.V] == family[Family.W] and family[Family.A] == -family[Family.B]:
        lowest = max(min(lowest, highest), family[Family.A])
    if lowest != family[Family.LOWEST]:
        family[Family.LOWEST] = lowest
        family[Family.LAST_RAMP], slope = ramp_duration(family[Family.B] + lowest, axis)
    if family[Family.MEMBER] < 0.0:
        p = canonical_search(family, axis)
    else:
        p = member_search(family, axis)
    if p < 0.0:
        return -1
    duration, y = canonical_member(p, family, axis)
    if duration < 0.0:
        return -1
    return write_member(phases, family, axis)


def write_member(phases: 'float[:,:]', family: 'float[:]', axis: 'float[:]') -> int:
    """Write the member of a family as phases, on its own branch; their number."""
    a, b, level1 = family[Family.A], family[Family.B], family[Family.FIRST_LEVEL]
    level2 = family[Family.SECOND_LEVEL]
    count = append_ramp(phases, 0, a, level1, family[Family.FIRST_TIME], axis)
    count = append_hold(phases, count, level1, family[Family.FIRST_HOLD])
    before = count
    count = append_change(phases, count, level1, level2, axis)
    if count > before and family[Family.STRETCH] > 1.0:
        basis = phases[before, Phase.BASIS]
        duration = basis * family[Family.STRETCH]
        phases[before, Phase.DURATION] = duration
        phases[before, Phase.BASIS] = basis + family[Family.FLATNESS] * (duration - basis)
    count = append_hold(phases, count, level2, family[Family.SECOND_HOLD])
    count = append_ramp(phases, count, level2, b, family[Family.LAST_TIME], axis)
    if family[Family.REVERSE] != 0.0:
        reverse_phases(phases, 0, count)
    if family[Family.MIRROR] != 0.0:
        mirror_phases(phases, count)
    return count


def velocity_excess(
    phases: 'float[:,:]', count: int, v: float, within: float, axis: 'float[:]'
) -> float:
    """Excess over a velocity limit [m/s] of phases that start with velocity v; below 0: none.

    Peaks inside ramps may be ignored if they are within +-`within`.
    """
    duration, y, end, lowest, highest = measure_phases(phases, count, v, within, axis)
    return max(highest - axis[Axis.VELOCITY], -lowest - axis[Axis.LOWER])


def level_within(
    outside: float, e_outside: float, phases: 'float[:,:]', family: 'float[:]', axis: 'float[:]'
) -> 'tuple[float, float, float, float]':
    """A first level whose member keeps the velocity limit, and one above it that does not.

    Returns both and their excess over the limit less a billionth; the first is -1 if there is none.
    Below some level there may be no member, or one that exceeds the limit on the other side.
    """
    peak_limit, other_limit = axis[Axis.VELOCITY], axis[Axis.LOWER]
    if family[Family.MIRROR] != 0.0:
        peak_limit, other_limit = axis[Axis.LOWER], axis[Axis.VELOCITY]
    v = family[Family.START_VELOCITY]
    rounding = EQUAL * fastest_velocity(axis)
    margin = NEARLY * fastest_velocity(axis)
    too_low = max(family[Family.A], max(family[Family.B], FINE * outside))
    inside = too_low
    for i in range(TRIES):
        count = merged_form(phases, inside, family, axis)
        duration, y, end, lowest, highest = measure_phases(phases, max(count, 0), v, 0.0, axis)
        peak = highest
        other = -lowest
        if family[Family.MIRROR] != 0.0:
            peak = -lowest
            other = highest
        if count <= 0 or other > other_limit + rounding:
            too_low = inside
        elif peak > peak_limit + rounding:
            outside = inside
            e_outside = peak - peak_limit + margin
        else:
            excess = max(peak - peak_limit, other - other_limit)
            return inside, outside, excess + margin, e_outside
        if too_low == outside:
            break
        inside = 0.5 * (too_low + outside)
    return -1.0, outside, 0.0, e_outside


def highest_within(
    inside: float, outside: float, e_inside: float, e_outside: float, phases: 'float[:,:]',
    family: 'float[:]', axis: 'float[:]',
) -> float:
    """The highest first level that keeps the velocity limit less a billionth: a bracketed root."""
    margin = NEARLY * fastest_velocity(axis)
    before = outside
    e_before = e_outside
    newest_inside = True
    # a boundary state can keep the excess near zero at any level; then only its sign is used
    constant, probing, steps = False, False, 0
    while steps < HALVINGS:
        steps = steps + 1
        probing = False
        if constant:
            e_inside = 0.0
            if steps > TRIES:
                break
        elif abs(e_inside) <= margin:
            probing = True
        if newest_inside:
            share = root_share(inside, outside, before, e_inside, e_outside, e_before)
        else:
            share = 1.0 - root_share(outside, inside, before, e_outside, e_inside, e_before)
        if probing:
            share = FINE
        level = inside + share * (outside - inside)
        count = merged_form(phases, level, family, axis)
        error = 0.0
        if count > 0:
            v = family[Family.START_VELOCITY]
            error = velocity_excess(phases, count, v, 0.0, axis) + margin
        if count > 0 and error <= margin:
            before = outside
            e_before = e_outside
            if newest_inside:
                before = inside
                e_before = e_inside
            inside = level
            e_inside = error
            newest_inside = True
            # close enough: what exceeds the limit is next to it
            if probing and outside - inside <= CLOSE * outside:
                break
            constant = constant or probing
        elif probing:
            break
        else:
            before = inside
            e_before = e_inside
            if not newest_inside:
                before = outside
                e_before = e_outside
            outside = level
            e_outside = error
            newest_inside = False
    return inside


def tempered_form(phases: 'float[:,:]', family: 'float[:]', axis: 'float[:]') -> int:
    """The merged form that keeps the velocity limit; the number of phases.

    It is -1 if there is no merged form, 0 if none keeps the limit.

    Between its levels the velocity has a peak. If that exceeds the limit, the first level is
    lowered and held (tempered), so that the peak is at the limit less a billionth.
    """
    count = merged_form(phases, family[Family.TOP], family, axis)
    rounding = EQUAL * fastest_velocity(axis)
    margin = NEARLY * fastest_velocity(axis)
    if count <= 0:
        return count
    v = family[Family.START_VELOCITY]
    e_outside = velocity_excess(phases, count, v, slowest_velocity(axis), axis) + margin
    if e_outside <= margin + rounding:
        return count
    family[Family.LOWERED] = 1.0
    outside = 0.0
    for i in range(count):
        level = phases[i, Phase.ACCELERATION]
        if family[Family.REVERSE] != family[Family.MIRROR]:
            level = -level
        outside = max(outside, level)
    inside, outside, e_inside, e_outside = level_within(outside, e_outside, phases, family, axis)
    if inside < 0.0:
        return 0
    inside = highest_within(inside, outside, e_inside, e_outside, phases, family, axis)
    return merged_form(phases, inside, family, axis)
