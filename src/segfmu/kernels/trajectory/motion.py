"""A whole plan in one call: waypoints, limits and options -> polynomial pieces, checked."""

from segfmu.kernels.planner.plan import plan_phases
from segfmu.kernels.planner.problem import check_problem
from segfmu.kernels.planner.records import PlanStatus, PlanWork
from segfmu.kernels.spline.nearer import stay_near
from segfmu.kernels.trajectory.check import check_plan
from segfmu.kernels.trajectory.expand import count_pieces, expand_plan
from segfmu.kernels.trajectory.records import Judging, MotionWork


def plan_motion(
    states: 'float[:,:,:]',
    dwells: 'float[:]',
    limits: 'float[:,:]',
    lower: 'float[:,:]',
    axes: 'float[:,:]',
    cells: 'float[:,:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    times: 'float[:,:]',
    work: 'float[:,:]',
) -> int:
    """Plan, expand and check a motion; returns the status (PlanStatus).

    states, dwells, limits, lower, axes and cells are those of `plan_phases`, the others those of
    `expand_plan`. work (MotionWork rows, MotionWork columns) brings the options and the tolerances
    of the check. MORE_PIECES: the plan is made, and `expand_motion` will do the rest with as many
    rows as `count_pieces` says. After a refusal the row REFUSAL of the planner's rows says where.
    """
    planner = work[MotionWork.PLAN:MotionWork.EXPANSION, :]
    status = check_problem(states, limits, planner[PlanWork.REFUSAL, :])
    if status == PlanStatus.PLANNED:
        status = plan_phases(
            states, dwells, limits, lower, work[MotionWork.OPTIONS, :], axes, cells, planner
        )
    if status == PlanStatus.PLANNED:
        stay_near(
            axes, cells, timing, coefficients, planner,
            work[MotionWork.EXPANSION:MotionWork.CHECK, :],
            work[MotionWork.SPLINE:MotionWork.PLAN, :],
        )
        status = expand_motion(
            states, dwells, limits, lower, axes, cells, timing, coefficients, offsets, times, work
        )
    return status


def expand_motion(
    states: 'float[:,:,:]',
    dwells: 'float[:]',
    limits: 'float[:,:]',
    lower: 'float[:,:]',
    axes: 'float[:,:]',
    cells: 'float[:,:,:]',
    timing: 'float[:,:]',
    coefficients: 'float[:,:]',
    offsets: 'int[:]',
    times: 'float[:,:]',
    work: 'float[:,:]',
) -> int:
    """Expand and check a planned motion, as in `plan_motion`: PLANNED, CHECK_FAILED, MORE_PIECES.

    After CHECK_FAILED the pieces are written all the same.
    """
    if count_pieces(axes, cells) > timing.shape[0]:
        return PlanStatus.MORE_PIECES
    expand_plan(
        states, dwells, axes, cells, timing, coefficients, offsets, times,
        work[MotionWork.EXPANSION:MotionWork.CHECK, :],
    )
    judging = work[MotionWork.JUDGING, :]
    wrong = check_plan(
        states, times, timing, coefficients, offsets, limits, lower, judging[Judging.TOLERANCE],
        judging[Judging.JOINTS], work[MotionWork.CHECK:MotionWork.SIZE, :],
    )
    if wrong > 0:
        return PlanStatus.CHECK_FAILED
    return PlanStatus.PLANNED
