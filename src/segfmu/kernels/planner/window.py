"""When a motion whose acceleration keeps its sign is possible between two states, at the latest.

It gains its velocity at most as late, or as early, as the limits of acceleration and jerk permit.
So its distance lies between two lines in its duration.
"""

from math import sqrt

from segfmu.kernels.numerics.numbers import EQUAL, NEARLY
from segfmu.kernels.planner.ramp import ramp_distance, ramp_duration
from segfmu.kernels.planner.records import Axis, Problem
from segfmu.kernels.planner.sides import side_limit

# end accelerations on both sides of zero leave a window where one is this small beside the other;
# to look everywhere finds no more and takes an eighth of the time of short plans
SMALL = 0.2


def least_lever(c: float, gain: float, top: float, axis: 'float[:]') -> float:
    """Least integral of time and acceleration of a velocity gain [m] next to an end.

    The acceleration is c there, at most `top`, and within the limit of the jerk.
    """
    if gain <= 0.0:
        return 0.0
    jerk = axis[Axis.JERK]
    rise = (top - c) / jerk
    rest = gain - (c + 0.5 * jerk * rise) * rise
    if rest <= 0.0:
        rise = (sqrt(c * c + 2.0 * jerk * gain) - c) / jerk
        rest = 0.0
    hold = rest / top
    return (0.5 * c + jerk * rise / 3.0) * rise * rise + rest * (rise + 0.5 * hold)


def early_window(duration: float, problem: 'float[:]', axis: 'float[:]') -> float:
    """The longest duration [s] of profiles whose acceleration keeps its sign; 0 if there are none.

    Only those can take less time than the shortest profile of the other forms, whose duration is
    given: any other one can be prolonged where its acceleration is zero. Their distance lies
    between two lines in the duration: the velocity is gained as late or as early as the limits of
    acceleration and jerk permit. Where the jerk alone bounds the ramps, several of them take no
    longer than one, and staircases that do change their sign can be shorter by little, by more
    with smoothsteps: the lines are those of the velocities at the ends then.
    """
    sign = -1.0 if problem[Problem.A] + problem[Problem.B] < 0.0 else 1.0
    v = sign * problem[Problem.V]
    a = sign * problem[Problem.A]
    w = sign * problem[Problem.W]
    b = sign * problem[Problem.B]
    distance = sign * problem[Problem.DISTANCE]
    gain = w - v
    if a < 0.0 or b < 0.0 or a + b == 0.0 or axis[Axis.SMOOTHNESS] < 3.0:
        return 0.0
    single, slope = ramp_duration(abs(b - a), axis)
    if gain < 0.5 * (a + b) * single * (1.0 - EQUAL):
        return 0.0
    # what the ends gain at least, and where
    top = side_limit(2, sign, axis)
    jerk = axis[Axis.JERK]
    first, last, late, early = 0.0, 0.0, 0.0, 0.0
    if jerk > 0.0 and axis[Axis.LINEAR_FROM] > 0.0 and axis[Axis.PLATEAU] != 0.0:
        first = 0.5 * a * a / jerk
        last = 0.5 * b * b / jerk
        late = least_lever(b, gain - first, top, axis) - a * first / (3.0 * jerk)
        early = least_lever(a, gain - last, top, axis) - b * last / (3.0 * jerk)
    # (v + first) T + late <= distance <= (w - last) T - early, up to rounding
    rounding = NEARLY * (abs(distance) + abs(late) + abs(early))
    late = late - rounding
    early = early - rounding
    least = max(single, gain / top)
    most = duration
    slowest = v + first
    fastest = w - last
    if slowest > 0.0:
        most = min(most, (distance - late) / slowest)
    elif slowest < 0.0:
        least = max(least, (distance - late) / slowest)
    elif late > distance:
        return 0.0
    if fastest > 0.0:
        least = max(least, (distance + early) / fastest)
    elif fastest < 0.0:
        most = min(most, (distance + early) / fastest)
    elif distance + early > 0.0:
        return 0.0
    if most < least * (1.0 - NEARLY):
        return 0.0
    return min(most * (1.0 + NEARLY), duration)


def short_window(duration: float, problem: 'float[:]', axis: 'float[:]', rest: 'float[:]') -> float:
    """`early_window`, also where the accelerations at the ends have unlike signs, one being small.

    One ramp brings that one to zero. `rest` becomes the problem that is left.
    """
    a, b = problem[Problem.A], problem[Problem.B]
    if a * b >= 0.0:
        return early_window(duration, problem, axis)
    if min(abs(a), abs(b)) > SMALL * max(abs(a), abs(b)):
        return 0.0
    rest[:] = problem
    if abs(a) < abs(b):
        spent, slope = ramp_duration(abs(a), axis)
        distance = ramp_distance(problem[Problem.V], a, 0.0, spent, spent, axis)
        rest[Problem.V] = problem[Problem.V] + 0.5 * a * spent
        rest[Problem.A] = 0.0
    else:
        spent, slope = ramp_duration(abs(b), axis)
        rest[Problem.W] = problem[Problem.W] - 0.5 * b * spent
        distance = ramp_distance(rest[Problem.W], 0.0, b, spent, spent, axis)
        rest[Problem.B] = 0.0
    rest[Problem.DISTANCE] = problem[Problem.DISTANCE] - distance
    longest = early_window(duration - spent, rest, axis)
    return longest + spent if longest > 0.0 else 0.0
