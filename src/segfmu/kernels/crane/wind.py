"""The wind's force on the load, given as forces, or as the speed of the air.

`plant` is a `Plant`, `work` a `Work`; components (count, 8): a `Sinusoid` a row, of the force or of
the air's speed.
"""

from math import cos, sin, sqrt

from segfmu.kernels.crane.records import Air, CommandRates, GustShape, Load, Plant, Vector, Work
from segfmu.kernels.crane.suspension import suspended_load
from segfmu.kernels.numerics.noise import full_circle
from segfmu.kernels.numerics.records import Sinusoid


def gust_factor(shape: float, share: float) -> float:
    """Force of a gust relative to its peak, at a share of its duration."""
    if share <= 0.0 or share >= 1.0:
        return 0.0
    if int(shape) == GustShape.SINE:
        return sin(0.5 * full_circle() * share)
    return 0.5 * (1.0 - cos(full_circle() * share))


def gust_rate(shape: float, share: float) -> float:
    """Derivative of `gust_factor` by the share of the gust's duration, between its ends."""
    # both shapes are sines of the share: their rate is the shape a quarter period later
    angle = full_circle() * share
    if int(shape) == GustShape.SINE:
        return 0.5 * full_circle() * cos(0.5 * angle)
    return 0.5 * full_circle() * cos(angle - 0.25 * full_circle())


def command_slope(i: int, elapsed: float, rate: 'float[:]') -> float:
    """Mean slope of a command over a time [s] elapsed, from its coefficients (CommandRates,)."""
    slope = rate[CommandRates.SQUARE + i] + elapsed * rate[CommandRates.CUBE + i]
    return rate[CommandRates.LINEAR + i] + elapsed * slope


def wind_force(
    plant: 'float[:]', components: 'float[:,:]', start: float, elapsed: float,
    state: 'float[:]', work: 'float[:,:]',
) -> None:
    """Force on the load [N]: the given one, constant wind, gust, noise, and drag of the air.

    At a time [s] elapsed since the interval's start [s].
    """
    time = start + elapsed
    gust = 0.0
    if plant[Plant.GUST_DURATION] > 0.0:
        share = (time - plant[Plant.GUST_START]) / plant[Plant.GUST_DURATION]
        gust = gust_factor(plant[Plant.GUST_SHAPE], share)
    force = work[Work.WIND, :]
    air = work[Work.AIR, :]
    rate = work[Work.LOAD_RATES, :]
    for i in range(Vector.SIZE):
        given = work[Work.LOAD_FORCE, i] + elapsed * command_slope(i, elapsed, rate)
        steady = given + plant[Plant.WIND + i]
        force[i] = steady + gust * plant[Plant.GUST_FORCE + i]
        air[Air.RELATIVE + i] = plant[Plant.WIND_SPEED + i] + gust * plant[Plant.GUST_SPEED + i]
    for k in range(components.shape[0]):
        sine = sin(components[k, Sinusoid.FREQUENCY] * time)
        cosine = cos(components[k, Sinusoid.FREQUENCY] * time)
        if components[k, Sinusoid.OF_SPEED] > 0.5:
            add_sinusoid(components[k, :], sine, cosine, air)
        else:
            add_sinusoid(components[k, :], sine, cosine, force)
    if plant[Plant.DRAG_AREA] > 0.0:
        add_drag(plant, state, work)


def add_sinusoid(
    component: 'float[:]', sine: float, cosine: float, total: 'float[:]'
) -> None:
    """Add a sinusoid to a vector."""
    for i in range(Vector.SIZE):
        added = total[i] + component[Sinusoid.SINE + i] * sine
        total[i] = added + component[Sinusoid.COSINE + i] * cosine


def drag_factor(plant: 'float[:]') -> float:
    """Force of the air over the square of its relative speed [N s2/m2]."""
    return 0.5 * plant[Plant.AIR_DENSITY] * plant[Plant.DRAG_AREA]


def relative_speed(air: 'float[:]') -> float:
    """Speed of the air relative to the load [m/s]."""
    squares = 0.0
    for i in range(Vector.SIZE):
        squares = squares + air[Air.RELATIVE + i] * air[Air.RELATIVE + i]
    return sqrt(squares)


def add_drag(plant: 'float[:]', state: 'float[:]', work: 'float[:,:]') -> None:
    """Add the drag of the air, rho c A |v| v / 2, to the force; v is relative to the load."""
    air = work[Work.AIR, :]
    suspended_load(plant, state, work, work[Work.LOAD:Work.LOAD + Load.SIZE, :])
    for i in range(Vector.SIZE):
        own = work[Work.LOAD + Load.VELOCITY, i]
        air[Air.RELATIVE + i] = air[Air.RELATIVE + i] - own
    factor = drag_factor(plant) * relative_speed(air)
    for i in range(Vector.SIZE):
        work[Work.WIND, i] = work[Work.WIND, i] + factor * air[Air.RELATIVE + i]


def drag_slope(plant: 'float[:]', air: 'float[:]', i: int, j: int) -> float:
    """Derivative of a component of the drag by one of the relative velocity [N s/m]."""
    speed = relative_speed(air)
    if plant[Plant.DRAG_AREA] == 0.0 or speed == 0.0:
        return 0.0
    slope = air[Air.RELATIVE + i] * air[Air.RELATIVE + j] / speed
    if i == j:
        slope = slope + speed
    return drag_factor(plant) * slope


def add_rate(
    component: 'float[:]', time: float, first: int, total: 'float[:]'
) -> None:
    """Add the time derivative of a sinusoid to a vector, from a place on."""
    frequency = component[Sinusoid.FREQUENCY]
    angle = frequency * time
    for i in range(Vector.SIZE):
        sines = component[Sinusoid.SINE + i] * cos(angle)
        sines = sines - component[Sinusoid.COSINE + i] * sin(angle)
        total[first + i] = total[first + i] + frequency * sines


def wind_rates(
    plant: 'float[:]', components: 'float[:,:]', time: float, air: 'float[:]'
) -> None:
    """Write the time derivatives of the air's velocity and of the force, where the load stays."""
    gust = 0.0
    duration = plant[Plant.GUST_DURATION]
    if duration > 0.0:
        share = (time - plant[Plant.GUST_START]) / duration
        if share > 0.0 and share < 1.0:
            gust = gust_rate(plant[Plant.GUST_SHAPE], share) / duration
    for i in range(Vector.SIZE):
        air[Air.RATE + i] = gust * plant[Plant.GUST_SPEED + i]
        air[Air.FORCE_RATE + i] = gust * plant[Plant.GUST_FORCE + i]
    for k in range(components.shape[0]):
        if components[k, Sinusoid.OF_SPEED] > 0.5:
            add_rate(components[k, :], time, Air.RATE, air)
        else:
            add_rate(components[k, :], time, Air.FORCE_RATE, air)
    for i in range(Vector.SIZE):
        rate = air[Air.FORCE_RATE + i]
        for j in range(Vector.SIZE):
            rate = rate + drag_slope(plant, air, i, j) * air[Air.RATE + j]
        air[Air.FORCE_RATE + i] = rate
