"""Logs of random cranes whose parameters are known, in the lab and on the quay.

Drives are told velocities that are sums of two sines each, from rest, at frequencies around that of
the pendulum; or forces of controllers that follow such velocities, as force drives have: forces
that nothing corrects let a load run away, or leave it where its friction holds it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import sqrt
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.keys import DRIVES
from segfmu.validation.files.reading import merged
from segfmu.validation.identification.log import OUTPUTS, Log
from segfmu.validation.identification.model import Model

# masses of bridge, trolley and load [kg], mean length of the rope [m]
SIZES = {"lab": (2.2, 1.155, 1.0, 0.5), "quay": (300e3, 15e3, 40e3, 20.0)}
GRAVITY = 9.81
ROWS, ROWS_OF_PERIOD = 600, 100
# noise: share of the rope's length, rad
LENGTH, ANGLE = 1e-3, 2e-3


@dataclass(frozen=True)
class Synthetic:
    """A log with what is true of its crane.

    Attributes
    ----------
    crane : dict
        What is known before: the crane file to begin with.
    truth : dict of str to float
        True values of the keys that differ from it.
    columns : dict of str to ndarray
        The log.
    """

    crane: dict[str, Any]
    truth: dict[str, float]
    columns: dict[str, FloatArray]

    def crane_without(self, *keys: str) -> dict[str, Any]:
        """The true crane, but for some keys."""
        known = {key: value for key, value in self.truth.items() if key not in keys}
        return merged(self.crane, tables(known))


def synthetic(
    size: str, drive: str, seed: int, *, unseen: bool = False, rows: int = ROWS
) -> Synthetic:
    """A log of a random crane; with `unseen` another one of the same crane."""
    draw = np.random.default_rng([seed, drive == "force"])
    bridge, trolley, load, length = SIZES[size]
    nominal = {
        "bridge_mass": bridge, "trolley_mass": trolley, "payload_mass": load, "drive": drive,
    }
    truth = _truth(size, drive, draw)
    motion = np.random.default_rng([seed, 1 + unseen])
    time = sqrt(length / GRAVITY)
    times = np.arange(rows) * 2.0 * np.pi * time / ROWS_OF_PERIOD
    crane: dict[str, Any] = merged(nominal, tables(truth))
    model = Model(CraneFile.model_validate(crane))
    velocities, places = _motion(times, length, motion)
    start = np.zeros(10)
    start[2], start[3:5] = length, motion.uniform(-0.05, 0.05, 2)
    setpoints = velocities
    if drive == "force":
        setpoints = _forces(model, SIZES[size], times, start, velocities, places)
    empty = np.full((rows, len(OUTPUTS)), np.nan)
    shown = model.run(Log("log", times, setpoints, empty), {}, start)
    deviation = [LENGTH * length] * 3 + [ANGLE] * 2
    shown += motion.normal(size=shown.shape) * deviation
    columns = {"time": times}
    columns |= {f"{drive}.{axis}": setpoints[:, i] for i, axis in enumerate(DRIVES)}
    columns |= {name: shown[:, i] for i, name in enumerate(OUTPUTS)}
    return Synthetic(nominal, truth, columns)


def tables(values: Mapping[str, float]) -> dict[str, Any]:
    """Nested tables from keys with dots."""
    found: dict[str, Any] = {}
    for key, value in values.items():
        *names, last = key.split(".")
        table = found
        for name in names:
            table = table.setdefault(name, {})
        table[last] = value
    return found


def _truth(size: str, drive: str, draw: np.random.Generator) -> dict[str, float]:
    masses = dict(zip(("bridge_mass", "trolley_mass", "payload_mass"), SIZES[size], strict=False))
    *_, load, length = SIZES[size]
    time = sqrt(length / GRAVITY)
    found = {}
    if drive == "force":
        found = {name: mass * draw.uniform(0.9, 1.1) for name, mass in masses.items()}
    for axis in DRIVES:
        found[f"{axis}.dead_time"] = draw.uniform(0.05, 0.15) * time
        if drive == "velocity":
            found[f"{axis}.lag"] = draw.uniform(0.1, 0.3) * time
        else:
            found[f"friction.{axis}.viscous"] = draw.uniform(0.02, 0.1) * load / time
            found[f"friction.{axis}.coulomb"] = draw.uniform(0.01, 0.05) * load * GRAVITY
    found["friction.sway.viscous"] = draw.uniform(0.005, 0.03) * load * length**2 / time
    found["sensors.rope.zero"] = draw.uniform(-0.03, 0.03) * length
    found["sensors.sway_x.zero"], found["sensors.sway_y.zero"] = draw.uniform(-0.5, 0.5, 2)
    return found


def _motion(
    times: FloatArray, length: float, motion: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    """Velocities [m/s] and ways from the start [m] of the drives, shape (rows, 3)."""
    frequency = sqrt(GRAVITY / length)
    rates = frequency * motion.uniform(0.2, 0.7, (2, 3))
    amplitude = 0.15 * length * frequency * np.array([1.0, 1.0, 0.3])
    phases = rates[:, None, :] * times[:, None]
    shape = np.array([1.0, 0.5])[:, None, None]
    velocities: FloatArray = np.add(*(shape * amplitude * np.sin(phases)))
    ways: FloatArray = np.add(*(shape * amplitude * (1.0 - np.cos(phases)) / rates[:, None, :]))
    return velocities, ways


def _forces(
    model: Model, size: tuple[float, ...], times: FloatArray, start: FloatArray,
    velocities: FloatArray, ways: FloatArray,
) -> FloatArray:
    """Forces [N] of controllers of places and velocities, which know nominal masses, (rows, 3)."""
    bridge, trolley, load, length = size
    rate = sqrt(GRAVITY / length)
    masses = np.array([bridge + trolley, trolley, load])
    weight = np.array([0.0, 0.0, load * GRAVITY])
    forces = np.empty_like(velocities)
    forces[0] = -weight
    plant = model.plant(times, forces[0], {}, start)
    for i, step in enumerate(np.diff(times), 1):
        late = start[:3] + ways[i - 1] - plant.state[:3]
        slow = velocities[i - 1] - plant.state[5:8]
        forces[i] = masses * rate * (rate * late + 2.0 * slow) - weight
        plant.follow(np.array([step]), model.records(forces[i : i + 1]))
    return forces
