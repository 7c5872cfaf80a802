"""The report of a campaign: margins of all runs, what they depend on, the worst cases."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.summary import Summary
from segfmu.validation.campaigns.tables import CHANCE, FAILS, case, rates
from segfmu.validation.report.curves import digits
from segfmu.validation.report.page import Cell, Chart, Curve, Page, Section, Table
from segfmu.validation.report.requirements import requirement_sections
from segfmu.validation.report.suite_page import runs
from segfmu.validation.units import labelled, powers, pretty, with_unit

if TYPE_CHECKING:
    from segfmu.validation.suites import Suite

# of a distribution; points and errors that are shown
MOST_BINS, MOST_POINTS, MOST_ERRORS = 30, 1000, 50


def campaign_page(result: CampaignResult, worst: Suite | None = None) -> Page:
    """Summary, distributions of the margins, sensitivities; views of the worst runs, if given."""
    count = result.table.num_rows
    passed = sum(result.column("passed"))
    scenes, sections = runs(worst.results) if worst is not None else ([], [])
    return Page(
        title=result.name,
        kind="Campaign",
        passed=result.passed,
        verdict=f"{passed} of {count} runs passed" + (
            ", which a search chose" if result.searched else ""
        ),
        facts=_facts(result, count),
        summary=_overview(result),
        scenes=scenes,
        sections=[
            *requirement_sections(result.requirements), _distributions(result),
            *_dependence(result), *_worst(result), *sections, *_errors(result),
        ],
    )


def _facts(result: CampaignResult, count: int) -> list[tuple[str, str]]:
    return [
        ("runs", str(count)), ("runs without a verdict", str(len(result.errors))),
        ("factors", str(len(result.factors))),
        ("scenarios", str(len(set(result.column("scenario"))))),
    ]


def _overview(result: CampaignResult) -> Table:
    rows: list[tuple[Cell, ...]] = []
    columns = rates(result)
    for row in result.summaries:
        cells: dict[str, Cell] = {
            "share": (f"{100.0 * row.share:.1f} %", "good" if row.held == row.judged else "bad"),
            FAILS: "" if row.fails is None else str(row.fails),
        }
        rows.append((
            row.criterion, f"{row.held} of {row.judged}", *(cells[name] for name in columns),
            row.least, "" if row.run is None else str(row.run), _causes(result, row),
        ))
    last = "worst case" if result.searched else "depends most on"
    heads = ("criterion", "held", *columns, "least margin", "run", last)
    return Table("Criteria in all runs", heads, rows)


def _causes(result: CampaignResult, row: Summary) -> str:
    if result.searched:
        return "" if row.run is None else case(result.values(row.run))
    found = [s for s in result.sensitivities if s.criterion == row.criterion]
    return ", ".join(s.factor for s in found[:2] if s.chance < CHANCE)


def _margins(result: CampaignResult, criterion: str) -> FloatArray:
    """NaN where there is none."""
    return np.array([
        np.nan if margin is None else margin for margin in result.column(f"margin.{criterion}")
    ], dtype=np.float64)


def _distributions(result: CampaignResult) -> Section:
    charts = []
    for row in result.summaries:
        margins = _margins(result, row.criterion)
        margins = margins[np.isfinite(margins)]
        if margins.size == 0:
            continue
        counts, edges = np.histogram(margins, bins=min(MOST_BINS, 5 + margins.size // 8))
        span = float(np.ptp(edges))
        curve = Curve(row.criterion, "run", digits(edges, span), [*map(int, counts), 0])
        low, middle, high = (pretty(float(q)) for q in np.quantile(margins, (0.05, 0.5, 0.95)))
        spread = f"median {middle}, nine of ten from {low} to {high}"
        charts.append(Chart(
            row.criterion, "runs", with_unit(spread, row.unit), [curve],
            (0.0, None) if edges[0] < 0.0 else (None, None), "steps", labelled("margin", row.unit),
        ))
    text = "How many runs have which margin. Grey: the criterion does not hold."
    return Section("Distribution of the margins", text, charts=charts)


def _dependence(result: CampaignResult) -> list[Section]:
    rows, charts = [], []
    for row in result.summaries:
        found = [s for s in result.sensitivities if s.criterion == row.criterion]
        rows += [
            (s.criterion, s.factor, f"{s.effect:{'+' if s.signed else ''}.2f}",
             "correlation of ranks" if s.signed else "share of the ranks",
             "below 0.0001" if s.chance < 1e-4 else f"{s.chance:.4f}")
            for s in found
        ]
        first = next((s for s in found if s.signed and s.chance < CHANCE), None)
        if first is not None:
            charts.append(_points(result, row, first.factor, first.effect))
    if not rows:
        return []
    heads = ("criterion", "factor", "effect on the margin", "kind", "by chance")
    text = (
        "Effects beside those of all other factors: of a number from -1 to 1, of a choice from 0 "
        "to 1."
    )
    if charts:
        text += " The charts have the runs over the number with the largest effect."
    return [Section("What the margins depend on", text, charts=charts,
                    tables=[Table("Sensitivities", heads, rows)])]


def _points(result: CampaignResult, row: Summary, factor: str, effect: float) -> Chart:
    margins = _margins(result, row.criterion)
    values = np.array([np.nan if v is None else v for v in result.column(factor)], dtype=float)
    known = np.flatnonzero(np.isfinite(margins) & np.isfinite(values))
    # the worst ones are among them
    order = known[np.argsort(margins[known])]
    kept = order[np.unique(np.linspace(0, order.size - 1, MOST_POINTS).astype(int))]
    x, y = values[kept], margins[kept]
    curve = Curve("run", "run", digits(x, float(np.ptp(x))), digits(y, float(np.ptp(y))))
    return Chart(
        row.criterion, powers(row.unit), f"margin, effect {effect:+.2f}", [curve],
        (0.0, None) if y.min() < 0.0 else (None, None), "points", factor,
    )


def _worst(result: CampaignResult) -> list[Section]:
    rows = []
    for row in result.summaries:
        if row.run is not None:
            rows.append((
                row.criterion, str(row.run), row.least,
                case(result.values(row.run)),
            ))
    if not rows:
        return []
    return [Section(
        "Worst cases", "Each can be run again as a scenario of its own.",
        tables=[Table("Least margins", ("criterion", "run", "margin", "factors"), rows)],
        commands=[result.command(run) for run in result.worst_runs],
    )]


def _errors(result: CampaignResult) -> list[Section]:
    rows = [(str(run), error) for run, error in result.errors[:MOST_ERRORS]]
    if not rows:
        return []
    caption = f"the first {len(rows)} of {len(result.errors)}"
    return [Section("Runs without a verdict", tables=[Table(caption, ("run", "error"), rows)])]
