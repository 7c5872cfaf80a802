"""The crane with drives, friction and wind, integrated adaptively over an interval.

`plant` is a `Plant`, `state` a `PlantState`, `work` a `Work` whose first rows are the commands, see
crane/records.py; components (count, 8): a `Sinusoid` a row, the wind's noise.
"""

from segfmu.kernels.crane.buffers import buffer_force
from segfmu.kernels.crane.drives import (
    driven_derivative,
    forced_derivative,
)
from segfmu.kernels.crane.friction import deflection_rate, friction_force
from segfmu.kernels.crane.records import (
    Action,
    Axes,
    DriveMode,
    GeneralisedForce,
    Load,
    Plant,
    PlantState,
    PlantStatus,
    Report,
    StageAction,
    State,
    Work,
)
from segfmu.kernels.crane.slack import (
    axis_position,
    axis_velocity,
    bears_wrongly,
    change_rope,
    may_slacken,
)
from segfmu.kernels.crane.suspension import has_tackle, suspended_load
from segfmu.kernels.crane.wind import command_slope, wind_force
from segfmu.kernels.numerics.integrate import (
    all_finite,
    next_step,
    stage_node,
    stage_state,
    step_error,
)
from segfmu.kernels.numerics.records import Stages


def plant_derivative(
    plant: 'float[:]',
    components: 'float[:,:]',
    time: float,
    elapsed: float,
    state: 'float[:]',
    work: 'float[:,:]',
    derivative: 'float[:]',
) -> None:
    """Derivative of the state at a time [s] elapsed since the interval's start, `time` [s]."""
    rate = work[Work.RATES, :]
    wind_force(plant, components, time, elapsed, state, work)
    for i in range(3):
        slope = command_slope(i, elapsed, rate)
        demand = work[Work.COMMAND, i] + elapsed * slope
        velocity = axis_velocity(state, i)
        deflection = state[PlantState.DEFLECTION + i]
        resistance = buffer_force(plant, i, axis_position(state, i), velocity)
        resistance = resistance + friction_force(plant, i, velocity, deflection)
        deflecting = deflection_rate(plant, i, velocity, deflection)
        # what is read before anything is written is read once
        work[Work.DEMAND, i] = demand
        work[Work.FRICTION, i] = resistance
        derivative[PlantState.DEFLECTION + i] = deflecting
        work[Work.ACTION, Action.SATURATED + i] = 0.0
    for i in range(2):
        derivative[PlantState.SLING_ANGLE + i] = 0.0
        derivative[PlantState.SLING_RATE + i] = 0.0
    derivative[PlantState.SLACK] = 0.0
    derivative[PlantState.PAID_OUT] = 0.0
    derivative[PlantState.PAYING_OUT] = 0.0
    for i in range(2):
        torque = -plant[Plant.SWAY_DAMPING] * state[State.RATE + i]
        work[Work.GENERALISED, GeneralisedForce.TORQUE + i] = torque
    if int(plant[Plant.MODE]) == DriveMode.VELOCITY:
        driven_derivative(plant, state, work, derivative)
    else:
        forced_derivative(plant, state, work, derivative)
    plant_powers(plant, state, work, derivative)


