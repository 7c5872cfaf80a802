"""Cranes under random commands, and what their loads need, found without the kernels."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from segfmu import ActuatorBounds, Clearance, Crane, Limits, Obstacle, Operator

MODES = ("velocity", "velocity", "velocity", "stop", "target", "inching", "mission")


@dataclass(frozen=True)
class Site:
    """A crane in its space; step: between commands [s]."""

    crane: Crane
    limits: Limits
    start: tuple[float, float, float]
    bounds: ActuatorBounds
    clearance: Clearance
    step: float

    def operator(self, **options: Any) -> Operator:
        known = {"bounds": self.bounds, "clearance": self.clearance} | options
        return Operator(self.crane, self.limits, self.start, **known)


LAB = Site(
    Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0, rope_min=0.2, rope_max=0.9),
    Limits(velocity=[0.4, 0.4, 0.3], acceleration=0.5, jerk=1.5, snap=10.0),
    (0.0, 0.0, -0.45),
    ActuatorBounds(
        force=[6.0, 4.0, 14.0], velocity=0.6, acceleration=[0.9, 0.9, 0.7], sway_angle=0.2
    ),
    Clearance(
        [Obstacle("box", [0.2, -0.3, -0.9], [0.5, 0.3, -0.5], 0.02)],
        minimum=[-1.0, -1.0, -0.9], maximum=[1.0, 1.0, -0.2],
    ),
    0.02,
)
PORT = Site(
    Crane(bridge_mass=800e3, trolley_mass=30e3, payload_mass=40e3, rope_min=4.0, rope_max=45.0),
    Limits(
        velocity=[0.75, 3.0, 1.5], acceleration=[0.1, 0.3, 0.4], jerk=[0.1, 0.2, 0.5],
        snap=[0.2, 0.3, 1.0],
    ),
    (0.0, 0.0, -15.0),
    ActuatorBounds(velocity=[1.0, 4.0, 2.0], acceleration=[0.3, 0.8, 0.8],
                   force=[400e3, 80e3, 480e3]),
    Clearance(
        [Obstacle("stack", [-10.0, 20.0, -40.0], [10.0, 30.0, -20.0], 0.5)],
        minimum=[-20.0, -5.0, -40.0], maximum=[20.0, 50.0, -6.0],
        load_size=[12.0, 2.4, 2.6], load_centre=[0.0, 0.0, -1.3],
    ),
    0.1,
)
SITES = {"lab": LAB, "port": PORT}


def parameters(site: Site) -> dict[str, Any]:
    """Of GantryFeedforward with commands, behind a load that rests."""
    crane, low, high = site.crane, site.clearance.minimum, site.clearance.maximum
    values: dict[str, Any] = dict(crane.values()) | {
        "waypoint.count": 2, "command.enabled": True, "obstacle.count": 1, "obstacle[1].margin":
        site.clearance.obstacles[0].margin, "planner.start_time": 0.0,
    }
    table = site.limits.table(3, 4)
    box = site.clearance.obstacles[0]
    for k, a in enumerate("xyz"):
        names = ("velocity", "acceleration", "jerk", "snap")
        values |= {f"limits.{a}.{n}": v for n, v in zip(names, table[k].tolist(), strict=False)}
        values |= {f"workspace.{a}.min": low[k], f"workspace.{a}.max": high[k],
                   f"load.size.{a}": site.clearance.load_size[k],
                   f"load.centre.{a}": site.clearance.load_centre[k],
                   f"obstacle[1].minimum.{a}": box.minimum[k],
                   f"obstacle[1].maximum.{a}": box.maximum[k]}
        for i in (1, 2):
            values[f"waypoint[{i}].position.{a}"] = site.start[k]
            values |= {f"waypoint[{i}].{n}.{a}": 0.0 for n in ("velocity", "acceleration")}
    for k, d in enumerate(("bridge", "trolley", "hoist")):
        for n in ("force", "velocity", "acceleration"):
            values[f"drive.{d}.{n}_max"] = getattr(site.bounds, n)[k]
    values |= {f"sway.{a}.angle_max": v for a, v in zip("xy", site.bounds.sway_angle, strict=True)}
    return {n: 0.0 if v == np.inf else v for n, v in values.items()}


def commands(site: Site, rng: np.random.Generator, steps: int) -> Iterator[dict[str, Any]]:
    """A command for each step, often the one before."""
    low, high = site.clearance.minimum, site.clearance.maximum
    most = 1.2 * np.asarray(site.limits.velocity)
    command: dict[str, Any] = {}
    left = 0
    for _ in range(steps):
        if left == 0:
            left = int(rng.integers(1, 40))
            command = {
                "mode": str(rng.choice(MODES)),
                "velocity": rng.uniform(-most, most) * rng.integers(0, 2, 3),
                "target": rng.uniform(1.05 * low - 0.05 * high, 1.05 * high - 0.05 * low),
                "distance": 0.05 * site.step, "scale": float(rng.choice([1.0, 1.0, 0.5, 0.1, 0.0])),
            }
        left -= 1
        yield command


def needs(crane: Crane, places: np.ndarray, step: float) -> dict[str, np.ndarray]:
    """What a path of the load (samples, 3) needs, by Newton's laws and finite differences.

    Of the samples but for two at both ends: forces, velocities and accelerations of the drives
    (samples, 3), and both sway angles (samples, 2).
    """
    def second(values: np.ndarray) -> np.ndarray:
        return np.asarray((values[2:] - 2.0 * values[1:-1] + values[:-2]) / step**2)

    acceleration = second(places)
    pull = acceleration + np.array([0.0, 0.0, crane.gravity])
    inner = places[1:-1]
    # the rope points along the force on the load, from the trolley at height 0
    carriage = inner[:, :2] - inner[:, 2:] * pull[:, :2] / pull[:, 2:]
    rope = np.linalg.norm(np.column_stack([carriage - inner[:, :2], -inner[:, 2]]), axis=1)
    drives = np.column_stack([carriage, rope])
    moved = second(drives)
    load = crane.payload_mass * pull[1:-1]
    mass = np.array([crane.bridge_mass + crane.trolley_mass, crane.trolley_mass])
    forces = np.column_stack([
        mass * moved[:, :2] + load[:, :2], -np.linalg.norm(load, axis=1)
    ])
    across = np.arctan2(-pull[:, 0], np.hypot(pull[:, 1], pull[:, 2]))
    along = np.arctan2(pull[:, 1], pull[:, 2])
    return {
        "force": forces, "velocity": (drives[2:] - drives[:-2]) / (2.0 * step),
        "acceleration": moved, "sway_angle": np.column_stack([across, along])[1:-1],
        "carriage": carriage[1:-1], "rope": rope[1:-1],
    }


def met(site: Site, places: np.ndarray, carriage: np.ndarray) -> np.ndarray:
    """How deep load or rope are in an obstacle at samples [m], 0: not at all."""
    deepest = np.zeros(len(places))
    size, centre = site.clearance.load_size, site.clearance.load_centre
    for box in site.clearance.obstacles:
        low, high = box.minimum - box.margin, box.maximum + box.margin
        load = np.minimum(
            places + centre + 0.5 * size - low, high - (places + centre - 0.5 * size)
        ).min(axis=1)
        deepest = np.maximum(deepest, load)
        top = np.column_stack([carriage, np.zeros(len(carriage))])
        for share in np.linspace(0.0, 1.0, 41):
            point = top + share * (places - top)
            deepest = np.maximum(deepest, np.minimum(point - low, high - point).min(axis=1))
    return deepest
