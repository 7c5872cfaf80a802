"""Three ramps over two levels that last a given duration, all slowed down alike.

Slower ramps are smoother: jerk and snap fall with the second and third power of their stretch. The
stretch makes the motion last as long as asked, so two unknowns are left, the levels, for the end
velocity and the distance. Beyond the acceleration limit a level is held there, the longer the
further beyond. Newton's method begins with the extreme accelerations of the polynomial of degree
five between the states.
"""

from math import sqrt

from segfmu.kernels.numerics.numbers import CLOSE, HALF_DIGITS, NEARLY, ROUNDED, SAME, TRIES
from segfmu.kernels.planner.phases import append_change, append_hold
from segfmu.kernels.planner.ramp import ramp_distance, ramp_duration
from segfmu.kernels.planner.records import Gentle, Phase, Problem
from segfmu.kernels.planner.sides import fastest_velocity, side_limit

# starts: half the difference of the levels grows by this from one to the next
WIDER = 1.5


def polynomial_levels(problem: 'float[:]', gentle: 'float[:]') -> None:
    """Set the levels to the extreme accelerations of the polynomial of degree five."""
    duration, a = problem[Problem.DURATION], problem[Problem.A]
    square = duration * duration
    y = problem[Problem.DISTANCE] - (problem[Problem.V] + 0.5 * a * duration) * duration
    v = (problem[Problem.W] - problem[Problem.V] - a * duration) * duration
    b = (problem[Problem.B] - a) * square
    third = 10.0 * y - 4.0 * v + 0.5 * b
    fourth = -15.0 * y + 7.0 * v - b
    fifth = 6.0 * y - 3.0 * v + 0.5 * b
    # where the jerk 10 fifth s^2 + 4 fourth s + third is zero
    first = 1.0 / 3.0
    second = 2.0 / 3.0
    inner = 4.0 * fourth * fourth - 10.0 * third * fifth
    if inner > 0.0:
        root = 2.0 * fourth - sqrt(inner) if fourth < 0.0 else 2.0 * fourth + sqrt(inner)
        low = -third / root
        high = -0.1 * root / fifth if fifth != 0.0 else 2.0
        if low > high:
            last = low
            low = high
            high = last
        if low > 0.0 and low < 1.0:
            first = low
            second = 0.5 * (1.0 + low)
        if high > 0.0 and high < 1.0:
            second = high
            if not (low > 0.0 and low < 1.0):
                first = 0.5 * high
    for i in range(2):
        s = first
        if i == 1:
            s = second
        curve = s * (6.0 * third + s * (12.0 * fourth + s * 20.0 * fifth))
        gentle[Gentle.LEVELS + i] = a + curve / square


def gentle_hold(level: float, problem: 'float[:]', axis: 'float[:]') -> 'tuple[float, float]':
    """The level within the acceleration limit, and how long it is held [s]."""
    top = side_limit(2, level, axis)
    if abs(level) <= top:
        return level, 0.0
    hold = 0.5 * problem[Problem.DURATION] * (abs(level) / top - 1.0)
    if level < 0.0:
        return -top, hold
    return top, hold


def gentle_ramps(problem: 'float[:]', axis: 'float[:]', gentle: 'float[:]') -> None:
    """Set ends, holds and durations of the three ramps to the levels, and their stretch."""
    hold, total = 0.0, 0.0
    a = problem[Problem.A]
    for i in range(3):
        b = problem[Problem.B]
        held = 0.0
        if i < 2:
            b, held = gentle_hold(gentle[Gentle.LEVELS + i], problem, axis)
        duration, slope = ramp_duration(abs(b - a), axis)
        gentle[Gentle.ENDS + i] = b
        gentle[Gentle.HOLDS + i] = held
        gentle[Gentle.RAMPS + i] = duration
        total = total + duration
        hold = hold + held
        a = b
    gentle[Gentle.STRETCH] = (problem[Problem.DURATION] - hold) / total if total > 0.0 else 0.0


def gentle_errors(problem: 'float[:]', axis: 'float[:]', gentle: 'float[:]') -> float:
    """Set by how much the motion of the levels gains and covers too much; the sum of both [m/s]."""
    gentle_ramps(problem, axis, gentle)
    v = problem[Problem.V]
    y = 0.0
    a = problem[Problem.A]
    for i in range(3):
        b = gentle[Gentle.ENDS + i]
        held = gentle[Gentle.HOLDS + i]
        basis = gentle[Gentle.RAMPS + i]
        duration = basis * gentle[Gentle.STRETCH]
        if duration > 0.0:
            y = y + ramp_distance(v, a, b, duration, basis, axis)
            v = v + 0.5 * (a + b) * duration
        y = y + (v + 0.5 * b * held) * held
        v = v + b * held
        a = b
    gentle[Gentle.GAIN] = v - problem[Problem.W]
    gentle[Gentle.EXCESS] = (y - problem[Problem.DISTANCE]) / problem[Problem.DURATION]
    return abs(gentle[Gentle.GAIN]) + abs(gentle[Gentle.EXCESS])


