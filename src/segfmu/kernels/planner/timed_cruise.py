"""The paper's form with prescribed duration: its cruise velocity is what covers the distance.

A cruise velocity fits when the velocity changes to and from it leave time for a cruise. The fitting
ones form one or several windows; within a window the distance is continuous.
"""

from segfmu.kernels.numerics.roots import root_share
from segfmu.kernels.planner.cruise import cruise_form
from segfmu.kernels.planner.phases import copy_phases, insert_hold, measure_phases


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
    most = velocity_limit * (1.0 + 1e-12)
    duration, y, end, lowest, highest = measure_phases(trial, count, v, most, ramp)
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
