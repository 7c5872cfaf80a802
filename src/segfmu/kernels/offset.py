"""The unknown offset of the rope's sensor, learnt from how the load swings.

The true length is the measured one plus an offset D, and the load at r + D e, with r its place by
the measured length and e the rope's direction. Rope and weight are all that acts on it beside the
wind, so its acceleration, less gravity's, lies along the rope; linear in D, whatever the drives,
their friction and the payload do:

    (r'' + g e_z) x e + D e'' x e = wind x e / m

r, e and the products' factors go through the same filter, three equal lags, so the second
derivatives are differences of its states, and what the filter does to products is taken off as far
as the reference has it too. Offset and wind are estimated by recursive least squares. Wind looks
like a rope of no length, D = -l, and is told from an offset by that: what no likely offset
explains, nor the sensors' noise, is wind, which is then followed freely and teaches nothing about
the offset. The filter is that of P. C. Young, Recursive Estimation and Time-Series Analysis,
Springer 1984 (state variable filters).

`parameters` are those of kernels/tracking.py. `memory` (13, 10):

    0:4   input and the three lags for the measured place (3), direction (3) and the start (1)
    4:8   the same for the reference
    8     offset, wind along x and y; residual at the start (2); variance that was not explained
          (2); ticks for which wind is followed freely (2); whether there was a tick before
    9:12  covariance of offset and winds (3, 3); in row 9 moreover: ticks for which the offset has
          been significant, whether it is used, the offset in use, and its standard deviation at
          the start
    12    signals to be filtered
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


def offset_learn(
    axis: int,
    residual: float,
    factor: float,
    length: float,
    parameters: 'float[:]',
    memory: 'float[:,:]',
) -> None:
    """One axis' step of the least squares; residual = factor * offset + wind."""
    noise, factor_noise = offset_noise(parameters, length)
    wind = 1 + axis
    deviation = memory[9, 6]
    if factor * factor < 9.0 * factor_noise:
        # a factor of mere noise would draw the offset to that of wind
        factor = 0.0
    error = residual - factor * memory[8, 0] - memory[8, wind]
    spread = factor * (factor * memory[9, 0] + 2.0 * memory[9, wind]) + memory[9 + wind, wind]
    likely = 2.0 * deviation * abs(factor) + sqrt(noise)
    if error * error > 9.0 * (spread + noise) or abs(residual - memory[8, wind]) > likely:
        memory[8, 6 + wind] = 6.0 / (parameters[24] * parameters[1])
    if memory[8, 6 + wind] > 0.0:
        memory[8, 6 + wind] = memory[8, 6 + wind] - 1.0
        memory[9 + wind, wind] = memory[9 + wind, wind] + parameters[27] * parameters[27]
        spread = spread + parameters[27] * parameters[27]
    # what was not explained is noise for a while
    unexplained = 3.0 * (error * error - 2.0 * (spread + noise))
    decay = 1.0 - parameters[24] * parameters[1] / 12.0
    memory[8, 4 + wind] = max(memory[8, 4 + wind] * decay, unexplained)
    # and no sample teaches more than a share, as filters and models are not exact
    trust = 4.0 * factor * factor * deviation * deviation
    total = spread + noise + memory[8, 4 + wind] + trust
    for i in range(3):
        memory[12, i] = factor * memory[9 + i, 0] + memory[9 + i, wind]
    for i in range(3):
        memory[8, i] = memory[8, i] + memory[12, i] * error / total
        for j in range(3):
            memory[9 + i, j] = memory[9 + i, j] - memory[12, i] * memory[12, j] / total


def offset_start(parameters: 'float[:]', length: float, memory: 'float[:,:]') -> None:
    """What is known before the first tick."""
    for axis in range(2):
        memory[10 + axis, 1 + axis] = 1e-4 * parameters[27] * parameters[27]
    memory[9, 6] = parameters[23] * length
    memory[9, 0] = memory[9, 6] * memory[9, 6]
    memory[8, 9] = 1.0


def offset_use(parameters: 'float[:]', memory: 'float[:,:]') -> float:
    """The offset in use: once it has been three standard deviations for a while; fades."""
    offset = memory[8, 0]
    deviation = sqrt(memory[9, 0])
    memory[9, 3] = memory[9, 3] + 1.0
    if abs(offset) < 3.0 * deviation:
        memory[9, 3] = 0.0
    if memory[9, 3] * parameters[1] * parameters[24] > 2.4:
        memory[9, 4] = 1.0
    if abs(offset) < 2.0 * deviation:
        memory[9, 4] = 0.0
    most = 3.0 * memory[9, 6]
    aim = memory[9, 4] * min(max(offset, -most), most)
    memory[9, 5] = aim + parameters[11] * (memory[9, 5] - aim)
    return memory[9, 5]


def offset_estimate(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> float:
    """Offset [m] to add to the measured length, from signals and reference of the same time."""
    if parameters[23] <= 0.0:
        return 0.0
    first = memory[8, 9] < 0.5
    start = 0.0
    if first:
        start = 1.0
        offset_start(parameters, measured[2], memory)
    share = 0.5 * parameters[24] * parameters[1]
    square = parameters[24] * parameters[24]
    offset_signals(measured, start, memory[12, :])
    offset_filter(first, share, memory[12, :], memory[0:4, :])
    offset_signals(reference, start, memory[12, :])
    offset_filter(first, share, memory[12, :], memory[4:8, :])
    walk = 3e-3 * parameters[27]
    for axis in range(2):
        found, factor = offset_residual(axis, parameters[6], square, memory[0:4, :])
        planned, unused = offset_residual(axis, parameters[6], square, memory[4:8, :])
        residual = planned - found
        if first:
            memory[8, 3 + axis] = residual
        # the filter starts as if all had rested before, which a swaying load did not
        residual = residual - memory[8, 3 + axis] * memory[3, 6]
        memory[10 + axis, 1 + axis] = memory[10 + axis, 1 + axis] + walk * walk * parameters[1]
        offset_learn(axis, residual, factor, measured[2], parameters, memory)
    least = 0.05 * memory[9, 6]
    memory[9, 0] = max(memory[9, 0], least * least)
    return offset_use(parameters, memory)
