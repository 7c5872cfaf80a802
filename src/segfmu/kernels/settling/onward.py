"""From any state onward in one call: leads, the plan behind them, and the check of both.

timing and coefficients have a plan a part (`PlanPart`, rows, columns), offsets axes + 1 entries a
part.
"""

from segfmu.kernels.planner.plan import plan_phases
from segfmu.kernels.planner.records import (
    PlanOptions,
    PlanStatus,
    PlanWork,
    Refusal,
    Synchronization,
    WaypointState,
)
from segfmu.kernels.settling.leads import find_brakes, find_leads
from segfmu.kernels.settling.records import (
    Done,
    LeadRows,
    LeadStage,
    LeadTask,
    LeadWork,
    PlanPart,
)
from segfmu.kernels.spline.nearer import stay_near
from segfmu.kernels.trajectory.check import check_braked_plan, check_plan
from segfmu.kernels.trajectory.cut import join_plans
from segfmu.kernels.trajectory.expand import count_pieces, expand_plan
from segfmu.kernels.trajectory.records import Judging


def lead_to_plan(lead: 'float[:,:]') -> None:
    """Search for leads to where the planner takes over, as the row OPTIONS of `lead` asks."""
    options = lead[LeadWork.OPTIONS, :]
    lead[LeadWork.TASK, LeadTask.ORDER] = LeadStage.ACCELERATION
    lead[LeadWork.TASK, LeadTask.SHAPE] = options[PlanOptions.SHAPE]
    lead[LeadWork.TASK, LeadTask.MEETING] = options[PlanOptions.DURATION]
    if int(options[PlanOptions.SYNCHRONIZATION]) == Synchronization.NONE:
        if options[PlanOptions.DURATION] == 0.0:
            lead[LeadWork.TASK, LeadTask.MEETING] = -1.0


def join_behind(
    states: 'float[:,:,:]', dwells: 'float[:]', axes: 'float[:,:]', cells: 'float[:,:,:]',
    timing: 'float[:,:,:]', coefficients: 'float[:,:,:]', offsets: 'int[:]', times: 'float[:,:]',
    lead: 'float[:,:]',
) -> bool:
    """Expand planned phases into the part BEHIND, and join leads and these in the part WHOLE.

    states are those of `plan_phases`. False: there are not rows enough.
    """
    count = axes.shape[0]
    leads = PlanPart.LEADS * (count + 1)
    behind = PlanPart.BEHIND * (count + 1)
    whole = PlanPart.WHOLE * (count + 1)
    end = PlanPart.COUNT * (count + 1)
    if offsets[leads + count] + count_pieces(axes, cells) > timing.shape[1]:
        return False
    expand_plan(
        states, dwells, axes, cells, timing[PlanPart.BEHIND, :, :],
        coefficients[PlanPart.BEHIND, :, :], offsets[behind:whole], times,
        lead[LeadWork.EXPANSION:LeadWork.CHECK, :],
    )
    join_plans(
        timing[PlanPart.LEADS, :, :], coefficients[PlanPart.LEADS, :, :], offsets[leads:behind],
        timing[PlanPart.BEHIND, :, :], coefficients[PlanPart.BEHIND, :, :], offsets[behind:whole],
        timing[PlanPart.WHOLE, :, :], coefficients[PlanPart.WHOLE, :, :], offsets[whole:end],
    )
    return True


def judge_pieces(
    states: 'float[:,:,:]', times: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]',
    offsets: 'int[:]', limits: 'float[:,:]', lower: 'float[:,:]', brakes: 'float[:,:]',
    lead: 'float[:,:]', spare_timing: 'float[:,:]', spare_coefficients: 'float[:,:]',
) -> bool:
    """Whether pieces are right (`check_plan`), at first perhaps outside the limits, as a brake is.

    states (points, k, n + 1 or more columns) are those to be passed at the times (points + 1, k).
    The row JUDGING of `lead` (LeadWork) has the tolerances; the spare arrays have LeadRows.ALL
    rows. Written: brakes (k, Brake), zeros where the pieces never are outside.
    """
    check = lead[LeadWork.CHECK:LeadWork.SIZE, :]
    tolerance = lead[LeadWork.JUDGING, Judging.TOLERANCE]
    joints = lead[LeadWork.JUDGING, Judging.JOINTS]
    for axis in range(limits.shape[0]):
        brakes[axis, :] = 0.0
    wrong = check_plan(
        states, times, timing, coefficients, offsets, limits, lower, tolerance, joints, check
    )
    if wrong > 0:
        if find_brakes(
            states[0, :, :], limits, lower, brakes, lead, spare_timing, spare_coefficients
        ):
            wrong = check_braked_plan(
                states, times, timing, coefficients, offsets, limits, lower, brakes, tolerance,
                joints, check,
            )
    return wrong == 0


