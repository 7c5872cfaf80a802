"""Plans that begin on other plans: arrival when replanned in cycles, stops, new targets."""

from __future__ import annotations

from time import perf_counter

import numpy as np

from benchmarks.report import Part, Record, Section, Settings
from benchmarks.stopping import FloatArray, shortest_motion, shortest_stop
from segfmu import InfeasibleError, Limits, Trajectory, Waypoint, plan, replan, stop

SEED = 11
CYCLES = (0.001, 0.01, 0.1)
LIMITS = ((1.0, 1.0, 4.0), (1.0, 1.0, 4.0, 20.0), (1.0, 1.0, 4.0, 20.0, 200.0))


def measure(settings: Settings) -> Part:
    """The five tables."""
    return Part(
        "Replanning",
        (
            _cycles(settings), _stops(settings), _stops_alone(settings), _moved(settings),
            _new_targets(settings),
        ),
        (
            "linear programming lets the highest limited derivative jump, which a plan does not",
            "a new target is compared with reaching it from rest, from the same place",
        ),
    )


def _cycles(settings: Settings) -> Section:
    records: list[Record] = []
    for n in range(2, 7):
        limits = Limits(*LIMITS[min(n, 4) - 2])
        target = Waypoint([1.0, 0.5, 0.2])
        first = plan([Waypoint([0.0, 0.0, 0.0]), target], limits, smoothness=n)
        record: Record = {"smoothness": n, "first plan s": first.duration}
        for cycle in CYCLES[settings.samples < 500 :]:
            record[f"arrival over it, {1000 * cycle:g} ms"] = (
                _arrival(first, target, cycle) / first.duration
            )
        records.append(record)
    return Section("Replanned to the same target every cycle, 3 axes", records)


def _arrival(trajectory: Trajectory, target: Waypoint, cycle: float) -> float:
    passed = 0.0
    while trajectory.duration > cycle:
        trajectory = replan(trajectory, cycle, target)
        passed += cycle
    return passed + trajectory.duration


def random_plan(random: np.random.Generator, n: int) -> Trajectory:
    """A plan of one axis between two or three waypoints, with limits up to the derivative n."""
    while True:
        bounds = 10.0 ** random.uniform(-0.7, 0.7, n)
        if n == 2:
            bounds = np.append(bounds, 10.0 ** random.uniform(-0.7, 0.7))
        points = [Waypoint(random.normal() * 10.0 ** random.uniform(-1.5, 1.0)) for _ in range(3)]
        share = random.uniform(-0.7, 0.7, 2) * bounds[:2]
        points[1] = Waypoint(points[1].position, *share)
        try:
            chosen = points if random.random() < 0.5 else points[::2]
            return plan(chosen, Limits(*bounds), smoothness=n)
        except InfeasibleError:
            continue


def over_optimum(trajectory: Trajectory, t: float) -> float | None:
    """Duration of a stop over that of linear programming; None where it does not find one."""
    limits: FloatArray = trajectory.limits.table(1, trajectory.smoothness)[0]
    highest = int(np.flatnonzero(limits)[-1]) + 1
    state = trajectory.state(t).state(highest - 1)[0, 1:]
    found = stop(trajectory, t).duration
    optimum = shortest_stop(state, limits[:highest], 1.02 * found)
    return found / optimum if optimum else None


def _quantiles(n: int, ratios: list[float]) -> Record:
    return {
        "smoothness": n, "states": len(ratios), "median": float(np.median(ratios)),
        "95 %": float(np.quantile(ratios, 0.95)), "largest": float(np.max(ratios)),
    }


def _stops(settings: Settings) -> Section:
    records: list[Record] = []
    for n in range(2, 7):
        random = np.random.default_rng(SEED)
        ratios = []
        for _ in range(min(settings.samples, 300) // 2):
            trajectory = random_plan(random, n)
            ratio = over_optimum(trajectory, random.uniform(0.0, trajectory.duration))
            if ratio is not None:
                ratios.append(ratio)
        records.append(_quantiles(n, ratios))
    return Section("Time of a stop over linear programming, random states", records)


def _stops_alone(settings: Settings) -> Section:
    records: list[Record] = []
    for n in range(3, 7):
        random = np.random.default_rng(SEED)
        ratios, refused = [], 0
        for _ in range(2 * settings.samples):
            old = random_plan(random, n)
            t = random.uniform(0.0, old.duration)
            try:
                found = stop(old.state(t), limits=old.limits, smoothness=n)
            except InfeasibleError:
                refused += 1
            else:
                ratios.append(found.duration / (old.duration - t))
        records.append({
            "smoothness": n, "states": len(ratios) + refused, "refused": refused,
            "over 1.05 %": 100.0 * float(np.mean(np.array(ratios) > 1.05)),
            "95 %": float(np.quantile(ratios, 0.95)), "largest": float(np.max(ratios)),
        })
    return Section("Stop from a state alone over the rest of the plan that it belongs to", records)


def _moved(settings: Settings) -> Section:
    records: list[Record] = []
    for n in range(3, 7):
        random = np.random.default_rng(SEED)
        ratios = []
        for _ in range(min(settings.samples, 300) // 2):
            old = random_plan(random, n)
            t = random.uniform(0.0, old.duration)
            positions = [point.position[0] for point in old.waypoints]
            moved = float(random.choice([0.01, 0.1, 1.0])) * random.uniform(-1.0, 1.0)
            target = positions[-1] + moved * float(np.ptp(positions))
            found = replan(old, t, Waypoint(target)).duration
            limits = old.limits.table(1, n)[0]
            highest = int(np.flatnonzero(limits)[-1]) + 1
            state = old.state(t).state(highest - 1)[0]
            optimum = shortest_motion(
                target - state[0], state[1:], limits[:highest], 1.02 * found
            )
            if optimum:
                ratios.append(found / optimum)
        records.append(_quantiles(n, ratios))
    return Section("Time to a target that moves over linear programming, random states", records)


def _new_targets(settings: Settings) -> Section:
    records: list[Record] = []
    for n in range(2, 7):
        random = np.random.default_rng(SEED)
        ratios, times = [], []
        for _ in range(settings.samples):
            old = random_plan(random, n)
            t = random.uniform(0.0, old.duration)
            target = Waypoint(old.waypoints[-1].position + random.normal())
            begin = perf_counter()
            found = replan(old, t, target)
            times.append(perf_counter() - begin)
            resting = plan([Waypoint(old(t)), target], old.limits, smoothness=n)
            ratios.append(found.duration / resting.duration)
        records.append({
            "smoothness": n, "median": float(np.median(ratios)),
            "95 %": float(np.quantile(ratios, 0.95)), "largest": float(np.max(ratios)),
            "call, median ms": 1000.0 * float(np.median(times)),
            "99 % ms": 1000.0 * float(np.quantile(times, 0.99)),
        })
    return Section("Duration to a new target over that from rest at the same place", records)