def usual_speed(problem: 'float[:]', axis: 'float[:]') -> float:
    """About how fast a motion between the boundary states is [m/s]; the errors are relative."""
    duration = problem[Problem.DURATION]
    speed = abs(problem[Problem.V]) + abs(problem[Problem.W])
    speed = speed + (abs(problem[Problem.A]) + abs(problem[Problem.B])) * duration
    return min(fastest_velocity(axis), speed + abs(problem[Problem.DISTANCE]) / duration)


def gentle_slopes(problem: 'float[:]', axis: 'float[:]', gentle: 'float[:]') -> bool:
    """Set the derivatives of both errors with the levels, from differences; False: all are zero."""
    gain, excess = gentle[Gentle.GAIN], gentle[Gentle.EXCESS]
    change = HALF_DIGITS * max(abs(gentle[Gentle.LEVELS]), abs(gentle[Gentle.LEVELS + 1]))
    if change == 0.0:
        return False
    for i in range(2):
        kept = gentle[Gentle.LEVELS + i]
        gentle[Gentle.LEVELS + i] = kept + change
        gentle_errors(problem, axis, gentle)
        gentle[Gentle.LEVELS + i] = kept
        gentle[Gentle.GAIN_SLOPES + i] = (gentle[Gentle.GAIN] - gain) / change
        gentle[Gentle.EXCESS_SLOPES + i] = (gentle[Gentle.EXCESS] - excess) / change
    gentle[Gentle.GAIN] = gain
    gentle[Gentle.EXCESS] = excess
    return True


def gentle_step(gentle: 'float[:]') -> bool:
    """Set Newton's step of the levels; False if there is none."""
    gain, excess, g1 = gentle[Gentle.GAIN], gentle[Gentle.EXCESS], gentle[Gentle.GAIN_SLOPES]
    g2 = gentle[Gentle.GAIN_SLOPES + 1]
    e1 = gentle[Gentle.EXCESS_SLOPES]
    e2 = gentle[Gentle.EXCESS_SLOPES + 1]
    determinant = g1 * e2 - g2 * e1
    if not abs(determinant) > NEARLY * (abs(g1 * e2) + abs(g2 * e1)):
        return False
    gentle[Gentle.STEPS] = (g2 * excess - e2 * gain) / determinant
    gentle[Gentle.STEPS + 1] = (e1 * gain - g1 * excess) / determinant
    return True


def spread_levels(attempt: int, gentle: 'float[:]') -> None:
    """Move the levels apart, or past each other, for another attempt of Newton's method."""
    middle = 0.5 * (gentle[Gentle.LEVELS] + gentle[Gentle.LEVELS + 1])
    half = 0.5 * (gentle[Gentle.LEVELS] - gentle[Gentle.LEVELS + 1])
    factor = WIDER * attempt + 1.0
    if attempt % 2 == 0:
        factor = -factor
    half = factor * half
    gentle[Gentle.LEVELS] = middle + half
    gentle[Gentle.LEVELS + 1] = middle - half


def take_levels(share: float, gentle: 'float[:]') -> None:
    """Add a share of Newton's step to the levels."""
    for i in range(2):
        gentle[Gentle.LEVELS + i] = gentle[Gentle.LEVELS + i] + share * gentle[Gentle.STEPS + i]


def solve_gentle(attempt: int, problem: 'float[:]', axis: 'float[:]', gentle: 'float[:]') -> bool:
    """Set the levels (Gentle) that lead to the end velocity and distance; False if none is found.

    Each attempt, 0 to 5, begins elsewhere.
    """
    polynomial_levels(problem, gentle)
    if attempt > 0:
        spread_levels(attempt, gentle)
    error = gentle_errors(problem, axis, gentle)
    speed = usual_speed(problem, axis)
    # close to the root the derivatives of the step before do as well
    close = CLOSE * speed
    for i in range(TRIES):
        if (i == 0 or error > close) and not gentle_slopes(problem, axis, gentle):
            return False
        if not gentle_step(gentle):
            return False
        share = 1.0
        reached = error
        for j in range(4):
            take_levels(share, gentle)
            reached = gentle_errors(problem, axis, gentle)
            if reached < error:
                break
            take_levels(-share, gentle)
            share = 0.5 * share
        if not reached < error:
            # the ramps are those of a step that was taken back
            error = gentle_errors(problem, axis, gentle)
            break
        error = reached
        if error <= ROUNDED * speed:
            break
    return error <= SAME * speed


def write_gentle(
    phases: 'float[:,:]', problem: 'float[:]', axis: 'float[:]', gentle: 'float[:]'
) -> int:
    """Write the ramps as phases; their number."""
    count = 0
    a = problem[Problem.A]
    for i in range(3):
        b = gentle[Gentle.ENDS + i]
        used = append_change(phases, count, a, b, axis)
        if used > count:
            phases[count, Phase.DURATION] = phases[count, Phase.BASIS] * gentle[Gentle.STRETCH]
        count = append_hold(phases, used, b, gentle[Gentle.HOLDS + i])
        a = b
    return count
