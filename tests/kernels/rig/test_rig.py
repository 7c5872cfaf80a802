"""The loop's memory is its whole state; built-in controllers equal the same ones from outside."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.crane import Plant, Rig, Setpoints
from segfmu.crane import Sensors as Signals
from segfmu.kernels import backend
from segfmu.kernels.control.records import Correction
from segfmu.kernels.crane.records import Plant as Parameters
from segfmu.kernels.rig.events import next_change
from segfmu.kernels.rig.loop import switch_correction
from segfmu.kernels.rig.records import (
    Clock,
    Corrector,
    Loop,
    Memory,
    Sensors,
    Settings,
)
from segfmu.kernels.rig.rig import rig_imbalance
from tests.kernels.rigs import CONTROLLERS, HANGING, LAB, everything, feedback, tracking


def switched(enabled: bool, value: float, memory: np.ndarray) -> float:
    """The correction of a tick along x, of which a tenth of a jump at a switch is left a tick."""
    settings = np.zeros((Settings.LOOP + 1, Loop.SIZE))
    settings[Settings.LOOP, Loop.ENABLED] = float(enabled)
    settings[Settings.LOOP, Loop.PERIOD], settings[Settings.LOOP, Loop.FADE] = np.log(10.0), 1.0
    memory[Memory.CORRECTION, Correction.VALUE] = value
    switch_correction(settings, memory)
    return float(memory[Memory.CORRECTION, Correction.VALUE])


def test_only_a_switch_fades() -> None:
    memory = np.zeros((Memory.PLANT + 1, 100))
    # the first tick is no switch
    assert [switched(True, v, memory) for v in (1.0, 2.0)] == [1.0, 2.0]
    assert [switched(False, 9.0, memory) for _ in range(3)] == pytest.approx([0.2, 0.02, 0.002])
    assert [switched(True, 1.0, memory) for _ in range(2)] == pytest.approx([0.9002, 0.99002])


class Inside:
    """A built-in controller that the plant does not recognise."""

    def __init__(self, controller) -> None:
        self.controller = controller
        self.sample_time = controller.sample_time

    def sample(self, time, measured, reference, feedforward) -> np.ndarray:
        return self.controller.sample(time, measured, reference, feedforward)


class OnState:
    """State feedback in plain NumPy, told the plant afterwards."""

    sample_time = 0.01

    def __init__(self, driven: bool) -> None:
        self.gains = feedback(driven)
        self.plant: Plant | None = None

    def sample(self, time, measured, reference, feedforward) -> np.ndarray:
        state = self.plant.state
        table = self.gains.gains.reshape(self.gains.lengths.size, -1).T
        gain = [np.interp(state[2], self.gains.lengths, column) for column in table]
        # the gain by the velocity added is that of drives with lag, of which there are none here
        assert not np.array(gain).reshape(3, 11)[:, 10].any()
        return -np.array(gain).reshape(3, 11)[:, :10] @ (state - reference)


def start(controller, driven: bool, rig: Rig) -> Plant:
    state = HANGING.copy()
    state[3:5] = 0.1, -0.05
    first = Setpoints(np.array([0.0, 0.0, -9.81]), reference=HANGING)
    return Plant(LAB, state, first, controller, driven=driven, rig=rig, start_time=0.3)


def go(plant: Plant, first: int, last: int) -> np.ndarray:
    rows = []
    for i in range(first, last):
        share = i / 40
        force = np.array([share, share, -9.81 - share])
        plant.step(
            0.001 * (1 + i % 7),
            Setpoints(force, np.full(3, 0.1 * share), HANGING + 0.01 * share),
        )
        rows.append(np.concatenate([plant.state, plant.measured, plant.drive_force]))
    return np.array(rows)


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("kind", CONTROLLERS)
def test_a_copy_of_the_memory_is_the_state(kind: str, driven: bool) -> None:
    controller = CONTROLLERS[kind](driven)
    plant = start(controller, driven, everything())
    go(plant, 1, 17)
    arrays = [plant._memory]
    if kind == "tracking":
        arrays.append(controller.arrays[-1])
    saved = [array.copy() for array in arrays]
    first = go(plant, 17, 40)
    for array, copy in zip(arrays, saved, strict=True):
        array[:] = copy
    assert go(plant, 17, 40).tolist() == first.tolist()
    # another plant, which has seen something else, goes on in the same way
    other = start(CONTROLLERS[kind](driven), driven, everything())
    go(other, 1, 3)
    other._memory[:] = saved[0]
    if kind == "tracking":
        other._controller.arrays[-1][:] = saved[1]
    assert go(other, 17, 40).tolist() == first.tolist()


@pytest.mark.parametrize("driven", [False, True])
def test_tracking_is_the_same_inside_and_outside(driven: bool) -> None:
    rig = Rig(sensors=Signals(0.01, 0.01, (1e-4,) * 5))
    inside, outside = (
        start(c, driven, rig) for c in (tracking(driven), Inside(tracking(driven)))
    )
    assert [p._loop[Loop.CORRECTOR] for p in (inside, outside)] == [
        Corrector.TRACKING, Corrector.CALLER
    ]
    assert go(inside, 1, 60).tolist() == go(outside, 1, 60).tolist()


@pytest.mark.parametrize("driven", [False, True])
def test_state_feedback_is_the_same_inside_and_outside(driven: bool) -> None:
    controller = OnState(driven)
    inside, outside = (start(c, driven, Rig()) for c in (feedback(driven), controller))
    controller.plant = outside
    assert [p._loop[Loop.CORRECTOR] for p in (inside, outside)] == [
        Corrector.STATE, Corrector.CALLER
    ]
    assert go(inside, 1, 60) == pytest.approx(go(outside, 1, 60), abs=1e-9)


def test_a_tick_of_the_callers_controller_keeps_saturation() -> None:
    """The flags belong to the whole step, also where it is left for a tick and entered again."""
    push = Setpoints(np.array([0.0, 0.0, -9.81]), np.array([0.0, 0.0, 0.0]), HANGING)
    rig = everything()
    flags = []
    for kind in ("state", "custom"):
        plant = start(CONTROLLERS[kind](True), True, rig)
        plant.step(0.002, push)
        plant.step(0.02, Setpoints(push.force, np.array([0.2, 0.0, 0.0]), HANGING))
        flags.append(plant.saturated.tolist())
        plant.step(0.1, Setpoints(push.force, np.array([0.2, 0.0, 0.0]), HANGING))
    assert flags[0][0]
    assert flags[1][0]


def test_changes_are_where_mass_or_wind_change() -> None:
    rig = everything()
    memory = np.zeros((Memory.SIZE, Memory.COLUMNS))
    memory[Memory.PLANT, : Parameters.SIZE] = rig.parameters(LAB, False)
    memory[Memory.CLOCK, Clock.START] = 0.3
    found, time = [], 0.0
    while (time := next_change(rig.changes, time, memory)) < 1e300:
        found.append(time)
    assert found == pytest.approx([0.0333, 0.04, 0.0601, 0.5333])
    memory[Memory.PLANT, [Parameters.GUST_START, Parameters.GUST_DURATION]] = 0.0
    assert next_change(np.zeros((0, 2)), 0.0, memory) == 1e300


def test_imbalance_is_what_is_not_accounted_for() -> None:
    values = np.array([1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0])
    assert rig_imbalance(values) == 1.0 + 2.0 - 4.0 - 8.0 - 16.0 - 32.0 + 64.0


def test_memory_grows_with_what_is_on_its_way() -> None:
    rows = []
    for sample_time, sensing, drive in (
        (0.0, 0.0, 0.0), (0.01, 0.0, 0.0), (0.01, 1.0, 0.0), (0.01, 1.0, 0.1)
    ):
        settings = np.zeros((Settings.SIZE, Settings.COLUMNS))
        settings[Settings.LOOP, Loop.PERIOD] = 0.01
        settings[Settings.SENSORS, [Sensors.SAMPLE_TIME, Sensors.DEAD_TIME]] = sample_time, sensing
        settings[Settings.PLANT, Parameters.DEAD_TIME + 1] = drive
        rows.append(backend.rig_rows(settings))
    # two samples, and two beside the hundred that are younger than the dead time, twelve a row;
    # then twice 512 and 10 commands and 8, five a row, behind the state of their ring
    assert np.diff(rows).tolist() == [1, 8, 212]
