"""Feedback of a crane that follows its plan exactly: it has nothing to do, and must do nothing.

The drives can just do what the plan asks of them.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from segfmu import Crane, FlatInverse, Limits, Waypoint, plan
from segfmu.crane import Drive, Plant, Rig, Setpoints
from segfmu.crane.feedback import SwayFeedback, design
from segfmu.crane.feedforward import Compensation, Feedforward
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.inverse import DRIVE_ACCELERATION, FORCE, VELOCITY
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.tracking import TrackingController
from tests.campaign import soaked

CRANES = {"lab": Crane(2.2, 1.155, 1.0), "ship": Crane(300e3, 15e3, 40e3)}
# lengths of rope [m]
ROPE = {"lab": 0.8, "ship": 35.0}
# in units of gravity and the pendulum's time; the carriages follow the load's snap
SNAPS = (1.0, 30.0)
KINDS = ("lqr", "flatness", "measured")
SIZES = pytest.mark.parametrize("size", CRANES)


def pendulum(size: str) -> float:
    """Time of the pendulum [s], in which a crane of any size moves alike."""
    return float(np.sqrt(ROPE[size] / 9.81))


@cache
def moved(size: str, snap: float) -> FlatInverse:
    """A diagonal move with hoisting."""
    rope, time = ROPE[size], pendulum(size)
    acceleration = 0.05 * 9.81
    limits = Limits(0.2 * 9.81 * time, acceleration, 4.0 * acceleration / time,
                    snap * 9.81 / time**2)
    points = [
        Waypoint([0.0, 0.0, -rope]), Waypoint([0.3 * rope, 0.8 * rope, -0.7 * rope]),
    ]
    return FlatInverse(CRANES[size], plan(points, limits))


def feedback(
    kind: str, size: str, lag: float, dead: float
) -> SwayFeedback | TrackingController:
    """One that is awake from the start."""
    crane, rope = CRANES[size], ROPE[size]
    ranges = {
        "sample_time": 0.04 * pendulum(size), "shortest": 0.6 * rope, "longest": 1.1 * rope,
        "driven": True, "lag": (lag,) * 3, "rows": 5,
    }
    chosen = design_flat if kind == "flatness" else design
    gains = chosen(crane, dead_time=dead, **ranges)
    if kind != "measured":
        return gains
    return TrackingController(
        design_observer(
            crane, dead_time=(dead,) * 3, uncertainty=Uncertainty(wake=0.0), **ranges
        ),
        gains,
    )


def bounded(
    controller: SwayFeedback | TrackingController, drives: tuple[Drive, ...]
) -> SwayFeedback | TrackingController:
    """The controller that knows what the drives can do; on the true state it does anyway."""
    if isinstance(controller, SwayFeedback):
        return controller
    most = np.array([drive.acceleration_max or 1e99 for drive in drives])
    return TrackingController(
        controller.observer, controller.feedback, lower=-most, upper=most,
        power_max=[drive.power_max or 0.0 for drive in drives],
    )


def drives_of(
    flat: FlatInverse, lag: float, dead: float, room: float, by: str
) -> tuple[Drive, ...]:
    """Drives whose acceleration, force or power is `room` times what a plan asks of them."""
    found = flat.evaluate(np.linspace(0.0, flat.trajectory.duration, 4001))
    asked = {
        "acceleration": found[:, DRIVE_ACCELERATION], "force": found[:, FORCE],
        "power": found[:, FORCE] * found[:, VELOCITY],
    }
    most = room * np.abs(asked[by]).max(axis=0)
    return tuple(
        Drive(lag, dead_time=dead, **{f"{by}_max": float(value)}) for value in most
    )


def run(
    kind: str, size: str, lag: float, snap: float, *, dead: float = 0.0, room: float = 1.0,
    by: str = "acceleration", enabled: bool = True,
) -> np.ndarray:
    """Distances of the load from its plan over the length of the rope."""
    flat = moved(size, snap)
    feedforward = Feedforward(flat, Compensation((lag,) * 3, dead_time=(dead,) * 3))
    controller = feedback(kind, size, lag, dead)
    end = flat.trajectory.duration + 6.0 * pendulum(size)
    times = np.union1d(
        np.arange(0.0, end, 0.5 * controller.sample_time),
        [*flat.trajectory.events, *(flat.trajectory.events + dead)],
    )
    drives = drives_of(flat, lag, dead, room, by)
    states, velocities = feedforward.state(times), feedforward.velocity(times)
    planned = feedforward.load(times)
    plant = Plant(
        CRANES[size], states[0], Setpoints(velocity=velocities[0], reference=states[0]),
        bounded(controller, drives), driven=True, enabled=enabled, rig=Rig(*drives),
    )
    found = []
    for i in range(1, times.size):
        plant.step(
            times[i] - times[i - 1], Setpoints(velocity=velocities[i], reference=states[i])
        )
        found.append(np.linalg.norm(plant.load[0] - planned[i]))
    return np.array(found) / ROPE[size]


def worst(*case, **more) -> tuple[float, float]:
    """Largest error with feedback and without."""
    return run(*case, **more).max(), run(*case, enabled=False, **more).max()


@pytest.mark.parametrize("snap", SNAPS)
@pytest.mark.parametrize("lag", [0.0, 0.2, *soaked(0.02, 0.6)])
@pytest.mark.parametrize("kind", KINDS)
@SIZES
def test_feedback_makes_an_undisturbed_run_no_worse(
    size: str, kind: str, lag: float, snap: float
) -> None:
    """What remains is of the setpoints, which are linear between steps."""
    corrected, alone = worst(kind, size, lag * pendulum(size), snap)
    assert corrected < 1.1 * alone + 1e-9


@pytest.mark.parametrize("by", ["force", "power"])
@pytest.mark.parametrize("lag", [0.0, 0.2])
@pytest.mark.parametrize("kind", KINDS)
@SIZES
def test_nor_where_force_or_power_are_just_enough(
    size: str, kind: str, lag: float, by: str
) -> None:
    """What these allow depends on the swinging load; the feedback knows it roughly."""
    corrected, alone = worst(kind, size, lag * pendulum(size), SNAPS[-1], by=by, room=1.001)
    assert corrected < 1.1 * alone + 1e-9


@pytest.mark.parametrize("kind", KINDS)
@SIZES
def test_nor_where_drives_act_late(size: str, kind: str) -> None:
    lag, dead = 0.2 * pendulum(size), 0.1 * pendulum(size)
    corrected, alone = worst(kind, size, lag, SNAPS[-1], dead=dead)
    assert corrected < 1.1 * alone + 1e-9


@pytest.mark.parametrize("snap", SNAPS)
@pytest.mark.parametrize("lag", [0.0, 0.6, *soaked(0.2)])
@pytest.mark.parametrize("kind", KINDS)
@SIZES
def test_a_plan_beyond_the_drives_is_kept_better_than_without_feedback(
    size: str, kind: str, lag: float, snap: float
) -> None:
    lag *= pendulum(size)
    corrected = run(kind, size, lag, snap, room=0.93)
    alone = run(kind, size, lag, snap, room=0.93, enabled=False)
    assert corrected.max() < alone.max()
    assert corrected[-1] < 0.02 * alone.max()


@given(
    size=st.sampled_from(list(CRANES)), kind=st.sampled_from(KINDS), lag=st.floats(1e-3, 1.0),
    snap=st.floats(0.5, 100.0), room=st.floats(1.0, 1.3),
)
@settings(max_examples=25, deadline=None)
def test_nor_with_any_lag_snap_and_room(
    size: str, kind: str, lag: float, snap: float, room: float
) -> None:
    corrected, alone = worst(kind, size, lag * pendulum(size), snap, room=room)
    assert corrected < 1.1 * alone + 1e-9
