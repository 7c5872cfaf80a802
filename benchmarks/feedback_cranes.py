"""Random cranes that differ from what their feedback was designed for, each with one move."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from segfmu import Crane, FlatInverse, Limits, Waypoint, plan
from segfmu.crane import Compensation, Drive, Feedforward, Friction, Rig, Sensors
from segfmu.crane.equipment import DRIVE
from segfmu.crane.sensors import SENSORS
from segfmu.crane.variables import values
from segfmu.fmu.gantry_crane.interface import spec

SEED = 7


@dataclass(frozen=True, eq=False)
class Perturbed:
    """A crane as it is, as its user describes it, and its move.

    Attributes
    ----------
    crane, rig : Crane, Rig
        The true crane.
    nominal : Crane
        The crane of plan and feedback.
    driven : bool
        Velocity drives.
    period : float or None
        Of the feedback [s]; None: the default.
    feedforward : Feedforward
    longer : float
        True length of the rope at the start less the planned one [m].
    """

    crane: Crane
    rig: Rig
    nominal: Crane
    driven: bool
    period: float | None
    feedforward: Feedforward
    longer: float

    @property
    def name(self) -> str:
        """What identifies it in a list of failures."""
        drive, first = self.rig.bridge, -float(self.feedforward.load(0.0)[2])
        return (
            f"{'velocity' if self.driven else 'force'}, {self.nominal.payload_mass:.3g} kg, "
            f"rope {first:.3g} to {-self.feedforward.load(self.end)[2]:.3g} m, "
            f"lag {drive.lag:.2g} s, period "
            f"{self.period}, dead {self.rig.sensors.dead_time:.3g} + {drive.dead_time:.2g} s"
        )

    @property
    def longest(self) -> float:
        """Longest planned rope [m]."""
        return max(-float(self.feedforward.load(t)[2]) for t in (0.0, self.end))

    @property
    def end(self) -> float:
        """When the plan ends [s]."""
        known = self.feedforward
        return float(known.inverse.trajectory.duration) + known.compensation.delay

    @property
    def resolution(self) -> float:
        """What the sensors resolve of the load's place [m]: steps of carriage and angle."""
        steps = self.rig.sensors.resolution
        return float(steps[0] + self.longest * steps[3])

    def values(self, design: str) -> dict[str, Any]:
        """The parameters of GantryCrane, as its user would set them for a feedback."""
        known = {v.name: v.start for v in _parameters()}
        known |= self.nominal.values() | values(self.rig.sensors, SENSORS)
        for drive, mapping in zip(self.rig.drives, DRIVE, strict=True):
            known |= values(drive, mapping)
        # the zero of a sensor is not known
        known |= {n: 0.0 for n in known if n.startswith("sensor.") and n.endswith(".offset")}
        known["drive.mode"] = 2 if self.driven else 1
        known["feedback.source"] = 2
        known["feedback.design"] = {"lqr": 1, "flatness": 2}[design]
        if self.period is not None:
            known["feedback.sample_time"] = self.period
        return known


@cache
def _parameters() -> tuple[Any, ...]:
    return tuple(v for v in spec().variables if v.causality == "parameter")


def perturbed_cranes(count: int, seed: int = SEED) -> Iterator[Perturbed]:
    """Loads of 1 kg to 40 t, ropes of 0.5 to 20 m; both kinds of drives in turn."""
    for number in range(count):
        yield perturbed_crane(np.random.default_rng([seed, number]), number % 2 == 0)


def perturbed_crane(random: np.random.Generator, driven: bool) -> Perturbed:
    """One of them; `driven`: with velocity drives."""
    payload = 40e3 ** random.uniform()
    rope = 0.5 * 40.0 ** random.uniform()
    masses = payload * 10.0 ** random.uniform([-0.3, -0.7], [1.0, 0.5])
    second = float(np.clip(rope * random.uniform(0.6, 1.6), 0.5, 20.0))
    if random.random() < 0.4:
        second = rope
    # +-10 % of the rope stay within the range
    ends = 0.85 * min(rope, second), 1.15 * max(rope, second)
    nominal = Crane(masses[0], masses[1], payload, rope_min=ends[0], rope_max=ends[1])
    inverse = _move(random, nominal, rope, second)
    period = float(random.choice([0.005, 0.01, 0.02]))
    dead = period * float(random.integers(1, 4))
    late = period * float(random.uniform()) if random.random() < 0.3 else 0.0
    drives = _drives(random, nominal, inverse, driven, late)
    share = random.uniform(-0.1, 0.1)
    measured = random.random() < 0.5
    rig = Rig(
        *drives, friction=_friction(random, nominal),
        sensors=_sensors(random, rope, period, dead, 0.0 if measured else -share * rope),
    )
    lag = drives[0].lag
    compensation = Compensation((lag, lag, lag), dead_time=(late, late, late))
    true = Crane(
        masses[0], masses[1], payload * random.uniform(0.5, 1.5),
        rope_min=nominal.rope_min, rope_max=nominal.rope_max,
    )
    return Perturbed(
        true, rig, nominal, driven, period, Feedforward(inverse, compensation), share * rope
    )


