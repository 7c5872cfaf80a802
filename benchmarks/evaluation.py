"""Evaluation of a planned trajectory at many times, beside SciPy's piecewise polynomials."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import PPoly

from benchmarks.report import Part, Record, Section, Settings
from benchmarks.timing import interleaved, ratios
from segfmu import Limits, Trajectory, Waypoint, plan

TIMES = 100_000
DERIVATIVES = range(5)


def measure(settings: Settings) -> Part:
    """Time of position and four derivatives of three axes at 100,000 times."""
    trajectory = _mission()
    splines = [_spline(trajectory, axis) for axis in range(trajectory.axes)]
    times = np.linspace(0.0, trajectory.duration, TIMES)
    taken = interleaved(
        {
            "scipy PPoly, by axis": lambda _: [
                [spline(times, d) for spline in splines] for d in DERIVATIVES
            ],
            "segfmu.Trajectory": lambda _: [trajectory(times, d) for d in DERIVATIVES],
        },
        1, 5 * settings.repetitions,
    )
    reference = next(iter(taken.values()))[:, 0]
    records: list[Record] = [
        {
            "evaluated by": name,
            "median ms": 1e-3 * float(np.median(values)),
            "largest ms": 1e-3 * float(values.max()),
            **ratios(values[:, 0], reference),
        }
        for name, values in taken.items()
    ]
    worst = max(
        float(np.abs(trajectory(times)[:, axis] - spline(times)).max())
        for axis, spline in enumerate(splines)
    )
    return Part(
        "Evaluation",
        (Section(f"Position and 4 derivatives of 3 axes at {TIMES:,} times", records),),
        (f"positions agree within {worst:.1e} m",),
    )


def _mission() -> Trajectory:
    points = [
        Waypoint([0.0, 0.0, -1.0]),
        Waypoint([0.3, 0.2, -0.8], velocity=[0.2, 0.1, 0.0]),
        Waypoint([1.0, 0.8, -0.5]),
    ]
    return plan(points, Limits([1.0, 0.4, 0.3], 0.5, 0.5, 5.0))


def _spline(trajectory: Trajectory, axis: int) -> PPoly:
    starts, lengths, coefficients = trajectory.pieces(axis)
    return PPoly(coefficients.T[::-1], np.append(starts, starts[-1] + lengths[-1]))
