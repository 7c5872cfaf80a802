"""A stick in Modelica commands GantryFeedforward in OpenModelica, which imports it."""

from __future__ import annotations

from math import sin
from pathlib import Path

import numpy as np
import pytest
from benchmarks.operated import SITES, parameters

from segfmu.cosim import Change, System
from segfmu.fmu.build import build_all
from segfmu.fmu.choice import Choice
from segfmu.fmu.gantry_feedforward import interface
from segfmu.fmu.standard.spec import connected, started
from tests.fmu.modelica.openmodelica import at_steps, built, imported, require_omc, simulated

require_omc()

STEPS = 100
# [s]; clocks add these without rounding
STEP = {"lab": 1.0 / 64.0, "port": 1.0 / 16.0}
MOVED = "command.velocity.y"
RECORDED = [
    f"reference.load.{n}.{a}" for n in ("position", "velocity", "acceleration", "jerk")
    for a in "xyz"
]


def model(path: Path, given: dict[str, float], equation: str) -> None:
    """The planner with a stick; other inputs are constant, and modes are not passed."""
    lines = [
        f"  feedforward.{v.name.replace('.', '_')} = {str(given.get(v.name, v.start)).lower()};"
        for v in connected(interface.spec(2)).where("input")
        if v.name != MOVED and v.enumeration is None
    ]
    path.write_text(
        "model Stick\n  GantryFeedforward_me_FMU feedforward;\n  Real stick;\nequation\n"
        f"{equation}  feedforward.{MOVED.replace('.', '_')} = stick;\n"
        + "\n".join(lines) + "\nend Stick;\n"
    )


def followed(folder: Path, loaded: str, stop: float) -> np.ndarray:
    """Results of the model."""
    program = built(folder, "Stick", loaded + 'loadFile("Stick.mo");\n', stop)
    return simulated(program)[0]


@pytest.mark.parametrize("name", SITES)
def test_a_stick(tmp_path: Path, name: str) -> None:
    site, step = SITES[name], STEP[name]
    fastest = float(site.limits.velocity[1])
    across = {"command.velocity.x": 0.3 * fastest}
    given = parameters(site) | across | {"command.mode": "velocity"}
    [archive] = build_all(
        tmp_path, Choice(True, 2, connected=True), [started(interface.spec(2), given)]
    )
    loaded = imported(tmp_path, [archive])
    times = step * np.arange(STEPS + 1)
    # faster than the load may be
    most, rate = 1.1 * fastest, 0.07 / step
    signal = f"{most!r} * sin({rate!r} * time)"
    changes = [Change(t, "planner", {MOVED: most * sin(rate * t)}) for t in times[:-1]]
    with System({"planner": archive}, step=step, events=False) as system:
        expected = system.run({}, stop_time=times[-1], changes=changes)
    assert np.abs(expected["reference.load.velocity.y"]).max() > 0.1 * fastest
    # held from step to step, as in co-simulation
    held = f"  when sample(0, {step!r}) then\n    stick = {signal};\n  end when;\n"
    model(tmp_path / "Stick.mo", across, held)
    rows = at_steps(followed(tmp_path, loaded, times[-1]), times)
    for variable in RECORDED:
        size = max(1.0, float(np.abs(expected[variable]).max()))
        found = rows[f"feedforward.{variable.replace('.', '_')}"]
        assert np.abs(found - expected[variable]).max() < 1e-9 * size, variable
    # a signal that changes all the time is followed as well, a little sooner
    model(tmp_path / "Stick.mo", across, f"  stick = {signal};\n")
    rows = followed(tmp_path, loaded, times[-1])
    speed = np.interp(times, rows["time"], rows["feedforward.reference_load_velocity_y"])
    assert np.abs(speed - expected["reference.load.velocity.y"]).max() < 0.1 * fastest
