"""Native FMUs in importers that share nothing with fmpy, and their sources compiled by fmpy."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest
from fmpy import extract, simulate_fmu
from fmpy.build import build_platform_binary

from segfmu.cosim import simulate
from segfmu.fmu import gantry_crane, gantry_feedforward

STEP, STOP = 0.005, 2.0


def test_libcosimpy_gives_what_our_master_gives(native_fmus) -> None:
    """Jacobi coupling: both FMUs step with the other's outputs of the step before.

    So the crane gets its inputs one step late there; our master is made to do the same.
    """
    pytest.importorskip("libcosimpy")
    from libcosimpy.CosimEnums import CosimVariableCausality, CosimVariableType
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    feedforward, crane = native_fmus[2]
    execution = CosimExecution.from_step_size(int(STEP * 1e9))
    source = CosimLocalSlave(fmu_path=str(feedforward), instance_name="feedforward")
    places = [execution.add_local_slave(source)]
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer)
    steps = round(STOP / STEP)
    names = [v.name for v in gantry_feedforward.spec().where("output") if v.kind == "Real"]
    references = [gantry_feedforward.native_spec().references[n] for n in names]
    rows = []
    for _ in range(steps):
        assert execution.step()
        rows.append(observer.last_real_values(places[0], references))
    expected = simulate(feedforward, crane, stop_time=STOP, step=STEP)
    for name, column in zip(names, np.array(rows).T, strict=True):
        assert column == pytest.approx(expected[name][1:], rel=1e-9, abs=1e-9), name


def test_fmpy_compiles_the_sources(native_fmus, tmp_path: Path) -> None:
    if shutil.which("cmake") is None:
        pytest.skip("fmpy compiles with cmake; it is not installed")
    for fmi, index in ((2, 1), (3, 0)):
        path = native_fmus[fmi][index]
        folder = tmp_path / f"{fmi}"
        extract(str(path), unzipdir=str(folder))
        shutil.rmtree(folder / "binaries")
        build_platform_binary(folder)
        found = simulate_fmu(str(folder), stop_time=0.5, output_interval=0.01)
        expected = simulate_fmu(str(path), stop_time=0.5, output_interval=0.01)
        for name in found.dtype.names:
            assert found[name] == pytest.approx(expected[name], rel=1e-12, abs=1e-12), name


def test_the_master_runs_both(native_fmus) -> None:
    rows = simulate(*native_fmus[2], stop_time=4.2, step=0.005)
    assert rows["error.load.norm"].max() < 1e-4
    assert abs(rows["sway.x.angle"][-1]) < 1e-4
    assert rows["plan.done"][-1]
    with zipfile.ZipFile(native_fmus[2][1]) as archive:
        assert gantry_crane.spec().description.encode() in archive.read("modelDescription.xml")
