"""End stops of bridge, trolley and rope, as bounds of a plan.

A place has bounds that need not be on both sides of zero. Its use of one is counted from the middle
between both end stops; where there is one alone, from a metre before it. `bounds` is a
`DriveBounds`.
"""

from segfmu.kernels.crane.records import Demand, DriveBounds


def no_stop() -> float:
    """Position [m] from which on an end stop is none."""
    return 1e9


def is_place(i: int) -> bool:
    """Whether a demand is a place."""
    return Demand.PLACE <= i < Demand.SWAY


def end_stop(i: int, side: int, bounds: 'float[:]') -> float:
    """The end stop [m] of a place in the positive direction, or, side 1, minus the other one.

    `no_stop` where there is none.
    """
    least = bounds[DriveBounds.TRAVEL_MIN + i - Demand.PLACE]
    greatest = bounds[i]
    found = greatest
    if side == 1:
        found = -least
    # what is not a number is an end stop that nothing keeps
    if least == greatest or found >= no_stop():
        return no_stop()
    return found


def travel_span(i: int, side: int, bounds: 'float[:]') -> float:
    """The way [m] along which a place comes to use all of its travel in a direction; 0: no end."""
    stop = end_stop(i, side, bounds)
    other = end_stop(i, 1 - side, bounds)
    if stop == no_stop():
        return 0.0
    if other == no_stop():
        return 1.0
    return 0.5 * (stop + other)


def travel_origin(i: int, side: int, bounds: 'float[:]') -> float:
    """Where that way begins [m], in the direction of the side."""
    return end_stop(i, side, bounds) - travel_span(i, side, bounds)
