"""Maps of the campaign: move times against shaped trapezoids, and eigenvalues of the loop.

Move times. A carriage may move with a velocity V and an acceleration A. The load is to go a
distance d at a constant height h below it, from rest to rest without residual sway. A trapezoid
takes T(d, V, A); the shapers ZV and ZVD add half and one period pi sqrt(h / g), and keep both
limits. The plan is that of the planner with V and A as the load's limits; the carriage is then at
y + h y'' / g, exactly, and its velocity y' + h y''' / g and acceleration y'' + h y'''' / g must
keep V and A as well. Jerk and snap are scaled by A sqrt(g / h) and A g / h, which makes the
problem one without dimensions, and chosen for the least time by search.
"""

from __future__ import annotations

from collections.abc import Callable
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

# jerk and snap without dimensions: first search, and the refinement around its best
COARSE = np.geomspace(0.3, 2.0, 9)
FINE = np.geomspace(0.85, 1.18, 7)

SAMPLES = 401
TOLERANCE = 1e-6

DESIGNS = ("LQR", "flatness")
PAYLOADS = 2.0


@dataclass(frozen=True)
class Setting:
    """Jerk and snap limits without dimensions, and the shape of the ramps."""

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
    """Largest of the carriage's velocity and acceleration over their limits."""
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    lever = height / gravity
    peaks = [
        np.abs(trajectory(times, order) + lever * trajectory(times, order + 2)).max() / limit
        for order, limit in zip((1, 2), limits, strict=True)
    ]
    return float(max(peaks))


def fastest(
    distance: float, limits: tuple[float, float], height: float, gravity: float
) -> tuple[float, Setting]:
    """Least duration [s] of a plan whose carriage keeps its limits too, and its setting."""

    def duration(setting: Setting) -> float:
        try:
            found = setting.plan(distance, limits, height, gravity)
        except InfeasibleError:
            return np.inf
        usage = carriage_usage(found, limits, height, gravity)
        return found.duration if usage <= 1.0 + TOLERANCE else np.inf

    return _least(duration)


def _least(duration: Callable[[Setting], float]) -> tuple[float, Setting]:
    settings = [Setting(*values) for values in product(SHAPES, COARSE, COARSE)]
    time, best = min(((duration(s), s) for s in settings), key=lambda found: found[0])
    near = [
        Setting(best.shape, best.jerk * float(j), best.snap * float(s))
        for j, s in product(FINE, FINE)
    ]
    return min([(time, best), *((duration(s), s) for s in near)], key=lambda found: found[0])


def move_times(
    heights: FloatArray, distances: FloatArray, limits: tuple[float, float], gravity: float
) -> NDArray[np.void]:
    """Times [s] of plan, trapezoid, ZV and ZVD for every height and distance [m].

    `setting` is the plan with one setting of jerk and snap for all, in SI units: that which is
    fastest for the longest rope and distance. It keeps the carriage's limits with shorter ropes.

    Returns
    -------
    ndarray, structured, shape (heights * distances,)
        height, distance, trapezoid, zv, zvd, plan, fixed.
    """
    longest = float(np.max(heights))
    _, common = fastest(float(np.max(distances)), limits, longest, gravity)
    rows = []
    for height, distance in product(heights.tolist(), distances.tolist()):
        trapezoid = Trapezoid(distance, *limits).duration
        half = pi * sqrt(height / gravity)
        time, _ = fastest(distance, limits, height, gravity)
        fixed = common.plan(distance, limits, longest, gravity)
        if carriage_usage(fixed, limits, height, gravity) > 1.0 + TOLERANCE:
            fixed_time = np.nan
        else:
            fixed_time = fixed.duration
        rows.append(
            (height, distance, trapezoid, trapezoid + half, trapezoid + 2.0 * half, time,
             fixed_time)
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