def plant_powers(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', derivative: 'float[:]'
) -> None:
    """Powers of drives, wind and friction [W]: the derivatives of their work."""
    wind = work[Work.WIND, :]
    # no wind, no work: skips the load's velocity
    calm = wind[0] == 0.0 and wind[1] == 0.0 and wind[2] == 0.0
    if not calm:
        suspended_load(plant, state, work, work[Work.LOAD:Work.LOAD + Load.SIZE, :])
    squares = state[State.RATE] * state[State.RATE]
    squares = squares + state[State.RATE + 1] * state[State.RATE + 1]
    derivative[PlantState.DRIVE_WORK] = 0.0
    derivative[PlantState.WIND_WORK] = 0.0
    derivative[PlantState.DISSIPATED] = plant[Plant.SWAY_DAMPING] * squares
    if may_slacken(plant) and work[Work.ACTION, Action.ROPE_FORCE] >= 0.0:
        # the sway is damped by a rope that bears
        derivative[PlantState.DISSIPATED] = 0.0
    for i in range(3):
        velocity = axis_velocity(state, i)
        drive = work[Work.ACTION, Action.FORCE + i] * velocity
        derivative[PlantState.DRIVE_WORK] = derivative[PlantState.DRIVE_WORK] + drive
        if not calm:
            power = wind[i] * work[Work.LOAD + Load.VELOCITY, i]
            derivative[PlantState.WIND_WORK] = derivative[PlantState.WIND_WORK] + power
        lost = work[Work.FRICTION, i] * velocity
        derivative[PlantState.DISSIPATED] = derivative[PlantState.DISSIPATED] + lost


def changing_components(plant: 'float[:]') -> int:
    """First components of the state that change: the last ones only with a sling or slack rope."""
    if may_slacken(plant) or has_tackle(plant):
        return PlantState.SIZE
    return PlantState.SLING_ANGLE


def reuse_last_stage(plant: 'float[:]', work: 'float[:,:]') -> None:
    """Use the last stage of a step, at its end, as the first stage of the next step."""
    action = work[Work.ACTION, :]
    for i in range(changing_components(plant)):
        work[Work.STAGES, i] = work[Work.STAGES + Stages.K7, i]
    for i in range(3):
        action[StageAction.SATURATED_BEFORE + i] = action[Action.SATURATED + i]


def first_stage(
    plant: 'float[:]',
    components: 'float[:,:]',
    time: float,
    elapsed: float,
    state: 'float[:]',
    work: 'float[:,:]',
) -> None:
    """Derivative from which the next step starts, where none leads up to the state."""
    plant_derivative(
        plant, components, time, elapsed, state, work, work[Work.STAGES + Stages.K7, :]
    )
    reuse_last_stage(plant, work)


def try_step(
    plant: 'float[:]',
    components: 'float[:,:]',
    time: float,
    elapsed: float,
    state: 'float[:]',
    h: float,
    work: 'float[:,:]',
) -> float:
    """Try a step of length h [s] from the derivative of the first stage on; returns the error.

    The new state is the trial state of work.
    """
    stages = work[Work.STAGES:Work.STAGES + Stages.SIZE, :]
    trial = work[Work.TRIAL, :]
    last = changing_components(plant)
    for stage in range(1, Stages.SIZE):
        count = last
        if stage != Stages.K7 and last < PlantState.SIZE:
            # the derivatives do not depend on the work
            count = PlantState.DRIVE_WORK
        # values beyond all bounds: the step was much too long
        if not stage_state(stage, h, count, state, stages, trial) < 1e100:
            return 1e100
        plant_derivative(
            plant, components, time, elapsed + stage_node(stage) * h, trial, work,
            work[Work.STAGES + stage, :],
        )
    return step_error(h, last, state, trial, stages)


