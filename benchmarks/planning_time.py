"""Time of one plan from Python: `segfmu.plan` beside Ruckig's `calculate`."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from benchmarks.problems import Problems, random_problems
from benchmarks.report import Part, Record, Section, Settings
from benchmarks.timing import interleaved, ratios, spread
from segfmu import InfeasibleError, plan

SEED = 11
RUCKIG = "Ruckig, calculate"
RUCKIG_BUILT = "Ruckig, input built"
SEGFMU_BUILT = "segfmu.plan, n = 4, input built"


def measure(settings: Settings) -> Part:
    """Times of 1 and 3 axes, rest to rest and moving, n = 2 and n = 4."""
    sections = [
        _section(kind, axes, settings)
        for axes in (1, 3)
        for kind in ("rest to rest", "moving")
    ]
    return Part(
        "Planning time from Python",
        sections,
        (
            "ratio: median time over Ruckig's in the same way of calling; least and largest of "
            f"{settings.repetitions} passes",
            "Ruckig bounds velocity, acceleration and jerk; n = 4 bounds snap as well",
            "99 % and largest: a problem counts with its least time of all passes",
            "segfmu.plan returns polynomials that were checked against every limit",
            "input built: waypoints and limits, or InputParameter, are made in the timed call",
        ),
    )


def _section(kind: str, axes: int, settings: Settings) -> Section:
    problems = _solvable(random_problems(kind, axes, settings.samples, SEED))
    calls = _calls(problems)
    times = interleaved(calls, problems.count, settings.repetitions)
    medians = {name: np.median(values, axis=1) for name, values in times.items()}
    records: list[Record] = []
    for name in calls:
        reference = RUCKIG_BUILT if "built" in name else RUCKIG
        records.append(
            {"planner": name, **spread(times[name]), **ratios(medians[name], medians[reference])}
        )
    plural = "axis" if axes == 1 else "axes"
    return Section(f"{axes} {plural}, {kind}, {problems.count} problems", records)


def _solvable(problems: Problems) -> Problems:
    """The problems that Ruckig and both smoothnesses plan, so that all time the same."""
    from ruckig import Ruckig, RuckigError, Trajectory

    ruckig, found = Ruckig(problems.axes), Trajectory(problems.axes)
    good = np.ones(problems.count, dtype=np.bool_)
    for i in range(problems.count):
        try:
            ruckig.calculate(problems.ruckig_input(i), found)
            for n in (2, 4):
                plan(problems.waypoints(i), problems.bounds(i, n), smoothness=n)
        except (RuckigError, InfeasibleError):
            good[i] = False
    return problems.pick(good)


def _calls(problems: Problems) -> dict[str, Callable[[int], object]]:
    from ruckig import Ruckig, Trajectory

    every = range(problems.count)
    inputs = [problems.ruckig_input(i) for i in every]
    points = [problems.waypoints(i) for i in every]
    bounds = {n: [problems.bounds(i, n) for i in every] for n in (2, 4)}
    ruckig, found = Ruckig(problems.axes), Trajectory(problems.axes)
    calls: dict[str, Callable[[int], object]] = {
        RUCKIG: lambda i: ruckig.calculate(inputs[i], found),
        "segfmu.plan, n = 2": lambda i: plan(points[i], bounds[2][i], smoothness=2),
        "segfmu.plan, n = 4": lambda i: plan(points[i], bounds[4][i], smoothness=4),
        RUCKIG_BUILT: lambda i: ruckig.calculate(problems.ruckig_input(i), found),
        SEGFMU_BUILT: lambda i: plan(
            problems.waypoints(i), problems.bounds(i, 4), smoothness=4
        ),
    }
    return calls
