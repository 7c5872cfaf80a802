"""A rig with everything on, and controllers of all kinds."""

from __future__ import annotations

from functools import cache

import numpy as np

from segfmu import Crane
from segfmu.crane import (
    Controller,
    Drive,
    Friction,
    Gust,
    PayloadChange,
    Rig,
    Sensors,
    SwayFeedback,
    Wind,
)
from segfmu.crane.feedback import design
from segfmu.crane.observer import Observer, design_observer
from segfmu.crane.tracking import TrackingController

LAB = Crane(2.2, 1.155, 1.0)
HANGING = LAB.hanging([0.0, 0.0, -0.5])


def everything() -> Rig:
    """Drives with lags and bounds, friction, noisy late sensors, wind, two payload changes."""
    return Rig(
        bridge=Drive(0.025, 30.0, 0.8), trolley=Drive(0.013, 25.0, 0.6, 0.0072),
        hoist=Drive(0.0, 40.0),
        friction=Friction((10.0, 8.0, 7.0), (0.5, 0.7, 1.0), 1e-2, 0.01),
        sensors=Sensors(0.004, 0.0093, (1e-4,) * 5, (1e-4,) * 5, (0.0, 0.0, 0.02, 0.0, 0.0), 3),
        wind=Wind(
            (0.05, 0.0, 0.0), Gust(0.3333, 0.5, (0.5, 0.4, 0.0)), (0.2, 0.1, 0.05), 3.0, seed=11
        ),
        payload=(PayloadChange(0.3601, 1.5), PayloadChange(0.34, 0.7)),
    )


@cache
def feedback(driven: bool) -> SwayFeedback:
    return design(LAB, sample_time=0.01, shortest=0.2, longest=1.0, rows=5, driven=driven)


@cache
def observer(driven: bool) -> Observer:
    return design_observer(
        LAB, sample_time=0.01, shortest=0.2, longest=1.0, rows=5, driven=driven, delayed=True
    )


def tracking(driven: bool) -> TrackingController:
    return TrackingController(observer(driven), feedback(driven))


class Proportional:
    """A controller that the kernels do not know."""

    sample_time = 0.007

    def sample(self, time, measured, reference, feedforward) -> np.ndarray:
        return -2.0 * (measured[:3] - reference[:3])


def proportional(driven: bool) -> Controller:
    return Proportional()


CONTROLLERS = {"state": feedback, "tracking": tracking, "custom": proportional}
