"""What the search for one axis misses: motions that exist, optima, plans of tighter limits.

A constructed motion is a random sequence of ramps and holds that keeps 95 % of every limit, so a
planner may take its duration at most. The optima of smoothness 4 to 6 come from linear programs.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.braked_states import barely_braked
from benchmarks.optimal_control import Transition, earliest, smoothest
from benchmarks.problems import FloatArray
from benchmarks.report import Part, Record, Section, Settings
from benchmarks.smooth_motions import measure_smooth
from segfmu import InfeasibleError, InputError, Limits, Trajectory, Waypoint, plan
from segfmu.kernels import backend
from segfmu.kernels.planner.parameters import usual_share
from segfmu.kernels.planner.records import Axis, Cell, Phase, PlanWork, Shape

SEED = 41
SLACK = 0.95
LONGER = 1.5
CLIFF = 1.1
CELLS = 50
# largest change of the acceleration, relative to its limit
SIZES = {"short": 0.3, "long": 2.0}


@dataclass(frozen=True)
class Motion:
    """A boundary problem v, a, w, b, distance, and the duration of a motion that solves it."""

    limits: FloatArray
    state: FloatArray
    duration: float


def measure(settings: Settings) -> Part:
    """Tables of constructed motions, of ratios to optima, and of loosened limits."""
    return Part(
        "Completeness",
        (
            _constructed(10 * settings.samples),
            measure_smooth(3 * settings.samples),
            _optima(max(settings.samples // 5, 20)),
            _cliffs(8 * settings.samples),
            _loosened(10 * settings.problems, False),
            _loosened(settings.problems, True),
            _prolonged(settings.samples),
        ),
        (
            f"constructed: ramps and holds that keep {SLACK:.0%} of every limit; short: the "
            f"acceleration changes by up to {SIZES['short']:g} of its limit in a ramp",
            f"optimum: linear program over {CELLS} cells, velocity and acceleration at the nodes; "
            "the highest limited derivative jumps, as it may with a smoothness of one less; "
            "braked: states that can barely be braked within the velocity limit",
            "prolonged: 1.05 to 2 times the shortest duration; smoothest: quadratic program over "
            f"{CELLS} cells within the same limits",
            "cliffs: the problems of the optima; ramps with a continuous snap take up to "
            f"{1.0 / np.sqrt(1.0 - snap_share()):.3f} times as long",
            "loosened: one limit times 1 to 10; longer by more than 1e-9 of the duration; beyond "
            "reach: one below the highest, times 1 to 1e12",
        ),
    )


def planned(smoothness: int, limits: FloatArray, state: FloatArray) -> float:
    """Duration of the plan of a problem [s]; inf where it is refused, 0 with nothing to do."""
    v, a, w, b, distance = state
    points = [Waypoint(0.0, v, a), Waypoint(distance, w, b)]
    given: list[Any] = [c or None for c in limits[:6]]
    try:
        return plan(points, Limits(*given), smoothness=smoothness).duration
    except InfeasibleError:
        return np.inf
    except InputError:
        return 0.0


def snap_share() -> float:
    """The usual share of the snap's rise at smoothness 4."""
    axis = np.zeros(Axis.SIZE)
    backend.axis_limits(4, Shape.PLATEAU, np.ones(5), axis)
    return float(usual_share(axis))


def random_limits(random: np.random.Generator, n: int) -> FloatArray:
    """Limits c_1 .. c_n, c_{n+1} absent (n = 2: c_3 given), over a decade and a half each."""
    limits = np.zeros(n + 1)
    given = max(n, 3)
    limits[:given] = 10.0 ** random.uniform(-0.5, 1.0, given)
    return limits


