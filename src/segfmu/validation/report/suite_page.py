"""The report of a suite of scenarios."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from shlex import quote
from typing import TYPE_CHECKING, Any

from segfmu.crane import ActuatorBounds
from segfmu.validation.report.motion import (
    Rows,
    arrivals,
    drive_section,
    error_section,
    owned,
    sway_section,
)
from segfmu.validation.report.page import Cell, Page, Section, Table
from segfmu.validation.report.requirements import requirement_sections
from segfmu.validation.report.scene import scene
from segfmu.validation.requirements import of_results
from segfmu.validation.units import pretty, with_unit

if TYPE_CHECKING:
    from segfmu.validation.scenario_result import Result
    from segfmu.validation.suites import Suite

# of curves in one file, so that it can be sent by mail; scenarios with the least margins first
MOST_POINTS = 50_000
FRAMES = 150
QUANTITIES = ("force",)


def suite_page(suite: Suite) -> Page:
    """All criteria with their margins, then the runs, those with the least margins first."""
    ordered = sorted(suite.results, key=_badness)
    scenes, sections = runs(ordered)
    right = sum(result.right for result in suite)
    return Page(
        title="Suite of scenarios" if len(suite) != 1 else suite.results[0].scenario.file.name,
        kind="Scenarios as co-simulations",
        passed=suite.passed,
        verdict="as expected" if suite.passed else "not as expected",
        facts=_facts(suite, right),
        summary=_overview(ordered),
        scenes=scenes,
        sections=[
            *requirement_sections(of_results(suite.results)),
            Section("Criteria", tables=[_criteria(ordered)]), *sections,
        ],
    )


def runs(results: Sequence[Result]) -> tuple[list[dict[str, Any]], list[Section]]:
    """Views and curves of runs, as many as one file should have."""
    sections: list[Section] = []
    scenes: list[dict[str, Any]] = []
    left = MOST_POINTS
    for result in results:
        if result.rows is None or left < 0:
            sections.append(_without_run(result))
            continue
        rows, own = owned(result.rows), result.scenario
        section = _details(result, rows, len(scenes))
        scenes.append(scene(own.mission, rows, own.file.name, FRAMES))
        left -= sum(len(curve.x) for chart in section.charts for curve in chart.curves)
        sections.append(section)
    return scenes, sections


def _badness(result: Result) -> tuple[bool, bool, float]:
    """Those that went otherwise than expected first, then failed ones, then by margin."""
    return result.right, result.passed, _least(result)


def _least(result: Result) -> float:
    """The least margin over its bound; infinite without one."""
    shares = [f.normalised for f in result.findings if f.normalised is not None]
    return -inf if result.error else min(shares, default=inf)


def _facts(suite: Suite, right: int) -> list[tuple[str, str]]:
    criteria = [finding for result in suite for finding in result.findings]
    facts = [
        ("scenarios as expected", f"{right} of {len(suite)}"),
        ("criteria that hold", f"{sum(f.passed for f in criteria)} of {len(criteria)}"),
    ]
    least = min((_least(result) for result in suite if result.passed), default=inf)
    if least < inf:
        facts.append(("least margin of those that pass", f"{percent(least)} of the bound"))
    return facts


def _verdict(passed: bool, result: Result) -> Cell:
    if passed:
        return "passed", "good"
    return ("failed, as expected", "soft") if result.right else ("failed", "bad")


def percent(share: float) -> str:
    """A margin as a share of its bound, with a sign unless it is zero."""
    digits = 0 if abs(share) >= 10.0 else 1
    return "0.0 %" if abs(share) < 5e-4 else f"{100.0 * share:+,.{digits}f} %"


def _overview(results: list[Result]) -> Table:
    rows = []
    for result in results:
        least = _least(result)
        share: Cell = ("", "") if abs(least) == inf else (percent(least), "margin")
        rows.append((
            result.scenario.file.name, result.scenario.file.expect, share,
            _verdict(result.passed, result),
        ))
    return Table("Scenarios", ("scenario", "expected", "least margin", "verdict"), rows)


def _criteria(results: list[Result]) -> Table:
    rows = []
    for result in results:
        for found in result.findings:
            share = found.normalised
            rows.append((
                result.scenario.file.name, found.name, found.signal, *(
                    (with_unit(pretty(value), found.unit), "number")
                    for value in (found.bound, found.margin)
                ),
                ("", "") if share is None else (percent(share), "margin"),
                _verdict(found.passed, result),
            ))
    heads = ("scenario", "criterion", "signal", "bound", "margin", "of the bound", "verdict")
    return Table("All criteria", heads, rows)


def _details(result: Result, rows: Rows, number: int) -> Section:
    mission = result.scenario.mission
    bounds = mission.build_bounds() or ActuatorBounds()
    error = error_section(rows)
    return Section(
        result.scenario.file.name, error.text or "Load less plan, sway, and forces of the drives.",
        (*error.legend, ("run", "run: sway, forces"), ("plan", "plan")),
        [
            *error.charts, *sway_section(rows, bounds).charts,
            *drive_section(rows, bounds, QUANTITIES).charts,
        ],
        commands=[_again(result)], folded=result.right, scene=number,
        arrivals=arrivals(rows, result.known["arrival"]), end=float(rows["time"][-1]),
    )


def _without_run(result: Result) -> Section:
    text = result.error or "Not drawn, to keep the file small: its margins are larger."
    return Section(
        result.scenario.file.name, text, commands=[_again(result)], folded=result.right
    )


def _again(result: Result) -> str:
    return f"segfmu validate {quote(str(result.scenario.path))}"
