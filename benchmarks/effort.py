"""Effort and result on the paper's two transitions: the planner, casadi with ipopt, and HiGHS."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import perf_counter_ns
from typing import TypeVar

import numpy as np

from benchmarks.optimal_control import ShootingProblem, Transition, linear_program
from benchmarks.report import Part, Record, Section, Settings
from segfmu import Limits, Waypoint, plan

MISSION = Path(__file__).parents[1] / "models" / "paper.toml"
GRIDS = (40, 80)
Result = TypeVar("Result")
TOLERANCE = 1e-4

# Time-optimal durations of the paper's transitions with snap limits 10 (x) and 5 (y), from linear
# programming bounds on fine grids: certified lower bound and best known [s]
OPTIMA = {
    "x, 1 to 2": (0.8740, 0.8744),
    "x, 2 to 3": (2.6537, 2.6547),
    "y, 1 to 2": (0.9309, 0.9312),
    "y, 2 to 3": (3.0289, 3.0305),
}


def measure(settings: Settings) -> Part:
    """One table for each axis and pair of waypoints."""
    repetitions = max(3, settings.repetitions // 2)
    built = {n: _timed(partial(ShootingProblem, n), 3) for n in GRIDS}
    sections = []
    for transition in transitions():
        lower, best = OPTIMA[transition.name]
        records = [_planned(transition, shape, repetitions) for shape in ("plateau", "smoothstep")]
        for n in GRIDS:
            build, problem = built[n]
            records.append(_shot(transition, n, build, problem, repetitions))
        records += [_programmed(transition, n) for n in GRIDS]
        title = f"{transition.name}: optimum between {lower} and {best} s"
        sections.append(Section(title, [_judged(record, lower) for record in records]))
    return Part(
        "Effort on the paper's transitions, n = 4, snap bounded",
        sections,
        (
            "N: grid intervals of constant snap; velocity and acceleration bounded at the nodes "
            "only, so that a duration can lie below the optimum",
            "build: waypoints and limits, or the nonlinear program, which serves all transitions",
            "HiGHS: bisection on the duration to a relative 1e-4, all linear programs together",
            f"times: median of {repetitions}, 3 for building",
        ),
    )


def transitions() -> list[Transition]:
    mission = tomllib.loads(MISSION.read_text(encoding="utf-8"))
    return [
        Transition(
            f"{name}, {j + 1} to {j + 2}",
            _state(mission["waypoints"][j], axis),
            _state(mission["waypoints"][j + 1], axis),
            (limits["velocity"], limits["acceleration"], limits["jerk"], limits["snap"]),
        )
        for axis, name in enumerate("xy")
        for limits in (mission["limits"][name],)
        for j in (0, 1)
    ]


def _state(waypoint: dict[str, list[float]], axis: int) -> tuple[float, float, float]:
    """Position, velocity and acceleration of one axis; at rest where the file has none."""
    rest = [0.0] * len(waypoint["position"])
    return (
        waypoint["position"][axis],
        waypoint.get("velocity", rest)[axis],
        waypoint.get("acceleration", rest)[axis],
    )


def _planned(transition: Transition, shape: str, repetitions: int) -> Record:
    build, (points, limits) = _timed(
        lambda: (
            [Waypoint(*transition.start), Waypoint(*transition.end)], Limits(*transition.limits)
        ),
        20 * repetitions,
    )
    time, found = _timed(lambda: plan(points, limits, shape=shape), 20 * repetitions)
    return {"method": f"segfmu, {shape}", "build ms": build, "solve ms": time,
            "duration s": found.duration}


def _shot(
    transition: Transition, n: int, build: float, problem: ShootingProblem, repetitions: int
) -> Record:
    time, found = _timed(lambda: problem.solve(transition), repetitions)
    return {"method": f"casadi + ipopt, N = {n}", "build ms": build, "solve ms": time,
            "duration s": found}


def _programmed(transition: Transition, n: int) -> Record:
    time, (duration, programs) = _timed(lambda: linear_program(transition, n, TOLERANCE), 1)
    return {"method": f"HiGHS, N = {n}, {programs} programs", "build ms": None, "solve ms": time,
            "duration s": duration}


def _judged(record: Record, lower: float) -> Record:
    duration = record["duration s"]
    over = None if duration is None else float(duration) / lower
    return {**record, "over lower bound": over}


def _timed(call: Callable[[], Result], repetitions: int) -> tuple[float, Result]:
    """Median time [ms] and the last result."""
    times = []
    for _ in range(repetitions):
        begun = perf_counter_ns()
        found = call()
        times.append((perf_counter_ns() - begun) * 1e-6)
    return float(np.median(times)), found
