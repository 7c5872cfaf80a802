"""HookCrane as native FMUs of both versions: checked by fmpy, against Newton's and the plant."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Slave
from scipy.integrate import solve_ivp

from segfmu.crane import Crane, Drive, Friction, Plant, Rig, Sensors, Setpoints
from segfmu.crane.hook import HookController, HookCrane, design_hook
from segfmu.kernels.hook.records import HookState
from tests.crane.hook_newton import forced
from tests.fmu.checking import faults

KINDS = [(fmi, kind) for fmi in (2, 3) for kind in ("CoSimulation", "ModelExchange")]
NAMES = tuple(v for f in HookState.FIELDS.values() for v in f.variables)
MASSES = np.array([2.2, 1.155, 1.0, 9.81, 0.1, 0.3])
SWAYING = np.array(
    [0.1, -0.2, 0.6, 0.2, -0.1, -0.3, 0.4, 0.1, -0.05, 0.02, 0.3, -0.2, 0.5, 0.6]
)
START = dict(zip(NAMES, SWAYING.tolist(), strict=True))


@pytest.fixture(scope="module")
def archives(hook_fmus: dict[int, tuple[Path, Path]]) -> dict[int, Path]:
    """The archive by version of FMI."""
    return {fmi: crane for fmi, (_, crane) in hook_fmus.items()}


def simulated(archive: Path, kind: str, start: dict[str, float], stop: float) -> np.ndarray:
    outputs = [*NAMES, "load.position.x", "load.position.y", "load.position.z", "hook.position.x",
               "hook.position.y", "hook.position.z", "sling.tension", "energy.imbalance",
               "drive.bridge.force", "sway.frequency.slow", "sway.frequency.fast"]
    rows: np.ndarray = simulate_fmu(
        str(archive), fmi_type=kind, stop_time=stop, step_size=0.01, output_interval=0.01,
        start_values=start, relative_tolerance=1e-10, output=outputs,
    )
    return rows


@pytest.mark.parametrize("fmi", [2, 3])
def test_fmpy_finds_nothing(archives, fmi: int) -> None:
    assert faults(archives[fmi]) == []


@pytest.mark.parametrize(("fmi", "kind"), KINDS)
def test_large_swings_are_newtons(archives, fmi: int, kind: str) -> None:
    force = np.array([0.8, -0.5, -10.9])
    start = START | dict(zip(("force.bridge", "force.trolley", "force.hoist"), force, strict=True))
    rows = simulated(archives[fmi], kind, start, 1.0)
    run = solve_ivp(
        lambda _, x: [*x[7:], *forced(x, force, np.zeros(3), MASSES).coordinates], (0.0, 1.0),
        SWAYING, method="DOP853", rtol=1e-12, atol=1e-13, dense_output=True,
    )
    states = run.sol(rows["time"])
    for name, values in zip(NAMES, states, strict=True):
        assert rows[name] == pytest.approx(values, abs=2e-6), name
    below = rows["load.position.z"] - rows["hook.position.z"]
    expected = -0.3 * np.cos(states[5]) * np.cos(states[6])
    assert below == pytest.approx(expected, abs=2e-6)
    # roots of m_h l s w^4 - M g (l + s) w^2 + M g^2 = 0
    for name in ("sway.frequency.slow", "sway.frequency.fast"):
        square, rope = rows[name] ** 2, rows["rope.length"]
        terms = 0.1 * rope * 0.3 * square**2, 1.1 * 9.81 * (rope + 0.3) * square, 1.1 * 9.81**2
        assert terms[0] - terms[1] + terms[2] == pytest.approx(0.0, abs=1e-8 * terms[2])
    tension = forced(states[:, -1], force, np.zeros(3), MASSES).tension
    assert rows["sling.tension"][-1] == pytest.approx(tension, abs=1e-4)
    assert abs(rows["energy.imbalance"]).max() <= 1e-6


@pytest.mark.parametrize("fmi", [2, 3])
def test_real_drives_are_the_plants(archives, fmi: int) -> None:
    """C and the Python simulation use one set of kernels."""
    values = {
        "drive.bridge.lag": 0.05, "drive.bridge.force_max": 1.0, "friction.bridge.coulomb": 0.1,
        "friction.bridge.static": 0.1, "friction.sway.viscous": 0.01, "drive.mode": 2,
        "velocity.bridge": 0.4,
    }
    rows = simulated(archives[fmi], "CoSimulation", START | values, 1.0)
    rig = Rig(bridge=Drive(lag=0.05, force_max=1.0),
              friction=Friction(coulomb=(0.1, 0.0, 0.0), static=(0.1, 0.0, 0.0), sway=0.01))
    given = Setpoints(np.zeros(3), np.array([0.4, 0.0, 0.0]), np.zeros(10))
    plant = Plant(HookCrane(Crane(*MASSES[:4]), 0.1, 0.3), SWAYING, given, Idle(), driven=True,
                  rig=rig)
    for _ in range(100):
        plant.step(0.01, given)
    assert [rows[n][-1] for n in NAMES] == pytest.approx(plant.state.tolist(), abs=1e-9)
    assert rows["drive.bridge.force"][-1] == pytest.approx(plant.drive_force[0], abs=1e-9)


FEEDBACK = {"feedback.enabled": True, "crane.rope_min": 0.2, "crane.rope_max": 1.2}
# hanging at rest aside from the reference, hook and sling at other angles
ASIDE = {
    "rope.length": 0.6, "sway.x.angle": 0.1, "sway.y.angle": -0.08, "sling.x.angle": -0.05,
    "sling.y.angle": 0.12, "reference.rope.length": 0.6, "start.on_reference": False,
}


@pytest.mark.parametrize(("fmi", "driven"), [(2, False), (2, True), (3, True)])
def test_the_feedback_is_that_of_python(archives, fmi: int, driven: bool) -> None:
    """Designed in C at initialisation: the same corrections.

    With lag, sensors, bounds of velocities, and another load and sling than it is designed for.
    """
    lag, most = (0.03, 0.2) if driven else (0.0, 0.0)
    values = FEEDBACK | ASIDE | {
        "drive.mode": 1 + driven, "crane.payload_mass": 1.3, "feedback.payload_mass": 1.0,
        "hook.sling": 0.33, "feedback.sling": 0.3,
        "force.hoist": -1.1 * 9.81, "sensor.sample_time": 0.01,
        "sensor.bridge.position.resolution": 1e-4, "sensor.sway.x.angle.resolution": 1e-3,
    } | {f"drive.{d}.lag": lag for d in ("bridge", "trolley", "hoist")}
    values |= {f"drive.{d}.velocity_max": most for d in ("bridge", "trolley", "hoist")}
    rows = simulated(archives[fmi], "CoSimulation", values, 4.0)
    plain = Crane(*MASSES[:2], 1.3, rope_min=0.2, rope_max=1.2)
    rig = Rig(*(Drive(lag=lag, velocity_max=most or None) for _ in range(3)),
              sensors=Sensors(sample_time=0.01, resolution=(1e-4, 0.0, 0.0, 1e-3, 0.0)))
    expected = HookCrane(Crane(*MASSES[:4]), 0.1, 0.3)
    feedback = design_hook(
        expected, sample_time=0.01, shortest=0.2, longest=1.2, driven=driven, lag=lag
    )
    start = np.zeros(14)
    start[2], start[3:7] = 0.6, (0.1, -0.08, -0.05, 0.12)
    reference = np.array([0.0, 0.0, 0.6, *np.zeros(7)])
    given = Setpoints(np.array([0.0, 0.0, -1.1 * 9.81]), np.zeros(3), reference)
    speed = most or 1e99
    controller = HookController(feedback, velocity_min=-speed, velocity_max=speed)
    plant = Plant(HookCrane(plain, 0.1, 0.33), start, given, controller, driven=driven, rig=rig)
    for i in range(1, 401):
        plant.step(0.01, given)
        if i % 50 == 0:
            found = [rows[n][i] for n in NAMES]
            assert found == pytest.approx(plant.state.tolist(), abs=1e-7)
    # it has calmed down
    assert np.abs(plant.state[3:7]).max() < 0.01


def test_a_swing_without_feedback_goes_on(archives) -> None:
    rows = simulated(archives[2], "CoSimulation", ASIDE | {"feedback.enabled": False}, 4.0)
    assert np.abs(rows["sling.y.angle"][-100:]).max() > 0.05


def test_model_exchange_has_no_feedback_of_measured_signals(archives) -> None:
    messages: list[str] = []
    with pytest.raises(Exception, match="fmi2"):
        simulate_fmu(str(archives[2]), fmi_type="ModelExchange", stop_time=0.1,
                     start_values=FEEDBACK, logger=lambda *m: messages.append(str(m[-1])))
    assert any("needs co-simulation" in m for m in messages), messages


class Idle:
    """A controller that corrects nothing."""

    sample_time = 0.01

    def sample(self, time, measured, reference, setpoint):
        return np.zeros(3)


def test_it_starts_on_its_reference(archives) -> None:
    """Start values of the sling are deviations from its reference."""
    start = {f"reference.{n}": v for n, v in START.items()} | {"sling.x.angle": 0.05}
    rows = simulated(archives[2], "CoSimulation", start, 0.01)
    expected = SWAYING.copy()
    expected[5] += 0.05
    assert [rows[n][0] for n in NAMES] == pytest.approx(expected.tolist(), abs=1e-12)


def test_it_hangs_at_rest_without_connections(archives) -> None:
    rows = simulated(archives[3], "CoSimulation", {}, 2.0)
    for name in NAMES:
        assert rows[name] == pytest.approx(rows[name][0], abs=1e-12), name


@pytest.mark.parametrize(
    ("values", "text"),
    [({"rope.slack": 2}, r"with a sling rope\.slack must be error"),
     ({"sling.x.angle": 1.6}, r"sling\.x\.angle must start within 90 degrees"),
     ({"wind.z": 10.3, "drive.mode": 2}, "the sling went slack")],
)
def test_what_cannot_be_is_told(archives, values, text: str) -> None:
    messages: list[str] = []
    with pytest.raises(Exception, match="fmi2"):
        simulate_fmu(
            str(archives[2]), stop_time=1.0, start_values=values, debug_logging=True,
            logger=lambda *m: messages.append(str(m[-1])),
        )
    assert any(re.search(text, m) for m in messages), messages


def test_a_saved_state_has_the_estimates(archives, tmp_path: Path) -> None:
    """With feedback, what follows a restored state is what followed it before, bit for bit."""
    description = read_model_description(str(archives[2]))
    references = {v.name: v.valueReference for v in description.modelVariables}
    unit = FMU2Slave(
        guid=description.guid, unzipDirectory=extract(str(archives[2]), str(tmp_path)),
        modelIdentifier=description.coSimulation.modelIdentifier, instanceName="hook",
    )
    unit.instantiate()
    unit.setupExperiment(startTime=0.0)
    for name, value in (FEEDBACK | ASIDE).items():
        setter = unit.setBoolean if isinstance(value, bool) else unit.setReal
        setter([references[name]], [value])
    unit.enterInitializationMode()
    unit.exitInitializationMode()

    def go(first: int, last: int) -> list[float]:
        for i in range(first, last):
            unit.doStep(0.01 * i, 0.01)
        found: list[float] = unit.getReal([references[n] for n in NAMES])
        return found

    go(0, 50)
    saved = unit.getFMUstate()
    once = go(50, 100)
    unit.setFMUstate(saved)
    assert go(50, 100) == once
    assert once[4] != 0.0
    unit.freeFMUstate(saved)
    unit.terminate()
    unit.freeInstance()
