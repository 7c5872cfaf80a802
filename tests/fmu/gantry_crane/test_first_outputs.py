"""Forces and powers at the start are those that act: of model exchange, and of a tiny step."""

from __future__ import annotations

import numpy as np
import pytest

from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.rig_parameters import DRIVES
from segfmu.fmu.gantry_crane.slave import CraneSlave
from tests.fmu.bench import Rows, SlaveBench, Values, bench
from tests.fmu.native.importer import Importer

SHOWN = [
    *(f"drive.{d}.{n}" for d in DRIVES for n in ("force", "power")), "rope.force",
    "power.wind", "power.friction", *gantry_crane.STATE, "energy.kinetic", "energy.imbalance",
]
FLAGS = [f"drive.{d}.saturated" for d in DRIVES]
RATES = [f"{n}.acceleration" for n in ("bridge", "trolley", "rope", "sway.x", "sway.y")]
TINY = np.array([0.0, 1e-6])

SWINGING: Values = {
    "feedback.enabled": False, "start.on_reference": False, "feedback.design": "flatness",
    "sway.x.angle": 0.5, "sway.y.angle": -0.2, "sway.x.rate": 0.3,
}
MOVING: Values = SWINGING | {
    "bridge.velocity": 1.0, "trolley.velocity": -0.3, "rope.velocity": 0.2,
    "velocity.bridge": 1.0, "velocity.trolley": -0.3, "velocity.hoist": 0.2,
}
VELOCITY: Values = {"drive.mode": "velocity"}
LAGS: Values = VELOCITY | {f"drive.{d}.lag": 0.1 for d in DRIVES}
FRICTION: Values = {
    "friction.bridge.viscous": 2.0, "friction.trolley.coulomb": 0.7, "friction.hoist.drag": 3.0,
    "friction.sway.viscous": 0.05,
}
WIND: Values = {
    "wind.constant.x": 3.0, "wind.x": 1.0, "wind.y": -0.5, "wind.noise.deviation.z": 0.2,
    "wind.gust.start": -0.2, "wind.gust.duration": 1.0, "wind.gust.force.y": 0.4,
    "wind.speed.x": 4.0, "load.drag_area": 0.2,
}
BLOWN: Values = MOVING | FRICTION | WIND
WEAK: Values = {"drive.hoist.force_max": 5.0, "drive.bridge.power_max": 0.4}
AWAY: Values = {"velocity.bridge": 1.5, "velocity.hoist": -0.4}

# in co-simulation and in model exchange
BOTH: dict[str, Values] = {
    "force": BLOWN, "lags": BLOWN | LAGS, "swinging": SWINGING | LAGS, "weak": BLOWN | WEAK,
    "force at speed": BLOWN | {"drive.bridge.velocity_max": 1.0, "force.bridge": 20.0},
    "weak lags": BLOWN | WEAK | LAGS, "away": BLOWN | LAGS | AWAY,
    "bounded": BLOWN | LAGS | AWAY | {"drive.bridge.acceleration_max": 0.5,
                                      "drive.hoist.velocity_max": 0.3},
    "bounded below": BLOWN | LAGS | {"velocity.bridge": -1.5, "velocity.hoist": -0.4}
    | {"drive.bridge.acceleration_min": -0.5, "drive.hoist.velocity_min": -0.3},
    "payload": BLOWN | {"payload.count": 1, "payload[1].time": 0.0, "payload[1].mass": 2.0},
    "buffer": BLOWN | {"travel.bridge.max": -0.01, "travel.bridge.stiffness": 50.0},
}
# in co-simulation alone
ALONE: dict[str, Values] = {
    "no lag": BLOWN | VELOCITY, "weak without lag": BLOWN | VELOCITY | WEAK,
    "away without lag": BLOWN | VELOCITY | {"velocity.bridge": 1.5}
    | {f"drive.{d}.acceleration_max": 0.5 for d in DRIVES},
    "away and weak": BLOWN | VELOCITY | {"velocity.bridge": 1.5, "drive.bridge.force_max": 9.0},
    "away below without lag": BLOWN | VELOCITY | {"velocity.bridge": -1.5}
    | {f"drive.{d}.acceleration_min": -0.5 for d in DRIVES},
    "late force": BLOWN | {"drive.bridge.dead_time": 0.02},
    "late": BLOWN | LAGS | AWAY | {f"drive.{d}.dead_time": 0.02 for d in DRIVES},
    "slack": MOVING | VELOCITY | {"rope.slack": "free_fall", "velocity.hoist": 3.0,
                                         "drive.hoist.acceleration_max": 30.0},
    "pushed": MOVING | {"rope.slack": "free_fall", "force.hoist": 1.0},
    "drawn": SWINGING | LAGS | {"rope.slack": "free_fall", "velocity.hoist": 3.0},
}
VERSIONS = pytest.mark.parametrize("fmi", [2, 3])


