"""A third model, registered by one call: built, validated and co-simulated from one folder."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from fmpy import simulate_fmu
from scipy.integrate import solve_ivp

from segfmu.cosim import simulate
from segfmu.errors import BuildError
from segfmu.fmu import models
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from tests.compiler import require_native
from tests.fmu.checking import faults
from tests.fmu.pendulum.equation import rates
from tests.fmu.pendulum.model import PENDULUM

CHOICES = {
    "native, FMI 2": Choice(True, 2), "native, FMI 3": Choice(True, 3), "Python": Choice(False),
}
KINDS = [(c, "CoSimulation") for c in CHOICES]
KINDS += [(c, "ModelExchange") for c in CHOICES if c.startswith("native")]


@pytest.fixture(scope="module")
def archives(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Path]]:
    """Archives of the pendulum by backend."""
    require_native()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(models, "_registered", dict(models._registered))
        models.register(PENDULUM)
        yield {
            name: build_all(tmp_path_factory.mktemp("pendulum"), choice, [PENDULUM.spec()])[0]
            for name, choice in CHOICES.items()
        }


@pytest.mark.parametrize("choice", CHOICES)
def test_fmpy_finds_nothing(archives, choice: str) -> None:
    assert models.registered()[-1] is PENDULUM
    assert faults(archives[choice]) == []


@pytest.mark.parametrize(("choice", "kind"), KINDS)
def test_free_swing_is_that_of_scipy(archives, choice: str, kind: str) -> None:
    start = {"sway.angle": 1.2, "sway.rate": -0.3, "crane.gravity": 3.7}
    rows = simulate_fmu(
        str(archives[choice]), fmi_type=kind, stop_time=2.0, step_size=0.01,
        output_interval=0.01, start_values=start, relative_tolerance=1e-9,
        output=["sway.angle", "load.offset"],
    )
    solved = solve_ivp(
        lambda t, s: rates(s, (0.0, 0.5, 0.0), 3.7), (0.0, 2.0), (1.2, -0.3),
        t_eval=rows["time"].clip(0.0, 2.0), rtol=1e-11, atol=1e-12,
    )
    assert rows["sway.angle"] == pytest.approx(solved.y[0], abs=1e-6)
    assert rows["load.offset"] == pytest.approx(0.5 * np.sin(solved.y[0]), abs=1e-6)


@pytest.mark.parametrize("choice", CHOICES)
def test_below_the_planned_trolley_it_swings_as_planned(
    archives, fmus: tuple[Path, Path], native_fmus: dict[int, tuple[Path, Path]], choice: str
) -> None:
    """In one plane, GantryFeedforward's inverse is the pendulum's solution."""
    own = CHOICES[choice]
    planner = (native_fmus[own.fmi] if own.native else fmus)[0]
    plane = {f"waypoint[{i}].{q}.y": 0.0 for i in (1, 2, 3) for q in ("position", "velocity")}
    if own.fmi == 3:
        plane = {"waypoint.position": [0.0, 0.0, -0.5, 0.07, 0.0, -0.5, 1.0, 0.0, -0.5],
                 "waypoint.velocity": [0.0, 0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0],
                 "waypoint.acceleration": [0.0, 0.0, 0.0, 0.34, 0.0, 0.0, 0.0, 0.0, 0.0]}
    else:
        plane["waypoint[2].acceleration.y"] = 0.0
    rows = simulate(planner, archives[choice], stop_time=3.5, step=0.005, source_values=plane)
    planned = rows["reference.sway.x.angle"]
    assert np.abs(planned).max() > 0.02
    assert rows["sway.angle"] == pytest.approx(planned, abs=2e-6)


def test_two_models_of_one_name_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(models, "_registered", {"Pendulum": models.registered()[0]})
    with pytest.raises(BuildError, match="there is a model Pendulum already"):
        models.register(PENDULUM)
    with pytest.raises(BuildError, match="model must be one of Pendulum, got 'Crane'"):
        models.named("Crane")
