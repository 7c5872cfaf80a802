"""Native FMUs compiled from their sources by fmpy, and run by the master."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest
from fmpy import extract, simulate_fmu
from fmpy.build import build_platform_binary

from segfmu import Limits, Waypoint, plan
from segfmu.cosim import simulate
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward


@pytest.mark.parametrize(("fmi", "index"), [(2, 1), (3, 0)])
def test_fmpy_compiles_the_sources(native_fmus, tmp_path: Path, fmi: int, index: int) -> None:
    if shutil.which("cmake") is None:
        pytest.skip("fmpy compiles with cmake; it is not installed")
    path, folder, build = native_fmus[fmi][index], tmp_path / "fmu", tmp_path / "build"
    extract(str(path), unzipdir=str(folder))
    shutil.rmtree(folder / "binaries")
    build.mkdir()
    # half a second is simulated sooner than an optimised program compiles; the crane's is half as
    # large without the kernels that it does not call, which -O0 keeps
    level = ("-O0", "-Og")[index]
    build_platform_binary(
        folder, build, cmake_options={"CMAKE_C_FLAGS_RELEASE": f"{level} -DNDEBUG"}
    )
    held = {"force.hoist": -9.81, "reference.rope.length": 0.5} if index == 1 else {}
    settings = {"stop_time": 0.5, "output_interval": 0.01, "start_values": held}
    found, expected = (simulate_fmu(str(p), **settings) for p in (folder, path))
    for name in found.dtype.names:
        assert found[name] == pytest.approx(expected[name], rel=1e-12, abs=1e-12), name


SWINGING = {
    "sway.x.angle": 0.05, "sway.y.angle": -0.03, "wind.gust.start": 1.0,
    "wind.gust.duration": 0.5, "wind.gust.force.x": 0.4,
}
CONTROLLED = {
    "lqr": {},
    "off": {"feedback.enabled": False},
    "measured": {"feedback.source": 2},
    "velocity": {"drive.mode": 2, "feedback.design": 2,
                 **{f"drive.{d}.lag": 0.05 for d in ("bridge", "trolley", "hoist")}},
}


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("control", CONTROLLED)
def test_fmpys_solver_agrees_by_default(native_fmus, fmi: int, control: str) -> None:
    """CVode at the tolerance that the archive asks for."""
    names = [f"load.position.{a}" for a in "xyz"]
    stepped, solved = (
        simulate_fmu(
            str(native_fmus[fmi][1]), fmi_type=kind, stop_time=3.0, output_interval=0.01,
            start_values=SWINGING | CONTROLLED[control], output=names,
        )
        for kind in ("CoSimulation", "ModelExchange")
    )
    # two rows at an event, the last one after it
    last = [np.flatnonzero(np.abs(solved["time"] - t) < 1e-9)[-1] for t in stepped["time"]]
    for name in names:
        assert np.abs(solved[name][last] - stepped[name]).max() < 1e-6, name
    assert np.ptp(stepped["load.position.x"]) > 1e-2


def test_the_master_runs_both(native_fmus) -> None:
    rows = simulate(*native_fmus[2], stop_time=4.2, step=0.005)
    assert rows["error.load.norm"].max() < 1e-4
    assert abs(rows["sway.x.angle"][-1]) < 1e-4
    assert rows["plan.done"][-1]
    with zipfile.ZipFile(native_fmus[2][1]) as archive:
        assert gantry_crane.spec().description.encode() in archive.read("modelDescription.xml")


@pytest.mark.parametrize("fmi", [2, 3])
def test_fmpy_changes_the_number_of_waypoints(native_fmus, fmi: int) -> None:
    points = gantry_feedforward.POINTS[:2]
    limits = np.array(list(gantry_feedforward.LIMITS.values())).T
    trajectory = plan([Waypoint(*p) for p in points], Limits(*limits))
    rows = simulate_fmu(
        str(native_fmus[fmi][0]), stop_time=1.0, output_interval=0.05,
        start_values={"waypoint.count": 2}, output=["reference.load.position.x"],
    )
    moving = rows["time"] <= trajectory.duration
    assert 3 < moving.sum() < 21
    assert rows["reference.load.position.x"][moving] == pytest.approx(
        trajectory(rows["time"][moving])[:, 0], abs=1e-9
    )
