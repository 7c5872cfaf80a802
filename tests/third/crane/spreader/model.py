"""A load with a spreader, as a flat system."""

from dataclasses import dataclass

import numpy as np

from segfmu.crane.contacts import NONE, resistance
from segfmu.crane.flat_model import FlatModel
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import require_rope
from segfmu.kernels import backend
from segfmu.kernels.crane.records import FlatInverse, FlatOrders, State


@dataclass(frozen=True)
class SpreaderCrane:
    """A gantry crane whose load hangs on a spreader."""

    crane: Crane
    mass: float

    @property
    def masses(self):
        return *self.crane.masses, self.mass

    @property
    def suspension(self):
        return 2

    @property
    def tackle(self):
        return self.mass, 0.0

    @property
    def gravity(self):
        return self.crane.gravity

    @property
    def weight(self):
        return self.crane.weight + self.mass * self.gravity

    def values(self):
        return self.crane.values() | {"spreader.mass": self.mass}


def _invert(crane, flat, found):
    columns = SPREADER.columns
    backend.spreader_inverse(
        flat, resistance(crane, NONE), found[columns.force], found[columns.state],
        found[columns.acceleration],
    )


SPREADER = FlatModel(
    SpreaderCrane, FlatOrders.CRANE, 4, FlatInverse, State, np.arange(State.SIZE), _invert,
    lambda crane, trajectory: require_rope(crane.crane, trajectory),
)
