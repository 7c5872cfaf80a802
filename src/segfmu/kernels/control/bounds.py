"""What drives can do, and how a feedback shares it out.

A linear feedback that saturates may make the sway grow, as the way back to the place takes what
damps it. So the way back is bounded first, and then its sum with what damps the sway: saturations
nested in each other stabilise a chain of integrators with any bound (A. R. Teel, Systems & Control
Letters 18 (1992)). Teel's proof needs less than half; more is faster and also damps 5 degrees.

A correction of zero is always within the bounds. What a drive can do is known only roughly, as it
depends on the swinging load; a plan that seems to ask for more must not be disturbed for that.

parameters is a `Tracking`, tick a `Tick` with a correction, situation a `Situation`.
"""

from segfmu.kernels.control.feedback import table_row, table_share
from segfmu.kernels.control.records import GainInputs, Gains, Situation, Tick, Tracking
from segfmu.kernels.crane.bounds import side_bound
from segfmu.kernels.crane.records import Axes, DriveMode, State


def return_effort() -> float:
    """Bound of what the way back asks for, over what the drive can do."""
    return 3.5


def return_speed() -> float:
    """Bound of the velocity of the way back, over what the plan leaves of the drive's."""
    return 0.7


def held_within(value: float, least: float, greatest: float) -> float:
    """A value within an interval."""
    return max(min(value, greatest), least)


def scheduled_gain(length: float, axis: int, column: int, gains: 'float[:,:,:]') -> float:
    """A gain at a rope length [m], linear between the rows."""
    row = table_row(length, gains)
    share = table_share(length, gains, row)
    following = min(row + 1, gains.shape[0] - 1)
    first = gains[row, Gains.AXES + axis, column]
    return first + share * (gains[following, Gains.AXES + axis, column] - first)


def top_speed(
    axis: int, sign: float, parameters: 'float[:]', situation: 'float[:]'
) -> float:
    """Largest speed [m/s] of a drive in the direction of a sign, 1e99 for any.

    A hoist also has to hold the load at it.
    """
    bound = side_bound(
        sign, parameters[Tracking.VELOCITY_MAX + axis], parameters[Tracking.VELOCITY_MIN + axis]
    )
    power = parameters[Tracking.POWER_MAX + axis]
    if bound <= 0.0:
        bound = 1e99
    if axis == Axes.ROPE and power > 0.0:
        bound = min(bound, power / situation[Situation.WEIGHT])
    return bound


def power_bound(axis: int, parameters: 'float[:]', situation: 'float[:]') -> float:
    """Greatest size of a setpoint, N or m/s2, that the drive's power allows; 1e99 for any."""
    power = parameters[Tracking.POWER_MAX + axis]
    if power <= 0.0:
        return 1e99
    force = power / max(abs(situation[Situation.VELOCITY + axis]), 1e-12 * power)
    if int(parameters[Tracking.MODE]) == DriveMode.FORCE:
        return force
    weight = situation[Situation.WEIGHT]
    gravity = parameters[Tracking.GRAVITY]
    if axis == Axes.ROPE:
        # a load that moves too fast is braked nevertheless
        return gravity * max(force / weight - 1.0, 1e-3)
    return force / (parameters[Tracking.MASSES + axis] + weight / gravity)


def least_correction(
    axis: int, parameters: 'float[:]', tick: 'float[:,:]', situation: 'float[:]'
) -> float:
    """Least correction with which the drive can do what it is told, at most 0.

    A hoist lifts with it.
    """
    least = max(parameters[Tracking.LEAST + axis], -power_bound(axis, parameters, situation))
    return min(least - tick[Tick.ADDED_TO, axis], 0.0)


