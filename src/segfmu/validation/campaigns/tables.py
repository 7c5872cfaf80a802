"""A campaign on the terminal."""

from __future__ import annotations

from rich.markup import escape
from rich.table import Table

from segfmu.validation.campaigns.result import CampaignResult

# of the factors of a criterion
MOST_SHOWN = 2
# an effect that chance alone makes in more than one of a hundred is not shown
CHANCE = 0.01


def criteria_table(result: CampaignResult) -> Table:
    """Every criterion: how many runs passed, the worst margin and its run, what it depends on."""
    table = Table(title=escape(result.name))
    for name in ("criterion", "held", "share", "fails (95 %)", "margin", "run", "depends on"):
        left = name in ("criterion", "depends on")
        # a number without its unit on the next line is misread
        table.add_column(
            name, justify="left" if left else "right", no_wrap=not left, min_width=9 if left else 0
        )
    for row in result.summaries:
        worst = "" if row.worst is None else f"{row.worst:+.4g}"
        verdict = "green" if row.judged and row.held == row.judged else "red"
        table.add_row(
            escape(row.criterion), f"{row.held} of {row.judged}",
            f"[{verdict}]{100.0 * row.share:.1f} %[/]",
            "" if row.fails is None else str(row.fails), worst,
            "" if row.run is None else str(row.run), _causes(result, row.criterion),
        )
    return table


def _causes(result: CampaignResult, criterion: str) -> str:
    found = [
        s for s in result.sensitivities if s.criterion == criterion and s.chance < CHANCE
    ]
    return ", ".join(
        f"{escape(s.factor)} {s.effect:{'+' if s.signed else ''}.2f}" for s in found[:MOST_SHOWN]
    )
