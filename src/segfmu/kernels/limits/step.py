"""The step of a search: the least duration within the bounds, as far as slopes tell.

Minimise g d for use + slopes d <= 1 and |d| <= radius, by damped Newton steps on the logarithmic
barrier, which is self-concordant: they stay inside without a line search (Nesterov and Nemirovskii,
Interior-Point Polynomial Algorithms in Convex Programming, 1994). A step needs no more digits than
the slopes have.
"""

from math import sqrt

from segfmu.kernels.limits.records import Search, SearchState, SearchValues, Values
from segfmu.kernels.numerics.matrices import matrix_solve


def write_step(
    search: 'float[:,:]', values: 'float[:,:]', slopes: 'float[:,:]', newton: 'float[:,:]'
) -> None:
    """Write the step and what it promises; newton (2 n, n) is work space for n unknowns."""
    n = int(search[Search.STATE, SearchState.UNKNOWNS])
    radius = search[Search.STATE, SearchState.RADIUS]
    most = 0.0
    for i in range(n):
        search[Search.STEP, i] = 0.0
        most = most + search[Search.FREE, i] * abs(slopes[i, Values.DURATION]) * radius
    search[Search.STATE, SearchState.PREDICTED] = 0.0
    if most <= 0.0:
        return
    weight = (2.0 * n + Values.USE + 28.0) / most
    for level in range(6):
        for trial in range(40):
            if damped_step(n, radius, weight, search, values, slopes, newton) < 0.3:
                break
        weight = 8.0 * weight
    promised = 0.0
    for i in range(n):
        promised = promised - search[Search.STEP, i] * slopes[i, Values.DURATION]
    search[Search.STATE, SearchState.PREDICTED] = promised


def damped_step(
    n: int, radius: float, weight: float, search: 'float[:,:]', values: 'float[:,:]',
    slopes: 'float[:,:]', newton: 'float[:,:]',
) -> float:
    """One damped Newton step on weight g d + barrier; returns the Newton decrement."""
    for i in range(n):
        for j in range(n):
            newton[i, j] = 0.0
        above = radius - search[Search.STEP, i]
        below = radius + search[Search.STEP, i]
        newton[i, i] = 1.0 / (above * above) + 1.0 / (below * below)
        force = search[Search.FREE, i] * weight * slopes[i, Values.DURATION]
        newton[n + i, 0] = -force - 1.0 / above + 1.0 / below
    for row in range(Values.USE, slopes.shape[1]):
        # a bound far from being reached is out of a step's reach as well
        if values[SearchValues.CENTRE, row] > 0.3:
            add_bound(n, row, search, values, slopes, newton)
    # the right-hand side is the negative gradient; keep it for the decrement
    for i in range(n):
        newton[n + i, 1] = newton[n + i, 0]
    matrix_solve(n, 1, newton[0:n, :], newton[n:2 * n, :])
    squared = 0.0
    for i in range(n):
        squared = squared + newton[n + i, 0] * newton[n + i, 1]
    decrement = sqrt(max(squared, 0.0))
    for i in range(n):
        search[Search.STEP, i] = search[Search.STEP, i] + newton[n + i, 0] / (1.0 + decrement)
    return decrement


def add_bound(
    n: int, row: int, search: 'float[:,:]', values: 'float[:,:]', slopes: 'float[:,:]',
    newton: 'float[:,:]',
) -> None:
    """Add the barrier of a bound to Hessian and negative gradient."""
    # a bound that is used in full leaves a little, so that there is an inside
    room = max(1.0 - values[SearchValues.CENTRE, row], 1e-5)
    for i in range(n):
        room = room - search[Search.FREE, i] * slopes[i, row] * search[Search.STEP, i]
    for i in range(n):
        own = search[Search.FREE, i] * slopes[i, row] / room
        newton[n + i, 0] = newton[n + i, 0] - own
        # most unknowns act on few bounds
        if own != 0.0:
            for j in range(n):
                newton[i, j] = newton[i, j] + own * search[Search.FREE, j] * slopes[j, row] / room
