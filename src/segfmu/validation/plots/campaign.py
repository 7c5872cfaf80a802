"""Plot of a campaign: margins of every criterion, and what they depend on most."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from segfmu.validation.plots.style import COLOURS, apart, grid, label, panels_of
from segfmu.validation.units import labelled

if TYPE_CHECKING:
    from segfmu.validation.campaigns.result import CampaignResult

BINS = 30
HEIGHT, WIDTH = 2.6, 10.0
# characters of a line below a panel
LINE = 45


def plot_campaign(result: CampaignResult) -> Figure:
    """A row for every criterion: how many runs have which margin, and the margin over a factor.

    The factor is the number on which it depends most. Grey: the criterion does not hold.
    """
    shown = [(name, margins) for name in result.criteria if (margins := _margins(result, name))]
    rows = max(len(shown), 1)
    figure, panels = panels_of(rows, 2, size=(WIDTH, HEIGHT * rows + 0.6))
    for (name, margins), (left, right) in zip(shown, np.reshape(panels, (rows, 2)), strict=False):
        values, unit = np.array(list(margins.values())), result.units.get(name, "")
        left.hist(values, bins=BINS, color=COLOURS[0], zorder=2)
        left.locator_params(axis="y", integer=True)
        left.set(xlabel=label(labelled(f"margin of {name}", unit), LINE), ylabel="runs")
        if values.min() < 0.0:
            left.axvspan(min(values.min(), 0.0), 0.0, color="#888888", alpha=0.25, linewidth=0.0)
        apart(left)
        grid(left)
        factor = _factor(result, name)
        if factor is None:
            right.set_axis_off()
            continue
        known = dict(zip(result.column("run"), result.column(factor), strict=True))
        places = [known[run] for run in margins]
        right.plot(places, values, ".", color=COLOURS[0], markersize=3)
        right.axhline(0.0, color="#888888", linewidth=0.8)
        right.set(xlabel=label(factor, LINE), ylabel=labelled("margin", unit))
        apart(right)
        grid(right)
    figure.suptitle(label(result.name))
    return figure


def _margins(result: CampaignResult, criterion: str) -> dict[int, float]:
    """Margins that are numbers, by their runs."""
    pairs = zip(result.column("run"), result.column(f"margin.{criterion}"), strict=True)
    return {run: m for run, m in pairs if m is not None and np.isfinite(m)}


def _factor(result: CampaignResult, criterion: str) -> str | None:
    own = [s for s in result.sensitivities if s.criterion == criterion and s.signed]
    return own[0].factor if own else None
