"""A profile of prescribed duration, and whether a duration is feasible at all.

For a given duration T the motions between two boundary states that keep every limit form a
convex set (the limits bound linear functions of y), so the distances they cover form an
interval, and a weighted mean of two such motions is one as well. A duration is therefore
feasible when one profile of that duration falls short of the distance and another one covers
at least as much. Between two moving waypoints the feasible durations can have gaps (errata
E10); outside the gaps the profile is, in this order:

* from rest to rest the shortest profile stretched in time, as in section 3.2;
* the paper's form with the cruise velocity that makes it last T;
* the weighted mean of two profiles that last T, one short of the distance and one beyond it.
"""

from segfmu.kernels.braking import brake, surround
from segfmu.kernels.cruise import cruise_form
from segfmu.kernels.merged import tempered_form
from segfmu.kernels.phases import (
    copy_phases,
    insert_hold,
    measure_phases,
    without_dust,
    without_excess,
)
from segfmu.kernels.roots import root_share


def stretch_phases(phases: 'float[:,:]', count: int, factor: float) -> None:
    """Stretch phases that begin and end at rest in time; the distance stays (section 3.2)."""
    for i in range(count):
        phases[i, 0] = phases[i, 0] * factor
        phases[i, 1] = phases[i, 1] * factor
        phases[i, 2] = phases[i, 2] / (factor * factor)
        phases[i, 3] = phases[i, 3] / (factor * factor)


def fit_duration(phases: 'float[:,:]', count: int, target: float) -> None:
    """Remove the rounding error of the total duration, which two averaged profiles must share."""
    total = 0.0
    for i in range(count):
        total = total + phases[i, 0]
    for i in range(count):
        phases[i, 0] = phases[i, 0] * (target / total)
        phases[i, 1] = phases[i, 1] * (target / total)


def timed_cruise(
    phases: 'float[:,:]',
    cruise: float,
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    top: float,
    ramp: 'float[:]',
) -> 'tuple[int, float, float]':
    """The paper's form with the cruise that makes it last `target`.

    Returns the number of phases, the distance, and the duration of the cruise, which is
    negative where the form takes longer; the number is -1 where it does not exist.
    """
    count, row, duration, y = cruise_form(phases, cruise, v, a, w, b, top, ramp)
    if count < 0:
        return -1, 0.0, -1.0
    hold = target - duration
    count = insert_hold(phases, count, row, 0.0, hold)
    return count, y + cruise * hold, hold


def cruise_range(
    phases: 'float[:,:]',
    middle: float,
    y: float,
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
) -> float:
    """A cruise velocity that leaves a cruise and, if there is one, passes the distance.

    The cruise velocity `middle` leaves a cruise and covers y; from there the search goes to the
    velocity limit on the side of the distance. Without such a velocity, the last one that leaves a
    cruise is returned.
    """
    outside = velocity_limit
    if y > distance:
        outside = -velocity_limit
    inside = middle
    trial = outside
    for i in range(30):
        count, y_trial, hold = timed_cruise(phases, trial, target, v, a, w, b, top, ramp)
        if count >= 0 and hold >= 0.0:
            inside = trial
            if i == 0 or (y_trial - distance) * (y - distance) <= 0.0:
                break
        else:
            outside = trial
        trial = 0.5 * (inside + outside)
        if trial == inside or trial == outside:
            break
    return inside


def keep_nearest(
    trial: 'float[:,:]',
    count: int,
    target: float,
    v: float,
    w: float,
    distance: float,
    velocity_limit: float,
    found: 'float[:]',
    below: 'float[:,:]',
    above: 'float[:,:]',
    ramp: 'float[:]',
) -> None:
    """Keep a profile that lasts `target` if it is the nearest one below or above the distance.

    found = number of phases below, their distance, number above, their distance.
    """
    if count <= 0:
        return
    duration, y, end, lowest, highest = measure_phases(trial, count, v, ramp)
    most = velocity_limit * (1.0 + 1e-12)
    if lowest < -most or highest > most:
        return
    if abs(duration - target) > 3e-11 * target or abs(end - w) > 1e-11 * velocity_limit:
        return
    if y <= distance and (found[0] == 0.0 or y > found[1]):
        copy_phases(trial, below, count)
        found[0] = count
        found[1] = y
    if y >= distance and (found[2] == 0.0 or y < found[3]):
        copy_phases(trial, above, count)
        found[2] = count
        found[3] = y


def between_cruises(
    lower: float,
    y_lower: float,
    upper: float,
    y_upper: float,
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
    found: 'float[:]',
    below: 'float[:,:]',
    above: 'float[:,:]',
    trial: 'float[:,:]',
) -> None:
    """Close in on the cruise velocity that covers the distance."""
    newest = upper
    other = lower
    before = lower
    e_newest = y_upper - distance
    e_other = y_lower - distance
    e_before = e_other
    rounding = 2e-15 * (abs(distance) + (abs(v) + abs(w)) * target)
    for i in range(100):
        if e_newest == 0.0 or e_other == 0.0:
            return
        share = root_share(newest, other, before, e_newest, e_other, e_before)
        cruise = newest + share * (other - newest)
        if cruise == newest or cruise == other:
            return
        count, y, hold = timed_cruise(trial, cruise, target, v, a, w, b, top, ramp)
        keep_nearest(
            trial, count, target, v, w, distance, velocity_limit, found, below, above, ramp
        )
        error = y - distance
        if abs(error) <= rounding:
            return
        before = newest
        e_before = e_newest
        if error * e_newest < 0.0:
            before = other
            e_before = e_other
            other = newest
            e_other = e_newest
        newest = cruise
        e_newest = error


