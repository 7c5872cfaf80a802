"""Settling in stages: bring the derivatives of high order to zero, the highest ones first.

A stage for the order q leads the derivative of this order to a given value, or to wherever it is
soonest, and all derivatives above to zero. Those above q + 2 are zero before: they were brought to
zero by the stage for the order q + 2. So the stage is a boundary problem of the planner, from
(position, velocity, acceleration) to a position at rest, on the axis seen from that derivative; if
q is n - 1, or the end is free, it is a change of velocity.
"""

from segfmu.kernels.numerics.numbers import NEVER
from segfmu.kernels.planner.cruise import append_velocity_change
from segfmu.kernels.planner.nested import ramp_pieces
from segfmu.kernels.planner.phases import append_change
from segfmu.kernels.planner.profile import shortest_ramps
from segfmu.kernels.planner.records import Axis, Problem
from segfmu.kernels.settling.chain import lift_pieces
from segfmu.kernels.settling.records import Chain, LeadRows, LeadWork
from segfmu.kernels.trajectory.pieces import expand_phases
from segfmu.kernels.trajectory.records import Expansion, PieceState


def stage_phases(order: int, end: float, free: bool, lead: 'float[:,:]') -> int:
    """Phases of the stage for an order in the row PHASES of `lead`; their number, below 0: none."""
    state, phases = lead[LeadWork.STATE, :], lead[LeadWork.PHASES:LeadWork.AXIS, :]
    smoothness = int(lead[LeadWork.CHAINS, Axis.SMOOTHNESS])
    if order == smoothness - 1:
        chain = lead[LeadWork.CHAINS + order - 1, :]
        if free:
            return append_change(phases, 0, state[order + 1], 0.0, chain)
        return append_stage(state[order], state[order + 1], end, phases, chain)
    chain = lead[LeadWork.CHAINS + order, :]
    if free:
        return append_stage(state[order + 1], state[order + 2], 0.0, phases, chain)
    problem = lead[LeadWork.PROBLEM, :]
    set_stage_problem(order, end, state, problem)
    return shortest_ramps(problem, chain, phases, lead[LeadWork.PLAN:LeadWork.EXPANSION, :])


def append_stage(v: float, a: float, w: float, phases: 'float[:,:]', chain: 'float[:]') -> int:
    """Phases of the fastest change from (v, a) to (w, 0); -1 if there is none."""
    top = chain[Axis.ACCELERATION]
    return append_velocity_change(phases, 0, v, a, w, top, chain[Axis.LOWER + 1], chain)


def set_stage_problem(order: int, end: float, state: 'float[:]', problem: 'float[:]') -> None:
    """Set the boundary problem (Problem) of the stage for an order."""
    problem[Problem.V] = state[order + 1]
    problem[Problem.A] = state[order + 2]
    problem[Problem.W] = 0.0
    problem[Problem.B] = 0.0
    problem[Problem.DISTANCE] = end - state[order]


def append_phases(
    order: int, end: float, count: int, row: int, lead: 'float[:,:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> int:
    """Append the pieces of the phases of a stage from `row` on; the row after them, -1: no room.

    The row STATE of `lead` (LeadWork) goes on to the end of the stage.
    """
    state = lead[LeadWork.STATE, :]
    smoothness = int(lead[LeadWork.CHAINS, Axis.SMOOTHNESS])
    seen = min(order, smoothness - 2)
    chain = lead[LeadWork.CHAINS + seen, :]
    if count < 0 or row + ramp_pieces(chain) * count > 2 * LeadRows.PIECES:
        return -1
    expansion = lead[LeadWork.EXPANSION:LeadWork.CHECK, :]
    now = expansion[Expansion.STATE, :]
    now[PieceState.POSITION] = state[seen]
    now[PieceState.VELOCITY] = state[seen + 1]
    now[PieceState.ACCELERATION] = state[seen + 2]
    third = seen + 3
    now[PieceState.JERK] = state[third]
    now[PieceState.TIME] = state[Chain.TIME]
    phases = lead[LeadWork.PHASES:LeadWork.AXIS, :]
    last = expand_phases(phases, count, chain, timing, coefficients, row, expansion)
    lift_pieces(seen, row, last, state, timing, coefficients)
    state[seen] = now[PieceState.POSITION]
    state[seen + 1] = now[PieceState.VELOCITY]
    if end < NEVER:
        state[order] = end
    for i in range(order + 1, smoothness + 1):
        state[i] = 0.0
    state[Chain.TIME] = now[PieceState.TIME]
    return last


def run_stage(
    order: int, row: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> int:
    """Append the pieces of the stage for an order from `row` on; the row after them, -1: none.

    The row STATE of `lead` (LeadWork) goes on to the end of the stage.
    """
    end = lead[LeadWork.ENDS, order]
    count = stage_phases(order, end, end >= NEVER, lead)
    return append_phases(order, end, count, row, lead, timing, coefficients)


def drop_rounding(order: int, lead: 'float[:,:]') -> None:
    """Bring derivatives in the row STATE of `lead` to their end that miss it by rounding alone.

    A stage for the rest would last 1e-20 s, and its end could not be told from its start.
    """
    state = lead[LeadWork.STATE, :]
    for i in range(1, int(lead[LeadWork.CHAINS, Axis.SMOOTHNESS]) + 1):
        aim = lead[LeadWork.ENDS, i] if i == order and lead[LeadWork.ENDS, i] < NEVER else 0.0
        if abs(state[i] - aim) <= lead[LeadWork.ROUNDING, i]:
            state[i] = aim


def settle(
    order: int, row: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> int:
    """Settle from the row START of `lead` so that all derivatives above an order are zero.

    The row ENDS tells where stages end. Returns the row after the last piece, -1: there is none.
    """
    row = settle_above(order, row, lead, timing, coefficients)
    if row >= 0 and order < int(lead[LeadWork.CHAINS, Axis.SMOOTHNESS]):
        row = run_stage(order, row, lead, timing, coefficients)
    return row


def settle_above(
    order: int, row: int, lead: 'float[:,:]', timing: 'float[:,:]', coefficients: 'float[:,:]'
) -> int:
    """The same without the last stage."""
    smoothness = int(lead[LeadWork.CHAINS, Axis.SMOOTHNESS])
    lead[LeadWork.STATE, :] = lead[LeadWork.START, :]
    for i in range(2):
        stage = order + 4 - 2 * i
        if stage < smoothness and row >= 0:
            drop_rounding(order, lead)
            row = run_stage(stage, row, lead, timing, coefficients)
    if order < smoothness:
        drop_rounding(order, lead)
    return row
