"""The report of a mission that was co-simulated."""

from __future__ import annotations

from dataclasses import replace
from math import inf, isfinite
from typing import TYPE_CHECKING

from segfmu.crane import ActuatorBounds
from segfmu.planning import Trajectory
from segfmu.validation.criteria import Criteria, Row
from segfmu.validation.files.crane_models import model_of, table_of
from segfmu.validation.report.motion import (
    drive_section,
    error_section,
    load_section,
    sway_section,
)
from segfmu.validation.report.page import Cell, Page, Section, Table
from segfmu.validation.report.scene import scene
from segfmu.validation.units import pretty, scale, shown

if TYPE_CHECKING:
    from segfmu.validation.runs import Run


def run_page(run: Run) -> Page:
    """Verdict, view, load, drives, sway, error and what was run."""
    mission, trajectory, rows = run.mission, run.trajectory, run.rows
    bounds = mission.build_bounds() or ActuatorBounds()
    times = [round(float(time), 4) for time in trajectory.waypoint_times]
    load = [load_section(trajectory, mission.limits is not None)]
    kind, duration = "Co-simulated mission", "planned duration"
    if run.commands is not None:
        # in place of the plan, so that the load does not go to its waypoints
        times, load = [], []
        kind, duration = "Co-simulated mission under commands", "at rest from"
    return Page(
        title=mission.name,
        kind=kind,
        passed=run.passed,
        verdict="passed" if run.passed else "failed",
        facts=_facts(run.criteria, duration),
        summary=_verdicts(run.criteria),
        scenes=[scene(mission, rows, mission.name)],
        sections=[
            *(replace(part, scene=0, arrivals=times, end=float(rows["time"][-1])) for part in (
                *load, drive_section(rows, bounds), sway_section(rows, bounds),
                error_section(rows),
            )),
            _task(run),
        ],
    )


def _facts(found: Criteria, duration: str) -> list[tuple[str, str]]:
    error, sway = found.rows[:2]
    facts = [
        (duration, f"{found.duration:.3f} s"),
        (error.name, error.measured), (sway.name, sway.measured),
    ]
    used = [use for use in found.uses if isfinite(use.bound)]
    if used:
        most = max(used, key=lambda use: use.use)
        facts.append((f"greatest use: {most.name}", f"{100.0 * most.use:.1f} %"))
    return facts


def _verdicts(found: Criteria) -> Table:
    rows: list[tuple[Cell, ...]] = [
        (
            row.name, row.measured, f"{pretty(row.allowed)} {row.unit}", _share(row), _word(row),
            row.key,
        )
        for row in found.rows if row.unit != "%"
    ]
    used = [row for row in found.rows if row.unit == "%"]
    known = [use for use in found.uses if isfinite(use.bound)]
    for use, row in zip(known, used, strict=True):
        (peak, bound), unit = shown((use.peak, use.bound), use.unit)
        rows.append((
            use.name, f"{pretty(peak)} {unit} ({row.value:.1f} %)",
            f"{row.allowed:.0f} % of {pretty(bound)} {unit}", _share(row), _word(row),
            "crane or actuators",
        ))
    heads = ("measure", "value", "allowed", "margin", "verdict", "set by")
    return Table("Verdict", heads, rows)


def _share(row: Row) -> str:
    """The margin, and its share of what is allowed where that tells something."""
    share = 1.0 - row.value / row.allowed if row.allowed else -inf
    percent = f"{100.0 * share:.1f} %"
    if row.unit == "%":
        return percent
    margin = f"{pretty(row.allowed - row.value)} {row.unit}"
    return f"{margin} ({percent})" if abs(share) <= 1.0 else margin


def _word(row: Row) -> Cell:
    return ("passed", "good") if row.passed else ("failed", "bad")


def _task(run: Run) -> Section:
    """Waypoints, the crane, and how to run this again."""
    mission = run.mission
    crane = mission.simulated
    parts = [("bridge", crane.bridge_mass), ("trolley", crane.trolley_mass)]
    parts += [("load", crane.payload_mass)]
    model = model_of(crane)
    masses = [(name, crane_mass(mass)) for name, mass in parts]
    for name, key, unit in model.parts:
        value = getattr(table_of(model, crane), key)
        masses.append((name, crane_mass(value) if unit == "kg" else f"{pretty(value)} {unit}"))
    plan = [
        ("smoothness", str(mission.smoothness)), ("shape of the ramps", mission.shape),
        ("communication step", f"{mission.simulation.step:g} s"),
        ("drives follow", f"{mission.simulation.drive or crane.drive} setpoints"),
    ]
    if run.commands is not None:
        plan.append(("commands", run.commands.name))
    tables = [Table("Crane and run", ("", ""), [*masses, *plan])]
    if run.commands is None:
        tables.insert(0, _waypoints(run.trajectory))
    return Section("What was run", tables=tables, commands=[run.again] if run.again else [])


def _waypoints(trajectory: Trajectory) -> Table:
    rows = [
        (str(i), f"{time:.3f}", *(pretty(float(p)) for p in point.position))
        for i, (time, point) in enumerate(
            zip(trajectory.waypoint_times, trajectory.waypoints, strict=True), 1
        )
    ]
    return Table("Waypoints", ("waypoint", "arrival [s]", "x [m]", "y [m]", "z [m]"), rows)


def crane_mass(mass: float) -> str:
    """A mass in kg or t."""
    factor, unit = scale(mass, "kg")
    return f"{pretty(factor * mass)} {unit}"
