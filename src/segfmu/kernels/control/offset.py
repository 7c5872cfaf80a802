"""The unknown offset of the rope's length sensor, estimated from the swing of the load.

The true length is the measured one plus an offset D. The load is at r + D e: r is its position by
the measured length, e the rope's direction. Only rope, weight and wind act on the load. So its
acceleration without gravity is parallel to the rope, except for wind; this is linear in D and
independent of drives, friction and payload:

    (r'' + g e_z) x e + D e'' x e = wind x e / m

r, e and the factors of the products pass the same filter, three equal lags, so second derivatives
are differences of its states. The filter's error in products is removed as far as the reference has
the same error. Slow means, from constant wind or a tilted sensor, are removed too.

Wind and noise swing the load, so they are correlated with the offset's factor, and least squares
would mistake them for an offset. The factor computed from the reference contains the planned swing,
but no wind, friction or noise. It is the instrument z of an instrumental-variable estimate from
residuals r and measured factors f,

    D = sum z r / sum z f,  variance of D = C sum z^2 (r - D f)^2 / (sum z f)^2,

over both axes. C residuals, two of the filter's time constants, count as one sample, because wind
is coloured. An offset explains the whole residual on both axes; wind unlike the plan explains
hardly any. Filter and estimate are those of P. C. Young, Recursive Estimation and Time-Series
Analysis, Springer 1984; the variance is that of H. White, Econometrica 48 (1980), for
heteroscedastic errors.

`parameters` is a `Tracking`, `memory` (15, 10) an `OffsetMemory`.
"""

from math import cos, sin, sqrt

from segfmu.kernels.control.records import (
    OffsetEquation,
    OffsetEstimate,
    OffsetFilter,
    OffsetMeans,
    OffsetMemory,
    OffsetSignals,
    OffsetSums,
    Tracking,
)
from segfmu.kernels.crane.records import Axes, Coordinates, Vector


def offset_filter(first: bool, share: float, signals: 'float[:]', states: 'float[:,:]') -> None:
    """Three lags of half a sample over their time constant `share`, by Tustin's rule.

    signals (7): `OffsetSignals`; states (4, 7): an `OffsetFilter`.
    """
    for i in range(OffsetSignals.SIZE):
        before = states[OffsetFilter.INPUT, i]
        states[OffsetFilter.INPUT, i] = signals[i]
        for k in range(OffsetFilter.FIRST, OffsetFilter.SIZE):
            lagged = states[k, i]
            entering = before + states[k - 1, i]
            states[k, i] = ((1.0 - share) * lagged + share * entering) / (1.0 + share)
            if first:
                states[k, i] = signals[i]
            before = lagged


def offset_signals(measured: 'float[:]', start: float, signals: 'float[:]') -> None:
    """Position of the load and direction of the rope from the coordinates (5)."""
    phi_x = measured[Coordinates.ANGLE]
    phi_y = measured[Coordinates.ANGLE + 1]
    signals[OffsetSignals.DIRECTION + Vector.X] = sin(phi_x)
    signals[OffsetSignals.DIRECTION + Vector.Y] = -cos(phi_x) * sin(phi_y)
    signals[OffsetSignals.DIRECTION + Vector.Z] = -cos(phi_x) * cos(phi_y)
    length = measured[Coordinates.POSITION + Axes.ROPE]
    for i in range(3):
        signals[OffsetSignals.PLACE + i] = length * signals[OffsetSignals.DIRECTION + i]
    for i in range(2):
        place = signals[OffsetSignals.PLACE + i]
        signals[OffsetSignals.PLACE + i] = place + measured[Coordinates.POSITION + i]
    signals[OffsetSignals.START] = start


def second_difference(signal: int, states: 'float[:,:]') -> float:
    """Second derivative of a filtered signal over the square of the filter's bandwidth."""
    difference = states[OffsetFilter.FIRST, signal] - 2.0 * states[OffsetFilter.SECOND, signal]
    return difference + states[OffsetFilter.THIRD, signal]


