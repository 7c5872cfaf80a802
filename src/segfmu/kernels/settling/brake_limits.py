"""The limits within which a brake ends, and whether a state is beyond them."""

from segfmu.kernels.numerics.numbers import EQUAL
from segfmu.kernels.planner.parameters import axis_limits, ramp_parameters, usual_share
from segfmu.kernels.planner.records import Axis, Lower, Shape
from segfmu.kernels.planner.sides import set_lower
from segfmu.kernels.settling.chain import chain_limits, set_chains
from segfmu.kernels.settling.records import LeadWork
from segfmu.kernels.trajectory.check import rounding_error


def set_box(steep: float, loose: int, limits: 'float[:]', lead: 'float[:,:]') -> bool:
    """Set the limits of a brake, and the chains; False if there are no ramps within them.

    Where a limit is absent a natural one, which the state NOW of `lead` keeps, takes its place.
    steep as in `natural_limit`. Derivatives from the order `loose` on may stay as large as in NOW.
    """
    smoothness = limits.shape[0] - 1
    axis, state = lead[LeadWork.AXIS, :], lead[LeadWork.STATE, :]
    axis_limits(smoothness, int(Shape.PLATEAU), limits, axis)
    set_lower(lead[LeadWork.LOWER, :], axis)
    for i in range(loose, smoothness + 1):
        if limits[i - 1] > 0.0:
            axis[Axis.VELOCITY + i - 1] = max(limits[i - 1], abs(lead[LeadWork.NOW, i]))
    if not ramp_parameters(usual_share(axis), axis, lead[LeadWork.CHAINS:LeadWork.PLAN, :]):
        return False
    state[:] = 0.0
    for i in range(1, smoothness + 1):
        lead[LeadWork.ROUNDING, i] = rounding_error(i, limits)
        if limits[i - 1] <= 0.0:
            state[i] = lead[LeadWork.NOW, i]
    chain_limits(steep, axis, state, lead[LeadWork.LIMITS, :])
    set_chains(steep, axis, lead[LeadWork.LIMITS, :], lead[LeadWork.CHAINS:LeadWork.PLAN, :])
    for i in range(1, smoothness + 2):
        lead[LeadWork.LOWEST, i] = -lead[LeadWork.LIMITS, i]
        if i <= Lower.SIZE:
            lead[LeadWork.LOWEST, i] = -axis[Axis.LOWER + i - 1]
        lead[LeadWork.HIGHEST, i] = lead[LeadWork.LIMITS, i]
    return True


def lower_limit(order: int, limits: 'float[:]', lead: 'float[:,:]') -> float:
    """The limit of a derivative in the negative direction, 0 if absent."""
    if order <= Lower.SIZE and lead[LeadWork.LOWER, order - 1] > 0.0:
        return lead[LeadWork.LOWER, order - 1]
    return limits[order - 1]


def is_outside(limits: 'float[:]', lead: 'float[:,:]') -> bool:
    """Whether a derivative in the row NOW of `lead` is beyond its limit by more than rounding."""
    for i in range(1, limits.shape[0]):
        value = lead[LeadWork.NOW, i]
        bound = lower_limit(i, limits, lead) if value < 0.0 else limits[i - 1]
        if bound > 0.0 and abs(value) > bound * (1.0 + EQUAL):
            return True
    return False
