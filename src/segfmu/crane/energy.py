"""The balance of energy and work."""

from __future__ import annotations

from dataclasses import astuple, dataclass

import numpy as np

from segfmu.kernels import backend


@dataclass(frozen=True)
class EnergyBalance:
    """Energies [J]; those beside kinetic and potential since the start.

    kinetic + potential = initial + drives + wind + payload - dissipated

    Attributes
    ----------
    kinetic, potential : float
        Of bridge, trolley and load; the potential energy is zero at the trolley's height.
    initial : float
        Their sum at the start.
    drives, wind : float
        Work of drives and of wind.
    payload : float
        Energy that payload changes brought (pick) or took (drop).
    dissipated : float
        By friction and by the damping of the sway.
    """

    kinetic: float
    potential: float
    initial: float
    drives: float
    wind: float
    payload: float
    dissipated: float

    @property
    def imbalance(self) -> float:
        """What the balance misses by integration and rounding [J]."""
        return float(backend.rig_imbalance(np.array(astuple(self))))
