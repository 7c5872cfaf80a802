"""Native FMUs against the Python simulation: both versions, both interfaces, several missions."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

import numpy as np
import pytest
from fmpy import simulate_fmu
from scipy.integrate import solve_ivp

from segfmu import Limits, Waypoint, plan
from segfmu.crane import FlatInverse, Plant, Rig, Setpoints
from segfmu.crane.feedback import design
from segfmu.crane.flat_feedback import design_flat
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_crane.rig_parameters import DRIVES, rig_parameters
from segfmu.fmu.standard.spec import started
from segfmu.validation.files.mission_file import load_mission
from segfmu.validation.scenario import crane_values, specs
from tests.cosim.test_agreement import UNKIND
from tests.fmu.native.importer import Importer

MODELS = Path(__file__).parents[3] / "models"
MISSIONS = ("paper", "pick_and_place", "inteco")
INPUTS = tuple(v.name for v in gantry_crane.spec().where("input"))
RESULTS = (
    "force.bridge", "force.trolley", "force.hoist", *(f"reference.{n}" for n in gantry_crane.STATE)
)


@pytest.fixture(scope="module", params=MISSIONS)
def mission(request):
    """A mission, its plan and its inverse."""
    task = load_mission(MODELS / f"{request.param}.toml")
    trajectory = task.plan()
    return task, trajectory, FlatInverse(task.build_crane(), trajectory)


def steps(kind: str, stop: float) -> np.ndarray:
    """Communication points, some in equal steps, some not."""
    if kind == "irregular":
        lengths = np.random.default_rng(3).uniform(1e-4, 0.05, 400)
        return np.concatenate([[0.0], np.cumsum(lengths)[np.cumsum(lengths) < stop]])
    return np.arange(0.0, stop, float(kind))


def waypoints(trajectory) -> dict[str, np.ndarray]:
    return {
        n: np.array([getattr(p, n) for p in trajectory.waypoints])
        for n in ("position", "velocity", "acceleration", "dwell")
    }


def plan_parameters(task, trajectory) -> dict[str, float | str]:
    values = {f"limits.{a}.{n}": float(np.broadcast_to(getattr(trajectory.limits, n), (3,))[i])
              for n in ("velocity", "acceleration", "jerk", "snap") for i, a in enumerate("xyz")}
    values |= {"planner.smoothness": task.smoothness, "planner.shape": task.shape,
               "planner.synchronization": task.synchronization,
               "planner.sample_time": task.sample_time or 0.0,
               "planner.duration": task.duration or 0.0}
    return values | {n: v for n, v in crane_values(task).items() if n.startswith("crane.")}


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("kind", ["0.05", "irregular"])
def test_feedforward_steps(mission, native_fmus, fmi: int, kind: str) -> None:
    task, trajectory, inverse = mission
    times = steps(kind, trajectory.duration + 0.2)
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.set(plan_parameters(task, trajectory))
        fmu.set_waypoints(waypoints(trajectory))
        fmu.initialise()
        assert fmu.get("plan.duration")[0] == pytest.approx(trajectory.duration, rel=1e-12)
        for before, time in itertools.pairwise(times):
            fmu.step(before, time - before)
            expected = np.concatenate([inverse.force(time), inverse.state(time)])
            assert fmu.get(*RESULTS) == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_feedforward_in_a_foreign_master(native_fmus, fmi: int, kind: str) -> None:
    task = load_mission(MODELS / "paper.toml")
    trajectory = task.plan()
    inverse = FlatInverse(task.build_crane(), trajectory)
    rows = simulate_fmu(
        str(native_fmus[fmi][0]), stop_time=4.2, output_interval=0.01, fmi_type=kind,
        output=[*RESULTS, "plan.interval", "plan.done"], record_events=False,
    )
    time = rows["time"]
    expected = np.concatenate([inverse.force(time), inverse.state(time)], axis=1)
    for name, column in zip(RESULTS, expected.T, strict=True):
        assert rows[name] == pytest.approx(column, rel=1e-9, abs=1e-9), name
    assert rows["plan.interval"].tolist() == [trajectory.interval(t) for t in time]
    assert rows["plan.done"].tolist() == (time >= trajectory.duration).tolist()


def plant_of(task, inverse, values: dict[str, float], driven: bool = False) -> tuple:
    """The Python simulation of a mission, and its setpoints over time."""
    crane = task.build_crane()
    starts = crane_values(task)

    def setpoints(time: float) -> Setpoints:
        return Setpoints(inverse.force(time), inverse.velocity(time), inverse.state(time))

    state = np.zeros(10)
    state[:5] = [starts[n] for n in gantry_crane.STATE[:5]]
    gains = design_flat(
        crane, sample_time=0.01, shortest=crane.rope_min or 0.2 * state[2],
        longest=crane.rope_max or 5.0 * state[2], driven=driven,
        lag=max(values.get(f"drive.{d}.lag", 0.0) for d in DRIVES) if driven else 0.0,
    )
    # choices are words in the values, and numbers here
    given = {n: v for n, v in starts.items() if not isinstance(v, str)}
    parameters = {v.name: given.get(v.name, v.start) for v in rig_parameters()} | values
    plant = Plant(
        crane, state, setpoints(0.0), gains, driven=driven, rig=Rig.of(parameters.__getitem__),
        enabled=bool(starts["feedback.enabled"]),
    )
    return plant, setpoints


def inputs(setpoints: Setpoints) -> np.ndarray:
    """In the order of INPUTS; the load's reference has no effect on the crane."""
    return np.concatenate([
        setpoints.force, setpoints.velocity, setpoints.reference, np.zeros(3), setpoints.wind
    ])


