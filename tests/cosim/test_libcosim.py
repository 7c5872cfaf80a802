"""A second importer, libcosim of the Open Simulation Platform, against our master.

libcosim is C++ and shares nothing with fmpy: it reads modelDescription.xml by itself, loads the
binaries by itself and orders the calls by itself. It steps all FMUs with the values of the step
before, which is our master's parallel coupling.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.standard.spec import Spec
from segfmu.validation.scenario import sized
from tests.compiler import needs_native
from tests.cosim.importers import require
from tests.cosim.pair import FREE, HOOKED, HOOKS, MISSIONS, SPECS, STEP, STOP, compare, signals

# libcosim has no enumerations, so missions have none
SETTERS = {"Real": "real", "Integer": "integer", "Boolean": "boolean"}


def late_execution(start: float, step: float) -> Any:
    """An execution that starts at a time [s], for which the package has no function."""
    from ctypes import POINTER, c_int64

    from libcosimpy._internal import libcosimc, wrap_function
    from libcosimpy.CosimExecution import CosimExecution

    create = wrap_function(
        lib=libcosimc(), funcname="cosim_execution_create", argtypes=[c_int64, c_int64],
        restype=POINTER(CosimExecution),
    )
    key = CosimExecution._CosimExecution__create_key
    return CosimExecution(key, create(round(start * 1e9), round(step * 1e9)))


def libcosim(
    paths: tuple[Path, Path], *values: dict[str, Any], step: float = STEP, stop: float = STOP,
    start: float = 0.0, specs: dict[str, Spec] = SPECS,
) -> dict[str, np.ndarray]:
    """All real outputs of both FMUs at every communication point after the first, at `start`."""
    require("libcosimpy")
    from libcosimpy.CosimConstants import success
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    execution = late_execution(start, step)
    slaves = [
        CosimLocalSlave(fmu_path=str(path), instance_name=name)
        for path, name in zip(paths, specs, strict=True)
    ]
    places = dict(zip(specs, (execution.add_local_slave(s) for s in slaves), strict=True))
    observer = CosimObserver.create_last_value()
    assert execution.add_observer(observer)
    for (name, spec), given in zip(specs.items(), values, strict=True):
        kinds = {v.name: v.kind for v in spec.variables}
        for variable, wanted in given.items():
            # enumerations are there in FMUs with integers in their place
            kind = SETTERS.get(kinds[variable], "integer")
            set_value = getattr(execution, f"{kind}_initial_value")
            assert set_value(places[name], spec.references[variable], wanted)
    source, sink = specs.values()
    for signal in signals(specs):
        done = execution.connect_real_variables(
            places[source.name], source.references[signal],
            places[sink.name], sink.references[signal],
        )
        assert done == success
    names = {n: [v.name for v in s.where("output") if v.kind == "Real"] for n, s in specs.items()}
    rows = []
    for _ in range(round(stop / step)):
        assert execution.step()
        rows.append([
            x for n, spec in specs.items()
            for x in observer.last_real_values(places[n], [spec.references[v] for v in names[n]])
        ])
    return dict(zip((*names[source.name], *names[sink.name]), np.array(rows).T, strict=True))


@pytest.mark.parametrize("mission", MISSIONS)
def test_libcosim_gives_what_our_master_gives(native_fmus, mission: str) -> None:
    values = MISSIONS[mission]
    found = libcosim(native_fmus[2], *values)
    compare(found, native_fmus[2], values)


def test_free_states_and_boxes_act(native_fmus) -> None:
    """The load is longer under way than without the boxes, and passes waypoints without a stop."""
    found = libcosim(native_fmus[2], FREE, {})
    fast = libcosim(native_fmus[2], FREE | {"obstacle.count": 0}, {})
    ends = [rows["plan.next_event"][-1] for rows in (fast, found)]
    assert ends[0] + 0.05 < ends[1] < STOP
    speed = np.hypot(found["reference.load.velocity.x"], found["reference.load.velocity.y"])
    far = found["reference.load.position.x"]
    assert speed[(far > 0.1) & (far < 0.6)].min() > 0.1


def test_libcosim_runs_the_pair_with_a_hook(hook_fmus) -> None:
    found = libcosim(hook_fmus[2], *HOOKED, specs=HOOKS)
    compare(found, hook_fmus[2], HOOKED)
    assert np.abs(found["sling.x.angle"]).max() > 0.02


def test_a_late_start_is_the_start_of_the_motion(native_fmus) -> None:
    found = libcosim(native_fmus[2], {}, {}, start=100.0)
    assert found.pop("plan.next_event")[-1] > 103.5
    compare(found, native_fmus[2], ({}, {}), 1e-6)


def test_parallel_coupling_has_an_error_of_first_order(native_fmus) -> None:
    """It shrinks with the step; the sequential one is far smaller."""
    def error(coupling: Any, step: float) -> float:
        rows = simulate(*native_fmus[2], stop_time=2.0, step=step, coupling=coupling,
                        events=False, sink_values={"feedback.enabled": False})
        return float(rows["error.load.norm"].max())

    coarse, fine = error("parallel", 0.005), error("parallel", 0.00125)
    assert coarse / fine == pytest.approx(4.0, rel=0.15)
    assert error("sequential", 0.005) < 0.2 * coarse


@pytest.fixture(scope="module")
def numbered_fmus(tmp_path_factory) -> tuple[Path, Path]:
    """Archives in which integers are in place of enumerations."""
    first, second = build_all(
        tmp_path_factory.mktemp("numbered"), Choice(True, numbered=True), sized(None)
    )
    return first, second


@needs_native
def test_choices_arrive_as_integers(numbered_fmus) -> None:
    values = ({"planner.shape": 1, "waypoint.count": 3}, {"drive.mode": 2, "feedback.design": 2})
    found = libcosim(numbered_fmus, *values)
    compare(found, numbered_fmus, values)
    assert np.abs(found["force.bridge"]).max() > 0.1
    plain = libcosim(numbered_fmus, {}, {})
    assert np.abs(found["load.position.x"] - plain["load.position.x"]).max() > 1e-3
