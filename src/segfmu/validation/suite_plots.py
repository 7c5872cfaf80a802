"""The margins of a suite of scenarios as a figure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from segfmu.validation.plots.style import COLOURS, label, panels_of
from segfmu.validation.scenario_result import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# %; larger margins are drawn at the edge
MOST = 100.0
# characters of a line beside the panel; inches of a line, and of the space between two names
LINE, HIGH, SPACE = 60, 0.14, 0.08


def plot_margins(results: Sequence[Result]) -> Figure:
    """The margin of every criterion as a share of its bound; left of the line it does not hold."""
    entries = [
        (label(f"{result.scenario.file.name}: {finding.name}", LINE), 100.0 * finding.normalised)
        for result in results for finding in result.findings if finding.normalised is not None
    ]
    lines = max((name.count("\n") + 1 for name, _ in entries), default=1)
    figure, panel = panels_of(size=(9, 1.2 + (HIGH * lines + SPACE) * max(len(entries), 1)))
    for place, (_, share) in enumerate(reversed(entries)):
        held = share >= 0.0
        panel.plot(
            [0.0, max(-MOST, min(MOST, share))], [place, place],
            color=COLOURS[0] if held else COLOURS[1], marker="o" if held else "X", markevery=[1],
        )
    panel.axvline(0.0, color="#444444", linewidth=1.0)
    panel.set_yticks(range(len(entries)), [name for name, _ in reversed(entries)], fontsize=8)
    panel.set_xlim(-1.05 * MOST, 1.05 * MOST)
    beyond = any(abs(share) > MOST for _, share in entries)
    edge = f"; beyond {MOST:.0f} % at the edge" if beyond else ""
    panel.set_xlabel(f"margin [% of the bound]; cross: does not hold{edge}")
    panel.grid(True, axis="x", color="#eeeeee")
    return figure
