"""Margins of criteria over rows that are given."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.validation.files.crane_file import CraneFile
from segfmu.validation.files.scenario_tables import CriterionTable
from segfmu.validation.monitor import Signals, judge

MASSES = {"bridge_mass": 2.0, "trolley_mass": 1.0, "payload_mass": 1.0}
KNOWN = {"start": 0.0, "arrival": 1.5, "end": 3.0}


def margin(values: list[float], crane: CraneFile | None = None, **keys: object) -> float:
    """The margin of a criterion of a signal with a value each second."""
    rows = np.zeros(len(values), dtype=[(n, float) for n in (
        "time", "a", *(f"drive.{d}.{q}" for d in ("bridge", "trolley", "hoist")
                       for q in ("force", "power")),
        "bridge.velocity", "trolley.velocity", "rope.velocity",
    )])
    rows["time"] = np.arange(len(values))
    rows["a"] = rows["bridge.velocity"] = values
    signal = {} if keys.get("kind") == "drives" else {"signal": "a"}
    criterion = CriterionTable.model_validate({"name": "c", "bound": 1.0} | signal | keys)
    crane = crane or CraneFile.model_validate(MASSES)
    return judge(criterion, Signals(rows), KNOWN, crane, {}).margin


@pytest.mark.parametrize(("window", "expected"), [
    # between rows signals are linear, up to the ends of a window
    ([0.0, 1.5], 0.5), ([2.5, 3.0], 0.5), ([1.25, 1.5], 0.5), ([0.0, 2.0], 0.0),
    ([2.25, 3.0], 0.25), ([0.0, "arrival-1"], 1.0),
])
def test_the_ends_of_a_window_count(window: list[float | str], expected: float) -> None:
    assert margin([0.0, 0.0, 1.0, 0.0], window=window) == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize(("window", "use"), [
    ([0.0, 3.0], 0.4), ([1.0, 3.0], 0.4), ([2.0, 3.0], 0.2),
])
def test_a_row_has_the_acceleration_of_both_sides(window: list[float], use: float) -> None:
    crane = CraneFile.model_validate(MASSES | {"bridge": {"acceleration_max": 0.5}})
    found = margin([0.0, 0.2, 0.2, 0.3], crane, kind="drives", window=window)
    assert found == pytest.approx(1.0 - use, abs=1e-12)


def test_rounding_beyond_a_bound_is_none() -> None:
    assert margin([1.0 + 1e-13, 0.0, 0.0, 0.0]) == 0.0
    assert margin([1.0 + 1e-11, 0.0, 0.0, 0.0]) < 0.0


def test_a_bound_that_is_met_has_no_sign() -> None:
    """It was told as a margin of -0, passed."""
    for sense in ("at least", "at most"):
        assert f"{margin([1.0] * 4, sense=sense):+.4g}" == "+0"
