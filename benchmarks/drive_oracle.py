"""What a plan asks of the drives, and the shortest transfer, without the project's crane.

Demands follow from the geometry of a taut rope: with w = p'' + g e_z the carriage is where the line
of the rope through the load p, along w, reaches z = 0. Time derivatives are those of truncated
Taylor series.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from segfmu import ActuatorBounds, Crane
from segfmu.crane import Friction

FloatArray = NDArray[np.float64]
ORDER = 3


class Motion(Protocol):
    """A load's motion, such as a `Trajectory`."""

    @property
    def duration(self) -> float: ...

    def __call__(self, t: FloatArray, derivative: int = 0) -> FloatArray: ...


FACTORIALS = np.array([1.0, 1.0, 2.0, 6.0, 24.0])


def _product(a: FloatArray, b: FloatArray) -> FloatArray:
    terms = [[a[j] * b[i - j] for j in range(i + 1)] for i in range(ORDER)]
    return np.array([np.sum(t, axis=0) for t in terms])


def _quotient(a: FloatArray, b: FloatArray) -> FloatArray:
    found: list[FloatArray] = []
    for i in range(ORDER):
        found.append((a[i] - sum(found[j] * b[i - j] for j in range(i))) / b[0])
    return np.array(found)


def _root(a: FloatArray) -> FloatArray:
    found = [np.sqrt(a[0])]
    for i in range(1, ORDER):
        inner = sum(found[j] * found[i - j] for j in range(1, i))
        found.append((a[i] - inner) / (2.0 * found[0]))
    return np.array(found)


def demands(
    crane: Crane, trajectory: Motion, times: FloatArray, friction: Friction | None = None
) -> FloatArray:
    """Force, velocity, acceleration, power, place and sway, shape (times, 17).

    With friction the times are samples from the start on, close enough for contacts to be followed.
    """
    series = np.array([trajectory(times, d) / FACTORIALS[d] for d in range(5)])
    load = series[:ORDER].transpose(2, 0, 1)
    # series of the second derivative: coefficient i is (i + 2)(i + 1) times that of the position
    growth = np.array([2.0, 6.0, 12.0])[:, None]
    pull = series[2:].transpose(2, 0, 1) * growth
    pull[2, 0] += crane.gravity
    ratio = _quotient(load[2], pull[2])
    size = _root(sum((_product(w, w) for w in pull), np.zeros(load[0].shape)))
    places = [load[i] - _product(ratio, pull[i]) for i in range(2)]
    places.append(-_product(ratio, size))
    velocity = np.stack([place[1] for place in places], axis=-1)
    acceleration = np.stack([2.0 * place[2] for place in places], axis=-1)
    moved = (crane.bridge_mass + crane.trolley_mass, crane.trolley_mass)
    force = np.stack(
        [moved[i] * acceleration[:, i] + crane.payload_mass * pull[i, 0] for i in range(2)]
        + [-crane.payload_mass * size[0]], axis=-1,
    )
    position = np.stack([place[0] for place in places], axis=-1)
    if friction is not None:
        force = force + friction_along(crane, friction, position, velocity)
    sway = np.stack(
        [np.arctan2(-pull[0, 0], np.hypot(pull[1, 0], pull[2, 0])),
         np.arctan2(pull[1, 0], pull[2, 0])], axis=-1,
    )
    return np.hstack([force, velocity, acceleration, force * velocity, position, sway])


