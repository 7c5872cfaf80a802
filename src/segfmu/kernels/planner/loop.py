"""Profiles of two levels next to a single ramp: between, above or below the end accelerations.

A short motion between moving states may only have time for a few small changes of its acceleration.
Its profile is ramp, level, ramp, level, ramp, with the levels anywhere: a staircase, a dip or a
pulse. Let p and q be the durations of the first and the last ramp, with the signs of their changes;
where a level reaches the acceleration limit, the rest of p or q is its hold. At p = q = 0 only the
ramp between the end accelerations is left. If it gains too little velocity, the gain is reached
along rays from there, as a longer motion gains more. Those points form a loop around p = q = 0, or
arcs of one. In its middle, the ramp between the levels is slower: its duration is what the gain
needs, with p = 0 or q = 0. Along all these arcs the distance is searched for (arcs.py).
"""

from segfmu.kernels.numerics.numbers import HALF_DIGITS, HALVINGS, LAST_DIGIT
from segfmu.kernels.numerics.roots import next_bracket, next_point
from segfmu.kernels.planner.ramp import ramp_change, ramp_duration
from segfmu.kernels.planner.records import Family, LoopArc, Problem
from segfmu.kernels.planner.sides import side_limit


def set_loop(problem: 'float[:]', axis: 'float[:]', family: 'float[:]') -> float:
    """Set the family of a problem; returns the velocity that the single ramp misses [m/s].

    The problem is mirrored if the single ramp gains too much.
    """
    v, a, w, b = problem[Problem.V], problem[Problem.A], problem[Problem.W], problem[Problem.B]
    single, slope = ramp_duration(abs(b - a), axis)
    missing = w - v - 0.5 * (a + b) * single
    sign = -1.0 if missing < 0.0 else 1.0
    family[Family.V] = sign * v
    family[Family.A] = sign * a
    family[Family.W] = sign * w
    family[Family.B] = sign * b
    family[Family.BY_TIME] = 0.0
    family[Family.TARGET] = sign * problem[Problem.DISTANCE]
    top = side_limit(2, sign, axis)
    bottom = side_limit(2, -sign, axis)
    family[Family.TOP] = top
    family[Family.BOTTOM] = bottom
    family[Family.START_VELOCITY] = v
    family[Family.REVERSE] = 0.0
    family[Family.MIRROR] = 0.5 - 0.5 * sign
    family[Family.FIRST_UP], slope = ramp_duration(top - sign * a, axis)
    family[Family.FIRST_DOWN], slope = ramp_duration(bottom + sign * a, axis)
    family[Family.LAST_UP], slope = ramp_duration(top - sign * b, axis)
    family[Family.LAST_DOWN], slope = ramp_duration(bottom + sign * b, axis)
    return sign * missing


def level_from(
    a: float, time: float, up: float, down: float, family: 'float[:]', axis: 'float[:]'
) -> 'tuple[float, float, float]':
    """The ramp from a that takes `time`, downwards if negative: its duration, hold, and level.

    up and down are the durations of the ramps to the limits.
    """
    if time >= up:
        return up, time - up, family[Family.TOP]
    if -time >= down:
        return down, -time - down, -family[Family.BOTTOM]
    change, slope = ramp_change(abs(time), axis)
    if time < 0.0:
        return -time, 0.0, a - change
    return time, 0.0, a + change


def set_point(place: float, radius: float, family: 'float[:]', axis: 'float[:]') -> float:
    """Set a member of the family; returns how much it gains too much [m/s].

    radius is |p| + |q|; the place along the loop is 0 for p = radius, 1 for q = radius, and so on.
    """
    part = place
    p_sign, q_sign = 1.0, 1.0
    if place >= 3.0:
        part = 4.0 - place
        q_sign = -1.0
    elif place >= 2.0:
        part = place - 2.0
        p_sign, q_sign = -1.0, -1.0
    elif place >= 1.0:
        part = 2.0 - place
        p_sign = -1.0
    a, b = family[Family.A], family[Family.B]
    t1, hold1, level1 = level_from(
        a, p_sign * radius * (1.0 - part), family[Family.FIRST_UP], family[Family.FIRST_DOWN],
        family, axis,
    )
    t3, hold2, level2 = level_from(
        b, q_sign * radius * part, family[Family.LAST_UP], family[Family.LAST_DOWN], family, axis
    )
    t2, slope = ramp_duration(abs(level2 - level1), axis)
    family[Family.FIRST_TIME] = t1
    family[Family.FIRST_HOLD] = hold1
    family[Family.FIRST_LEVEL] = level1
    family[Family.SECOND_HOLD] = hold2
    family[Family.SECOND_LEVEL] = level2
    family[Family.LAST_TIME] = t3
    gain = 0.5 * ((a + level1) * t1 + (level1 + level2) * t2 + (level2 + b) * t3)
    gain = gain + level1 * hold1 + level2 * hold2
    return gain - (family[Family.W] - family[Family.V])


def loop_radius(
    arc: int, place: float, accuracy: float, missing: float, largest: float, family: 'float[:]',
    axis: 'float[:]',
) -> float:
    """The radius at which the velocity is reached at a place, and that member; -1: none.

    arc: LOOP for the least such radius, FOLD for the next one. accuracy: of the velocity, as a
    share of what is missing; 0: up to rounding.
    """
    lower = 0.0
    e_lower = -missing
    upper = max(0.25 * missing / family[Family.TOP], HALF_DIGITS * largest)
    upper = min(upper, 0.25 * largest)
    e_upper = set_point(place, upper, family, axis)
    while e_upper < 0.0 or arc == LoopArc.FOLD:
        if not upper < largest:
            return -1.0
        lower = upper
        e_lower = e_upper
        upper = min(2.0 * upper, largest)
        e_upper = set_point(place, upper, family, axis)
        if arc == LoopArc.FOLD and e_lower >= 0.0 and e_upper < 0.0:
            break
    newest, other, before = upper, lower, lower
    e_newest, e_other, e_before = e_upper, e_lower, e_lower
    scale = abs(family[Family.V]) + abs(family[Family.W]) + missing
    most = max(LAST_DIGIT * scale, accuracy * missing)
    for i in range(HALVINGS):
        if abs(e_newest) <= most or abs(other - newest) <= LAST_DIGIT * newest:
            break
        radius = next_point(newest, other, before, e_newest, e_other, e_before)
        error = set_point(place, radius, family, axis)
        newest, other, before, e_newest, e_other, e_before = next_bracket(
            error * e_newest < 0.0, radius, error, newest, other, e_newest, e_other
        )
    return newest


def slow_middle(place: float, radius: float, family: 'float[:]', axis: 'float[:]') -> bool:
    """Set the member with one of p and q zero (as in `set_point`) whose second ramp is slow."""
    error = set_point(place, radius, family, axis)
    level1, level2 = family[Family.FIRST_LEVEL], family[Family.SECOND_LEVEL]
    fastest, slope = ramp_duration(abs(level2 - level1), axis)
    mean = 0.5 * (level1 + level2)
    if fastest <= 0.0:
        return False
    if mean != 0.0:
        stretch = 1.0 - error / (mean * fastest)
    elif family[Family.BY_TIME] != 0.0 and radius == 0.0 and error == 0.0:
        # the velocity does not tell how slow the ramp is
        stretch = family[Family.TARGET] / fastest
    else:
        return False
    family[Family.STRETCH] = stretch
    return stretch >= 1.0
