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

`parameters` are those of kernels/control/tracking.py. `memory` (13, 10):

    0:4   input and the three lags for the measured place (3), direction (3) and the start (1)
    4:8   the same for the reference
    8     slow means of residual, factor and instrument for x (3) and y (3); residual at the start
          (2); whether there was a tick before
    9     offset and its standard deviation; ticks for which it has been significant; the offset
          that was last; whether there was one; the offset in use
    10    sums of z r, z f, z^2 r^2, z^2 r f, z^2 f^2, z^2
    11:13 signals to be filtered, of the reference and measured; then residual, factor, instrument
          of x and y
"""

from math import cos, sin, sqrt


def offset_filter(first: bool, share: float, signals: 'float[:]', states: 'float[:,:]') -> None:
    """Three lags (4, 7) of half a sample over their time constant `share`, by Tustin's rule."""
    for i in range(7):
        before = states[0, i]
        states[0, i] = signals[i]
        for k in range(1, 4):
            lagged = states[k, i]
            entering = before + states[k - 1, i]
            states[k, i] = ((1.0 - share) * lagged + share * entering) / (1.0 + share)
            if first:
                states[k, i] = signals[i]
            before = lagged


def offset_signals(measured: 'float[:]', start: float, signals: 'float[:]') -> None:
    """Place of the load and direction of the rope (3 each) from five measured values."""
    signals[3] = sin(measured[3])
    signals[4] = -cos(measured[3]) * sin(measured[4])
    signals[5] = -cos(measured[3]) * cos(measured[4])
    for i in range(3):
        signals[i] = measured[2] * signals[3 + i]
    for i in range(2):
        signals[i] = signals[i] + measured[i]
    signals[6] = start


def offset_residual(
    axis: int, gravity: float, square: float, states: 'float[:,:]'
) -> 'tuple[float, float]':
    """The equation's left side without offset, and the offset's factor, across the rope.

    square: of the filter's bandwidth.
    """
    place = square * (states[1, axis] - 2.0 * states[2, axis] + states[3, axis])
    height = square * (states[1, 2] - 2.0 * states[2, 2] + states[3, 2]) + gravity
    turn = square * (states[1, 3 + axis] - 2.0 * states[2, 3 + axis] + states[3, 3 + axis])
    drop = square * (states[1, 5] - 2.0 * states[2, 5] + states[3, 5])
    across = states[3, 3 + axis]
    down = states[3, 5]
    return height * across - place * down, drop * across - turn * down


def offset_noise(parameters: 'float[:]', length: float) -> 'tuple[float, float]':
    """Variances of residual and factor by the noise of the sensors, white before the filter."""
    w = parameters[24]
    gravity = parameters[6]
    share = parameters[1] / 16.0
    fifth = 3.0 * w * w * w * w * w
    angle = length * length * fifth + gravity * w * (3.0 * gravity - 2.0 * length * w * w)
    residual = share * (angle * parameters[25] + fifth * parameters[26])
    return residual, share * fifth * parameters[25]


def offset_centre(axis: int, share: float, values: 'float[:]', means: 'float[:]') -> None:
    """Take their slow means off an axis' three values; share: of what is new."""
    for i in range(3):
        k = 3 * axis + i
        means[k] = means[k] + share * (values[i] - means[k])
        values[i] = values[i] - means[k]


def offset_sum(keep: float, values: 'float[:]', sums: 'float[:]') -> None:
    """Add one axis' residual, factor and instrument to the sums, of which a share is kept."""
    residual = values[0]
    factor = values[1]
    instrument = values[2]
    square = instrument * instrument
    sums[0] = keep * sums[0] + instrument * residual
    sums[1] = keep * sums[1] + instrument * factor
    sums[2] = keep * sums[2] + square * residual * residual
    sums[3] = keep * sums[3] + square * residual * factor
    sums[4] = keep * sums[4] + square * factor * factor
    sums[5] = keep * sums[5] + square


def offset_judge(parameters: 'float[:]', length: float, noise: float, memory: 'float[:,:]') -> None:
    """Offset and deviation by the sums; which offset is to be used.

    One that has been five deviations for five of the filter's time constants is; it stays until the
    data speak against it. In less time wind is too often shaped like the plan by chance.
    """
    samples = 2.0 / (parameters[24] * parameters[1])
    offset = memory[10, 0] / memory[10, 1]
    left = memory[10, 2] - 2.0 * offset * memory[10, 3] + offset * offset * memory[10, 4]
    # what remains may be little by chance, but not less than the sensors' noise, of which a small
    # part is as slow as the plan
    least = noise * memory[10, 5] / 16.0
    deviation = sqrt(samples * (max(left, 0.0) + least)) / memory[10, 1]
    memory[9, 0] = offset
    memory[9, 1] = deviation
    memory[9, 2] = memory[9, 2] + 1.0
    if abs(offset) < 5.0 * deviation or abs(offset) > 3.0 * parameters[23] * length:
        memory[9, 2] = 0.0
    if memory[9, 2] * parameters[1] * parameters[24] > 5.0:
        memory[9, 3] = offset
        memory[9, 4] = 1.0
    elif abs(offset - memory[9, 3]) > 3.0 * deviation:
        memory[9, 4] = 0.0


def offset_equations(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Put residual, factor and instrument of x and y into the memory's last two rows."""
    first = memory[8, 8] < 0.5
    memory[8, 8] = 1.0
    start = 0.0
    if first:
        start = 1.0
    step = parameters[24] * parameters[1]
    square = parameters[24] * parameters[24]
    offset_signals(measured, start, memory[12, :])
    offset_filter(first, 0.5 * step, memory[12, :], memory[0:4, :])
    offset_signals(reference, start, memory[11, :])
    offset_filter(first, 0.5 * step, memory[11, :], memory[4:8, :])
    for axis in range(2):
        found, factor = offset_residual(axis, parameters[6], square, memory[0:4, :])
        planned, instrument = offset_residual(axis, parameters[6], square, memory[4:8, :])
        residual = planned - found
        if first:
            memory[8, 6 + axis] = residual
        # the filter starts as if all had rested before, which a swaying load did not
        memory[11 + axis, 0] = residual - memory[8, 6 + axis] * memory[3, 6]
        memory[11 + axis, 1] = factor
        memory[11 + axis, 2] = instrument
        offset_centre(axis, step / 12.0, memory[11 + axis, :], memory[8, :])


def offset_estimate(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> float:
    """Offset [m] to add to the measured length, from signals and reference of the same time."""
    if parameters[23] <= 0.0:
        return 0.0
    offset_equations(parameters, measured, reference, memory)
    noise, factor_noise = offset_noise(parameters, measured[2])
    planned = memory[11, 2] * memory[11, 2] + memory[12, 2] * memory[12, 2]
    if planned > 9.0 * factor_noise:
        # a plan that swings the load less than the sensors' noise teaches nothing
        keep = 1.0 - parameters[24] * parameters[1] / 60.0
        offset_sum(keep, memory[11, :], memory[10, :])
        offset_sum(1.0, memory[12, :], memory[10, :])
        if memory[10, 1] > 0.0:
            offset_judge(parameters, measured[2], noise, memory)
    aim = memory[9, 4] * memory[9, 3]
    memory[9, 5] = aim + parameters[11] * (memory[9, 5] - aim)
    return memory[9, 5]
