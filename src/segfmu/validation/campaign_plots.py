"""Plots of the campaign (PNG): outcomes, move times, eigenvalues."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm, Normalize, TwoSlopeNorm
from matplotlib.figure import Figure
from numpy.typing import NDArray

from segfmu.planning.arrays import FloatArray
from segfmu.validation.campaign import Outcome
from segfmu.validation.maps import DESIGNS
from segfmu.validation.methods import MODES
from segfmu.validation.plots.style import panels_of
from segfmu.validation.verdict import SMALL_ERROR, SMALL_SWAY

FAILED = "#d0d0d0"

# map of move times [%]: where the colours end, and contours
STRONGEST = 30.0
LEVELS = (-40, -30, -20, -10, -5, 0, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 40)
QUANTITIES = (
    ("rms_error", "RMS tracking error [mm]", 1e3, (1e3 * SMALL_ERROR, 200.0)),
    ("residual_sway", "residual sway [deg]", 1.0, (SMALL_SWAY, 10.0)),
)


def plot_outcomes(outcomes: Sequence[Outcome], mode: str, title: str) -> Figure:
    """RMS tracking error and residual sway of one mode: disturbances down, methods across."""
    chosen = [o for o in outcomes if o.mode == mode]
    rows = list(dict.fromkeys(o.disturbance for o in chosen))
    columns = list(dict.fromkeys(o.method for o in chosen))
    figure, panels = panels_of(1, 2, size=(13, 1.6 + 0.42 * len(rows)), sharey=True)
    for panel, (name, label, scale, span) in zip(panels, QUANTITIES, strict=True):
        values = np.full((len(rows), len(columns)), np.nan)
        for o in chosen:
            values[rows.index(o.disturbance), columns.index(o.method)] = scale * getattr(o, name)
        _cells(panel, values, span)
        panel.set_title(label, fontsize=10)
        wrapped = [c.replace(" + ", "\n+ ").replace("no control", "no\ncontrol") for c in columns]
        panel.set_xticks(range(len(columns)), wrapped, fontsize=8)
    panels[0].set_yticks(range(len(rows)), rows, fontsize=9)
    figure.suptitle(f"{title}, {mode} mode", fontsize=11, parse_math=False)
    return figure


def _cells(panel: Axes, values: FloatArray, span: tuple[float, float]) -> None:
    shades = colormaps["RdYlGn_r"].with_extremes(bad=FAILED)
    panel.imshow(
        np.ma.masked_invalid(np.clip(values, *span)), norm=LogNorm(*span), cmap=shades,
        aspect="auto", alpha=0.75,
    )
    for (row, column), value in np.ndenumerate(values):
        text = "failed" if np.isnan(value) else _number(value)
        panel.text(column, row, text, ha="center", va="center", fontsize=8)
    panel.tick_params(length=0)
    for side in panel.spines.values():
        side.set_visible(False)


def _number(value: float) -> str:
    return "0" if value < 5e-4 else f"{value:.3f}" if value < 1.0 else f"{value:.3g}"


def plot_move_times(rows: NDArray[np.void], limits: tuple[float, float]) -> Figure:
    """Time saved against ZV and ZVD by the plan, tuned for each move and with one setting."""
    heights, distances = np.unique(rows["height"]), np.unique(rows["distance"])
    figure, panels = panels_of(2, 2, size=(11, 8), sharex=True, sharey=True)
    gains = {
        (plan, shaper): 100.0 * (1.0 - rows[plan] / rows[shaper])
        for plan in ("plan", "fixed") for shaper in ("zv", "zvd")
    }
    norm = TwoSlopeNorm(0.0, -STRONGEST, STRONGEST)
    mesh: Any = None
    for panel, ((plan, shaper), gain) in zip(panels.ravel(), gains.items(), strict=True):
        table = gain.reshape(heights.size, distances.size)
        mesh = panel.pcolormesh(
            distances, heights, table, norm=norm, cmap="RdBu", shading="gouraud"
        )
        _contours(panel, distances, heights, table)
        tuned = "jerk and snap tuned per move" if plan == "plan" else "one jerk and snap for all"
        panel.set_title(f"plan against {shaper.upper()}; {tuned}", fontsize=10)
    for panel in panels[-1]:
        panel.set_xlabel("distance [m]")
    for panel in panels[:, 0]:
        panel.set_ylabel("rope length [m]")
    figure.colorbar(
        mesh, ax=panels, extend="both",
        label="move time saved by the plan [%]; red: the shaper is faster",
    )
    velocity, acceleration = limits
    figure.suptitle(
        f"move time without residual sway; carriage within {velocity:g} m/s, {acceleration:g} m/s²",
        fontsize=11,
    )
    return figure


def _contours(panel: Axes, x: FloatArray, y: FloatArray, table: FloatArray) -> None:
    levels = [level for level in LEVELS if table.min() < level < table.max()]
    if levels:
        widths = [1.6 if level == 0.0 else 0.5 for level in levels]
        lines = panel.contour(x, y, table, levels=levels, colors="black", linewidths=widths)
        panel.clabel(lines, fmt="%.0f %%", fontsize=7)


def plot_eigenvalues(rows: NDArray[np.void], payload: float) -> Figure:
    """Largest eigenvalue magnitude over rope length and payload, for both modes and designs."""
    lengths, payloads = np.unique(rows["length"]), np.unique(rows["payload"])
    figure, panels = panels_of(2, 2, size=(11, 8), sharex=True, sharey=True)
    norm = Normalize(float(rows["eigenvalue"].min()), max(1.0, float(rows["eigenvalue"].max())))
    mesh: Any = None
    for row, mode in enumerate(MODES):
        for column, design in enumerate(DESIGNS):
            chosen = (rows["driven"] == (mode == "velocity")) & (rows["design"] == column)
            table = rows["eigenvalue"][chosen].reshape(lengths.size, payloads.size).T
            panel = panels[row, column]
            mesh = panel.pcolormesh(
                lengths, payloads / payload, table, norm=norm, cmap="viridis", shading="gouraud"
            )
            if np.ptp(table) > 1e-6:
                lines = panel.contour(
                    lengths, payloads / payload, table, levels=6, colors="white", linewidths=0.6
                )
                panel.clabel(lines, fmt="%.4f", fontsize=7)
            else:
                panel.text(
                    0.5, 0.5, f"{table.max():.4f} everywhere", ha="center",
                    transform=panel.transAxes,
                )
            panel.set_title(f"{mode} mode, {design}; largest {table.max():.4f}", fontsize=10)
    for panel in panels[-1]:
        panel.set_xlabel("rope length [m]")
    for panel in panels[:, 0]:
        panel.set_ylabel("payload / nominal")
    figure.colorbar(mesh, ax=panels, label="largest eigenvalue magnitude of the sampled loop")
    figure.suptitle("closed loop, stable below 1", fontsize=11)
    return figure
