"""A measured state that GantryFeedforward takes over, at the start and while it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.operated import LAB, PORT, Site, parameters

from segfmu import ActuatorBounds, Clearance, InputError, Operator
from segfmu.fmu.gantry_crane.feedback_parameters import DESIGNS
from segfmu.kernels.operation.records import MEASURED
from tests.fmu.gantry_feedforward.test_commands import (
    KINDS,
    LOAD,
    MODES,
    SITES,
    arrays,
    named,
)
from tests.fmu.gantry_feedforward.test_drive_bounds import initialised
from tests.fmu.native.importer import Importer

REFERENCE = [f"reference.{n}" for n in MEASURED]
STILL = {"mode": "stop", "scale": 1.0, "target": [0.0] * 3, "velocity": [0.0] * 3}
BOUNDS = {
    "lab": ActuatorBounds(velocity=0.6, acceleration=0.9),
    "port": ActuatorBounds(velocity=4.0, acceleration=0.8),
}


@pytest.fixture(params=KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def archive(request, native_fmus, fmus) -> Path:
    kind, fmi = request.param
    return native_fmus[fmi][0] if kind == "native" else fmus[0]


def swing_of(site: Site) -> np.ndarray:
    """A load that swings by some degrees below a moving bridge."""
    rope = -site.start[2]
    rate = np.sqrt(site.crane.gravity / rope)
    return np.array([0.1, 0.2, rope, 0.08, -0.05, 0.1, 0.0, 0.0, 0.05 * rate, 0.0])


def measured(state: np.ndarray) -> dict[str, float]:
    """A state of the crane as values of the FMU's variables."""
    return {f"measured.{n}": float(v) for n, v in zip(MEASURED, state, strict=True)}


def given(name: str) -> dict[str, Any]:
    """Parameters of a site with bounds of velocities and accelerations, without obstacles."""
    site, bounds = SITES[name], BOUNDS[name]
    values = parameters(site) | {"obstacle.count": 0, "sway.x.angle_max": 0.0,
                                 "sway.y.angle_max": 0.0}
    for k, drive in enumerate(("bridge", "trolley", "hoist")):
        values[f"drive.{drive}.force_max"] = 0.0
        values[f"drive.{drive}.velocity_max"] = float(bounds.velocity[k])
        values[f"drive.{drive}.acceleration_max"] = float(bounds.acceleration[k])
    return values


def operator_of(name: str, state: np.ndarray) -> Operator:
    site = SITES[name]
    space = Clearance(minimum=site.clearance.minimum, maximum=site.clearance.maximum)
    return Operator(site.crane, site.limits, state, bounds=BOUNDS[name], clearance=space)


@pytest.mark.parametrize("goes", [False, True], ids=["to rest", "to a target"])
@pytest.mark.parametrize("name", SITES)
def test_an_fmu_begins_in_a_measured_swing(archive, name: str, goes: bool) -> None:
    site, state = SITES[name], swing_of(SITES[name])
    scale = 1.0 if name == "lab" else 20.0
    target = np.asarray(site.start) + scale * np.array([0.3, 0.15, 0.05])
    command = STILL | {"mode": "target" if goes else "stop", "target": target}
    operator = operator_of(name, state)
    operator.command(**command)
    with Importer(archive) as fmu:
        fmu.set(arrays(fmu, given(name)))
        fmu.set(measured(state) | {"command.take_over": True} | named(command))
        fmu.initialise()
        np.testing.assert_allclose(fmu.get(*REFERENCE), state, atol=1e-7)
        for i in range(600):
            fmu.step(i * site.step, site.step)
            load = operator.step(site.step)
            np.testing.assert_allclose(fmu.get(*LOAD[:6]), load[:2].ravel(), rtol=0, atol=1e-7)
            # straight to the target, and without a stop between
            assert operator.status == "taken"
            if operator.time > operator.rests_at:
                break
        assert operator.time > operator.rests_at
        np.testing.assert_allclose(fmu.get(*LOAD[3:6]), 0.0, atol=1e-8)
        if goes:
            np.testing.assert_allclose(fmu.get(*LOAD[:3]), target, atol=1e-9)
            fmu.step((i + 1) * site.step, site.step)
            np.testing.assert_allclose(fmu.get(*LOAD[:3]), target, atol=1e-9)


