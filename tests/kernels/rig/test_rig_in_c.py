"""The sampled loop in a program without Python: the numbers of `Plant`, nothing out of bounds."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest

from segfmu.codegen.native import TARGET
from segfmu.crane import Plant, Rig, Sensors, Setpoints, SwayFeedback
from segfmu.crane.flat_model import GANTRY
from segfmu.kernels import backend
from segfmu.kernels.control.records import Tracking
from segfmu.kernels.crane.records import Plant as Parameters
from segfmu.kernels.rig.records import Corrector, Loop, Settings
from segfmu.kernels.rig.records import Sensors as Sensing
from tests.compiler import CC, SANITIZERS, STRICT, needs_cc
from tests.kernels.rigs import HANGING, LAB, everything, feedback, observer, tracking
from tests.sharing import shared

STEPS = 60

pytestmark = needs_cc


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory, sanitized_kernels: Path) -> Path:
    """The driver with the compiler's checks of memory and undefined behaviour."""
    def compiled(folder: Path) -> None:
        subprocess.run(
            [CC, *STRICT, *SANITIZERS, f"-I{TARGET}", Path(__file__).with_name("rig_driver.c"),
             sanitized_kernels, "-lm", "-o", folder / "driver"],
            check=True,
        )

    return shared(tmp_path_factory, "rig", compiled) / "driver"


def steps(driven: bool) -> list[tuple[float, Setpoints]]:
    """Durations and setpoints; the first is the start."""
    found = []
    for i in range(STEPS + 1):
        share = i / STEPS
        force, velocity = np.array([share, share, -9.81 - share]), np.full(3, 0.1 * share)
        found.append((0.001 * (1 + i % 7), Setpoints(force, velocity, HANGING + 0.01 * share)))
    return found


def settings(rig: Rig, controller, driven: bool) -> np.ndarray:
    """All that is set, a `Settings`."""
    found = np.zeros((Settings.SIZE, Settings.COLUMNS))
    on_state = isinstance(controller, SwayFeedback)
    corrector = Corrector.STATE if on_state else Corrector.TRACKING
    found[Settings.LOOP, : Loop.SIZE] = corrector, controller.sample_time, 1.0, 1e-10, 0.1
    found[Settings.SENSORS, : Sensing.SIZE] = rig.sensors.vector
    found[Settings.PLANT, : Parameters.SIZE] = rig.parameters(LAB, driven)
    if on_state:
        found[Settings.TRACKING, Tracking.PERIOD] = controller.sample_time
        backend.set_drives(found[Settings.PLANT], found[Settings.TRACKING])
    else:
        found[Settings.TRACKING, : Tracking.SIZE] = controller.parameters
    return found


def case(rig: Rig, kind: str, driven: bool) -> tuple[str, Plant]:
    """What the driver reads, and the same as a plant."""
    controller = feedback(driven) if kind == "state" else tracking(driven)
    start = HANGING.copy()
    start[3:5] = 0.1, -0.05
    table = steps(driven)
    plant = Plant(LAB, start, table[0][1], controller, driven=driven, rig=rig, start_time=0.3)
    seen, gains = observer(driven), feedback(driven)
    arrays = [
        settings(rig, controller, driven), GANTRY.kept(start), [0.3], rig.wind.components,
        rig.changes,
        seen.table, gains.table,
        *(np.append(duration, setpoints.vector) for duration, setpoints in table),
    ]
    sizes = len(rig.wind.components), len(rig.changes), len(seen.table), STEPS
    numbers = np.concatenate([np.ravel(a) for a in arrays])
    return " ".join(map(str, sizes)) + " " + " ".join(float(x).hex() for x in numbers), plant


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("kind", ["state", "tracking"])
@pytest.mark.parametrize("rig", [Rig(), everything(), Rig(sensors=Sensors(0.001, 0.0117))])
def test_c_steps_as_the_plant_and_its_memory_is_one_block(
    driver: Path, rig: Rig, kind: str, driven: bool
) -> None:
    text, plant = case(rig, kind, driven)
    done = subprocess.run(
        [driver], input=text, capture_output=True, text=True, check=True, timeout=60
    )
    rows = np.array([[float.fromhex(x) for x in line.split()] for line in done.stdout.splitlines()])
    expected = []
    for duration, setpoints in steps(driven)[1:]:
        plant.step(duration, setpoints)
        expected.append(np.concatenate([plant.state, plant.measured, plant.drive_force]))
    assert rows[:STEPS] == pytest.approx(np.array(expected), rel=1e-10, abs=1e-12)
    # from the middle on once more, after the block was put back
    again = STEPS - (STEPS + 1) // 2 + 1
    assert len(rows) == STEPS + again
    assert rows[STEPS:].tolist() == rows[STEPS - again : STEPS].tolist()
