"""Trapezoidal velocities of bridge, trolley and rope, plain or shaped.

They stop at each waypoint, because trapezoids of several axes cannot pass one together while
moving. Shapers are for the swings about the mean rope length; the load that they refer to swings as
linear pendulums do until the end, and rests then. The others refer to a load straight below.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from math import inf

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane.shaping import Shaper, Trapezoid, zv, zvd
from segfmu.errors import InputError
from segfmu.validation.baselines.course import Course, carriages, hanging
from segfmu.validation.baselines.legs import PLAIN, Legs
from segfmu.validation.baselines.swings import Swing, swings
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.keys import AXES, DRIVES
from segfmu.validation.files.mission import Mission

# shaper, and for how many swings
SHAPERS = {"zv": (zv, 1), "zvd": (zvd, 1), "zv_both": (zv, 2), "zvd_both": (zvd, 2)}


@dataclass(frozen=True, eq=False)
class Trapezoids(Course):
    """A course of trapezoids.

    Attributes
    ----------
    motions : tuple of 3 Legs
        Of bridge, trolley and rope.
    swings : tuple of 2 sequences of Swing
        That the reference has along x and y; none: straight below.
    """

    motions: tuple[Legs, Legs, Legs]
    swings: tuple[Sequence[Swing], Sequence[Swing]]

    def motion(self, times: FloatArray, derivative: int) -> FloatArray:
        return np.stack([m(times, derivative) for m in self.motions], axis=-1)

    def forces(self, times: FloatArray, accelerations: FloatArray) -> FloatArray:
        """They move carriage and load as one body."""
        hung = hanging(self.crane)
        masses = np.append(carriages(self.crane) + hung, hung)
        found: FloatArray = accelerations * masses
        found[:, 2] -= hung * self.crane.gravity
        return found

    def reference(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        since = self.begun(times)
        place, speed = self.motion(since, 0), self.motion(since, 1)
        ends, rates, loads = (np.zeros((since.size, 2)) for _ in range(3))
        for axis, (motion, own) in enumerate(zip(self.motions[:2], self.swings, strict=True)):
            for swing in own:
                deviation, rate = motion.swing(since, swing.frequency)
                ends[:, axis] += swing.end * deviation
                rates[:, axis] += swing.end * rate
                loads[:, axis] += swing.load * deviation
        for values in (ends, rates, loads):
            values[since >= self.duration] = 0.0
        state = np.hstack([place, np.zeros_like(ends), speed, np.zeros_like(ends)])
        _hang(state, ends, rates)
        # the sling is as long as it is
        across = np.linalg.norm(loads - ends, axis=1)
        below = place[:, 2] * np.cos(state[:, 3]) * np.cos(state[:, 4])
        below += np.sqrt(np.clip(self.crane.tackle[1] ** 2 - across**2, 0.0, None))
        return state, np.column_stack([place[:, :2] + loads, -below])


def _hang(state: FloatArray, ends: FloatArray, rates: FloatArray) -> None:
    """Write angles and rates of the rope whose end deviates so from the carriage, and so fast.

    The end is at x + l sin phi_x, y - l cos phi_x sin phi_y.
    """
    length, winding = state[:, 2], state[:, 7]
    first = np.arcsin(np.clip(ends[:, 0] / length, -1.0, 1.0))
    lever = length * np.cos(first)
    second = np.arcsin(np.clip(-ends[:, 1] / lever, -1.0, 1.0))
    rate = (rates[:, 0] - winding * np.sin(first)) / lever
    shrinking = winding * np.cos(first) - length * np.sin(first) * rate
    state[:, 3], state[:, 4], state[:, 8] = first, second, rate
    state[:, 9] = (-rates[:, 1] - shrinking * np.sin(second)) / (lever * np.cos(second))


def trapezoids(mission: Mission, method: str) -> Trapezoids:
    """The course of "trapezoid", "pd", or one of `SHAPERS` through a mission's waypoints.

    Velocities and accelerations are within the mission's limits and the drives' bounds.

    Raises
    ------
    InputError
        Where neither are known.
    """
    crane = mission.build_crane()
    # of the rope
    points = np.array([w.position for w in mission.waypoints]) * [1.0, 1.0, -1.0]
    points[:, 2] -= crane.tackle[1]
    limits = [_limits(mission, axis) for axis in range(3)]
    lengths = np.array([
        max(Trapezoid(float(d), *own).duration for d, own in zip(leg, limits, strict=True))
        for leg in np.diff(points, axis=0)
    ]) + [w.dwell for w in mission.waypoints[1:]]
    rope = Legs(points[:, 2], lengths, *limits[2])
    mean = float(rope(np.linspace(0.0, rope.duration, 1001)).mean())
    found: list[Sequence[Swing]] = [(), ()]
    shapers = [PLAIN, PLAIN]
    if method in SHAPERS:
        driven = crane_parameters.parameters(mission.crane)["drive.mode"] == "velocity"
        for axis, mass in enumerate(carriages(crane).tolist()):
            found[axis] = swings(crane, mean, inf if driven else mass)
            shapers[axis] = _shaper(method, found[axis])
    legs = [Legs(points[:, i], lengths, *limits[i], shapers[i]) for i in range(2)]
    drives = [getattr(mission.crane, name) for name in DRIVES]
    return Trapezoids(
        max(leg.duration for leg in (*legs, rope)), crane, tuple(d.lag or 0.0 for d in drives),
        tuple(d.dead_time or 0.0 for d in drives), (legs[0], legs[1], rope), (found[0], found[1]),
    )


def _shaper(method: str, own: Sequence[Swing]) -> Shaper:
    make, count = SHAPERS[method]
    return reduce(Shaper.then, (make(swing.frequency) for swing in own[:count]))


def _limits(mission: Mission, axis: int) -> tuple[float, float]:
    """Velocity and acceleration of a carriage or the rope."""
    bounds = mission.build_bounds()
    found = []
    for name in ("velocity", "acceleration"):
        own = inf if bounds is None else float(getattr(bounds, name)[axis])
        given = None if mission.limits is None else getattr(mission.limits, AXES[axis])
        found.append(min(own, inf if given is None else getattr(given, name)))
        if found[-1] == inf:
            raise InputError(
                f"method: a trapezoid needs a limit or a bound of the {name} along {AXES[axis]}"
            )
    return found[0], found[1]
