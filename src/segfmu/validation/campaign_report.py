"""Tables of the campaign for the terminal."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite, isnan

from rich.table import Table

from segfmu.validation.campaign import Outcome
from segfmu.validation.verdict import ERROR_FACTOR, SWAY_FACTOR, Comparison

COLUMNS = ("T \\[s]", "RMS \\[mm]", "peak \\[mm]", "sway \\[deg]", "rest \\[s]", "F \\[N]")

# larger ratios are shown as "> this"
LARGEST_FACTOR = 1000.0


def outcome_table(mode: str, outcomes: Sequence[Outcome]) -> Table:
    """Every metric of one mode of the drives: duration, errors, sway, settling, peak force."""
    table = Table(title=f"{mode} mode", header_style="bold")
    table.add_column("", no_wrap=True)
    for column in COLUMNS:
        table.add_column(column, justify="right")
    chosen = [o for o in outcomes if o.mode == mode]
    for name in dict.fromkeys(o.disturbance for o in chosen):
        table.add_section()
        table.add_row(f"[bold]{name}[/]")
        for o in (o for o in chosen if o.disturbance == name):
            table.add_row(f"  {o.method}", *_cells(o))
    return table


def _cells(o: Outcome) -> list[str]:
    if o.failure:
        return [f"{o.duration:.2f}", "[red]failed[/]", "", "", "", ""]
    force = max(o.peak_force_bridge, o.peak_force_trolley)
    settled = f"{o.settling_time:.2f}" if isfinite(o.settling_time) else "-"
    return [
        f"{o.duration:.2f}", f"{1e3 * o.rms_error:.3f}", f"{1e3 * o.peak_error:.1f}",
        f"{o.residual_sway:.4f}", settled, f"{force:.1f}",
    ]


def verdict_table(comparisons: Iterable[Comparison]) -> Table:
    """Gain by the feedback, and the verdict."""
    table = Table(
        title=f"feedback against feedforward alone; demanded: {ERROR_FACTOR:g}x in RMS error, "
        f"{SWAY_FACTOR:g}x in residual sway, and worse nowhere",
        header_style="bold",
    )
    for column in ("mode", "disturbance", "feedback"):
        table.add_column(column)
    for column in ("RMS", "sway"):
        table.add_column(column, justify="right")
    table.add_column("verdict", no_wrap=True)
    for c in comparisons:
        table.add_row(
            c.mode, c.disturbance, c.method.removeprefix("feedforward + "),
            factor(c.error_ratio), factor(c.sway_ratio), _word(c),
        )
    return table


def factor(ratio: float) -> str:
    """A ratio as text; - if there is nothing to gain."""
    if isnan(ratio):
        return "-"
    if ratio > LARGEST_FACTOR:
        return f"> {LARGEST_FACTOR:g}x" if isfinite(ratio) else "fails alone"
    return f"{ratio:.2f}x" if ratio < 10.0 else f"{ratio:.0f}x"


def _word(c: Comparison) -> str:
    if c.worse:
        return "[red]worse[/]"
    if not c.demanded:
        return "[green]not worse[/]"
    return "[green]reached[/]" if c.reached else "[red]missed[/]"
