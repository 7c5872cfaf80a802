"""Feedback from measured signals inside the FMUs: both backends against the Python simulation."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from fmpy import simulate_fmu

from segfmu import Crane, FlatInverse, plan
from segfmu.cosim import simulate
from segfmu.cosim.load import load
from segfmu.crane import Plant, Rig, Setpoints
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import Uncertainty, design_observer
from segfmu.crane.tracking import TrackingController
from segfmu.errors import SimulationError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.rig_parameters import rig_parameters
from tests.campaign import SOAK
from tests.fmu.native.importer import Importer
from tests.fmu.native.test_agreement import INPUTS, exchange, inputs, steps
from tests.fmu.native.test_state import restore, run, serialised
from tests.fmu.python.test_slaves import LIMITS, POINTS

CRANE = Crane(2.2, 1.155, 1.0, rope_min=0.16, rope_max=1.5)
REST = CRANE.hanging([0.0, 0.0, -0.5])
SIGNALS = ("bridge.position", "trolley.position", "rope.length", "sway.x.angle", "sway.y.angle")
ENCODERS = dict(zip(
    (f"sensor.{n}.resolution" for n in SIGNALS), (1e-4,) * 3 + (2.0 * np.pi / 4096,) * 2,
    strict=True,
))
# everything that a controller may meet, at once
ON = ENCODERS | {
    "feedback.source": 2, "sensor.sample_time": 0.01,
    "drive.bridge.lag": 0.025, "drive.trolley.lag": 0.013, "drive.hoist.lag": 0.02,
    "drive.bridge.force_max": 30.0, "drive.trolley.acceleration_max": 0.8,
    "drive.bridge.force_min": -20.0, "drive.trolley.acceleration_min": -0.6,
    "drive.bridge.velocity_min": -0.4, "drive.hoist.velocity_max": 0.2,
    "friction.bridge.viscous": 5.0, "friction.bridge.coulomb": 0.4,
    "friction.trolley.coulomb": 0.3, "friction.hoist.viscous": 4.0, "friction.sway.viscous": 0.002,
    "wind.gust.start": 0.5, "wind.gust.duration": 0.7, "wind.gust.force.x": 0.5,
    "wind.noise.deviation.y": 0.05, "wind.noise.bandwidth": 3.0,
}
LATE = {"sensor.dead_time": 0.01, "sensor.sway.x.angle.deviation": 1e-4, "sensor.seed": 3}
OUTPUTS = (
    *gantry_crane.STATE, *(f"measured.{n}" for n in SIGNALS), "drive.bridge.force",
    "drive.hoist.force", "energy.drives", "estimate.payload_mass", "estimate.disturbance.bridge",
    "estimate.disturbance.hoist", "estimate.disturbance.load.y",
    "estimate.rope_offset",
)


@dataclass
class Loop:
    """The Python simulation: plant, controller, and setpoints over time."""

    plant: Plant
    controller: TrackingController
    inverse: FlatInverse

    def setpoints(self, time: float) -> Setpoints:
        return setpoints(self.inverse, time)

    def row(self) -> np.ndarray:
        """In the order of OUTPUTS."""
        found = self.controller.disturbance
        return np.array([
            *self.plant.state, *self.plant.measured, *self.plant.drive_force[[0, 2]],
            self.plant.balance.drives, self.controller.payload, found[0, 0], found[0, 2],
            found[1, 1], self.controller.offset,
        ])


def setpoints(inverse: FlatInverse, time: float) -> Setpoints:
    return Setpoints(inverse.force(time), inverse.velocity(time), inverse.state(time))


def loop(driven: bool, values: dict[str, float], **options) -> Loop:
    """Made of the classes of the crane layer, with nothing of the FMUs but the rig's names."""
    parameters = {v.name: v.start for v in rig_parameters()} | values
    inverse = FlatInverse(CRANE, plan(POINTS, LIMITS))
    ranges = {"sample_time": 0.01, "shortest": 0.16, "longest": 1.5, "driven": driven}
    lag = tuple(parameters[f"drive.{d}.lag"] for d in ("bridge", "trolley", "hoist"))
    drives, bound = ("bridge", "trolley", "hoist"), "acceleration" if driven else "force"
    most = np.array([parameters[f"drive.{d}.{bound}_max"] or 1e99 for d in drives])
    least = np.array([parameters[f"drive.{d}.{bound}_min"] for d in drives])
    least = np.where(least < 0.0, least, -most)
    if driven:
        # the bridge's force moves the load as well
        mass = CRANE.bridge_mass + CRANE.trolley_mass + CRANE.payload_mass
        most[0], least[0] = 30.0 / mass, -20.0 / mass
    # errors that quantisation and noise of the sensors have, or usual ones
    steps = {
        n: max(np.hypot(parameters[f"sensor.{s}.resolution"],
                        np.sqrt(12.0) * parameters[f"sensor.{s}.deviation"]) for s in signals)
        for n, signals in (
            ("position", ("bridge.position", "trolley.position")), ("length", ("rope.length",)),
            ("angle", ("sway.x.angle", "sway.y.angle")),
        )
    }
    late = parameters["sensor.dead_time"]
    observer = design_observer(
        CRANE, lag=lag, delayed=late / 0.01,
        uncertainty=Uncertainty(wake=values.get("feedback.observer.wake", 1.0), **steps),
        strongest=np.minimum(most, -least), **ranges,
    )
    controller = TrackingController(
        observer, design_flat(CRANE, lag=lag, dead_time=late, **ranges), lower=least,
        upper=most, velocity_max=[parameters[f"drive.{d}.velocity_max"] for d in drives],
        velocity_min=[parameters[f"drive.{d}.velocity_min"] for d in drives], **options,
    )
    state = np.array([values.get(n, REST[i]) for i, n in enumerate(gantry_crane.STATE)])
    plant = Plant(
        CRANE, state, setpoints(inverse, 0.0), controller, driven=driven,
        rig=Rig.of(parameters.__getitem__),
    )
    return Loop(plant, controller, inverse)


