"""Random commands: what is exceeded, how long a step takes, and how far a load runs on."""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from benchmarks.operated import SITES, Site, commands, met, needs
from benchmarks.optimal_control import integrators
from benchmarks.report import Part, Record, Section, Settings
from segfmu import Operator

FloatArray = NDArray[np.float64]
SEED = 71
# commands of a run, samples of a step, intervals of the linear program
STEPS = 400
FINE = 16
CELLS = 60
# finite differences know forces no better
ROUGH = 1.002
# an overrun below this share of that from full speed tells nothing
TINY = 1e-3


@dataclass
class Found:
    """What runs at a site have shown."""

    outcomes: Counter[str] = field(default_factory=Counter)
    exceeded: Counter[str] = field(default_factory=Counter)
    seconds: list[float] = field(default_factory=list)
    single: list[float] = field(default_factory=list)
    overruns: list[float] = field(default_factory=list)
    late: int = 0
    slower: int = 0
    releases: int = 0
    samples: int = 0


def measure(settings: Settings) -> Part:
    """Three tables: what was exceeded, time of a step, overrun of a release."""
    runs = max(settings.problems // 100, 1)
    found = {name: runs_at(site, runs) for name, site in SITES.items()}
    return Part("Operation", (
        Section("Random commands", [
            {
                "crane": name, "plans": sum(f.outcomes.values()), "taken": f.outcomes["taken"],
                "reduced": f.outcomes["reduced"], "refused": sum(
                    n for o, n in f.outcomes.items() if o not in ("taken", "reduced")
                ),
                "samples": f.samples,
                **{f"{what} exceeded": f.exceeded[what]
                   for what in ("limits", "drives", "workspace", "boxes")},
                "releases": f.releases, "not at once": f.late,
                "slower, by drives": f.slower,
            }
            for name, f in found.items()
        ]),
        Section("A step that plans, through the extension: processor time [us]", [
            row for name, f in found.items()
            for row in (_times(name, "all", f.seconds), _times(name, "one attempt", f.single))
        ]),
        Section("Way of an axis after a release over the shortest by a linear program", [
            {
                "crane": name, "releases": len(f.overruns), **_quantiles(f.overruns),
            }
            for name, f in found.items()
        ]),
    ), (
        f"{runs} runs of {STEPS} steps at each crane, {FINE} samples of each step; drives and "
        "boxes by Newton's laws and finite differences",
        f"linear program: {CELLS} intervals of constant snap, the least of the farthest positions",
        "not at once: stops that begin after the next step; slower: those that the drives "
        "do not follow with all limits, which are not in the last table",
    ))


def _times(name: str, which: str, seconds: list[float]) -> Record:
    micro = 1e6 * np.array(seconds)
    return {
        "crane": name, "steps": which, "count": micro.size, "median": float(np.median(micro)),
        "99 %": float(np.quantile(micro, 0.99)), "99.99 %": float(np.quantile(micro, 0.9999)),
        "largest": float(micro.max()),
    }


def _quantiles(values: list[float]) -> Record:
    array = np.array(values)
    return {
        "median": float(np.median(array)), "95 %": float(np.quantile(array, 0.95)),
        "largest": float(array.max()),
    }


def runs_at(site: Site, runs: int) -> Found:
    """All runs at a site."""
    found = Found()
    for seed in range(runs):
        run(site, np.random.default_rng((SEED, seed)), found)
    return found


def run(site: Site, random: np.random.Generator, found: Found) -> None:
    """One run; adds to what was found."""
    operator = site.operator()
    motion = []
    before = ""
    for command in commands(site, random, STEPS):
        operator.command(**command)
        released = command["mode"] == "stop" and before == "velocity"
        before = str(command["mode"])
        state = operator.load
        tried = operator.attempts
        begin = time.thread_time()
        operator.step(site.step)
        seconds = time.thread_time() - begin
        tried = operator.attempts - tried
        if tried > 0:
            found.seconds.append(seconds)
            found.outcomes[operator.status] += 1
            if tried == 1:
                found.single.append(seconds)
        if released and np.abs(state[1]).max() > 0.0:
            found.releases += 1
            found.late += operator.status != "taken"
            found.slower += operator.status == "taken" and tried > 1
            if operator.status == "taken" and tried == 1:
                found.overruns += overruns(site, operator, state)
        start = operator.time - site.step
        motion += [operator.load_at(start + site.step * i / FINE) for i in range(FINE)]
    judge(site, np.array(motion), found)


def judge(site: Site, motion: FloatArray, found: Found) -> None:
    """Count the samples (samples, 5, 3) that exceed something."""
    found.samples += len(motion)
    table = site.limits.table(3, 4)[:, :4].T
    found.exceeded["limits"] += int((np.abs(motion[:, 1:]) > table * (1.0 + 1e-9)).sum())
    places = motion[:, 0]
    touch = 1e-9 * np.abs(places).max()
    outside = (places < site.clearance.minimum - touch) | (places > site.clearance.maximum + touch)
    found.exceeded["workspace"] += int(outside.sum())
    needed = needs(site.crane, places, site.step / FINE)
    for quantity in ("force", "velocity", "acceleration", "sway_angle"):
        bound = ROUGH * getattr(site.bounds, quantity)
        found.exceeded["drives"] += int((np.abs(needed[quantity]) > bound).sum())
    depth = met(site, places[2:-2], needed["carriage"])
    found.exceeded["boxes"] += int((depth > 1e-5 * np.abs(places).max()).sum())


def overruns(site: Site, operator: Operator, state: FloatArray) -> list[float]:
    """Way of each moving axis after a release over the shortest one."""
    table = site.limits.table(3, 4)
    pieces = operator.plan
    last = operator.load_at(operator.rests_at)[0]
    found = []
    for axis in range(3):
        velocity = state[1, axis]
        longest = float(pieces.timing[pieces.offsets[axis + 1] - 1].sum())
        usual = table[axis, 0] ** 2 / table[axis, 1]
        way = float(np.sign(velocity) * (last[axis] - state[0, axis]))
        if abs(velocity) > 0.05 * table[axis, 0] and way > TINY * usual:
            least = shortest_overrun(
                np.sign(velocity) * state[1:4, axis], table[axis, :4], 1.5 * longest
            )
            if least is not None and least > TINY * usual:
                found.append(way / least)
    return found


def shortest_overrun(state: FloatArray, limits: FloatArray, duration: float) -> float | None:
    """The least farthest position [m] of an axis on its way to rest, by a linear program.

    state: velocity, acceleration and jerk, from the position 0; the snap is constant in each
    interval and may jump. Limits are kept at the ends of the intervals. None: no solution.
    """
    step, gain = integrators(4, duration / CELLS)
    effect, free = np.zeros((CELLS + 1, 4, CELLS)), np.zeros((CELLS + 1, 4))
    free[0, 1:] = state
    for k in range(CELLS):
        effect[k + 1], free[k + 1] = step @ effect[k], step @ free[k]
        effect[k + 1, :, k] += gain * limits[3]
    # the last unknown is the farthest position, in units of the distance at full speed
    unit = limits[0] * duration
    rows = [np.column_stack([effect[1:, 0] / unit, -np.ones(CELLS)])]
    bounds = [-free[1:, 0] / unit]
    for i in range(1, 4):
        inner, offset = effect[1:-1, i] / limits[i - 1], free[1:-1, i] / limits[i - 1]
        nothing = np.zeros((len(inner), 1))
        rows += [np.hstack([inner, nothing]), np.hstack([-inner, nothing])]
        bounds += [1.0 - offset, 1.0 + offset]
    ends = np.hstack([effect[-1, 1:] / limits[:3, None], np.zeros((3, 1))])
    found = linprog(
        np.append(np.zeros(CELLS), 1.0), A_ub=np.vstack(rows), b_ub=np.concatenate(bounds),
        A_eq=ends, b_eq=-free[-1, 1:] / limits[:3],
        bounds=[(-1.0, 1.0)] * CELLS + [(0.0, None)], method="highs",
    )
    return float(found.x[-1] * unit) if found.status == 0 else None
