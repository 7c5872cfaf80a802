"""What a motion of the load asks of the drives."""

from segfmu.kernels.crane.contact import planned_friction
from segfmu.kernels.crane.records import Demand, DemandWork, MostSeries, Resistance, State
from segfmu.kernels.crane.suspension import crane_inverse


def drive_demands(
    flat: 'float[:,:,:]',
    times: 'float[:]',
    resistance: 'float[:]',
    contacts: 'float[:,:,:]',
    work: 'float[:,:]',
    demands: 'float[:,:]',
) -> None:
    """Demands of a plan at times, a `Demand` per row.

    flat[row, d, i] is the d-th derivative of the load's position in axis i; resistance:
    `Resistance`; contacts: the plan's `Contact` rows of each axis; work: `DemandWork`. The velocity
    is that of the setpoint, which leads a lag by lag times acceleration: the drive cuts it at its
    bound. The power is force times the drive's own velocity: positive where the drive does work.
    """
    for i in range(flat.shape[0]):
        motion_demand(flat[i], times[i], resistance, contacts, work, demands[i])


def motion_demand(
    flat: 'float[:,:]',
    time: float,
    resistance: 'float[:]',
    contacts: 'float[:,:,:]',
    work: 'float[:,:]',
    demand: 'float[:]',
) -> None:
    """The `Demand` of a plan at a time [s], as in `drive_demands`."""
    series = work[DemandWork.SERIES:DemandWork.SERIES + MostSeries.SIZE, :]
    crane_inverse(
        flat, resistance, series, work[DemandWork.FORCE], work[DemandWork.STATE],
        work[DemandWork.ACCELERATION],
    )
    for k in range(3):
        velocity = work[DemandWork.STATE, State.VELOCITY + k]
        force = work[DemandWork.FORCE, k] + planned_friction(
            resistance, k, time, work[DemandWork.STATE, State.POSITION + k], velocity, contacts[k],
        )
        demand[Demand.FORCE + k] = force
        acceleration = work[DemandWork.ACCELERATION, k]
        demand[Demand.VELOCITY + k] = velocity + resistance[Resistance.LAG + k] * acceleration
        demand[Demand.ACCELERATION + k] = acceleration
        demand[Demand.POWER + k] = force * velocity
        demand[Demand.PLACE + k] = work[DemandWork.STATE, State.POSITION + k]
    for k in range(2):
        demand[Demand.SWAY + k] = work[DemandWork.STATE, State.ANGLE + k]
