"""Methods that a crane may be driven by in place of the plan: the baselines of comparisons.

A baseline moves bridge, trolley and rope from waypoint to waypoint with trapezoidal velocities. It
stops at each waypoint, because trapezoids of several axes cannot pass one together while moving.
ZV and ZVD shape bridge and trolley for the mean rope length; the load they refer to swings as a
linear pendulum of this length does. The others refer to a load straight below.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import inf, sqrt
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from segfmu.cosim import Change
from segfmu.crane import Crane
from segfmu.crane.linear import moved_masses
from segfmu.crane.shaping import Shaper, Trapezoid, zv, zvd
from segfmu.errors import InputError
from segfmu.fmu.gantry_crane.interface import STATE
from segfmu.planning.arrays import FloatArray
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.hook_checks import require_gantry
from segfmu.validation.files.keys import AXES, DRIVES
from segfmu.validation.files.mission import Mission

SHAPERS: dict[str, Callable[[float], Shaper]] = {"zv": zv, "zvd": zvd}
# of a trapezoid without a shaper
PLAIN = Shaper(np.zeros(1), np.ones(1))
# critically damped control of the carriages' positions: its frequency over the pendulum's; a
# stiffer one asks for more than drives have
RATIO = 1.0


class Legs:
    """Consecutive trapezoids of one axis, shaped.

    Parameters
    ----------
    positions : ndarray, shape (n,)
        [m]
    lengths : ndarray, shape (n - 1,)
        Time from each position to the next one [s].
    velocity, acceleration : float
        Limits [m/s], [m/s2].
    shaper : Shaper
    """

    def __init__(
        self, positions: FloatArray, lengths: FloatArray, velocity: float, acceleration: float,
        shaper: Shaper = PLAIN,
    ) -> None:
        self.duration = float(np.sum(lengths) + shaper.times[-1])
        self._start, self._shaper = float(positions[0]), shaper
        starts = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
        legs = [Trapezoid(float(b - a), velocity, acceleration) for a, b in pairwise(positions)]
        self._legs = list(zip(starts.tolist(), legs, strict=True))

    def __call__(self, t: ArrayLike, derivative: int = 0) -> FloatArray:
        """Position, velocity or acceleration at times t, the shape of t."""
        times = np.asarray(t, dtype=np.float64)
        value = np.full(times.shape, self._start if derivative == 0 else 0.0)
        for start, leg in self._legs:
            for delay, share in zip(self._shaper.times, self._shaper.shares, strict=True):
                value += share * leg(times - start - delay, derivative)
        return value

    def swing(self, t: ArrayLike, frequency: float) -> tuple[FloatArray, FloatArray]:
        """Deviation of a linear pendulum below the axis from it [m], and its rate [m/s]."""
        times = np.asarray(t, dtype=np.float64)
        value, rate = np.zeros(times.shape), np.zeros(times.shape)
        for start, leg in self._legs:
            for delay, share in zip(self._shaper.times, self._shaper.shares, strict=True):
                for edge, step in leg.edges:
                    since = frequency * np.clip(times - start - delay - edge, 0.0, None)
                    value -= share * step / frequency**2 * (1.0 - np.cos(since))
                    rate -= share * step / frequency * np.sin(since)
        return value, rate


@dataclass(frozen=True, eq=False)
class Course:
    """The motion of a baseline.

    Attributes
    ----------
    duration : float
        [s], without dead times.
    crane : Crane
    motions : tuple of 3 Legs
        Of bridge, trolley and rope.
    frequencies : tuple of 2 float
        Of the pendulums that the reference swings as, along x and y [rad/s]; 0: straight below.
    lag, dead_time : tuple of 3 float
        Of the drives as the crane file has them [s].
    """

    duration: float
    crane: Crane
    motions: tuple[Legs, Legs, Legs]
    frequencies: tuple[float, float]
    lag: tuple[float, ...]
    dead_time: tuple[float, ...]

    def reference(self, times: FloatArray) -> FloatArray:
        """Reference state at times [s], shape (times, 10)."""
        since = times - max(self.dead_time)
        place, speed = (
            np.stack([m(since, order) for m in self.motions], axis=-1) for order in (0, 1)
        )
        state = np.zeros((times.size, 10))
        state[:, :3], state[:, 5:8] = place, speed
        if all(self.frequencies):
            pairs = zip(self.motions[:2], self.frequencies, strict=True)
            (x, u), (y, v) = (motion.swing(since, own) for motion, own in pairs)
            length, winding = place[:, 2], speed[:, 2]
            # load: x + l sin phi_x, y - l cos phi_x sin phi_y
            first = np.arcsin(np.clip(x / length, -1.0, 1.0))
            second = np.arcsin(np.clip(-y / (length * np.cos(first)), -1.0, 1.0))
            rate = (u - winding * np.sin(first)) / (length * np.cos(first))
            lever = length * np.cos(first)
            shrinking = winding * np.cos(first) - length * np.sin(first) * rate
            state[:, 3], state[:, 4], state[:, 8] = first, second, rate
            state[:, 9] = (-v - shrinking * np.sin(second)) / (lever * np.cos(second))
        return state

    def setpoints(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Forces [N] and velocities [m/s] that are held from each time to the next one.

        Velocities move the carriages as far as the motion does; known lags are compensated. Forces
        move carriage and load as one body. Shapes (times - 1, 3).
        """
        step = np.diff(times)
        forces, velocities = [], []
        masses = moved_masses(self.crane.masses)
        masses = masses + self.crane.payload_mass * np.array([1.0, 1.0, 0.0])
        late = max(self.dead_time)
        for motion, mass, lag, dead in zip(
            self.motions, masses, self.lag, self.dead_time, strict=True
        ):
            own = times - late + dead
            speed, gain = (np.diff(motion(own, order)) / step for order in (0, 1))
            velocities.append(speed + lag * gain)
            forces.append(mass * gain)
        weight = np.array([0.0, 0.0, self.crane.payload_mass * self.crane.gravity])
        return np.stack(forces, axis=-1) - weight, np.stack(velocities, axis=-1)


