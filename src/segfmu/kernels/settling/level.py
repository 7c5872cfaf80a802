"""A lead to a velocity that passes zero jerk with snap.

Where the highest limit is above the snap, a stage that ends with zero snap at a jerk costs what a
ramp of the acceleration costs in the planner (passing.py). So a lead of this kind ends its first
stage at a level of the snap, with zero derivatives above, and the passing profile of the velocity
starts from that level. The search varies the level.
"""

from segfmu.kernels.planner.passing import passing_form
from segfmu.kernels.planner.phases import copy_phases, total_duration
from segfmu.kernels.planner.profile import shortest_ramps
from segfmu.kernels.planner.records import Axis, Passing, PlanWork
from segfmu.kernels.settling.records import Chain, LeadStage, LeadWork
from segfmu.kernels.settling.stages import append_phases, run_stage, set_stage_problem, settle


def passing_phases(
    row: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> int:
    """Phases of the passing profile from the level in the row LEVEL of `lead`; 0 if there is none.

    Newton's method starts from the ramps that follow when the snap goes to zero first. The pieces
    of that are written from `row` on.
    """
    state = lead[LeadWork.STATE, :]
    level = lead[LeadWork.LEVEL, :]
    chain = lead[LeadWork.CHAINS + LeadStage.VELOCITY, :]
    problem = lead[LeadWork.PROBLEM, :]
    phases = lead[LeadWork.PHASES:LeadWork.AXIS, :]
    plan = lead[LeadWork.PLAN:LeadWork.EXPANSION, :]
    ramps = plan[PlanWork.TRIAL:PlanWork.BEST, :]
    passing = plan[PlanWork.PASSING, :]
    end = lead[LeadWork.ENDS, LeadStage.VELOCITY]
    lead[LeadWork.ENDS, LeadStage.JERK] = 1e300
    if run_stage(LeadStage.JERK, row, lead, timing, coefficients) < 0:
        return 0
    longest = state[Chain.TIME] - level[Chain.TIME]
    set_stage_problem(LeadStage.VELOCITY, end, state, problem)
    count = shortest_ramps(problem, chain, phases, plan)
    if count <= 0:
        return 0
    copy_phases(phases, ramps, count)
    longest = longest + total_duration(ramps, count)
    set_stage_problem(LeadStage.VELOCITY, end, level, problem)
    passing[Passing.START] = level[Chain.DERIVATIVES + LeadStage.SNAP]
    return passing_form(longest, longest, count, ramps, phases, problem, chain, plan)


def settle_over_level(
    row: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> int:
    """`settle` to a velocity over a level of the snap; the row ENDS has both, and 1e300 else."""
    state = lead[LeadWork.STATE, :]
    level = lead[LeadWork.LEVEL, :]
    if lead[LeadWork.CHAINS + LeadStage.VELOCITY, Axis.ABOVE] < 0.5:
        return -1
    row = settle(LeadStage.SNAP, row, lead, timing, coefficients)
    if row < 0:
        return -1
    for i in range(Chain.SIZE):
        level[i] = state[i]
    count = passing_phases(row, lead, timing, coefficients)
    for i in range(Chain.SIZE):
        state[i] = level[i]
    end = lead[LeadWork.ENDS, LeadStage.VELOCITY]
    if count == 0:
        return -1
    return append_phases(LeadStage.VELOCITY, end, count, row, lead, timing, coefficients)
