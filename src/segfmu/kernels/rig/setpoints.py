"""Setpoints within a communication step, and the commands of the drives.

`setpoints` and `memory` are described in kernels/rig/rig.py.
"""

from segfmu.kernels.crane.bounds import exceeds, limited, velocity_bound
from segfmu.kernels.crane.records import CommandRates, DriveMode, Plant, Report, Work
from segfmu.kernels.crane.slack import axis_velocity
from segfmu.kernels.rig.records import Memory


def is_driven(memory: 'float[:,:]') -> bool:
    """Whether the drives follow velocities."""
    return int(memory[Memory.PLANT, Plant.MODE]) == DriveMode.VELOCITY


def setpoint_at(setpoints: 'float[:]', i: int, share: float, memory: 'float[:,:]') -> float:
    """A setpoint at a share of the step."""
    last = memory[Memory.LAST, i]
    bend = memory[Memory.SQUARE, i] + memory[Memory.CUBE, i] * (share + 1.0)
    return last + (setpoints[i] - last + bend * (share - 1.0)) * share


def setpoint_rates(
    setpoints: 'float[:]', i: int, share: float, duration: float, memory: 'float[:,:]'
) -> 'tuple[float, float, float]':
    """Taylor coefficients over time of a setpoint at a share of the step: slope, square, cube."""
    square = memory[Memory.SQUARE, i]
    cube = memory[Memory.CUBE, i]
    slope = setpoints[i] - memory[Memory.LAST, i] - square - cube
    slope = slope + (2.0 * square + 3.0 * cube * share) * share
    bend = (square + 3.0 * cube * share) / (duration * duration)
    return slope / duration, bend, cube / (duration * duration * duration)


def bounded_velocity(axis: int, velocity: float, memory: 'float[:,:]') -> float:
    """A velocity within the bound of its drive, which counts as saturated beyond it."""
    bound = velocity_bound(memory[Memory.PLANT, :], axis, velocity)
    if exceeds(velocity, bound):
        memory[Memory.REPORT, Report.STEP_SATURATED + axis] = 1.0
        return limited(velocity, bound)
    return velocity


def set_polynomial(
    row: int, rates: int, i: int, value: float, slope: float, square: float, cube: float,
    memory: 'float[:,:]',
) -> None:
    """Component of a row of `Work`, and its coefficients over the elapsed time in another."""
    memory[Memory.WORK + row, i] = value
    memory[Memory.WORK + rates, CommandRates.LINEAR + i] = slope
    memory[Memory.WORK + rates, CommandRates.SQUARE + i] = square
    memory[Memory.WORK + rates, CommandRates.CUBE + i] = cube


def set_command(
    axis: int, value: float, slope: float, square: float, cube: float, memory: 'float[:,:]'
) -> None:
    """Command of a drive, and its coefficients over the elapsed time."""
    set_polynomial(Work.COMMAND, Work.RATES, axis, value, slope, square, cube, memory)


def follow_velocity(
    axis: int, end: float, square: float, cube: float, length: float, memory: 'float[:,:]'
) -> None:
    """Command of a drive without lag for a length of time [s]: the acceleration of its setpoint.

    At the end it has its setpoint [m/s], even after saturation; square and cube are the setpoint's
    Taylor coefficients.
    """
    bend = square + cube * length
    velocity = bounded_velocity(axis, end, memory)
    if velocity != end:
        square = 0.0
        cube = 0.0
        bend = 0.0
    mean = (velocity - axis_velocity(memory[Memory.STATE, :], axis)) / length
    set_command(axis, mean - bend * length, 2.0 * square, 3.0 * cube, 0.0, memory)


def set_load_force(
    i: int, value: float, slope: float, square: float, cube: float, memory: 'float[:,:]'
) -> None:
    """Component of the given force on the load, and its coefficients over the elapsed time."""
    set_polynomial(Work.LOAD_FORCE, Work.LOAD_RATES, i, value, slope, square, cube, memory)
