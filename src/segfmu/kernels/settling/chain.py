"""An axis seen from a derivative: the derivative of order m of a position, as a position itself.

What follows it are its velocity, acceleration and so on, within the limits c_{m+1}, c_{m+2} ..., so
every profile of the planner is a motion of the derivative as well, of the smoothness n - m. Where a
limit is absent, a natural one takes its place: one that the derivatives next to it imply, and that
the present state keeps.
"""

from segfmu.kernels.planner.parameters import ramp_parameters, usual_share
from segfmu.kernels.planner.records import Axis, Shape
from segfmu.kernels.trajectory.evaluate import evaluate_piece
from segfmu.kernels.trajectory.records import Timing

# a limit's natural value grows by this at most to let the derivative below brake in its room
MOST = 1e4
# derivatives that nothing limits are raised by this factor at a time, and ramps once at most
STEEPER = 10.0


def shortest_scale(order: int, limits: 'float[:]') -> float:
    """The shortest time [s] in which a derivative of lower order changes by its limit."""
    scale = limits[order - 1] / limits[order]
    for below in range(1, order - 1):
        scale = min(scale, (limits[below] / limits[order]) ** (1.0 / (order - below)))
    return scale


def natural_limit(order: int, steep: float, axis: 'float[:]', limits: 'float[:]') -> float:
    """A value in place of the absent limit of a derivative; those of lower order are set.

    steep >= 1: by how much derivatives without a limit above exceed what is usual.
    """
    below = limits[order - 1]
    highest = int(axis[Axis.SMOOTHNESS]) + 1
    top = 2
    for above in range(order + 1, highest + 1):
        bound = axis[Axis.VELOCITY + above - 1]
        if bound > 0.0:
            # between two limits the derivatives grow by the same factor from order to order
            return 2.0 * below * (bound / below) ** (1.0 / (above - order + 1))
    for given in range(3, order):
        if axis[Axis.VELOCITY + given - 1] > 0.0:
            top = given
    growth = steep ** (1.0 / (highest - top)) / usual_share(axis)
    return growth * below / shortest_scale(order - 1, limits)


def chain_limits(steep: float, axis: 'float[:]', state: 'float[:]', limits: 'float[:]') -> None:
    """Limits of all derivatives of an axis (Axis) by their order (Chain), natural ones for absent.

    A natural limit is at least twice the state (Chain), and lets the derivative below brake before
    the one below that reaches its own limit. steep as in `natural_limit`.
    """
    smoothness = int(axis[Axis.SMOOTHNESS])
    for order in range(1, smoothness + 2):
        limits[order] = axis[Axis.VELOCITY + order - 1]
        if limits[order] <= 0.0:
            bound = natural_limit(order, steep, axis, limits)
            if order <= smoothness:
                bound = max(bound, 2.0 * abs(state[order]))
            room = max(limits[order - 2] - abs(state[order - 2]), 0.0)
            needed = state[order - 1] * state[order - 1]
            if needed > room * MOST * bound:
                bound = MOST * bound
            elif needed > room * bound:
                bound = needed / room
            limits[order] = bound


def set_chains(steep: float, axis: 'float[:]', limits: 'float[:]', chains: 'float[:,:]') -> None:
    """Axes (Axis) whose positions are the derivatives of order 0 .. n - 2 of an axis.

    steep as in `natural_limit`, limits those of `chain_limits`; chains has two rows more, as work
    space.
    """
    smoothness = int(axis[Axis.SMOOTHNESS])
    for order in range(smoothness - 1):
        chain = chains[order, :]
        chain[:] = 0.0
        chain[Axis.SMOOTHNESS] = smoothness - order
        chain[Axis.SHAPE] = Shape.PLATEAU
        chain[Axis.RAISED] = order
        for i in range(smoothness - order + 1):
            chain[Axis.VELOCITY + i] = axis[Axis.VELOCITY + order + i]
            if i <= 2:
                chain[Axis.VELOCITY + i] = limits[order + 1 + i]
        chain[Axis.LOWER] = chain[Axis.VELOCITY]
        chain[Axis.LOWER + 1] = chain[Axis.ACCELERATION]
        if order == 0:
            chain[Axis.LOWER] = axis[Axis.LOWER]
            chain[Axis.LOWER + 1] = axis[Axis.LOWER + 1]
        elif order == 1:
            chain[Axis.LOWER] = axis[Axis.LOWER + 1]
        ramp_parameters(
            usual_share(chain) / min(steep, STEEPER), chain,
            chains[smoothness - 1:smoothness + 1, :],
        )


def lift_pieces(
    order: int, first: int, last: int, state: 'float[:]', timing: 'float[:,:]',
    coefficients: 'float[:,:]',
) -> None:
    """Integrate pieces of the derivative of an order to pieces of the position, in place.

    The derivatives below that order in the state (Chain) go on to the end of the last piece.
    """
    width = coefficients.shape[1]
    for row in range(first, last):
        for j in range(width - order):
            i = width - 1 - j
            value = coefficients[row, i - order]
            for m in range(order):
                value = value / (i - m)
            coefficients[row, i] = value
        factorial = 1.0
        for i in range(order):
            if i > 0:
                factorial = factorial * i
            coefficients[row, i] = state[i] / factorial
        for i in range(order):
            length = timing[row, Timing.LENGTH]
            state[i] = evaluate_piece(coefficients, row, width, length, i)
