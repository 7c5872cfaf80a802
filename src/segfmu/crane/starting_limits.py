"""Limits of the load's motion to begin a search with, from the bounds of the drives alone.

Each is what the drive could do if the rope were rigid; the ramps last a multiple of half the
pendulum's period, the time in which the load takes over the carriage's acceleration.
"""

from __future__ import annotations

from math import isfinite, pi, tan

import numpy as np

from segfmu.crane.bounds import DRIVES, ActuatorBounds
from segfmu.crane.drive_task import SEARCHED, Task
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels.crane.records import RopeDemand
from segfmu.kernels.messages import ROPE_LIMITS
from segfmu.planning.arrays import FloatArray

HOIST = 2
BELOW = RopeDemand.BELOW_TROLLEY
# least bounds of a drive [m/s, m/s2]: in slower plans the clock is too coarse for ramps
SLOWEST = 1e-5
# downward acceleration in units of gravity that leaves the rope taut
TAUT = 0.9
# acceleration in units of gravity where a bound hardly lifts the load
LEAST = 1e-3
# sway [rad] whose tangent is still of use
STEEPEST = 1.0
# ramps over half of the pendulum's period, or over the time of the hoist to its speed
MULTIPLES = (0.5, 0.8, 1.25, 2.0)
HOIST_RAMP = 0.3
# peaks of the first and second derivative of a ramp over one second of height one
JERK, SNAP = 1.9, 5.8


def starting_tables(task: Task, bounds: ActuatorBounds) -> list[FloatArray]:
    """Tables of limits (3, 4), one per multiple of the ramps' duration.

    Raises
    ------
    InputError
        For an axis that moves although nothing bounds its acceleration, or hardly at all.
    InfeasibleError
        For a waypoint that is not below the trolley.
    """
    _require_below(task)
    rope = max(-float(p.position[HOIST]) for p in task.waypoints)
    swing = pi * (rope / task.crane.gravity) ** 0.5
    _require_pace(task, bounds)
    motions = {int(axis): _rigid(task, bounds, int(axis)) for axis in task.moving}
    tables = []
    for multiple in MULTIPLES:
        table = np.ones((3, SEARCHED))
        for axis, (velocity, acceleration, distance) in motions.items():
            rise = min(velocity / acceleration, (distance / acceleration) ** 0.5)
            ramp = multiple * (HOIST_RAMP * rise if axis == HOIST else min(swing, 2.0 * rise))
            table[axis] = (
                velocity, acceleration, JERK * acceleration / ramp, SNAP * acceleration / ramp**2
            )
        tables.append(np.minimum(table, task.caps))
    return tables


def _require_below(task: Task) -> None:
    for number, point in enumerate(task.waypoints, 1):
        height = float(point.position[HOIST])
        if height >= 0.0:
            raise InfeasibleError(
                f"waypoint {number}: position z {abs(height):g} m must be below the trolley, "
                "z < 0; lower the waypoint",
                axis=HOIST, interval=max(number - 1, 1), limit=ROPE_LIMITS[BELOW], value=height,
                bound=0.0,
            )


def _require_pace(task: Task, bounds: ActuatorBounds) -> None:
    for axis in task.moving.tolist():
        for name, unit in (("velocity", "m/s"), ("acceleration", "m/s2")):
            bound = float(getattr(bounds, name)[axis])
            if bound < SLOWEST:
                raise InputError(
                    f"axis {'xyz'[axis]}: {DRIVES[axis]} {name} must have a bound of at least "
                    f"{SLOWEST:g} {unit}, got {bound:g} {unit}; raise the bound"
                )


def _rigid(task: Task, bounds: ActuatorBounds, axis: int) -> tuple[float, float, float]:
    """Velocity, acceleration and largest distance of an axis, as if the rope were rigid."""
    crane, power = task.crane, float(bounds.power[axis])
    velocity = min(float(bounds.velocity[axis]), float(task.caps[axis, 0]))
    held = float(task.sticking[axis]) + (task.weight if axis == HOIST else 0.0)
    mass = crane.payload_mass
    mass += (crane.bridge_mass + crane.trolley_mass, crane.trolley_mass, 0.0)[axis]
    distance = float(np.abs(np.diff([p.position[axis] for p in task.waypoints])).max())
    fastest = float(np.abs(task.states[:, 0, axis]).max())
    accelerations = [float(bounds.acceleration[axis]), float(task.caps[axis, 1])]
    if isfinite(bounds.force[axis]):
        accelerations.append(max((bounds.force[axis] - held) / mass, LEAST * crane.gravity))
    if axis != HOIST and isfinite(bounds.sway_angle[axis]):
        accelerations.append(crane.gravity * tan(min(float(bounds.sway_angle[axis]), STEEPEST)))
    acceleration = min(accelerations)
    if isfinite(power) and not isfinite(acceleration):
        # constant power covers the distance in about this time
        time = (mass * distance**2 / power) ** (1.0 / 3.0)
        acceleration = min(velocity / time, distance / time**2)
    if not isfinite(acceleration):
        raise InputError(
            f"axis {'xyz'[axis]}: nothing bounds the acceleration; give a bound of the "
            f"{DRIVES[axis]}'s acceleration, force or power, or limits of the load"
        )
    # more would make the rope slack, or swing it near to the horizontal
    acceleration = min(acceleration, crane.gravity * (TAUT if axis == HOIST else tan(STEEPEST)))
    distance = distance or fastest**2 / acceleration
    if isfinite(power):
        velocity = min(velocity, power / (held + mass * acceleration))
    return min(velocity, 2.0 * (acceleration * distance) ** 0.5), acceleration, distance
