"""Sway feedback Delta u = -K(l) (x - x*) of section 4.4: sampled LQR, scheduled by rope length.

Linearised about the load hanging at rest the crane decouples into bridge with phi_x, trolley with
phi_y, and hoist. Each design is discretised with a zero-order hold over the feedback's period.
The weights are those of the crane made dimensionless with the rope length l and the pendulum's
frequency sqrt(g / l), so that one set of weights suits every crane.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import expm, solve_discrete_are

from segfmu.crane.parameters import Crane
from segfmu.errors import InputError
from segfmu.planning.arrays import FloatArray


@dataclass(frozen=True)
class Weights:
    """Weights of the dimensionless design: carriage position, sway, their rates, and effort."""

    position: float = 1.0
    angle: float = 1.0
    velocity: float = 1.0
    rate: float = 1.0
    effort: float = 1.0

    def __post_init__(self) -> None:
        for name in ("position", "angle", "velocity", "rate", "effort"):
            value = getattr(self, name)
            if not 0.0 <= value < np.inf or (name in ("position", "effort") and value == 0.0):
                raise InputError(f"weight {name} must be positive and finite, got {value!r}")


@dataclass(frozen=True, eq=False)
class SwayFeedback:
    """Gain table over rope length.

    Attributes
    ----------
    sample_time : float
        Period of the sampled feedback [s].
    lengths : ndarray, shape (rows,)
        Rope lengths [m], ascending.
    gains : ndarray, shape (rows, 3, 10)
        From the state error to the corrections of the three forces [N], or in velocity mode of
        the three accelerations [m/s2].
    """

    sample_time: float
    lengths: FloatArray
    gains: FloatArray


def linearised(crane: Crane, length: float, driven: bool) -> tuple[FloatArray, FloatArray]:
    """A (10, 10) and B (10, 3) about the load hanging at rest.

    The inputs are the three drive forces, or if `driven` the accelerations of bridge, trolley and
    rope.
    """
    bridge, trolley, payload, gravity = crane.masses
    a = np.zeros((10, 10))
    a[:5, 5:] = np.eye(5)
    b = np.zeros((10, 3))
    for axis, (mass, sign) in enumerate(((bridge + trolley, 1.0), (trolley, -1.0))):
        angle = 3 + axis
        if driven:
            b[5 + axis, axis] = 1.0
        else:
            a[5 + axis, angle] = sign * payload * gravity / mass
            b[5 + axis, axis] = 1.0 / mass
        # l phi'' = -g phi - sign * carriage acceleration
        a[5 + angle] = -sign * a[5 + axis] / length
        a[5 + angle, angle] -= gravity / length
        b[5 + angle] = -sign * b[5 + axis] / length
    b[7, 2] = 1.0 if driven else 1.0 / payload
    return a, b


def gain(
    crane: Crane, length: float, sample_time: float, weights: Weights, driven: bool
) -> FloatArray:
    """Discrete-time LQR gain at one rope length, shape (3, 10)."""
    a, b = linearised(crane, length, driven)
    block = np.zeros((13, 13))
    block[:10, :10], block[:10, 10:] = a * sample_time, b * sample_time
    transition = expm(block)
    ad, bd = transition[:10, :10], transition[:10, 10:]
    frequency = np.sqrt(crane.gravity / length)
    coordinates = np.array([1.0 / length] * 3 + [1.0] * 2)
    scale = np.concatenate([coordinates, coordinates / frequency])
    w = weights
    values = [w.position] * 3 + [w.angle] * 2 + [w.velocity] * 3 + [w.rate] * 2
    state_cost = np.diag(scale**2 * values)
    bridge, trolley, payload, gravity = crane.masses
    unit = np.ones(3) if driven else np.array([bridge + trolley, trolley, payload])
    effort = np.diag(w.effort / (unit * gravity) ** 2)
    riccati = solve_discrete_are(ad, bd, state_cost, effort)
    found: FloatArray = np.linalg.solve(
        effort + bd.T @ riccati @ bd, bd.T @ riccati @ ad
    )
    return found


def design(
    crane: Crane,
    *,
    sample_time: float,
    shortest: float,
    longest: float,
    weights: Weights | None = None,
    driven: bool = False,
    rows: int = 17,
) -> SwayFeedback:
    """Design the gain table between two rope lengths.

    Raises
    ------
    InputError
        For a period or rope lengths that are not positive.
    """
    if not 0.0 < shortest <= longest < np.inf:
        raise InputError(f"rope lengths must be positive, got {shortest!r} to {longest!r} m")
    if not 0.0 < sample_time < np.inf:
        raise InputError(f"sample_time must be a time > 0 s, got {sample_time!r}")
    lengths = np.geomspace(shortest, longest, rows) if longest > shortest else np.array([shortest])
    table = [gain(crane, float(x), sample_time, weights or Weights(), driven) for x in lengths]
    return SwayFeedback(sample_time, lengths, np.array(table))
