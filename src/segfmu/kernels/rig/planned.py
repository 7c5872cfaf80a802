"""Accelerations of drives with lag under their velocity setpoints alone.

A setpoint is ahead of its drive, v + T v', so its slope v' + T v'' is not what the drive does: it
exceeds every bound of the acceleration where a plan has much jerk. The drive's own equation tells,
at the ticks of the controller; between them setpoints count as linear.

`memory` is a `Memory`, its row PLANNED a `Planned`.
"""

from math import exp

from segfmu.kernels.crane.bounds import exceeds, limited
from segfmu.kernels.crane.records import Axes, Plant, State
from segfmu.kernels.rig.records import Clock, Memory, Planned, Setpoints


def start_planned(setpoints: 'float[:]', memory: 'float[:,:]') -> None:
    """Drives start with the velocities of the state."""
    planned = memory[Memory.PLANNED, :]
    for i in range(Axes.SIZE):
        planned[Planned.SETPOINT + i] = setpoints[Setpoints.VELOCITY + i]
        planned[Planned.VELOCITY + i] = memory[Memory.STATE, State.VELOCITY + i]


def follow_setpoint(
    axis: int, setpoint: float, period: float, memory: 'float[:,:]'
) -> None:
    """Advance the velocity of a drive with lag from the last tick, a period [s] ago, to this one.

    It falls behind a ramp of the setpoint by the lag times the slope.
    """
    planned = memory[Memory.PLANNED, :]
    lag = memory[Memory.PLANT, Plant.LAG + axis]
    before = planned[Planned.SETPOINT + axis]
    velocity = planned[Planned.VELOCITY + axis]
    bound = memory[Memory.PLANT, Plant.VELOCITY_MAX + axis]
    reached = setpoint
    if exceeds(setpoint, bound):
        reached = limited(setpoint, bound)
    planned[Planned.SETPOINT + axis] = reached
    # nothing has passed before the first tick
    if memory[Memory.CLOCK, Clock.TICKS] > 1.5 and lag > 0.0:
        behind = lag * (reached - before) / period
        gained = reached - behind - velocity - (before - behind - velocity) * exp(-period / lag)
        most = period * memory[Memory.PLANT, Plant.ACCELERATION_MAX + axis]
        if exceeds(gained, most):
            gained = limited(gained, most)
        planned[Planned.VELOCITY + axis] = velocity + gained


def planned_acceleration(axis: int, slope: float, memory: 'float[:,:]') -> float:
    """Acceleration of a drive under its setpoint alone, at a tick; without lag the slope."""
    lag = memory[Memory.PLANT, Plant.LAG + axis]
    planned = memory[Memory.PLANNED, :]
    if lag > 0.0:
        return (planned[Planned.SETPOINT + axis] - planned[Planned.VELOCITY + axis]) / lag
    return slope
