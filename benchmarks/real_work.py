"""Durations of plans of every kind of work, by the kernels that this process has.

`python -m benchmarks.real_work COUNT FILE` writes them as JSON.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import numpy as np

from benchmarks.completeness import constructed, random_problem
from benchmarks.drive_problems import DriveProblem, drive_problems
from benchmarks.free_missions import missions
from benchmarks.replanning import random_plan
from benchmarks.smooth_motions import SLACK, boundary, smooth_motion
from segfmu import (
    InfeasibleError,
    Limits,
    Trajectory,
    Waypoint,
    plan,
    plan_actuated,
    reach_velocity,
    replan,
    stop,
)

SEED = 46
SMOOTHNESS = range(3, 7)
AXES = 3
# a call that plans
Call = Callable[[], Trajectory]
BOUNDARY = ("rest", "moving", "short", "braked")


def boundary_problems(kind: str, shape: str, n: int, count: int) -> Iterator[Call]:
    """One axis between two states."""
    random = np.random.default_rng((SEED, n, len(kind)))
    for _ in range(count):
        limits, (v, a, w, b, y) = random_problem(random, n, kind)
        points = [Waypoint(0.0, v, a), Waypoint(y, w, b)]
        yield partial(plan, points, Limits(*limits[:n]), smoothness=n, shape=shape)


def paths(n: int, count: int) -> Iterator[Call]:
    """Three axes that meet in four waypoints, the inner ones moving."""
    random = np.random.default_rng((SEED, n))
    for _ in range(count // 4):
        limits = 10.0 ** random.uniform(-0.3, 0.7, (n, AXES))
        places = random.normal(size=(4, AXES)) * limits[0]
        inner = 0.5 * random.uniform(-1.0, 1.0, (2, 2, AXES)) * limits[:2]
        points = [Waypoint(places[0]), *(
            Waypoint(p, *s) for p, s in zip(places[1:3], inner, strict=True)
        ), Waypoint(places[3])]
        yield partial(plan, points, Limits(*limits), smoothness=n)


def motions(shape: str, n: int, count: int) -> Iterator[Call]:
    """Between the states of a motion by ramps, which keeps the limits."""
    random = np.random.default_rng((SEED, n, 1))
    for _ in range(count):
        motion = constructed(random, n, 0.3)
        if motion is not None:
            v, a, w, b, y = motion.state
            points = [Waypoint(0.0, v, a), Waypoint(y, w, b)]
            yield partial(plan, points, Limits(*motion.limits[:n]), smoothness=n, shape=shape)


def recordings(n: int, count: int) -> Iterator[Call]:
    """Five states of a polynomial, as from a recording."""
    random = np.random.default_rng((SEED, n, 2))
    for _ in range(count // 4):
        motion = smooth_motion(random, n)
        _, limits = boundary(motion, n, 0.7)
        rates = [np.polynomial.polynomial.polyder(motion, k) for k in range(3)]
        points = [
            Waypoint(*(float(np.polynomial.polynomial.polyval(t, c)) for c in rates))
            for t in np.linspace(0.0, 1.0, 5)
        ]
        yield partial(plan, points, limits, smoothness=n)


def durations_asked(n: int, count: int) -> Iterator[Call]:
    """The duration of a polynomial that keeps the limits, and a longer one."""
    random = np.random.default_rng((SEED, n, 3))
    for _ in range(count // 2):
        points, limits = boundary(smooth_motion(random, n), n, SLACK)
        for duration in (1.0, 1.0 + random.uniform()):
            yield partial(plan, points, limits, smoothness=n, duration=duration)


def replans(n: int, count: int) -> Iterator[Call]:
    """To another target, within a motion."""
    random = np.random.default_rng((SEED, n, 4))
    for _ in range(count // 2):
        old = random_plan(random, n)
        t = random.uniform(0.0, old.duration)
        target = Waypoint(old.waypoints[-1].position + random.normal())
        yield partial(replan, old, t, target)


def stops(n: int, count: int) -> Iterator[Call]:
    """To rest and to another velocity, within a motion."""
    random = np.random.default_rng((SEED, n, 5))
    for _ in range(count // 2):
        old = random_plan(random, n)
        t = random.uniform(0.0, old.duration)
        to = [random.uniform(-1.0, 1.0) * float(old.limits.table(1, n)[0][0])]
        yield partial(stop, old, t)
        yield partial(reach_velocity, old, to, t)


def free_states(n: int, count: int) -> Iterator[Call]:
    """Three axes with free waypoints; n = 4 alone, as others take long."""
    for mission in missions(count // 16 if n == 4 else 0, (4, 6), SEED):
        yield partial(plan, mission.waypoints("free", "free"), mission.bounds)


def drives(n: int, count: int) -> Iterator[Call]:
    """Within the drives of a crane."""
    for problem in drive_problems(count // 32 if n == 4 else 0, SEED):
        yield partial(within_drives, problem)


def within_drives(problem: DriveProblem) -> Trajectory:
    """The plan of a problem."""
    return plan_actuated(
        problem.crane, problem.waypoints, problem.limits, problem.bounds
    ).trajectory


WORK: dict[str, Callable[[int, int], Iterator[Call]]] = {
    **{kind: partial(boundary_problems, kind, "plateau") for kind in BOUNDARY},
    **{f"{kind}, smoothstep": partial(boundary_problems, kind, "smoothstep") for kind in BOUNDARY},
    "paths": paths, "motions by ramps": partial(motions, "plateau"),
    "motions by ramps, smoothstep": partial(motions, "smoothstep"), "recorded states": recordings,
    "durations asked": durations_asked, "replans": replans, "stops": stops,
    "free states": free_states, "drives": drives,
}


def duration(call: Call) -> float | None:
    """Duration [s]; None where it is refused."""
    try:
        return call().duration
    except InfeasibleError:
        return None


def main() -> None:
    """Durations by kind of work and smoothness."""
    found = {
        kind: {n: [duration(call) for call in calls(n, int(sys.argv[1]))] for n in SMOOTHNESS}
        for kind, calls in WORK.items()
    }
    Path(sys.argv[2]).write_text(json.dumps(found), encoding="utf-8")


if __name__ == "__main__":
    main()
