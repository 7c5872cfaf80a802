"""Limits to begin a search with: what the drives could do if the rope were rigid.

The ramps last multiples of half the pendulum's period, the time in which the load takes over the
carriage's acceleration.
"""

from math import exp, log, sqrt, tan

from segfmu.kernels.crane.bounds import hanging_mass
from segfmu.kernels.crane.records import Axes, Demand, DriveBounds, Resistance
from segfmu.kernels.crane.uses import bound_magnitude
from segfmu.kernels.limits.heading import heading_sign, state_of
from segfmu.kernels.limits.records import AxisTask, LimitFault, LimitRow, LimitStatus
from segfmu.kernels.limits.task import held_force
from segfmu.kernels.numerics.numbers import NEVER


def write_starts(
    rope: float,
    bounds: 'float[:]',
    resistance: 'float[:]',
    axes: 'float[:,:]',
    starts: 'float[:,:]',
    fault: 'float[:]',
) -> int:
    """Write logarithms of limits, (16, 3 LimitRow.SIZE or more); returns a `LimitStatus`.

    rope: its greatest length at a waypoint [m]. The starts have four lengths of ramps, each with
    the velocity and the acceleration of the drives, a higher velocity, a lower acceleration, and
    both: with these a motion may be shorter that has no time at constant velocity.
    """
    swing = 3.141592653589793 * sqrt(max(rope, 1e-3) / resistance[Resistance.GRAVITY])
    for axis in range(axes.shape[0]):
        status = check_pace_of(axis, bounds, axes, fault)
        if status != LimitStatus.FOUND:
            return status
        for k in range(starts.shape[0]):
            for i in range(LimitRow.SIZE):
                starts[k, axis * LimitRow.SIZE + i] = 0.0
        if axes[axis, AxisTask.MOVES] > 0.5:
            status = write_axis_starts(axis, swing, bounds, resistance, axes, starts)
            if status != LimitStatus.FOUND:
                return status
    return LimitStatus.FOUND


def check_pace_of(axis: int, bounds: 'float[:]', axes: 'float[:,:]', fault: 'float[:]') -> int:
    """Refuse bounds of an axis that moves which are below 1e-5 m/s or m/s2.

    In slower plans the clock is too coarse for ramps.
    """
    fault[LimitFault.AXIS] = axis
    fault[LimitFault.DRIVE] = axis
    for side in range(2):
        for i in range(2):
            bound = bound_magnitude(Demand.VELOCITY + 3 * i + axis, side, bounds)
            if axes[axis, AxisTask.MOVES] > 0.5 and 0.0 < bound < 1e-5:
                fault[LimitFault.SIDE] = side
                fault[LimitFault.VALUE] = bound
                return LimitStatus.SLOW_VELOCITY + i
    return LimitStatus.FOUND


def write_axis_starts(
    axis: int, swing: float, bounds: 'float[:]', resistance: 'float[:]', axes: 'float[:,:]',
    starts: 'float[:,:]',
) -> int:
    """Write the starts of an axis that moves."""
    row = axes[axis, :]
    ahead, rise = rigid_limits(axis, 0, bounds, resistance, row)
    back, fall = rigid_limits(axis, 1, bounds, resistance, row)
    if rise >= NEVER or fall >= NEVER:
        return LimitStatus.UNBOUNDED
    if row[AxisTask.DIRECTED] < 0.5:
        ahead = of_the_way(ahead, back, axis, row)
        back = ahead
    if row[AxisTask.DIRECTED + 1] < 0.5:
        rise = of_the_way(rise, fall, axis, row)
        fall = rise
    least = min(rise, fall)
    time = min(ahead, back) / least
    if row[AxisTask.DISTANCE] > 0.0:
        time = min(time, sqrt(row[AxisTask.DISTANCE] / least))
    for k in range(starts.shape[0]):
        # 0.5, 0.8, 1.26, 2
        multiple = 0.5 * exp((k % 4) * 0.46209812)
        ramp = multiple * min(swing, 2.0 * time)
        if axis == Axes.ROPE:
            ramp = multiple * 0.3 * time
        faster = 0.0
        if k // 4 % 2 == 1:
            faster = log(1.5)
        calmer = 0.0
        if k // 8 == 1:
            calmer = log(0.75)
        first = axis * LimitRow.SIZE
        most = max(rise, fall)
        starts[k, first + LimitRow.VELOCITY] = log(ahead) + faster
        starts[k, first + LimitRow.ACCELERATION] = log(rise) + calmer
        # peaks of the first and second derivative of a ramp over one second of height one
        starts[k, first + LimitRow.JERK] = log(1.9 * most / ramp)
        starts[k, first + LimitRow.SNAP] = log(5.8 * most / (ramp * ramp))
        starts[k, first + LimitRow.VELOCITY_MIN] = log(back) + faster
        starts[k, first + LimitRow.ACCELERATION_MIN] = log(fall) + calmer
    return LimitStatus.FOUND


def of_the_way(ahead: float, back: float, axis: int, row: 'float[:]') -> float:
    """The limit of both directions: that of the one in which an axis goes, the smaller of two."""
    up = row[AxisTask.GOES]
    down = row[AxisTask.GOES + 1]
    if axis == Axes.ROPE:
        up = row[AxisTask.GOES + 1]
        down = row[AxisTask.GOES]
    if down < 0.5:
        return ahead
    if up < 0.5:
        return back
    return min(ahead, back)


