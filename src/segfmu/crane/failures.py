"""What the statuses of kernels/crane/plant.py mean, in words."""

from __future__ import annotations

from segfmu.crane.equipment import AXES
from segfmu.planning.arrays import FloatArray

BEYOND_RANGE = {
    1: "a sway angle came to 90 degrees",
    2: "the rope's length came to zero",
    3: "the integration steps became too small",
    4: "a value is not finite",
    5: "the rope went slack",
}
BELOW, ABOVE = 6, 9


def failure(status: int, time: float, state: FloatArray, parameters: FloatArray) -> str:
    """One line for a status other than 0; state and parameters are those of the kernel."""
    at = f"at {time:.3f} s: "
    if status < BELOW:
        return f"{at}{BEYOND_RANGE[status]}; check the setpoints, the masses and the friction"
    axis = (status - BELOW) % 3
    kind = "greatest" if status >= ABOVE else "least"
    limit = parameters[(25 if status >= ABOVE else 22) + axis]
    return (
        f"{at}{AXES[axis]} at {state[axis]:.6g} m is at its end stop, {kind} position "
        f"{limit:.6g} m; shorten the move, brake earlier or widen the travel limits"
    )
