"""Motions of polynomials, which no ramps resemble: shortest plans, and plans of their duration."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import chebyshev, polynomial

from benchmarks.problems import FloatArray
from benchmarks.report import Record, Section
from segfmu import InfeasibleError, Limits, Waypoint, plan

SEED = 43
LONGER = 1.5
SLACK = 0.95
# smoothness, and the highest limited derivative
KINDS = ((3, 3), (3, 4), (4, 4), (4, 5), (5, 4), (5, 5), (5, 6), (6, 4), (6, 6))


def smooth_motion(rng: np.random.Generator, smoothness: int) -> FloatArray:
    """Coefficients of a polynomial on [0, 1], the higher derivatives zero at its ends."""
    factor = chebyshev.cheb2poly(rng.normal(size=rng.integers(1, 9)))
    jerk = polynomial.polymul(polynomial.polypow([0.0, 1.0, -1.0], smoothness - 2), factor)
    acceleration = polynomial.polyint(jerk)
    acceleration[0] = rng.choice([0.0, -0.5, -1.0]) * polynomial.polyval(1.0, acceleration)
    velocity = polynomial.polyint(acceleration)
    velocity[0] = rng.choice([0.0, -0.5, -1.0, rng.normal()]) * polynomial.polyval(1.0, velocity)
    return np.asarray(polynomial.polyint(velocity), dtype=np.float64)


def boundary(motion: FloatArray, highest: int, slack: float) -> tuple[list[Waypoint], Limits]:
    """The states at both ends, and limits of which the motion uses at most the share `slack`."""
    times = np.linspace(0.0, 1.0, 401)
    orders = [polynomial.polyder(motion, k) for k in range(highest + 1)]
    limits = [np.abs(polynomial.polyval(times, c)).max() / slack for c in orders[1:]]
    ends = [[float(polynomial.polyval(t, c)) for c in orders[:3]] for t in (0.0, 1.0)]
    return [Waypoint(*state) for state in ends], Limits(*limits)


def measure_smooth(count: int) -> Section:
    """Shortest duration, and the duration of the motion itself."""
    records: list[Record] = []
    for smoothness, highest in KINDS:
        rng = np.random.default_rng((SEED, smoothness, highest))
        ratios, gaps, refused = [], 0, 0
        for _ in range(count):
            points, limits = boundary(smooth_motion(rng, smoothness), highest, SLACK)
            try:
                ratios.append(plan(points, limits, smoothness=smoothness).duration)
            except InfeasibleError:
                refused += 1
                continue
            try:
                plan(points, limits, smoothness=smoothness, duration=1.0)
            except InfeasibleError:
                gaps += ratios[-1] <= 1.0
        taken = np.array(ratios)
        records.append({
            "smoothness": smoothness, "highest limit": highest, "count": count,
            "refused": refused, f"over {LONGER:g}": f"{(taken > LONGER).mean():.2%}",
            "longer": f"{(taken > 1.0 + 1e-9).mean():.1%}", "largest": float(taken.max()),
            "its duration refused": f"{gaps / count:.1%}",
        })
    return Section(f"Motions of polynomials of 1 s within {SLACK:.0%} of the limits", records)
