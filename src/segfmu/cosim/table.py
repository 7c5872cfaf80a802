"""Rows of a co-simulation's result, collected in blocks, one per type and unit."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim.unit import Unit, alike

# types of values -> those of a result's columns
COLUMNS: dict[type, type] = {float: np.float64, int: np.int32, bool: np.bool_}

# rows in a block before it is copied to the result's columns
BLOCK = 256


class Table:
    """Time and all outputs of some units at every communication point.

    Parameters
    ----------
    times : ndarray, shape (n,)
        Communication points [s].
    units : Unit
        After their `observe`.
    """

    def __init__(self, times: NDArray[np.float64], *units: Unit) -> None:
        fields: list[tuple[str, type]] = [("time", np.float64)]
        for unit in units:
            names = [n for group in alike(unit.outputs(), unit) for n in group]
            fields += [(n, COLUMNS[unit.kind(n)]) for n in names]
        self.rows: NDArray[np.void] = np.zeros(times.size, dtype=fields)
        self.rows["time"] = times
        observed = [o for unit in units for o in unit.observed]
        self._blocks = [
            (np.zeros((BLOCK, c.values.size), c.values.dtype), c.values) for _, c in observed
        ]
        self._columns = [
            (self.rows[name], block[:, j])
            for (own, _), (block, _) in zip(observed, self._blocks, strict=True)
            for j, name in enumerate(own)
        ]

    def record(self, i: int) -> None:
        """Store the outputs that were read last as row `i`; rows must be consecutive."""
        place = i % BLOCK
        for block, values in self._blocks:
            block[place] = values
        if place == BLOCK - 1 or i == self.rows.size - 1:
            for column, gathered in self._columns:
                column[i - place:i + 1] = gathered[:place + 1]
