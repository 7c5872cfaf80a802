"""Limits of the load's motion to begin a search with, from the bounds of the drives alone.

Each is what the drive could do if the rope were rigid; the ramps last a multiple of half the
pendulum's period, the time in which the load takes over the carriage's acceleration.
"""

from __future__ import annotations

from math import isfinite, pi, tan

import numpy as np

from segfmu.crane.bounds import DRIVES
from segfmu.crane.drive_task import COLUMNS, DIRECTED, HOIST, SEARCHED, Task
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels.crane.records import Demand, RopeDemand
from segfmu.kernels.messages import ROPE_LIMITS
from segfmu.planning.arrays import FloatArray

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


def starting_tables(task: Task) -> list[FloatArray]:
    """Tables of limits (3, 6), one per multiple of the ramps' duration.

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
    _require_pace(task)
    motions = [(int(axis), *_both_ways(task, int(axis))) for axis in task.moving]
    tables = []
    for multiple in MULTIPLES:
        table = np.ones((3, COLUMNS))
        for axis, (velocity, acceleration, distance), back in motions:
            rise = min(velocity / acceleration, (distance / acceleration) ** 0.5)
            ramp = multiple * (HOIST_RAMP * rise if axis == HOIST else min(swing, 2.0 * rise))
            most = max(acceleration, back[1])
            table[axis] = (
                velocity, acceleration, JERK * most / ramp, SNAP * most / ramp**2, *back
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


def _require_pace(task: Task) -> None:
    for axis in task.moving.tolist():
        for name, first, unit in (
            ("velocity", Demand.VELOCITY, "m/s"), ("acceleration", Demand.ACCELERATION, "m/s2")
        ):
            upper, lower = task.bounds[:, first + axis].tolist()
            if min(upper, lower) < SLOWEST:
                bound = name if upper < SLOWEST else f"{name}_min"
                raise InputError(
                    f"axis {'xyz'[axis]}: {DRIVES[axis]} {bound} must have a bound of at least "
                    f"{SLOWEST:g} {unit}, got {min(upper, lower):g} {unit}; raise the bound"
                )


def _both_ways(
    task: Task, axis: int
) -> tuple[tuple[float, float, float], FloatArray]:
    """`_rigid` of an axis ahead, and velocity and acceleration backwards."""
    sense = float(task.senses[axis])
    ahead = _rigid(task, axis, sense)
    if not task.directed[axis].any():
        return ahead, np.array(ahead[:DIRECTED])
    back = _rigid(task, axis, -sense)
    return ahead, np.where(task.directed[axis], back[:DIRECTED], ahead[:DIRECTED])


def _rigid(task: Task, axis: int, sign: float) -> tuple[float, float, float]:
    """Velocity, acceleration and largest distance of an axis, as if the rope were rigid.

    In the direction of a sign, in which the load is accelerated; a hoist lifts it by its pull, and
    lowers it by its weight.
    """
    crane, power = task.crane, float(task.bounds[0, Demand.POWER + axis])
    # a rope that gets longer lowers the load
    side = 1 if (sign < 0.0) != (axis == HOIST) else 0
    force, fastest_drive, strongest = task.bounds[side, : Demand.POWER].reshape(-1, 3)[:, axis]
    lowered = axis == HOIST and side == 0 and bool(task.directed[axis, 1])
    if axis == HOIST:
        force = task.bounds[1, Demand.FORCE + axis]
    cap = 0 if sign == task.senses[axis] else SEARCHED
    velocity = min(float(fastest_drive), float(task.caps[axis, cap]))
    held = float(task.sticking[axis]) + (task.weight if axis == HOIST else 0.0)
    mass = crane.payload_mass
    mass += (crane.bridge_mass + crane.trolley_mass, crane.trolley_mass, 0.0)[axis]
    distance = float(np.abs(np.diff([p.position[axis] for p in task.waypoints])).max())
    fastest = float(np.abs(task.states[:, 0, axis]).max())
    accelerations = [float(strongest), float(task.caps[axis, cap + 1])]
    if lowered:
        accelerations.append(TAUT * crane.gravity)
    elif isfinite(force):
        accelerations.append(max((float(force) - held) / mass, LEAST * crane.gravity))
    if axis != HOIST and isfinite(sway := float(task.bounds[0, Demand.SWAY + axis])):
        accelerations.append(crane.gravity * tan(min(sway, STEEPEST)))
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
