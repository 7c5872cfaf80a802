"""Tables of identifications."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.validation.identification.prediction import Prediction, SignalFit
from segfmu.validation.identification.tables import predictions_table


@pytest.mark.parametrize(("index", "told"), [
    (0.98765, "0.988"), (-3.0, "-3.000"), (-2.5e10, "below -10"), (np.nan, "rests"),
])
def test_a_signal_that_rests_has_no_fit_of_many_digits(index: float, told: str) -> None:
    signal = SignalFit("measured.rope.length", index, 1e-6, 2e-6, 1.0)
    table = predictions_table("log", Prediction("log", {}, (signal,), index, ()))
    assert list(table.columns[1].cells) == [told, told]
