"""The compiled kernels give the numbers of the interpreted ones, and refuse wrong arguments."""

from __future__ import annotations

import os
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from segfmu import Crane, Limits, Waypoint, plan
from segfmu.crane import Drive, Friction, Gust, Plant, Rig, Setpoints, Wind
from segfmu.crane.flat_feedback import design_flat
from segfmu.crane.observer import design_observer
from segfmu.crane.tracking import TrackingController
from segfmu.kernels import backend
from segfmu.kernels.control import feedback, observer, tracking
from segfmu.kernels.control.records import (
    Gains,
    Observer,
    Tick,
    Tracker,
    Tracking,
    VelocityCommand,
)
from segfmu.kernels.crane import _crane, contact, friction_series, plant, rope
from segfmu.kernels.crane.records import (
    CommandRates,
    Contact,
    ContactWork,
    FrictionSeries,
    PlantState,
    Report,
    Resistance,
    RopeWork,
    State,
    Work,
)
from segfmu.kernels.numerics import noise
from segfmu.kernels.numerics.records import RandomState, Sinusoid
from segfmu.kernels.planner import parameters, profile, synchronize
from segfmu.kernels.planner.records import Axis, Cell, Phase, PlanWork, Problem
from segfmu.kernels.rig import rig
from segfmu.kernels.trajectory import evaluate, motion
from tests.campaign import SOAK, campaign
from tests.compiler import compiled_kernels
from tests.kernels.rigs import CONTROLLERS, HANGING, LAB, everything
from tests.problems import AxisProblem, axis_problems, work_space

compiled = compiled_kernels()
INTERPRETED = SimpleNamespace(
    axis_limits=parameters.axis_limits, ramp_parameters=parameters.ramp_parameters,
    shortest_profile=profile.shortest_profile, timed_profile=synchronize.timed_profile,
)
MASSES = (2.2, 1.155, 1.0, 9.81)


def close(a, b) -> bool:
    return np.allclose(a, b, rtol=1e-12, atol=1e-14)


@pytest.mark.soak
@settings(max_examples=150 if SOAK else 60, deadline=None)
@given(axis_problems())
def test_shortest_profiles_agree(problem: AxisProblem) -> None:
    results = []
    for module in (INTERPRETED, compiled):
        axis, phases = np.zeros(Axis.SIZE), np.zeros((Cell.ABOVE, Phase.SIZE))
        work = work_space()
        module.axis_limits(problem.smoothness, problem.shape, np.array(problem.limits), axis)
        assert module.ramp_parameters(parameters.usual_share(axis), axis, work)
        count = module.shortest_profile(problem.boundary(), axis, phases, work)
        results.append((count, axis, phases[: max(count, 0)]))
    assert results[0][0] == results[1][0]
    assert close(results[0][1], results[1][1])
    assert close(results[0][2], results[1][2])


@settings(max_examples=40, deadline=None)
@given(axis_problems(smoothness=4), st.floats(1.0, 4.0))
def test_timed_profiles_agree(problem: AxisProblem, factor: float) -> None:
    _, phases = problem.shortest()
    target = factor * float(phases[:, Phase.DURATION].sum())
    if target <= 0.0:
        return
    results = []
    for module in (INTERPRETED, compiled):
        cell, work = np.zeros((Cell.SIZE, Cell.COLUMNS)), work_space()
        cell[Cell.PROBLEM, : Problem.SIZE] = problem.boundary()
        weight = module.timed_profile(target, problem.axis(), cell, work)
        results.append(np.concatenate([[weight], work[PlanWork.NEAREST], cell.ravel()]))
    assert close(*results)


def test_plans_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    points = [
        Waypoint([0.0, 0.0, -1.0]), Waypoint([0.07, 0.055, -0.9], [0.2, 0.1, 0.0], [0.3, 0.2, 0.0]),
        Waypoint([1.0, 0.8, -0.5], dwell=0.3), Waypoint([1.4, 0.8, -0.9]),
    ]
    limits = Limits([1.0, 0.4, 0.5], [1.0, 0.5, 0.8], [1.0, 0.5, 4.0], [10.0, 5.0, 30.0])
    fast = plan(points, limits, sample_time=0.01)
    times = np.linspace(-0.1, fast.duration + 0.1, 999)
    values = fast(times, 2)
    monkeypatch.setattr(backend, "plan_motion", motion.plan_motion)
    monkeypatch.setattr(backend, "evaluate", evaluate.evaluate)
    slow = plan(points, limits, sample_time=0.01)
    assert close(fast.timing, slow.timing)
    assert close(fast.coefficients, slow.coefficients)
    assert close(values, slow(times, 2))