def friction_along(
    crane: Crane, friction: Friction, position: FloatArray, velocity: FloatArray
) -> FloatArray:
    """Friction of bridge, trolley and hoist (times, 3) from rest on, from sample to sample.

    The spring of a contact follows its axis up to the presliding displacement; beside it acts a
    damper that is critical for the axis' own mass, as long as nothing slides.
    """
    masses = (crane.bridge_mass + crane.trolley_mass, crane.trolley_mass, crane.payload_mass)
    found = np.zeros(position.shape)
    for axis, mass in enumerate(masses):
        v, coulomb = velocity[:, axis], friction.coulomb[axis]
        static = max(friction.static[axis], coulomb)
        found[:, axis] = (friction.viscous[axis] + friction.drag[axis] * np.abs(v)) * v
        if static == 0.0:
            continue
        level = coulomb + (static - coulomb) * np.exp(-((v / friction.width) ** 2))
        springs = [0.0]
        for way in np.diff(position[:, axis]):
            stretched = springs[-1] + way
            springs.append(min(max(stretched, -friction.presliding), friction.presliding))
        share = np.array(springs) / friction.presliding
        damping = 2.0 * np.sqrt(1.5 * static * mass / friction.presliding) * v
        damped = damping / np.hypot(level, damping)
        found[:, axis] += level * (0.5 * share * (3.0 - share**2) + damped * (1.0 - share**2))
    return found


def largest_use(
    crane: Crane, trajectory: Motion, bounds: ActuatorBounds, samples: int,
    friction: Friction | None = None,
) -> float:
    """Largest share of a bound, each direction against its own, among equidistant samples."""
    return float(shares(crane, trajectory, bounds, samples, friction).max())


def shares(
    crane: Crane, trajectory: Motion, bounds: ActuatorBounds, samples: int,
    friction: Friction | None = None,
) -> FloatArray:
    """Largest shares of the bounds in the positive and the negative direction, shape (2, 17).

    Of a travel, from the middle between its end stops.
    """
    times = np.linspace(0.0, trajectory.duration, samples)
    found = demands(crane, trajectory, times, friction)
    stopped = np.isfinite(bounds.travel) & np.isfinite(bounds.travel_min)
    least, greatest = (np.where(stopped, s, 0.0) for s in (bounds.travel_min, bounds.travel))
    half = np.where(stopped, 0.5 * (greatest - least), np.inf)
    found[:, 12:15] -= 0.5 * (greatest + least)
    upper = [bounds.force, bounds.velocity, bounds.acceleration, bounds.power, half,
             bounds.sway_angle]
    directed = [bounds.force_min, bounds.velocity_min, bounds.acceleration_min]
    lower = [np.where(np.isinf(b), u, -b) for b, u in zip(directed, upper, strict=False)]
    return np.array([
        found.max(axis=0) / np.concatenate(upper),
        -found.min(axis=0) / np.concatenate([*lower, *upper[3:]]),
    ])


def shortest_transfer(
    distance: float, rope: float, gravity: float, velocity: float, acceleration: float,
    intervals: int, tolerance: float, *, braking: float | None = None,
) -> float:
    """Shortest time [s] of a carriage that takes a hanging load from rest to rest, linearised.

    By bisection over linear programs in the carriage's acceleration, constant in each interval. The
    pendulum is exact; no smoothness is asked for. braking: the acceleration backwards, if that
    differs.
    """
    ranges = (-acceleration if braking is None else -braking, acceleration)
    low = distance / velocity
    high = low + velocity / acceleration + 4.0 * np.pi * (rope / gravity) ** 0.5
    frequency = (gravity / rope) ** 0.5
    while high - low > tolerance * high:
        middle = 0.5 * (low + high)
        if _reaches(middle, distance, frequency, velocity, ranges, intervals):
            high = middle
        else:
            low = middle
    return float(high)


def _reaches(
    duration: float, distance: float, frequency: float, velocity: float,
    ranges: tuple[float, float], intervals: int,
) -> bool:
    step = duration / intervals
    left = duration - step * np.arange(intervals + 1)
    early, late = left[:-1], left[1:]
    # effects of each acceleration on velocity and position of the carriage, and on the sway
    effects = np.array([
        np.full(intervals, step), 0.5 * (early**2 - late**2),
        np.cos(frequency * late) - np.cos(frequency * early),
        np.sin(frequency * early) - np.sin(frequency * late),
    ])
    gained = np.tril(np.full((intervals, intervals), step))
    return bool(
        linprog(
            np.zeros(intervals), A_ub=np.vstack([gained, -gained]),
            b_ub=np.full(2 * intervals, velocity), A_eq=effects, b_eq=[0.0, distance, 0.0, 0.0],
            bounds=ranges, method="highs",
        ).status == 0
    )
