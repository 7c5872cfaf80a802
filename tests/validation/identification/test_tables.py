"""Tables of identifications."""

from __future__ import annotations

from io import StringIO

import numpy as np
import pytest
from rich.console import Console

from segfmu.validation.identification.prediction import Prediction, SignalFit
from segfmu.validation.identification.result import Estimate
from segfmu.validation.identification.tables import predictions_table


@pytest.mark.parametrize(("index", "told"), [
    (0.98765, "0.988"), (-3.0, "-3.000"), (-2.5e10, "below -10"), (np.nan, "rests"),
])
def test_a_signal_that_rests_has_no_fit_of_many_digits(index: float, told: str) -> None:
    signal = SignalFit("measured.rope.length", index, 1e-6, 2e-6, 1.0)
    table = predictions_table("log", Prediction("log", {}, (signal,), index, ()))
    assert list(table.columns[1].cells) == [told, told]


def test_names_of_signals_are_whole_on_a_narrow_terminal() -> None:
    """They ended in an ellipsis, and residuals of places were 1.72e-06 m."""
    signals = tuple(
        SignalFit(f"measured.{name}", 0.99, 1.72e-6, 7.5e-6, 12.3)
        for name in ("trolley.position", "sway.x.angle")
    )
    shown = StringIO()
    table = predictions_table("fitted: log.csv", Prediction("log", {}, signals, 0.9, ()))
    Console(file=shown, width=80).print(table)
    assert all(signal.signal in shown.getvalue() for signal in signals)
    assert "1.72" in shown.getvalue() and "µm" in shown.getvalue() and "e-" not in "".join(
        line for line in shown.getvalue().splitlines() if "position" in line
    )


def test_a_value_has_no_digits_below_its_interval() -> None:
    """A dead time of 0 to 4.5 ms was 1.57e-14 s."""
    one = Estimate("hoist.dead_time", "s", 0.0, 1.57e-14, 0.0, 0.004534)
    assert one.rounded == 0.0 and str(one) == "hoist.dead_time 0 s (0 to 0.004534)"
    assert Estimate("k", "s", 0.0, 0.020174812, 0.02015, 0.0202).rounded == 0.0201748
