"""Sections of a co-simulated mission: load, drives, sway, tracking error."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.lib.recfunctions import rename_fields
from numpy.typing import NDArray

from segfmu.arrays import FloatArray
from segfmu.crane.bounds import DRIVES, UNITS, ActuatorBounds
from segfmu.fmu.pairs import PAIRS
from segfmu.kernels.crane.records import Demand
from segfmu.planning import Trajectory
from segfmu.planning.limits import NAMES
from segfmu.planning.limits import UNITS as LIMIT_UNITS
from segfmu.validation.criteria import angles
from segfmu.validation.drive_use import run_demands
from segfmu.validation.files.keys import AXES
from segfmu.validation.report.curves import digits, thinned
from segfmu.validation.report.page import NEAR, Chart, Curve, Section
from segfmu.validation.units import length, powers, pretty, resting, scale, ways_from_start

SAMPLES = 2000
# [m], [rad]: below these numbers are noise of the computation
NO_ERROR, NO_SWAY = 1e-9, 2e-8
AXIS_LEGEND = (("x", "x"), ("y", "y"), ("z", "z"))
RUN_LEGEND = (("run", "run"), ("plan", "plan"))
# what the run shows of a drive, in the order of the record `Demand`; the plan's columns beside it
PLANS = {
    "velocity": ("reference.bridge.velocity", "reference.trolley.velocity",
                 "reference.rope.velocity"),
    "acceleration": ("reference.bridge.acceleration", "reference.trolley.acceleration",
                     "reference.rope.acceleration"),
    "force": ("force.bridge", "force.trolley", "force.hoist"),
}
FIRST = {
    "velocity": Demand.VELOCITY, "acceleration": Demand.ACCELERATION, "force": Demand.FORCE,
    "power": Demand.POWER,
}
FOUND = (
    " The mission has no limits: these were found, so that the plan uses the bounds of the drives."
)
Rows = NDArray[np.void]


def load_section(trajectory: Trajectory, given: bool = True) -> Section:
    """The planned motion of the load and its derivatives, against their limits.

    given: whether the limits are the mission's, not those of the search within the drives' bounds.
    """
    # peaks of short ramps are at ends of pieces and between them
    ends = trajectory.events
    between = 0.5 * (ends[1:] + ends[:-1])
    times = np.linspace(0.0, trajectory.duration, SAMPLES)
    times = np.unique(np.concatenate([times, ends, between]))
    times = times[times <= trajectory.duration]
    if trajectory.duration == 0.0:
        return Section("Load against its limits", "The load rests in its place: the plan is 0 s.")
    table = trajectory.limits.sides(trajectory.axes, trajectory.smoothness)
    # for an axis that rests no limits are searched for
    known = [given or not rest for rest in resting(trajectory)]
    charts = [_position(trajectory, times)]
    for order, name in enumerate(NAMES[: min(trajectory.smoothness, 4)], 1):
        charts.append(_derivative(trajectory, times, order, name, table[..., order - 1], known))
    return Section(
        "Load against its limits",
        "The planned motion of the load. Vertical lines: arrivals at the waypoints."
        + ("" if given else FOUND),
        AXIS_LEGEND, charts,
    )


def _position(trajectory: Trajectory, times: FloatArray) -> Chart:
    ways, factor, unit = ways_from_start(trajectory, times)
    spans = (
        f"{axis} {pretty(float(low))} to {pretty(float(high))} m"
        for axis, low, high in zip(AXES, *trajectory.extrema(0), strict=True)
    )
    return Chart(
        "way from the start", unit, "; ".join(spans), curves(times, factor * ways, AXES, AXES)
    )


def _derivative(
    trajectory: Trajectory, times: FloatArray, order: int, name: str, limits: FloatArray,
    known: Sequence[bool],
) -> Chart:
    """In percent where all axes are limited; limits (2, axes) of both directions.

    known: whether limits of an axis are more than a number in its place.
    """
    unit = powers(LIMIT_UNITS[order - 1])
    low, high = trajectory.extrema(order)
    peaks = np.array([high, -low])
    limited = bool((limits > 0.0).all())
    # of each axis the direction that uses more of its limit
    used = (peaks / np.where(limits > 0.0, limits, 1.0)).argmax(axis=0)
    words = "; ".join(
        f"{axis} {pretty(float(peak))}"
        + (f" of {pretty(float(most))}" if most > 0.0 and told else "")
        for axis, peak, most, told in zip(
            AXES, *(np.take_along_axis(a, used[None], axis=0)[0] for a in (peaks, limits)), known,
            strict=True,
        )
    )
    values = trajectory(times, order)
    if limited:
        shares = 100.0 * values / np.where(values < 0.0, limits[1], limits[0])
        return Chart(
            name, "% of limit", f"peaks {words} {unit}",
            curves(times, shares, AXES, AXES, 200.0), (-100.0, 100.0),
        )
    return Chart(name, unit, f"peaks {words} {unit}", curves(times, values, AXES, AXES))


def drive_section(
    rows: Rows, bounds: ActuatorBounds, quantities: Sequence[str] = tuple(FIRST)
) -> Section:
    """Velocity, acceleration, force and power of each drive, against its bounds."""
    found = run_demands(rows)
    resting = [drive for i, drive in enumerate(DRIVES) if _rests(found, i)]
    charts = []
    for quantity in quantities:
        first = FIRST[quantity]
        for i, drive in enumerate(DRIVES):
            if drive not in resting:
                charts.append(_drive(
                    rows, found[:, first + i], bounds.table[:, first + i], quantity, i, drive
                ))
    text = (
        "What the run asked of each drive, and what was planned. Grey: beyond the bound. The pull "
        "of the hoist is positive; so is its velocity when the rope gets longer."
    )
    if resting:
        text += f" {' and '.join(resting).capitalize()}: at rest and without force."
    return Section(
        "Drives against their bounds", text, RUN_LEGEND, charts,
        columns=len(DRIVES) - len(resting),
    )


def _rests(found: FloatArray, i: int) -> bool:
    """Whether a drive neither moves nor pushes."""
    used = (found[:, Demand.VELOCITY + i], found[:, Demand.FORCE + i])
    weight = float(np.abs(found[:, Demand.FORCE: Demand.VELOCITY]).max())
    return bool(np.abs(used[0]).max() < NO_ERROR and np.abs(used[1]).max() <= NO_ERROR * weight)


def _drive(
    rows: Rows, values: FloatArray, bounds: FloatArray, quantity: str, i: int, drive: str
) -> Chart:
    """bounds: of the positive and the negative direction."""
    planned = rows[PLANS[quantity][i]] if quantity in PLANS else \
        rows[PLANS["force"][i]] * rows[PLANS["velocity"][i]]
    pulls = quantity == "force" and drive == "hoist"
    if pulls:
        values, planned, bounds = -values, -planned, bounds[::-1]
    peaks = np.array([values.max(), -values.min()])
    # the direction that uses more of its bound; without bounds the larger peak
    known = bool(np.isfinite(bounds).any())
    side = int((peaks / bounds if known else peaks).argmax())
    peak, bound = float(peaks[side]), float(bounds[side])
    largest = float(bounds[np.isfinite(bounds)].max()) if known else 0.0
    factor, unit = scale(max(float(peaks.max()), largest), UNITS[quantity])
    words = f"peak {pretty(factor * peak)} {unit}"
    if known:
        words += f", {pretty(100.0 * peak / bound)} % of {pretty(factor * bound)} {unit}"
    near = known and peak >= NEAR * bound
    shown = np.column_stack([values, planned]) * factor
    limits: tuple[float | None, float | None] = (None, None)
    if near:
        least, most = (
            factor * b if np.isfinite(b) else None for b in (-float(bounds[1]), float(bounds[0]))
        )
        limits = (0.0 if pulls else least, most)
    return Chart(
        f"{drive}, {quantity}", unit, words,
        curves(rows["time"], shown, ("run", "plan"), ("run", "plan"),
               2.0 * factor * largest if near else 0.0),
        limits,
    )


def sway_section(rows: Rows, bounds: ActuatorBounds) -> Section:
    """Sway about both axes, of the rope and of a sling, as planned and as it was."""
    charts = []
    most = dict(zip(("sway.x.angle", "sway.y.angle"), bounds.sway_angle, strict=True))
    for signal in angles(rows):
        part, axis, _ = signal.split(".")
        values = np.column_stack([
            np.degrees(rows[f"{name}{signal}"]) for name in ("", "reference.")
        ])
        peak = float(np.abs(values[:, 0]).max())
        bound = float(np.degrees(most.get(signal, np.inf)))
        known = bool(np.isfinite(bound))
        words = f"peak {pretty(peak)} deg" + (f" of {pretty(bound)} deg" if known else "")
        near = known and peak >= NEAR * bound
        charts.append(Chart(
            f"{part} along {axis}", "deg", words,
            curves(rows["time"], values, ("run", "plan"), ("run", "plan"),
                   max(2.0 * bound if near else 0.0, np.degrees(NO_SWAY))),
            (-bound, bound) if near else (None, None),
        ))
    return Section("Sway", "", RUN_LEGEND, charts)


def error_section(rows: Rows) -> Section:
    """Where the load is away from its plan; noise of the computation is only said."""
    values = np.column_stack([rows[f"error.load.{axis}"] for axis in AXES])
    largest = float(rows["error.load.norm"].max())
    if largest < NO_ERROR:
        return Section(
            "Tracking error", "The load is on its plan: the distance is below 1e-6 mm throughout."
        )
    factor, unit = length(largest)
    at = float(rows["time"][int(rows["error.load.norm"].argmax())])
    words = f"largest distance {pretty(factor * largest)} {unit} at {at:.3f} s"
    chart = Chart("load less plan", unit, words,
                  curves(rows["time"], factor * values, AXES, AXES))
    return Section("Tracking error", "", AXIS_LEGEND, [chart], wide=True)


def curves(
    times: FloatArray, values: FloatArray, names: tuple[str, ...], roles: tuple[str, ...],
    height: float = 0.0,
) -> list[Curve]:
    """Curves of columns, thinned to what a chart of at least this height shows."""
    known = values[np.isfinite(values)]
    own = float(np.ptp(known)) if known.size else 0.0
    size = float(np.abs(known).max()) if known.size else 0.0
    most = max(own, height, 1e-12 * max(1.0, size))
    found = []
    for column, name, role in zip(values.T, names, roles, strict=True):
        x, y = thinned(times, np.asarray(column, dtype=np.float64), most)
        found.append(Curve(name, role, digits(x, float(np.ptp(times))), digits(y, most)))
    return found


def owned(rows: Rows) -> Rows:
    """Rows in which the variables of both FMUs have their names, whatever others are called."""
    names = rows.dtype.names or ()
    changed: dict[str, str] = {}
    for fmu in (name for pair in PAIRS for name in reversed(pair.names)):
        for name in names:
            bare = name.removeprefix(f"{fmu}.")
            if bare != name and bare not in names and bare not in changed.values():
                changed[name] = bare
    renamed: Rows = rename_fields(rows, changed) if changed else rows
    return renamed


def arrivals(rows: Rows, end: float) -> list[float]:
    """Times at which the load is at the waypoints [s], from the rows of a run.

    A run without a planner's FMU tells the start and the end alone.
    """
    if "plan.interval" not in (rows.dtype.names or ()):
        return [0.0, round(end, 4)]
    jumps = np.flatnonzero(np.diff(rows["plan.interval"].astype(int)) > 0) + 1
    return [0.0, *(round(float(rows["time"][i]), 4) for i in jumps), round(end, 4)]
