"""The shortest transfer of a carriage with friction and a bound of its force, by programs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.optimize import linprog

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Transfer:
    """A carriage with a hanging load, its friction and its bounds.

    Attributes
    ----------
    mass, load : float
        Of all that the drive moves but the load, and of the load [kg].
    rope, gravity : float
        [m], [m/s2]
    distance : float
        [m]
    force, velocity : float
        Bounds of the drive [N], [m/s].
    coulomb, viscous : float
        Friction [N], [N s/m].
    """

    mass: float
    load: float
    rope: float
    gravity: float
    distance: float
    force: float
    velocity: float
    coulomb: float
    viscous: float


def shortest_time(transfer: Transfer, cells: int, tolerance: float) -> float:
    """Shortest time [s] from rest to rest, by bisection over linear programs.

    The drive's force is linear in each cell and may jump between them; the motion is that of the
    linearised crane, exact in the force. The carriage does not turn, so its friction is linear in
    the state: viscous v + coulomb. No smoothness is asked for.
    """
    own = transfer
    least = own.distance / own.velocity
    high = 2.0 * least + 20.0 * (own.mass * own.distance / (own.force - own.coulomb)) ** 0.5
    low = 0.0
    while high - low > tolerance * high:
        middle = 0.5 * (low + high)
        if _reaches(own, middle, cells):
            high = middle
        else:
            low = middle
    return float(high)


def _reaches(own: Transfer, duration: float, cells: int) -> bool:
    # state: position and velocity of the carriage, deflection and rate of the load against it
    pull = own.load * own.gravity / own.rope
    rate = np.array([
        [0.0, 1.0, 0.0, 0.0],
        [0.0, -own.viscous / own.mass, pull / own.mass, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [0.0, own.viscous / own.mass, -pull / own.mass - own.gravity / own.rope, 0.0],
    ])
    push = np.array([0.0, 1.0 / own.mass, 0.0, -1.0 / own.mass])
    step = duration / cells
    # with the force and its slope as further states
    whole = np.zeros((6, 6))
    whole[:4, :4], whole[:4, 4], whole[4, 5] = rate, push, 1.0
    ahead = expm(whole * step)
    move, held, rising = ahead[:4, :4], ahead[:4, 4], ahead[:4, 5] / step
    # effects of the forces at both ends of each cell, less Coulomb friction, on the state
    unknowns = 2 * cells
    effects = np.zeros((cells + 1, 4, unknowns))
    for k in range(cells):
        effects[k + 1] = move @ effects[k]
        effects[k + 1, :, 2 * k] += held - rising
        effects[k + 1, :, 2 * k + 1] += rising
    speeds = effects[1:, 1]
    goal = np.array([own.distance, 0.0, 0.0, 0.0])
    return bool(
        linprog(
            np.zeros(unknowns), A_ub=np.vstack([speeds, -speeds]),
            b_ub=np.concatenate([np.full(cells, own.velocity), np.zeros(cells)]),
            A_eq=effects[-1], b_eq=goal,
            bounds=(-own.force - own.coulomb, own.force - own.coulomb), method="highs",
        ).status == 0
    )
