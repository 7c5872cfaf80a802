"""Parameters of the tracking controller, against what they mean."""

from __future__ import annotations

from math import exp

import numpy as np
import pytest

from segfmu.kernels.control.design import rope_range, table_lengths
from segfmu.kernels.control.records import RopeRange, Tracking, TrackingDesign
from segfmu.kernels.control.setting import (
    drive_bound,
    nominal_payload,
    set_drives,
    set_fading,
    set_tracking,
    signal_age,
)
from segfmu.kernels.crane.records import DriveMode, Masses, Plant

pytestmark = pytest.mark.interpreted

PERIOD, LONGEST = 0.02, 1.5


def plant(mode: int) -> np.ndarray:
    found = np.zeros(Plant.SIZE)
    found[: Masses.SIZE] = 2.2, 1.155, 1.0, 9.81
    found[Plant.MODE] = mode
    found[Plant.FORCE_MAX : Plant.FORCE_MIN] = 4.0, 0.0, 6.0
    found[Plant.ACCELERATION_MAX : Plant.ACCELERATION_MIN] = 0.0, 0.5, 0.6
    return found


def tracking(mode: int, dead_time: float) -> np.ndarray:
    found, design = np.zeros(Tracking.SIZE), np.zeros(TrackingDesign.SIZE)
    found[Tracking.PERIOD] = PERIOD
    design[: TrackingDesign.WAKE] = 1e-4, 2e-4, 1e-3, 0.3, 0.1
    design[TrackingDesign.WAKE :] = 2.0, 0.05, dead_time, 0.0, 4.0
    set_tracking(plant(mode), design, LONGEST, found)
    return found


@pytest.mark.parametrize("mode", [DriveMode.FORCE, DriveMode.VELOCITY])
def test_tracking_follows_from_crane_and_expectations(mode: int) -> None:
    found = tracking(mode, 0.0)
    assert found[Tracking.MODE] == mode
    assert found[Tracking.MASSES : Tracking.GRAVITY] == pytest.approx([3.355, 1.155, 1.0])
    assert found[Tracking.GRAVITY] == 9.81
    # the bridge by its force, with trolley and load
    by_force = 4.0 / (2.2 + 1.155 + 1.0)
    most = [4.0, 1e99, 6.0] if mode == DriveMode.FORCE else [by_force, 0.5, 9.81e-3]
    least = found[Tracking.LEAST : Tracking.GREATEST]
    assert least == pytest.approx([-m for m in most])
    assert [drive_bound(plant(mode), i, -1.0) for i in range(3)] == pytest.approx(most)
    # a hoist cannot push
    pull = 0.0 if mode == DriveMode.FORCE else 0.6
    assert found[Tracking.GREATEST : Tracking.GAINS_PAYLOAD] == pytest.approx([*most[:2], pull])
    assert found[Tracking.PAYLOAD_SHARE] == PERIOD / 4.0
    assert found[Tracking.WAKE_ANGLE] == 2e-3
    assert found[Tracking.POSITION_VARIANCE] == pytest.approx(4e-8 / 12.0)


@pytest.mark.parametrize("mode", [DriveMode.FORCE, DriveMode.VELOCITY])
def test_setpoints_are_bounded_by_their_direction(mode: int) -> None:
    own, found = plant(mode), np.zeros(Tracking.SIZE)
    own[Plant.FORCE_MIN : Plant.FORCE_MIN + 3] = -8.0, -0.7, -15.0
    own[Plant.ACCELERATION_MIN : Plant.ACCELERATION_MIN + 3] = -5.0, -0.9, -0.4
    own[Plant.VELOCITY_MIN : Plant.VELOCITY_MIN + 3] = -0.1, 0.0, -0.2
    set_drives(own, found)
    least = found[Tracking.LEAST : Tracking.GREATEST]
    greatest = found[Tracking.GREATEST : Tracking.GAINS_PAYLOAD]
    if mode == DriveMode.FORCE:
        assert least.tolist() == [-8.0, -0.7, -15.0]
        assert greatest.tolist() == [4.0, 1e99, 0.0]
    else:
        # the bridge and the lowered trolley by their forces, with the load
        assert least == pytest.approx([-8.0 / 4.355, -0.7 / 2.155, -0.4])
        assert greatest == pytest.approx([4.0 / 4.355, 0.5, 0.6])
    assert found[Tracking.VELOCITY_MIN : Tracking.POWER_MAX].tolist() == [-0.1, 0.0, -0.2]


@pytest.mark.parametrize(
    ("dead_time", "sampling", "age"),
    # continuous; in step, rounded up to samples; finer samples; out of step, half a sample more
    [(0.013, 0.0, 0.013), (0.0, 0.02, 0.0), (0.005, 0.02, 0.02), (0.04, 0.02, 0.04),
     (0.013, 0.005, 0.015), (0.02, 0.03, 0.035)],
)
def test_signals_are_as_old_as_their_sample(
    dead_time: float, sampling: float, age: float
) -> None:
    assert signal_age(dead_time, sampling, PERIOD) == pytest.approx(age)


def test_delays_are_those_of_signals_and_drives() -> None:
    drives = plant(DriveMode.VELOCITY)
    drives[Plant.DEAD_TIME : Plant.DEAD_TIME + 3] = 0.0, 0.01, 0.05
    found, design = np.zeros(Tracking.SIZE), np.ones(TrackingDesign.SIZE)
    design[TrackingDesign.DEAD_TIME], design[TrackingDesign.SAMPLING] = 0.03, 0.02
    found[Tracking.PERIOD] = PERIOD
    set_tracking(drives, design, LONGEST, found)
    assert found[Tracking.AGE] == pytest.approx(2.0)
    assert found[Tracking.DELAY : Tracking.DELAY + 3] == pytest.approx([2.0, 2.5, 4.5])


@pytest.mark.parametrize("fade", [0.0, 0.1])
def test_a_switching_step_decays(fade: float) -> None:
    found = tracking(DriveMode.FORCE, 0.0)
    found[Tracking.FADE] = fade
    set_fading(found)
    assert found[Tracking.DECAY] == (exp(-PERIOD / fade) if fade else 0.0)


def test_no_expected_payload_is_that_of_the_crane() -> None:
    assert nominal_payload(0.0, 1.5) == 1.5
    assert nominal_payload(2.0, 1.5) == 2.0


@pytest.mark.parametrize(
    ("bounds", "expected"), [((0.16, 1.5), (0.16, 1.5)), ((0.0, 0.0), (0.1, 2.5))]
)
def test_a_table_without_bounds_is_about_the_start(bounds, expected) -> None:
    found = np.zeros(RopeRange.SIZE)
    rope_range(0.5, *bounds, found)
    assert found.tolist() == list(expected)


def test_lengths_of_a_table_meet_both_ends() -> None:
    lengths = np.zeros(17)
    assert table_lengths(0.16, 1.5, 17, lengths) == 17
    assert lengths[[0, -1]].tolist() == [0.16, 1.5]
    assert np.ptp(lengths[1:] / lengths[:-1]) < 1e-14
    assert table_lengths(0.5, 0.5, 17, lengths) == 1
