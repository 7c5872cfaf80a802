"""The measurement of communication steps: every way of calling works, on FMUs that do something."""

from __future__ import annotations

import platform
import sys
from pathlib import Path

import numpy as np
import pytest
from benchmarks import fmu_steps

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive as native
from segfmu.fmu.standard.spec import started
from tests.compiler import CC

pytestmark = pytest.mark.skipif(
    not CC or sys.platform != "linux" or platform.machine() != "x86_64",
    reason="the importer in C needs a C compiler and Linux on x86_64",
)


@pytest.mark.parametrize("index", [0, 1])
def test_both_importers_run_an_fmu_and_one_that_does_nothing(
    native_fmus, tmp_path: Path, index: int
) -> None:
    path = native_fmus[2][index]
    spec = (gantry_feedforward, gantry_crane)[index].native_spec()
    driver = fmu_steps._compiled("fmu_driver", tmp_path)
    fmu_steps._compiled("nothing", tmp_path)
    empty = fmu_steps._emptied(path, tmp_path / "nothing.so", tmp_path / "empty")
    for archive in (fmu_steps._unpacked(p, tmp_path / p.parent.name) for p in (path, empty)):
        assert [len(archive.inputs), len(archive.outputs)] == [
            sum(v.kind == "Real" for v in spec.where(c)) for c in ("input", "output")
        ]
        for importer in ("C", "master"):
            # as long as the crane takes to fall with no force on its rope
            initialisation, step = fmu_steps._call(driver, archive, importer, 50)()
            assert initialisation > 0.0 and step > 0.0


def test_a_failing_fmu_is_no_measurement(tmp_path: Path) -> None:
    failing = started(gantry_crane.spec(), {"reference.rope.length": 0.0})
    (crane,) = native.build_all([gantry_crane.native_spec(failing)], tmp_path, fmi=2)
    archive = fmu_steps._unpacked(crane, tmp_path / "crane")
    driver = fmu_steps._compiled("fmu_driver", tmp_path)
    with pytest.raises(RuntimeError, match=r"fmu_driver\.c: status -4"):
        fmu_steps._in_c(driver, archive, 100_000)


def test_missions_fit_the_interface() -> None:
    feedforward = fmu_steps._mission(fmu_steps.gantry_feedforward.spec())
    starts = {v.name: v.start for v in feedforward.variables}
    assert starts["waypoint.count"] == fmu_steps.WAYPOINTS
    assert starts["waypoint[16].position.x"] > starts["waypoint[15].position.x"]


def test_backends_take_turns() -> None:
    called: list[str] = []
    calls = {(n, "C"): lambda n=n: (called.append(n), (1.0, 2.0))[1] for n in "ab"}
    found = fmu_steps._in_turns(calls, 2)
    assert "".join(called) == "baabba"
    assert all(np.array_equal(v, [[1.0, 2.0]] * 2) for v in found.values())
