"""Commands to an operated motion: the record `Command`, from what a caller gives."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, as_index, finite_number, shown, sized
from segfmu.errors import InputError
from segfmu.kernels.numerics.numbers import FARTHEST_PLACE
from segfmu.kernels.operation.records import Command, OperationMode, Tries

MODES = tuple(name.lower() for name in OperationMode.items())
# how long a velocity is held beyond the next command [s]
HOLD = 0.1
# what a mode does not do without
NEEDED = {"target": ("target", Command.TARGET), "inching": ("distance", Command.DISTANCE)}


def first_command(hold: float, tries: int) -> FloatArray:
    """The command before any other: nothing is wished for, at full velocity."""
    given = finite_number("hold", hold)
    if given <= 0.0:
        raise InputError(f"hold must be a time > 0 s, got {shown(hold)}")
    command = np.zeros(Command.SIZE)
    command[Command.HOLD], command[Command.SCALE] = given, 1.0
    for _, place in NEEDED.values():
        command[place : place + 3] = np.nan
    command[Command.TRIES] = as_index("tries", tries, Tries.MOST, least=1)
    return command


def changed_command(
    command: FloatArray,
    mode: str,
    *,
    velocity: ArrayLike | None,
    target: ArrayLike | None,
    distance: ArrayLike | None,
    scale: float | None,
) -> FloatArray:
    """Another command; what is not given is that of the one before, which stays as it is."""
    if not isinstance(mode, str) or mode not in MODES:
        raise InputError(f"mode must be one of {', '.join(MODES)}, got {shown(mode)}")
    changed = command.copy()
    if scale is not None:
        given = finite_number("scale", scale)
        if not 0.0 <= given <= 1.0:
            raise InputError(f"scale must be from 0 to 1, got {shown(scale)}")
        changed[Command.SCALE] = given
    for name, value, place in (
        ("velocity", velocity, Command.VELOCITY), ("target", target, Command.TARGET),
        ("distance", distance, Command.DISTANCE),
    ):
        if value is not None:
            values = sized(name, value, 3, alike=name == "distance")
            if name != "velocity" and np.abs(values).max() > FARTHEST_PLACE:
                raise InputError(f"{name} must be at most {FARTHEST_PLACE:g} m, got {shown(value)}")
            changed[place : place + 3] = values
    if (changed[Command.DISTANCE : Command.DISTANCE + 3] < 0.0).any():
        raise InputError(
            f"distance must be at least 0 m, got {shown(distance)}; the sign of the velocity is "
            "the direction of a push"
        )
    if mode in NEEDED:
        needed, place = NEEDED[mode]
        if np.isnan(changed[place : place + 3]).any():
            raise InputError(f"mode {mode} needs a {needed} [m]: give it once, as {needed}=")
    changed[Command.MODE] = MODES.index(mode)
    changed[Command.GO] = float(mode == "target")
    return changed
