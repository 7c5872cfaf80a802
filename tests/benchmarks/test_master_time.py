"""The plain loop that the master is measured against has the master's rows."""

from __future__ import annotations

import pytest
from benchmarks import master_time


@pytest.mark.parametrize("fmi", [2, 3])
def test_every_run_of_the_master_is_measured(native_fmus, fmi: int) -> None:
    section = master_time._section(fmi, native_fmus[fmi], 0.05, 2)
    assert [r["master"] for r in section.records] == [master_time.PLAIN, *master_time.RUNS]
    assert all(r["ms"] > 0.0 for r in section.records)
