"""Whether a table of gains is stable with the drives that it is for.

The model of an axis is the observer's, sampled. With exact predictions, delays do not matter to
the poles of the feedback (separation of estimate and feedback); without an observer a dead time
adds the corrections on their way as states.
"""

from math import exp, log

from segfmu.kernels.control.bounds import scheduled_gain
from segfmu.kernels.control.design import table_lengths
from segfmu.kernels.control.kalman import kalman_model
from segfmu.kernels.control.records import AxisModel, GainInputs, Loops, LoopWork
from segfmu.kernels.crane.records import Axes, DriveMode, Plant, State
from segfmu.kernels.numerics.matrices import (
    halvings_below,
    matrix_copy,
    matrix_exponential,
    matrix_product,
)
from segfmu.kernels.rig.records import SetupFault, SetupStatus


def spectral_radius(
    n: int, enough: float, a: 'float[:,:]', square: 'float[:,:]'
) -> float:
    """Largest eigenvalue magnitude, by squaring; overwrites both matrices.

    One that is at most `enough` is only bounded: |r|^k <= n max |A^k|, by the row sums of A^k.
    """
    total = 0.0
    weight = 1.0
    for _ in range(30):
        size = 0.0
        for i in range(n):
            for j in range(n):
                size = max(size, abs(a[i, j]))
        if not size > 0.0:
            return 0.0
        total = total + weight * log(size)
        if total + weight * log(float(n)) <= log(enough):
            return enough
        weight = 0.5 * weight
        for i in range(n):
            for j in range(n):
                a[i, j] = a[i, j] / size
        matrix_product(n, a, a, square)
        matrix_copy(n, square, a)
    return exp(total)


def sampled_transition(
    sample_time: float, model: 'float[:,:]', transition: 'float[:,:]', work: 'float[:,:]'
) -> None:
    """Transition (8, 8) of a model over a sample, by series and doublings; work (16, .)."""
    doublings = halvings_below(AxisModel.SIZE, sample_time, model)
    term = work[0:AxisModel.SIZE, :]
    product = work[AxisModel.SIZE:2 * AxisModel.SIZE, :]
    matrix_exponential(
        AxisModel.SIZE, sample_time / 2**doublings, model, transition, term, product
    )
    for _ in range(doublings):
        matrix_product(AxisModel.SIZE, transition, transition, term)
        matrix_copy(AxisModel.SIZE, term, transition)


def is_state(axis: int, lagging: bool, place: int) -> bool:
    """Whether an entry of an `AxisModel` is a state of the loop."""
    if place == AxisModel.COMMAND:
        return lagging
    if place == AxisModel.ANGLE or place == AxisModel.RATE:
        return axis != Axes.ROPE
    return place == AxisModel.POSITION or place == AxisModel.VELOCITY


def axis_gains(
    axis: int, plant: 'float[:]', length: float, table: 'float[:,:,:]', gains: 'float[:]'
) -> None:
    """Gains of an axis by the entries of an `AxisModel`."""
    sign = 1.0 - 2.0 * axis
    scale = 1.0
    driven = int(plant[Plant.MODE]) == DriveMode.VELOCITY
    if axis == Axes.ROPE and not driven:
        # the model of the hoist has an acceleration for its input
        scale = 1.0 / plant[Plant.PAYLOAD_MASS]
    for i in range(AxisModel.SIZE):
        gains[i] = 0.0
    command = scale * scheduled_gain(length, axis, GainInputs.COMMAND, table)
    gains[AxisModel.COMMAND] = command
    place = scheduled_gain(length, axis, State.POSITION + axis, table)
    velocity = scheduled_gain(length, axis, State.VELOCITY + axis, table)
    gains[AxisModel.POSITION] = scale * place
    gains[AxisModel.VELOCITY] = scale * velocity
    if driven and plant[Plant.LAG + axis] <= 0.0:
        # the drive's velocity is its command
        gains[AxisModel.VELOCITY] = scale * velocity + command
    if axis != Axes.ROPE:
        gains[AxisModel.ANGLE] = sign * scheduled_gain(length, axis, State.ANGLE + axis, table)
        gains[AxisModel.RATE] = sign * scheduled_gain(length, axis, State.RATE + axis, table)


