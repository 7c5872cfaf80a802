"""Limits that differ by direction: against Ruckig, linear programs, and the mirrored problem."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from benchmarks.optimal_control import Transition, earliest
from benchmarks.problems import FloatArray
from benchmarks.report import Part, Record, Section, Settings, installed_version
from segfmu import InfeasibleError, Limits, Waypoint, plan, verify

SEED = 17
EQUAL = 1e-8
MIRRORED = 1e-12
CELLS = 60


@dataclass(frozen=True)
class Directed:
    """Limits c_1 .. c_n, magnitudes of the first two downwards, and v, a, w, b, distance."""

    limits: FloatArray
    lower: FloatArray
    state: FloatArray

    def duration(self, smoothness: int, mirrored: bool = False) -> float:
        """Duration of the plan [s]; inf where it is refused. Every plan is verified."""
        upper, lower, state = self.limits[:2], self.lower, self.state
        if mirrored:
            upper, lower, state = lower, upper, -state
        v, a, w, b, distance = state.tolist()
        limits = Limits(
            *upper.tolist(), *self.limits[2:].tolist(), velocity_min=-lower[0],
            acceleration_min=-lower[1],
        )
        try:
            found = plan(
                [Waypoint(0.0, v, a), Waypoint(distance, w, b)], limits, smoothness=smoothness
            )
        except InfeasibleError:
            return np.inf
        assert verify(found).passed
        return float(found.duration)


def directed(random: np.random.Generator, count: int) -> Directed:
    """A problem of so many limits, states up to them, of which three in ten are zero."""
    limits = 10.0 ** random.uniform(-0.3, 0.7, count)
    lower = 10.0 ** random.uniform(-0.3, 0.7, 2)
    share = random.uniform(-1.0, 1.0, 4)
    share[random.random(4) < 0.3] = 0.0
    bounds = np.where(share < 0.0, np.tile(lower, 2), np.tile(limits[:2], 2))
    distance = 2.0 * random.normal() * max(limits[0], lower[0])
    return Directed(limits, lower, np.array([*(share * bounds), distance]))


def measure(settings: Settings) -> Part:
    """Tables against Ruckig (with the extra `bench`), linear programs and the mirrored problem."""
    sections = [_mirrored(settings.samples), _optima(max(settings.samples // 8, 10))]
    if installed_version("ruckig") is not None:
        sections.insert(0, _against_ruckig(min(settings.problems, 2000)))
    return Part(
        "Limits by direction", tuple(sections),
        (
            "velocity and acceleration have another limit in each direction, up to ten times the "
            "other one",
            f"equal: within {EQUAL:g} s; start passes: full jerk towards zero acceleration passes "
            "the velocity limit, which Ruckig then exceeds",
            f"optimum: linear program over {CELLS} cells, in which the highest derivative jumps",
        ),
    )


def ruckig_duration(problem: Directed) -> float:
    """Duration of Ruckig's motion, limits up to the jerk [s]; inf where it is refused."""
    from ruckig import InputParameter, Ruckig, RuckigError, Trajectory

    v, a, w, b, distance = problem.state.tolist()
    given = InputParameter(1)
    given.current_position, given.target_position = [0.0], [distance]
    given.current_velocity, given.target_velocity = [v], [w]
    given.current_acceleration, given.target_acceleration = [a], [b]
    given.max_velocity, given.max_acceleration, given.max_jerk = (
        [c] for c in problem.limits.tolist()
    )
    given.min_velocity, given.min_acceleration = ([-c] for c in problem.lower.tolist())
    found = Trajectory(1)
    try:
        Ruckig(1).calculate(given, found)
    except RuckigError:
        return np.inf
    return float(found.duration)


def _passes(problem: Directed) -> bool:
    """Whether full jerk towards zero acceleration passes the velocity limit at the start."""
    v, a = problem.state[:2]
    reached = v + a * abs(a) / (2.0 * problem.limits[2])
    return bool(reached > problem.limits[0] or reached < -problem.lower[0])


def _against_ruckig(count: int) -> Section:
    random = np.random.default_rng((SEED, 2))
    outcomes = dict.fromkeys(
        ("equal", "longer", "shorter", "refused by both", "start passes: refused by segfmu",
         "refused by segfmu alone, other reasons", "refused by Ruckig alone"), 0,
    )
    largest = 0.0
    for _ in range(count):
        problem = directed(random, 3)
        ours, theirs = problem.duration(2), ruckig_duration(problem)
        if np.isinf(ours) and np.isinf(theirs):
            outcome = "refused by both"
        elif np.isinf(ours):
            outcome = "start passes: refused by segfmu"
            if not _passes(problem):
                outcome = "refused by segfmu alone, other reasons"
        elif np.isinf(theirs):
            outcome = "refused by Ruckig alone"
        else:
            largest = max(largest, abs(ours - theirs))
            outcome = "longer" if ours > theirs else "shorter"
            if abs(ours - theirs) <= EQUAL:
                outcome = "equal"
        outcomes[outcome] += 1
    records: list[Record] = [{"n = 2": k, "problems": v} for k, v in outcomes.items()]
    records.append({"n = 2": "largest difference s", "problems": largest})
    return Section(f"{count} random problems against Ruckig", records)


def _mirrored(count: int) -> Section:
    """Positions negated and limits exchanged: the same durations."""
    records: list[Record] = []
    for n in range(2, 7):
        random = np.random.default_rng((SEED, n, 1))
        apart, other, planned = 0.0, 0, 0
        for _ in range(count):
            problem = directed(random, max(n, 3))
            one, two = problem.duration(n), problem.duration(n, mirrored=True)
            if np.isinf(one) and np.isinf(two):
                continue
            planned += 1
            difference = abs(one - two) / min(one, two)
            other += not difference <= MIRRORED
            apart = max(apart, difference)
        records.append({"n": n, "planned": planned, "over 1e-12": other, "largest": apart})
    return Section("Mirrored problems, relative difference of the durations", records)


def _optima(count: int) -> Section:
    records: list[Record] = []
    for order, smoothness in ((3, 2), (3, 3), (4, 3), (4, 4)):
        random = np.random.default_rng((SEED, order, 2))
        ratios: list[float] = []
        while len(ratios) < count:
            problem = directed(random, order)
            found = problem.duration(smoothness)
            if not np.isfinite(found) or found == 0.0:
                continue
            v, a, w, b, y = problem.state.tolist()
            transition = Transition(
                "", (0.0, v, a), (y, w, b), tuple(problem.limits.tolist()),
                (float(problem.lower[0]), float(problem.lower[1])),
            )
            ratios.append(found / earliest(transition, found, CELLS, 2e-3))
        records.append({
            "limits": order, "smoothness": smoothness, "count": count,
            "median": float(np.median(ratios)), "95 %": float(np.quantile(ratios, 0.95)),
            "largest": max(ratios),
        })
    return Section("Duration over the optimum", records)
