"""The wind as an input follows time within a step, as the forces of the drives do."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from segfmu import Crane
from segfmu.cosim import Change, System, native
from segfmu.crane import Plant, Setpoints
from segfmu.crane.feedback import design
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.slave import CraneSlave
from tests.fmu.bench import Inputs, Rows, SlaveBench, Values, bench
from tests.fmu.native.importer import Importer

LAB = Crane(2.2, 1.155, 1.0)
START: Values = {"feedback.enabled": False, "feedback.design": "flatness", "force.hoist": -9.81}
NAMES = ["bridge.velocity", "trolley.velocity", *(f"load.velocity.{a}" for a in "xyz")]
# s
STEP = 0.01
TIMES = STEP * np.arange(4)
# N.s; 1 N comes within the second step and stays
MOMENTA = pytest.approx([0.0, 0.0, 0.005, 0.015], abs=1e-10)
AXES = pytest.mark.parametrize("axis", range(3))
ENGINES = ("c", "python") if native.COMPILED else ("python",)


def momenta(velocities: np.ndarray) -> np.ndarray:
    """Momentum along x, y and z of rows of NAMES; the rope's weight and pull are in balance."""
    bridge, trolley, *load = np.asarray(velocities).T
    return np.array([3.355 * bridge + load[0], 1.155 * trolley + load[1], load[2]])


def pushed(names: list[str]) -> Inputs:
    """Inputs of 1 N from the second step's end on."""
    return lambda time: dict.fromkeys(names, 1.0 if time > 0.5 * STEP else 0.0)


def blowing(wind: np.ndarray) -> Values:
    return dict(zip(("wind.x", "wind.y", "wind.z"), wind, strict=True))


def table(rows: Rows | np.ndarray, names: list[str]) -> np.ndarray:
    return np.array([rows[n] for n in names]).T


@AXES
@pytest.mark.parametrize("kind", [2, 3, "python"])
def test_momentum_of_a_wind_is_that_of_a_force(native_fmus, kind: int | str, axis: int) -> None:
    def run(inputs: list[str]) -> np.ndarray:
        if kind == "python":
            runs = SlaveBench(CraneSlave, NAMES)
            return momenta(table(runs.run(START, pushed(inputs), TIMES), NAMES))
        with bench(native_fmus[kind][1], gantry_crane.native_spec(), NAMES) as others:
            return momenta(table(others.run(START, pushed(inputs), TIMES), NAMES))

    assert run([f"wind.{'xyz'[axis]}"])[axis] == MOMENTA
    if axis < 2:
        assert run([("force.bridge", "force.trolley")[axis]])[axis] == MOMENTA


@AXES
def test_plant_takes_the_wind_as_linear(axis: int) -> None:
    weight = np.array([0.0, 0.0, -9.81])
    gains = design(LAB, sample_time=0.01, shortest=0.3, longest=2.0)
    plant = Plant(LAB, LAB.hanging([0.0, 0.0, -0.5]), Setpoints(weight), gains, enabled=False)
    rows = []
    for time in TIMES:
        if time > 0.0:
            wind = (time > 1.5 * STEP) * np.eye(3)[axis]
            plant.step(STEP, Setpoints(weight, wind=wind))
        rows.append([*plant.state[5:7], *plant.load[1]])
    assert momenta(np.array(rows))[axis] == MOMENTA


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kind", [2, 3, "python"])
def test_wind_of_a_change_comes_within_a_step(
    native_fmus, fmus: tuple[Path, Path], engine: str, kind: int | str
) -> None:
    path = fmus[1] if kind == "python" else native_fmus[kind][1]
    with System({"crane": path}, step=STEP, engine=engine) as system:
        rows = system.run(
            {"crane": START}, stop_time=TIMES[-1], changes=[Change(STEP, "crane", {"wind.x": 1.0})]
        )
    assert momenta(table(rows, NAMES))[0] == MOMENTA


def test_wind_by_its_derivatives(native_fmus) -> None:
    """1 N/s and 4 N/s2 and 6 N/s3 from the step's beginning on: their integrals."""
    with Importer(native_fmus[2][1]) as fmu:
        fmu.set(START)
        fmu.initialise()
        wind = fmu.variables["wind.y"].valueReference
        fmu.fmu.setRealInputDerivatives([wind] * 3, [1, 2, 3], [1.0, 4.0, 6.0])
        fmu.step(0.0, 0.1)
        expected = 0.1**2 / 2.0 + 4.0 * 0.1**3 / 6.0 + 6.0 * 0.1**4 / 24.0
        assert momenta(fmu.get(*NAMES)[None])[1] == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("values", [{}, {"drive.mode": "velocity"}])
def test_backends_agree_on_a_changing_wind_at_any_step(native_fmus, values: Values) -> None:
    winds = np.random.default_rng(5).uniform(-1.0, 1.0, (30, 3))
    step, names = 0.013, [*gantry_crane.STATE, "energy.wind", "power.wind"]

    def coarse(time: float) -> Values:
        return blowing(winds[round(time / step)])

    def fine(time: float) -> Values:
        """Of half steps: the same wind, linear in time."""
        number = round(2.0 * time / step)
        last = winds[number // 2]
        return blowing(last if number % 2 else (last + winds[max(number // 2 - 1, 0)]) / 2.0)

    times = np.arange(30) * step
    runs = SlaveBench(CraneSlave, names)
    found = table(runs.run(START | values, coarse, times), names)
    halves = table(runs.run(START | values, fine, np.arange(59) * step / 2.0), names)
    assert halves[::2] == pytest.approx(found, abs=1e-8)
    for fmi in (2, 3):
        with bench(native_fmus[fmi][1], gantry_crane.native_spec(), names) as others:
            rows = table(others.run(START | values, coarse, times), names)
        assert rows == pytest.approx(found, rel=1e-9, abs=1e-12)
