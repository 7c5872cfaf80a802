"""A mission that is made of Python objects, as the tables that its file would have."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from os import fspath
from pathlib import Path
from typing import Any

import numpy as np

from segfmu.crane import Crane
from segfmu.crane.kinds import AnyCrane
from segfmu.errors import InputError
from segfmu.planning import Limits, Obstacle, Waypoint
from segfmu.planning.limits import LOWER, NAMES, limited
from segfmu.validation.files.crane_model import CraneModel
from segfmu.validation.files.crane_models import FURTHER
from segfmu.validation.files.keys import AXES, Table

MASSES = ("bridge_mass", "trolley_mass", "payload_mass", "gravity")
STATES = ("velocity", "acceleration")
LIMITS = NAMES[:4]


def plain(value: Any) -> Any:
    """What a file says in place of an object: tables, lists, numbers and words.

    Raises
    ------
    InputError
        For objects that say what no mission file can.
    """
    if isinstance(value, Mapping):
        return {str(name): plain(entry) for name, entry in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, Path):
        return fspath(value)
    if isinstance(value, Table):
        return value.model_dump(exclude_unset=True)
    made = next((make for kind, make in MAKERS if isinstance(value, kind)), None)
    if made is not None:
        return made(value)
    if isinstance(value, Iterable) and not isinstance(value, str | bytes):
        return [plain(entry) for entry in value]
    return value


def _crane(crane: Crane) -> dict[str, Any]:
    names = (*MASSES, "rope_min", "rope_max")
    return {name: getattr(crane, name) for name in names if getattr(crane, name) is not None}


def _further(model: CraneModel, crane: AnyCrane) -> dict[str, Any]:
    return {**_crane(crane.crane), model.key: model.table(crane)}


def _limits(limits: Limits) -> dict[str, Any]:
    if limited(limits.crackle) or limited(limits.pop):
        raise InputError("limits: a mission has limits up to the snap; leave out crackle and pop")
    table = limits.table(len(AXES), len(LIMITS))[:, : len(LIMITS)]
    found = {
        axis: {name: number for name, number in zip(LIMITS, row, strict=True) if number > 0.0}
        for axis, row in zip(AXES, table.tolist(), strict=True)
    }
    for axis, row in zip(AXES, limits.lower(len(AXES)).tolist(), strict=True):
        for name, number in zip(LOWER, row, strict=True):
            if number != found[axis][name[:-4]]:
                found[axis][name] = -number
    return found


def _waypoint(point: Waypoint) -> dict[str, Any]:
    if not point.settled:
        raise InputError("waypoints: a mission gives position, velocity and acceleration alone")
    found: dict[str, Any] = {"position": point.position.tolist(), "dwell": point.dwell}
    for name in STATES:
        values = getattr(point, name)
        free = np.isnan(values)
        if free.any() and not free.all():
            raise InputError(f'waypoints: {name} of a mission is "free" for all axes or for none')
        found[name] = "free" if free.any() else values.tolist()
    return found


def _obstacle(box: Obstacle) -> dict[str, Any]:
    return {
        "name": box.name, "minimum": box.minimum.tolist(), "maximum": box.maximum.tolist(),
        "margin": box.margin, "rope": box.rope,
    }


MAKERS: tuple[tuple[type, Callable[[Any], dict[str, Any]]], ...] = (
    (Crane, _crane), (Limits, _limits), (Waypoint, _waypoint), (Obstacle, _obstacle),
    *((model.parameters, partial(_further, model)) for model in FURTHER),
)
