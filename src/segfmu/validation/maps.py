"""Maps of the campaign: move times against shaped trapezoids, and eigenvalues of the loop.

Move times. A carriage has a velocity limit V and an acceleration limit A. The load moves a distance
d at a constant height h below it, from rest to rest without residual sway. A trapezoid takes T(d,
V, A); the shapers ZV and ZVD add half and one period 2 pi sqrt(h / g), and keep both limits. The
planner takes V and A as limits of the load; the carriage is then exactly at y + h y'' / g, and its
velocity y' + h y''' / g and acceleration y'' + h y'''' / g must keep V and A too. A search over
jerk and snap finds the least time; they are made dimensionless by A sqrt(g / h) and A g / h.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from math import pi, sqrt

import numpy as np
from numpy.typing import NDArray

from segfmu.crane import Crane
from segfmu.crane.shaping import Trapezoid
from segfmu.crane.stability import stability_map
from segfmu.errors import InfeasibleError
from segfmu.planning import Limits, Trajectory, Waypoint, plan
from segfmu.planning.arrays import FloatArray
from segfmu.validation.disturbances import LAG
from segfmu.validation.methods import MODES, tracking_controller

SHAPES = ("plateau", "smoothstep")

# dimensionless jerk and snap: first search, and refinements around its best
COARSE = np.geomspace(0.3, 2.0, 9)
FINE = (np.geomspace(0.87, 1.15, 5), np.geomspace(0.97, 1.03, 5))

SAMPLES = 401
TOLERANCE = 1e-6

DESIGNS = ("LQR", "flatness")
PAYLOADS = 2.0


@dataclass(frozen=True)
class Setting:
    """Dimensionless jerk and snap limits, and the shape of the ramps."""

    shape: str
    jerk: float
    snap: float

    def plan(
        self, distance: float, limits: tuple[float, float], height: float, gravity: float
    ) -> Trajectory:
        """The load's motion over a distance [m] at a height [m] below the carriage."""
        velocity, acceleration = limits
        frequency = sqrt(gravity / height)
        bounds = Limits(
            velocity, acceleration, self.jerk * acceleration * frequency,
            self.snap * acceleration * frequency**2,
        )
        return plan([Waypoint([0.0]), Waypoint([distance])], bounds, shape=self.shape)


def carriage_usage(
    trajectory: Trajectory, limits: tuple[float, float], height: float, gravity: float
) -> float:
    """Largest ratio of the carriage's velocity and acceleration to their limits."""
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    lever = height / gravity
    peaks = [
        np.abs(trajectory(times, order) + lever * trajectory(times, order + 2)).max() / limit
        for order, limit in zip((1, 2), limits, strict=True)
    ]
    return float(max(peaks))


def fastest(
    distances: Sequence[float], limits: tuple[float, float], height: float, gravity: float
) -> tuple[float, Setting]:
    """Least total time [s] of plans that keep the carriage's limits too, and their setting.

    Raises
    ------
    InfeasibleError
        If no setting of the search keeps the limits.
    """
    best: tuple[float, Setting | None] = (np.inf, None)

    def search(shapes: Sequence[str], jerks: FloatArray, snaps: FloatArray) -> None:
        nonlocal best
        for shape, jerk, snap in product(shapes, jerks.tolist(), snaps.tolist()):
            setting = Setting(shape, jerk, snap)
            plans = [setting.plan(distance, limits, height, gravity) for distance in distances]
            time = sum(found.duration for found in plans)
            if time < best[0] and all(
                carriage_usage(found, limits, height, gravity) <= 1.0 + TOLERANCE
                for found in plans
            ):
                best = time, setting

    search(SHAPES, COARSE, COARSE)
    for fine in FINE:
        if best[1] is not None:
            search((best[1].shape,), best[1].jerk * fine, best[1].snap * fine)
    time, setting = best
    if setting is None:
        raise InfeasibleError(
            f"no plan over {max(distances):g} m keeps the carriage within {limits[0]:g} m/s and "
            f"{limits[1]:g} m/s2 at a rope length of {height:g} m; raise the limits"
        )
    return time, setting


def move_times(
    heights: FloatArray, distances: FloatArray, limits: tuple[float, float], gravity: float
) -> NDArray[np.void]:
    """Times [s] of plan, trapezoid, ZV and ZVD for every height and distance [m].

    `plan` has jerk and snap tuned for height and distance, as a shaper is for the height. `fixed`
    has one jerk and snap for all, the fastest for the longest rope; it also keeps the carriage's
    limits with shorter ropes, because the factor h / g is smaller.

    Returns
    -------
    ndarray, structured, shape (heights * distances,)
        height, distance, trapezoid, zv, zvd, plan, fixed.
    """
    longest = float(np.max(heights))
    _, common = fastest(distances.tolist(), limits, longest, gravity)
    rows = []
    for height, distance in product(heights.tolist(), distances.tolist()):
        trapezoid = Trapezoid(distance, *limits).duration
        half = pi * sqrt(height / gravity)
        tuned, _ = fastest([distance], limits, height, gravity)
        fixed = common.plan(distance, limits, longest, gravity).duration
        rows.append(
            (height, distance, trapezoid, trapezoid + half, trapezoid + 2.0 * half, tuned, fixed)
        )
    names = ("height", "distance", "trapezoid", "zv", "zvd", "plan", "fixed")
    return np.array(rows, dtype=[(name, np.float64) for name in names])


def eigenvalue_maps(
    crane: Crane, ropes: tuple[float, float], lengths: int, payloads: int
) -> NDArray[np.void]:
    """Largest eigenvalue magnitude of the loop over rope length [m] and payload [kg].

    For both modes (velocity drives lag by LAG) and both designs; payloads from 0 to PAYLOADS times
    the nominal one.

    Returns
    -------
    ndarray, structured, shape (4 * lengths * payloads,)
        driven (1 for velocity drives), design (index of DESIGNS), length, payload, eigenvalue.
    """
    grid = np.geomspace(*ropes, lengths)
    masses = np.linspace(0.0, PAYLOADS * crane.payload_mass, payloads)
    rows = []
    for mode, (number, design) in product(MODES, enumerate(DESIGNS)):
        driven = mode == "velocity"
        controller = tracking_controller(crane, design, driven, ropes)
        found = stability_map(controller, grid, masses, (LAG if driven else 0.0,) * 3)
        rows += [
            (float(driven), number, length, mass, value)
            for (length, mass), value in zip(product(grid, masses), found.ravel(), strict=True)
        ]
    names = ("driven", "design", "length", "payload", "eigenvalue")
    return np.array(rows, dtype=[(name, np.float64) for name in names])
