"""Setpoints of a crane."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from segfmu.arrays import FloatArray, numbers, sized
from segfmu.errors import InputError
from segfmu.kernels.rig.records import Setpoints as Record

SHAPES = ((3,), (3,), (10,), (3,))


@dataclass(frozen=True, eq=False)
class Setpoints:
    """Setpoints, reference and wind at one time.

    Attributes
    ----------
    force, velocity : ndarray, shape (3,)
        Setpoints of bridge, trolley and hoist [N], [m/s].
    reference : ndarray, shape (10,)
        Reference state.
    wind : ndarray, shape (3,)
        Force on the load [N] in addition to the rig's wind.
    """

    force: FloatArray = field(default_factory=lambda: np.zeros(3))
    velocity: FloatArray = field(default_factory=lambda: np.zeros(3))
    reference: FloatArray = field(default_factory=lambda: np.zeros(10))
    wind: FloatArray = field(default_factory=lambda: np.zeros(3))

    @classmethod
    def of(cls, vector: FloatArray) -> Setpoints:
        """From the kernels' `Setpoints`, shape (19,)."""
        vector = sized("vector", vector, Record.SIZE)
        ends = Record.VELOCITY, Record.REFERENCE, Record.WIND
        return cls(*np.split(vector, ends))

    @property
    def vector(self) -> FloatArray:
        """The kernels' `Setpoints`, shape (19,).

        Raises
        ------
        InputError
            For parts of other shapes, and what is no number.
        """
        parts = (self.force, self.velocity, self.reference, self.wind)
        if tuple(map(np.shape, parts)) != SHAPES:
            raise InputError(
                "force, velocity, reference and wind of setpoints have 3, 3, 10 and 3 values, got "
                f"arrays of shape {', '.join(str(np.shape(part)) for part in parts)}"
            )
        return numbers("setpoints", np.concatenate(parts))
