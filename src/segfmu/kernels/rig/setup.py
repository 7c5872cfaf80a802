"""Checks of the parameters of a rig; the results are those of SetupStatus."""

from math import sqrt

from segfmu.kernels.control.records import RopeRange
from segfmu.kernels.crane.records import Axes, DriveMode, Plant, Vector
from segfmu.kernels.crane.slack import may_slacken
from segfmu.kernels.crane.suspension import has_tackle
from segfmu.kernels.rig.records import (
    Delay,
    PayloadChange,
    SensorLimits,
    Sensors,
    SetupFault,
    SetupStatus,
)


def check_travel(least: 'float[:]', greatest: 'float[:]', fault: 'float[:]') -> int:
    """Check that the end stops of every axis [m], least and greatest (Axes,), are ascending."""
    for axis in range(Axes.SIZE):
        if not least[axis] < greatest[axis]:
            fault[SetupFault.AXIS] = axis
            fault[SetupFault.VALUE] = least[axis]
            fault[SetupFault.BOUND] = greatest[axis]
            return SetupStatus.EMPTY_TRAVEL
    return SetupStatus.FITS


def check_lags(plant: 'float[:]', exchange: int, fault: 'float[:]') -> int:
    """Check that velocity drives have a lag that can be integrated; none only in co-simulation.

    exchange: 1 in model exchange.
    """
    fault[SetupFault.BOUND] = 1e-5
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        for axis in range(Axes.SIZE):
            lag = plant[Plant.LAG + axis]
            fault[SetupFault.DRIVE] = axis
            fault[SetupFault.VALUE] = lag
            if lag == 0.0 and exchange == 1:
                return SetupStatus.NO_LAG
            if lag > 0.0 and lag < fault[SetupFault.BOUND]:
                return SetupStatus.SHORT_LAG
    return SetupStatus.FITS


def check_friction(static: 'float[:]', coulomb: 'float[:]', fault: 'float[:]') -> int:
    """Check that static friction [N], of each axis (Axes,), is not below Coulomb friction or 0."""
    for axis in range(Axes.SIZE):
        if static[axis] > 0.0 and static[axis] < coulomb[axis]:
            fault[SetupFault.DRIVE] = axis
            fault[SetupFault.VALUE] = static[axis]
            fault[SetupFault.BOUND] = coulomb[axis]
            return SetupStatus.LOW_STATIC
    return SetupStatus.FITS


def wind_speed(speed: 'float[:]') -> float:
    """Magnitude of the mean speed of the air [m/s], from its components (Vector,)."""
    squares = 0.0
    for i in range(Vector.SIZE):
        squares = squares + speed[i] * speed[i]
    return sqrt(squares)


def check_turbulence(speed: 'float[:]', deviation: 'float[:]', fault: 'float[:]') -> int:
    """Check that turbulence (Vector,) [m/s] has a mean speed (Vector,) for its spectrum."""
    for i in range(Vector.SIZE):
        fault[SetupFault.VALUE] = deviation[i]
        if deviation[i] > 0.0 and wind_speed(speed) == 0.0:
            return SetupStatus.NO_WIND
    return SetupStatus.FITS


def check_changes(changes: 'float[:,:]', fault: 'float[:]') -> int:
    """Check that each change of the load, a `PayloadChange` a row, has a time of its own."""
    for i in range(changes.shape[0]):
        fault[SetupFault.VALUE] = changes[i, PayloadChange.TIME]
        for k in range(i):
            if changes[k, PayloadChange.TIME] == changes[i, PayloadChange.TIME]:
                return SetupStatus.TWO_CHANGES
    return SetupStatus.FITS


def check_slack(plant: 'float[:]', exchange: int, fault: 'float[:]') -> int:
    """Check that the rope cannot slacken with a sling below it, and in model exchange not at all.

    exchange: 1 in model exchange.
    """
    fault[SetupFault.VALUE] = plant[Plant.SLACK]
    if has_tackle(plant) and may_slacken(plant):
        return SetupStatus.SLACK_SLING
    if exchange == 1 and may_slacken(plant):
        return SetupStatus.SLACK_EXCHANGE
    return SetupStatus.FITS


def check_delays(plant: 'float[:]', period: float, exchange: int, fault: 'float[:]') -> int:
    """Check that there is memory for the dead times of the drives; in model exchange there is none.

    period: of the controller [s]; exchange: 1 in model exchange.
    """
    for axis in range(Axes.SIZE):
        late = plant[Plant.DEAD_TIME + axis]
        fault[SetupFault.DRIVE] = axis
        fault[SetupFault.VALUE] = late
        fault[SetupFault.BOUND] = period
        if exchange == 1 and late > 0.0:
            return SetupStatus.LATE_EXCHANGE
        if late > Delay.MOST_TICKS * period:
            return SetupStatus.LONG_DELAY
    return SetupStatus.FITS


def check_sensors(sensors: 'float[:]', fault: 'float[:]') -> int:
    """Check that noise and dead time have a sample time, and that the ring can hold the samples."""
    sample_time = sensors[Sensors.SAMPLE_TIME]
    dead_time = sensors[Sensors.DEAD_TIME]
    noise = 0.0
    for i in range(Sensors.RESOLUTION - Sensors.DEVIATION):
        noise = noise + sensors[Sensors.DEVIATION + i]
    if sample_time == 0.0 and (dead_time > 0.0 or noise > 0.0):
        return SetupStatus.NOT_SAMPLED
    fault[SetupFault.VALUE] = sample_time
    fault[SetupFault.BOUND] = 1e-6
    if sample_time > 0.0 and sample_time < fault[SetupFault.BOUND]:
        return SetupStatus.SHORT_SAMPLE
    fault[SetupFault.VALUE] = dead_time
    fault[SetupFault.BOUND] = sample_time
    if dead_time > SensorLimits.MOST_SAMPLES * sample_time:
        return SetupStatus.LONG_DEAD_TIME
    return SetupStatus.FITS


def check_rope_bounds(length: float, shortest: float, longest: float, fault: 'float[:]') -> int:
    """Check that the rope starts above 0 m and its bounds are ascending; a bound of 0 is none."""
    fault[SetupFault.VALUE] = length
    if not length > 0.0:
        return SetupStatus.ROPE_START
    fault[SetupFault.VALUE] = shortest
    fault[SetupFault.BOUND] = longest
    if longest > 0.0 and not shortest < longest:
        return SetupStatus.ROPE_BOUNDS
    return SetupStatus.FITS


def check_lengths(lengths: 'float[:]', fault: 'float[:]') -> int:
    """The rope lengths of a table, a `RopeRange`, are positive and do not descend."""
    shortest = lengths[RopeRange.SHORTEST]
    longest = lengths[RopeRange.LONGEST]
    fault[SetupFault.VALUE] = shortest
    fault[SetupFault.BOUND] = longest
    if not (shortest > 0.0 and shortest <= longest and longest <= 1.7976931348623157e308):
        return SetupStatus.LENGTHS
    return SetupStatus.FITS