def close_loop(
    axis: int, lagging: bool, delay: float, gains: 'float[:]', work: 'float[:,:]'
) -> int:
    """The loop's transition over a sample, for a delay in samples; returns its order.

    work: a `LoopWork` with the sampled model. The states are an `AxisModel` without its correction,
    then the corrections of past ticks that have not acted yet.
    """
    transition = work[LoopWork.TRANSITION:LoopWork.TERM, :]
    loop = work[LoopWork.LOOP:LoopWork.SQUARE, :]
    own = AxisModel.CORRECTION
    whole = min(int(delay + 1e-9), Loops.MOST - own - 2)
    share = min(max(delay - whole, 0.0), 1.0)
    order = own + whole
    if share > 1e-9:
        order = order + 1
    for i in range(order):
        for j in range(order):
            loop[i, j] = 0.0
    for i in range(own):
        if is_state(axis, lagging, i):
            effect = transition[i, AxisModel.CORRECTION]
            for j in range(own):
                if is_state(axis, lagging, j):
                    loop[i, j] = transition[i, j]
                    if whole == 0:
                        loop[i, j] = loop[i, j] - (1.0 - share) * effect * gains[j]
            if whole > 0:
                loop[i, own + whole - 1] = (1.0 - share) * effect
            if share > 1e-9:
                loop[i, own + whole] = share * effect
    for i in range(own, order):
        if i > own:
            loop[i, i - 1] = 1.0
        else:
            for j in range(own):
                if is_state(axis, lagging, j):
                    loop[i, j] = -gains[j]
    return order


def check_gains(
    plant: 'float[:]',
    period: float,
    predicted: int,
    ends: 'float[:]',
    table: 'float[:,:,:]',
    work: 'float[:,:]',
    fault: 'float[:]',
) -> int:
    """A `SetupStatus`: whether a table of gains is stable between two rope lengths, ends (2,) [m].

    plant: a `Plant` with the design payload; period [s] of the feedback; predicted: 1 where an
    observer predicts over dead times. fault: a `SetupFault`, with the fastest growth in a sample.
    """
    lengths = work[LoopWork.LENGTHS, :]
    gains = work[LoopWork.GAINS, :]
    count = table_lengths(ends[0], ends[1], 33, lengths)
    status = SetupStatus.FITS
    fault[SetupFault.BOUND] = 1.0 + 1e-6
    for axis in range(Axes.SIZE):
        driven = int(plant[Plant.MODE]) == DriveMode.VELOCITY
        lagging = driven and plant[Plant.LAG + axis] > 0.0
        delay = plant[Plant.DEAD_TIME + axis] / period
        if predicted == 1:
            delay = 0.0
        for row in range(count):
            kalman_model(axis, plant, lengths[row], work[LoopWork.MODEL:LoopWork.TRANSITION, :])
            sampled_transition(
                period, work[LoopWork.MODEL:LoopWork.TRANSITION, :],
                work[LoopWork.TRANSITION:LoopWork.TERM, :], work[LoopWork.TERM:LoopWork.LOOP, :],
            )
            axis_gains(axis, plant, lengths[row], table, gains)
            order = close_loop(axis, lagging, delay, gains, work)
            growth = spectral_radius(
                order, fault[SetupFault.BOUND], work[LoopWork.LOOP:LoopWork.SQUARE, :],
                work[LoopWork.SQUARE:LoopWork.LENGTHS, :],
            )
            if growth > fault[SetupFault.BOUND]:
                fault[SetupFault.BOUND] = growth
                fault[SetupFault.DRIVE] = float(axis)
                fault[SetupFault.VALUE] = lengths[row]
                status = SetupStatus.UNSTABLE
    return status
