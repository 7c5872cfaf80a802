"""The shortest plan along one axis over all limits of the load, by differential evolution.

It tells what the paper's profiles can do at most within bounds of a drive, whatever search finds
their limits. It shares the planner and the demands with the product, and nothing of its search.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import differential_evolution

from segfmu import ActuatorBounds, Crane, InfeasibleError, Limits, Waypoint, plan
from segfmu.crane import Friction
from segfmu.crane.bounds import uses
from segfmu.crane.demand import peaks

# velocity, acceleration, jerk, snap, and the acceleration that brakes: logarithms over the mean
# velocity and its powers that a known duration tells
RANGES = ((0.0, 1.5), (0.5, 4.5), (1.0, 8.5), (2.0, 12.0), (0.5, 4.5))
ORDERS = np.array([1.0, 2.0, 3.0, 4.0, 2.0])
MEMBERS, GENERATIONS, SEED = 12, 70, 1
# what a bound that is exceeded costs: in any case, and by how much
EXCEEDED, BY = 0.01, 5.0
REFUSED = 1e3


def shortest_over_limits(
    crane: Crane,
    waypoints: Sequence[Waypoint],
    axis: int,
    bounds: ActuatorBounds,
    friction: Friction,
    shape: str,
    known: float,
    generations: int = GENERATIONS,
) -> float:
    """Duration [s] of the shortest plan that is found within the bounds.

    Parameters
    ----------
    axis : int
        The only one that moves.
    known : float
        About how long it takes [s].
    generations : int
        Of the 60 members of the population.
    """
    distance = abs(waypoints[-1].position[axis] - waypoints[0].position[axis])
    here = np.arange(3) == axis

    def cost(exponents: NDArray[np.float64]) -> float:
        values = np.exp(exponents) * distance / known**ORDERS
        velocity, acceleration, jerk, snap, braking = (np.where(here, v, 1.0) for v in values)
        limits = Limits(velocity, acceleration, jerk, snap, acceleration_min=-braking)
        try:
            found = plan(waypoints, limits, shape=shape)
        except InfeasibleError:
            return REFUSED
        used = max(use.use for use in uses(bounds, *peaks(crane, found, friction)))
        return found.duration / known + (BY * (used - 1.0) + EXCEEDED if used > 1.0 else 0.0)

    best = differential_evolution(
        cost, RANGES, popsize=MEMBERS, maxiter=generations, seed=SEED, tol=0.0, polish=False,
        init="sobol",
    )
    return known * float(best.fun)