def mode(driven: bool) -> dict[str, int]:
    return {"drive.mode": 1 + driven, "feedback.design": 2}


both = pytest.mark.parametrize("driven", [False, True], ids=["force", "velocity"])
late = pytest.mark.parametrize("more", [{}, LATE], ids=["prompt", "late"])


@both
@late
@pytest.mark.soak
@pytest.mark.parametrize("kind", ["0.004", "0.05", "irregular"])
def test_native_is_the_python_simulation(native_fmus, driven: bool, more, kind: str) -> None:
    values = ON | more | {"sway.x.angle": 0.03}
    # the versions in turns; both in a soak
    for fmi in (2, 3) if SOAK else (2 + driven,):
        own = loop(driven, values)
        with Importer(native_fmus[fmi][1]) as fmu:
            fmu.set(values | mode(driven))
            fmu.write(INPUTS, inputs(own.setpoints(0.0)))
            fmu.initialise()
            for before, time in itertools.pairwise(steps(kind, 2.0)):
                fmu.write(INPUTS, inputs(own.setpoints(time)))
                fmu.step(before, time - before)
                own.plant.step(time - before, own.setpoints(time))
            assert fmu.get(*OUTPUTS) == pytest.approx(own.row(), rel=1e-7, abs=1e-7)
    assert own.controller.deviation.any()


@both
@late
def test_cosimulation_is_the_python_simulation(native_fmus, fmus, driven: bool, more) -> None:
    """The whole loop through GantryFeedforward and GantryCrane, both backends, everything on."""
    step, stop = 0.004, 2.0
    own = loop(driven, ON | more)
    expected = [own.row()]
    for i in range(1, round(stop / step) + 1):
        own.plant.step(step, own.setpoints(i * step))
        expected.append(own.row())
    table = np.array(expected)
    for paths, tolerance in ((fmus, 1e-9), (native_fmus[2], 1e-7)):
        rows = simulate(
            *paths, stop_time=stop, step=step, sink_values=ON | more | mode(driven),
            coupling="sequential", events=False,
        )
        for name, column in zip(OUTPUTS, table.T, strict=True):
            # an angle that rounding moves over the edge of a step shows in it alone
            assert rows[name] == pytest.approx(
                column, abs=tolerance * np.abs(column).max()
            ), name