def constructed(random: np.random.Generator, n: int, size: float) -> Motion | None:
    """A random motion that keeps SLACK of every limit; None if it passes the velocity limit."""
    limits = random_limits(random, n)
    axis, work = np.zeros(Axis.SIZE), np.zeros((PlanWork.SIZE, PlanWork.COLUMNS))
    backend.axis_limits(n, Shape.PLATEAU, SLACK * limits, axis)
    backend.ramp_parameters(usual_share(axis), axis, work)
    top = SLACK * limits[1]
    phases = np.zeros((Cell.ABOVE, Phase.SIZE))
    a = first = top * random.choice([random.uniform(-1.0, 1.0), -1.0, 1.0, 0.0])
    count = 0
    for _ in range(random.integers(1, 5)):
        b = np.clip(a + size * top * random.uniform(-1.0, 1.0), -top, top)
        duration, _ = backend.ramp_duration(abs(b - a), axis)
        phases[count, : Phase.ABOVE] = duration, duration, a, b - a
        count += 1
        if random.random() < 0.4:
            phases[count, : Phase.ABOVE] = size * duration * random.uniform(0.0, 1.0), 0.0, b, 0.0
            count += 1
        a = b
    v = SLACK * limits[0] * random.uniform(-1.0, 1.0)
    duration, y, w, low, high = backend.measure_phases(phases[:count], count, v, 0.0, axis)
    if duration == 0.0 or max(-low, high) > SLACK * limits[0]:
        return None
    return Motion(limits, np.array([v, first, w, a, y]), duration)


def _constructed(count: int) -> Section:
    records: list[Record] = []
    for n in range(3, 7):
        for name, size in SIZES.items():
            random = np.random.default_rng((SEED, n, len(name)))
            ratios: list[float] = []
            while len(ratios) < count:
                motion = constructed(random, n, size)
                if motion is not None:
                    found = planned(n, motion.limits, motion.state)
                    ratios.append(found / motion.duration)
            taken = np.array(ratios)
            finite = taken[np.isfinite(taken)]
            records.append({
                "n": n, "motions": name, "count": count,
                "refused": f"{np.isinf(taken).mean():.3%}",
                f"over {LONGER:g}": f"{(taken > LONGER).mean():.3%}",
                "longer": f"{(taken > 1.0 + 1e-9).mean():.3%}",
                "99 %": float(np.quantile(finite, 0.99)), "largest": float(finite.max()),
            })
    return Section("Duration over that of a constructed motion", records)


def random_problem(
    random: np.random.Generator, n: int, kind: str
) -> tuple[FloatArray, FloatArray]:
    """Limits and boundary values of a random problem."""
    limits = np.zeros(n + 1)
    limits[:n] = 10.0 ** random.uniform(-0.3, 0.7, n)
    share = random.uniform(-1.0, 1.0, 4)
    if kind == "ties":
        share = np.round(2.0 * share) / 2.0
    distance = random.normal() * (0.1 if kind == "short" else 2.0) * limits[0]
    state = np.array([*(share * limits[[0, 1, 0, 1]] * 0.8), distance])
    if kind == "rest":
        state[:4] = 0.0
    elif kind == "braked":
        state = barely_braked(random, limits, state)
    return limits, state


def _optima(count: int) -> Section:
    records: list[Record] = []
    for n in (4, 5, 6):
        for kind in ("rest", "moving", "short", "ties", "braked"):
            random = np.random.default_rng((SEED, n, len(kind)))
            ratios: list[FloatArray] = []
            while len(ratios) < count:
                limits, state = random_problem(random, n, kind)
                # with the smoothness n - 1 the highest limited derivative may jump
                found = np.array([planned(n - 1, limits, state), planned(n, limits, state)])
                if not np.isfinite(found).all() or found.min() == 0.0:
                    continue
                v, a, w, b, distance = state
                transition = Transition(kind, (0.0, v, a), (distance, w, b), tuple(limits[:n]))
                ratios.append(found / earliest(transition, float(found.min()), CELLS, 2e-3))
            for smoothness, taken in zip((n - 1, n), np.array(ratios).T, strict=True):
                records.append({
                    "limits": n, "smoothness": smoothness, "problems": kind, "count": count,
                    "median": float(np.median(taken)),
                    "95 %": float(np.quantile(taken, 0.95)), "largest": float(taken.max()),
                })
    return Section("Duration over the optimum", records)


def _cliffs(count: int) -> Section:
    """What a continuous snap costs: limits up to the snap, smoothness 4 and 3."""
    records: list[Record] = []
    for kind in ("moving", "short", "ties"):
        random = np.random.default_rng((SEED, 4, len(kind)))
        ratios: list[float] = []
        while len(ratios) < count:
            limits, state = random_problem(random, 4, kind)
            jumping, smooth = (planned(n, limits, state) for n in (3, 4))
            if np.isfinite(jumping) and smooth > 0.0:
                ratios.append(smooth / jumping)
        taken = np.array(ratios)
        finite = taken[np.isfinite(taken)]
        records.append({
            "problems": kind, "count": count, "refused": int(np.isinf(taken).sum()),
            "median": float(np.median(taken)), "95 %": float(np.quantile(taken, 0.95)),
            f"over {CLIFF:g}": int((finite > CLIFF).sum()), "largest": float(finite.max()),
        })
    return Section("Duration at smoothness 4 over that at smoothness 3", records)


