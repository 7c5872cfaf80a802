"""Plans within the drives of cranes with friction: whether they keep the bounds, and how short."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from benchmarks.best_limits import GENERATIONS, shortest_over_limits
from benchmarks.drive_oracle import largest_use
from benchmarks.drive_problems import drive_problems
from benchmarks.friction_program import Transfer, shortest_time
from benchmarks.report import Part, Record, Section, Settings
from segfmu import ActuatorBounds, Crane, InfeasibleError, Waypoint, plan_actuated
from segfmu.crane import Friction

LAB, SHIP_TO_SHORE = Crane(2.2, 1.155, 1.0), Crane(300e3, 15e3, 40e3)
SHAPES = ("plateau", "smoothstep")
SAMPLES = 40_001
RANDOM = 100
TOLERANCE = 1e-4


@dataclass(frozen=True)
class Case:
    """A transfer along one axis with one drive's bounds and friction."""

    name: str
    crane: Crane
    axis: int
    distance: float
    rope: float
    force: float
    velocity: float
    coulomb: float
    viscous: float


CASES = (
    Case("lab, bridge, 1 m/s", LAB, 0, 1.0, 0.5, 6.0, 1.0, 4.0, 0.0),
    Case("lab, bridge, 0.3 m/s", LAB, 0, 1.0, 0.5, 6.0, 0.3, 4.0, 0.0),
    Case("lab, bridge, viscous", LAB, 0, 1.0, 0.5, 6.0, 0.3, 3.0, 3.0),
    Case("lab, trolley, 0.3 m/s", LAB, 1, 0.8, 0.5, 6.0, 0.3, 4.0, 0.0),
    Case("40 t, trolley, 4 m/s", SHIP_TO_SHORE, 1, 45.0, 30.0, 60e3, 4.0, 5.4e3, 0.0),
    Case("40 t, bridge, 1 m/s", SHIP_TO_SHORE, 0, 20.0, 30.0, 100e3, 1.0, 34e3, 0.0),
)


def measure(settings: Settings) -> Part:
    """Transfers over linear programs, random cranes."""
    quick = settings.samples <= 100
    cases = CASES[1:2] if quick else CASES
    return Part(
        "Plans within the drives of cranes with friction",
        (Section("from rest to rest along one axis", [_transfer(c, quick) for c in cases]),
         Section("random cranes, 1 kg to 100 t", [_random(10 if quick else RANDOM)])),
        (
            "linear program: HiGHS, force linear in each of 200 cells, no smoothness; the carriage "
            "does not turn, so friction is linear; without friction: the same for a crane that has "
            "none",
            "best of its limits: the shortest plan of the method over all limits, by differential "
            "evolution",
            "use: largest share of a bound among samples, by Taylor series in NumPy, with contacts "
            "followed from sample to sample",
        ),
    )


def _transfer(case: Case, quick: bool) -> Record:
    rows: Record = {"transfer": case.name}
    cells = 60 if quick else 200
    for name, share in (("", 1.0), (", no friction", 0.0)):
        coulomb, viscous = share * case.coulomb, share * case.viscous
        moved = case.crane.trolley_mass + (case.crane.bridge_mass if case.axis == 0 else 0.0)
        optimum = shortest_time(
            Transfer(
                moved, case.crane.payload_mass, case.rope, case.crane.gravity, case.distance,
                case.force, case.velocity, coulomb, viscous,
            ),
            cells, TOLERANCE,
        )
        durations, used = zip(*(_plan(case, s, coulomb, viscous) for s in SHAPES), strict=True)
        if share:
            rows |= {"optimum s": optimum, "use": max(used)}
            rows |= {
                f"{s} over best of its limits": d / _best(case, s, d, quick)
                for s, d in zip(SHAPES, durations, strict=True)
            }
        rows |= {f"{s} over it{name}": d / optimum for s, d in zip(SHAPES, durations, strict=True)}
    return rows


def _plan(case: Case, shape: str, coulomb: float, viscous: float) -> tuple[float, float]:
    """Duration [s] and largest use of a plan."""
    waypoints, bounds, friction = _task(case, coulomb, viscous)
    found = plan_actuated(
        case.crane, waypoints, None, bounds, shape=shape, friction=friction
    ).trajectory
    return found.duration, largest_use(case.crane, found, bounds, SAMPLES, friction)


def _best(case: Case, shape: str, duration: float, quick: bool) -> float:
    """Duration [s] of the shortest plan over all limits, beside that of ours."""
    waypoints, bounds, friction = _task(case, case.coulomb, case.viscous)
    return shortest_over_limits(
        case.crane, waypoints, case.axis, bounds, friction, shape, duration,
        5 if quick else GENERATIONS,
    )


def _task(
    case: Case, coulomb: float, viscous: float
) -> tuple[list[Waypoint], ActuatorBounds, Friction]:
    start = np.array([0.0, 0.0, -case.rope])
    here = np.arange(3) == case.axis
    bounds = ActuatorBounds(
        force=np.where(here, case.force, np.inf), velocity=np.where(here, case.velocity, np.inf)
    )
    friction = Friction(tuple(viscous * here), tuple(coulomb * here))
    return [Waypoint(start), Waypoint(start + case.distance * here)], bounds, friction


def _random(count: int) -> Record:
    """Random cranes and missions, with friction of up to half of what each drive has to spare."""
    random = np.random.default_rng(7)
    exceeded = refused = 0
    largest = 0.0
    for problem in drive_problems(count):
        crane, bounds = problem.crane, problem.bounds
        weights = crane.gravity * np.cumsum(
            [crane.payload_mass, crane.trolley_mass, crane.bridge_mass]
        )[::-1]
        spare = bounds.force - np.array([0.0, 0.0, crane.payload_mass * crane.gravity])
        dry = np.minimum(random.uniform(0.0, 0.02, 3) * weights, 0.5 * spare)
        dry = np.maximum(dry, 0.0)
        viscous = random.uniform(0.0, 0.5, 3) * dry
        friction = Friction(
            tuple(viscous), tuple(dry), static=tuple(dry * random.uniform(1.0, 1.3, 3))
        )
        try:
            found = plan_actuated(
                crane, problem.waypoints, problem.limits, bounds, friction=friction
            ).trajectory
        except InfeasibleError:
            refused += 1
            continue
        used = largest_use(crane, found, bounds, SAMPLES, friction)
        largest = max(largest, used)
        exceeded += used > 1.0 + TOLERANCE
    return {
        "cranes": count, "refused": refused, "bounds exceeded": exceeded, "largest use": largest,
    }
