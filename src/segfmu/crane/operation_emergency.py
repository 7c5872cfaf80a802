"""Drives that trip, and emergency stops of an operated motion."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from segfmu.arrays import shown
from segfmu.crane.bounds import DRIVES
from segfmu.crane.operation import OperatedMotion
from segfmu.errors import InfeasibleError, InputError
from segfmu.kernels.crane.records import DriveBounds
from segfmu.kernels.operation.records import Command, Known, Swing


@dataclass(frozen=True)
class EmergencyStop:
    """What an emergency stop comes to.

    Attributes
    ----------
    duration : float
        Time until bridge, trolley and hoist rest [s].
    sway : float
        Largest angle between rope and vertical from then on [rad], without damping.
    """

    duration: float
    sway: float


def foreseen(motion: OperatedMotion, time: float) -> EmergencyStop:
    """An emergency stop at a time [s], or the present one.

    Raises
    ------
    InputError
        If the acceleration of a drive has no bound.
    InfeasibleError
        If no such stop keeps forces and powers of the drives.
    """
    require_brakes(motion, "an emergency stop", tripped(motion))
    found = motion.foresee(time)
    if found is None:
        raise InfeasibleError(
            "no emergency stop keeps the bounds of forces and powers of the drives with a rope "
            "that pulls; use the mode stop"
        )
    return EmergencyStop(float(found[Swing.STAND]), float(found[Swing.SWAY]))


def trip(motion: OperatedMotion, drives: Collection[str]) -> None:
    """Let drives trip, from the next step on.

    Raises
    ------
    InputError
        For another name, and if the acceleration of a drive has no bound.
    """
    for drive in drives:
        if not isinstance(drive, str) or drive not in DRIVES:
            raise InputError(f"a drive is one of {', '.join(DRIVES)}, got {shown(drive)}")
    require_brakes(motion, "a drive that trips", {*drives, *tripped(motion)})
    for drive in drives:
        motion.command[Command.TRIPPED + DRIVES.index(drive)] = 1.0


def reset(motion: OperatedMotion) -> None:
    """Let all drives work again."""
    motion.command[Command.TRIPPED : Command.TRIPPED + len(DRIVES)] = 0.0


def tripped(motion: OperatedMotion) -> tuple[str, ...]:
    """The drives that have tripped."""
    rows = motion.command[Command.TRIPPED :]
    return tuple(drive for drive, row in zip(DRIVES, rows, strict=False) if row)


def require_brakes(motion: OperatedMotion, what: str, stopped: Collection[str] = ()) -> None:
    """Refuse what needs greatest accelerations of drives, but for those that brakes have stopped.

    Raises
    ------
    InputError
        For the first drive without.
    """
    bounds = motion.known[Known.BOUNDS, DriveBounds.ACCELERATION_MAX :]
    brakes = motion.known[Known.BRAKES]
    for drive, bound, brake in zip(DRIVES, bounds, brakes, strict=False):
        if not bound > 0.0 and not (drive in stopped and brake > 0.0):
            raise InputError(
                f"{what} needs the greatest acceleration of each drive; that of the {drive} has no "
                "bound: give bounds=ActuatorBounds(acceleration=...)"
            )
