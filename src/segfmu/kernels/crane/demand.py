"""What a motion of the load asks of the drives."""

from segfmu.kernels.crane._crane import crane_flat_inverse
from segfmu.kernels.crane.records import Demand, DemandWork, State


def drive_demands(
    flat: 'float[:,:,:]', masses: 'float[:]', work: 'float[:,:]', demands: 'float[:,:]'
) -> None:
    """Demands of many motions, a `Demand` per row.

    flat[row, d, i] is the d-th derivative of the load's position in axis i; masses: `Masses`; work:
    `DemandWork`. The power is force times velocity: positive where the drive does work.
    """
    for i in range(flat.shape[0]):
        crane_flat_inverse(
            flat[i], masses, work[DemandWork.FORCE], work[DemandWork.STATE],
            work[DemandWork.ACCELERATION],
        )
        for k in range(3):
            force = work[DemandWork.FORCE, k]
            velocity = work[DemandWork.STATE, State.VELOCITY + k]
            demands[i, Demand.FORCE + k] = force
            demands[i, Demand.VELOCITY + k] = velocity
            demands[i, Demand.ACCELERATION + k] = work[DemandWork.ACCELERATION, k]
            demands[i, Demand.POWER + k] = force * velocity
        for k in range(2):
            demands[i, Demand.SWAY + k] = work[DemandWork.STATE, State.ANGLE + k]
