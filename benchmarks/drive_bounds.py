"""Plans within the bounds of a crane's drives: how short, and whether all bounds are kept."""

from __future__ import annotations

from dataclasses import replace
from time import perf_counter

import numpy as np

from benchmarks.drive_oracle import largest_use, shortest_transfer
from benchmarks.drive_problems import DriveProblem, drive_problems
from benchmarks.report import Part, Record, Section, Settings
from segfmu import (
    ActuatorBounds,
    Crane,
    InfeasibleError,
    Limits,
    Trajectory,
    Waypoint,
    plan,
    plan_actuated,
)

SHIP_TO_SHORE = Crane(300e3, 15e3, 40e3)
DISTANCE, ROPE, VELOCITY, ACCELERATION = 45.0, 30.0, 4.0, 0.8
# the load is lifted to 18 m of rope before a stack from 8 to 37 m, and lowered behind it
STACK = (
    Waypoint([0.0, 0.0, -ROPE]), Waypoint([0.0, 8.0, -18.0], "free", "free"),
    Waypoint([0.0, 37.0, -18.0], "free", "free"), Waypoint([0.0, DISTANCE, -ROPE]),
)
WEIGHT = SHIP_TO_SHORE.payload_mass * SHIP_TO_SHORE.gravity
HOIST_SPEED = 1.5
CONTAINER = ActuatorBounds(
    velocity=[None, VELOCITY, HOIST_SPEED], acceleration=[None, ACCELERATION, 0.75],
    force=[None, None, 1.2 * WEIGHT], power=[None, None, HOIST_SPEED * WEIGHT],
)
SHAPES = ("plateau", "smoothstep")
RANDOM = 200
SAMPLES = 20_001
TOLERANCE = 1e-9


def measure(settings: Settings) -> Part:
    """Transfer against linear programs, container mission, random cranes."""
    quick = settings.samples <= 100
    return Part(
        "Plans within the drives",
        (Section("45 m at 30 m of rope, trolley 4 m/s and 0.8 m/s2", _transfer(quick)),
         Section("45 m over a stack, hoist 1.5 m/s, 0.75 m/s2, 1.2 x and power of the load",
                 _container()),
         Section("random cranes, 1 kg to 100 t", [_random(20 if quick else RANDOM)])),
        (
            "linear program: HiGHS, the carriage's acceleration constant in each interval, no "
            "smoothness; trapezoid with ZV: 45 / 4 + 4 / 0.8 s and half the pendulum's period",
            "use: largest share of a bound among samples, by Taylor series in NumPy",
            "limits exist: a scan over scaled limits finds a plan that keeps the bounds",
        ),
    )


def _transfer(quick: bool) -> list[Record]:
    optimum = shortest_transfer(
        DISTANCE, ROPE, SHIP_TO_SHORE.gravity, VELOCITY, ACCELERATION, 200 if quick else 500, 1e-4
    )
    half_period = np.pi * (ROPE / SHIP_TO_SHORE.gravity) ** 0.5
    shaped = DISTANCE / VELOCITY + VELOCITY / ACCELERATION + half_period
    rows = [_row("linear program", optimum, optimum), _row("trapezoid, ZV", shaped, optimum)]
    points = (Waypoint([0.0, 0.0, -ROPE]), Waypoint([0.0, DISTANCE, -ROPE]))
    bounds = ActuatorBounds(
        velocity=[None, VELOCITY, None], acceleration=[None, ACCELERATION, None]
    )
    for shape in SHAPES:
        found = plan_actuated(SHIP_TO_SHORE, points, None, bounds, shape=shape).trajectory
        rows.append(_row(shape, found.duration, optimum, found, bounds))
    return rows


def _row(
    name: str, duration: float, optimum: float, found: Trajectory | None = None,
    bounds: ActuatorBounds | None = None,
) -> Record:
    used = None
    if found is not None and bounds is not None:
        used = largest_use(SHIP_TO_SHORE, found, bounds, SAMPLES)
    return {
        "plan": name, "duration s": float(duration), "over optimum": float(duration / optimum),
        "use": used,
    }


def _container() -> list[Record]:
    rows: list[Record] = []
    for shape in SHAPES:
        begin = perf_counter()
        found = plan_actuated(SHIP_TO_SHORE, STACK, None, CONTAINER, shape=shape)
        used = largest_use(SHIP_TO_SHORE, found.trajectory, CONTAINER, SAMPLES)
        rows.append({
            "plan": shape, "duration s": found.trajectory.duration, "use": used,
            "active": ", ".join(use.name for use in found.active),
            "planned in s": perf_counter() - begin,
        })
    return rows


def _random(count: int) -> Record:
    exceeded = refused = missed = 0
    times = []
    for problem in drive_problems(count):
        begin = perf_counter()
        try:
            found = plan_actuated(
                problem.crane, problem.waypoints, problem.limits, problem.bounds
            ).trajectory
        except InfeasibleError:
            refused += 1
            missed += feasible(problem)
            continue
        times.append(perf_counter() - begin)
        used = largest_use(problem.crane, found, problem.bounds, SAMPLES)
        exceeded += used > 1.0 + TOLERANCE
    return {
        "cranes": count, "bounds exceeded": exceeded, "refused": refused,
        "refused although limits exist": missed, "planned in s, median": float(np.median(times)),
        "95 %": float(np.quantile(times, 0.95)), "largest": float(np.max(times)),
    }


def feasible(problem: DriveProblem) -> bool:
    """Whether a scan over scaled limits finds a plan that keeps the bounds."""
    rest = replace(problem, waypoints=tuple(
        Waypoint(
            p.position, np.nan_to_num(p.velocity), np.nan_to_num(p.acceleration), dwell=p.dwell
        )
        for p in problem.waypoints
    ))
    states = np.array([[p.velocity, p.acceleration] for p in rest.waypoints])
    caps = np.full((4, 3), np.inf)
    if problem.limits is not None:
        given = problem.limits.table(3, 4).T[:4]
        caps = np.where(given > 0.0, given, np.inf)
    least = np.abs(states).max(axis=0)
    span = np.ptp([p.position for p in rest.waypoints], axis=0).max()
    for time in span * 10.0 ** np.linspace(-1.0, 2.0, 16):
        for sharpness in (3.0, 10.0, 30.0, 100.0):
            velocity = np.maximum(span / time, least[0] * 1.001)
            acceleration = np.maximum(3.0 * velocity / time, least[1] * 1.001)
            table = np.array([
                velocity, acceleration, sharpness * acceleration / time,
                sharpness**2 * acceleration / time**2,
            ])
            try:
                found = plan(rest.waypoints, Limits(*np.minimum(table, caps)))
            except InfeasibleError:
                continue
            if largest_use(problem.crane, found, problem.bounds, 2001) <= 1.0:
                return True
    return False
