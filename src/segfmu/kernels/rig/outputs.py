"""Outputs of the crane's FMU from a rig and its controller."""

from math import atan2, cos, sin, sqrt

from segfmu.kernels.control.records import (
    Estimate,
    Estimates,
    Fading,
    OffsetEstimate,
    OffsetMemory,
    Tracker,
    Tracking,
)
from segfmu.kernels.crane.records import (
    Axes,
    Coordinates,
    Load,
    Plant,
    PlantState,
    Report,
    State,
    Vector,
    Work,
)
from segfmu.kernels.crane.slack import axis_velocity
from segfmu.kernels.crane.suspension import suspended_load
from segfmu.kernels.rig.records import Balance, Memory, Outputs
from segfmu.kernels.rig.rig import rig_balance, rig_imbalance


def rig_outputs(
    target: 'float[:]', memory: 'float[:,:]', balance: 'float[:]', outputs: 'float[:]'
) -> None:
    """Write Outputs; target: reference of the load (Target), balance (Balance): work space."""
    state = memory[Memory.STATE, :]
    for i in range(State.SIZE):
        outputs[Outputs.STATE + i] = state[i]
    for i in range(Axes.SIZE):
        outputs[Outputs.DEFLECTION + i] = state[PlantState.DEFLECTION + i]
    for i in range(Coordinates.SIZE):
        outputs[Outputs.MEASURED + i] = memory[Memory.SIGNALS, i]
    load_outputs(target, memory, outputs)
    outputs[Outputs.TOTAL_SWAY] = total_sway(state[State.ANGLE], state[State.ANGLE + 1])
    drive_outputs(memory, outputs)
    rig_balance(memory, balance)
    outputs[Outputs.KINETIC] = balance[Balance.KINETIC]
    outputs[Outputs.POTENTIAL] = balance[Balance.POTENTIAL]
    outputs[Outputs.WORK] = state[PlantState.DRIVE_WORK] + state[PlantState.WIND_WORK]
    outputs[Outputs.DRIVE_WORK] = balance[Balance.DRIVES]
    outputs[Outputs.WIND_WORK] = balance[Balance.WIND]
    outputs[Outputs.PAYLOAD] = balance[Balance.PAYLOAD]
    outputs[Outputs.DISSIPATED] = balance[Balance.DISSIPATED]
    outputs[Outputs.IMBALANCE] = rig_imbalance(balance)


def total_sway(angle_x: float, angle_y: float) -> float:
    """Angle [rad] between rope and vertical, of the angles phi_x and phi_y [rad] of (16)."""
    across = cos(angle_x) * sin(angle_y)
    return atan2(sqrt(sin(angle_x) * sin(angle_x) + across * across), cos(angle_x) * cos(angle_y))


def load_outputs(target: 'float[:]', memory: 'float[:,:]', outputs: 'float[:]') -> None:
    """The load's motion and speed, and its distance from where it shall be."""
    load = memory[Memory.WORK + Work.LOAD : Memory.WORK + Work.LOAD + Load.SIZE, :]
    suspended_load(
        memory[Memory.PLANT, :], memory[Memory.STATE, :],
        memory[Memory.WORK:Memory.WORK + Work.SIZE, :], load,
    )
    square = 0.0
    speed = 0.0
    for i in range(Vector.SIZE):
        speed = speed + load[Load.VELOCITY, i] * load[Load.VELOCITY, i]
        error = load[Load.POSITION, i] - target[i]
        outputs[Outputs.LOAD_POSITION + i] = load[Load.POSITION, i]
        outputs[Outputs.LOAD_VELOCITY + i] = load[Load.VELOCITY, i]
        outputs[Outputs.ERROR + i] = error
        square = square + error * error
    outputs[Outputs.LOAD_SPEED] = sqrt(speed)
    outputs[Outputs.ERROR_NORM] = sqrt(square)


def drive_outputs(memory: 'float[:,:]', outputs: 'float[:]') -> None:
    """Forces and powers of drives, rope and wind."""
    report = memory[Memory.REPORT, :]
    for i in range(Axes.SIZE):
        outputs[Outputs.FORCE + i] = report[Report.FORCE + i]
        outputs[Outputs.SATURATED + i] = report[Report.STEP_SATURATED + i]
        outputs[Outputs.POWER + i] = (
            report[Report.FORCE + i] * axis_velocity(memory[Memory.STATE, :], i)
        )
    outputs[Outputs.ROPE_FORCE] = report[Report.ROPE_FORCE]
    outputs[Outputs.WIND_POWER] = report[Report.WIND_POWER]
    outputs[Outputs.FRICTION_POWER] = report[Report.FRICTION_POWER]
    outputs[Outputs.PAYLOAD_MASS] = memory[Memory.PLANT, Plant.PAYLOAD_MASS]


def tracking_estimates(
    parameters: 'float[:]', tracker: 'float[:,:]', estimates: 'float[:]'
) -> None:
    """Write the estimates (Estimates) of a tracking controller (Tracking, Tracker)."""
    estimates[Estimates.PAYLOAD_MASS] = parameters[Tracking.MASSES + Axes.ROPE] * (
        1.0 + tracker[Tracker.FADING, Fading.PAYLOAD]
    )
    for i in range(Axes.SIZE):
        estimates[Estimates.DRIFT + i] = tracker[Tracker.PRESENT + i, Estimate.DRIFT]
    for i in range(Estimates.ROPE_OFFSET - Estimates.WIND):
        estimates[Estimates.WIND + i] = tracker[Tracker.PRESENT + i, Estimate.WIND]
    estimates[Estimates.ROPE_OFFSET] = tracker[
        Tracker.OFFSET + OffsetMemory.ESTIMATE, OffsetEstimate.USED
    ]
