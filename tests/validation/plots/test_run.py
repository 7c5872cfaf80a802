"""The plot of a run: bounds beside the curves, and noise that is called so."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu import ActuatorBounds, Crane
from segfmu.crane.bounds import DRIVES
from segfmu.validation.plots.run import plot_run

CRANES = {"lab": Crane(2.2, 1.155, 1.0), "quay": Crane(300e3, 15e3, 40e3)}


def table(error: float) -> np.ndarray:
    names = [f"{kind}.{drive}" for kind in ("velocity",) for drive in DRIVES]
    names += [f"drive.{drive}.force" for drive in DRIVES]
    names += ["bridge.velocity", "trolley.velocity", "rope.velocity"]
    names += ["bridge.position", "trolley.position", "rope.length"]
    names += [f"{of}sway.{axis}.angle" for of in ("", "reference.") for axis in "xy"]
    names += [f"error.load.{axis}" for axis in "xyz"]
    rows = np.zeros(50, dtype=[(n, float) for n in ("time", *names)])
    rows["time"] = np.linspace(0.0, 5.0, 50)
    rows["error.load.x"] = error * np.sin(rows["time"])
    return rows


@pytest.mark.parametrize("name", CRANES)
def test_bounds_are_drawn_in_the_units_of_the_size(name: str) -> None:
    crane = CRANES[name]
    force = 0.5 * crane.payload_mass * crane.gravity
    rows = table(1e-3)
    rows["drive.trolley.force"] = 0.4 * force
    bounds = ActuatorBounds(velocity=[None, 2.0, None], force=[None, force, None])
    figure = plot_run(rows, np.array([0.0, 4.0]), "run", crane, bounds)
    velocity, forces = figure.axes[0], figure.axes[2]

    def dashed(panel) -> list[float]:
        return sorted(line.get_ydata()[0] for line in panel.lines if line.get_linestyle() == "--")

    assert dashed(velocity) == pytest.approx([-2.0, 2.0])
    factor = 1e-3 if name == "quay" else 1.0
    assert dashed(forces) == pytest.approx([-factor * force, factor * force])
    assert forces.get_ylabel() == ("force\n[kN]" if name == "quay" else "force\n[N]")


def test_bounds_of_both_directions_are_drawn() -> None:
    crane = CRANES["lab"]
    weight = crane.payload_mass * crane.gravity
    bounds = ActuatorBounds(
        velocity=[None, None, 0.5], velocity_min=[None, None, -0.2],
        force=[None, 3.0, 20.0], force_min=[None, -5.0, -15.0],
    )
    rows = table(1e-3)
    figure = plot_run(rows, np.array([0.0, 4.0]), "run", crane, bounds)

    def dashed(panel) -> list[float]:
        return sorted(line.get_ydata()[0] for line in panel.lines if line.get_linestyle() == "--")

    assert dashed(figure.axes[0]) == pytest.approx([-0.2, 0.5])
    # what the hoist pulls beyond the weight
    assert dashed(figure.axes[2]) == pytest.approx(sorted([-5.0, 3.0, -weight, 15.0 - weight]))


@pytest.mark.parametrize(("sway", "far"), [(0.4, True), (4.0, False), (0.0, False), (1e-9, False)])
def test_bounds_far_from_what_is_shown_are_in_the_legend(sway: float, far: bool) -> None:
    """A sway of 0.4 of 8 degrees was a line; noise stays one."""
    rows = table(1e-3)
    rows["sway.x.angle"] = np.radians(sway) * np.sin(rows["time"])
    bounds = ActuatorBounds(
        sway_angle=np.radians(8.0), velocity=[None, None, 0.5], velocity_min=[None, None, -0.2]
    )
    figure = plot_run(rows, np.array([0.0]), "run", CRANES["lab"], bounds)
    panel = figure.axes[4]
    assert (panel.get_ylim()[1] < 1.0) == far
    assert panel.get_legend().get_texts()[0].get_text() == ("φx, of 8 deg" if far else "φx")
    rows["rope.velocity"] = 0.01
    velocity = plot_run(rows, np.array([0.0]), "run", CRANES["lab"], bounds).axes[0]
    names = [text.get_text() for text in velocity.get_legend().get_texts()]
    assert names == ["bridge", "trolley", "hoist, of -0.2 to 0.5 m/s", "setpoint"]


def test_bounds_in_one_place_are_all_seen() -> None:
    """The last one hid the others."""
    bounds = ActuatorBounds(velocity=0.3)
    panel = plot_run(table(1e-3), np.array([0.0]), "run", CRANES["lab"], bounds).axes[0]
    dashed = [line for line in panel.lines if line.get_linestyle() == "--"]
    upper = [line for line in dashed if line.get_ydata()[0] > 0.0]
    # offsets and lengths of dashes and gaps, as they are drawn
    patterns = [line._dash_pattern for line in upper]
    ons = [np.arange(offset, offset + dash) for offset, (dash, _) in patterns]
    period = patterns[0][1][0] + patterns[0][1][1]
    assert len(upper) == 3
    assert len({round(float(v) % period, 6) for on in ons for v in on}) == sum(map(len, ons))
    assert panel.figure.axes[-1].get_xlabel().endswith("; dashed: bounds of the drives")


@pytest.mark.parametrize("error", [0.0, 1e-13, 9e-10])
def test_noise_is_no_landscape(error: float) -> None:
    figure = plot_run(table(error), np.array([0.0]), "run", CRANES["quay"], ActuatorBounds())
    errors = figure.axes[-1]
    assert errors.get_ylim() == pytest.approx((-1e-6, 1e-6))
    told = errors.get_legend()
    assert told.get_title().get_text() == "below 1e-6 mm" and not errors.texts
    # beside the curves, not over them
    figure.draw_without_rendering()
    assert told.get_window_extent().x0 >= errors.get_window_extent().x1


def test_the_distance_is_what_is_called_noise() -> None:
    """Three errors below the bound of noise were called so beside a distance above it."""
    rows = table(9e-10)
    rows["error.load.y"] = rows["error.load.z"] = rows["error.load.x"]
    errors = plot_run(rows, np.array([0.0]), "run", CRANES["lab"], ActuatorBounds()).axes[-1]
    assert errors.get_legend().get_title().get_text() == ""
    assert errors.get_ylabel() == "load error\n[µm]"


@pytest.mark.parametrize(("error", "unit"), [(2e-3, "mm"), (2.0, "mm"), (2e-8, "µm")])
def test_an_error_is_shown_in_the_unit_of_its_size(error: float, unit: str) -> None:
    errors = plot_run(
        table(error), np.array([0.0]), "run", CRANES["lab"], ActuatorBounds()
    ).axes[-1]
    factor = {"mm": 1e3, "µm": 1e6}[unit]
    assert errors.lines[0].get_ydata().max() == pytest.approx(factor * error, rel=0.01)
    assert errors.get_ylabel() == f"load error\n[{unit}]"
    assert not errors.texts
