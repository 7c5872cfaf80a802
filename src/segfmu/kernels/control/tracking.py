"""One tick of the tracking controller: observer, feedback, disturbance rejection, limits.

`parameters` (27): driven, sample time [s], whether measurements are one sample old, mass that
moves in x, in y and with the rope [kg], gravity [m/s2], share of the carriage's and of the load's
estimated disturbance that is rejected, enabled, time constant [s] of switching and decay of a
switching step over a sample, the least (3) and the greatest (3) setpoint, the payload [kg] that
the gains are for, the sample time as a share of the payload estimate's time constant, the
deviations of carriages, rope and angles up to which the feedback stays asleep; of the offset of
offset.py its standard deviation before anything is known as a share of the rope's length,
0: none is estimated, the bandwidth of the filter [rad/s], and variances of the noise of angles and
positions.

`memory` (22, 10): estimate (3 rows, see kernels/control/observer.py); velocity command (3), whether
there was a tick before, whether something was switched since; what the observer takes as input
since the last tick (3), last correction (3), whether it is awake; what remains of a switching
step (3), estimate of the payload over the nominal one, minus 1; reference at the tick before; two
rows of work space; from row 9 on that of offset.py, whose last row has the signals with the
offset removed in the end.

The force on the rope holds the load's weight, so a wrong payload is a large disturbance, and it
changes what a force does. Both are cured by asking for an acceleration v of the rope and applying
the estimated mass to v and to gravity; v is zero on average when that mass is right, and moves
the estimate otherwise. The loop is then the same for every payload.
"""

from segfmu.kernels.control.feedback import feedback_correction
from segfmu.kernels.control.observer import observer_correct, observer_predict
from segfmu.kernels.control.offset import offset_estimate


