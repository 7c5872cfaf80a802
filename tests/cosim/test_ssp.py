"""mission.ssp and OspSystemStructure.xml as libcosim and Ecos run them, against our master."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim import simulate
from segfmu.fmu.pair import ModelPair
from segfmu.fmu.pairs import GANTRY, HOOK, native
from segfmu.fmu.standard.spec import Spec, started
from segfmu.fmu.standard.system import values
from segfmu.fmu.system import write_system
from tests.cosim.importers import require
from tests.cosim.pair import HOOKED, MISSIONS
from tests.cosim.test_ecos import load

STEP, STOP = 1e-3, 3.0
LOAD = [f"load.position.{a}" for a in "xyz"]
TOLERANCE = 1e-9


TASKS = {**{name: (GANTRY, *task) for name, task in MISSIONS.items()}, "hook": (HOOK, *HOOKED)}


def specs(models: ModelPair, *parts: dict[str, object]) -> tuple[Spec, ...]:
    """Interfaces whose parameters differ from the start values of the FMUs in the package."""
    given = ({n: x for n, x in part.items() if not n.startswith(("sway.", "sling."))}
             for part in parts)
    return tuple(
        replace(started(own, part), stop_time=STOP, step_size=STEP)
        for own, part in zip((models.planner(16), models.plant()), given, strict=True)
    )


# what the load moves along x [m], in missions that hardly move it: at least, at most
TRAVEL = {"hook": (0.2, 0.3), "equal waypoints": (0.19, 0.21), "where it is": (0.0, 1e-9)}


@pytest.fixture(scope="module", params=TASKS)
def run(request, native_fmus, hook_fmus, tmp_path_factory) -> tuple[Path, Spec, np.ndarray]:
    """A folder with all files, the crane, and the load's path by our master in parallel."""
    folder = tmp_path_factory.mktemp("mission")
    models, *parts = TASKS[request.param]
    built = native_fmus if models is GANTRY else hook_fmus
    archives = [Path(shutil.copy(p, folder)) for p in built[2]]
    wanted = specs(models, *parts)
    write_system(folder, archives, wanted)
    natives = native(wanted)
    source, sink = (
        {v.name: x for v, x in values(s) if v.kind != "Enumeration"} for s in natives
    )
    rows = simulate(*archives, stop_time=STOP, step=STEP, source_values=source, sink_values=sink,
                    coupling="parallel", events=False)
    path = np.array([rows[n][1:] for n in LOAD]).T
    least, most = TRAVEL.get(request.param, (0.3, np.inf))
    assert least <= np.ptp(path, axis=0)[0] <= most
    return folder, natives[1], path


def compare(found: list[list[float]], expected: np.ndarray) -> None:
    assert np.abs(np.array(found) - expected).max() <= TOLERANCE


def cosim(create: Callable[[], object], own: Spec) -> list[list[float]]:
    from libcosimpy.CosimObserver import CosimObserver

    execution = create()
    observer = CosimObserver.create_last_value()
    assert execution.add_observer(observer)
    crane = execution.slave_index_from_instance_name(own.name)
    references = [own.references[n] for n in LOAD]
    rows = []
    for _ in range(round(STOP / STEP)):
        assert execution.step()
        rows.append(observer.last_real_values(crane, references))
    assert execution.status().current_time == round(STOP * 1e9)
    return rows


@pytest.mark.parametrize("form", ["SSP", "OSP"])
def test_libcosim(run, form: str) -> None:
    require("libcosimpy")
    from libcosimpy.CosimExecution import CosimExecution

    folder, crane, expected = run
    # neither is told a step: both files have it
    forms = {
        "SSP": lambda: CosimExecution.from_ssp_file(str(folder / "mission.ssp")),
        "OSP": lambda: CosimExecution.from_osp_config_file(str(folder)),
    }
    compare(cosim(forms[form], crane), expected)


def test_ecos(run) -> None:
    library = load()
    folder, crane, expected = run
    rows = []
    with library.EcosSimulation(
        ssp_path=str(folder / "mission.ssp"), step_size=STEP
    ) as simulation:
        assert simulation.init(parameter_set="mission")
        for _ in range(round(STOP / STEP)):
            simulation.step()
            rows.append([simulation.get_real(f"{crane.name}::{n}") for n in LOAD])
        simulation.terminate()
    compare(rows, expected)