def crane_parameters(task) -> dict[str, float | str]:
    return crane_values(task) | {"feedback.design": "flatness"}


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize(("kind", "stop"), [("0.0001", 0.03), ("0.05", 2.0), ("irregular", 1.0)])
@pytest.mark.parametrize("values", [{}, UNKIND], ids=["ideal", "unkind"])
def test_crane_steps(mission, native_fmus, fmi: int, kind: str, stop: float, values) -> None:
    task, trajectory, inverse = mission
    plant, setpoints = plant_of(task, inverse, values, task.simulation.drive == "velocity")
    with Importer(native_fmus[fmi][1]) as fmu:
        fmu.set(crane_parameters(task) | values)
        fmu.write(INPUTS, inputs(setpoints(0.0)))
        fmu.initialise()
        times = steps(kind, stop)
        for before, time in itertools.pairwise(times):
            fmu.write(INPUTS, inputs(setpoints(time)))
            plant.step(time - before, setpoints(time))
            fmu.step(before, time - before)
        found = fmu.get(*gantry_crane.STATE, "drive.bridge.force", "energy.drives")
    expected = [*plant.state, plant.drive_force[0], plant.balance.drives]
    assert found == pytest.approx(np.array(expected), rel=1e-7, abs=1e-7)


def test_a_mission_has_its_own_gains(tmp_path: Path) -> None:
    """The table of an FMU that is built for a mission holds the LQR design for its crane."""
    task = load_mission(MODELS / "inteco.toml")
    trajectory = task.plan()
    spec = gantry_crane.native_spec(specs(task, trajectory)[1])
    starts = {v.name: v.start for v in spec.variables}
    crane = task.build_crane()
    gains = design(
        crane, sample_time=0.01, shortest=crane.rope_min, longest=crane.rope_max,
        driven=task.simulation.drive == "velocity",
    )
    assert starts["feedback.table[3].length"] == pytest.approx(gains.lengths[2])
    assert starts["feedback.table[17].trolley.rate"] == pytest.approx(gains.gains[16, 1, 9])
    assert starts["crane.payload_mass"] == crane.payload_mass
    assert spec.stop_time > trajectory.duration