def baseline_crane(mission: Mission) -> Crane:
    """The crane that a baseline moves.

    Raises
    ------
    InputError
        For one with a hook.
    """
    return require_gantry(mission.build_crane(), "method but feedforward")


def course(mission: Mission, method: str) -> Course:
    """The course of "trapezoid", "pd", "zv" or "zvd" through a mission's waypoints.

    Velocities and accelerations are within the mission's limits and the drives' bounds.

    Raises
    ------
    InputError
        Where neither are known, and for a crane with a hook.
    """
    crane, frequencies = baseline_crane(mission), [0.0, 0.0]
    points = np.array([w.position for w in mission.waypoints]) * [1.0, 1.0, -1.0]
    limits = [_limits(mission, axis) for axis in range(3)]
    lengths = np.array([
        max(Trapezoid(float(d), *own).duration for d, own in zip(leg, limits, strict=True))
        for leg in np.diff(points, axis=0)
    ]) + [w.dwell for w in mission.waypoints[1:]]
    legs = [Legs(points[:, i], lengths, *own) for i, own in enumerate(limits)]
    drives = [getattr(mission.crane, name) for name in DRIVES]
    if method in SHAPERS:
        mean = float(legs[2](np.linspace(0.0, legs[2].duration, 1001)).mean())
        driven = crane_parameters.parameters(mission.crane)["drive.mode"] == "velocity"
        for axis in range(2):
            share = 0.0 if driven else crane.payload_mass / moved_masses(crane.masses)[axis]
            frequencies[axis] = sqrt(crane.gravity / mean * (1.0 + float(share)))
            shaper = SHAPERS[method](frequencies[axis])
            legs[axis] = Legs(points[:, axis], lengths, *limits[axis], shaper)
    return Course(
        max(leg.duration for leg in legs), crane, (legs[0], legs[1], legs[2]),
        (frequencies[0], frequencies[1]),
        tuple(d.lag or 0.0 for d in drives), tuple(d.dead_time or 0.0 for d in drives),
    )


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


def changes(own: Course, fmu: str, times: FloatArray) -> list[Change]:
    """Inputs of GantryCrane at every communication step."""
    forces, velocities = own.setpoints(times)
    states = own.reference(times)
    loads = np.array([own.crane.load(state)[0] for state in states])
    names = [f"{kind}.{drive}" for kind in ("force", "velocity") for drive in DRIVES]
    names += [f"reference.{name}" for name in STATE]
    names += [f"reference.load.position.{axis}" for axis in AXES]
    table = np.hstack([forces, velocities, states[:-1], loads[:-1]])
    found, before = [], None
    for time, row in zip(times.tolist(), table.tolist(), strict=False):
        if row != before:
            found.append(Change(time, fmu, dict(zip(names, row, strict=True))))
        before = row
    return found


def position_gains(crane: Crane, driven: bool, table: Mapping[str, Any]) -> dict[str, Any]:
    """The table of gains of PD control of the carriages' positions: nothing of the sway.

    `table` is that of the crane's linear-quadratic design, whose hoist stays.
    """
    masses = moved_masses(crane.masses) if not driven else np.ones(3)
    found = dict(table)
    for name in table:
        row, _, gain = name.rpartition("].")
        drive, _, quantity = gain.partition(".")
        if drive not in DRIVES[:2]:
            continue
        own = RATIO * sqrt(crane.gravity / float(table[f"{row}].length"]))
        mass = float(masses[DRIVES.index(drive)])
        found[name] = mass * {"position": own**2, "velocity": 2.0 * own}.get(quantity, 0.0)
    return found
