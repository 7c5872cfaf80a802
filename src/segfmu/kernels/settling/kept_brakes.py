"""How the last brakes were made: a state is braked as often as velocities are tried from it.

What is kept are choices of the search alone, so the brake is the same as without.
"""

from segfmu.kernels.planner.records import Lower
from segfmu.kernels.settling.records import Chain, KeptBrake, LeadTask, LeadWork
from segfmu.kernels.trajectory.records import Brake


def kind_of(whole: bool, limits: 'float[:]') -> float:
    """A number for how a brake goes on and for its number of limits; never 0."""
    return -float(limits.shape[0]) if whole else float(limits.shape[0])


def is_kept(row: int, whole: bool, limits: 'float[:]', lead: 'float[:,:]') -> bool:
    """Whether a row of `lead` has the brake from the state NOW within the limits."""
    if lead[row, KeptBrake.KIND] != kind_of(whole, limits):
        return False
    for i in range(limits.shape[0]):
        if lead[row, KeptBrake.LIMITS + i] != limits[i]:
            return False
        if lead[row, KeptBrake.STATE + i] != lead[LeadWork.NOW, Chain.DERIVATIVES + i]:
            return False
    for i in range(Lower.SIZE):
        if lead[row, KeptBrake.LOWER + i] != lead[LeadWork.LOWER, i]:
            return False
    return True


def kept_brake(whole: bool, limits: 'float[:]', lead: 'float[:,:]') -> int:
    """The row of `lead` with the brake from the state NOW within the limits; -1: it is not kept."""
    for row in range(LeadWork.KEPT, LeadWork.NOW):
        if is_kept(row, whole, limits, lead):
            return row
    return -1


def keep_brake(
    whole: bool, steep: float, loose: int, limits: 'float[:]', lead: 'float[:,:]'
) -> None:
    """Keep the choices of a brake, with those in the row BRAKE of `lead`, for the oldest one.

    steep and loose as in `brake_within`; steep is 0 where there is no brake.
    """
    row = LeadWork.KEPT + int(lead[LeadWork.TASK, LeadTask.OLDEST])
    lead[LeadWork.TASK, LeadTask.OLDEST] = 0.0
    if row + 1 < LeadWork.NOW:
        lead[LeadWork.TASK, LeadTask.OLDEST] = row + 1 - LeadWork.KEPT
    lead[row, KeptBrake.KIND] = kind_of(whole, limits)
    lead[row, KeptBrake.STEEP] = steep
    lead[row, KeptBrake.LOOSE] = loose
    for i in range(limits.shape[0]):
        lead[row, KeptBrake.LIMITS + i] = limits[i]
        lead[row, KeptBrake.STATE + i] = lead[LeadWork.NOW, Chain.DERIVATIVES + i]
        lead[row, KeptBrake.GENTLE + i] = lead[LeadWork.BRAKE, Brake.GENTLE + i]
    for i in range(Lower.SIZE):
        lead[row, KeptBrake.LOWER + i] = lead[LeadWork.LOWER, i]
