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

from segfmu.kernels.planner.braking import braked, surround
from segfmu.kernels.planner.merged import tempered_form
from segfmu.kernels.planner.phases import without_dust, without_excess
from segfmu.kernels.planner.timed_cruise import (
    between_cruises,
    cruise_range,
    keep_nearest,
    scan_cruises,
    timed_cruise,
)


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
