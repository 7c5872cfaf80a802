"""The tracking controller learns the offset of the rope's sensor, in loops by Newton's laws."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from segfmu import FlatInverse, Limits, Waypoint, plan
from segfmu.crane import Drive, Plant, Sensors, Setpoints, Wind
from segfmu.crane import Rig as Equipment
from tests.campaign import soaked
from tests.crane.loop import Rig, Signal, simulate
from tests.crane.test_tracking import ENCODERS, LAB, T, controller, lags, rig


@cache
def planned() -> tuple[FlatInverse, float]:
    """A move with hoisting, and its duration [s]."""
    points = [Waypoint([-0.25, -0.3, -0.8]), Waypoint([0.25, 0.3, -0.7])]
    trajectory = plan(points, Limits([0.22, 0.22, 0.2], 0.3, 0.8, 6.0), smoothness=5)
    return FlatInverse(LAB, trajectory), trajectory.duration


@cache
def followed(driven: bool) -> tuple[np.ndarray, np.ndarray]:
    """Its states and what the drives are given, every half tick until it has rested for 2 s."""
    inverse, duration = planned()
    times = T / 2.0 * np.arange(2 * round(round(duration + 2.0) / T) + 1)
    if not driven:
        return inverse.state(times), inverse.force(times)
    # the slope of the velocity commands, which compensate the lag
    now, later = (inverse.evaluate(t)[:, 13:16] for t in (times, times + 1e-4))
    return inverse.state(times), now + np.array(lags(driven)) * (later - now) / 1e-4


def move(loop, true: Rig, start=0.0):
    """States under it, by Newton's laws, and those of the plan."""
    states, given = followed(true.driven)

    def at(rows: np.ndarray) -> Signal:
        return lambda time: rows[round(2.0 * time / T)]

    found, _ = simulate(
        true, loop, states[0] + start, T / 2.0 * (len(states) - 1), at(states), at(given)
    )
    return found, states[::2]


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("offset", [0.04, *soaked(-0.04)])
def test_the_offset_of_the_ropes_sensor_is_learnt_on_the_way(driven: bool, offset: float) -> None:
    """5 % of the rope: the load comes to its height, and the sway of the wrong rope goes."""
    longer = np.array([0.0, 0.0, offset, *np.zeros(7)])
    true = rig(driven, offset=(0.0, 0.0, -offset, 0.0, 0.0))
    learning = controller("flat", driven, wake=1.0, rope_offset=True)
    believing = controller("flat", driven, wake=1.0, rope_offset=True, offset=0.0)
    states, planned = move(learning, true, longer)
    blind, _ = move(believing, true, longer)
    assert learning.offset == pytest.approx(offset, rel=0.05)
    assert believing.offset == 0.0
    assert states[-1, 2] == pytest.approx(planned[-1, 2], abs=3e-3)
    assert blind[-1, 2] == pytest.approx(planned[-1, 2] + offset, abs=3e-3)
    swayed = [np.abs(s[-200:, 3:5]).max() for s in (states, blind)]
    assert swayed[0] < 0.2 * swayed[1]


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize(
    "values",
    [{}, {"payload": 0.5}, {"wind": lambda t: np.array([1.0, 0.5, 0.0]) * (1.0 < t < 1.5)},
     *soaked({"payload": 1.5}, {"resolution": ENCODERS})],
    ids=lambda values: " ".join(values) or "nothing",
)
def test_what_is_no_offset_is_not_taken_for_one(driven: bool, values) -> None:
    loop = controller("flat", driven, wake=1.0, rope_offset=True)
    offsets = []

    def sample(*given, own=loop.sample) -> np.ndarray:
        offsets.append(loop.offset)
        return own(*given)

    loop.sample = sample
    move(loop, rig(driven, **values))
    assert len(offsets) > 400
    assert not np.any(offsets)


def blown(driven: bool, wind: Wind, resolution: tuple[float, ...], share: float) -> np.ndarray:
    """Offsets in use at the ticks of a move in the wind; the sensor's is a share of the rope."""
    inverse, duration = planned()
    values = inverse.evaluate(T * np.arange(round((duration + 1.0) / T)))
    velocity = values[:, 8:11] + lags(driven)[0] * values[:, 13:16]
    aims = list(map(Setpoints, values[:, :3], velocity, values[:, 3:13]))
    drive, offset = Drive(lag=lags(driven)[0]), 0.8 * share
    equipment = Equipment(
        drive, drive, drive, wind=wind,
        sensors=Sensors(resolution=resolution, offset=(0.0, 0.0, -offset, 0.0, 0.0)),
    )
    loop, found = controller("flat", driven, wake=1.0, rope_offset=True), []
    start = values[0, 3:13] + np.array([0.0, 0.0, offset, *np.zeros(7)])
    crane = Plant(LAB, start, aims[0], loop, driven=driven, rig=equipment)
    for aim in aims[1:]:
        crane.step(T, aim)
        found.append(loop.offset)
    return np.array(found)


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("resolution", [ENCODERS, *soaked((0.0,) * 5)])
def test_noisy_wind_is_no_offset(driven: bool, resolution: tuple[float, ...]) -> None:
    """Weak to strong noise of wind from the start on: an offset in use is the rare exception."""
    used = [
        np.abs(blown(driven, Wind(deviation=(n, n, 0.0), bandwidth=b, seed=s), resolution, 0.0))
        for n in (0.02, 0.1, 0.3) for b in (0.3, 1.0, 2.0) for s in range(8)
    ]
    assert np.mean([u.any() for u in used]) < 0.03


def test_an_offset_is_learnt_in_the_weakest_wind() -> None:
    winds = [Wind(deviation=(2e-3, 2e-3, 0.0), bandwidth=1.0, seed=s) for s in range(8)]
    found = [blown(True, wind, (0.0,) * 5, 0.05)[-1] for wind in winds]
    assert found == pytest.approx(np.full(8, 0.04), rel=0.15)
