"""Searches along the canonical family of levels.py: by the distance, and by the duration."""

from segfmu.kernels.numerics.roots import root_share
from segfmu.kernels.planner.levels import canonical_point
from segfmu.kernels.planner.transition import ramp_duration


def window_edge(
    halvings: int,
    inside: float,
    outside: float,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    ramp: 'float[:]',
) -> float:
    """Bisect between a parameter that has a canonical member and one that has none."""
    for i in range(halvings):
        middle = 0.5 * (inside + outside)
        if middle == inside or middle == outside:
            break
        duration, y, t1, hold1, level1, hold2, level2, t3 = canonical_point(
            middle, v, a, w, b, high, top, t_top, ramp
        )
        if duration >= 0.0:
            inside = middle
        else:
            outside = middle
    return inside


def canonical_value(
    p: float,
    by_time: bool,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    ramp: 'float[:]',
) -> 'tuple[float, float]':
    """The searched quantity (duration or distance) of a member, and its duration or -1."""
    duration, y, t1, hold1, level1, hold2, level2, t3 = canonical_point(
        p, v, a, w, b, high, top, t_top, ramp
    )
    if by_time:
        return duration, duration
    return y, duration


def bracketed_root(
    lower: float,
    upper: float,
    f_lower: float,
    f_upper: float,
    target: float,
    by_time: bool,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    ramp: 'float[:]',
) -> float:
    """Bracketed root on the canonical family; f_lower < target <= f_upper.

    `lower` and `upper` name the values, not the order of the parameters.
    """
    a_p = upper
    a_error = f_upper - target
    b_p = lower
    b_error = f_lower - target
    c_p = lower
    c_error = b_error
    speed = abs(v) + abs(w)
    if by_time:
        speed = 0.0
    for i in range(120):
        if a_error == 0.0 or abs(a_p - b_p) <= 2e-16 * abs(a_p):
            break
        p = a_p + root_share(a_p, b_p, c_p, a_error, b_error, c_error) * (b_p - a_p)
        value, duration = canonical_value(p, by_time, v, a, w, b, high, top, t_top, ramp)
        error = value - target
        c_p = a_p
        c_error = a_error
        if error * a_error < 0.0:
            c_p = b_p
            c_error = b_error
            b_p = a_p
            b_error = a_error
        a_p = p
        a_error = error
        # what rounding leaves of a sum whose terms may cancel
        if abs(error) <= 2e-15 * (abs(target) + speed * duration):
            break
    if abs(b_error) < abs(a_error):
        return b_p
    return a_p


def first_window(
    target: float,
    f_start: float,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    t_zero: float,
    ramp: 'float[:]',
) -> 'tuple[float, float]':
    """Search the members whose second level lies between the end acceleration and zero.

    Returns the parameter or -1, and t_zero if the family goes on there, else -1: a positive
    second level gains velocity, which can leave no room for the first one. Where the motion
    starts backwards the distance can rise and fall again, so the members between are looked at.
    """
    if v < 0.0:
        samples = 8
        lower = 0.0
        f_lower = f_start
        for i in range(1, samples):
            p = t_zero * i / samples
            value, duration = canonical_value(p, False, v, a, w, b, high, top, t_top, ramp)
            if duration < 0.0:
                break
            if value >= target and value > f_lower:
                return bracketed_root(
                    lower, p, f_lower, value, target, False, v, a, w, b, high, top, t_top, ramp
                ), t_zero
            lower = p
            f_lower = value
    value, duration = canonical_value(t_zero, False, v, a, w, b, high, top, t_top, ramp)
    end = t_zero
    if duration < 0.0:
        end = window_edge(80, 0.0, t_zero, v, a, w, b, high, top, t_top, ramp)
        value, duration = canonical_value(end, False, v, a, w, b, high, top, t_top, ramp)
    going_on = -1.0
    if end == t_zero:
        going_on = t_zero
    if value >= target and value > f_start:
        p = bracketed_root(
            0.0, end, f_start, value, target, False, v, a, w, b, high, top, t_top, ramp
        )
        return p, going_on
    return -1.0, going_on


def dip(
    target: float,
    f_start: float,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    ramp: 'float[:]',
) -> float:
    """Parameter of a member that covers less than the first one, and just the target; or -1.

    Going on for longer covers less distance while the velocity in between is negative.
    """
    samples = 12
    span, rise, slope = ramp_duration(top, ramp)
    for i in range(1, samples + 1):
        p = max(t_top, span) * i * i / (samples * samples)
        value, duration = canonical_value(p, False, v, a, w, b, high, top, t_top, ramp)
        if duration < 0.0:
            return -1.0
        if value <= target:
            return bracketed_root(
                p, 0.0, value, f_start, target, False, v, a, w, b, high, top, t_top, ramp
            )
    return -1.0


