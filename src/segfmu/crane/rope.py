"""Proof that the rope stays taut and within its range along a trajectory of the load.

With w = p'' + g e_z the rope's length is l = -z |w| / w_z (errata E7). So each demand is a
polynomial in time that must not become negative: -z and w_z, and with the bound L of the length
L^2 w_z^2 - z^2 |w|^2 or its negative. A polynomial lies in the hull of its Bernstein
coefficients; where the hull is too wide, the interval is halved. Nothing is sampled, so nothing
is missed between samples.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import comb
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError
from segfmu.planning.arrays import FloatArray
from segfmu.planning.polynomials import derivative_pieces, hulls

TOLERANCE = 1e-9
HALVINGS = 40
SAMPLES = 33


class LoadTrajectory(Protocol):
    """What the inverse needs of a trajectory of the load."""

    @property
    def axes(self) -> int:
        """Number of axes."""

    @property
    def duration(self) -> float:
        """Its end [s]."""

    @property
    def smoothness(self) -> int:
        """How often it is continuously differentiable."""

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Value of a derivative, shape (..., axes)."""

    def pieces(self, axis: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Starts (pieces,), lengths (pieces,) and ascending coefficients (pieces, width)."""


@dataclass(frozen=True)
class Demand:
    """`polynomial`, one row an interval, is negative where sign * quantity is past its bound."""

    polynomial: FloatArray
    quantity: Callable[[FloatArray], FloatArray]
    sign: float
    bound: float
    name: str
    unit: str
    limit: str
    remedy: str


def require_rope(crane: Crane, trajectory: LoadTrajectory) -> None:
    """Check that the load stays below the trolley, the rope taut and its length in range.

    Raises
    ------
    InfeasibleError
        With the time from which on this fails, and the worst value after it.
    """
    ends = [np.append(p[0], p[0][-1] + p[1][-1]) for p in map(trajectory.pieces, range(3))]
    breaks = np.unique(np.concatenate(ends))
    for demand in _demands(crane, trajectory, breaks):
        time = _first_negative(demand.polynomial, breaks)
        if time is None:
            continue
        samples = breaks[:-1, None] + np.linspace(0.0, 1.0, SAMPLES) * np.diff(breaks)[:, None]
        values = demand.quantity(np.append(time, samples[samples > time]))
        worst = float(values[(demand.sign * values).argmax()])
        raise InfeasibleError(
            f"at {time:.3f} s: {demand.name} passes {demand.limit}, {demand.bound:.6g} "
            f"{demand.unit}, and comes to {worst:.6g} {demand.unit}; {demand.remedy}",
            limit=demand.limit, value=worst, bound=demand.bound, time=time,
        )


def _demands(crane: Crane, trajectory: LoadTrajectory, breaks: FloatArray) -> Iterator[Demand]:
    """All demands; the later ones rely on the earlier ones."""
    gravity = crane.gravity
    position = [_local_pieces(trajectory, axis, breaks) for axis in range(3)]
    z = position[2]
    x_pull, y_pull, z_pull = (derivative_pieces(pieces, 2) for pieces in position)
    z_pull[:, 0] += gravity

    def height(t: FloatArray) -> FloatArray:
        values: FloatArray = trajectory(t)[..., 2]
        return values

    def fall(t: FloatArray) -> FloatArray:
        values: FloatArray = -trajectory(t, 2)[..., 2]
        return values

    def length(t: FloatArray) -> FloatArray:
        pull = trajectory(t, 2) + np.array([0.0, 0.0, gravity])
        values: FloatArray = -height(t) * np.linalg.norm(pull, axis=-1) / pull[..., 2]
        return values

    yield Demand(
        _shifted(-z, -TOLERANCE), height, 1.0, 0.0,
        "load height z", "m", "the trolley's height", "lower the waypoints",
    )
    yield Demand(
        _shifted(z_pull, -TOLERANCE * gravity), fall, 1.0, gravity,
        "downward acceleration of the load", "m/s2", "gravity, where the rope goes slack",
        "lower limits.z.acceleration",
    )
    cosine = _product(z_pull, z_pull)
    reach = _product(_product(z, z), _product(x_pull, x_pull) + _product(y_pull, y_pull) + cosine)
    bounds = (
        (crane.rope_max, 1.0, "rope_max", "raise the waypoints or rope_max"),
        (crane.rope_min, -1.0, "rope_min", "lower the waypoints or rope_min"),
    )
    for bound, sign, name, remedy in bounds:
        if bound is not None:
            margin = sign * -reach
            allowed = (bound * (1.0 + sign * TOLERANCE)) ** 2
            margin[:, : cosine.shape[1]] += sign * allowed * cosine
            yield Demand(margin, length, sign, bound, "rope length", "m", name, remedy)


def _local_pieces(trajectory: LoadTrajectory, axis: int, breaks: FloatArray) -> FloatArray:
    """Position of one axis as polynomials in the local time of every interval of `breaks`."""
    own, lengths, coefficients = trajectory.pieces(axis)
    middles = 0.5 * (breaks[:-1] + breaks[1:])
    rows = np.clip(np.searchsorted(own, middles, side="right") - 1, 0, own.size - 1)
    offsets = breaks[:-1] - own[rows]
    width = coefficients.shape[1]
    local = np.zeros((rows.size, width))
    for i in range(width):
        for j in range(i, width):
            local[:, i] += comb(j, i) * coefficients[rows, j] * offsets ** (j - i)
    end = own[-1] + lengths[-1]
    ended = middles > end
    local[ended] = 0.0
    local[ended, 0] = trajectory(end)[axis]
    return local


def _product(a: FloatArray, b: FloatArray) -> FloatArray:
    """Products of polynomials, row by row."""
    product = np.zeros((a.shape[0], a.shape[1] + b.shape[1] - 1))
    for i in range(b.shape[1]):
        product[:, i : i + a.shape[1]] += a * b[:, i : i + 1]
    return product


def _shifted(pieces: FloatArray, constant: float) -> FloatArray:
    shifted = pieces.copy()
    shifted[:, 0] += constant
    return shifted


def _first_negative(pieces: FloatArray, breaks: FloatArray) -> float | None:
    """First time at which polynomials are not proved to be zero or more; None if nowhere."""
    lengths = np.diff(breaks)
    hull = hulls(pieces, lengths)
    for i in np.flatnonzero(hull.min(axis=1) < 0.0):
        share = _first_root(hull[i], HALVINGS)
        if share is not None:
            return float(breaks[i] + share * lengths[i])
    return None


def _first_root(hull: FloatArray, halvings: int) -> float | None:
    """Where on [0, 1] a polynomial first falls below zero, from its Bernstein coefficients."""
    if hull.min() >= 0.0:
        return None
    if hull[0] < 0.0 or halvings == 0:
        return 0.0
    left, right = _halves(hull)
    share = _first_root(left, halvings - 1)
    if share is not None:
        return 0.5 * share
    share = _first_root(right, halvings - 1)
    return None if share is None else 0.5 + 0.5 * share


def _halves(hull: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Bernstein coefficients on [0, 1/2] and [1/2, 1], by de Casteljau's scheme."""
    left, right = np.empty(hull.size), np.empty(hull.size)
    rest = hull
    for i in range(hull.size):
        left[i], right[-1 - i] = rest[0], rest[-1]
        rest = 0.5 * (rest[:-1] + rest[1:])
    return left, right
