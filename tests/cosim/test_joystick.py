"""A stick that is an FMU commands GantryFeedforward in libcosim and Ecos, which step in parallel.

The stick swings as a pendulum does, so each step has another command. Commands are inputs, and all
other values those of the archives.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from benchmarks.operated import SITES, Site, parameters

from segfmu.cosim import System
from segfmu.fmu import models
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.gantry_feedforward import interface
from segfmu.fmu.standard.spec import Spec, started
from tests.compiler import require_native
from tests.cosim.importers import require
from tests.cosim.test_ecos import load
from tests.fmu.pendulum.model import PENDULUM

STEPS = 400
# [s]; all clocks add these without rounding, and a command a rounding error away may have another
# plan
STEP = {"lab": 1.0 / 64.0, "port": 1.0 / 8.0}
STICK, PLANNER = "Pendulum", "GantryFeedforward"
ANGLE, COMMAND = "sway.angle", "command.velocity.y"
RECORDED = [
    f"reference.load.{n}.{a}" for n in ("position", "velocity", "acceleration", "jerk", "snap")
    for a in "xyz"
]
RECORDED += [f"force.{d}" for d in ("bridge", "trolley", "hoist")]


def specs(site: Site, step: float) -> list[Spec]:
    """The stick beyond the fastest velocity, and the planner that it moves, behind a site."""
    fastest = float(site.limits.velocity[1])
    # a swing takes 100 steps
    rope = site.crane.gravity * (100.0 * step / (2.0 * np.pi)) ** 2
    swing = {"sway.angle": min(1.1 * fastest, 1.2), "reference.rope.length": rope}
    given = parameters(site) | {"command.mode": "velocity", "command.velocity.x": 0.3 * fastest}
    return [started(PENDULUM.spec(), swing), started(interface.spec(2), given)]


@pytest.fixture(scope="module")
def built(request, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, int, list[Path]]:
    """Stick and planner of a site."""
    require_native()
    name, fmi = request.param
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(models, "_registered", dict(models._registered))
        models.register(PENDULUM)
        paths = build_all(
            tmp_path_factory.mktemp("stick"), Choice(True, fmi, numbered=True, connected=True),
            specs(SITES[name], STEP[name]),
        )
    return name, fmi, paths


@pytest.fixture(scope="module")
def expected(built) -> np.ndarray:
    """What our master gives."""
    name, _, paths = built
    site, step = SITES[name], STEP[name]
    with System(
        dict(zip((STICK, PLANNER), paths, strict=True)), step=step,
        connections=[(STICK, ANGLE, PLANNER, COMMAND)], coupling="parallel", events=False,
    ) as system:
        rows = system.run({}, stop_time=STEPS * step)
    found = np.column_stack([rows[n] for n in RECORDED])[1:]
    # the stick moves the load, forwards and back
    speed = found[:, RECORDED.index("reference.load.velocity.y")]
    assert speed.min() < -0.03 * float(site.limits.velocity[1])
    assert speed.max() > 0.03 * float(site.limits.velocity[1])
    return found


def require_equal(found: np.ndarray, expected: np.ndarray) -> None:
    scale = np.maximum(np.abs(expected).max(axis=0), 1.0)
    np.testing.assert_allclose(found / scale, expected / scale, rtol=0, atol=1e-9)


@pytest.mark.parametrize("built", [(name, 2) for name in SITES], indirect=True, ids=str)
def test_libcosim(built, expected) -> None:
    require("libcosimpy")
    from libcosimpy.CosimConstants import success
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    name, _, paths = built
    execution = CosimExecution.from_step_size(round(STEP[name] * 1e9))
    stick, planner = (
        execution.add_local_slave(CosimLocalSlave(fmu_path=str(path), instance_name=fmu))
        for fmu, path in zip((STICK, PLANNER), paths, strict=True)
    )
    observer = CosimObserver.create_last_value()
    assert execution.add_observer(observer)
    sources, sinks = (spec.references for spec in specs(SITES[name], STEP[name]))
    connected = execution.connect_real_variables(stick, sources[ANGLE], planner, sinks[COMMAND])
    assert connected == success
    rows = []
    for _ in range(STEPS):
        assert execution.step()
        rows.append(observer.last_real_values(planner, [sinks[n] for n in RECORDED]))
    require_equal(np.array(rows), expected)


@pytest.mark.parametrize(
    "built", [(name, fmi) for name in SITES for fmi in (2, 3)], indirect=True, ids=str
)
def test_ecos(built, expected) -> None:
    library = load()
    name, _, paths = built
    rows = []
    with library.EcosSimulationStructure() as structure:
        for fmu, path in zip((STICK, PLANNER), paths, strict=True):
            structure.add_model(fmu, path)
        structure.make_real_connection(f"{STICK}::{ANGLE}", f"{PLANNER}::{COMMAND}")
        with library.EcosSimulation(structure=structure, step_size=STEP[name]) as simulation:
            assert simulation.init()
            for _ in range(STEPS):
                simulation.step()
                rows.append([simulation.get_real(f"{PLANNER}::{n}") for n in RECORDED])
            simulation.terminate()
    require_equal(np.array(rows), expected)
