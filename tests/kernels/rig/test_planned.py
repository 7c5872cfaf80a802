"""What a controller is told that the velocity setpoints make of the drives, by the drives."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from segfmu import Crane
from segfmu.crane import Drive, Plant, Rig, Setpoints

CRANES = {"lab": (Crane(2.2, 1.155, 1.0), 0.8), "ship": (Crane(300e3, 15e3, 40e3), 35.0)}
PERIOD = 0.01
SIZES = pytest.mark.parametrize("size", CRANES)
LAGS = pytest.mark.parametrize("lag", [0.003, 0.05, 0.5])


class Idle:
    """Corrects nothing and remembers the accelerations that it is told."""

    sample_time = PERIOD

    def __init__(self) -> None:
        self.told: list[np.ndarray] = []

    def sample(self, time, measured, reference, feedforward) -> np.ndarray:
        self.told.append(feedforward)
        return np.zeros(3)


def told(size: str, drive: Drive, setpoint: Callable[[float], float], step: float) -> np.ndarray:
    """Of the trolley for 1 s: the accelerations told, and those of the drive at the ticks."""
    crane, rope = CRANES[size]
    start = crane.hanging([0.0, 0.0, -rope])
    idle = Idle()
    plant = Plant(
        crane, start, Setpoints(reference=start), idle, driven=True, rig=Rig(trolley=drive)
    )
    found = []
    for i in range(round(1.0 / step)):
        if i % round(PERIOD / step) == 0:
            behind = (setpoint(i * step) - plant.state[6]) / drive.lag
            found.append(np.clip(behind, -drive.acceleration_max, drive.acceleration_max))
        value = setpoint((i + 1) * step)
        plant.step(step, Setpoints(velocity=[0.0, value, 0.0], reference=start))
    return np.array([np.array(idle.told)[:, 1], found])


@pytest.mark.parametrize("step", [0.01, 0.002])
@LAGS
@SIZES
def test_a_ramp_of_the_setpoint_is_an_acceleration_that_rises_with_the_lag(
    size: str, lag: float, step: float
) -> None:
    found, real = told(size, Drive(lag, acceleration_max=9.0), lambda t: 0.4 * t, step)
    ticks = PERIOD * np.arange(found.size)
    assert found == pytest.approx(0.4 * (1.0 - np.exp(-ticks / lag)), abs=1e-9)
    # that of the drive is a difference of velocities over the lag
    assert found == pytest.approx(real, abs=1e-7)


@LAGS
@SIZES
def test_a_plan_is_known_to_the_period(size: str, lag: float) -> None:
    """A setpoint of v + lag v', whose slope exceeds the acceleration by far at its jerks."""
    wave = 2.0 * np.pi

    def setpoint(t: float) -> float:
        return (1.0 - np.cos(wave * t)) / wave + lag * np.sin(wave * t)

    found, real = told(size, Drive(lag, acceleration_max=1.0), setpoint, 0.001)
    planned = np.sin(wave * PERIOD * np.arange(found.size))
    assert np.abs(found - planned).max() < 0.5 * wave * PERIOD
    assert np.abs(real - planned).max() < 1e-2


@SIZES
def test_a_setpoint_beyond_the_drive_is_followed_at_its_bound(size: str) -> None:
    """A jump by 1 m/s at 2 m/s2 with a lag of 0.1 s: at the bound until 0.2 m/s are missing."""
    found, real = told(
        size, Drive(0.1, acceleration_max=2.0), lambda t: float(t > 0.0), PERIOD
    )
    assert np.minimum(found, 2.0) == pytest.approx(real, abs=0.03)
    assert (found[2:40] > 2.0 - 1e-9).all()
    assert found[-1] < 0.03


def test_velocities_beyond_the_drive_do_not_count() -> None:
    found, real = told(
        "lab", Drive(0.1, velocity_max=0.3, acceleration_max=9.0), lambda t: 0.6 * t, 0.002
    )
    assert found[60:] == pytest.approx(0.6 * np.exp(-(PERIOD * np.arange(60, 100) - 0.5) / 0.1),
                                       abs=2e-2)