@both
def test_model_exchange_is_co_simulation(native_fmus, driven: bool) -> None:
    """Without the bound of an acceleration: there, setpoints' slopes are not known."""
    values = ON | {"sway.x.angle": 0.03, "drive.trolley.acceleration_max": 0.0} | mode(driven)
    own = loop(driven, values)
    times = steps("0.02", 0.5)
    for before, time in itertools.pairwise(times):
        own.plant.step(time - before, own.setpoints(time))
    for fmi in (2, 3):
        found = exchange(native_fmus[fmi][1], values, own.setpoints, times)
        expected = np.array([*own.plant.state, own.plant.balance.drives])
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("fmi", [2, 3])
@both
def test_a_saved_state_goes_on_bit_for_bit(native_fmus, fmi: int, driven: bool) -> None:
    path = native_fmus[fmi][1]
    with Importer(path) as fmu:
        fmu.set(ON | LATE | mode(driven) | {
            "sway.x.angle": 0.1, "force.hoist": -9.81, "reference.rope.length": 0.5,
        })
        fmu.initialise()
        run(fmu, 0, 40)
        saved = serialised(fmu)
        expected = run(fmu, 40, 80)
        restore(fmu, saved)
        assert run(fmu, 40, 80).tobytes() == expected.tobytes()
    with Importer(path) as fmu:
        restore(fmu, saved)
        assert run(fmu, 40, 80).tobytes() == expected.tobytes()


HELD = {"force.hoist": -9.81, "reference.rope.length": 0.5}


def held(path: Path, values: dict[str, float], stop: float, *outputs: str) -> np.ndarray:
    """Outputs while the crane is to stay where it is; also by the Python backend."""
    rows = simulate_fmu(
        str(path), stop_time=stop, step_size=0.01, output_interval=0.01, output=list(outputs),
        start_values=HELD | values, fmi_type="CoSimulation", use_event_mode=False,
    )
    return np.column_stack([rows[n] for n in outputs])


@both
@pytest.mark.parametrize("backend", ["native", "python"])
def test_sway_decays_by_measured_signals_alone(
    native_fmus, fmus, backend: str, driven: bool
) -> None:
    path = native_fmus[2][1] if backend == "native" else fmus[1]
    values = ENCODERS | mode(driven) | {
        "feedback.source": 2, "sensor.sample_time": 0.01, "sway.x.angle": np.radians(5.0),
        "sway.y.angle": np.radians(-5.0),
    }
    names = ("sway.x.angle", "sway.y.angle", "load.position.x", "load.position.y")
    found = held(path, values, 4.0, *names)
    # 30 times less after three swings; uncontrolled, it stays, but for what the rope gives way
    assert np.abs(found[-100:, :2]).max() < np.radians(5.0) / 30.0
    assert np.abs(found[-100:, 2:]).max() < 2e-3
    free = held(path, values | {"feedback.enabled": 0}, 4.0, *names)
    assert np.abs(free[-100:, :2]).max() > np.radians(3.0)


@pytest.mark.parametrize("fmi", [2, 3])
def test_estimates_find_wind_friction_and_payload(native_fmus, fmi: int) -> None:
    values = {
        "feedback.source": 2, "feedback.observer.wake": 0.0, "feedback.payload_time": 0.5,
        "wind.constant.x": 0.2, "crane.payload_mass": 1.3, "feedback.payload_mass": 1.0,
        "force.bridge": 0.5, **mode(False),
    }
    found = held(
        native_fmus[fmi][1], values, 8.0, "estimate.payload_mass", "load.position.x",
        "load.position.z", "estimate.disturbance.load.y",
    )[-1]
    assert found[0] == pytest.approx(1.3, rel=1e-3)
    assert found[1:] == pytest.approx([0.0, -0.5, 0.0], abs=1e-3)
    # in mode velocity, where masses do not count, the wind is what it does to the load
    moved = held(
        native_fmus[fmi][1], values | mode(True), 8.0, "estimate.disturbance.load.x",
        "estimate.payload_mass",
    )[-1]
    assert moved == pytest.approx([0.2 / 1.3, 1.0], rel=1e-3)


@both
def test_the_offset_of_the_ropes_sensor_is_found(native_fmus, driven: bool) -> None:
    values = ENCODERS | {
        "feedback.source": 2, "drive.bridge.lag": 0.02, "drive.trolley.lag": 0.02,
        "drive.hoist.lag": 0.02, "sensor.rope.length.offset": 0.03,
    }
    own = loop(driven, values)
    with Importer(native_fmus[3][1]) as fmu:
        fmu.set(values | mode(driven))
        fmu.write(INPUTS, inputs(own.setpoints(0.0)))
        fmu.initialise()
        for before, time in itertools.pairwise(steps("0.004", 4.0)):
            fmu.write(INPUTS, inputs(own.setpoints(time)))
            fmu.step(before, time - before)
            own.plant.step(time - before, own.setpoints(time))
        found = fmu.get("estimate.rope_offset")[0]
    assert found == pytest.approx(-0.03, abs=0.008)
    assert found == pytest.approx(own.controller.offset, rel=1e-7)