@pytest.mark.parametrize("smoothness", [2, 4, 6])
@pytest.mark.parametrize("bounds", [(0.0, 0.0), (0.45, 0.0), (0.0, 0.95), (0.1, 2.0)])
def test_proofs_of_the_rope_agree(smoothness: int, bounds: tuple[float, float]) -> None:
    points = [Waypoint([0.0, 0.0, -1.0]), Waypoint([0.5, 0.3, -0.6]), Waypoint([0.1, 0.0, -0.5])]
    limits = Limits([1.0, 0.4, 0.5], [1.0, 0.5, 12.0], [10.0, 9.0, 400.0])
    found = plan(points, limits, smoothness=smoothness)
    for gravity in (9.81, 3.0):
        outputs = []
        for module in (rope, compiled):
            report = np.zeros(3)
            status = module.check_rope(
                found.timing, found.coefficients, found.offsets, np.array([gravity, *bounds]),
                np.zeros((RopeWork.SIZE, 8 * smoothness - 5)), report,
            )
            outputs.append([status, *report])
        assert close(*outputs)


def test_crane_kernels_agree() -> None:
    random = np.random.default_rng(3)
    for _ in range(50):
        state = random.uniform(-0.5, 0.5, 10)
        state[2] = random.uniform(0.3, 3.0)
        force, wind = random.uniform(-9.0, 9.0, (2, 3))
        generalized = np.append(force, [0.1, -0.2])
        flat = random.uniform(-1.0, 1.0, (5, 3)) + np.array([[0.0, 0.0, -2.0]] + [[0.0] * 3] * 4)
        outputs = []
        for module in (_crane, compiled):
            results = [np.zeros(10), np.zeros(2), np.zeros((2, 3)), np.zeros(3), np.zeros(10)]
            accelerations = np.zeros(5)
            module.crane_rhs(state, generalized, wind, np.array(MASSES), results[0])
            module.crane_energy(state, np.array(MASSES), results[1])
            module.crane_load(state, results[2])
            module.crane_flat_inverse(flat, np.array(MASSES), results[3], results[4], accelerations)
            outputs.append(np.concatenate([r.ravel() for r in (*results, accelerations)]))
        assert close(*outputs)


@pytest.mark.parametrize("driven", [False, True])
@campaign(6, 20)
def test_plants_agree(driven: bool, count: int) -> None:
    random = np.random.default_rng(5)
    rig = Rig(
        bridge=Drive(0.02, 12.0, 2.0), trolley=Drive(0.01, 3.0), hoist=Drive(0.0, 25.0),
        friction=Friction((1.0, 2.0, 3.0), (0.5, 0.4, 0.3), 0.01, 0.02),
        wind=Wind((0.1, 0.2, 0.0), Gust(0.0, 0.1, (1.0, 0.5, 0.1), "sine"), (0.1, 0.1, 0.0)),
    )
    parameters = rig.parameters(Crane(*MASSES), driven)
    for _ in range(count):
        state = np.append(random.uniform(-0.4, 0.4, 10), np.zeros(PlantState.SIZE - State.SIZE))
        state[2] = random.uniform(0.5, 3.0)
        command, load_force = random.uniform(-1.0, 1.0, (2, 3))
        rate = random.uniform(-1.0, 1.0, 9)
        command[2] = 0.0 if driven else -15.0
        outputs = []
        for advance in (plant.plant_advance, compiled.plant_advance):
            moved, report = state.copy(), np.zeros(Report.SIZE)
            work = np.zeros((Work.SIZE, Work.COLUMNS))
            work[Work.COMMAND, :3], work[Work.RATES, : CommandRates.SIZE] = command, rate
            work[Work.LOAD_FORCE, :3] = load_force
            status = advance(
                parameters, rig.wind.components, 0.05, moved, 0.02, 1e-9, work, report
            )
            assert status == 0
            outputs.append(np.concatenate([moved, report]))
        assert np.allclose(*outputs, rtol=1e-10, atol=1e-12)


def test_noise_agrees() -> None:
    outputs = []
    for module in (noise, compiled):
        numbers, components = np.zeros(RandomState.SIZE), np.zeros((8, Sinusoid.SIZE))
        module.seed_numbers(2**31 - 1, numbers)
        module.noise_components(2.0, np.array([1.0, 2.0, 0.5]), numbers, components)
        outputs.append(np.concatenate([numbers, components.ravel()]))
    assert close(*outputs)