def canonical_search(
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    ramp: 'float[:]',
) -> float:
    """Parameter of the first canonical member that covers the target distance, or -1."""
    f_lower, duration = canonical_value(0.0, False, v, a, w, b, high, top, t_top, ramp)
    if duration < 0.0:
        return -1.0
    # a target that only rounding keeps from the first member is met by it
    if abs(f_lower - target) <= 1e-14 * (abs(target) + (abs(v) + abs(w)) * duration):
        return 0.0
    if f_lower > target:
        if v >= 0.0 and w >= 0.0:
            return -1.0
        return dip(target, f_lower, v, a, w, b, high, top, t_top, ramp)
    lower = 0.0
    if b > 0.0:
        t_zero, rise, slope = ramp_duration(b, ramp)
        p, lower = first_window(
            target, f_lower, v, a, w, b, high, top, t_top, t_zero, ramp
        )
        if p >= 0.0:
            return p
        if lower < 0.0:
            upper = t_top
            value, duration = canonical_value(upper, False, v, a, w, b, high, top, t_top, ramp)
            for i in range(60):
                if duration >= 0.0:
                    break
                upper = 2.0 * upper
                value, duration = canonical_value(
                    upper, False, v, a, w, b, high, top, t_top, ramp
                )
            lower = window_edge(80, upper, t_zero, v, a, w, b, high, top, t_top, ramp)
        f_lower, duration = canonical_value(lower, False, v, a, w, b, high, top, t_top, ramp)
        if f_lower > target:
            return -1.0
    # where the last acceleration is at its limit, t_top is no scale of the family
    span, rise, slope = ramp_duration(top, ramp)
    upper = max(t_top, span)
    if upper <= lower:
        upper = 2.0 * lower
    for i in range(200):
        f_upper, duration = canonical_value(upper, False, v, a, w, b, high, top, t_top, ramp)
        if f_upper >= target:
            return bracketed_root(
                lower, upper, f_lower, f_upper, target, False, v, a, w, b, high, top, t_top, ramp
            )
        lower = upper
        f_lower = f_upper
        upper = 2.0 * upper
    return -1.0


def member_search(
    which: int,
    by_time: bool,
    scale: float,
    target: float,
    v: float,
    a: float,
    w: float,
    b: float,
    high: float,
    top: float,
    t_top: float,
    ramp: 'float[:]',
) -> float:
    """Parameter of the which-th canonical member (from 0) of a duration or distance, or -1.

    Neither is monotone along the family: the duration falls and rises again where a first level
    that takes long to come back from is traded for a shorter one, the distance while the velocity
    in between is negative. So the members are looked at one by one, up to nine times `scale`.
    """
    found = 0
    previous = 0.0
    lower = -1.0
    f_lower = 0.0
    p = 0.0
    for i in range(36):
        p = scale * i * i / 144.0
        value, duration = canonical_value(p, by_time, v, a, w, b, high, top, t_top, ramp)
        upper = p
        inside = duration >= 0.0
        if inside and lower < 0.0 and i > 0:
            lower = window_edge(24, p, previous, v, a, w, b, high, top, t_top, ramp)
            f_lower, duration = canonical_value(
                lower, by_time, v, a, w, b, high, top, t_top, ramp
            )
        if not inside and lower >= 0.0:
            upper = window_edge(24, lower, p, v, a, w, b, high, top, t_top, ramp)
            value, duration = canonical_value(
                upper, by_time, v, a, w, b, high, top, t_top, ramp
            )
        if lower >= 0.0 and (f_lower - target) * (value - target) <= 0.0 and value != f_lower:
            if found == which and value > f_lower:
                return bracketed_root(
                    lower, upper, f_lower, value, target, by_time, v, a, w, b, high, top, t_top,
                    ramp,
                )
            if found == which:
                return bracketed_root(
                    upper, lower, value, f_lower, target, by_time, v, a, w, b, high, top, t_top,
                    ramp,
                )
            found = found + 1
        lower = -1.0
        if inside:
            lower = p
            f_lower = value
            if i > 12 and value > target:
                return -1.0
        previous = p
    return -1.0
