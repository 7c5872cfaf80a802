"""What no run could do is refused before the first one."""

from __future__ import annotations

from pathlib import Path

import dask

# its defaults: of settings before they were read, `dask.config.set` leaves none behind
import distributed  # noqa: F401

from segfmu.validation.campaigns.result import load_result
from tests.compiler import needs_native
from tests.cosim.probe.build import build
from tests.validation.campaigns.files import SCENARIO, run, write

# aborts, but for a run that has another status
PROBE = """
[[fmus]]
name = "probe"
path = "{path}"
connections = [["probe", "y", "GantryCrane", "wind.z"]]
values = {{ gain = 0.0, "fail.time" = 1.0, "fail.status" = 99 }}
"""
DYING = """
name = "dying"
scenarios = ["s.toml"]
sampling.kind = "matrix"

[[factors]]
name = "status"
key = "fmus.probe.values.fail.status"
values = [0, 99]
"""


@needs_native
def test_a_scenario_whose_fmu_ends_the_process_costs_its_runs_alone(tmp_path: Path) -> None:
    probe = build(tmp_path, 2).as_posix()
    path = write(tmp_path, DYING, SCENARIO + PROBE.format(path=probe))
    # Dask begins a worker anew less often than the usual three times
    with dask.config.set({"distributed.scheduler.allowed-failures": 0}):
        run(path, "-o", tmp_path / "out", "--jobs", "1", code=1)
    result = load_result(tmp_path / "out")
    ((number, error),) = result.errors
    assert number == 1 and "died" in error
    assert result.column("margin.follows")[0] is not None
