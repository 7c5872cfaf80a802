"""Accelerations of drives with lag under their velocity setpoints alone.

A setpoint is ahead of its drive, v + T v', so its slope v' + T v'' is not what the drive does: it
exceeds every bound of the acceleration where a plan has much jerk. The drive's own equation tells,
at the ticks of the controller; between them setpoints count as linear.

`memory` is a `Memory`, its row PLANNED a `Planned`.
"""

from math import exp

from segfmu.kernels.crane.bounds import acceleration_bound, exceeds, limited, velocity_bound
from segfmu.kernels.crane.records import Axes, Plant, State
from segfmu.kernels.rig.records import Clock, Memory, Planned, Setpoints


def start_planned(setpoints: 'float[:]', memory: 'float[:,:]') -> None:
    """Drives start with the velocities of the state."""
    planned = memory[Memory.PLANNED, :]
    for i in range(Axes.SIZE):
        value = setpoints[Setpoints.VELOCITY + i]
        lag = memory[Memory.PLANT, Plant.LAG + i]
        planned[Planned.SETPOINT + i] = value
        if lag > 0.0:
            behind = value - memory[Memory.STATE, State.VELOCITY + i]
            planned[Planned.ACCELERATION + i] = behind / lag


def follow_setpoint(
    axis: int, setpoint: float, slope: float, period: float, memory: 'float[:,:]'
) -> None:
    """Advance the acceleration of a drive from the last tick, a period [s] ago, to this one.

    Without lag it is the slope [m/s2] of the setpoint. With lag it approaches the mean slope since
    the last tick; a drive at the bound of its acceleration falls farther behind.
    """
    planned = memory[Memory.PLANNED, :]
    lag = memory[Memory.PLANT, Plant.LAG + axis]
    if lag <= 0.0:
        planned[Planned.ACCELERATION + axis] = slope
        return
    bound = velocity_bound(memory[Memory.PLANT, :], axis, setpoint)
    reached = setpoint
    if exceeds(setpoint, bound):
        reached = limited(setpoint, bound)
    risen = reached - planned[Planned.SETPOINT + axis]
    planned[Planned.SETPOINT + axis] = reached
    # nothing has passed before the first tick
    if memory[Memory.CLOCK, Clock.TICKS] > 1.5:
        before = planned[Planned.ACCELERATION + axis]
        mean = risen / period
        after = mean + (before - mean) * exp(-period / lag)
        gained = risen - lag * (after - before)
        most = period * acceleration_bound(memory[Memory.PLANT, :], axis, gained)
        if exceeds(gained, most):
            after = before + (risen - limited(gained, most)) / lag
        planned[Planned.ACCELERATION + axis] = after
