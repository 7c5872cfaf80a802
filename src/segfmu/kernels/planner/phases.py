"""Lists of phases: rows of the record `Phase`."""

from segfmu.kernels.numerics.numbers import EQUAL, NEVER, SAME
from segfmu.kernels.planner.ramp import ramp_change, ramp_distance, ramp_duration
from segfmu.kernels.planner.ramp_peak import extreme_gain, ramp_extreme_velocity
from segfmu.kernels.planner.records import Axis, Phase, Problem
from segfmu.kernels.planner.sides import (
    fastest_velocity,
    is_beyond,
    side_limit,
    slowest_velocity,
    top_acceleration,
)

# powers up to the sixth of what is smaller beside its scale would underflow
TINY = 1e-30


def flush_tiny(value: float, scale: float) -> float:
    """The value, or 0 if it is so small relative to its scale that its powers would underflow."""
    return 0.0 if abs(value) <= TINY * scale else value


def boundary_value(value: float, lower: float, upper: float) -> float:
    """A boundary value, set to zero if tiny, clamped if it exceeds a limit by rounding.

    lower, upper: the limits in both directions.
    """
    return min(max(flush_tiny(value, max(lower, upper)), -lower), upper)


def append_phase(
    phases: 'float[:,:]', count: int, duration: float, basis: float, start: float, change: float,
    above: float,
) -> int:
    """Append a phase (Phase); nothing if it has no duration. Returns the number of phases."""
    if duration <= 0.0:
        return count
    phases[count, Phase.DURATION] = duration
    phases[count, Phase.BASIS] = basis
    phases[count, Phase.ACCELERATION] = start
    phases[count, Phase.CHANGE] = change
    phases[count, Phase.ABOVE] = above
    return count + 1


def append_ramp(
    phases: 'float[:,:]', count: int, a: float, b: float, duration: float, axis: 'float[:]'
) -> int:
    """Append the ramp from a to b with a computed duration; nothing if that is zero.

    The change follows from the duration, not from b - a: the rounding error of that difference
    would be large against a small change, and break the limits of the ramp.
    """
    if duration <= 0.0:
        return count
    change, slope = ramp_change(duration, axis)
    if b < a:
        change = -change
    return append_phase(phases, count, duration, duration, a, change, 0.0)


def append_change(phases: 'float[:,:]', count: int, a: float, b: float, axis: 'float[:]') -> int:
    """Append the fastest ramp from a to b; nothing if they are equal."""
    duration, slope = ramp_duration(abs(b - a), axis)
    return append_phase(phases, count, duration, duration, a, b - a, 0.0)


def append_hold(phases: 'float[:,:]', count: int, a: float, duration: float) -> int:
    """Append a phase of constant acceleration; nothing if it has no duration."""
    return append_phase(phases, count, duration, 0.0, a, 0.0, 0.0)


def insert_hold(phases: 'float[:,:]', count: int, row: int, a: float, duration: float) -> int:
    """Insert a phase of constant acceleration before `row`; nothing if it has no duration."""
    if duration <= 0.0:
        return count
    for j in range(count - row):
        i = count - 1 - j
        for column in range(Phase.SIZE):
            phases[i + 1, column] = phases[i, column]
    append_hold(phases, row, a, duration)
    return count + 1


def copy_phases(source: 'float[:,:]', target: 'float[:,:]', count: int) -> None:
    """Copy the first rows of a list of phases."""
    for i in range(count):
        for column in range(Phase.SIZE):
            target[i, column] = source[i, column]


def join_phases(source: 'float[:,:]', count: int, phases: 'float[:,:]', used: int) -> int:
    """Append the first `count` rows of another list to the first `used` ones; their number."""
    for i in range(count):
        for column in range(Phase.SIZE):
            phases[used + i, column] = source[i, column]
    return used + count


def mirror_phases(phases: 'float[:,:]', count: int) -> None:
    """The same motion in the other direction."""
    for i in range(count):
        phases[i, Phase.ACCELERATION] = -phases[i, Phase.ACCELERATION]
        phases[i, Phase.CHANGE] = -phases[i, Phase.CHANGE]


