"""One tick of the tracking controller: observer, feedback, disturbance rejection, limits.

`parameters` is a `Tracking`, `memory` a `Tracker`, `tick` (4, 10) a `Tick`; table is the
observer's, gains the feedback's.

The force on the rope holds the load's weight, so a wrong payload is a large disturbance, and it
changes the effect of a force. Therefore the feedback computes an acceleration v of the rope, and
the force is the estimated mass times v and gravity. v is zero on average if that mass is right;
otherwise it moves the estimate. The loop is then the same for every payload.
"""

from segfmu.kernels.control.bounds import bound_correction, bound_return
from segfmu.kernels.control.delay import (
    advance_estimates,
    aged_reference,
    predict_present,
    remember_start,
    remember_tick,
)
from segfmu.kernels.control.feedback import feedback_correction
from segfmu.kernels.control.observer import observer_correct
from segfmu.kernels.control.offset import offset_estimate
from segfmu.kernels.control.records import (
    Estimate,
    Fading,
    Held,
    OffsetCause,
    OffsetEstimate,
    OffsetMemory,
    Situation,
    Tick,
    Tracker,
    Tracking,
    VelocityCommand,
)
from segfmu.kernels.crane.records import Axes, Coordinates, DriveMode, State


def track_wake(
    parameters: 'float[:]', measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Wake the feedback at the first deviation above the sensors' quantisation.

    Until then the deviation may be rounding.
    """
    for i in range(Coordinates.SIZE):
        tolerance = parameters[Tracking.WAKE_POSITION]
        if i == Coordinates.POSITION + Axes.ROPE:
            tolerance = parameters[Tracking.WAKE_LENGTH]
        elif i >= Coordinates.ANGLE:
            tolerance = parameters[Tracking.WAKE_ANGLE]
        if abs(measured[i] - reference[i]) > tolerance:
            memory[Tracker.HELD, Held.AWAKE] = 1.0


def track_offset(parameters: 'float[:]', tick: 'float[:,:]', memory: 'float[:,:]') -> None:
    """Signals, with the offset of the rope's length removed if it is to be."""
    measured = tick[Tick.SIGNALS, :]
    offsets = memory[Tracker.OFFSET:Tracker.OFFSET + OffsetMemory.SIZE, :]
    before = offsets[OffsetMemory.ESTIMATE, OffsetEstimate.USED]
    offset = offset_estimate(parameters, measured, memory[Tracker.REFERENCE, :], offsets)
    if parameters[Tracking.OFFSET_ACTS] < 0.5:
        offset = 0.0
        before = 0.0
    # a correction of the length is no motion of the rope
    hoist = memory[Tracker.ESTIMATE + Axes.ROPE, :]
    hoist[Estimate.POSITION] = hoist[Estimate.POSITION] + (offset - before)
    length = Coordinates.POSITION + Axes.ROPE
    for i in range(Coordinates.SIZE):
        memory[Tracker.SIGNALS, i] = measured[i]
    memory[Tracker.SIGNALS, length] = measured[length] + offset


def track_start(measured: 'float[:]', reference: 'float[:]', memory: 'float[:,:]') -> None:
    """Begin the estimate at the first measured positions and angles."""
    estimate = memory[Tracker.ESTIMATE:Tracker.COMMAND, :]
    for i in range(3):
        estimate[i, Estimate.POSITION] = measured[i] - reference[i]
    phi_x = Coordinates.ANGLE
    phi_y = Coordinates.ANGLE + 1
    estimate[Axes.BRIDGE, Estimate.ANGLE] = measured[phi_x] - reference[phi_x]
    estimate[Axes.TROLLEY, Estimate.ANGLE] = reference[phi_y] - measured[phi_y]
    memory[Tracker.COMMAND, VelocityCommand.STARTED] = 1.0


def track_observe(
    parameters: 'float[:]', table: 'float[:,:,:]', memory: 'float[:,:]'
) -> None:
    """Correct the estimate by the signals, and predict it to when a correction acts."""
    measured = memory[Tracker.SIGNALS, :]
    reference = memory[Tracker.REFERENCE, :]
    length = measured[Coordinates.POSITION + Axes.ROPE]
    track_wake(parameters, measured, reference, memory)
    if memory[Tracker.COMMAND, VelocityCommand.STARTED] < 0.5:
        track_start(measured, reference, memory)
    else:
        advance_estimates(parameters, length, table, memory)
        observer_correct(
            length, table, measured, reference, memory[Tracker.ESTIMATE:Tracker.COMMAND, :]
        )
    predict_present(parameters, length, table, memory)


def track_acts(parameters: 'float[:]', memory: 'float[:,:]') -> bool:
    """Whether corrections act: enabled, and a deviation has woken the feedback."""
    return parameters[Tracking.ENABLED] > 0.5 and memory[Tracker.HELD, Held.AWAKE] > 0.5


def track_deviation(parameters: 'float[:]', memory: 'float[:,:]') -> None:
    """Estimated deviation from the state that balances the disturbances.

    A load pushed by an acceleration w hangs at the angle w / g. Its position is right if the
    carriage is at -l w / g, and its height if the rope is longer by l (w / g)^2 / 2. A sensor of
    the angle that is wrong by w / g shows the same while all is in place.
    """
    length = memory[Tracker.SIGNALS, Coordinates.POSITION + Axes.ROPE]
    deviation = memory[Tracker.DEVIATION, :]
    target = memory[Tracker.TARGET, :]
    for i in range(State.SIZE):
        target[i] = 0.0
    moves = 1.0
    if int(parameters[Tracking.OFFSET_CAUSE]) == OffsetCause.SENSOR:
        moves = 0.0
    for i in range(3):
        deviation[State.POSITION + i] = memory[Tracker.PRESENT + i, Estimate.POSITION]
        deviation[State.VELOCITY + i] = memory[Tracker.PRESENT + i, Estimate.VELOCITY]
    slant = 0.0
    for i in range(2):
        estimate = memory[Tracker.PRESENT + i, :]
        sign = 1.0 - 2.0 * i
        rejected = parameters[Tracking.REJECTED_WIND] * estimate[Estimate.WIND]
        angle = rejected / parameters[Tracking.GRAVITY]
        place = State.POSITION + i
        deviation[place] = deviation[place] + moves * length * angle
        deviation[State.ANGLE + i] = sign * (estimate[Estimate.ANGLE] - angle)
        deviation[State.RATE + i] = sign * estimate[Estimate.RATE]
        slant = slant + 0.5 * moves * length * angle * angle
    # the length of the first argument selects the gains, the difference is the deviation
    target[State.POSITION + Axes.ROPE] = length - deviation[State.POSITION + Axes.ROPE] + slant
    deviation[State.POSITION + Axes.ROPE] = length


def track_situation(
    parameters: 'float[:]', tick: 'float[:,:]', memory: 'float[:,:]'
) -> None:
    """What bounds depend on: drives move as commanded, or as estimated where forces are commanded.

    The load's mass is the estimated one.
    """
    situation = memory[Tracker.SITUATION, :]
    deviation = memory[Tracker.DEVIATION, :]
    length = memory[Tracker.SIGNALS, Coordinates.POSITION + Axes.ROPE]
    share = memory[Tracker.FADING, Fading.PAYLOAD]
    weight = parameters[Tracking.MASSES + Axes.ROPE] * parameters[Tracking.GRAVITY]
    situation[Situation.WEIGHT] = (1.0 + share) * weight
    situation[Situation.LENGTH] = length
    for i in range(Axes.SIZE):
        velocity = memory[Tracker.PRESENT + i, Estimate.VELOCITY]
        if int(parameters[Tracking.MODE]) == DriveMode.VELOCITY:
            velocity = memory[Tracker.COMMAND, VelocityCommand.VELOCITY + i]
        velocity = velocity + tick[Tick.REFERENCE, State.VELOCITY + i]
        situation[Situation.VELOCITY + i] = velocity
        place = deviation[State.POSITION + i] - memory[Tracker.TARGET, State.POSITION + i]
        rate = deviation[State.VELOCITY + i]
        if i != Axes.ROPE:
            sign = 1.0 - 2.0 * i
            place = place + length * sign * deviation[State.ANGLE + i]
            rate = rate + length * sign * deviation[State.RATE + i]
        situation[Situation.PLACE + i] = place
        situation[Situation.RATE + i] = rate


def track_law(
    parameters: 'float[:]', gains: 'float[:,:,:]', tick: 'float[:,:]', memory: 'float[:,:]'
) -> None:
    """Feedback on the estimated deviation, written to `tick`."""
    correction = tick[Tick.CORRECTION, :]
    driven = int(parameters[Tracking.MODE]) == DriveMode.VELOCITY
    track_deviation(parameters, memory)
    track_situation(parameters, tick, memory)
    if not track_acts(parameters, memory):
        for i in range(3):
            correction[i] = 0.0
            if driven:
                # the velocity added by the feedback must return to zero
                added = memory[Tracker.COMMAND, VelocityCommand.VELOCITY + i]
                fade = max(parameters[Tracking.FADE], parameters[Tracking.PERIOD])
                correction[i] = -added / fade
        return
    feedback_correction(
        memory[Tracker.DEVIATION, :], memory[Tracker.TARGET, :],
        memory[Tracker.COMMAND, :], gains,
        correction,
    )
    for i in range(Axes.SIZE):
        bound_return(i, parameters, gains, tick, memory[Tracker.SITUATION, :])
    if not driven:
        track_forces(parameters, memory, correction)


def track_forces(
    parameters: 'float[:]', memory: 'float[:,:]', correction: 'float[:]'
) -> None:
    """Forces that also reject the estimated disturbances."""
    rejected = parameters[Tracking.REJECTED_DRIFT]
    payload = parameters[Tracking.MASSES + Axes.ROPE]
    for i in range(2):
        estimate = memory[Tracker.PRESENT + i, :]
        mass = rejected * parameters[Tracking.MASSES + i]
        pull = parameters[Tracking.REJECTED_WIND] * payload * estimate[Estimate.WIND]
        correction[i] = correction[i] - mass * estimate[Estimate.DRIFT] - pull
    drift = memory[Tracker.PRESENT + Axes.ROPE, Estimate.DRIFT]
    rope = correction[Axes.ROPE] / parameters[Tracking.GAINS_PAYLOAD] - rejected * drift
    share = memory[Tracker.FADING, Fading.PAYLOAD]
    rope = (1.0 + share) * rope - share * parameters[Tracking.GRAVITY]
    correction[Axes.ROPE] = payload * rope


def track_hoist(parameters: 'float[:]', memory: 'float[:,:]') -> None:
    """The rope's acceleration for the limited force; update of the payload's estimate."""
    gravity = parameters[Tracking.GRAVITY]
    held = memory[Tracker.HELD, :]
    share = memory[Tracker.FADING, Fading.PAYLOAD]
    force = held[Held.CORRECTION + Axes.ROPE]
    rope = (force / parameters[Tracking.MASSES + Axes.ROPE] + share * gravity) / (1.0 + share)
    held[Held.INPUT + Axes.ROPE] = rope
    if track_acts(parameters, memory):
        share = share - parameters[Tracking.PAYLOAD_SHARE] * (1.0 + share) * rope / gravity
        memory[Tracker.FADING, Fading.PAYLOAD] = min(max(share, -0.98), 9.0)


def track_setpoint(
    parameters: 'float[:]',
    table: 'float[:,:,:]',
    gains: 'float[:,:,:]',
    tick: 'float[:,:]',
    memory: 'float[:,:]',
) -> None:
    """Compute the correction at a tick, held until the next one, and write it to `tick`.

    Only the limits use the setpoints to which it is added.
    """
    correction = tick[Tick.CORRECTION, :]
    held = memory[Tracker.HELD, :]
    step = memory[Tracker.FADING, :]
    reference = tick[Tick.REFERENCE, :]
    if memory[Tracker.COMMAND, VelocityCommand.STARTED] < 0.5:
        remember_start(reference, memory)
    remember_tick(parameters, reference, memory)
    aged_reference(parameters, memory)
    track_offset(parameters, tick, memory)
    track_observe(parameters, table, memory)
    track_law(parameters, gains, tick, memory)
    for i in range(3):
        if memory[Tracker.COMMAND, VelocityCommand.SWITCHED] > 0.5:
            # bumpless: the jump at a switch is added and fades out
            step[Fading.STEP + i] = held[Held.CORRECTION + i] - correction[i]
        step[Fading.STEP + i] = parameters[Tracking.DECAY] * step[Fading.STEP + i]
        correction[i] = correction[i] + step[Fading.STEP + i]
        bound_correction(i, parameters, tick, memory[Tracker.SITUATION, :])
        # the observer gets the limited correction, so nothing winds up
        held[Held.CORRECTION + i] = correction[i]
        held[Held.INPUT + i] = correction[i]
    if int(parameters[Tracking.MODE]) == DriveMode.FORCE:
        track_hoist(parameters, memory)
    memory[Tracker.COMMAND, VelocityCommand.SWITCHED] = 0.0