def still(time: float) -> Values:
    return {}


def agree(rows: Rows | None, messages: list[str]) -> None:
    """The values at the start are those after a tiny step."""
    assert rows is not None, messages
    for name in rows:
        first, then = rows[name]
        assert first == pytest.approx(then, abs=2e-4 * max(1.0, abs(then))), name


@VERSIONS
@pytest.mark.parametrize("case", BOTH | ALONE)
def test_native_start_is_that_of_a_tiny_step(native_fmus, fmi: int, case: str) -> None:
    names = [*SHOWN, *FLAGS, *RATES]
    with bench(native_fmus[fmi][1], gantry_crane.native_spec(), names) as runs:
        agree(runs.run((BOTH | ALONE)[case], still, TINY), runs.messages)


@pytest.mark.parametrize("case", BOTH | ALONE)
def test_python_start_is_that_of_a_tiny_step_and_of_the_native_fmu(native_fmus, case: str) -> None:
    values, names = (BOTH | ALONE)[case], [*SHOWN, *FLAGS]
    runs = SlaveBench(CraneSlave, names)
    found = runs.run(values, still, TINY)
    agree(found, runs.messages)
    with bench(native_fmus[2][1], gantry_crane.native_spec(), names) as others:
        expected = others.run(values, still, TINY)
    for name in names:
        assert found[name] == pytest.approx(expected[name], rel=1e-12, abs=1e-12), name


@VERSIONS
@pytest.mark.parametrize("case", BOTH)
def test_start_is_that_of_model_exchange(native_fmus, fmi: int, case: str) -> None:
    found = []
    for kind in ("CoSimulation", "ModelExchange"):
        with Importer(native_fmus[fmi][1], kind) as fmu:
            fmu.set(BOTH[case])
            fmu.initialise()
            flags = [fmu.variables[n].valueReference for n in FLAGS]
            found.append([*fmu.get(*SHOWN, *RATES), *fmu.fmu.getBoolean(flags)])
    assert found[0] == found[1]


def test_forces_of_a_swinging_load_and_of_a_weak_hoist() -> None:
    runs = SlaveBench(CraneSlave, [*SHOWN, *FLAGS])
    held = runs.run(SWINGING | LAGS | {"sway.y.angle": 0.0, "sway.x.rate": 0.0}, still, TINY[:1])
    pull = 9.81 * np.cos(0.5)
    assert held["rope.force"] == held["drive.hoist.force"] == pytest.approx([-pull])
    assert held["drive.bridge.force"] == pytest.approx([-pull * np.sin(0.5)])
    weak = runs.run({
        "feedback.enabled": False, "start.on_reference": False, "drive.hoist.force_max": 5.0,
        "rope.velocity": 0.2, "bridge.velocity": 1.0, "friction.bridge.viscous": 2.0,
        "wind.constant.x": 3.0, "wind.x": 1.0,
    }, still, TINY[:1])
    names = ("drive.hoist.force", "drive.hoist.saturated", "power.wind", "power.friction",
             "drive.hoist.power")
    assert [weak[n] for n in names] == [pytest.approx([x]) for x in (-5.0, 1.0, 4.0, 2.0, -1.0)]
