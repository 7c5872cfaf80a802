"""What a load trajectory asks of the drives, and its exact peaks.

The demands are analytic functions on every polynomial piece of the trajectory. There they are
interpolated at Chebyshev points; a piece is halved until the last coefficients vanish, and the peak
is found on the interpolating polynomial. Where friction changes its law, pieces begin as well.
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import ArrayLike

from segfmu.crane.bounds import sides
from segfmu.crane.contacts import NONE, Contacts, resistance
from segfmu.crane.equipment import Friction
from segfmu.crane.parameters import Crane
from segfmu.crane.rope import LoadTrajectory
from segfmu.kernels import backend
from segfmu.kernels.crane.records import Axes, Contact, Demand, DemandWork
from segfmu.planning.arrays import FloatArray
from segfmu.planning.waypoint import Waypoint

ORDERS = 5
DEGREE = 16
# the last coefficients of a resolved piece, relative to the quantity's largest magnitude
RESOLVED = 1e-11
# below the first, coefficients that halving does not lower to this share of them are rounding, as
# that of the time in a long plan with short ramps
ROUNDED, LOWERED = 1e-5, 0.1
HALVINGS = 12
# a drive that hardly acts is resolved relative to this share of the one that acts most
SHARE = 1e-3
# below this, sway angles [rad] are rounding
SMALL_SWAY = 1e-6
# points of a resolved piece among which the peak is sought
GRID = 65
NEWTON_STEPS = 5
# way [m] behind which every contact slides
FAR = 1e30


def demands(
    crane: Crane, trajectory: LoadTrajectory, times: FloatArray, friction: Friction = NONE
) -> FloatArray:
    """Rows of the record `Demand` at times, shape (times, 14)."""
    return _at(Contacts(crane, friction, trajectory), trajectory, times)


def demands_in_state(crane: Crane, point: Waypoint, friction: Friction = NONE) -> FloatArray:
    """Magnitudes of the demands in the state of a waypoint in both directions, shape (2, 14).

    An axis that moves slides; one at rest needs no more than what it carries.
    """
    flat = np.zeros((1, ORDERS, 3))
    flat[0] = point.position, point.velocity, point.acceleration, point.jerk, point.snap
    known = resistance(crane, friction)
    rows = np.zeros((Axes.SIZE, 1, Contact.SIZE))
    velocity = _of(flat, np.zeros(1), known, rows)[0, Demand.VELOCITY : Demand.ACCELERATION]
    # far from where it turned
    rows[:, 0, Contact.POSITION] = np.where(velocity == 0.0, 0.0, -np.sign(velocity) * FAR)
    rows[velocity == 0.0, 0, Contact.RELEASED] = 1.0
    return sides(_of(flat, np.zeros(1), known, rows))


def _at(contacts: Contacts, trajectory: LoadTrajectory, times: FloatArray) -> FloatArray:
    flat = np.empty((times.size, ORDERS, 3))
    for order in range(ORDERS):
        flat[:, order] = trajectory(times, order)
    return _of(flat, times, contacts.resistance, contacts.rows)


def _of(
    flat: FloatArray, times: FloatArray, known: FloatArray, rows: FloatArray
) -> FloatArray:
    found = np.empty((flat.shape[0], Demand.SIZE))
    work = np.zeros((DemandWork.SIZE, DemandWork.COLUMNS))
    backend.drive_demands(flat, np.ascontiguousarray(times), known, rows, work, found)
    return found


def joints(trajectory: LoadTrajectory, more: ArrayLike = ()) -> FloatArray:
    """Times at which a polynomial piece of any axis begins or ends, and more, ascending."""
    ends = [np.array([0.0, trajectory.duration]), np.asarray(more, dtype=np.float64)]
    for axis in range(3):
        starts, lengths, _ = trajectory.pieces(axis)
        ends += [starts, starts + lengths]
    times = np.unique(np.clip(np.concatenate(ends), 0.0, trajectory.duration))
    apart = np.append(True, np.diff(times) > 1e-12 * max(trajectory.duration, 1e-300))
    return np.asarray(times[apart])


def rough_peaks(
    crane: Crane, trajectory: LoadTrajectory, friction: Friction = NONE
) -> FloatArray:
    """Greatest magnitudes among samples in both directions, (2, 14): a look, not a proof."""
    ends = joints(trajectory)
    shares = ends[:-1, None] + np.diff(ends)[:, None] * np.array([0.0, 0.21, 0.5, 0.79])
    even = np.linspace(0.0, trajectory.duration, 129)
    contacts = Contacts(crane, friction, trajectory)
    turns = contacts.times
    # friction is greatest as a contact begins to slide
    times = np.sort(np.concatenate([shares.ravel(), even, turns, 0.5 * (turns[1:] + turns[:-1])]))
    return sides(_at(contacts, trajectory, times))


def peaks(
    crane: Crane, trajectory: LoadTrajectory, friction: Friction = NONE
) -> tuple[FloatArray, FloatArray]:
    """Exact greatest magnitudes of all demands in the positive and in the negative direction.

    Also their times [s]; shapes (2, 14). 0 at time 0 where there is none in a direction.
    """
    contacts = Contacts(crane, friction, trajectory)
    ends = joints(trajectory, contacts.times)
    found, moments = np.zeros((2, Demand.SIZE)), np.zeros((2, Demand.SIZE))
    if ends.size < 2:
        return sides(_at(contacts, trajectory, ends)), moments
    starts, lengths, series = _resolved(contacts, trajectory, ends)
    grid = np.linspace(-1.0, 1.0, GRID)
    values = chebyshev.chebval(grid, series)
    # a grid misses a peak by no more than this
    missed = 0.01 * np.abs(values).max(axis=(1, 2))
    for side, sign in enumerate((1.0, -1.0)):
        best = (sign * values).max(axis=(1, 2))
        for i in np.flatnonzero(best > -missed):
            heights = sign * values[i]
            near = np.flatnonzero(heights.max(axis=1) >= best[i] - missed[i])
            at = grid[heights[near].argmax(axis=1)]
            places = _stationary(sign * series[:, i][:, near], at)
            moments_near = starts[near] + 0.5 * (places + 1.0) * lengths[near]
            exact = sign * _at(contacts, trajectory, moments_near)[:, i]
            worst = int(exact.argmax())
            found[side, i], moments[side, i] = exact[worst], moments_near[worst]
    return np.maximum(found, 0.0), moments


def _resolved(
    contacts: Contacts, trajectory: LoadTrajectory, ends: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Starts and lengths (pieces,) and Chebyshev series (17, 14, pieces) of resolved pieces."""
    starts, lengths = ends[:-1], np.diff(ends)
    done: list[tuple[FloatArray, FloatArray, FloatArray]] = []
    size: FloatArray = np.zeros(Demand.SIZE)
    before = np.full((Demand.SIZE, starts.size), np.inf)
    for halving in range(HALVINGS + 1):
        times = starts[:, None] + 0.5 * lengths[:, None] * (1.0 + _nodes())
        values = _at(contacts, trajectory, times.ravel()).reshape(*times.shape, Demand.SIZE)
        size = np.maximum(size, np.abs(values).max(axis=(0, 1)))
        series = np.einsum("kj,pji->kip", _transform(), values)
        tail = np.abs(series[-2:]).max(axis=0)
        scale = _scale(size)[:, None]
        rounding = (tail <= ROUNDED * scale) & (tail > LOWERED * before)
        unresolved = (tail > RESOLVED * scale) & ~rounding
        rough = unresolved.any(axis=0) & (halving < HALVINGS)
        done.append((starts[~rough], lengths[~rough], series[..., ~rough]))
        starts, lengths = starts[rough], 0.5 * lengths[rough]
        if starts.size == 0:
            break
        starts, lengths = np.concatenate([starts, starts + lengths]), np.tile(lengths, 2)
        before = np.tile(tail[:, rough], 2)
    return (
        np.concatenate([d[0] for d in done]), np.concatenate([d[1] for d in done]),
        np.concatenate([d[2] for d in done], axis=-1),
    )


