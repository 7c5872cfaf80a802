"""One axis, one pair of boundary states -> the phases of the shortest profile.

The paper's profile (Fig. 3) is a ramp to a first acceleration level, a hold (I.1, I.c), a ramp
to zero, a cruise, a ramp to a second level, a hold and a ramp to the end (I.2, c, II.1, II.c,
II.2). Phases of zero length vanish. The candidates, in this order:

* cruise at the velocity limit, in closed form once the two velocity changes are known;
* the merged form without cruise (levels.py), from either of the two fastest velocity changes;
* the paper's form with a cruise velocity below the limit, by a bracketed root.

Each is tried from the boundary states as they are and, where that passes the velocity limit
inside a ramp, after braking the boundary accelerations to zero. After braking both, the last
form always exists: its distance is continuous in the cruise velocity and unbounded at the two
limits (docs/planner.md).
"""

from segfmu.kernels.braking import brake, surround
from segfmu.kernels.levels import canonical_point, solve_level
from segfmu.kernels.phases import (
    append_change,
    append_hold,
    append_ramp,
    copy_phases,
    insert_hold,
    measure_phases,
    mirror_phases,
    reverse_phases,
    without_dust,
    without_excess,
)
from segfmu.kernels.roots import root_share
from segfmu.kernels.search import canonical_search, timed_search
from segfmu.kernels.transition import ramp_duration


def append_velocity_change(
    phases: 'float[:,:]', count: int, v: float, a: float, w: float, top: float, ramp: 'float[:]'
) -> int:
    """Append the fastest change from (v, a) to (w, 0) over one level; -1 if there is none."""
    sign = 1.0
    t1, hold, level = solve_level(w - v, a, 0.0, max(0.0, a), top, ramp)
    if hold < 0.0:
        sign = -1.0
        t1, hold, level = solve_level(v - w, -a, 0.0, max(0.0, -a), top, ramp)
        if hold < 0.0:
            return -1
    count = append_ramp(phases, count, a, sign * level, t1, ramp)
    count = append_hold(phases, count, sign * level, hold)
    return append_change(phases, count, sign * level, 0.0, ramp)


def cruise_form(
    phases: 'float[:,:]',
    cruise: float,
    v: float,
    a: float,
    w: float,
    b: float,
    top: float,
    ramp: 'float[:]',
) -> 'tuple[int, int, float, float]':
    """The paper's form with a given cruise velocity, the cruise itself left out.

    Returns the number of phases (-1: a velocity change does not exist), the row before which
    the cruise belongs, duration and distance.
    """
    row = append_velocity_change(phases, 0, v, a, cruise, top, ramp)
    if row < 0:
        return -1, 0, 0.0, 0.0
    # the second part is the first part of the reversed problem
    count = append_velocity_change(phases, row, w, -b, cruise, top, ramp)
    if count < 0:
        return -1, 0, 0.0, 0.0
    reverse_phases(phases, row, count)
    duration, y, end, lowest, highest = measure_phases(phases, count, v, ramp)
    return count, row, duration, y


def merged_form(
    phases: 'float[:,:]',
    reverse: bool,
    mirror: bool,
    which: int,
    target: float,
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

    which >= 0 takes the which-th member that lasts `target`, which < 0 the first one that covers
    the distance. Reversal exchanges the boundary states,
    mirroring their signs; together they reduce every branch to the canonical one, whose first
    level is at most `high`.
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
        p = timed_search(which, target, v1, a1, v2, a2, high, top, t_top, ramp)
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
    phases: 'float[:,:]', count: int, v: float, limit: float, ramp: 'float[:]'
) -> float:
    """By how much the phases that start with velocity v pass the velocity limit, or less than 0."""
    duration, y, end, lowest, highest = measure_phases(phases, count, v, ramp)
    return max(highest, -lowest) - limit


def tempered_form(
    phases: 'float[:,:]',
    reverse: bool,
    mirror: bool,
    which: int,
    target: float,
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
        phases, reverse, mirror, which, target, v, a, w, b, distance, top, top, ramp
    )
    rounding = 1e-12 * velocity_limit
    margin = 1e-9 * velocity_limit
    if count <= 0:
        return count
    e_outside = velocity_excess(phases, count, v, velocity_limit, ramp) + margin
    if e_outside <= margin + rounding:
        return count
    inside = max(a, b)
    if reverse != mirror:
        inside = -min(a, b)
    inside = max(inside, 0.001 * top)
    count = merged_form(
        phases, reverse, mirror, which, target, v, a, w, b, distance, inside, top, ramp
    )
    if count <= 0:
        return 0
    e_inside = velocity_excess(phases, count, v, velocity_limit, ramp) + margin
    if e_inside > margin + rounding:
        return 0
    outside = top
    before = top
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
            phases, reverse, mirror, which, target, v, a, w, b, distance, high, top, ramp
        )
        error = 0.0
        if count > 0:
            error = velocity_excess(phases, count, v, velocity_limit, ramp) + margin
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
    return merged_form(
        phases, reverse, mirror, which, target, v, a, w, b, distance, inside, top, ramp
    )


