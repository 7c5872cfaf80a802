"""The balance of energy and work."""

from __future__ import annotations

from dataclasses import astuple, dataclass

import numpy as np

from segfmu.kernels import backend


@dataclass(frozen=True)
class EnergyBalance:
    """Energies [J]; all but kinetic and potential count from the start.

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
        Energy added (pick) or removed (drop) by payload changes.
    dissipated : float
        By friction and sway damping.
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
        """Error of the balance by integration and rounding [J]."""
        return float(backend.rig_imbalance(np.array(astuple(self))))