def offset_residual(
    axis: int, gravity: float, square: float, states: 'float[:,:]'
) -> 'tuple[float, float]':
    """The equation's left side without offset, and the offset's factor, across the rope.

    square: of the filter's bandwidth.
    """
    sideways = OffsetSignals.DIRECTION + axis
    upwards = OffsetSignals.DIRECTION + Vector.Z
    place = square * second_difference(OffsetSignals.PLACE + axis, states)
    height = square * second_difference(OffsetSignals.PLACE + Vector.Z, states) + gravity
    turn = square * second_difference(sideways, states)
    drop = square * second_difference(upwards, states)
    across = states[OffsetFilter.THIRD, sideways]
    down = states[OffsetFilter.THIRD, upwards]
    return height * across - place * down, drop * across - turn * down


def offset_noise(parameters: 'float[:]', length: float) -> 'tuple[float, float]':
    """Variances of residual and factor due to sensor noise, white before the filter."""
    w = parameters[Tracking.OFFSET_BANDWIDTH]
    gravity = parameters[Tracking.GRAVITY]
    share = parameters[Tracking.PERIOD] / 16.0
    fifth = 3.0 * w * w * w * w * w
    angle = length * length * fifth + gravity * w * (3.0 * gravity - 2.0 * length * w * w)
    of_angles = angle * parameters[Tracking.ANGLE_VARIANCE]
    residual = share * (of_angles + fifth * parameters[Tracking.POSITION_VARIANCE])
    return residual, share * fifth * parameters[Tracking.ANGLE_VARIANCE]


def offset_centre(axis: int, share: float, values: 'float[:]', means: 'float[:]') -> None:
    """Subtract the slow means from an axis' three values; share: weight of the new values."""
    for i in range(OffsetEquation.SIZE):
        k = OffsetMeans.AXES + OffsetEquation.SIZE * axis + i
        means[k] = means[k] + share * (values[i] - means[k])
        values[i] = values[i] - means[k]


def offset_sum(keep: float, values: 'float[:]', sums: 'float[:]') -> None:
    """Add one axis' residual, factor and instrument to the sums, after scaling them by `keep`."""
    residual = values[OffsetEquation.RESIDUAL]
    factor = values[OffsetEquation.FACTOR]
    instrument = values[OffsetEquation.INSTRUMENT]
    square = instrument * instrument
    sums[OffsetSums.ZR] = keep * sums[OffsetSums.ZR] + instrument * residual
    sums[OffsetSums.ZF] = keep * sums[OffsetSums.ZF] + instrument * factor
    sums[OffsetSums.ZZRR] = keep * sums[OffsetSums.ZZRR] + square * residual * residual
    sums[OffsetSums.ZZRF] = keep * sums[OffsetSums.ZZRF] + square * residual * factor
    sums[OffsetSums.ZZFF] = keep * sums[OffsetSums.ZZFF] + square * factor * factor
    sums[OffsetSums.ZZ] = keep * sums[OffsetSums.ZZ] + square


def offset_decide(
    parameters: 'float[:]', length: float, noise: float, sums: 'float[:]', estimate: 'float[:]'
) -> None:
    """Offset and deviation from the sums, and the offset to use.

    An offset is used after it has exceeded five deviations for five of the filter's time constants,
    and until the data contradict it. In a shorter time wind too often resembles the plan by chance.
    sums: an `OffsetSums`, estimate: an `OffsetEstimate`.
    """
    period = parameters[Tracking.PERIOD]
    bandwidth = parameters[Tracking.OFFSET_BANDWIDTH]
    samples = 2.0 / (bandwidth * period)
    offset = sums[OffsetSums.ZR] / sums[OffsetSums.ZF]
    left = sums[OffsetSums.ZZRR] - 2.0 * offset * sums[OffsetSums.ZZRF]
    left = left + offset * offset * sums[OffsetSums.ZZFF]
    # the residual may be small by chance, but not below the part of the sensors' noise that is as
    # slow as the plan
    least = noise * sums[OffsetSums.ZZ] / 16.0
    deviation = sqrt(samples * (max(left, 0.0) + least)) / sums[OffsetSums.ZF]
    estimate[OffsetEstimate.FOUND] = offset
    estimate[OffsetEstimate.DEVIATION] = deviation
    estimate[OffsetEstimate.TICKS] = estimate[OffsetEstimate.TICKS] + 1.0
    largest = 3.0 * parameters[Tracking.OFFSET_EXPECTED] * length
    if abs(offset) < 5.0 * deviation or abs(offset) > largest:
        estimate[OffsetEstimate.TICKS] = 0.0
    if estimate[OffsetEstimate.TICKS] * period * bandwidth > 5.0:
        estimate[OffsetEstimate.LAST] = offset
        estimate[OffsetEstimate.VALID] = 1.0
    elif abs(offset - estimate[OffsetEstimate.LAST]) > 3.0 * deviation:
        estimate[OffsetEstimate.VALID] = 0.0


