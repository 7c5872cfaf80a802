"""Tables of an identification for the terminal."""

from __future__ import annotations

from rich.markup import escape
from rich.table import Table

from segfmu.validation.identification.prediction import Prediction, told
from segfmu.validation.identification.result import Identification
from segfmu.validation.units import pretty, scale_with_lengths, signal_units


def estimates_table(found: Identification) -> Table:
    """Every parameter that is told, with its interval, beside what the crane file had."""
    table = Table(title=escape(found.nominal.name))
    for name in ("parameter", "unit", "was", "is", "95 %"):
        table.add_column(name, justify="left" if name in ("parameter", "unit") else "right")
    for one in found.estimates:
        interval = f"{pretty(one.low)} to {pretty(one.high)}"
        table.add_row(one.key, one.unit, pretty(one.before), pretty(one.rounded), interval)
    return table


def predictions_table(title: str, part: Prediction) -> Table:
    """Every signal's fit and residuals, and the fit of the load's path."""
    # no space beside the lines: with it, 80 characters have no room for the names of signals
    table = Table(title=escape(title), padding=0)
    for name in ("signal", "fit", "rms", "largest", "unit", "samples of one"):
        table.add_column(name, justify="left" if name in ("signal", "unit") else "right")
    units = signal_units()
    for one in part.signals:
        factor, unit = scale_with_lengths(one.largest, units.get(one.signal, ""))
        table.add_row(
            one.signal, told(one.index), pretty(factor * one.deviation),
            pretty(factor * one.largest), unit, f"{one.dependence:.1f}",
        )
    if part.load is not None:
        table.add_row("load's path", told(part.load), "", "", "", "")
    return table
