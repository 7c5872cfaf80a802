"""The sampled controller and the drives' commands between two events.

`settings`, `setpoints` and `memory` are described in kernels/rig/rig.py.
"""

from math import exp

from segfmu.kernels.control.bounds import bound_correction, bound_return
from segfmu.kernels.control.feedback import feedback_correction
from segfmu.kernels.control.records import Acting, Correction, Situation, Tick, Tracker
from segfmu.kernels.control.tracking import track_setpoint
from segfmu.kernels.crane.plant import plant_advance
from segfmu.kernels.crane.records import (
    Axes,
    Plant,
    PlantStatus,
    Report,
    State,
    Vector,
    Work,
)
from segfmu.kernels.rig.delay import is_late, late_commands
from segfmu.kernels.rig.events import next_tick, present_time, time_tolerance, update_signals
from segfmu.kernels.rig.planned import follow_setpoint
from segfmu.kernels.rig.records import (
    Clock,
    Corrector,
    Loop,
    Memory,
    Planned,
    Setpoints,
    Settings,
)
from segfmu.kernels.rig.sensing import sensing_end
from segfmu.kernels.rig.setpoints import (
    follow_velocity,
    is_driven,
    set_command,
    set_load_force,
    setpoint_at,
    setpoint_rates,
)


def controller_due(settings: 'float[:,:]', memory: 'float[:,:]') -> bool:
    """Whether the controller's next tick has come."""
    return next_tick(settings, memory) <= present_time(memory) + time_tolerance(settings)


def prepare_tick(
    settings: 'float[:,:]', setpoints: 'float[:]', duration: float, memory: 'float[:,:]'
) -> None:
    """Prepare the controller's inputs for the tick that is due."""
    clock = memory[Memory.CLOCK, :]
    time = present_time(memory)
    share = clock[Clock.DONE] / duration
    clock[Clock.TICKS] = clock[Clock.TICKS] + 1.0
    clock[Clock.EVENT] = clock[Clock.START] + time
    update_signals(settings, time, memory)
    for i in range(State.SIZE):
        value = setpoint_at(setpoints, Setpoints.REFERENCE + i, share, memory)
        memory[Memory.REFERENCE, i] = value
    for i in range(3):
        if is_driven(memory):
            velocity = Setpoints.VELOCITY + i
            slope, _, _ = setpoint_rates(setpoints, velocity, share, duration, memory)
            value = setpoint_at(setpoints, velocity, share, memory)
            follow_setpoint(i, value, slope, settings[Settings.LOOP, Loop.PERIOD], memory)
            memory[Memory.ADDED_TO, i] = memory[Memory.PLANNED, Planned.ACCELERATION + i]
        else:
            value = setpoint_at(setpoints, Setpoints.FORCE + i, share, memory)
            memory[Memory.ADDED_TO, i] = value


def correct_setpoints(
    settings: 'float[:,:]',
    table: 'float[:,:,:]',
    gains: 'float[:,:,:]',
    tracker: 'float[:,:]',
    memory: 'float[:,:]',
) -> None:
    """The correction at a tick; the tracking controller's observer runs even if it is off."""
    if int(settings[Settings.LOOP, Loop.CORRECTOR]) == Corrector.TRACKING:
        track_setpoint(
            settings[Settings.TRACKING, :], table, gains, memory[0:Tick.SIZE, :], tracker
        )
    else:
        feedback_correction(
            memory[Memory.STATE, :], memory[Memory.REFERENCE, :], memory[Memory.ADDED, :], gains,
            memory[Memory.CORRECTION, :],
        )
        bound_feedback(settings, gains, tracker[Tracker.SITUATION, :], memory)
    switch_correction(settings, memory)


def bound_feedback(
    settings: 'float[:,:]', gains: 'float[:,:,:]', situation: 'float[:]', memory: 'float[:,:]'
) -> None:
    """Bound the feedback of the true state by what the drives can do."""
    parameters = settings[Settings.TRACKING, :]
    state = memory[Memory.STATE, :]
    reference = memory[Memory.REFERENCE, :]
    plant = memory[Memory.PLANT, :]
    tick = memory[0:Tick.SIZE, :]
    length = state[State.POSITION + Axes.ROPE]
    situation[Situation.WEIGHT] = plant[Plant.PAYLOAD_MASS] * plant[Plant.GRAVITY]
    situation[Situation.LENGTH] = length
    for i in range(Axes.SIZE):
        velocity = state[State.VELOCITY + i]
        if is_driven(memory):
            velocity = reference[State.VELOCITY + i] + memory[Memory.ADDED, i]
        situation[Situation.VELOCITY + i] = velocity
        place = state[State.POSITION + i] - reference[State.POSITION + i]
        rate = state[State.VELOCITY + i] - reference[State.VELOCITY + i]
        if i != Axes.ROPE:
            sign = 1.0 - 2.0 * i
            angle = state[State.ANGLE + i] - reference[State.ANGLE + i]
            swing = state[State.RATE + i] - reference[State.RATE + i]
            place = place + length * sign * angle
            rate = rate + length * sign * swing
        situation[Situation.PLACE + i] = place
        situation[Situation.RATE + i] = rate
        bound_return(i, parameters, gains, tick, situation)
        bound_correction(i, parameters, tick, situation)


