"""Where a plan ends, and whether that is at a velocity."""

from segfmu.kernels.numerics.numbers import BESIDE
from segfmu.kernels.planner.records import DelayedState, WaypointState
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Timing


def write_end(last: int, timing: 'float[:,:]', coefficients: 'float[:,:]', end: 'float[:]') -> None:
    """Write where the piece in the row `last` ends, and when (DelayedState)."""
    width = coefficients.shape[1]
    length = timing[last, Timing.LENGTH]
    for order in range(WaypointState.SIZE):
        end[order] = evaluate_piece(coefficients, last, width, length, order)
    end[DelayedState.DELAY] = timing[last, Timing.START] + length


def is_at_velocity(velocity: float, limits: 'float[:]', end: 'float[:]') -> bool:
    """Whether an end has a velocity [m/s], and no acceleration, up to rounding."""
    missed = end[WaypointState.VELOCITY] - velocity
    if abs(missed) > BESIDE * limits[0]:
        return False
    return abs(end[WaypointState.ACCELERATION]) <= BESIDE * limits[1]


def plan_ends(
    timing: 'float[:,:]', coefficients: 'float[:,:]', offsets: 'int[:]', ends: 'float[:,:]'
) -> None:
    """Write where each axis of a plan ends, and when: ends (axes, DelayedState) [m, s]."""
    for axis in range(offsets.shape[0] - 1):
        write_end(offsets[axis + 1] - 1, timing, coefficients, ends[axis, :])


def are_at_velocities(targets: 'float[:,:]', limits: 'float[:,:]', ends: 'float[:,:]') -> bool:
    """Whether all ends (axes, DelayedState) have the velocities of targets (axes, WaypointState).

    limits (axes, 2): of velocity and acceleration.
    """
    for axis in range(ends.shape[0]):
        velocity = targets[axis, WaypointState.VELOCITY]
        if not is_at_velocity(velocity, limits[axis, :], ends[axis, :]):
            return False
    return True
