"""What is known of each model whose load's path determines everything.

`FlatInverse` and the planner serve every model of this table. A further one needs a kernel that
inverts it, records of its state and of the results, and a check that what pulls stays taut.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from segfmu.crane.hook import HookCrane
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import LoadTrajectory, require_hook, require_rope
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.crane.records import FlatInverse, FlatOrders, Masses, SlingSeries, State
from segfmu.kernels.hook.records import HookInverse, HookState
from segfmu.kernels.records import Record
from segfmu.planning.arrays import FloatArray


@dataclass(frozen=True)
class FlatModel:
    """A flat system.

    Attributes
    ----------
    name : str
        Of its parameters in Python, as messages have it.
    orders : int
        Derivatives of the load's position that the inverse needs, that of order 0 included. With
        a trajectory that is `orders - 1` times continuously differentiable the forces are
        continuous, with one less the velocities of the drives.
    least : int
        Smoothness of a trajectory from which on there is an inverse.
    results, state : type of Record
        What the inverse gives, and the state in it: positions first, then angles, then rates.
    invert : callable
        Writes the results for derivatives of the load's position, (orders, 3).
    require_taut : callable
        Refuses trajectories along which what pulls goes slack or leaves its range.
    """

    name: str
    orders: int
    least: int
    results: type[Record]
    state: type[Record]
    invert: Callable[[Any, FloatArray, FloatArray], None]
    require_taut: Callable[[Any, LoadTrajectory], None]

    @cached_property
    def columns(self) -> Columns:
        """Where the results are."""
        return Columns.of(self.results, self.state)


@dataclass(frozen=True)
class Columns:
    """Columns of `FlatInverse.evaluate`; those of drives are bridge, trolley and rope."""

    force: slice
    state: slice
    position: slice
    velocity: slice
    acceleration: slice
    drive_acceleration: slice

    @classmethod
    def of(cls, results: Any, state: Any) -> Columns:
        """From the records of results and state."""
        return cls(
            force=slice(results.FORCE, results.STATE),
            state=slice(results.STATE, results.ACCELERATION),
            position=slice(results.STATE, results.STATE + state.ANGLE),
            velocity=slice(results.STATE + state.VELOCITY, results.STATE + state.RATE),
            acceleration=slice(results.ACCELERATION, results.SIZE),
            drive_acceleration=slice(results.ACCELERATION, results.ACCELERATION + state.ANGLE),
        )


def _invert_crane(crane: Crane, flat: FloatArray, found: FloatArray) -> None:
    columns = GANTRY.columns
    backend.crane_flat_inverse(
        flat, np.array(crane.masses), found[columns.force], found[columns.state],
        found[columns.acceleration],
    )


def _invert_hook(hook: HookCrane, flat: FloatArray, found: FloatArray) -> None:
    masses = np.array(hook.masses)
    series = np.zeros((SlingSeries.SIZE, FlatOrders.CRANE))
    backend.hook_derivatives(
        flat, 0, masses[: Masses.SIZE], hook.hook_mass, hook.sling, series, found
    )


GANTRY = FlatModel(
    "Crane", FlatOrders.CRANE, 4, FlatInverse, State, _invert_crane, require_rope
)
HOOK = FlatModel(
    "HookCrane", FlatOrders.HOOK, 5, HookInverse, HookState, _invert_hook, require_hook
)
MODELS: dict[type, FlatModel] = {Crane: GANTRY, HookCrane: HOOK}


def model_of(crane: object) -> FlatModel:
    """The model that a crane's parameters belong to.

    Raises
    ------
    InputError
        For anything else.
    """
    for kind, model in MODELS.items():
        if isinstance(crane, kind):
            return model
    raise InputError(
        f"crane must be a segfmu.Crane or a segfmu.HookCrane, got {type(crane).__name__}"
    )


def require_flat(crane: object, axes: int, smoothness: int) -> None:
    """Raise InputError unless a trajectory of so many axes, so smooth, has a flat inverse."""
    model = model_of(crane)
    if axes != 3:
        raise InputError(f"the flat inverse needs axes x, y, z; got {axes} axes")
    if smoothness < model.least:
        jumps = "acceleration" if model is GANTRY else "velocity"
        raise InputError(
            f"the flat inverse of a {model.name} needs smoothness {model.least} or more, got "
            f"{smoothness}; with less, the carriage's {jumps} jumps"
        )


def require_gantry(crane: object, axes: int, smoothness: int) -> None:
    """The same where there is no hook."""
    if not isinstance(crane, Crane):
        raise InputError(f"crane must be a segfmu.Crane, got {type(crane).__name__}")
    require_flat(crane, axes, smoothness)


def require_force(crane: object, smoothness: int) -> None:
    """Raise InputError unless a trajectory is smooth enough for the forces of the drives."""
    model = model_of(crane)
    if smoothness < model.orders - 1:
        raise InputError(
            f"the forces of a {model.name} need smoothness {model.orders - 1}, got {smoothness}; "
            "with less, they jump"
        )
