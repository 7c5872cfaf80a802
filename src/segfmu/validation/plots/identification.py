"""Plot of an identification: measured and simulated signals, and their differences."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from segfmu.validation.identification.prediction import Prediction, told
from segfmu.validation.plots.style import COLOURS, finish, label, legend, panels_of
from segfmu.validation.units import scale, signal_units

HEIGHT = 1.8
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
            factor, unit = scale(float(np.abs(measured).max()), units.get(name, ""))
            panel.plot(times, factor * measured, color="#999999", label="measured")
            panel.plot(
                times, factor * simulated, color=COLOURS[0],
                label=f"simulated, fit {told(signal.index)}",
            )
            panel.plot(
                times, factor * (measured - simulated), color=COLOURS[1], label="difference"
            )
            # in lines that are no longer than a panel is high
            words = name.replace("measured.", "measured\n")
            panel.set_ylabel(f"{words}\n[{unit}]")
            legend(panel)
        column[0].set_title(label(part.log, LINE))
    finish(figure, list(panels.ravel()), (), f"Measured and simulated signals, {what}")
    for column, part in zip(panels.T, shown, strict=True):
        for panel in column[len(part.signals):]:
            panel.set_axis_off()
        column[len(part.signals) - 1].set_xlabel("time [s]")
    return figure
