"""The least velocity that braking an acceleration needs, against linear programs."""

from __future__ import annotations

import numpy as np
from scipy.optimize import linprog

from benchmarks.completeness import planned
from benchmarks.optimal_control import integrators
from benchmarks.problems import FloatArray
from benchmarks.report import Part, Record, Section, Settings
from segfmu.kernels import backend
from segfmu.kernels.planner.parameters import usual_share
from segfmu.kernels.planner.records import Axis, PlanWork, Shape

SEED = 43
CELLS = 80
# names of the highest limited derivative
HIGHEST = {3: "jerk", 4: "snap", 5: "crackle", 6: "pop"}


def measure(settings: Settings) -> Part:
    """One table: the velocity needed over the least possible one."""
    records: list[Record] = []
    for n, name in HIGHEST.items():
        random = np.random.default_rng((SEED, n))
        found = np.array([_ratio(random, n) for _ in range(max(settings.samples // 10, 10))])
        records.append({
            "highest limit": name, "problems": found.size, "median": float(np.median(found)),
            "95 %": float(np.quantile(found, 0.95)), "largest": float(found.max()),
        })
    title = "Velocity limit needed to brake an acceleration, from velocity 0, over the least one"
    return Part("Braking", (Section(title, records),), (
        f"least one: linear program over {CELLS} cells, in which the highest derivative may jump",
        "needed: the least limit with which a plan to rest is found, by bisection",
    ))


def _ratio(random: np.random.Generator, n: int) -> float:
    limits = np.zeros(n + 1)
    limits[:n] = 10.0 ** random.uniform(-1.0, 1.0, n)
    first = limits[1] * random.uniform(0.1, 1.0)
    least = least_velocity(first, limits[1:n], 3.0 * _ramp(2.0 * first, n, limits))
    # far away, so that the distance decides nothing
    state = np.array([0.0, first, 0.0, 0.0, 1e3 * least * _ramp(first, n, limits)])
    low, high = 0.5 * least, 4.0 * least
    while high - low > 1e-4 * high:
        limits[0] = 0.5 * (low + high)
        if np.isfinite(planned(n, limits, state)):
            high = float(limits[0])
        else:
            low = float(limits[0])
    return high / least


def _ramp(change: float, n: int, limits: FloatArray) -> float:
    """Duration of a ramp [s]."""
    axis, work = np.zeros(Axis.SIZE), np.zeros((PlanWork.SIZE, PlanWork.COLUMNS))
    backend.axis_limits(n, Shape.PLATEAU, limits, axis)
    assert backend.ramp_parameters(usual_share(axis), axis, work)
    return float(backend.ramp_duration(change, axis)[0])


def least_velocity(first: float, limits: FloatArray, horizon: float) -> float:
    """The least peak of the velocity of a motion from an acceleration to none.

    limits: those of the acceleration and what follows, all given; the last one may jump.
    horizon: the acceleration is zero, and all above it, at that time [s].
    """
    order = limits.size
    h = horizon / CELLS
    # state: velocity, acceleration .. below the control
    step, gain = integrators(order, h)
    gain *= limits[-1]
    effect, free = np.zeros((CELLS + 1, order, CELLS)), np.zeros((CELLS + 1, order))
    free[0, 1] = first
    for k in range(CELLS):
        effect[k + 1] = step @ effect[k]
        effect[k + 1, :, k] += gain
        free[k + 1] = step @ free[k]
    scale = np.concatenate([[first * horizon], limits[:-1]])
    effect, free = effect / scale[:, None], free / scale
    rows = effect[1:].reshape(-1, CELLS)
    offset = free[1:].ravel()
    peak = np.tile(np.arange(order) == 0, CELLS).astype(float)[:, None]
    bound = np.where(peak[:, 0] > 0.0, 0.0, 1.0)
    found = linprog(
        np.append(np.zeros(CELLS), 1.0),
        A_ub=np.vstack([np.hstack([rows, -peak]), np.hstack([-rows, -peak])]),
        b_ub=np.concatenate([bound - offset, bound + offset]),
        A_eq=np.hstack([effect[-1, 1:], np.zeros((order - 1, 1))]), b_eq=-free[-1, 1:],
        bounds=[(-1.0, 1.0)] * CELLS + [(0.0, None)], method="highs",
    )
    return float(found.x[-1] * first * horizon)