@both
@pytest.mark.parametrize(
    ("source", "tuned"),
    [(1, "feedback.enabled"), (2, "feedback.enabled"), (2, "feedback.rejection.load")],
)
def test_switching_is_bumpless(native_fmus, driven: bool, source: int, tuned: str) -> None:
    """The bridge's force, or the added velocity's slope, goes on where it was."""
    values = ENCODERS | mode(driven) | {
        "feedback.source": source, "sensor.sample_time": 0.01, "wind.constant.x": 0.5,
        "sway.x.angle": 0.1, "drive.bridge.lag": 0.02 if driven else 0.0, tuned: 0,
    }
    jumps = []
    for fade in (0.1, 0.0):
        with Importer(native_fmus[2][1]) as fmu:
            fmu.set(HELD | values | {"feedback.fade": fade})
            fmu.initialise()
            forces = []
            for i in range(60):
                if i == 30:
                    fmu.set({tuned: 1})
                fmu.step(0.01 * i, 0.01)
                forces.append(fmu.get("drive.bridge.force")[0])
        jumps.append(abs(forces[30] - forces[29]))
    assert jumps[0] < 0.25 * jumps[1] and jumps[1] > 0.1


@pytest.mark.parametrize("source", [1, 2])
def test_tuning_is_the_same_in_both_backends(native_fmus, fmus, source: int) -> None:
    found = []
    for path in (native_fmus[2][1], fmus[1]):
        with Importer(path) as fmu:
            fmu.set(HELD | ENCODERS | mode(False) | {
                "feedback.source": source, "sensor.sample_time": 0.01, "sway.x.angle": 0.1,
            })
            fmu.initialise()
            for i in range(60):
                fmu.set({
                    "feedback.enabled": int(not 20 <= i < 30), "feedback.fade": 0.05 + 1e-3 * i,
                    "feedback.rejection.carriage": 0.5 if i > 40 else 1.0,
                    "feedback.rejection.load": 0.7 if i > 10 else 0.2,
                    "feedback.bandwidth": 0.8 if i > 45 else 1.0,
                    "feedback.hoist_bandwidth": 2.0 if i > 50 else 3.0,
                })
                fmu.step(0.01 * i, 0.01)
            found.append(fmu.get("bridge.position", "sway.x.angle", "drive.bridge.force"))
    assert found[0] == pytest.approx(found[1], rel=1e-7, abs=1e-9)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"feedback.observer.wind": 1e200}, "the observer has no finite gains between 0.16"),
        ({"feedback.rejection.load": 1.1}, "rejection.load must be at least 0 and at most 1"),
        ({"feedback.payload_time": 0.0}, "feedback.payload_time must be at least"),
        ({"feedback.source": 3}, "feedback.source must be at least 1 and at most 2, got 3"),
    ],
)
def test_what_cannot_be_is_told(native_fmus, fmus, values, words: str) -> None:
    with Importer(native_fmus[2][1]) as fmu:
        fmu.set({"feedback.source": 2} | values)
        fmu.begin()
        with pytest.raises(Exception, match="fmi2ExitInitializationMode"):
            fmu.fmu.exitInitializationMode()
        assert words in fmu.messages[-1]
    with load(fmus[1]) as unit:
        unit.set({"feedback.source": 2} | values)
        unit.enter_initialization(0.0, 1.0)
        with pytest.raises(SimulationError) as caught:
            unit.exit_initialization()
        assert words in str(caught.value)


def test_the_lqr_table_works_with_measured_signals(native_fmus, fmus) -> None:
    values = ON | {"feedback.source": 2, "sway.x.angle": 0.1, "feedback.design": 1}
    ends = [held(p, values, 1.0, "sway.x.angle", "rope.length")[-1]
            for p in (native_fmus[2][1], native_fmus[3][1], fmus[1])]
    assert ends[0] == pytest.approx(ends[2], rel=1e-7)
    assert ends[1] == pytest.approx(ends[2], rel=1e-7)