def set_delayed(states: 'float[:,:,:]') -> None:
    """Let the second half of the states be what is planned: the targets behind the ends of leads.

    Nothing above the acceleration is asked for there.
    """
    points = states.shape[0] // 2
    for j in range(1, points):
        for axis in range(states.shape[1]):
            for i in range(states.shape[2]):
                states[points + j, axis, i] = 0.0
            for i in range(WaypointState.SIZE):
                states[points + j, axis, i] = states[j, axis, i]


def plan_onward(
    states: 'float[:,:,:]', dwells: 'float[:]', limits: 'float[:,:]', lower: 'float[:,:]',
    axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]', times: 'float[:,:]', lead: 'float[:,:]',
) -> int:
    """Plan from any state of k axes: leads, the plan behind them, joined and checked; PlanStatus.

    states (2 points, k, LeadEnd): the start as far as the derivative n, the targets, and room for
    the same behind the leads. dwells (points,), limits (k, n + 1), lower (k, Lower), cells and
    times are those of `plan_phases` and `expand_plan`. axes (2 k, Axis) is written: the axes, and
    behind them their brakes (Brake), see `judge_pieces`.

    The part FOLLOWED has a plan that leads may follow. The caller sets the rows OPTIONS and
    JUDGING of `lead` (LeadWork), and BRAKES and DONE in the row TASK. Leads that are DONE are in
    their part, their ends (DelayedState) in the states behind the targets.

    NO_PROFILE with an axis in FAILED: it has no lead. MORE_PIECES: the plan is made, and a call
    with the PHASES done and more rows does the rest. After CHECK_FAILED all is written.
    """
    points = dwells.shape[0]
    count = limits.shape[0]
    last = 2 * points
    done = int(lead[LeadWork.TASK, LeadTask.DONE])
    status = int(PlanStatus.PLANNED)
    lead[LeadWork.TASK, LeadTask.FAILED] = -1.0
    for i in range(Refusal.SIZE):
        lead[LeadWork.PLAN + PlanWork.REFUSAL, i] = 0.0
    if timing.shape[1] < offsets[count] + LeadRows.PIECES * count + LeadRows.ALL:
        return int(PlanStatus.MORE_PIECES)
    if done == Done.NOTHING:
        lead_to_plan(lead)
        first = count + 1
        behind = 2 * first
        failed = find_leads(
            states[0:2, :, :], limits, lower, offsets[0:first], timing[PlanPart.FOLLOWED, :, :],
            coefficients[PlanPart.FOLLOWED, :, :], states[points, :, :], lead,
            timing[PlanPart.LEADS, :, :], coefficients[PlanPart.LEADS, :, :],
            offsets[first:behind],
        )
        lead[LeadWork.TASK, LeadTask.FAILED] = failed
        if failed >= 0:
            status = int(PlanStatus.NO_PROFILE)
    if status == PlanStatus.PLANNED and done != Done.PHASES:
        set_delayed(states)
        status = plan_phases(
            states[points:last, :, :], dwells, limits, lower, lead[LeadWork.OPTIONS, :],
            axes[0:count, :], cells, lead[LeadWork.PLAN:LeadWork.EXPANSION, :],
        )
        if status == PlanStatus.PLANNED:
            stay_near(
                axes[0:count, :], cells, timing[PlanPart.BEHIND, :, :],
                coefficients[PlanPart.BEHIND, :, :], lead[LeadWork.PLAN:LeadWork.EXPANSION, :],
                lead[LeadWork.EXPANSION:LeadWork.CHECK, :],
                lead[LeadWork.SPLINE:LeadWork.PLAN, :],
            )
    if status == PlanStatus.PLANNED:
        status = finish_plan(
            states, dwells, limits, lower, axes, cells, timing, coefficients, offsets, times, lead
        )
    return status


def finish_plan(
    states: 'float[:,:,:]', dwells: 'float[:]', limits: 'float[:,:]', lower: 'float[:,:]',
    axes: 'float[:,:]', cells: 'float[:,:,:]', timing: 'float[:,:,:]', coefficients: 'float[:,:,:]',
    offsets: 'int[:]', times: 'float[:,:]', lead: 'float[:,:]',
) -> int:
    """Expand, join and check what `plan_onward` has planned."""
    points = dwells.shape[0]
    last = 2 * points
    count = limits.shape[0]
    ends = 2 * count
    whole = PlanPart.WHOLE * (count + 1)
    end = PlanPart.COUNT * (count + 1)
    if not join_behind(
        states[points:last, :, :], dwells, axes[0:count, :], cells, timing, coefficients, offsets,
        times, lead,
    ):
        return int(PlanStatus.MORE_PIECES)
    if judge_pieces(
        states[0:points, :, :], times, timing[PlanPart.WHOLE, :, :],
        coefficients[PlanPart.WHOLE, :, :], offsets[whole:end], limits, lower,
        axes[count:ends, :], lead, timing[PlanPart.BEHIND, :, :],
        coefficients[PlanPart.BEHIND, :, :],
    ):
        return int(PlanStatus.PLANNED)
    return int(PlanStatus.CHECK_FAILED)
