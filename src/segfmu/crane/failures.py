"""What the statuses of the kernels mean, in words."""

from __future__ import annotations

from segfmu.crane.equipment import AXES
from segfmu.kernels.crane.records import Plant, PlantStatus
from segfmu.planning.arrays import FloatArray

BEYOND_RANGE = {
    PlantStatus.SWAY_ANGLE: "a sway angle came to 90 degrees",
    PlantStatus.ROPE_LENGTH: "the rope's length came to zero",
    PlantStatus.STEP_TOO_SMALL: "the integration steps became too small",
    PlantStatus.NOT_FINITE: "a value is not finite",
    PlantStatus.SLACK_ROPE: "the rope went slack",
}


def failure(status: int, time: float, state: FloatArray, parameters: FloatArray) -> str:
    """One line for a status other than 0; state and parameters are those of the kernel."""
    at = f"at {time:.3f} s: "
    if status < PlantStatus.BELOW_TRAVEL:
        return f"{at}{BEYOND_RANGE[status]}; check the setpoints, the masses and the friction"
    above = status >= PlantStatus.ABOVE_TRAVEL
    axis = status - (PlantStatus.ABOVE_TRAVEL if above else PlantStatus.BELOW_TRAVEL)
    kind = "greatest" if above else "least"
    limit = parameters[(Plant.TRAVEL_MAX if above else Plant.TRAVEL_MIN) + axis]
    return (
        f"{at}{AXES[axis]} at {state[axis]:.6g} m is at its end stop, {kind} position "
        f"{limit:.6g} m; shorten the move, brake earlier or widen the travel limits"
    )