@pytest.mark.parametrize("driven", [False, True])
@pytest.mark.parametrize("kind", CONTROLLERS)
def test_rigs_agree(monkeypatch: pytest.MonkeyPatch, kind: str, driven: bool) -> None:
    start = HANGING.copy()
    start[3:5] = 0.1, -0.05
    outputs = []
    for module in (compiled, rig):
        for name in ("rig_rows", "rig_start", "rig_step"):
            monkeypatch.setattr(backend, name, getattr(module, name))
        plant = Plant(
            LAB, start, Setpoints(np.array([0.0, 0.0, -9.81]), reference=HANGING),
            CONTROLLERS[kind](driven), driven=driven, rig=everything(), start_time=0.3,
        )
        for i in range(1, 13):
            share = i / 12
            force, velocity = np.array([share, share, -9.81 - share]), np.full(3, 0.1 * share)
            plant.step(0.003 * (1 + i % 3), Setpoints(force, velocity, HANGING))
        outputs.append(np.concatenate([plant.state, plant.measured, plant.drive_force]))
    assert np.allclose(*outputs, rtol=1e-10, atol=1e-12)


def test_feedback_agrees() -> None:
    random = np.random.default_rng(4)
    gains = random.uniform(-1.0, 1.0, (3, Gains.SIZE, Gains.COLUMNS))
    gains[:, Gains.LENGTH, 0] = 0.5, 1.0, 2.0
    for length in (0.1, 0.5, 0.7, 1.0, 1.9, 2.0, 5.0):
        state, reference = random.uniform(-1.0, 1.0, (2, 10))
        state[2] = length
        results, added = np.zeros((2, 3)), random.uniform(-1.0, 1.0, 3)
        feedback.feedback_correction(state, reference, added, gains, results[0])
        compiled.feedback_correction(state, reference, added, gains, results[1])
        assert close(*results)


@pytest.mark.parametrize("driven", [False, True])
def test_flat_gains_agree(driven: bool) -> None:
    results = np.zeros((2, Gains.SIZE, Gains.COLUMNS))
    crane = Crane(*MASSES).plant(driven, (0.1, 0.0, 0.05))
    for module, gains in zip((feedback, compiled), results, strict=True):
        bandwidth = module.feedback_bandwidth(1.3, 0.2, 9.81, 0.05, 0.25)
        module.feedback_gains(crane, 0.2, bandwidth, 1.1 * bandwidth, 9.0, 0.8, gains)
    assert close(*results)
    assert results[0].any()


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_friction_along_a_plan_agrees(axis: int) -> None:
    """History of a contact, friction, its derivatives and events; every axis turns round."""
    found = plan([Waypoint([0.0, 0.0, -1.0]), Waypoint([0.1, 0.3, -0.6]),
                  Waypoint([-0.1, 0.0, -0.9])], Limits(0.5, 0.4, 1.0))
    plan_of = found.timing, found.coefficients, found.offsets, found.axis_durations
    known = everything().parameters(LAB, True)[: Resistance.SIZE].copy()
    known[Resistance.COULOMB : Resistance.STATIC] = 4.0
    known[Resistance.STATIC : Resistance.DRAG] = 5.0
    outputs = []
    slope = friction_series.friction_derivative
    interpreted = SimpleNamespace(**vars(contact), friction_derivative=slope)
    for kernels in (interpreted, compiled):
        rows = np.zeros((12, Contact.SIZE))
        work = np.zeros((ContactWork.SIZE, ContactWork.COLUMNS))
        count = kernels.contact_history(axis, *plan_of, known, work, rows)
        values = [float(count), *rows.ravel()]
        for time in np.linspace(0.0, found.duration + 0.1, 40):
            motion = np.array([0.01 * time, 1e-3, 0.2, 0.1, 0.5])
            values.append(kernels.planned_friction(known, axis, time, 0.01 * time, 1e-3, rows))
            values.append(kernels.next_contact_event(time, 0.3, rows))
            values.append(kernels.friction_derivative(
                known, axis, time, motion, 3, rows, np.zeros((FrictionSeries.SIZE, 4))
            ))
        outputs.append(values)
    assert outputs[0][0] >= 3.0
    assert close(*map(np.array, outputs))


