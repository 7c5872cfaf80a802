"""Plot of an identification: measured and simulated signals, and their differences."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from segfmu.arrays import FloatArray
from segfmu.validation.identification.prediction import Prediction, told
from segfmu.validation.plots.style import COLOURS, finish, label, legend, panels_of
from segfmu.validation.units import pretty, scale_with_lengths, signal_units, with_unit

HEIGHT = 1.8
# colours and widths of measured and simulated signals and of their difference: those below show
CURVES = (("#999999", 2.2), (COLOURS[0], 1.5), (COLOURS[1], 0.8))
# times the range of a signal, beyond which its level is left out
FAR = 3.0
# characters of a title's line
LINE = 60


def plot_identification(shown: Sequence[Prediction], what: str) -> Figure:
    """A row for every measured signal, with a column for every part of a log.

    what: these parts are, in the title.
    """
    units = signal_units()
    rows = max(len(p.signals) for p in shown)
    figure, panels = panels_of(
        rows, len(shown), size=(6.0 * len(shown) + 2.0, HEIGHT * rows + 0.8)
    )
    panels = np.reshape(panels, (rows, len(shown)))
    for column, part in zip(panels.T, shown, strict=True):
        for panel, signal in zip(column, part.signals, strict=False):
            name, times = signal.signal, part.columns["time"]
            measured, simulated = (part.columns[n] for n in (name, f"simulated.{name}"))
            difference = measured - simulated
            level = _level(measured)
            drawn = np.array([measured - level, simulated - level, difference])
            own = units.get(name, "")
            factor, unit = scale_with_lengths(float(np.abs(drawn).max()), own)
            labels = ("measured", f"simulated, fit {told(signal.index)}", "difference")
            for values, (colour, width), text in zip(factor * drawn, CURVES, labels, strict=True):
                panel.plot(times, values, color=colour, linewidth=width, label=text)
            # in lines that are no longer than a panel is high
            words = name.replace("measured.", "measured\n")
            panel.set_ylabel("\n".join(filter(None, (words, _less(level, own), f"[{unit}]"))))
            legend(panel)
        column[0].set_title(label(part.log, LINE))
    finish(figure, list(panels.ravel()), (), f"Measured and simulated signals, {what}")
    for column, part in zip(panels.T, shown, strict=True):
        for panel in column[len(part.signals):]:
            panel.set_axis_off()
        column[len(part.signals) - 1].set_xlabel("time [s]")
    return figure


def _level(measured: FloatArray) -> float:
    """What a signal is shown less of, to four digits: far from 0 its changes would be flat."""
    level = float(measured.mean())
    return float(f"{level:.4g}") if abs(level) > FAR * float(np.ptp(measured)) else 0.0


def _less(level: float, unit: str) -> str:
    factor, name = scale_with_lengths(abs(level), unit)
    return f"less {with_unit(pretty(factor * level), name)}" if level else ""