def rigid_limits(
    axis: int, way: int, bounds: 'float[:]', resistance: 'float[:]', row: 'float[:]'
) -> 'tuple[float, float]':
    """Velocity and acceleration of the load along an axis, as if the rope were rigid.

    way: 0 in the positive direction, 1 in the negative one. A hoist lifts by its pull, and lowers
    by the load's weight. The acceleration is NEVER if nothing bounds it.
    """
    gravity = resistance[Resistance.GRAVITY]
    side = way
    if axis == Axes.ROPE:
        # a rope that gets longer lowers the load
        side = 1 - way
    cap = AxisTask.CAP + way * LimitRow.VELOCITY_MIN
    velocity = least_of(row[cap], bound_magnitude(Demand.VELOCITY + axis, side, bounds))
    strongest = bound_magnitude(Demand.ACCELERATION + axis, side, bounds)
    acceleration = least_of(row[cap + 1], strongest)
    carried = row[AxisTask.HELD + 1]
    held = row[AxisTask.HELD] + carried
    mass = rigid_mass(axis, resistance)
    force = bound_magnitude(Demand.FORCE + axis, side, bounds)
    if axis == Axes.ROPE:
        force = bound_magnitude(Demand.FORCE + axis, 1, bounds)
    lowered = axis == Axes.ROPE and side == 0 and row[AxisTask.DIRECTED + 1] > 0.5
    if lowered:
        acceleration = min(acceleration, 0.9 * gravity)
    elif force > 0.0:
        # a bound may hardly move the load, or be next to none
        if axis != Axes.ROPE:
            held = held_force(side, row)
        strong = min((force - held) / mass, 1e299)
        acceleration = min(acceleration, max(strong, 1e-3 * gravity))
    steepest = tan(1.0)
    if axis == Axes.ROPE:
        steepest = 0.9
    elif bounds[DriveBounds.SWAY_MAX + axis] > 0.0:
        sway = tan(min(bounds[DriveBounds.SWAY_MAX + axis], 1.0))
        acceleration = min(acceleration, gravity * sway)
    power = bounds[DriveBounds.POWER_MAX + axis]
    distance = row[AxisTask.DISTANCE]
    if power > 0.0 and acceleration >= NEVER:
        # constant power covers the distance in about this time
        time = exp(log(max(mass * distance * distance / power, 1e-30)) / 3.0)
        acceleration = min(velocity / time, distance / (time * time))
    if acceleration >= NEVER:
        return velocity, acceleration
    # more would make the rope slack, or swing it near to the horizontal
    acceleration = min(acceleration, gravity * steepest)
    if distance <= 0.0:
        fastest = row[AxisTask.FASTEST]
        distance = max(fastest * fastest / acceleration, 1e-9)
    if power > 0.0:
        velocity = min(velocity, power / (row[AxisTask.HELD] + carried + mass * acceleration))
    return min(velocity, 2.0 * sqrt(acceleration * distance)), acceleration


def least_of(limit: float, bound: float) -> float:
    """The smaller of a limit and a bound, of which 0 is none."""
    if bound > 0.0:
        return min(limit, bound)
    return limit


def rigid_mass(axis: int, resistance: 'float[:]') -> float:
    """What the drive of an axis moves [kg]."""
    mass = hanging_mass(resistance)
    if axis < Axes.ROPE:
        mass = mass + resistance[Resistance.TROLLEY_MASS]
    if axis == Axes.BRIDGE:
        mass = mass + resistance[Resistance.BRIDGE_MASS]
    return mass


def write_passing(
    positions: 'float[:,:]', kinds: 'float[:]', axes: 'float[:,:]', heading: 'float[:]',
    start: 'float[:]',
) -> None:
    """Let a start pass waypoints with free velocities, each as fast as its axis goes on average.

    In the slower of the two intervals beside the waypoint, as long as the slowest axis needs from
    rest to rest.
    """
    for point in range(1, positions.shape[0] - 1):
        for axis in range(axes.shape[0]):
            i = state_of(point, 0, axis, heading)
            if kinds[i] > 1.5:
                before = mean_velocity(point, axis, positions, axes, start)
                after = mean_velocity(point + 1, axis, positions, axes, start)
                share = 0.0
                if before * after > 0.0:
                    share = min(abs(before), abs(after)) / exp(start[axis * LimitRow.SIZE])
                if before < 0.0:
                    share = -share
                start[i] = share * heading_sign(0, axis, heading)


def mean_velocity(
    point: int, axis: int, positions: 'float[:,:]', axes: 'float[:,:]', start: 'float[:]'
) -> float:
    """Mean velocity [m/s] of an axis towards a waypoint, if all axes move from rest to rest."""
    time = 0.0
    for i in range(axes.shape[0]):
        if axes[i, AxisTask.MOVES] > 0.5:
            way = abs(positions[point, i] - positions[point - 1, i])
            velocity = exp(start[i * LimitRow.SIZE + LimitRow.VELOCITY])
            acceleration = exp(start[i * LimitRow.SIZE + LimitRow.ACCELERATION])
            time = max(time, max(way / velocity, 2.0 * sqrt(way / acceleration)))
    return (positions[point, axis] - positions[point - 1, axis]) / max(time, 1e-9)