def _scale(size: FloatArray) -> FloatArray:
    """Magnitudes relative to which quantities are resolved, from their largest ones, (14,)."""
    scale = size.copy()
    for first, last in pairwise((*range(0, Demand.SWAY + 1, 3), Demand.SIZE)):
        scale[first:last] = np.maximum(size[first:last], SHARE * size[first:last].max())
    scale[Demand.SWAY :] = np.maximum(scale[Demand.SWAY :], SMALL_SWAY)
    return scale


def _stationary(series: FloatArray, at: FloatArray) -> FloatArray:
    """Maxima of series (17, pieces) near starts (pieces,), by Newton's method."""
    slope, bend = chebyshev.chebder(series, axis=0), chebyshev.chebder(series, 2, axis=0)
    reach = 2.0 / (GRID - 1)
    low, high = np.maximum(at - reach, -1.0), np.minimum(at + reach, 1.0)
    place = at
    for _ in range(NEWTON_STEPS):
        rate = chebyshev.chebval(place, slope, tensor=False)
        change = chebyshev.chebval(place, bend, tensor=False)
        with np.errstate(all="ignore"):
            step = np.where(change != 0.0, rate / change, 0.0)
        place = np.clip(place - np.nan_to_num(step), low, high)
    best = chebyshev.chebval(place, series, tensor=False)
    return np.where(best >= chebyshev.chebval(at, series, tensor=False), place, at)


@cache
def _nodes() -> FloatArray:
    """Chebyshev points on [-1, 1], ends included."""
    return np.asarray(np.cos(np.pi * np.arange(DEGREE, -1, -1) / DEGREE))


@cache
def _transform() -> FloatArray:
    """Matrix from values at the nodes to the coefficients of the Chebyshev series."""
    return np.asarray(np.linalg.inv(chebyshev.chebvander(_nodes(), DEGREE)))