def timed_between(
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
    found: 'float[:]',
    below: 'float[:,:]',
    above: 'float[:,:]',
    trial: 'float[:,:]',
) -> None:
    """Nearest profiles below and above the distance, from boundary states taken as they are."""
    clipped = min(max(distance / target, min(v, w)), max(v, w))
    for start in range(3):
        middle = clipped
        if start == 1:
            middle = velocity_limit
        elif start == 2:
            middle = -velocity_limit
        count, y, hold = timed_cruise(trial, middle, target, v, a, w, b, top, ramp)
        if count < 0 or hold < 0.0:
            continue
        keep_nearest(
            trial, count, target, v, w, distance, velocity_limit, found, below, above, ramp
        )
        edge = cruise_range(
            trial, middle, y, target, v, a, w, b, distance, velocity_limit, top, ramp
        )
        count, y_edge, hold = timed_cruise(trial, edge, target, v, a, w, b, top, ramp)
        keep_nearest(
            trial, count, target, v, w, distance, velocity_limit, found, below, above, ramp
        )
        if found[0] > 0.0 and found[2] > 0.0:
            between_cruises(
                middle, y, edge, y_edge, target, v, a, w, b, distance, velocity_limit, top, ramp,
                found, below, above, trial,
            )
            return
    for branch in range(4):
        reverse = branch == 1 or branch == 2
        mirror = branch >= 2
        for which in range(2):
            count = tempered_form(
                trial, reverse, mirror, which, target, v, a, w, b, distance, velocity_limit,
                top, ramp,
            )
            if count < 0:
                break
            keep_nearest(
                trial, count, target, v, w, distance, velocity_limit, found, below, above, ramp
            )


def timed_profile(
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    distance: float,
    velocity_limit: float,
    top: float,
    ramp: 'float[:]',
    found: 'float[:]',
    below: 'float[:,:]',
    above: 'float[:,:]',
    trial: 'float[:,:]',
) -> float:
    """Profiles that last `target`; returns the weight of `above`, or -1 if none is feasible.

    The motion is (1 - weight) * below + weight * above; found[0] and found[2] are the numbers
    of phases of the two (12 rows each). Where none is feasible, found[4] is the least distance by
    which a profile that lasts `target` misses, or 0 if there is no such profile.
    """
    v = without_excess(v, velocity_limit)
    w = without_excess(w, velocity_limit)
    a = without_excess(a, top)
    b = without_excess(b, top)
    distance = without_dust(distance, velocity_limit * velocity_limit / top)
    found[4] = 0.0
    for variant in range(4):
        first = 0
        last = 0
        brake_start = variant == 1 or variant == 3
        brake_end = variant >= 2
        if (brake_start and a == 0.0) or (brake_end and b == 0.0):
            continue
        time = target
        rest = distance
        v1 = v
        a1 = a
        w1 = w
        b1 = b
        if brake_start:
            first, duration, y, v1 = brake(v, a, velocity_limit, top, ramp, trial)
            if first < 0:
                return -1.0
            time = time - duration
            rest = rest - y
            a1 = 0.0
        if brake_end:
            last, duration, y, w1 = brake(w, -b, velocity_limit, top, ramp, trial)
            if last < 0:
                return -1.0
            time = time - duration
            rest = rest - y
            b1 = 0.0
        # 12 rows hold seven phases between them
        if time <= 0.0 or first + last > 5:
            continue
        found[0] = 0.0
        found[2] = 0.0
        timed_between(
            time, v1, a1, w1, b1, rest, velocity_limit, top, ramp, found, below, above, trial
        )
        if found[0] > 0.0 and found[2] > 0.0:
            span = found[3] - found[1]
            weight = 0.0
            # one profile is enough when it misses the distance by no more than rounding
            tiny = 1e-14 * (abs(rest) + velocity_limit * time)
            if found[3] - rest <= tiny:
                weight = 1.0
            if rest - found[1] > tiny and weight < 1.0:
                weight = (rest - found[1]) / span
            found[0] = surround(
                below, int(found[0]), brake_start, v, a, brake_end, w, b, velocity_limit, top,
                ramp, trial,
            )
            found[2] = surround(
                above, int(found[2]), brake_start, v, a, brake_end, w, b, velocity_limit, top,
                ramp, trial,
            )
            fit_duration(below, int(found[0]), target)
            fit_duration(above, int(found[2]), target)
            return weight
        missed = 0.0
        if found[0] > 0.0:
            missed = rest - found[1]
        elif found[2] > 0.0:
            missed = found[3] - rest
        if missed > 0.0 and (found[4] == 0.0 or missed < found[4]):
            found[4] = missed
    return -1.0