def plant_advance(
    plant: 'float[:]',
    components: 'float[:,:]',
    time: float,
    state: 'float[:]',
    duration: float,
    tolerance: float,
    work: 'float[:,:]',
    report: 'float[:]',
) -> int:
    """Advance the state, in place, by a duration [s] from a time [s] on.

    tolerance: relative and absolute error of a step. report: a `Report`; the caller collects the
    drives that were at a bound in the communication step.

    Returns a `PlantStatus`. A failure, and a rope that goes slack or taut where it may, is located
    to 0.1 us; after a failure the state is the last valid one. With
    stiff friction, STEP_TOO_SMALL also means too many steps.
    """
    for i in range(Report.STEP_SATURATED):
        report[i] = 0.0
    finite = all_finite(state, PlantState.SIZE) and all_finite(work[Work.COMMAND, :], 3)
    if not finite or not all_finite(work[Work.LOAD_FORCE, :], 3):
        return PlantStatus.NOT_FINITE
    first_stage(plant, components, time, 0.0, state, work)
    t = 0.0
    # the previous step is a better guess than the interval, which may need many steps
    planned = work[Work.STEP, 0]
    if planned <= 0.0:
        planned = duration
    h = planned
    for _ in range(200000):
        last = h >= duration - t
        if last:
            planned = h
            h = duration - t
        error = try_step(plant, components, time, t, state, h, work)
        if error > tolerance:
            h = h * next_step(error, tolerance)
            if h < 1e-12 * duration:
                return PlantStatus.STEP_TOO_SMALL
            continue
        status = plant_status(plant, work[Work.TRIAL, :], work[Work.ACTION, :])
        if status != PlantStatus.DONE:
            if h >= 1e-7:
                h = 0.5 * h
                continue
            if status != PlantStatus.SLACK_ROPE or not may_slacken(plant):
                return status
            change_rope(plant, state)
            first_stage(plant, components, time, t, state, work)
            h = duration - t
            continue
        t = t + h
        h = h * next_step(error, tolerance)
        accept_step(plant, state, work, t, report)
        if last:
            # a step shortened by the interval's end is a worse guess than the step planned before
            work[Work.STEP, 0] = max(h, planned)
            return PlantStatus.DONE
        reuse_last_stage(plant, work)
    return PlantStatus.STEP_TOO_SMALL


def accept_step(
    plant: 'float[:]', state: 'float[:]', work: 'float[:,:]', elapsed: float, report: 'float[:]'
) -> None:
    """Accept the trial state, and report the forces in it."""
    action = work[Work.ACTION, :]
    for i in range(changing_components(plant)):
        state[i] = work[Work.TRIAL, i]
    for i in range(3):
        saturated = max(action[Action.SATURATED + i], action[StageAction.SATURATED_BEFORE + i])
        report[Report.FORCE + i] = action[Action.FORCE + i]
        report[Report.SATURATED + i] = max(report[Report.SATURATED + i], saturated)
    report[Report.ROPE_FORCE] = action[Action.ROPE_FORCE]
    report[Report.SLING_TENSION] = action[Action.SLING_TENSION]
    report[Report.WIND_POWER] = work[Work.STAGES + Stages.K7, PlantState.WIND_WORK]
    report[Report.FRICTION_POWER] = work[Work.STAGES + Stages.K7, PlantState.DISSIPATED]
    report[Report.ELAPSED] = elapsed


def plant_status(plant: 'float[:]', state: 'float[:]', action: 'float[:]') -> int:
    """Whether the crane is within the range of its equations: a `PlantStatus`; action: `Action`."""
    for i in range(2):
        if abs(state[State.ANGLE + i]) >= 1.57 or abs(state[PlantState.SLING_ANGLE + i]) >= 1.57:
            return PlantStatus.SWAY_ANGLE
    if state[State.POSITION + Axes.ROPE] <= 0.0:
        return PlantStatus.ROPE_LENGTH
    for i in range(3):
        # rest exactly at the limit is allowed, and a buffer gives way
        if plant[Plant.STIFFNESS + i] > 0.0:
            continue
        position = axis_position(state, i)
        if position < plant[Plant.TRAVEL_MIN + i] - 1e-9:
            return PlantStatus.BELOW_TRAVEL + i
        if position > plant[Plant.TRAVEL_MAX + i] + 1e-9:
            return PlantStatus.ABOVE_TRAVEL + i
    if bears_wrongly(plant, state, action[Action.ROPE_FORCE]):
        return PlantStatus.SLACK_ROPE
    least = -1e-9 * plant[Plant.PAYLOAD_MASS] * plant[Plant.GRAVITY]
    if has_tackle(plant) and action[Action.SLING_TENSION] < least:
        return PlantStatus.SLACK_SLING
    return PlantStatus.DONE
