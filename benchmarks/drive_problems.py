"""Random cranes of any size, with bounds of their drives and missions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from segfmu import ActuatorBounds, Crane, Limits, Waypoint

SEED = 12


@dataclass(frozen=True, eq=False)
class DriveProblem:
    """A crane, its bounds, limits of the load or None, and waypoints."""

    crane: Crane
    bounds: ActuatorBounds
    limits: Limits | None
    waypoints: tuple[Waypoint, ...]


def drive_problems(
    count: int, seed: int = SEED, *, directed: bool = False
) -> Iterator[DriveProblem]:
    """Cranes from 1 kg to 100 t; bounds known in part; waypoints that rest, move or are free.

    directed: known bounds differ by direction, by a factor of up to three.
    """
    random = np.random.default_rng(seed)
    for _ in range(count):
        problem = _problem(random)
        yield replace(problem, bounds=_directed(random, problem)) if directed else problem


def _directed(random: np.random.Generator, problem: DriveProblem) -> ActuatorBounds:
    bounds = problem.bounds
    factors = -(3.0 ** random.uniform(-1.0, 1.0, (3, 3)))
    # the hoist still has to hold the load
    factors[0, 2] = min(factors[0, 2], -1.0)
    names = ("force", "velocity", "acceleration")
    own = {name: getattr(bounds, name) for name in (*names, "power", "sway_angle")}
    least = {f"{n}_min": f * own[n] for n, f in zip(names, factors, strict=True)}
    return ActuatorBounds(**own, **least)


def _problem(random: np.random.Generator) -> DriveProblem:
    size = random.uniform()
    payload = 10.0 ** (5.0 * size)
    masses = payload * 10.0 ** random.uniform([-0.3, -0.5], [1.0, 0.5])
    rope = 0.5 * 60.0**size * random.uniform(0.5, 1.5)
    crane = Crane(masses[0], masses[1], payload)
    speed = 0.5 * 8.0**size * random.uniform(0.3, 2.0, 3) * np.array([1.0, 1.0, 0.4])
    rise = random.uniform(0.1, 1.5, 3)
    moved = np.array([masses.sum() + payload, masses[1] + payload, payload])
    weight = np.array([0.0, 0.0, payload * crane.gravity])
    force = moved * rise * random.uniform(0.5, 2.0, 3) + weight
    known = random.random((4, 3)) < 0.6
    # something must bound each acceleration
    known[2] |= ~known[0]
    bounds = ActuatorBounds(
        force=np.where(known[0], force, np.inf), velocity=np.where(known[1], speed, np.inf),
        acceleration=np.where(known[2], rise, np.inf),
        power=np.where(known[3], force * speed * random.uniform(0.4, 1.5, 3), np.inf),
        sway_angle=random.uniform(0.02, 0.3) if random.random() < 0.3 else None,
    )
    limits = None
    if random.random() < 0.5:
        c = [4.0 * speed, 4.0 * rise, 20.0 * rise**2 / speed, 200.0 * rise**3 / speed**2]
        limits = Limits(*(values * 10.0 ** random.uniform(-0.5, 1.0, 3) for values in c))
    return DriveProblem(crane, bounds, limits, _waypoints(random, rope, speed, rise))


def _waypoints(
    random: np.random.Generator, rope: float, speed: np.ndarray, rise: np.ndarray
) -> tuple[Waypoint, ...]:
    reach = rope * random.uniform(0.3, 4.0)
    count = int(random.integers(2, 5))
    places = random.random((count, 3)) * [reach, reach, -0.6 * rope] - [0.0, 0.0, 0.4 * rope]
    along = np.sort(places[:, :2], axis=0)
    places[:, :2] = np.where(random.random(2) < 0.25, places[:1, :2], along)
    kind = random.choice(["rest", "moving", "free"])
    points = []
    for i, place in enumerate(places):
        if 0 < i < count - 1 and kind == "free":
            points.append(Waypoint(place, "free", "free"))
        elif 0 < i < count - 1 and kind == "moving":
            # what the bounds and half of a stretch allow
            room = np.minimum(np.abs(place - places[i - 1]), np.abs(places[i + 1] - place))
            most = np.minimum(0.3 * speed, 0.3 * (rise * room) ** 0.5)
            way = np.sign(places[i + 1] - place) * [1.0, 1.0, 0.0]
            points.append(Waypoint(place, random.uniform(0.0, 1.0) * most * way))
        else:
            points.append(Waypoint(place))
    return tuple(points)