def reverse_phases(phases: 'float[:,:]', first: int, count: int) -> None:
    """The same path run from its end, velocities kept: accelerations change their sign.

    y(t) becomes -y(T - t); rows first .. count - 1 are reversed.
    """
    for i in range((count - first) // 2):
        for column in range(Phase.SIZE):
            kept = phases[first + i, column]
            phases[first + i, column] = phases[count - 1 - i, column]
            phases[count - 1 - i, column] = kept
    for i in range(first, count):
        # a ramp from a to a + d, run backwards with the sign changed, goes from -(a + d) to -a
        end = phases[i, Phase.ACCELERATION] + phases[i, Phase.CHANGE]
        phases[i, Phase.ACCELERATION] = -end
        if phases[i, Phase.ABOVE] == 1.0:
            # of the jerk: from a + d to a
            phases[i, Phase.ACCELERATION] = end
            phases[i, Phase.CHANGE] = -phases[i, Phase.CHANGE]


def boundary_problem(problem: 'float[:]', axis: 'float[:]', cleaned: 'float[:]') -> None:
    """Copy a boundary problem (Problem), rounding tiny values to zero and to limits."""
    fastest, backwards, top = axis[Axis.VELOCITY], axis[Axis.LOWER], axis[Axis.ACCELERATION]
    bottom = axis[Axis.LOWER + 1]
    cleaned[Problem.V] = boundary_value(problem[Problem.V], backwards, fastest)
    cleaned[Problem.A] = boundary_value(problem[Problem.A], bottom, top)
    cleaned[Problem.W] = boundary_value(problem[Problem.W], backwards, fastest)
    cleaned[Problem.B] = boundary_value(problem[Problem.B], bottom, top)
    velocity = fastest_velocity(axis)
    acceleration = top_acceleration(axis)
    # of limits that are far apart, the smaller scale is that of motions which are possible
    ramp = acceleration * axis[Axis.FULL_RAMP] * axis[Axis.FULL_RAMP]
    scale = min(velocity * velocity / acceleration, ramp)
    cleaned[Problem.DISTANCE] = flush_tiny(problem[Problem.DISTANCE], scale)
    cleaned[Problem.DURATION] = problem[Problem.DURATION]


def steepest_acceleration(duration: float, problem: 'float[:]', axis: 'float[:]') -> float:
    """Bound [m/s2] of the accelerations in motions between the boundary states."""
    # half of the time leads there, the other half back
    change, slope = ramp_change(0.5 * duration, axis)
    steepest = max(abs(problem[Problem.A]), abs(problem[Problem.B])) + change
    return min(steepest, top_acceleration(axis))


def speed_bound(sign: float, duration: float, problem: 'float[:]', axis: 'float[:]') -> float:
    """Bound [m/s] of the velocities in motions between the boundary states that last a duration.

    In the direction of a sign it is the velocity limit, unless that is beyond what the other limits
    permit in that time.
    """
    steepest = steepest_acceleration(duration, problem, axis)
    # half of the time leads there, the other half back
    most = max(abs(problem[Problem.V]), abs(problem[Problem.W])) + steepest * 0.5 * duration
    return min(side_limit(1, sign, axis), most)


def is_resting(problem: 'float[:]', axis: 'float[:]') -> bool:
    """Whether both boundary states are at rest."""
    speed = abs(problem[Problem.V]) + abs(problem[Problem.W])
    if flush_tiny(speed, fastest_velocity(axis)) != 0.0:
        return False
    acceleration = abs(problem[Problem.A]) + abs(problem[Problem.B])
    return flush_tiny(acceleration, top_acceleration(axis)) == 0.0


def measure_phases(
    phases: 'float[:,:]', count: int, v: float, within: float, axis: 'float[:]'
) -> 'tuple[float, float, float, float, float]':
    """Duration, distance, end velocity, lowest and highest velocity of a list of phases.

    v is the velocity at the start. Peaks inside ramps are ignored if they are surely within
    +-`within`, as all are within NEVER.
    """
    total, y = 0.0, 0.0
    lowest = v
    highest = v
    for i in range(count):
        duration, basis = phases[i, Phase.DURATION], phases[i, Phase.BASIS]
        a = phases[i, Phase.ACCELERATION]
        b = a + phases[i, Phase.CHANGE]
        if a * b < 0.0 and within < NEVER:
            # a quick bound first
            near = v + 0.5 * (a + b) * duration if abs(a) > abs(b) else v
            bound = near + extreme_gain(a, b, duration, basis, axis)
            if a < 0.0:
                bound = 2.0 * near - bound
            if bound > max(highest, within) or bound < min(lowest, -within):
                extreme = ramp_extreme_velocity(v, a, b, duration, basis, axis)
                lowest = min(lowest, extreme)
                highest = max(highest, extreme)
        y = y + ramp_distance(v, a, b, duration, basis, axis)
        v = v + 0.5 * (a + b) * duration
        lowest = min(lowest, v)
        highest = max(highest, v)
        total = total + duration
    return total, y, v, lowest, highest


def total_duration(phases: 'float[:,:]', count: int) -> float:
    """Sum of the durations of phases [s]."""
    total = 0.0
    for i in range(count):
        total = total + phases[i, Phase.DURATION]
    return total


def valid_duration(
    phases: 'float[:,:]', count: int, problem: 'float[:]', axis: 'float[:]'
) -> float:
    """Duration [s] of phases that join the boundary states within the velocity limit, else -1."""
    distance = problem[Problem.DISTANCE]
    most = slowest_velocity(axis) * (1.0 + EQUAL)
    duration, y, end, lowest, highest = measure_phases(
        phases, count, problem[Problem.V], most, axis
    )
    if is_beyond(lowest, highest, 1.0 + EQUAL, axis):
        return -1.0
    # relative to the motion, which can be tiny
    fastest = max(-lowest, highest)
    if abs(end - problem[Problem.W]) > EQUAL * fastest:
        return -1.0
    return -1.0 if abs(y - distance) > EQUAL * (abs(distance) + fastest * duration) else duration


def is_passing(phases: 'float[:,:]', count: int, axis: 'float[:]') -> bool:
    """Whether phases are those of a passing profile (passing.py), not ramps, or dips among them."""
    found = False
    for i in range(count):
        if phases[i, Phase.CHANGE] != 0.0:
            if phases[i, Phase.ABOVE] == 0.0 or phases[i, Phase.ABOVE] != axis[Axis.ABOVE]:
                return False
            found = True
    return found


def has_dip(phases: 'float[:,:]', count: int) -> bool:
    """Whether phases of ramps begin or end with a dip (dip.py)."""
    if count == 0:
        return False
    return phases[0, Phase.ABOVE] != 0.0 or phases[count - 1, Phase.ABOVE] != 0.0


def stretch_phases(phases: 'float[:,:]', count: int, factor: float) -> None:
    """Stretch phases that begin and end at rest in time; the distance stays (section 3.2)."""
    for i in range(count):
        phases[i, Phase.DURATION] = phases[i, Phase.DURATION] * factor
        power = factor * factor
        for j in range(int(phases[i, Phase.ABOVE])):
            power = power * factor
        phases[i, Phase.ACCELERATION] = phases[i, Phase.ACCELERATION] / power
        phases[i, Phase.CHANGE] = phases[i, Phase.CHANGE] / power


def fit_duration(phases: 'float[:,:]', count: int, target: float) -> int:
    """Remove the rounding error of the total duration: two averaged profiles need the same.

    So go phases that are nothing else, whose pieces are too short for the clock. Returns the number
    of phases.
    """
    total, kept = 0.0, 0
    for i in range(count):
        duration = phases[i, Phase.DURATION]
        if duration > SAME * target:
            phases[kept, :] = phases[i, :]
            total = total + duration
            kept = kept + 1
    for i in range(kept):
        phases[i, Phase.DURATION] = phases[i, Phase.DURATION] * (target / total)
    return kept
