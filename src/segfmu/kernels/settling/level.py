"""A lead over a level: to a velocity, or to rest at a position, through zero jerk with snap.

Where the highest limit is above the snap, a stage that ends with zero jerk and snap costs what a
ramp of the acceleration costs in the planner (passing.py). So a lead of this kind ends its first
stage at a level of the derivative that has levels, with zero derivatives above, and a passing
profile starts from that level. The search varies the level.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.passing import passing_form
from segfmu.kernels.planner.phases import copy_phases, total_duration
from segfmu.kernels.planner.profile import shortest_ramps
from segfmu.kernels.planner.records import Axis, Passing, PlanWork, Problem
from segfmu.kernels.settling.records import Chain, LeadStage, LeadWork
from segfmu.kernels.settling.stages import append_phases, run_stage, set_stage_problem, settle


def level_order(order: int, lead: 'float[:,:]') -> int:
    """The derivative that has levels in leads of an order; 0 where none is above the jerk's."""
    seen = LeadStage.ACCELERATION - order
    above = int(lead[LeadWork.CHAINS + seen, Axis.ABOVE])
    return 0 if above == 0 else seen + 2 + above


def lead_end(order: int, lead: 'float[:,:]') -> float:
    """Velocity, or position, at the end of a lead of an order."""
    if order == LeadStage.VELOCITY:
        return lead[LeadWork.TARGET, Problem.W]
    return lead[LeadWork.TARGET, Problem.DISTANCE]


def passing_phases(
    order: int, least: float, row: int, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Phases of the passing profile from the level in the row LEVEL of `lead`; 0: none is shorter.

    Newton's method starts from the ramps that follow when the derivatives above the velocity, or
    above the acceleration, go to zero first. The pieces of that are written from `row` on.
    """
    state, level = lead[LeadWork.STATE, :], lead[LeadWork.LEVEL, :]
    seen = LeadStage.ACCELERATION - order
    chain, problem = lead[LeadWork.CHAINS + seen, :], lead[LeadWork.PROBLEM, :]
    phases, plan = lead[LeadWork.PHASES:LeadWork.AXIS, :], lead[LeadWork.PLAN:LeadWork.EXPANSION, :]
    ramps, passing = plan[PlanWork.TRIAL:PlanWork.BEST, :], plan[PlanWork.PASSING, :]
    end = lead_end(order, lead)
    lead[LeadWork.ENDS, seen + 2] = NEVER
    if run_stage(seen + 2, row, lead, timing, coefficients) < 0:
        return 0
    longest = state[Chain.TIME] - level[Chain.TIME]
    set_stage_problem(seen, end, state, problem)
    count = shortest_ramps(problem, chain, phases, plan)
    if count <= 0:
        return 0
    copy_phases(phases, ramps, count)
    longest = min(longest + total_duration(ramps, count), least - level[Chain.TIME])
    set_stage_problem(seen, end, level, problem)
    passing[Passing.PLAIN] = 1.0
    passing[Passing.START] = level[level_order(order, lead)]
    third = seen + 3
    passing[Passing.JERK] = level[third]
    return passing_form(longest, longest, count, ramps, phases, problem, chain, plan)


def settle_over_level(
    order: int, end: float, least: float, row: int, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """`settle` over a level, the value `end`, in less than `least` [s].

    With the order 2 the target is where it ends, at rest.
    """
    state, level = lead[LeadWork.STATE, :], lead[LeadWork.LEVEL, :]
    stage = level_order(order, lead)
    lead[LeadWork.ENDS, :] = NEVER
    lead[LeadWork.ENDS, stage] = end
    row = settle(stage, row, lead, timing, coefficients)
    if row < 0 or state[Chain.TIME] >= least:
        return -1
    level[:] = state
    count = passing_phases(order, least, row, lead, timing, coefficients)
    state[:] = level
    if count == 0:
        return -1
    seen = LeadStage.ACCELERATION - order
    end = lead_end(order, lead)
    return append_phases(seen, end, count, row, lead, timing, coefficients)
