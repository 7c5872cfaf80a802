"""What a model declares whose load's path determines everything, and the gantry crane's."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.crane.kinds import AnyCrane
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import LoadTrajectory, require_rope
from segfmu.kernels import backend
from segfmu.kernels.crane.records import FlatInverse, FlatOrders, PlantState, State
from segfmu.kernels.records import Record


@dataclass(frozen=True, eq=False)
class FlatModel:
    """A flat system.

    Attributes
    ----------
    parameters : type
        Of its parameters, an `AnyCrane`.
    orders : int
        Derivatives of the load's position that the inverse needs, that of order 0 included. With
        a trajectory that is `orders - 1` times continuously differentiable the forces are
        continuous, with one less the velocities of the drives.
    least : int
        Smoothness of a trajectory from which on there is an inverse.
    results, state : type of Record
        What the inverse gives, and the state in it: positions first, then angles, then rates.
    places : ndarray of int
        Places of the state in the kernels' `PlantState`.
    invert : callable
        Writes the results for derivatives of the load's position, (orders, 3).
    require_taut : callable
        Refuses trajectories along which what pulls goes slack or leaves its range.
    unjudged : str
        What an obstacle for the rope cannot be judged with, as messages have it; empty for none.
    """

    parameters: type[AnyCrane]
    orders: int
    least: int
    results: type[Record]
    state: type[Record]
    places: NDArray[np.int64]
    invert: Callable[[Any, FloatArray, FloatArray], None]
    require_taut: Callable[[Any, LoadTrajectory], None]
    unjudged: str = ""

    @property
    def name(self) -> str:
        """Of its parameters in Python, as messages have it."""
        return self.parameters.__name__

    def kept(self, state: FloatArray) -> FloatArray:
        """The kernels' `PlantState` of a state."""
        found = np.zeros(PlantState.SIZE)
        found[self.places] = state
        return found

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


GANTRY = FlatModel(
    Crane, FlatOrders.CRANE, 4, FlatInverse, State, np.arange(State.SIZE), _invert_crane,
    require_rope,
)