def _move(
    random: np.random.Generator, crane: Crane, rope: float, second: float
) -> FlatInverse:
    """From rest to rest."""
    frequency = np.sqrt(crane.gravity / max(rope, second))
    acceleration = crane.gravity * 10.0 ** random.uniform(-2.0, -1.0, 3)
    distance = rope * random.uniform(0.3, 3.0, 2)
    velocity = np.sqrt(acceleration * max(rope, second)) * random.uniform(0.3, 1.0, 3)
    jerk = acceleration * frequency * random.uniform(0.5, 2.0)
    limits = Limits(velocity, acceleration, jerk, 4.0 * jerk * frequency)
    ends = Waypoint([0.0, 0.0, -rope]), Waypoint([*distance, -second])
    return FlatInverse(crane, plan(ends, limits))


def _drives(
    random: np.random.Generator, crane: Crane, inverse: FlatInverse, driven: bool, late: float
) -> tuple[Drive, Drive, Drive]:
    """Drives that can do what the plan needs, and some more."""
    times = np.linspace(0.0, inverse.trajectory.duration, 2001)
    room = random.uniform(1.2, 4.0)
    lag = 0.0 if random.random() < 0.3 else float(random.uniform(0.0, 0.5))
    if not driven:
        most = np.abs(inverse.force(times)).max(axis=0)
        # half more than the planned load, and friction
        most = 1.5 * room * most + 0.03 * crane.gravity * _moved(crane)
        bridge, trolley, hoist = (Drive(force_max=float(f), dead_time=late) for f in most)
        return bridge, trolley, hoist
    speed = np.abs(inverse.velocity(times))
    slope = np.abs(np.gradient(inverse.velocity(times), times, axis=0)).max(axis=0)
    slope = np.maximum(room * slope, 0.01 * crane.gravity)
    least = 0.05 * np.sqrt(-crane.gravity * inverse.trajectory(0.0)[2])
    fast = np.maximum(room * speed.max(axis=0), least)
    bridge, trolley, hoist = (
        Drive(lag, acceleration_max=float(a), velocity_max=float(v), dead_time=late)
        for a, v in zip(slope, fast, strict=True)
    )
    return bridge, trolley, hoist


def _friction(random: np.random.Generator, crane: Crane) -> Friction:
    weight = _moved(crane) * crane.gravity
    first, second, third = (weight * random.uniform(0.0, 0.01, 3)).tolist()
    a, b, c = (weight * random.uniform(0.0, 0.01, 3)).tolist()
    return Friction(viscous=(first, second, third), coulomb=(a, b, c))


def _moved(crane: Crane) -> np.ndarray:
    """Masses that the drives move, the load included [kg]."""
    trolley, payload = crane.trolley_mass, crane.payload_mass
    return np.array([crane.bridge_mass + trolley + payload, trolley + payload, payload])


def _sensors(
    random: np.random.Generator, rope: float, period: float, dead: float, offset: float
) -> Sensors:
    place = rope * 10.0 ** random.uniform(-4.3, -3.0)
    angle = 2.0 * np.pi / 2.0 ** random.integers(11, 16)
    steps = np.array([place] * 3 + [angle] * 2)
    noise = random.uniform(0.0, 1.0) * steps * (random.random() < 0.7)
    return Sensors(
        sample_time=period, dead_time=dead, resolution=tuple(steps.tolist()),
        deviation=tuple(noise.tolist()), offset=(0.0, 0.0, offset, 0.0, 0.0),
        seed=int(random.integers(1, 10**6)),
    )

