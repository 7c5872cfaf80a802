"""Mechanics of a real crane: drives with lag and bounds, friction, end stops."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from segfmu.arrays import shown, sized
from segfmu.crane.checks import require_negative, require_not_negative, require_positive
from segfmu.crane.variables import Fed, fed
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import AXES, DRIVES, Plant
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import SetupFault, SetupStatus

UNLIMITED = 1e99
# what a rope does that would have to push
SLACK = ("error", "free_fall")


@dataclass(frozen=True)
class Drive:
    """Drive of one axis.

    In force mode it applies its force setpoint, within its bounds. In velocity mode it is the
    frequency converter of section 4.4: lag v' = v* - v, with v' within the bounds of the
    acceleration, and its force follows from this motion. If that force exceeds its bound, the drive
    applies as much as it can and its velocity falls behind.

    Bounds may differ by direction. Forces and velocities of the hoist are positive where they pay
    rope out: it lifts with negative ones.

    Parameters
    ----------
    lag : float
        Time constant of the velocity loop [s]. With 0 the velocity equals the setpoint; after
        saturation it reaches it within the next step.
    force_max : float, optional
        Largest force [N].
    acceleration_max : float, optional
        Largest acceleration [m/s2], in velocity mode.
    dead_time : float
        Time from the command, setpoint and correction, to the drive [s].
    velocity_max : float, optional
        Largest velocity [m/s]. Velocity setpoints beyond it are clipped; in force mode the drive
        applies at most the force that holds it.
    power_max : float, optional
        Largest power [W], driving or braking: the force is at most power_max / |v|.
    force_min, acceleration_min, velocity_min : float, optional
        Least ones, below zero; None for minus the largest.

    Raises
    ------
    InputError
        For negative times, and for bounds that are zero or of the other sign.
    """

    lag: float = 0.0
    force_max: float | None = None
    acceleration_max: float | None = None
    dead_time: float = 0.0
    velocity_max: float | None = None
    power_max: float | None = None
    force_min: float | None = None
    acceleration_min: float | None = None
    velocity_min: float | None = None

    def __post_init__(self) -> None:
        require_not_negative("drive lag", self.lag)
        require_not_negative("drive dead_time", self.dead_time)
        for name in ("force_max", "acceleration_max", "velocity_max", "power_max"):
            if getattr(self, name) is not None:
                require_positive(f"drive {name}", getattr(self, name))
        for name in ("force_min", "acceleration_min", "velocity_min"):
            if getattr(self, name) is not None:
                require_negative(f"drive {name}", getattr(self, name))


@dataclass(frozen=True)
class Friction:
    """Friction of the axes and damping of the sway.

    Parameters
    ----------
    viscous, coulomb : tuple of 3 float
        Of bridge, trolley and hoist [N s/m], [N].
    width : float
        Velocity [m/s] over which friction falls from static to Coulomb friction as an axis breaks
        away: coulomb + (static - coulomb) exp(-(v / width)^2).
    sway : float
        Viscous damping of each sway angle [N m s].
    drag : tuple of 3 float
        Of bridge, trolley and hoist [N] at 1 m/s: drag * v |v|, from air and gears at speed.
    static : tuple of 3 float
        Static friction [N] of bridge, trolley and hoist; 0 is as Coulomb friction.
    presliding : float
        Displacement [m] at which a contact begins to slide.

    Raises
    ------
    InputError
        For negative coefficients, for a width or displacement that is not positive, and for static
        friction below Coulomb friction.
    """

    viscous: tuple[float, float, float] = (0.0, 0.0, 0.0)
    coulomb: tuple[float, float, float] = (0.0, 0.0, 0.0)
    width: float = 1e-3
    sway: float = 0.0
    drag: tuple[float, float, float] = (0.0, 0.0, 0.0)
    static: tuple[float, float, float] = (0.0, 0.0, 0.0)
    presliding: float = 1e-5

    def __post_init__(self) -> None:
        for name in ("viscous", "coulomb", "drag", "static"):
            values = sized(f"friction {name}", getattr(self, name), 3)
            for axis, value in zip(AXES, values, strict=True):
                require_not_negative(f"friction {name} of the {axis}", value)
        require_positive("friction width", self.width)
        require_positive("friction presliding", self.presliding)
        require_not_negative("friction sway", self.sway)
        fault = np.zeros(SetupFault.SIZE)
        static, coulomb = (np.array(v, dtype=np.float64) for v in (self.static, self.coulomb))
        status = backend.check_friction(static, coulomb, fault)
        if status != SetupStatus.FITS:
            raise InputError(SETUP.text(status, fault.tolist()))


@dataclass(frozen=True)
class TravelLimits:
    """End stops [m]: least and greatest position of bridge and trolley, and length of the rope.

    Reaching one ends the simulation with an error, if it has no buffer.

    Parameters
    ----------
    bridge, trolley, rope : tuple of 2 float, optional
        None for no end stop.
    stiffness, damping : tuple of 3 float
        Of the buffers of bridge, trolley and rope [N/m], [N s/m]: a spring and a damper side by
        side that never pull. Stiffness 0 is no buffer.
    slack : {"error", "free_fall"}
        What a rope does that would have to push: end the simulation with an error, or bear nothing
        until it is taut again, with an impulse.

    Raises
    ------
    InputError
        For an empty range, negative values and another word.
    """

    bridge: tuple[float, float] | None = None
    trolley: tuple[float, float] | None = None
    rope: tuple[float, float] | None = None
    stiffness: tuple[float, float, float] = (0.0, 0.0, 0.0)
    damping: tuple[float, float, float] = (0.0, 0.0, 0.0)
    slack: Literal["error", "free_fall"] = "error"

    def __post_init__(self) -> None:
        if not isinstance(self.slack, str) or self.slack not in SLACK:
            raise InputError(f"slack must be error or free_fall, got {shown(self.slack)}")
        for name in ("stiffness", "damping"):
            values = sized(f"travel {name}", getattr(self, name), 3)
            for axis, value in zip(AXES, values, strict=True):
                require_not_negative(f"travel {name} of the {axis}", value)
        limits = np.array([
            (-UNLIMITED, UNLIMITED) if limit is None else sized(f"travel {name}", limit, 2)
            for name, limit in zip(AXES, (self.bridge, self.trolley, self.rope), strict=True)
        ])
        fault = np.zeros(SetupFault.SIZE)
        status = backend.check_travel(limits[:, 0].copy(), limits[:, 1].copy(), fault)
        if status != SetupStatus.FITS:
            raise InputError(SETUP.text(status, fault.tolist()))


def _stops(axis: int) -> Fed:
    least, greatest = (Plant.FIELDS[n].variables[axis] for n in ("TRAVEL_MIN", "TRAVEL_MAX"))
    return Fed((least, greatest), (-UNLIMITED, UNLIMITED))


# variables of the classes' fields; of a drive, those of bridge, trolley and hoist
DRIVE = tuple(
    {
        "lag": fed(Plant, "LAG", i),
        "force_max": fed(Plant, "FORCE_MAX", i, none=(0.0,)),
        "acceleration_max": fed(Plant, "ACCELERATION_MAX", i, none=(0.0,)),
        "dead_time": fed(Plant, "DEAD_TIME", i),
        "velocity_max": fed(Plant, "VELOCITY_MAX", i, none=(0.0,)),
        "power_max": fed(Plant, "POWER_MAX", i, none=(0.0,)),
        "force_min": fed(Plant, "FORCE_MIN", i, none=(0.0,)),
        "acceleration_min": fed(Plant, "ACCELERATION_MIN", i, none=(0.0,)),
        "velocity_min": fed(Plant, "VELOCITY_MIN", i, none=(0.0,)),
    }
    for i in range(len(DRIVES))
)
FRICTION = {
    "viscous": fed(Plant, "VISCOUS"), "coulomb": fed(Plant, "COULOMB"),
    "width": fed(Plant, "FRICTION_WIDTH"), "sway": fed(Plant, "SWAY_DAMPING"),
    "drag": fed(Plant, "DRAG"), "static": fed(Plant, "STATIC"),
    "presliding": fed(Plant, "PRESLIDING"),
}
TRAVEL = {
    **{name: _stops(i) for i, name in enumerate(AXES)},
    "stiffness": fed(Plant, "STIFFNESS"), "damping": fed(Plant, "DAMPING"),
    "slack": fed(Plant, "SLACK", items=SLACK),
}
