"""Dead times of the drives: what arrives is what was sent a dead time ago."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from segfmu import Crane, InputError
from segfmu.crane import Drive, Plant, Rig, Setpoints
from segfmu.kernels.rig.delay import delay_rows
from segfmu.kernels.rig.records import CommandQueue, Delay, Delayed
from tests.kernels.rigs import CONTROLLERS, LAB

STS = Crane(300e3, 15e3, 40e3)
# a load so light that the carriages do not feel it
BARE = {c: replace(c, payload_mass=1e-9) for c in (LAB, STS)}


class Ramp:
    """Corrections that grow from tick to tick: 1, 2, 3 ..."""

    def __init__(self, period: float, size: float = 1.0) -> None:
        self.sample_time, self.size, self.ticks = period, size, 0

    def sample(self, time, measured, reference, feedforward) -> np.ndarray:
        self.ticks += 1
        return np.array([self.size * self.ticks, 0.0, 0.0])


class Off(Ramp):
    """No corrections."""

    def __init__(self) -> None:
        super().__init__(0.01, 0.0)


def late(crane: Crane, controller, delays, *, driven: bool, lag: float = 0.0) -> Plant:
    drives = [Drive(lag, dead_time=d) for d in delays]
    start = crane.hanging([0.0, 0.0, -0.5 if crane.payload_mass < 10.0 else -20.0])
    force = np.array([0.0, 0.0, -crane.payload_mass * crane.gravity])
    first = Setpoints(force, reference=start)
    return Plant(crane, start, first, controller, driven=driven, rig=Rig(*drives))


def run(plant: Plant, sent, step: float, until: float) -> None:
    """Velocity setpoints (3,) over time, linear in each step."""
    for i in range(1, round(until / step) + 1):
        plant.step(step, Setpoints(plant_force(plant), sent(i * step)))


def plant_force(plant: Plant) -> np.ndarray:
    return np.array([0.0, 0.0, -plant.payload_mass * 9.81])


@pytest.mark.parametrize("step", [0.002, 0.01, 0.05, 0.1])
@pytest.mark.parametrize("crane", [LAB, STS], ids=["lab", "sts"])
def test_ramp_arrives_after_the_dead_time_of_each_drive(crane: Crane, step: float) -> None:
    delays, slopes = np.array([0.02, 0.0317, 0.0]), np.array([0.4, 0.3, -0.1])
    plant = late(crane, Off(), delays, driven=True)
    before = plant.state
    run(plant, lambda t: slopes * t, step, 0.4)
    state, left = plant.state, 0.4 - delays
    assert state[5:8] == pytest.approx(slopes * left, abs=1e-12)
    # the one without lag has its setpoint at the end of each interval
    assert state[:3] - before[:3] == pytest.approx(0.5 * slopes * left**2, abs=1e-9)


@pytest.mark.parametrize("step", [0.01, 0.037, 0.37])
def test_lag_follows_behind_the_dead_time(step: float) -> None:
    plant = late(LAB, Off(), (0.02, 0.0, 0.0), driven=True, lag=0.1)
    run(plant, lambda t: np.array([0.3 * t, 0.0, 0.0]), step, 0.37)
    t = 0.35
    assert plant.state[5] == pytest.approx(0.3 * (t - 0.1 * (1.0 - np.exp(-t / 0.1))), abs=1e-9)


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("delay", [1e-6, 0.003, 0.01, 0.0234, 0.5])
@pytest.mark.parametrize("crane", [LAB, STS], ids=["lab", "sts"])
def test_corrections_of_the_ticks_arrive_late_too(
    crane: Crane, delay: float, driven: bool
) -> None:
    """A force of n at tick n, and an acceleration with velocity drives."""
    mass = 1.0 if driven else crane.bridge_mass + crane.trolley_mass
    size = 0.01 * mass
    plant = late(BARE[crane], Ramp(0.01, size), (delay, 0.0, 0.0), driven=driven)
    for _ in range(40):
        plant.step(0.007, Setpoints(plant_force(plant)))
    arrived = max(0.28 - delay, 0.0)
    whole = int(arrived / 0.01 + 1e-9)
    gained = 0.01 * whole * (whole + 1) / 2 + (arrived - 0.01 * whole) * (whole + 1)
    assert plant.state[5] == pytest.approx(size / mass * gained, rel=1e-8, abs=1e-12)


def test_start_holds_until_the_dead_time_has_passed() -> None:
    plant = late(LAB, Off(), (0.0, 0.1, 0.0), driven=False)
    force = np.array([0.0, 1.0, -9.81])
    for _ in range(9):
        plant.step(0.01, Setpoints(force))
        assert plant.state[6] == 0.0
    plant.step(0.1, Setpoints(force))
    assert plant.state[6] > 0.0


def test_ring_is_large_enough_for_tiny_steps() -> None:
    """Steps of 2 us within 20 ms: short commands are joined, and the delay stays exact."""
    plant = late(LAB, Ramp(0.01, 0.0), (0.02, 0.0, 0.0), driven=True)
    for i in range(1, 12001):
        plant.step(2e-6, Setpoints(plant_force(plant), np.array([(i * 2e-6) ** 2, 0.0, 0.0])))
    assert plant.state[5] == pytest.approx(0.004**2, abs=1e-9)
    memory = plant._memory
    first = memory.shape[0] - delay_rows(0.02, 0.01)
    waiting = memory[first + Delayed.QUEUE, CommandQueue.WAITING]
    assert 400 < waiting < Delay.COMMANDS_A_ROW * (delay_rows(0.02, 0.01) - Delayed.RING)


def test_no_dead_time_no_memory() -> None:
    assert delay_rows(0.0, 0.01) == 0


def test_too_long_a_dead_time_is_refused_by_name() -> None:
    refused = r"drive\.trolley\.dead_time 1000000000 s is longer than 1000"
    with pytest.raises(InputError, match=refused):
        late(LAB, Off(), (0.0, 1e9, 0.0), driven=False)


@pytest.mark.parametrize("kind", CONTROLLERS)
@pytest.mark.parametrize("driven", [False, True])
def test_communication_step_does_not_matter(kind: str, driven: bool) -> None:
    """Setpoints rise evenly, so that they do not depend on the steps."""
    ends = []
    for steps in (6, 60, 600):
        plant = late(LAB, CONTROLLERS[kind](driven), (0.013, 0.007, 0.02), driven=driven, lag=0.02)
        for i in range(1, steps + 1):
            share = i / steps
            plant.step(
                0.3 / steps,
                Setpoints(np.array([share, share, -9.81]), np.array([0.1, 0.2, 0.1]) * share,
                          LAB.hanging([0.0, 0.0, -0.5])),
            )
        ends.append(plant.state)
    assert ends[1] == pytest.approx(ends[0], abs=1e-8)
    assert ends[2] == pytest.approx(ends[0], abs=1e-8)