def meets(
    phases: 'float[:,:]',
    count: int,
    v: float,
    w: float,
    distance: float,
    limit: float,
    ramp: 'float[:]',
) -> float:
    """Duration of the phases if they meet the boundary within the velocity limit, else -1."""
    duration, y, end, lowest, highest = measure_phases(phases, count, v, ramp)
    most = limit * (1.0 + 1e-12)
    if lowest < -most or highest > most:
        return -1.0
    if abs(end - w) > 1e-12 * limit:
        return -1.0
    if abs(y - distance) > 1e-12 * (abs(distance) + limit * duration):
        return -1.0
    return duration


def slower_cruise(
    phases: 'float[:,:]',
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The paper's form whose cruise velocity, below the limit, makes the cruise vanish.

    Searched between the two limits, of which one falls short of the distance and the other one
    is too far; by bisection where the form does not exist.
    """
    newest = -velocity_limit
    other = velocity_limit
    before = velocity_limit
    e_newest = 0.0
    e_other = 0.0
    e_before = 0.0
    falls_short = True
    for i in range(120):
        middle = max(v, w)
        if i > 0:
            share = root_share(newest, other, before, e_newest, e_other, e_before)
            middle = newest + share * (other - newest)
        if (middle - newest) * (middle - other) >= 0.0:
            if i > 0:
                break
            middle = 0.0
        count, row, duration, y = cruise_form(phases, middle, v, a, w, b, top, ramp)
        error = y - distance
        short = count < 0 or error < 0.0
        if count < 0:
            error = 0.0
        before = newest
        e_before = e_newest
        if short != falls_short:
            before = other
            e_before = e_other
            other = newest
            e_other = e_newest
        newest = middle
        e_newest = error
        falls_short = short
        if count >= 0 and abs(error) <= 1e-15 * abs(distance):
            other = newest
            break
    lower = newest
    upper = other
    if not falls_short:
        lower = other
        upper = newest
    # the side whose rounding error a short cruise can make up
    cruise = lower
    if cruise < 0.0:
        cruise = upper
    return with_cruise(phases, cruise, v, a, w, b, distance, top, ramp)


def with_cruise(
    phases: 'float[:,:]',
    cruise: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The paper's form with the cruise that covers the distance; 0 if it is overshot."""
    count, row, duration, y = cruise_form(phases, cruise, v, a, w, b, top, ramp)
    if count < 0 or cruise == 0.0:
        return max(count, 0)
    hold = (distance - y) / cruise
    # shorter than rounding: no cruise, and what it misses is judged by its caller
    if hold < 0.0 and abs(distance - y) > 1e-13 * abs(distance):
        return 0
    return insert_hold(phases, count, row, 0.0, hold)


def direct_form(
    phases: 'float[:,:]',
    from_start: bool,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The paper's form around the velocity that one ramp to zero reaches from one end, or 0.

    The distance has a kink there, which can be the only member that covers it: a state on the
    way of another profile leads to such problems.
    """
    end = abs(b)
    cruise = w
    if from_start:
        end = abs(a)
        cruise = v
    if end == 0.0:
        return 0
    t, rise, slope = ramp_duration(end, ramp)
    if from_start:
        cruise = v + 0.5 * a * t
    else:
        cruise = w - 0.5 * b * t
    if abs(cruise) > velocity_limit:
        return 0
    count, row, duration, y = cruise_form(phases, cruise, v, a, w, b, top, ramp)
    if abs(y - distance) > 1e-14 * (abs(distance) + (abs(v) + abs(w)) * duration):
        return 0
    return max(count, 0)


def shortest_between(
    attempt: int,
    phases: 'float[:,:]',
    trial: 'float[:,:]',
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> int:
    """The shortest candidate between two boundary states taken as they are; 0 if none holds.

    The first attempt (0) is for the forms that nothing is shorter than; the second one takes
    those that keep the velocity limit at some price.
    """
    if attempt == 0:
        # nothing is faster than one ramp: phase I.1 alone, where the points are consistent
        count = append_change(phases, 0, a, b, ramp)
        if count > 0 and abs(v + 0.5 * (a + b) * phases[0, 0] - w) <= 1e-13 * velocity_limit:
            if meets(phases, count, v, w, distance, velocity_limit, ramp) >= 0.0:
                return count
        for side in range(2):
            cruise = velocity_limit * (1 - 2 * side)
            count = with_cruise(phases, cruise, v, a, w, b, distance, top, ramp)
            if count > 0 and meets(phases, count, v, w, distance, velocity_limit, ramp) >= 0.0:
                return count
    best = 0
    shortest = 0.0
    for branch in range(6 - attempt):
        reverse = branch == 1 or branch == 2
        mirror = branch >= 2
        if branch == 4 and attempt == 1:
            count = slower_cruise(trial, v, a, w, b, distance, velocity_limit, top, ramp)
        elif branch >= 4:
            count = direct_form(
                trial, branch == 4, v, a, w, b, distance, velocity_limit, top, ramp
            )
        elif attempt == 0:
            count = merged_form(
                trial, reverse, mirror, -1, 0.0, v, a, w, b, distance, top, top, ramp
            )
        else:
            count = tempered_form(
                trial, reverse, mirror, -1, 0.0, v, a, w, b, distance, velocity_limit, top, ramp
            )
        if count > 0:
            duration = meets(trial, count, v, w, distance, velocity_limit, ramp)
            if duration >= 0.0 and (best == 0 or duration < shortest):
                copy_phases(trial, phases, count)
                best = count
                shortest = duration
    return best


def shortest_profile(
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
    phases: 'float[:,:]',
    work: 'float[:,:]',
) -> int:
    """Phases of the shortest profile from (v, a) over a distance to (w, b).

    top is the acceleration limit; `phases` has 12 rows and `work` 24. Returns the number of
    phases (0 when there is nothing to do), or -1 when bringing the first acceleration to zero
    passes the velocity limit, -2 when building up the last one does, -3 otherwise.
    """
    v = without_excess(v, velocity_limit)
    w = without_excess(w, velocity_limit)
    a = without_excess(a, top)
    b = without_excess(b, top)
    distance = without_dust(distance, velocity_limit * velocity_limit / top)
    if distance == 0.0 and v == w and a == b:
        return 0
    trial = work[0:12, :]
    found = work[12:24, :]
    count = shortest_between(0, phases, trial, v, a, w, b, distance, velocity_limit, top, ramp)
    if count > 0:
        return count
    best = 0
    shortest = 0.0
    # longer than a paper's form with cruise needs for the velocity changes and the distance
    t_top, rise, slope = ramp_duration(top, ramp)
    usual = 4.0 * (velocity_limit / top + t_top) + abs(distance) / velocity_limit
    crowded = False
    for variant in range(1, 8):
        # variants 0 to 3: braking none, the first, the last or both of the accelerations to zero;
        # 4 to 7 the same with the second attempt, of which the last three are the way out
        if variant > 4 and best > 0 and shortest <= usual:
            break
        attempt = variant // 4
        first = 0
        last = 0
        brake_start = variant % 2 == 1
        brake_end = variant % 4 >= 2
        if (brake_start and a == 0.0) or (brake_end and b == 0.0):
            continue
        v1 = v
        a1 = a
        w1 = w
        b1 = b
        rest = distance
        if brake_start:
            first, duration, y, v1 = brake(v, a, velocity_limit, top, ramp, trial)
            if first < 0:
                return -1
            rest = rest - y
            a1 = 0.0
        if brake_end:
            last, duration, y, w1 = brake(w, -b, velocity_limit, top, ramp, trial)
            if last < 0:
                return -2
            rest = rest - y
            b1 = 0.0
        # 12 rows hold seven phases between them
        if first + last > 5:
            crowded = True
            continue
        count = shortest_between(
            attempt, found, trial, v1, a1, w1, b1, rest, velocity_limit, top, ramp
        )
        if count == 0 and not (rest == 0.0 and v1 == w1 and a1 == 0.0 and b1 == 0.0):
            continue
        count = surround(
            found, count, brake_start, v, a, brake_end, w, b, velocity_limit, top, ramp, trial
        )
        duration = meets(found, count, v, w, distance, velocity_limit, ramp)
        if duration >= 0.0 and (best == 0 or duration < shortest):
            copy_phases(found, phases, count)
            best = count
            shortest = duration
    if best == 0 and crowded:
        return -1
    if best == 0:
        return -3
    return best