def loosened(
    random: np.random.Generator, n: int, smoothness: int, beyond: bool = False
) -> tuple[float, str]:
    """How much longer a plan becomes by loosening one limit, relative; and the problem.

    Limits c_1 .. c_n, or up to the jerk at n = 2; beyond: all but the highest one, by up to 1e12.
    """
    limits = random_limits(random, n)
    share = random.uniform(-1.0, 1.0, 4)
    share[random.random(4) < 0.3] = 0.0
    state = np.array([
        *(share * limits[[0, 1, 0, 1]]), random.normal() * 10.0 ** random.uniform(-2.0, 1.0)
    ])
    loose = limits.copy()
    loose[random.integers(0, max(n, 3) - beyond)] *= 10.0 ** random.uniform(0.0, 1.0 + 11 * beyond)
    before, after = planned(smoothness, limits, state), planned(smoothness, loose, state)
    longer = 0.0 if np.isinf(before) else after / max(before, 1e-300) - 1.0
    return longer, f"{n}, {limits.tolist()}, {loose.tolist()}, {state.tolist()}"


def _loosened(count: int, beyond: bool) -> Section:
    records: list[Record] = []
    # with the smoothness n - 1 the highest limited derivative may jump, as with 2 and limits of the
    # jerk: then there are no rises to choose
    for n, smoothness in ((2, 2), (3, 2), (3, 3), (4, 3), (4, 4), (5, 4), (5, 5), (6, 5), (6, 6)):
        random = np.random.default_rng((SEED, n))
        taken = np.array([loosened(random, n, smoothness, beyond)[0] for _ in range(count // 5)])
        finite = taken[np.isfinite(taken)]
        records.append({
            "limits": max(n, 3), "smoothness": smoothness, "problems": taken.size,
            "refused then": int(np.isinf(taken).sum()),
            "longer": int((finite > 1e-9).sum()), "by 1 %": int((finite > 0.01).sum()),
            "largest": float(finite.max()),
        })
    return Section(f"One limit loosened{' beyond reach' if beyond else ''}", records)


def _snap_rms(trajectory: Trajectory) -> float:
    """RMS of the snap of the first axis [m/s4], from its polynomials."""
    _, lengths, coefficients = trajectory.pieces(0)
    total = 0.0
    for length, row in zip(lengths, coefficients, strict=True):
        snap = np.polynomial.Polynomial(row).deriv(4)
        total += float((snap * snap).integ()(length))
    return float(np.sqrt(total / lengths.sum()))


def _prolonged(count: int) -> Section:
    """Snap of one axis at smoothness 4 whose duration is prescribed."""
    random = np.random.default_rng((SEED, 7))
    ratios: list[float] = []
    pieces: list[int] = []
    none = 0
    while len(ratios) < count:
        limits, state = random_problem(random, 4, "moving")
        state[:4] *= 0.5
        found = planned(4, limits, state)
        if not np.isfinite(found):
            continue
        v, a, w, b, distance = state
        target = found * random.uniform(1.05, 2.0)
        points = [Waypoint([0.0], [v], [a]), Waypoint([distance], [w], [b])]
        try:
            trajectory = plan(points, Limits(*limits[:4]), duration=target)
        except InfeasibleError:
            continue
        bounds = tuple(limits[:4].tolist())
        transition = Transition("x", (0.0, v, a), (distance, w, b), bounds)
        least = smoothest(transition, target, CELLS)
        if np.isnan(least):
            none += 1
            continue
        ratios.append(_snap_rms(trajectory) / least)
        pieces.append(len(trajectory.pieces(0)[1]))
    return Section("Snap of a prolonged axis over that of the smoothest motion, RMS", [{
        "problems": count, "not over cells": none, "median": float(np.median(ratios)),
        "95 %": float(np.quantile(ratios, 0.95)), "largest": float(max(ratios)),
        "pieces, median": float(np.median(pieces)), "most": max(pieces),
    }])
