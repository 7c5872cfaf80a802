"""Details of a failure of the plant."""

from segfmu.kernels.crane.records import Plant, PlantFault, PlantStatus, State


def plant_failure(
    status: int, time: float, state: 'float[:]', plant: 'float[:]', fault: 'float[:]'
) -> int:
    """Fill in PlantFault for a status other than DONE at a time [s], for messages.

    Returns the status without the axis: BELOW_TRAVEL or ABOVE_TRAVEL for any axis.
    """
    fault[PlantFault.TIME] = time
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