def test_observers_agree() -> None:
    outputs = []
    for module in (observer, compiled):
        random = np.random.default_rng(8)
        table = random.uniform(-1.0, 1.0, (3, Observer.SIZE, Observer.COLUMNS))
        table[:, Observer.LENGTH, 0] = 0.5, 1.0, 2.0
        estimate = random.uniform(-1.0, 1.0, (3, 6))
        for length in (0.1, 0.7, 2.5):
            command, held = random.uniform(-1.0, 1.0, (2, 3))
            measured, reference = random.uniform(-1.0, 1.0, 5), random.uniform(-1.0, 1.0, 10)
            for axis in range(3):
                module.observer_predict(
                    axis, length, table, command[axis], held[axis], estimate[axis], np.zeros(10)
                )
            module.observer_correct(length, table, measured, reference, estimate)
        outputs.append(estimate)
    assert close(*outputs)


@pytest.mark.parametrize("delayed", [False, True])
@pytest.mark.parametrize("driven", [False, True])
def test_tracking_agrees(driven: bool, delayed: bool) -> None:
    crane = Crane(*MASSES)
    options = {"sample_time": 0.01, "shortest": 0.3, "longest": 0.9, "driven": driven, "rows": 3}
    watcher = design_observer(crane, lag=(0.02, 0.0, 0.01), delayed=delayed, **options)
    outputs = []
    for module in (tracking, compiled):
        random = np.random.default_rng(9)
        controller = TrackingController(
            watcher, design_flat(crane, **options), rejection=(0.9, 0.8),
            lower=[-6.0, -6.0, -20.0], upper=[6.0, 6.0, 0.0],
        )
        parameters, rows = controller.parameters, []
        memory = np.zeros((Tracker.SIZE, Tracker.COLUMNS))
        for i in range(60):
            parameters[Tracking.ENABLED] = i < 40
            memory[Tracker.COMMAND, VelocityCommand.SWITCHED] = i in (20, 40)
            reference, tick = crane.hanging([0.1, 0.2, -0.6]), np.zeros((Tick.SIZE, Tick.COLUMNS))
            tick[Tick.REFERENCE], tick[Tick.ADDED_TO, :3] = reference, random.uniform(-1.0, 1.0, 3)
            # the first ones are below the steps of the sensors
            measured = reference[:5] + min(i, 3) * random.uniform(-1e-4, 1e-2, 5) * (i > 1)
            tick[Tick.SIGNALS, :5] = measured
            gains = controller.feedback.table
            module.track_setpoint(parameters, watcher.table, gains, tick, memory)
            rows.append(np.concatenate([tick[Tick.CORRECTION, :3], memory.ravel()]))
        outputs.append(np.array(rows))
    assert np.allclose(*outputs, rtol=1e-9, atol=1e-11)
    assert np.abs(outputs[0][30]).max() > 0.1


def readonly(shape: tuple[int, ...]) -> np.ndarray:
    array = np.zeros(shape)
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    "arguments",
    [
        (),
        (np.zeros(11),),
        (np.zeros(11), np.zeros((2, 3)), 1),
        (np.zeros(11), np.zeros(6)),
        (np.zeros(11, dtype=np.float32), np.zeros((2, 3))),
        (np.zeros(11, dtype=np.int64), np.zeros((2, 3))),
        (np.zeros(22)[::2], np.zeros((2, 3))),
        (np.zeros(11), np.zeros((3, 2)).T),
        (np.zeros(11), readonly((2, 3))),
        ([0.0] * 11, np.zeros((2, 3))),
        (None, np.zeros((2, 3))),
    ],
)
def test_wrong_arguments_raise(arguments) -> None:
    with pytest.raises((TypeError, ValueError, BufferError)):
        compiled.crane_load(*arguments)


@pytest.mark.parametrize(("value", "expected"), [("1", "False"), ("0", "True"), ("", "True")])
def test_environment_chooses(value: str, expected: str) -> None:
    code = "from segfmu.kernels import backend; print(backend.COMPILED)"
    done = subprocess.run(
        [sys.executable, "-c", code], env={**os.environ, "SEGFMU_INTERPRETED": value},
        capture_output=True, text=True, check=True,
    )
    assert done.stdout.strip() == expected


@pytest.mark.parametrize(
    "arguments",
    [
        (np.zeros(10), np.zeros(5), np.zeros(3), np.zeros(4), np.zeros(9)),
        (np.zeros(10), np.zeros(5), np.zeros(3), np.zeros(3), np.zeros(10)),
        (np.zeros(9), np.zeros(5), np.zeros(3), np.zeros(4), np.zeros(10)),
    ],
)
def test_arrays_that_are_too_short_are_refused(arguments) -> None:
    with pytest.raises(IndexError, match="must be at least"):
        compiled.crane_rhs(*arguments)
