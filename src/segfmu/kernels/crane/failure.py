"""Details of a failure of the plant."""

from segfmu.kernels.crane.records import (
    Axes,
    Plant,
    PlantFault,
    PlantState,
    PlantStatus,
    State,
)


def plant_failure(
    status: int, time: float, state: 'float[:]', plant: 'float[:]', fault: 'float[:]'
) -> int:
    """Fill in PlantFault for a status other than DONE at a time [s], for messages.

    Returns the status without the axis: BELOW_TRAVEL or ABOVE_TRAVEL for any axis.
    """
    fault[PlantFault.TIME] = time
    if status == PlantStatus.SWAY_ANGLE:
        fault[PlantFault.POSITION] = state[State.POSITION + Axes.ROPE]
        fault[PlantFault.ANGLE] = 0.0
        for i in range(2):
            widest_angle(i, state[State.ANGLE + i], fault)
            widest_angle(2 + i, state[PlantState.SLING_ANGLE + i], fault)
    if status < PlantStatus.BELOW_TRAVEL or status == PlantStatus.SLACK_SLING:
        return status
    axis = (status - PlantStatus.BELOW_TRAVEL) % 3
    fault[PlantFault.AXIS] = axis
    fault[PlantFault.POSITION] = state[State.POSITION + axis]
    if status >= PlantStatus.ABOVE_TRAVEL:
        fault[PlantFault.STOP] = plant[Plant.TRAVEL_MAX + axis]
        return PlantStatus.ABOVE_TRAVEL
    fault[PlantFault.STOP] = plant[Plant.TRAVEL_MIN + axis]
    return PlantStatus.BELOW_TRAVEL


def widest_angle(sway: int, angle: float, fault: 'float[:]') -> None:
    """Write a sway angle [rad] into PlantFault if it is wider than the one that is there."""
    if abs(angle) > abs(fault[PlantFault.ANGLE]):
        fault[PlantFault.SWAY] = sway
        fault[PlantFault.ANGLE] = angle
