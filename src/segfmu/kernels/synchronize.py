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

from segfmu.kernels.braking import braked, surround
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


def cruise_edge(
    inside: float,
    outside: float,
    phases: 'float[:,:]',
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    top: float,
    ramp: 'float[:]',
) -> float:
    """Bisect between a velocity that leaves a cruise and one that does not."""
    for i in range(30):
        trial = 0.5 * (inside + outside)
        count, y, hold = timed_cruise(phases, trial, target, v, a, w, b, top, ramp)
        if count >= 0 and hold >= 0.0:
            inside = trial
        else:
            outside = trial
    return inside


def scan_cruises(
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
    """Nearest profiles with a cruise, looked for over all cruise velocities.

    Those that leave a cruise can form several windows.
    """
    samples = 24
    inside = False
    before = 0.0
    for i in range(samples + 1):
        cruise = velocity_limit * (2.0 * i / samples - 1.0)
        count, y, hold = timed_cruise(trial, cruise, target, v, a, w, b, top, ramp)
        fits = count >= 0 and hold >= 0.0
        if i > 0 and (inside or fits):
            lower = before
            upper = cruise
            if not inside:
                lower = cruise_edge(cruise, before, trial, target, v, a, w, b, top, ramp)
            if not fits:
                upper = cruise_edge(before, cruise, trial, target, v, a, w, b, top, ramp)
            count, y_lower, hold = timed_cruise(trial, lower, target, v, a, w, b, top, ramp)
            keep_nearest(
                trial, count, target, v, w, distance, velocity_limit, found, below, above, ramp
            )
            count, y_upper, hold = timed_cruise(trial, upper, target, v, a, w, b, top, ramp)
            keep_nearest(
                trial, count, target, v, w, distance, velocity_limit, found, below, above, ramp
            )
            if (y_lower - distance) * (y_upper - distance) <= 0.0:
                between_cruises(
                    lower, y_lower, upper, y_upper, target, v, a, w, b, distance,
                    velocity_limit, top, ramp, found, below, above, trial,
                )
            if found[0] > 0.0 and found[2] > 0.0:
                return
        inside = fits
        before = cruise


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
    middle = min(max(distance / target, min(v, w)), max(v, w))
    count, y, hold = timed_cruise(trial, middle, target, v, a, w, b, top, ramp)
    if count >= 0 and hold >= 0.0:
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
    scan_cruises(
        target, v, a, w, b, distance, velocity_limit, top, ramp, found, below, above, trial
    )
    if found[0] > 0.0 and found[2] > 0.0:
        return
    for branch in range(4):
        reverse = branch == 1 or branch == 2
        mirror = branch >= 2
        for which in range(2):
            count = tempered_form(
                trial, reverse, mirror, which, True, target, v, a, w, b, distance,
                velocity_limit, top, ramp,
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
    of phases of the two (13 rows each).
    """
    v = without_excess(v, velocity_limit)
    w = without_excess(w, velocity_limit)
    a = without_excess(a, top)
    b = without_excess(b, top)
    distance = without_dust(distance, velocity_limit * velocity_limit / top)
    for variant in range(4):
        taken, spent, rest, v1, a1, w1, b1 = braked(
            variant, v, a, w, b, distance, velocity_limit, top, ramp, trial
        )
        if taken == -3:
            continue
        if taken < 0:
            return -1.0
        time = target - spent
        if time <= 0.0:
            continue
        brake_start = variant % 2 == 1
        brake_end = variant >= 2
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
    return -1.0
