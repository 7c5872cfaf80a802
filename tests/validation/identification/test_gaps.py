"""Times of logs without rows."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import segfmu
from segfmu.validation.identification.gaps import longest_gap
from segfmu.validation.identification.log import read_log
from tests.campaign import soaked_rows

CRANE: dict[str, Any] = {
    "bridge_mass": 2.2, "trolley_mass": 1.1, "payload_mass": 1.0, "drive": "velocity",
}


def moving(kept: np.ndarray[Any, np.dtype[np.bool_]]) -> dict[str, Any]:
    """A bridge that swings to and fro from 1 s to 4 s, without some of its rows."""
    times = np.arange(250) / 50.0
    speed = np.where((times > 1.0) & (times < 4.0), 0.2 * np.sin(2.0 * np.pi * times), 0.0)
    columns = {
        "time": times, "velocity.bridge": speed, "measured.rope.length": 1.0 + 0.0 * times,
        "measured.bridge.position": np.cumsum(speed) / 50.0,
    }
    return {name: values[kept] for name, values in columns.items()}


@pytest.mark.parametrize(("first", "last", "found"), [
    (100, 115, (1.98, 2.3)),  # while it moves
    (5, 45, None),            # while it rests
    *soaked_rows((100, 105, None)),  # a few rows
])
def test_setpoints_that_change_without_a_row_are_told(
    first: int, last: int, found: tuple[float, float] | None
) -> None:
    places = np.arange(250)
    columns = moving((places < first) | (places >= last))
    gap = longest_gap(read_log(columns, "velocity", {}, "log 1"))
    assert (None if gap is None else (gap.begin, gap.end)) == found
    result = segfmu.identify(columns, CRANE, fit=["bridge.dead_time"], held_out=0.0)
    assert result.gaps == (() if gap is None else (gap,))
    if gap is not None:
        assert str(gap).startswith("log 1: no row from 1.98 to 2.3 s, while setpoints changed")