def greatest_correction(
    axis: int, parameters: 'float[:]', tick: 'float[:,:]', situation: 'float[:]'
) -> float:
    """Greatest correction with which the drive can do what it is told, at least 0."""
    greatest = parameters[Tracking.GREATEST + axis]
    if axis != Axes.ROPE:
        greatest = min(greatest, power_bound(axis, parameters, situation))
    elif int(parameters[Tracking.MODE]) == DriveMode.FORCE:
        # a tenth of the weight keeps the rope taut
        greatest = min(greatest, -0.1 * situation[Situation.WEIGHT])
    return max(greatest - tick[Tick.ADDED_TO, axis], 0.0)


def bound_correction(
    axis: int, parameters: 'float[:]', tick: 'float[:,:]', situation: 'float[:]'
) -> None:
    """Bound a correction, so that the drive can do what it is told, feedforward included."""
    correction = tick[Tick.CORRECTION, axis]
    if int(parameters[Tracking.MODE]) == DriveMode.VELOCITY:
        least = -top_speed(axis, -1.0, parameters, situation)
        greatest = top_speed(axis, 1.0, parameters, situation)
        velocity = situation[Situation.VELOCITY + axis]
        period = parameters[Tracking.PERIOD]
        correction = held_within(
            correction, min(least - velocity, 0.0) / period, max(greatest - velocity, 0.0) / period
        )
    tick[Tick.CORRECTION, axis] = held_within(
        correction, least_correction(axis, parameters, tick, situation),
        greatest_correction(axis, parameters, tick, situation),
    )


def return_room(
    axis: int, parameters: 'float[:]', gains: 'float[:,:,:]', situation: 'float[:]'
) -> float:
    """Bound of the way back, as a multiple of what the drive can do.

    A carriage with the acceleration a has the load hang at -a / g, which the feedback of the sway
    opposes. So the way back asks for more than it gets; by that much its bound is larger.
    """
    if axis == Axes.ROPE:
        return 1.0
    sign = 1.0 - 2.0 * axis
    length = situation[Situation.LENGTH]
    pull = parameters[Tracking.GRAVITY]
    if int(parameters[Tracking.MODE]) == DriveMode.FORCE:
        pull = pull * parameters[Tracking.MASSES + axis] + situation[Situation.WEIGHT]
    opposed = length * scheduled_gain(length, axis, State.POSITION + axis, gains)
    opposed = opposed - sign * scheduled_gain(length, axis, State.ANGLE + axis, gains)
    return return_effort() * max(1.0 + opposed / pull, 1.0)


def bound_return(
    axis: int,
    parameters: 'float[:]',
    gains: 'float[:,:,:]',
    tick: 'float[:,:]',
    situation: 'float[:]',
) -> None:
    """Bound the part of a correction that brings the load, or the rope's length, to its place.

    With the deviation p of the load's place, that part is k (p' + r p), with the gains by the
    carriage's velocity and place; r p, a velocity, is bounded first.
    """
    length = situation[Situation.LENGTH]
    slope = scheduled_gain(length, axis, State.VELOCITY + axis, gains)
    slope = slope + scheduled_gain(length, axis, GainInputs.COMMAND, gains)
    pull = scheduled_gain(length, axis, State.POSITION + axis, gains)
    pull = pull * situation[Situation.PLACE + axis]
    damping = slope * situation[Situation.RATE + axis]
    asked = -(pull + damping)
    # the correction is opposite to the pull
    speed = top_speed(axis, -pull, parameters, situation)
    if slope > 0.0 and speed < 1e99:
        reference = abs(tick[Tick.REFERENCE, State.VELOCITY + axis])
        fastest = slope * return_speed() * max(speed - reference, 0.0)
        pull = held_within(pull, -fastest, fastest)
    room = return_room(axis, parameters, gains, situation)
    least = room * least_correction(axis, parameters, tick, situation)
    greatest = room * greatest_correction(axis, parameters, tick, situation)
    given = held_within(-(pull + damping), least, greatest)
    tick[Tick.CORRECTION, axis] = tick[Tick.CORRECTION, axis] + given - asked