def switch_correction(settings: 'float[:,:]', memory: 'float[:,:]') -> None:
    """Switch the new correction on or off; the jump at a change fades out.

    A caller with a controller of its own calls it after writing its correction to the memory.
    """
    loop = settings[Settings.LOOP, :]
    correction = memory[Memory.CORRECTION, :]
    acts = float(Acting.ON)
    if loop[Loop.ENABLED] < 0.5:
        acts = float(Acting.OFF)
    decay = 0.0
    if loop[Loop.FADE] > 0.0:
        decay = exp(-loop[Loop.PERIOD] / loop[Loop.FADE])
    acted = correction[Correction.ACTED]
    for i in range(3):
        if loop[Loop.ENABLED] < 0.5:
            correction[Correction.VALUE + i] = 0.0
            if is_driven(memory):
                # the added velocity must return to zero
                fade = max(loop[Loop.FADE], loop[Loop.PERIOD])
                correction[Correction.VALUE + i] = -memory[Memory.ADDED, i] / fade
        value = correction[Correction.VALUE + i]
        fading = correction[Correction.FADING + i]
        if acted > 0.5 and acted != acts:
            fading = correction[Correction.BEFORE + i] - value
        fading = decay * fading
        correction[Correction.FADING + i] = fading
        correction[Correction.VALUE + i] = value + fading
        correction[Correction.BEFORE + i] = value + fading
    correction[Correction.ACTED] = acts


def advance_plant(
    settings: 'float[:,:]',
    components: 'float[:,:]',
    setpoints: 'float[:]',
    duration: float,
    until: float,
    memory: 'float[:,:]',
) -> int:
    """Integrate until a time [s] within the step; returns a `PlantStatus`."""
    clock = memory[Memory.CLOCK, :]
    report = memory[Memory.REPORT, :]
    work = memory[Memory.WORK:Memory.WORK + Work.SIZE, :]
    time = clock[Clock.START] + clock[Clock.REACHED] + clock[Clock.DONE]
    if is_driven(memory):
        command_velocities(setpoints, duration, until, memory)
    else:
        command_forces(setpoints, duration, memory)
    if is_late(memory):
        late_commands(
            settings, until - clock[Clock.DONE], memory,
            memory[sensing_end(settings):memory.shape[0], :],
        )
    follow_wind(setpoints, duration, memory)
    status = plant_advance(
        memory[Memory.PLANT, :], components, time, memory[Memory.STATE, :],
        until - clock[Clock.DONE], settings[Settings.LOOP, Loop.TOLERANCE], work, report,
    )
    for i in range(3):
        before = report[Report.STEP_SATURATED + i]
        report[Report.STEP_SATURATED + i] = max(before, report[Report.SATURATED + i])
    if status != PlantStatus.DONE:
        clock[Clock.EVENT] = time + report[Report.ELAPSED]
    return status


def follow_wind(setpoints: 'float[:]', duration: float, memory: 'float[:,:]') -> None:
    """The given force on the load now, and its rates."""
    share = memory[Memory.CLOCK, Clock.DONE] / duration
    for i in range(Vector.SIZE):
        place = Setpoints.WIND + i
        force = setpoint_at(setpoints, place, share, memory)
        slope, square, cube = setpoint_rates(setpoints, place, share, duration, memory)
        set_load_force(i, force, slope, square, cube, memory)


def command_forces(setpoints: 'float[:]', duration: float, memory: 'float[:,:]') -> None:
    """Commands of force drives now, and their rates."""
    share = memory[Memory.CLOCK, Clock.DONE] / duration
    for i in range(3):
        force = setpoint_at(setpoints, Setpoints.FORCE + i, share, memory)
        slope, square, cube = setpoint_rates(
            setpoints, Setpoints.FORCE + i, share, duration, memory
        )
        correction = memory[Memory.CORRECTION, Correction.VALUE + i]
        set_command(i, force + correction, slope, square, cube, memory)


def command_velocities(
    setpoints: 'float[:]', duration: float, until: float, memory: 'float[:,:]'
) -> None:
    """Commands of velocity drives and their rates until a time; advances the added velocities."""
    done = memory[Memory.CLOCK, Clock.DONE]
    length = until - done
    for i in range(3):
        velocity = Setpoints.VELOCITY + i
        correction = memory[Memory.CORRECTION, Correction.VALUE + i]
        added = memory[Memory.ADDED, i]
        command = setpoint_at(setpoints, velocity, done / duration, memory) + added
        slope, square, cube = setpoint_rates(
            setpoints, velocity, done / duration, duration, memory
        )
        memory[Memory.ADDED, i] = added + correction * length
        set_command(i, command, slope + correction, square, cube, memory)
        if memory[Memory.PLANT, Plant.LAG + i] == 0.0:
            end = setpoint_at(setpoints, velocity, until / duration, memory)
            follow_velocity(i, end + memory[Memory.ADDED, i], square, cube, length, memory)
