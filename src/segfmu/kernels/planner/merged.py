"""The merged form without cruise (levels.py) as phases, on each of its four branches.

Reversal of time and mirroring of the position reduce every branch to the canonical family, which
search.py searches by distance or by duration.
"""

from segfmu.kernels.numerics.roots import root_share
from segfmu.kernels.planner.levels import canonical_point
from segfmu.kernels.planner.phases import (
    append_change,
    append_hold,
    append_ramp,
    measure_phases,
    mirror_phases,
    reverse_phases,
)
from segfmu.kernels.planner.search import canonical_search, member_search
from segfmu.kernels.planner.transition import ramp_duration


def merged_form(
    phases: 'float[:,:]',
    reverse: bool,
    mirror: bool,
    which: int,
    by_time: bool,
    time: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    high: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The merged form on one of its four branches; the number of phases, -1 if it has none.

    which < 0 takes the first member that covers the distance, which >= 0 the which-th one that
    lasts `time` or, not by time but with it as the scale, covers the distance. Reversal exchanges
    the boundary states, mirroring their signs; together they reduce every branch to the canonical
    one, whose first level is at most `high`.
    """
    v1 = v
    a1 = a
    v2 = w
    a2 = b
    if reverse:
        v1 = w
        a1 = -b
        v2 = v
        a2 = -a
    if mirror:
        v1 = -v1
        a1 = -a1
        v2 = -v2
        a2 = -a2
        distance = -distance
    t_top, rise, slope = ramp_duration(a2 + top, ramp)
    if which < 0:
        p = canonical_search(distance, v1, a1, v2, a2, high, top, t_top, ramp)
    else:
        target = distance
        if by_time:
            target = time
        scale = max(t_top, 0.1 * time)
        p = member_search(
            which, by_time, scale, target, v1, a1, v2, a2, high, top, t_top, ramp
        )
    if p < 0.0:
        return -1
    duration, y, t1, hold1, level1, hold2, level2, t3 = canonical_point(
        p, v1, a1, v2, a2, high, top, t_top, ramp
    )
    if duration < 0.0:
        return -1
    count = append_ramp(phases, 0, a1, level1, t1, ramp)
    count = append_hold(phases, count, level1, hold1)
    count = append_change(phases, count, level1, level2, ramp)
    count = append_hold(phases, count, level2, hold2)
    count = append_ramp(phases, count, level2, a2, t3, ramp)
    if reverse:
        reverse_phases(phases, 0, count)
    if mirror:
        mirror_phases(phases, count)
    return count


def velocity_excess(
    phases: 'float[:,:]', count: int, v: float, within: float, limit: float, ramp: 'float[:]'
) -> float:
    """By how much the phases that start with velocity v pass the velocity limit, or less than 0."""
    duration, y, end, lowest, highest = measure_phases(phases, count, v, within, ramp)
    return max(highest, -lowest) - limit


def level_within(
    outside: float,
    e_outside: float,
    phases: 'float[:,:]',
    reverse: bool,
    mirror: bool,
    which: int,
    by_time: bool,
    time: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> 'tuple[float, float, float, float]':
    """A first level whose member keeps the velocity limit, and one above it that does not.

    Returns both and by how much they pass the limit less a billionth; -1 first if there is none.
    Below some level there may be no member, or one that passes the limit on the other side.
    """
    rounding = 1e-12 * velocity_limit
    margin = 1e-9 * velocity_limit
    sign = 1.0
    if reverse != mirror:
        sign = -1.0
    without = max(sign * a, max(sign * b, 0.001 * top))
    inside = without
    for i in range(24):
        count = merged_form(
            phases, reverse, mirror, which, by_time, time, v, a, w, b, distance, inside, top, ramp
        )
        duration, y, end, lowest, highest = measure_phases(phases, max(count, 0), v, 0.0, ramp)
        peak = highest
        other = -lowest
        if mirror:
            peak = -lowest
            other = highest
        if count <= 0 or other > velocity_limit + rounding:
            without = inside
        elif peak > velocity_limit + rounding:
            outside = inside
            e_outside = peak - velocity_limit + margin
        else:
            return inside, outside, max(peak, other) - velocity_limit + margin, e_outside
        if without == outside:
            break
        inside = 0.5 * (without + outside)
    return -1.0, outside, 0.0, e_outside


def highest_within(
    inside: float,
    outside: float,
    e_inside: float,
    e_outside: float,
    phases: 'float[:,:]',
    reverse: bool,
    mirror: bool,
    which: int,
    by_time: bool,
    time: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> float:
    """The highest first level that keeps the velocity limit less a billionth: a bracketed root."""
    margin = 1e-9 * velocity_limit
    before = outside
    e_before = e_outside
    newest_inside = True
    # a boundary state can hold the excess near zero, whatever the level; then it only says whether
    # the limit is kept
    constant = False
    probing = False
    steps = 0
    while steps < 60:
        steps = steps + 1
        probing = False
        if constant:
            e_inside = 0.0
            if steps > 24:
                break
        elif abs(e_inside) <= margin:
            probing = True
        if newest_inside:
            share = root_share(inside, outside, before, e_inside, e_outside, e_before)
        else:
            share = 1.0 - root_share(outside, inside, before, e_outside, e_inside, e_before)
        if probing:
            share = 1e-3
        high = inside + share * (outside - inside)
        count = merged_form(
            phases, reverse, mirror, which, by_time, time, v, a, w, b, distance, high, top, ramp
        )
        error = 0.0
        if count > 0:
            error = velocity_excess(phases, count, v, 0.0, velocity_limit, ramp) + margin
        if count > 0 and error <= margin:
            before = outside
            e_before = e_outside
            if newest_inside:
                before = inside
                e_before = e_inside
            inside = high
            e_inside = error
            newest_inside = True
            constant = constant or probing
        elif probing:
            break
        else:
            before = inside
            e_before = e_inside
            if not newest_inside:
                before = outside
                e_before = e_outside
            outside = high
            e_outside = error
            newest_inside = False
    return inside


def tempered_form(
    phases: 'float[:,:]',
    reverse: bool,
    mirror: bool,
    which: int,
    by_time: bool,
    time: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The merged form that keeps the velocity limit; the number of phases.

    It is -1 where there is no merged form, 0 where none keeps the limit.

    Between its levels the velocity has a peak. Where that passes the limit, the first level is
    lowered, and held, until the peak is at the limit less a billionth.
    """
    count = merged_form(
        phases, reverse, mirror, which, by_time, time, v, a, w, b, distance, top, top, ramp
    )
    rounding = 1e-12 * velocity_limit
    margin = 1e-9 * velocity_limit
    if count <= 0:
        return count
    e_outside = velocity_excess(phases, count, v, velocity_limit, velocity_limit, ramp) + margin
    if e_outside <= margin + rounding:
        return count
    outside = 0.0
    for i in range(count):
        level = phases[i, 2]
        if reverse != mirror:
            level = -level
        outside = max(outside, level)
    inside, outside, e_inside, e_outside = level_within(
        outside, e_outside, phases, reverse, mirror, which, by_time, time, v, a, w, b, distance,
        velocity_limit, top, ramp,
    )
    if inside < 0.0:
        return 0
    inside = highest_within(
        inside, outside, e_inside, e_outside, phases, reverse, mirror, which, by_time, time, v, a,
        w, b, distance, velocity_limit, top, ramp,
    )
    return merged_form(
        phases, reverse, mirror, which, by_time, time, v, a, w, b, distance, inside, top, ramp
    )
