"""Hook models on PythonFMU: what the native ones do."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.fmu import pairs
from segfmu.fmu.hook_crane import interface as hook_crane
from segfmu.fmu.hook_crane.slave import HookCraneSlave
from segfmu.fmu.hook_feedforward import interface as hook_feedforward
from segfmu.fmu.hook_feedforward.slave import HookFeedforwardSlave
from segfmu.fmu.python.archive import build_all
from segfmu.kernels.hook.records import HookFeedforward, HookState
from tests.fmu.bench import SlaveBench, bench
from tests.fmu.checking import faults
from tests.fmu.gantry_feedforward.test_drive_bounds import initialised
from tests.sharing import shared

STATE = [v for f in HookState.FIELDS.values() for v in f.variables]
PLANNED = [v for f in HookFeedforward.FIELDS.values() for v in f.variables if v]
SHOWN = [*STATE, *(f"{part}.position.{a}" for part in ("load", "hook") for a in "xyz"),
         "sling.tension", "sway.frequency.slow", "sway.frequency.fast", "drive.hoist.force",
         "drive.trolley.force", "estimate.payload_mass"]
SWAYING = {"sway.x.angle": 0.05, "sling.x.angle": -0.04, "sling.y.rate": 0.1, "hook.mass": 0.2}
TIMES = np.arange(41) / 40.0


@pytest.fixture(scope="module")
def python_fmus(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    specs = (hook_feedforward.spec(), hook_crane.spec())
    build = partial(build_all, specs=specs)
    folder = shared(tmp_path_factory, "pythonhooks", build)
    feedforward, crane = (folder / f"{name}.fmu" for name in pairs.HOOK.names)
    return feedforward, crane


def pushes(time: float) -> dict[str, float]:
    """Setpoints that move all axes."""
    wave = float(np.sin(3.0 * time))
    return {"force.bridge": 2.0 * wave, "force.trolley": -wave, "force.hoist": -12.0 - wave,
            "velocity.bridge": 0.1 * wave, "velocity.trolley": -0.1 * wave,
            "velocity.hoist": 0.05 * wave}


def test_fmpy_finds_nothing(python_fmus) -> None:
    assert [faults(path) for path in python_fmus] == [[], []]


@pytest.mark.parametrize("smoothness", [5, 6])
def test_the_planner_gives_what_the_native_one_does(hook_fmus, smoothness: int) -> None:
    start = {"planner.smoothness": smoothness, "hook.mass": 0.3, "drive.trolley.lag": 0.1,
             "friction.bridge.coulomb": 0.2}
    times, names = np.arange(30) / 5.0, [*PLANNED, "plan.duration", "plan.next_event"]
    one = SlaveBench(HookFeedforwardSlave, names).run(start, lambda _: {}, times)
    with bench(hook_fmus[2][0], hook_feedforward.native_spec(), names) as runs:
        other = runs.run(start, lambda _: {}, times)
    assert one is not None and other is not None
    for name in names:
        size = max(1.0, float(np.abs(other[name]).max()))
        assert one[name] == pytest.approx(other[name], abs=1e-9 * size), name


@pytest.mark.parametrize("values", [
    {"travel.rope.max": 0.01}, {"obstacle.count": 1}, {"drive.bridge.velocity_max": 0.01},
    {"planner.finds_limits": True, "drive.trolley.acceleration_max": 0.3},
])
def test_both_find_or_refuse_the_same(hook_fmus, python_fmus, values) -> None:
    one, other = (initialised(p, values) for p in (python_fmus[0], hook_fmus[2][0]))
    if isinstance(other, str):
        assert other.rpartition("failed: ")[2] in str(one)
    else:
        assert one == pytest.approx(other, rel=1e-9)


@pytest.mark.parametrize("mode", ["force", "velocity"])
@pytest.mark.parametrize("source", [None, "state", "measured"])
def test_the_crane_moves_as_the_native_one(hook_fmus, mode: str, source: str | None) -> None:
    start = SWAYING | {"drive.mode": mode, "feedback.sling": 0.25}
    if mode == "velocity":
        start |= {f"drive.{d}.lag": 0.1 for d in ("bridge", "trolley", "hoist")}
        start |= {"drive.trolley.velocity_max": 0.5}
    if source is not None:
        start |= {"feedback.enabled": True, "feedback.source": source,
                  "feedback.design": "flatness"}
    one = SlaveBench(HookCraneSlave, SHOWN).run(start, pushes, TIMES)
    with bench(hook_fmus[2][1], hook_crane.native_spec(), SHOWN) as runs:
        other = runs.run(start, pushes, TIMES)
    assert one is not None and other is not None
    moved = np.ptp(other["sling.x.angle"])
    assert moved > 0.01
    for name in SHOWN:
        size = max(1.0, float(np.abs(other[name]).max()))
        assert one[name] == pytest.approx(other[name], abs=1e-8 * size), name


def test_the_load_is_on_its_plan(python_fmus) -> None:
    """But for setpoints that are held for a step, as this backend has no derivatives."""
    off = []
    for step in (0.01, 0.005):
        rows = simulate(
            *python_fmus, stop_time=2.0, step=step,
            sink_values={"start.on_reference": True, "feedback.enabled": False},
        )
        off.append(rows["error.load.norm"].max())
    assert 4.0 * off[1] < off[0] < 1e-3
