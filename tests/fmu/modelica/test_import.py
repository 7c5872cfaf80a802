"""OpenModelica's own import of both FMUs, connected, against our co-simulation."""

from __future__ import annotations

from pathlib import Path

import pytest

from segfmu.cosim import simulate
from segfmu.fmu.models import registered
from segfmu.fmu.native.archive import build_all
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.scenario import specs
from tests.fmu.modelica.openmodelica import (
    built,
    imported,
    load_distance,
    require_omc,
    simulated,
)

require_omc()

MODELS = Path(__file__).parents[3] / "models"
CONNECTED = [
    v.name.replace(".", "_")
    for v in registered()[1].spec().where("input") if not v.name.startswith("wind")
]


def mission(folder: Path, changes: str = "") -> None:
    """A model of both imported classes, connected by name."""
    lines = "\n".join(f"  connect(feedforward.{n}, gantry.{n});" for n in CONNECTED)
    (folder / "Mission.mo").write_text(
        f"model Mission\n{changes}\nequation\n{lines}\n"
        "  gantry.wind_x = 0;\n  gantry.wind_y = 0;\n  gantry.wind_z = 0;\nend Mission;\n"
    )


CLASSES = "  GantryFeedforward_me_FMU feedforward{};\n  GantryCrane_me_FMU gantry{};"


@pytest.mark.parametrize(("name", "stop"), [("paper", 5.0), ("pick_and_place", 7.0)])
def test_missions_with_every_solver(tmp_path: Path, name: str, stop: float) -> None:
    task = load_mission(MODELS / f"{name}.toml")
    natives = [
        m.native_spec(s) for m, s in zip(registered()[:2], specs(task, task.plan()), strict=True)
    ]
    archives = build_all(natives, tmp_path / "archives")
    expected = simulate(*archives, stop_time=stop, step=1e-3)
    loaded = imported(tmp_path, archives)
    mission(tmp_path, CLASSES.format("", ""))
    program = built(tmp_path, "Mission", loaded + 'loadFile("Mission.mo");\n', stop)
    for solver, tolerance in (("dassl", 3e-9), ("ida", 3e-9), ("cvode", 3e-9), ("gbode", 1e-8)):
        results, _ = simulated(program, f"-s={solver}", f"-override=tolerance={tolerance}")
        assert load_distance(results, "gantry.", expected) < 1e-6, solver


def test_parameters_changed_in_modelica_take_effect(native_fmus, tmp_path: Path) -> None:
    loaded = imported(tmp_path, native_fmus[2])
    mission(tmp_path, CLASSES.format(
        "(crane_payload_mass = 1.4, waypoint_3__position_x = 0.8, limits_x_velocity = 0.5)",
        "(crane_payload_mass = 1.4, friction_sway_viscous = 0.01)",
    ))
    program = built(tmp_path, "Mission", loaded + 'loadFile("Mission.mo");\n', 5.0)
    results, _ = simulated(program)
    source = {
        "crane.payload_mass": 1.4, "waypoint[3].position.x": 0.8, "limits.x.velocity": 0.5,
    }
    sink = {"crane.payload_mass": 1.4, "friction.sway.viscous": 0.01}
    expected = simulate(
        *native_fmus[2], stop_time=5.0, step=1e-3, source_values=source, sink_values=sink
    )
    assert load_distance(results, "gantry.", expected) < 1e-6
    assert expected["load.position.x"][-1] == pytest.approx(0.8, abs=1e-3)


def test_a_moved_first_waypoint_needs_nothing_else(native_fmus, tmp_path: Path) -> None:
    loaded = imported(tmp_path, native_fmus[2])
    mission(tmp_path, CLASSES.format(
        "(waypoint_1__position_x = 0.1, waypoint_1__position_y = -0.05, "
        "waypoint_1__position_z = -0.6)", "",
    ))
    program = built(tmp_path, "Mission", loaded + 'loadFile("Mission.mo");\n', 5.0)
    first = {"x": 0.1, "y": -0.05, "z": -0.6}
    source = {f"waypoint[1].position.{a}": p for a, p in first.items()}
    expected = simulate(*native_fmus[2], stop_time=5.0, step=1e-3, source_values=source)
    for solver in ("dassl", "ida", "gbode"):
        results, _ = simulated(program, f"-s={solver}")
        # the states of initialisation last until the first event, at 1e-12 s
        assert load_distance(results[1:], "gantry.", expected[1:]) < 1e-6, solver


def test_equal_waypoints_are_one(native_fmus, tmp_path: Path) -> None:
    loaded = imported(tmp_path, native_fmus[2])
    places = {1: (0.0, 0.0, -0.5), 2: (0.0, 0.0, -0.5), 3: (0.2, 0.1, -0.5), 4: (0.2, 0.1, -0.5)}
    values = {
        f"waypoint_{i}__{name}_{axis}": x if name == "position" else 0.0
        for i, place in places.items() for name in ("position", "velocity", "acceleration")
        for axis, x in zip("xyz", place, strict=True)
    }
    given = ", ".join(f"{name} = {value}" for name, value in values.items())
    mission(tmp_path, CLASSES.format(f"(waypoint_count = 4, {given})", ""))
    program = built(tmp_path, "Mission", loaded + 'loadFile("Mission.mo");\n', 5.0)
    results, _ = simulated(program)
    once = {f"waypoint[{i}].{name}.{axis}": values[f"waypoint_{i + 1}__{name}_{axis}"]
            for i in (1, 2) for name in ("position", "velocity", "acceleration") for axis in "xyz"}
    expected = simulate(
        *native_fmus[2], stop_time=5.0, step=1e-3, source_values={"waypoint.count": 2} | once
    )
    assert load_distance(results[1:], "gantry.", expected[1:]) < 1e-6
    assert expected["load.position.x"][-1] == pytest.approx(0.2, abs=1e-3)


def test_parameters_of_no_use_end_the_simulation_with_their_reason(
    native_fmus, tmp_path: Path
) -> None:
    loaded = imported(tmp_path, native_fmus[2])
    mission(tmp_path, CLASSES.format("(limits_x_velocity = -1)", ""))
    program = built(tmp_path, "Mission", loaded + 'loadFile("Mission.mo");\n', 5.0)
    with pytest.raises(AssertionError, match=r"limits\.x\.velocity must be at least 0, got -1"):
        simulated(program)
