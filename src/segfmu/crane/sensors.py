"""Sensors as on the paper's rig: bridge, trolley, rope length and the two cardan angles."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from segfmu.arrays import FloatArray, sized
from segfmu.crane.checks import require_not_negative, require_positive, require_seed
from segfmu.crane.variables import fed, filled, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.messages import SETUP
from segfmu.kernels.rig.records import Sensors as Settings
from segfmu.kernels.rig.records import SetupFault, SetupStatus

Five = tuple[float, float, float, float, float]
NONE: Five = (0.0, 0.0, 0.0, 0.0, 0.0)


def resolution(counts: float, travel: float = 2.0 * pi) -> float:
    """Quantisation step of an encoder with `counts` per revolution and `travel` [m or rad].

    Raises
    ------
    InputError
        For values that are not positive.
    """
    require_positive("counts", counts)
    require_positive("travel", travel)
    return travel / counts


@dataclass(frozen=True)
class Sensors:
    """Errors of the measured signals; five values each, [m] and [rad].

    Parameters
    ----------
    sample_time : float
        Period [s]; 0: continuous.
    dead_time : float
        From sampling to availability [s]; the first sample is available at once.
    resolution : tuple of 5 float
        Width of a quantisation step; 0: none.
    deviation : tuple of 5 float
        Standard deviation of the noise of every sample.
    offset : tuple of 5 float
        Measured minus true value.
    seed : int
        Of the noise.

    Raises
    ------
    InputError
        For negative values, and for noise or dead time without a sample time.
    """

    sample_time: float = 0.0
    dead_time: float = 0.0
    resolution: Five = NONE
    deviation: Five = NONE
    offset: Five = NONE
    seed: int = 0

    def __post_init__(self) -> None:
        require_not_negative("sensor sample_time", self.sample_time)
        require_not_negative("sensor dead_time", self.dead_time)
        require_seed("sensor seed", self.seed)
        sized("sensor offset", self.offset, 5)
        for name in ("resolution", "deviation"):
            for value in sized(f"sensor {name}", getattr(self, name), 5):
                require_not_negative(f"sensor {name}", value)
        fault = np.zeros(SetupFault.SIZE)
        status = backend.check_sensors(self.vector, fault)
        if status != SetupStatus.FITS:
            raise InputError(SETUP.text(status, fault.tolist()))

    @property
    def vector(self) -> FloatArray:
        """The kernels' `Sensors`, shape (18,)."""
        return filled(Settings, values(self, SENSORS).__getitem__)


# variables of the fields
SENSORS = {
    "sample_time": fed(Settings, "SAMPLE_TIME"), "dead_time": fed(Settings, "DEAD_TIME"),
    "resolution": fed(Settings, "RESOLUTION"), "deviation": fed(Settings, "DEVIATION"),
    "offset": fed(Settings, "OFFSET"), "seed": fed(Settings, "SEED", whole=True),
}