def offset_equations(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Residual, factor and instrument of x and y at the present tick."""
    means = memory[OffsetMemory.MEANS, :]
    signals = memory[OffsetMemory.SIGNALS, :]
    filtered = memory[OffsetMemory.MEASURED:OffsetMemory.PLANNED, :]
    planned = memory[OffsetMemory.PLANNED:OffsetMemory.MEANS, :]
    first = means[OffsetMeans.STARTED] < 0.5
    means[OffsetMeans.STARTED] = 1.0
    start = 0.0
    if first:
        start = 1.0
    bandwidth = parameters[Tracking.OFFSET_BANDWIDTH]
    step = bandwidth * parameters[Tracking.PERIOD]
    square = bandwidth * bandwidth
    offset_signals(measured, start, signals)
    offset_filter(first, 0.5 * step, signals, filtered)
    offset_signals(reference, start, signals)
    offset_filter(first, 0.5 * step, signals, planned)
    for axis in range(2):
        gravity = parameters[Tracking.GRAVITY]
        seen, factor = offset_residual(axis, gravity, square, filtered)
        expected, instrument = offset_residual(axis, gravity, square, planned)
        residual = expected - seen
        if first:
            means[OffsetMeans.START + axis] = residual
        # the filter assumes rest before the start, but the load may sway
        settling = filtered[OffsetFilter.THIRD, OffsetSignals.START]
        equation = memory[OffsetMemory.EQUATIONS + axis, :]
        equation[OffsetEquation.RESIDUAL] = residual - means[OffsetMeans.START + axis] * settling
        equation[OffsetEquation.FACTOR] = factor
        equation[OffsetEquation.INSTRUMENT] = instrument
        offset_centre(axis, step / 12.0, equation, means)


def offset_estimate(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> float:
    """Offset [m] to add to the measured length, from signals and reference of the same time."""
    if parameters[Tracking.OFFSET_EXPECTED] <= 0.0:
        return 0.0
    sums = memory[OffsetMemory.SUMS, :]
    estimate = memory[OffsetMemory.ESTIMATE, :]
    length = measured[Coordinates.POSITION + Axes.ROPE]
    offset_equations(parameters, measured, reference, memory)
    noise, factor_noise = offset_noise(parameters, length)
    power = 0.0
    for axis in range(2):
        instrument = memory[OffsetMemory.EQUATIONS + axis, OffsetEquation.INSTRUMENT]
        power = power + instrument * instrument
    if power > 9.0 * factor_noise:
        # a planned swing below the sensors' noise contains no information
        step = parameters[Tracking.OFFSET_BANDWIDTH] * parameters[Tracking.PERIOD]
        offset_sum(1.0 - step / 60.0, memory[OffsetMemory.EQUATIONS, :], sums)
        offset_sum(1.0, memory[OffsetMemory.EQUATIONS + 1, :], sums)
        if sums[OffsetSums.ZF] > 0.0:
            offset_decide(parameters, length, noise, sums, estimate)
    aim = estimate[OffsetEstimate.VALID] * estimate[OffsetEstimate.LAST]
    used = estimate[OffsetEstimate.USED]
    estimate[OffsetEstimate.USED] = aim + parameters[Tracking.DECAY] * (used - aim)
    return estimate[OffsetEstimate.USED]
