"""Random problems of every kind, and the same ones written in another way.

A problem is a dictionary that JSON can hold: kind, smoothness, shape, limits (a row an order),
points of position, velocity and acceleration; `drives` are the crane and the bounds of its drives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import sqrt
from typing import Any

import numpy as np
from benchmarks.drive_problems import drive_problems
from benchmarks.free_missions import missions

from tests.property.plan_durations import random_problems, several_axes

Problem = dict[str, Any]
FREE = "free"
# of all problems: with free states, and within drives, whose searches plan a thousand times
FREE_SHARE, DRIVE_SHARE = 0.05, 0.004
BOUNDS = ("force", "velocity", "acceleration", "power", "sway_angle")
# powers of length and time in the units of these bounds and of the first derivatives
UNITS = {"force": (1, -2), "velocity": (1, -1), "acceleration": (1, -2), "power": (2, -3),
         "sway_angle": (0, 0)}


def problems(count: int) -> list[Problem]:
    """About `count` problems, n = 2 to 6, at rest and moving, one to three axes."""
    single = random_problems(max(1, round(0.7 * count / 35)))
    several = several_axes(max(1, round(0.25 * count)))
    free = free_problems(max(6, round(FREE_SHARE * count)))
    return single + several + free + within_drives(max(2, round(DRIVE_SHARE * count)))


def free_problems(count: int) -> list[Problem]:
    """Missions with free states; of one axis where smoothness is above 4."""
    found = []
    for i, mission in enumerate(missions(count, (3, 4), 5)):
        n = (2, 3, 4, 4, 5, 6)[i % 6]
        axes = 3 if n <= 4 else 1
        limits = mission.limits[:axes, : max(n, 3)].T
        while len(limits) < n:
            limits = np.vstack([limits, 10.0 * limits[-1]])
        places = mission.positions[:, :axes].tolist()
        points = [[p, FREE, FREE] for p in places]
        points[0], points[-1] = ([p, [0.0] * axes, [0.0] * axes] for p in (places[0], places[-1]))
        found.append({
            "kind": "free states", "n": n, "shape": ("plateau", "smoothstep")[i % 4 == 3 and n > 2],
            "limits": limits.tolist(), "points": points,
        })
    return found


def within_drives(count: int) -> list[Problem]:
    """Plans within the drives of random cranes, from 1 kg to 100 t."""
    found = []
    for problem in drive_problems(count, seed=43):
        crane, limits = problem.crane, problem.limits
        found.append({
            "kind": "drives", "n": 4, "shape": "plateau",
            "limits": None if limits is None else limits.table(3, 4).T.tolist(),
            "points": [
                [p.position.tolist(), *(_given(values) for values in (p.velocity, p.acceleration))]
                for p in problem.waypoints
            ],
            "drives": {
                "masses": [crane.bridge_mass, crane.trolley_mass, crane.payload_mass],
                **{name: getattr(problem.bounds, name).tolist() for name in BOUNDS},
            },
        })
    return found


def _given(values: np.ndarray) -> list[float] | str:
    return FREE if np.isnan(values).any() else values.tolist()


def _moved(problem: Problem, change: Callable[[int, np.ndarray], np.ndarray]) -> list[list[Any]]:
    """Points whose derivatives of an order are changed."""
    return [
        [values if values == FREE else change(order, np.asarray(values)).tolist()
         for order, values in enumerate(point)]
        for point in problem["points"]
    ]


def _level(problem: Problem) -> np.ndarray | float:
    """1 for axes without gravity."""
    return np.array([1.0, 1.0, 0.0]) if "drives" in problem else 1.0


def shifted(problem: Problem) -> Problem:
    """Somewhere else, by about the size of the motion."""
    places = np.array([point[0] for point in problem["points"]])
    by = 0.7 * float(np.abs(places).max()) * _level(problem)
    return problem | {"points": _moved(problem, lambda k, x: x + by if k == 0 else x)}


def mirrored(problem: Problem) -> Problem:
    """All axes in the other direction, except those with gravity."""
    sign = 1.0 - 2.0 * np.asarray(_level(problem))
    return problem | {"points": _moved(problem, lambda k, x: sign * x)}


def reversed_in_time(problem: Problem) -> Problem:
    """From the last point to the first one."""
    moved = _moved(problem, lambda k, x: -x if k == 1 else x)
    return problem | {"points": moved[::-1]}


def scaled(problem: Problem, length: float, time: float) -> Problem:
    """In other units of length and time; with gravity in units that keep it."""
    if "drives" in problem:
        time = sqrt(length) if time == 1.0 else time
        length = time * time
    changed = problem | {
        "points": _moved(problem, lambda k, x: x * length / time**k),
    }
    if problem["limits"] is not None:
        changed["limits"] = [
            (np.asarray(row) * length / time ** (k + 1)).tolist()
            for k, row in enumerate(problem["limits"])
        ]
    if "drives" in problem:
        changed["drives"] = problem["drives"] | {
            name: (np.asarray(problem["drives"][name]) * length**a * time**b).tolist()
            for name, (a, b) in UNITS.items()
        }
    return changed


def rewritten(given: list[Problem]) -> Iterator[tuple[str, list[Problem], np.ndarray]]:
    """Name, the problems written in another way, and their durations over those as given."""
    one = np.ones(len(given))
    yield "shifted", [shifted(p) for p in given], one
    yield "mirrored", [mirrored(p) for p in given], one
    yield "reversed in time", [reversed_in_time(p) for p in given], one
    for factor in (3.0, 0.7):
        gravity = np.array(["drives" in p for p in given])
        yield (
            f"lengths by {factor:g}", [scaled(p, factor, 1.0) for p in given],
            np.where(gravity, sqrt(factor), 1.0),
        )
        yield f"times by {factor:g}", [scaled(p, 1.0, factor) for p in given], factor * one
