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
from tests.fmu.importer import Importer

STEP, STOP = 0.005, 2.0
SIGNALS = tuple(
    v.name for v in gantry_crane.spec().where("input") if not v.name.startswith("wind")
)


def test_libcosimpy_gives_what_our_master_gives(native_fmus) -> None:
    """GantryFeedforward alone, and the pair coupled as libcosim does it.

    libcosim steps all FMUs with the values of the step before, so the crane gets its inputs one
    step late; our importer is made to do the same.
    """
    pytest.importorskip("libcosimpy")
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    feedforward, crane = native_fmus[2]
    execution = CosimExecution.from_step_size(int(STEP * 1e9))
    slaves = [
        CosimLocalSlave(fmu_path=str(path), instance_name=name)
        for path, name in ((feedforward, "feedforward"), (crane, "crane"))
    ]
    first, second = (execution.add_local_slave(s) for s in slaves)
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer)
    specs = (gantry_feedforward.native_spec(), gantry_crane.native_spec())
    references = [s.references for s in specs]
    for name in SIGNALS:
        execution.connect_real_variables(
            first, references[0][name], second, references[1][name]
        )
    rows = []
    for _ in range(round(STOP / STEP)):
        assert execution.step()
        rows.append([
            *observer.last_real_values(first, [references[0][n] for n in SIGNALS]),
            *observer.last_real_values(second, [references[1][n] for n in gantry_crane.STATE]),
        ])
    assert np.array(rows) == pytest.approx(coupled(feedforward, crane), rel=1e-9, abs=1e-9)


def coupled(feedforward: Path, crane: Path) -> np.ndarray:
    """Signals and states after every step."""
    rows = []
    with Importer(feedforward) as source, Importer(crane) as sink:
        source.initialise()
        sink.write(SIGNALS, source.get(*SIGNALS))
        sink.initialise()
        for i in range(round(STOP / STEP)):
            source.step(STEP * i, STEP)
            sink.step(STEP * i, STEP)
            sink.write(SIGNALS, source.get(*SIGNALS))
            rows.append([*source.get(*SIGNALS), *sink.get(*gantry_crane.STATE)])
    return np.array(rows)


@pytest.mark.parametrize(("fmi", "index"), [(2, 1), (3, 0)])
def test_fmpy_compiles_the_sources(native_fmus, tmp_path: Path, fmi: int, index: int) -> None:
    if shutil.which("cmake") is None:
        pytest.skip("fmpy compiles with cmake; it is not installed")
    path, folder, build = native_fmus[fmi][index], tmp_path / "fmu", tmp_path / "build"
    extract(str(path), unzipdir=str(folder))
    shutil.rmtree(folder / "binaries")
    build.mkdir()
    build_platform_binary(folder, build)
    held = {"force.hoist": -9.81, "reference.rope.length": 0.5} if index == 1 else {}
    settings = {"stop_time": 0.5, "output_interval": 0.01, "start_values": held}
    found, expected = (simulate_fmu(str(p), **settings) for p in (folder, path))
    for name in found.dtype.names:
        assert found[name] == pytest.approx(expected[name], rel=1e-12, abs=1e-12), name


def test_the_master_runs_both(native_fmus) -> None:
    rows = simulate(*native_fmus[2], stop_time=4.2, step=0.005)
    assert rows["error.load.norm"].max() < 1e-4
    assert abs(rows["sway.x.angle"][-1]) < 1e-4
    assert rows["plan.done"][-1]
    with zipfile.ZipFile(native_fmus[2][1]) as archive:
        assert gantry_crane.spec().description.encode() in archive.read("modelDescription.xml")
