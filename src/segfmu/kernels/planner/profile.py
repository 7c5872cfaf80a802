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

from segfmu.kernels.planner.braking import braked, surround
from segfmu.kernels.planner.cruise import direct_form, slower_cruise, with_cruise
from segfmu.kernels.planner.merged import merged_form, tempered_form
from segfmu.kernels.planner.phases import (
    append_change,
    copy_phases,
    measure_phases,
    without_dust,
    without_excess,
)
from segfmu.kernels.planner.transition import ramp_duration


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
    most = limit * (1.0 + 1e-12)
    duration, y, end, lowest, highest = measure_phases(phases, count, v, most, ramp)
    if lowest < -most or highest > most:
        return -1.0
    if abs(end - w) > 1e-12 * limit:
        return -1.0
    if abs(y - distance) > 1e-12 * (abs(distance) + limit * duration):
        return -1.0
    return duration


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
                trial, reverse, mirror, -1, False, 0.0, v, a, w, b, distance, top, top, ramp
            )
        else:
            count = tempered_form(
                trial, reverse, mirror, -1, False, 0.0, v, a, w, b, distance, velocity_limit,
                top, ramp,
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

    top is the acceleration limit; `phases` has 13 rows and `work` 26. Returns the number of
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
    trial = work[0:13, :]
    found = work[13:26, :]
    count = shortest_between(0, phases, trial, v, a, w, b, distance, velocity_limit, top, ramp)
    if count > 0:
        return count
    best = 0
    shortest = 0.0
    # longer than a paper's form with cruise needs for the velocity changes and the distance
    t_top, rise, slope = ramp_duration(top, ramp)
    usual = 4.0 * (velocity_limit / top + t_top) + abs(distance) / velocity_limit
    for variant in range(1, 8):
        # variants 0 to 3: braking none, the first, the last or both of the accelerations to zero;
        # 4 to 7 the same with the second attempt, of which the last three are the way out
        if variant > 4 and best > 0 and shortest <= usual:
            break
        taken, time, rest, v1, a1, w1, b1 = braked(
            variant % 4, v, a, w, b, distance, velocity_limit, top, ramp, trial
        )
        if taken == -3:
            continue
        if taken < 0:
            return taken
        count = shortest_between(
            variant // 4, found, trial, v1, a1, w1, b1, rest, velocity_limit, top, ramp
        )
        if count == 0 and not (rest == 0.0 and v1 == w1 and a1 == 0.0 and b1 == 0.0):
            continue
        count = surround(
            found, count, variant % 2 == 1, v, a, variant % 4 >= 2, w, b, velocity_limit, top,
            ramp, trial,
        )
        duration = meets(found, count, v, w, distance, velocity_limit, ramp)
        if duration >= 0.0 and (best == 0 or duration < shortest):
            copy_phases(found, phases, count)
            best = count
            shortest = duration
    if best == 0:
        return -3
    return best
