"""The unknown offset of the rope's sensor, learnt from how the load swings.

The true length is the measured one plus an offset D, and the load at r + D e, with r its place by
the measured length and e the rope's direction. Rope and weight are all that acts on it beside the
wind, so its acceleration, less gravity's, lies along the rope; linear in D, whatever the drives,
their friction and the payload do:

    (r'' + g e_z) x e + D e'' x e = wind x e / m

r, e and the products' factors go through the same filter, three equal lags, so the second
derivatives are differences of its states, and what the filter does to products is taken off as far
as the reference has it too; slow means, of constant wind or a tilted sensor, are taken off as well.

Wind and noise swing the load themselves, so they go with the offset's factor, and least squares
would take them for an offset. The factor of the reference is as good as the measured one when it
comes to the plan's swinging and knows nothing of wind, friction and noise: it is the instrument z
of an instrumental-variable estimate from residuals r and measured factors f,

    D = sum z r / sum z f,  variance of D = C sum z^2 (r - D f)^2 / (sum z f)^2,

both axes together. C samples, two of the filter's time constants, of what remains count as one, as
wind is coloured. An offset explains
all of the residual on both axes, and wind that is not shaped like the plan hardly any. Filter and
estimate are those of P. C. Young, Recursive Estimation and Time-Series Analysis, Springer 1984; the
variance by the remaining residuals is that of H. White, Econometrica 48 (1980), for samples whose
errors differ.

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
    """Place of the load and direction of the rope from the coordinates (5)."""
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
    """Variances of residual and factor by the noise of the sensors, white before the filter."""
    w = parameters[Tracking.OFFSET_BANDWIDTH]
    gravity = parameters[Tracking.GRAVITY]
    share = parameters[Tracking.PERIOD] / 16.0
    fifth = 3.0 * w * w * w * w * w
    angle = length * length * fifth + gravity * w * (3.0 * gravity - 2.0 * length * w * w)
    of_angles = angle * parameters[Tracking.ANGLE_VARIANCE]
    residual = share * (of_angles + fifth * parameters[Tracking.POSITION_VARIANCE])
    return residual, share * fifth * parameters[Tracking.ANGLE_VARIANCE]


def offset_centre(axis: int, share: float, values: 'float[:]', means: 'float[:]') -> None:
    """Take their slow means off an axis' three values; share: of what is new."""
    for i in range(OffsetEquation.SIZE):
        k = OffsetMeans.AXES + OffsetEquation.SIZE * axis + i
        means[k] = means[k] + share * (values[i] - means[k])
        values[i] = values[i] - means[k]


def offset_sum(keep: float, values: 'float[:]', sums: 'float[:]') -> None:
    """Add one axis' residual, factor and instrument to the sums, of which a share is kept."""
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
    """Offset and deviation by the sums; which offset is to be used.

    One that has been five deviations for five of the filter's time constants is; it stays until the
    data speak against it. In less time wind is too often shaped like the plan by chance. sums: an
    `OffsetSums`, estimate: an `OffsetEstimate`.
    """
    period = parameters[Tracking.PERIOD]
    bandwidth = parameters[Tracking.OFFSET_BANDWIDTH]
    samples = 2.0 / (bandwidth * period)
    offset = sums[OffsetSums.ZR] / sums[OffsetSums.ZF]
    left = sums[OffsetSums.ZZRR] - 2.0 * offset * sums[OffsetSums.ZZRF]
    left = left + offset * offset * sums[OffsetSums.ZZFF]
    # what remains may be little by chance, but not less than the sensors' noise, of which a small
    # part is as slow as the plan
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
        # the filter starts as if all had rested before, which a swaying load did not
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
        # a plan that swings the load less than the sensors' noise teaches nothing
        step = parameters[Tracking.OFFSET_BANDWIDTH] * parameters[Tracking.PERIOD]
        offset_sum(1.0 - step / 60.0, memory[OffsetMemory.EQUATIONS, :], sums)
        offset_sum(1.0, memory[OffsetMemory.EQUATIONS + 1, :], sums)
        if sums[OffsetSums.ZF] > 0.0:
            offset_decide(parameters, length, noise, sums, estimate)
    aim = estimate[OffsetEstimate.VALID] * estimate[OffsetEstimate.LAST]
    used = estimate[OffsetEstimate.USED]
    estimate[OffsetEstimate.USED] = aim + parameters[Tracking.DECAY] * (used - aim)
    return estimate[OffsetEstimate.USED]
