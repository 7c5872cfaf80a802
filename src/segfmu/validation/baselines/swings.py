"""Small swings of what hangs on a rope: points on links, the load and what is above it."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np

from segfmu.crane.kinds import AnyCrane


@dataclass(frozen=True)
class Swing:
    """A natural swing that an acceleration of the carriage excites.

    Attributes
    ----------
    frequency : float
        [rad/s]
    end, load : float
        Deviations of the rope's end and of the load from the carriage, over that of a pendulum of
        this frequency.
    """

    frequency: float
    end: float
    load: float


def swings(crane: AnyCrane, rope: float, carriage: float) -> tuple[Swing, ...]:
    """All swings about a rope length [m], the slowest first.

    carriage: mass that yields to the pull of the rope [kg]; infinite with velocity drives.
    """
    payload, gravity = crane.masses[2], crane.gravity
    mass, length = crane.tackle
    points = [(payload, rope)] if length == 0.0 else [(mass, rope), (payload, length)]
    masses, lengths = np.array(points).T
    # each link pulls with the weight of all points below it
    pulls = gravity * np.cumsum(masses[::-1])[::-1] / lengths
    stiffness = np.diag(pulls)
    for i, pull in enumerate(pulls[1:].tolist()):
        stiffness[i, i] += pull
        stiffness[i, i + 1] = stiffness[i + 1, i] = -pull
    rates = stiffness / masses[:, None]
    rates[:, 0] += pulls[0] / carriage
    squares, shapes = np.linalg.eig(rates)
    # all points stay behind a carriage that accelerates
    parts = shapes * np.linalg.solve(shapes, np.ones(masses.size))
    return tuple(
        Swing(sqrt(float(squares[i].real)), float(parts[0, i].real), float(parts[-1, i].real))
        for i in np.argsort(squares.real)
    )