def track_wake(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Wake the feedback at the first deviation that is more than the sensors' steps.

    Until then there is nothing to correct that a rounded signal could show.
    """
    for i in range(3):
        tolerance = parameters[20]
        if i == 2:
            tolerance = parameters[21]
        if abs(measured[i] - reference[i]) > tolerance:
            memory[4, 6] = 1.0
    for i in range(2):
        if abs(measured[3 + i] - reference[3 + i]) > parameters[22]:
            memory[4, 6] = 1.0


def track_offset(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Put the signals (5) with the offset of the rope's length removed into memory[21]."""
    before = memory[18, 5]
    if parameters[2] > 0.5 and memory[3, 3] > 0.5:
        offset = offset_estimate(parameters, measured, memory[6, :], memory[9:22, :])
    else:
        offset = offset_estimate(parameters, measured, reference, memory[9:22, :])
    # a better known length is no motion of the rope
    memory[2, 0] = memory[2, 0] + (offset - before)
    for i in range(5):
        memory[21, i] = measured[i]
    memory[21, 2] = measured[2] + offset


def track_observe(
    parameters: 'float[:]',
    lengths: 'float[:]',
    table: 'float[:,:,:]',
    measured: 'float[:]',
    reference: 'float[:]',
    memory: 'float[:,:]',
) -> None:
    """Bring estimate and velocity command to the present tick."""
    delayed = parameters[2] > 0.5
    if memory[3, 3] < 0.5:
        for i in range(3):
            memory[i, 0] = measured[i] - reference[i]
        memory[0, 1] = measured[3] - reference[3]
        memory[1, 1] = reference[4] - measured[4]
        memory[3, 3] = 1.0
        track_wake(parameters, measured, reference, memory)
    elif delayed:
        track_wake(parameters, measured, memory[6, :], memory)
        observer_correct(measured[2], lengths, table, measured, memory[6, :], memory[0:3, :])
        observer_predict(
            measured[2], lengths, table, memory[3, :], memory[4, :], memory[0:3, :], memory[8, :]
        )
    else:
        track_wake(parameters, measured, reference, memory)
        observer_predict(
            measured[2], lengths, table, memory[3, :], memory[4, :], memory[0:3, :], memory[8, :]
        )
        observer_correct(measured[2], lengths, table, measured, reference, memory[0:3, :])
    for i in range(3):
        memory[3, i] = memory[3, i] + parameters[1] * memory[4, i]
    for i in range(10):
        memory[6, i] = reference[i]


def track_law(
    parameters: 'float[:]',
    length: float,
    gain_lengths: 'float[:]',
    gains: 'float[:,:,:]',
    memory: 'float[:,:]',
    correction: 'float[:]',
) -> None:
    """Feedback on the estimated deviation from where the disturbances are balanced.

    A load pushed by an acceleration w hangs at the angle w / g; its position is right with the
    carriage at -l w / g, and its height with a rope longer by l (w / g)^2 / 2.
    """
    if parameters[9] < 0.5 or memory[4, 6] < 0.5:
        for i in range(3):
            correction[i] = 0.0
            if parameters[0] > 0.5:
                # a velocity that the feedback has added must not stay
                correction[i] = -memory[3, i] / max(parameters[10], parameters[1])
        return
    for i in range(10):
        memory[8, i] = 0.0
    for i in range(3):
        memory[7, i] = memory[i, 0]
        memory[7, 5 + i] = memory[i, 2]
    slant = 0.0
    for i in range(2):
        sign = 1.0 - 2.0 * i
        angle = parameters[8] * memory[i, 5] / parameters[6]
        memory[7, i] = memory[7, i] + length * angle
        memory[7, 3 + i] = sign * (memory[i, 1] - angle)
        memory[7, 8 + i] = sign * memory[i, 3]
        slant = slant + 0.5 * length * angle * angle
    # the first argument's length chooses the gains, the difference is the deviation
    memory[8, 2] = length - memory[7, 2] + slant
    memory[7, 2] = length
    feedback_correction(memory[7, :], memory[8, :], gain_lengths, gains, correction)
    if parameters[0] < 0.5:
        for i in range(2):
            mass = parameters[7] * parameters[3 + i]
            pull = parameters[8] * parameters[5] * memory[i, 5]
            correction[i] = correction[i] - mass * memory[i, 4] - pull
        rope = correction[2] / parameters[18] - parameters[7] * memory[2, 4]
        share = memory[5, 3]
        correction[2] = parameters[5] * ((1.0 + share) * rope - share * parameters[6])


def track_hoist(parameters: 'float[:]', memory: 'float[:,:]') -> None:
    """The rope's acceleration that its force asked for, within limits; estimate of the payload."""
    share = memory[5, 3]
    rope = (memory[4, 5] / parameters[5] + share * parameters[6]) / (1.0 + share)
    memory[4, 2] = rope
    if parameters[9] > 0.5 and memory[4, 6] > 0.5:
        share = share - parameters[19] * (1.0 + share) * rope / parameters[6]
        memory[5, 3] = min(max(share, -0.98), 9.0)


def track_setpoint(
    parameters: 'float[:]',
    lengths: 'float[:]',
    table: 'float[:,:,:]',
    gain_lengths: 'float[:]',
    gains: 'float[:,:,:]',
    measured: 'float[:]',
    reference: 'float[:]',
    feedforward: 'float[:]',
    memory: 'float[:,:]',
    correction: 'float[:]',
) -> None:
    """Correction (3) of the setpoints at a tick, held until the next one.

    measured (5), reference (10) at this tick; feedforward (3) is what the correction is added to,
    and counts for the limits alone. lengths and table are the observer's, gain_lengths and gains
    the feedback's.
    """
    track_offset(parameters, measured, reference, memory)
    track_observe(parameters, lengths, table, memory[21, :], reference, memory)
    track_law(parameters, memory[21, 2], gain_lengths, gains, memory, correction)
    for i in range(3):
        if memory[3, 4] > 0.5:
            # bumpless: what a switch would jump by fades out instead
            memory[5, i] = memory[4, 3 + i] - correction[i]
        memory[5, i] = parameters[11] * memory[5, i]
        total = feedforward[i] + correction[i] + memory[5, i]
        total = min(max(total, parameters[12 + i]), parameters[15 + i])
        correction[i] = total - feedforward[i]
        # the observer gets what remains within the limits, so nothing winds up
        memory[4, 3 + i] = correction[i]
        memory[4, i] = correction[i]
    if parameters[0] < 0.5:
        track_hoist(parameters, memory)
    memory[3, 4] = 0.0