def exchange(path: Path, values, setpoints, times: np.ndarray) -> np.ndarray:
    """Outputs after model exchange by SciPy, inputs linear between communication points."""
    with Importer(path, "ModelExchange") as fmu:
        fmu.set(values)
        fmu.write(INPUTS, inputs(setpoints(0.0)))
        fmu.begin()
        fmu.fmu.exitInitializationMode()
        upcoming = fmu.event()
        state, time = fmu.state(), 0.0
        for before, after in itertools.pairwise(times):
            start, end = inputs(setpoints(before)), inputs(setpoints(after))

            def given(t: float, before=before, after=after, start=start, end=end) -> np.ndarray:
                return start + (end - start) * (t - before) / (after - before)

            def slope(t: float, x: np.ndarray, given=given) -> np.ndarray:
                fmu.fmu.setTime(t)
                fmu.write(INPUTS, given(t))
                return fmu.derivatives(t, x)

            while time < after:
                until = min(after, upcoming)
                if until > time:
                    found = solve_ivp(
                        slope, (time, until), state, "DOP853", rtol=1e-10, atol=1e-11
                    )
                    state, time = found.y[:, -1], until
                slope(time, state)
                fmu.fmu.completedIntegratorStep()
                if upcoming <= time:
                    fmu.fmu.enterEventMode()
                    upcoming = fmu.event()
        return fmu.get(*gantry_crane.STATE, "energy.drives")


# model exchange knows no setpoints of the past
IN_EXCHANGE = {
    n: v for n, v in UNKIND.items()
    if not n.startswith(("sensor", "drive.hoist")) and not n.endswith("dead_time")
}


@pytest.mark.parametrize("fmi", [2, 3])
def test_crane_in_model_exchange(mission, native_fmus, fmi: int) -> None:
    task, trajectory, inverse = mission
    driven = task.simulation.drive == "velocity"
    times = steps("0.02", 0.5)
    lag = {f"drive.{d}.lag": 0.02 for d in ("bridge", "trolley", "hoist")} if driven else {}
    values = lag | IN_EXCHANGE
    plant, setpoints = plant_of(task, inverse, values, driven)
    for before, time in itertools.pairwise(times):
        plant.step(time - before, setpoints(time))
    found = exchange(
        native_fmus[fmi][1], crane_parameters(task) | values, setpoints, times
    )
    expected = [*plant.state, plant.balance.drives]
    assert found == pytest.approx(np.array(expected), rel=1e-7, abs=1e-7)


@pytest.mark.parametrize("fmi", [2, 3])
def test_missions_by_cvode(mission, native_fmus, fmi: int) -> None:
    task, trajectory, inverse = mission
    driven = task.simulation.drive == "velocity"
    values = {f"drive.{d}.lag": 0.02 for d in DRIVES} if driven else {}
    values |= IN_EXCHANGE
    plant, setpoints = plant_of(task, inverse, values, driven)
    # fmpy's solver holds inputs from one stop to the next; it stops at the controller's ticks
    times = steps("0.01", 0.5)
    given = np.array(
        [(t, *inputs(setpoints(t))) for t in times],
        dtype=[("time", np.float64), *((n, np.float64) for n in INPUTS)],
    )
    numbers = {"force": 1, "velocity": 2, "flatness": 2, "state": 1, "error": 1, "wind": 1}
    start = {n: numbers.get(v, v) for n, v in (crane_parameters(task) | values).items()}
    names = [*gantry_crane.STATE, "energy.drives"]
    rows = simulate_fmu(
        str(native_fmus[fmi][1]), fmi_type="ModelExchange", stop_time=times[-1],
        output_interval=0.01, start_values=start, input=given, output=names,
        relative_tolerance=1e-10, record_events=False,
    )
    for i, (before, time) in enumerate(itertools.pairwise(times), 1):
        plant.step(time - before - 1e-9, setpoints(before))
        plant.step(1e-9, setpoints(time))
        expected = np.array([*plant.state, plant.balance.drives])
        found = np.array([rows[n][i] for n in names])
        assert rows["time"][i] == pytest.approx(time)
        assert found == pytest.approx(expected, rel=1e-7, abs=1e-7), time


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize(
    "values",
    [
        {},
        {"drive.mode": 2, "feedback.design": 2, "drive.bridge.lag": 0.02,
         "drive.trolley.lag": 0.02, "drive.hoist.lag": 0.02, "friction.bridge.viscous": 2.0},
        {"sensor.sample_time": 0.02, "sensor.dead_time": 0.03,
         "sensor.bridge.position.deviation": 1e-3, "wind.noise.deviation.x": 0.1,
         "wind.gust.start": 0.5, "wind.gust.duration": 0.7, "wind.gust.force.y": 0.2,
         "payload.count": 1, "payload[1].time": 1.0, "payload[1].mass": 1.3},
    ],
    ids=["force", "velocity", "disturbed"],
)
def test_cvode_gives_what_steps_give(native_fmus, fmi: int, values) -> None:
    start = {"sway.x.angle": 0.05, "trolley.position": 0.02, "force.hoist": -9.81,
             "reference.rope.length": 0.5, **values}
    names = [*gantry_crane.STATE, "measured.bridge.position", "energy.dissipated"]
    rows = [
        simulate_fmu(
            str(native_fmus[fmi][1]), stop_time=2.0, output_interval=0.02, fmi_type=kind,
            output=names, start_values=start, relative_tolerance=1e-10, record_events=False,
        )
        for kind in ("CoSimulation", "ModelExchange")
    ]
    for name in names:
        assert rows[1][name] == pytest.approx(rows[0][name], abs=1e-7), name


