"""Messages for the statuses of the plant."""

from __future__ import annotations

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.kernels import backend
from segfmu.kernels.crane.records import PlantFault
from segfmu.kernels.messages import PLANT


def failure(status: int, time: float, state: FloatArray, parameters: FloatArray) -> str:
    """One line for a status other than 0, from the kernel's state and parameters."""
    fault = np.zeros(PlantFault.SIZE)
    kind = backend.plant_failure(status, time, state, parameters, fault)
    text: str = PLANT.text(kind, fault.tolist())
    return text
