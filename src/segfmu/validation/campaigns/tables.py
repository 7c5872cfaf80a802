"""A campaign on the terminal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rich.markup import escape
from rich.table import Table

from segfmu.validation.campaigns.result import CampaignResult
from segfmu.validation.campaigns.summary import Summary
from segfmu.validation.units import pretty, with_unit

FAILS = "fails (95 %)"
# of the factors of a criterion
MOST_SHOWN = 2
# an effect that chance alone makes in more than one of a hundred is not shown
CHANCE = 0.01


def criteria_table(result: CampaignResult) -> Table:
    """Every criterion: how many runs passed, the worst margin and its run, what it depends on.

    Of a search the worst case itself: how often its runs fail says nothing of other runs; one for
    rare failures tells their probability.
    """
    # no space beside the lines: with it, 80 characters have no room for the last column
    table = Table(title=escape(result.name), padding=0)
    counts = ("held", *rates(result))
    last = "worst case" if result.searched else "depends on"
    for name in ("criterion", *counts, "margin", "run", last):
        left = name in ("criterion", last)
        # a number without its unit on the next line is misread
        table.add_column(
            name, justify="left" if left else "right", no_wrap=not left, min_width=9 if left else 0
        )
    for row in result.summaries:
        worst = "" if row.worst is None else with_unit(f"{row.worst:+.4g}", row.unit)
        verdict = "green" if row.judged and row.held == row.judged else "red"
        cells = {
            "held": f"{row.held} of {row.judged}",
            "share": f"[{verdict}]{100.0 * row.share:.1f} %[/]",
            FAILS: "" if row.fails is None else str(row.fails),
        }
        table.add_row(
            escape(row.criterion), *(cells[name] for name in counts), worst,
            "" if row.run is None else str(row.run), _causes(result, row),
        )
    return table


def rates(result: CampaignResult) -> tuple[str, ...]:
    """Columns that tell how often criteria hold and fail, of which something is known."""
    known = any(row.fails is not None for row in result.summaries)
    return (*(() if result.searched else ("share",)), *((FAILS,) if known else ()))


def case(values: Mapping[str, Any]) -> str:
    """Values of factors in words."""
    return ", ".join(f"{name} {_shown(value)}" for name, value in values.items())


def _shown(value: Any) -> str:
    number = isinstance(value, int | float) and not isinstance(value, bool)
    return pretty(float(value)) if number else str(value)


def _causes(result: CampaignResult, row: Summary) -> str:
    if result.searched:
        return "" if row.run is None else escape(case(result.values(row.run)))
    found = [
        s for s in result.sensitivities if s.criterion == row.criterion and s.chance < CHANCE
    ]
    return ", ".join(
        f"{escape(s.factor)} {s.effect:{'+' if s.signed else ''}.2f}" for s in found[:MOST_SHOWN]
    )