def test_both_designs_are_those_of_python(native_fmus, fmus) -> None:
    starts = {"sway.x.angle": 0.1, "force.hoist": -9.81, "reference.rope.length": 0.5}
    for design_of in ("lqr", "flatness"):
        ends = []
        for path in (native_fmus[2][1], fmus[1]):
            rows = simulate_fmu(
                str(path), stop_time=0.5, output_interval=0.05, output=["sway.x.angle"],
                start_values=starts | {"feedback.design": 1 + (design_of == "flatness")},
            )
            ends.append(rows["sway.x.angle"][-1])
        assert ends[0] == pytest.approx(ends[1], rel=1e-9)


def test_specifications_start_with_what_is_asked_for() -> None:
    spec = started(gantry_crane.spec(), {"drive.mode": "velocity", "rope.length": 0.7})
    starts = {v.name: v.start for v in spec.variables}
    assert (starts["drive.mode"], starts["rope.length"]) == (2, 0.7)
    with pytest.raises(KeyError, match="no nonsense"):
        started(gantry_crane.spec(), {"nonsense": 1.0})


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("interface", ["CoSimulation", "ModelExchange"])
def test_a_crane_alone_hangs_at_rest(native_fmus, fmi: int, interface: str) -> None:
    rows = simulate_fmu(
        str(native_fmus[fmi][1]), stop_time=2.0, fmi_type=interface, output=list(gantry_crane.STATE)
    )
    for name in gantry_crane.STATE:
        assert rows[name] == pytest.approx(rows[name][0], abs=1e-9)


@pytest.mark.parametrize("fmi", [2, 3])
def test_feedforward_keeps_limits_by_direction(mission, native_fmus, fmi: int) -> None:
    task, trajectory, _ = mission
    points = list(reversed(trajectory.waypoints))
    given = trajectory.limits
    lower = {"velocity_min": -0.7 * given.velocity, "acceleration_min": -0.6 * given.acceleration}
    limits = Limits(given.velocity, given.acceleration, given.jerk, given.snap, **lower)
    rest = [Waypoint(p.position) for p in points]
    options = {
        "smoothness": task.smoothness, "shape": task.shape, "sample_time": task.sample_time,
        "synchronize": task.synchronization,
    }
    expected = plan(rest, limits, **options)
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.set(plan_parameters(task, trajectory) | {"planner.duration": 0.0} | {
            f"limits.{axis}.{name}": float(np.broadcast_to(values, (3,))[i])
            for name, values in lower.items() for i, axis in enumerate("xyz")
        })
        fmu.set_waypoints(waypoints(expected))
        fmu.initialise()
        assert fmu.get("plan.duration")[0] == pytest.approx(expected.duration, rel=1e-12)
    assert expected.duration > 1.05 * plan(rest, given, **options).duration


@pytest.mark.parametrize(("value", "limit"), [(-0.3, "velocity_min"), (0.5, "velocity")])
def test_feedforward_tells_the_direction_of_a_limit(
    mission, native_fmus, value: float, limit: str
) -> None:
    task, trajectory, _ = mission
    with Importer(native_fmus[2][0]) as fmu:
        fmu.set(plan_parameters(task, trajectory) | {
            "limits.x.velocity": 0.4, "limits.x.velocity_min": -0.2,
            "waypoint[2].velocity.x": value,
        })
        with pytest.raises(Exception, match="fmi2ExitInitializationMode"):
            fmu.initialise()
        assert re.search(rf"velocity {value:g} m/s .*raise limits\.{limit} ", fmu.messages[-1])
