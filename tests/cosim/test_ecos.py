"""A third importer, Ecos: C++, with its own readers of FMI 2.0 and 3.0, stepping in parallel."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.standard.spec import Spec, started
from segfmu.validation.scenario import sized
from tests.compiler import needs_native
from tests.cosim.importers import load_threads, require
from tests.cosim.pair import FREE, HOOKED, HOOKS, MISSIONS, SPECS, STEP, STOP, compare, signals

# Of FMI 3.0, Ecos knows scalars only, and sets whole numbers with the function of another type.
SCALARS: tuple[dict[str, Any], dict[str, Any]] = (
    {"limits.x.velocity": 0.3, "limits.y.jerk": 0.4},
    {"sway.x.angle": 0.03, "feedback.enabled": False, "wind.gust.start": 1.0,
     "wind.gust.duration": 0.5, "wind.gust.force.x": 0.4},
)
CASES = {
    **{f"FMI 2.0, {name}": (2, values) for name, values in MISSIONS.items()},
    "FMI 3.0, paper": (3, MISSIONS["paper"]),
    "FMI 3.0, scalars": (3, SCALARS),
}


def load() -> Any:
    """Ecos."""
    require("ecospy")
    load_threads()
    import ecospy

    return ecospy


def ecos(
    paths: tuple[Path, Path], *values: dict[str, Any], step: float = STEP, stop: float = STOP,
    specs: dict[str, Spec] = SPECS,
) -> dict[str, np.ndarray]:
    """All real outputs of both FMUs at every communication point after the first."""
    library = load()
    names = [(s, v.name) for s, spec in specs.items() for v in spec.where("output")
             if v.kind == "Real"]
    given = {f"{s}::{n}": x for s, part in zip(specs, values, strict=True)
             for n, x in part.items()}
    rows = []
    with library.EcosSimulationStructure() as structure:
        for name, path in zip(specs, paths, strict=True):
            structure.add_model(name, path)
        for signal in signals(specs):
            structure.make_real_connection(*(f"{s}::{signal}" for s in specs))
        assert structure.add_parameter_set("given", given)
        with library.EcosSimulation(structure=structure, step_size=step) as simulation:
            assert simulation.init(parameter_set="given")
            for _ in range(round(stop / step)):
                simulation.step()
                rows.append([simulation.get_real(f"{s}::{n}") for s, n in names])
            simulation.terminate()
    return dict(zip((n for _, n in names), np.array(rows).T, strict=True))


@pytest.mark.parametrize("case", CASES)
def test_ecos_gives_what_our_master_gives(native_fmus, case: str) -> None:
    version, values = CASES[case]
    compare(ecos(native_fmus[version], *values), native_fmus[2], values)


@needs_native
def test_free_states_and_boxes_are_in_an_archive_of_fmi_3(native_fmus, tmp_path: Path) -> None:
    """As start values: Ecos cannot set its arrays."""
    planner, plant = sized(None)
    paths = build_all(tmp_path, Choice(True, 3), (started(planner, FREE), plant))
    compare(ecos((paths[0], paths[1]), {}, {}), native_fmus[2], (FREE, {}))


@pytest.mark.parametrize("fmi", (2, 3))
def test_ecos_runs_the_pair_with_a_hook(hook_fmus, fmi: int) -> None:
    found = ecos(hook_fmus[fmi], *HOOKED, specs=HOOKS)
    compare(found, hook_fmus[2], HOOKED)
    assert np.abs(found["sling.x.angle"]).max() > 0.02


@needs_native
@pytest.mark.parametrize("fmi", (2, 3))
def test_choices_arrive_as_integers(tmp_path: Path, fmi: int) -> None:
    first, second = build_all(tmp_path, Choice(True, fmi, numbered=True), sized(None))
    values = ({"planner.shape": 1}, {"drive.mode": 2, "feedback.design": 2})
    found = ecos((first, second), *values)
    compare(found, (first, second), values)
    plain = ecos((first, second), {}, {})
    assert np.abs(found["load.position.x"] - plain["load.position.x"]).max() > 1e-3
