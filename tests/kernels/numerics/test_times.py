"""Times that are given as parameters."""

from __future__ import annotations

from segfmu.kernels import backend
from segfmu.kernels.numerics.records import GivenTime


def test_begin_time() -> None:
    assert backend.begin_time(-3.0, 100.0) == -3.0
    assert backend.begin_time(0.0, 100.0) == 0.0
    assert backend.begin_time(float(GivenTime.AT_START), 100.0) == 100.0
