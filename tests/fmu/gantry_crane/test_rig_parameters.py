"""GantryCrane's equipment: parameters become the rig, unkindness arrives in the FMU's outputs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from segfmu.cosim.load import load
from segfmu.cosim.unit import Unit
from segfmu.crane import Drive, Friction, Gust, PayloadChange, Rig, Sensors, TravelLimits, Wind
from segfmu.crane.disturbance import Turbulence
from segfmu.errors import SimulationError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.rig_parameters import FAR, SIGNALS, rig_parameters

START = {v.name: v.start for v in rig_parameters()}

VALUES = {
    "drive.bridge.lag": 0.01, "drive.trolley.lag": 0.02, "drive.hoist.lag": 0.03,
    "drive.trolley.force_max": 5.0, "drive.hoist.acceleration_max": 2.0,
    "drive.bridge.dead_time": 0.04,
    "friction.bridge.viscous": 1.0, "friction.trolley.viscous": 2.0, "friction.hoist.viscous": 3.0,
    "friction.bridge.coulomb": 4.0, "friction.trolley.coulomb": 5.0, "friction.hoist.coulomb": 6.0,
    "friction.width": 0.02, "friction.sway.viscous": 0.1,
    "travel.trolley.min": -0.5, "travel.trolley.max": 0.7,
    "sensor.sample_time": 0.01, "sensor.dead_time": 0.02, "sensor.seed": 9,
    "sensor.rope.length.offset": 0.05, "sensor.sway.y.angle.resolution": 1e-3,
    "sensor.bridge.position.deviation": 1e-4,
    "wind.constant.y": 0.1, "wind.gust.start": 1.0, "wind.gust.duration": 2.0,
    "wind.gust.shape": 2, "wind.gust.force.z": 0.3, "wind.noise.deviation.x": 0.2,
    "wind.speed.x": 5.0, "wind.gust.speed.y": 2.0, "wind.turbulence.deviation.z": 0.4,
    "wind.turbulence.length": 800.0, "wind.turbulence.bandwidth": 0.6, "wind.turbulence.seed": 6,
    "wind.air_density": 1.1, "load.drag_area": 0.3, "travel.trolley.stiffness": 50.0,
    "travel.trolley.damping": 4.0, "friction.trolley.static": 7.0, "friction.presliding": 2e-5,
    "drive.hoist.velocity_max": 0.9, "drive.hoist.velocity_min": -0.4,
    "drive.trolley.force_min": -7.0, "drive.hoist.acceleration_min": -1.5,
    "drive.bridge.power_max": 60.0,
    "rope.slack": 2, "wind.noise.bandwidth": 4.0, "wind.noise.seed": 8,
    "payload.count": 2, "payload[1].time": 1.0, "payload[1].mass": 2.0, "payload[2].time": 3.0,
    "payload[2].mass": 0.5,
}


def test_ideal_by_default() -> None:
    far = (-FAR, FAR)
    assert Rig.of(START.__getitem__) == Rig(travel=TravelLimits(far, far, far))


def test_every_parameter_finds_its_place() -> None:
    assert set(VALUES) <= set(START)
    expected = Rig(
        Drive(0.01, dead_time=0.04, power_max=60.0), Drive(0.02, force_max=5.0, force_min=-7.0),
        Drive(0.03, acceleration_max=2.0, velocity_max=0.9, acceleration_min=-1.5,
              velocity_min=-0.4),
        Friction((1.0, 2.0, 3.0), (4.0, 5.0, 6.0), 0.02, 0.1,
                 static=(0.0, 7.0, 0.0), presliding=2e-5),
        TravelLimits(
            (-FAR, FAR), (-0.5, 0.7), (-FAR, FAR), (0.0, 50.0, 0.0), (0.0, 4.0, 0.0), "free_fall"
        ),
        Sensors(
            0.01, 0.02, (0.0, 0.0, 0.0, 0.0, 1e-3), (1e-4, 0.0, 0.0, 0.0, 0.0),
            (0.0, 0.0, 0.05, 0.0, 0.0), 9,
        ),
        Wind(
            (0.0, 0.1, 0.0), Gust(1.0, 2.0, (0.0, 0.0, 0.3), "sine", (0.0, 2.0, 0.0)),
            (0.2, 0.0, 0.0), 4.0, 8, (5.0, 0.0, 0.0), Turbulence((0.0, 0.0, 0.4), 800.0, 0.6, 6),
            0.3, 1.1,
        ),
        (PayloadChange(1.0, 2.0), PayloadChange(3.0, 0.5)),
    )
    assert Rig.of({**START, **VALUES}.__getitem__) == expected


def test_signals_are_the_measured_part_of_the_state() -> None:
    assert gantry_crane.STATE[:5] == SIGNALS


def test_names_of_the_contract() -> None:
    names = {v.name for v in gantry_crane.spec().variables}
    for axis in ("bridge", "trolley", "hoist"):
        for quantity in (
            "lag", "force_max", "force_min", "acceleration_max", "acceleration_min",
            "velocity_max", "velocity_min", "dead_time",
        ):
            assert f"drive.{axis}.{quantity}" in names
        for quantity in ("viscous", "coulomb"):
            assert f"friction.{axis}.{quantity}" in names
    assert "friction.sway.viscous" in names


def outputs(unit: Unit, names: list[str]) -> dict[str, float]:
    found = {}
    for name in names:
        channel = unit.channel([name])
        channel.read()
        found[name] = float(channel.values[0])
    return found


def test_outputs_of_a_crane_that_is_not_ideal(fmus: tuple[Path, Path]) -> None:
    names = [
        "drive.trolley.saturated", "drive.trolley.force", "drive.trolley.power", "payload.mass",
        "measured.rope.length", "rope.length", "rope.force", "trolley.velocity", "bridge.velocity",
        "energy.kinetic", "energy.potential", "energy.work", "energy.drives", "energy.wind",
        "energy.payload", "energy.dissipated", "energy.imbalance", "power.wind", "power.friction",
    ]
    with load(fmus[1]) as unit:
        unit.set({
            "drive.trolley.force_max": 0.5, "payload.count": 1, "payload[1].time": 0.055,
            "payload[1].mass": 1.5, "sensor.rope.length.offset": 0.05, "wind.constant.x": 0.2,
            "friction.trolley.viscous": 2.0, "feedback.enabled": False,
            "force.trolley": 1.0, "force.hoist": -9.81,
        })
        unit.enter_initialization(0.0, 1.0)
        unit.exit_initialization()
        before = outputs(unit, names)
        for i in range(20):
            unit.step(0.01 * i, 0.01 * (i + 1))
        found = outputs(unit, names)
    assert found["drive.trolley.saturated"] == 1.0
    assert found["drive.trolley.force"] == 0.5
    assert found["drive.trolley.power"] == pytest.approx(0.5 * found["trolley.velocity"])
    assert found["payload.mass"] == 1.5
    assert found["measured.rope.length"] == pytest.approx(found["rope.length"] + 0.05)
    assert found["rope.force"] == -9.81
    assert found["power.friction"] == pytest.approx(2.0 * found["trolley.velocity"] ** 2)
    gained = found["energy.kinetic"] + found["energy.potential"] - before["energy.potential"]
    given = found["energy.work"] + found["energy.payload"] - found["energy.dissipated"]
    assert gained == pytest.approx(given, rel=1e-9)
    assert found["energy.work"] == pytest.approx(found["energy.drives"] + found["energy.wind"])
    assert abs(found["energy.imbalance"]) < 1e-9
    assert found["power.wind"] > 0.0
    assert found["energy.dissipated"] > 0.0


def test_end_stop_ends_the_simulation_with_its_name(fmus: tuple[Path, Path]) -> None:
    with load(fmus[1]) as unit:
        unit.set({"travel.bridge.max": 0.01, "drive.mode": "velocity", "feedback.enabled": False})
        unit.enter_initialization(0.0, 1.0)
        unit.set({"velocity.bridge": 0.1})
        unit.exit_initialization()
        # without lag the velocity is there at the first tick of the feedback, after 0.01 s
        with pytest.raises(SimulationError, match=r"at 0\.105 s: bridge at 0\.01 m .* end stop"):
            for i in range(30):
                unit.step(0.02 * i, 0.02 * (i + 1))


def test_start_time_is_the_time_of_disturbances(fmus: tuple[Path, Path]) -> None:
    with load(fmus[1]) as unit:
        unit.set({"payload.count": 1, "payload[1].time": 5.05, "payload[1].mass": 1.5})
        unit.enter_initialization(5.0, 6.0)
        unit.set({"force.hoist": -9.81})
        unit.exit_initialization()
        masses = []
        for i in range(10):
            unit.step(5.0 + 0.01 * i, 5.0 + 0.01 * (i + 1))
            masses.append(outputs(unit, ["payload.mass"])["payload.mass"])
    assert np.array(masses).tolist() == [1.0] * 4 + [1.5] * 6


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"drive.hoist.lag": -1.0}, "drive.hoist.lag must be at least 0"),
        ({"payload.count": 5}, "payload.count must be at least 0 and at most 4"),
        ({"sensor.dead_time": 0.1}, "set sensor.sample_time above 0 s"),
        ({"travel.rope.min": 2.0, "travel.rope.max": 1.0}, "travel.rope: min 2 m must be below"),
        ({"sensor.seed": -1}, "sensor.seed"),
        ({"wind.constant.x": float("nan")}, "wind.constant.x must be finite, got nan"),
    ],
)
def test_bad_parameters_end_initialisation_with_the_reason(
    fmus: tuple[Path, Path], values: dict[str, float], words: str
) -> None:
    with load(fmus[1]) as unit:
        unit.set(values)
        unit.enter_initialization(0.0, 1.0)
        with pytest.raises(SimulationError, match="could not be initialised") as caught:
            unit.exit_initialization()
        assert words in str(caught.value)


def test_two_changes_of_the_load_at_one_time_end_initialisation(fmus, native_fmus) -> None:
    for path in (fmus[1], native_fmus[2][1], native_fmus[3][1]):
        with load(path) as unit:
            unit.set({"payload.count": 2})
            unit.enter_initialization(0.0, 1.0)
            with pytest.raises(SimulationError, match="two changes of the load are at 0 s"):
                unit.exit_initialization()
