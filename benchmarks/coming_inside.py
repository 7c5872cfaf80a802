"""How long states stay outside their limits, against linear programs and against Ruckig.

The derivatives come inside one after the other, the highest one first. The least time of the last
one follows from linear programs in the derivative n + 1, bisected in the time: until then it is
free, afterwards inside; those above it are at most as far outside as in the plan, those below
inside if they are in the plan. At the end of a second part all above the velocity are zero, so that
the state can stay inside.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import linprog

from benchmarks.optimal_control import integrators
from benchmarks.problems import FloatArray
from benchmarks.report import Part, Record, Section, Settings
from segfmu import Limits, Trajectory, Waypoint, stop
from segfmu.planning.polynomials import inside_from

SEED = 44
CELLS = 90
BASE = np.array([1.0, 1.0, 4.0, 20.0, 400.0])


def measure(settings: Settings) -> Part:
    """Two tables: times outside over the least ones, and brakes over Ruckig's."""
    records: list[Record] = []
    for n in (2, 3, 4):
        found = np.array(ratios(n, max(settings.samples // 10, 10), SEED))
        records.append({
            "n": n, "problems": found.size, "median": float(np.median(found)),
            "95 %": float(np.quantile(found, 0.95)), "largest": float(found.max()),
        })
    title = "Time outside the limits over the least one"
    return Part("Coming inside", (Section(title, records), _against_ruckig(settings)), (
        f"least one: linear programs over {CELLS} cells before it and as many after it",
        "states beyond one to all of their limits by 0.1 % to 200 %",
    ))


def _against_ruckig(settings: Settings) -> Section:
    from ruckig import InputParameter, Ruckig, RuckigError
    from ruckig import Trajectory as Found

    random, otg, found = np.random.default_rng(SEED), Ruckig(1), Found(1)
    brakes, worst, narrow, late = 0, 0.0, 0, 0
    for _ in range(20 * settings.samples):
        limits = random.uniform(0.08, 16.0, 3)
        state = random.uniform(-3.0, 3.0, 2) * limits[:2]
        ours = float(stop(Waypoint(0.0, *state), limits=Limits(*limits), smoothness=2).outside[0])
        given = InputParameter(1)
        given.current_position, given.target_position = [0.0], [random.uniform(-5.0, 5.0)]
        given.current_velocity, given.current_acceleration = [state[0]], [state[1]]
        given.max_velocity, given.max_acceleration, given.max_jerk = ([c] for c in limits)
        try:
            otg.calculate(given, found)
        except RuckigError:
            continue
        theirs = found.profiles[0][0].brake.duration
        if abs(found.at_time(theirs)[1][0]) <= limits[0] * (1.0 + 1e-9):
            brakes += theirs > 0.0
            worst = max(worst, abs(ours - theirs) / max(theirs, 1.0))
            continue
        # its brake ends before the velocity is inside
        narrow += 1
        times = np.linspace(theirs, found.duration, 2001)
        beyond = np.array([abs(found.at_time(t)[1][0]) for t in times]) > limits[0]
        inside = times[min(int(np.flatnonzero(beyond)[-1]) + 1, times.size - 1)]
        late += bool(ours > inside + 1e-9)
    return Section("Brakes at n = 2 beside Ruckig's", [{
        "brakes": brakes, "largest difference [s]": worst,
        "end outside in Ruckig": narrow, "of these later inside": late,
    }])


def ratios(n: int, count: int, seed: int) -> list[float]:
    """Times outside over the least ones, of random states at the smoothness n."""
    random = np.random.default_rng((seed, n))
    found: list[float] = []
    while len(found) < count:
        limits = BASE[: n + 1] * np.exp(random.uniform(-0.5, 0.5, n + 1))
        shares = random.uniform(-0.9, 0.9, n)
        for i in random.choice(n, size=random.integers(1, n + 1), replace=False):
            shares[i] = np.sign(shares[i]) * (1.0 + 10.0 ** random.uniform(-3.0, np.log10(2.0)))
        state = shares * limits[:n]
        stopped = stop(Waypoint(0.0, *state), limits=Limits(*limits), smoothness=n)
        if stopped.outside[0] > 0.0:
            found.append(float(stopped.outside[0]) / least_time(stopped, state, limits))
    return found


def least_time(found: Trajectory, state: FloatArray, limits: FloatArray) -> float:
    """The least time until all derivatives are inside [s]."""
    starts, lengths, coefficients = found.pieces(0)
    # those that exceed their limit by rounding alone are inside
    told = np.array([
        inside_from(starts, lengths, coefficients, q, -limit, limit)
        for q, limit in enumerate((limits[:-1] * (1.0 + 1e-9)).tolist(), 1)
    ])
    low, high = 0.0, 1.05 * float(told.max())
    assert _feasible(found, state, limits, told, high)
    while high - low > 1e-3 * high:
        middle = 0.5 * (low + high)
        if _feasible(found, state, limits, told, middle):
            high = middle
        else:
            low = middle
    others = told[told < 0.999 * told.max()]
    return max(high, *others) if others.size else high


def _nodes(told: FloatArray, limits: FloatArray, until: float) -> FloatArray:
    settling = 3.0 * float(np.sum(limits[:-1] / limits[1:]))
    shares = np.linspace(0.0, 1.0, CELLS + 1)
    before = 0.5 * until * (1.0 - np.cos(np.pi * shares))
    inner = told[(told > 0.0) & (told < until)]
    nodes: FloatArray = np.unique(np.concatenate([before, inner, until + settling * shares**2]))
    return nodes


def _feasible(
    found: Trajectory, state: FloatArray, limits: FloatArray, told: FloatArray, until: float
) -> bool:
    n = state.size
    nodes = _nodes(told, limits, until)
    effect, free = np.zeros((n, nodes.size - 1)), state.copy()
    rows, room = [], []
    for k, step in enumerate(np.diff(nodes)):
        matrix, gain = integrators(n, float(step))
        effect, free = matrix @ effect, matrix @ free
        effect[:, k] += gain * limits[-1]
        bounds = _bounds(found, limits, told, until, float(nodes[k + 1]))
        for i in np.flatnonzero(np.isfinite(bounds)):
            rows += [effect[i] / bounds[i], -effect[i] / bounds[i]]
            room += [1.0 - free[i] / bounds[i] + 1e-10, 1.0 + free[i] / bounds[i] + 1e-10]
    # all above the velocity are zero at the end
    scale = limits[1:n]
    solved = linprog(
        np.zeros(nodes.size - 1), A_ub=np.array(rows), b_ub=np.array(room),
        A_eq=effect[1:] / scale[:, None], b_eq=-free[1:] / scale, bounds=(-1.0, 1.0),
        method="highs",
    )
    return bool(solved.status == 0)


def _bounds(
    found: Trajectory, limits: FloatArray, told: FloatArray, until: float, time: float
) -> FloatArray:
    """Bounds of the derivatives 1 .. n at a time, infinite for what is free."""
    bounds, last = limits[:-1].copy(), int(np.argmax(told))
    if time >= until * (1.0 - 1e-9):
        return bounds
    for i in range(bounds.size):
        if i == last or (i < last and told[i] > 0.0):
            bounds[i] = np.inf
        elif i > last and time < 1.02 * told[i]:
            around = found(np.array([time, max(time - 0.02 * told[i], 0.0)]), i + 1)
            bounds[i] = max(bounds[i], 1.01 * float(np.abs(around).max()))
    return bounds