@pytest.mark.parametrize("lead", [0.0, 0.01])
@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("name", SITES)
def test_a_crane_that_swings_is_taken_over_while_it_runs(
    native_fmus, name: str, fmi: int, lead: float
) -> None:
    """The error between reference and crane is gone from there on, without a feedback."""
    site, state = SITES[name], swing_of(SITES[name])
    step = 0.01 * np.sqrt(-site.start[2] / 15.0)
    drives = [f"velocity.{d}" for d in ("bridge", "trolley", "hoist")]
    begin = {n: float(v) for n, v in zip(MEASURED, state, strict=True)}
    begin |= dict.fromkeys(("bridge.velocity", "trolley.velocity", "rope.velocity"), 0.0)
    lead = lead and step
    with Importer(native_fmus[fmi][0]) as planner, Importer(native_fmus[fmi][1]) as crane:
        planner.set(arrays(planner, given(name) | {"setpoint.lead": lead}))
        planner.set({"command.mode": MODES["stop"]})
        crane.set(dict(site.crane.values()) | begin | {
            "drive.mode": 2, "feedback.enabled": False,
            "feedback.design": DESIGNS.items.index("flatness") + 1,
        })
        planner.initialise()
        crane.initialise()
        errors, names = [], [*LOAD[:3], *drives, *REFERENCE]
        sent = planner.get(*names)
        for i in range(6000):
            if i == 20:
                now = np.array(crane.get(*MEASURED))
                planner.set(measured(now) | {"command.take_over": True})
            planner.step(i * step, step)
            # units in parallel: what is sent acts a step later, which the lead makes up for
            acting = sent if lead else planner.get(*names)
            sent = planner.get(*names)
            signals = dict(zip(names[3:], acting[3:], strict=True))
            crane.set({n: v for n, v in signals.items() if n in crane.variables})
            crane.step(i * step, step)
            place = np.array(crane.get("load.position.x", "load.position.y", "load.position.z"))
            errors.append(np.linalg.norm(np.array(acting[:3]) - place))
            rests = np.abs(planner.get(*LOAD[3:6])).max() < 1e-9
            if i > 30 and rests:
                break
        rope = -site.start[2]
        assert rests
        assert min(errors[:20]) > 0.05 * rope
        assert max(errors[21:]) < 1e-5 * rope
        assert np.abs(crane.get("sway.x.angle", "sway.y.angle")).max() < np.deg2rad(0.1)


@pytest.mark.parametrize("native", [True, False], ids=["native", "python"])
def test_what_cannot_be_taken_over_is_told(native_fmus, fmus, native: bool) -> None:
    archive = native_fmus[2][0] if native else fmus[0]
    state = swing_of(LAB)
    far = {"measured.bridge.position": 1.1e6, "workspace.x.max": 1e9, "travel.bridge.max": 1e9}
    for values, told in (
        (measured(state) | {"workspace.x.max": 0.14}, "leaves the workspace"),
        (measured(state) | far, "beyond 1e6 m, where targets end"),
        (measured(state) | {"measured.rope.length": -1.0}, "no state of a load"),
        (measured(state) | {"drive.bridge.acceleration_max": 0.0}, "drive.*.acceleration_max"),
    ):
        found = initialised(archive, given("lab") | {"command.take_over": True} | values)
        assert isinstance(found, str)
        assert told in found


def test_a_refused_state_changes_nothing(archive) -> None:
    with Importer(archive) as fmu:
        fmu.set(arrays(fmu, given("lab")) | {"command.mode": MODES["stop"]})
        fmu.initialise()
        fmu.step(0.0, 0.02)
        fmu.set(measured(swing_of(LAB)) | {"measured.sway.x.angle": 2.0, "command.take_over": True})
        fmu.step(0.02, 0.02)
        np.testing.assert_allclose(fmu.get(*LOAD[:3]), LAB.start, atol=1e-9)


def test_an_operator_takes_a_state_over_while_it_moves() -> None:
    operator = operator_of("port", np.array([0.0, 0.0, 15.0] + [0.0] * 7))
    operator.command("velocity", velocity=[0.0, 2.0, 0.0])
    for _ in range(50):
        operator.step(PORT.step)
    state = operator.setpoints[3:13].copy()
    # a gust
    state[4] += 0.05
    operator.take_over(state)
    np.testing.assert_allclose(operator.setpoints[3:13], state, atol=1e-7)
    operator.command("stop")
    while operator.time < operator.rests_at:
        operator.step(PORT.step)
    np.testing.assert_allclose(operator.load[1:4], 0.0, atol=1e-8)
    with pytest.raises(InputError, match="state must have 10 values"):
        operator.take_over([0.0])


@pytest.mark.parametrize("name", SITES)
def test_the_jerk_of_a_calming_load_is_continuous(name: str) -> None:
    operator = operator_of(name, swing_of(SITES[name]))
    times = np.linspace(0.0, operator.rests_at, 20001)
    jerks = np.array([operator.load_at(t)[3] for t in times])
    # a jump does not shrink with the time between samples
    coarse = np.abs(np.diff(jerks[::4], axis=0)).max()
    fine = np.abs(np.diff(jerks, axis=0)).max()
    assert fine < 0.3 * coarse
