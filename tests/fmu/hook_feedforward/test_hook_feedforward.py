"""HookFeedforward as native FMUs: by fmpy, against the Python inverse, and with HookCrane."""

from __future__ import annotations

import re

import numpy as np
import pytest
from fmpy import simulate_fmu

from segfmu import Crane, FlatInverse, HookCrane, Limits, Waypoint, plan
from segfmu.cosim import simulate
from segfmu.crane import Friction
from segfmu.kernels.crane.records import DRIVES
from segfmu.kernels.hook.records import HookFeedforward
from tests.fmu.checking import faults

NAMES = tuple(v for f in HookFeedforward.FIELDS.values() for v in f.variables if v)
KINDS = [(fmi, kind) for fmi in (2, 3) for kind in ("CoSimulation", "ModelExchange")]
# a crane, limits of x, y and z, and the ends of a move that hoists
RIGS = {
    "lab": (
        HookCrane(Crane(2.2, 1.155, 1.0), 0.1, 0.3), (0.6, 1.0, 3.0, 20.0),
        ((0.0, 0.0, -0.9), (0.8, 0.5, -0.7)),
    ),
    "hall": (
        HookCrane(Crane(12e3, 3e3, 10e3, rope_max=12.0), 500.0, 4.0), (1.0, 0.4, 0.4, 0.8),
        ((0.0, 0.0, -10.0), (12.0, 6.0, -8.0)),
    ),
}


def values(name: str, **other: float) -> dict[str, float]:
    """Parameters of both FMUs."""
    hook, limits, ends = RIGS[name]
    crane = {n: v for n, v in hook.values().items() if v or not n.startswith("crane.rope")}
    crane |= {f"crane.rope_{n}": getattr(hook.crane, f"rope_{n}") or 0.0 for n in ("min", "max")}
    planned = {"waypoint.count": 2}
    for i, place in enumerate(ends, 1):
        for axis, x in zip("xyz", place, strict=True):
            planned[f"waypoint[{i}].position.{axis}"] = x
            planned |= {f"waypoint[{i}].{q}.{axis}": 0.0 for q in ("velocity", "acceleration")}
    for axis in "xyz":
        for quantity, limit in zip(("velocity", "acceleration", "jerk", "snap"), limits,
                                   strict=True):
            planned[f"limits.{axis}.{quantity}"] = limit
    return crane | planned | other


def inverse(name: str, smoothness: int = 6) -> FlatInverse:
    hook, limits, ends = RIGS[name]
    points = [Waypoint(p) for p in ends]
    trajectory = plan(points, Limits(*limits), smoothness=smoothness, shape="smoothstep")
    return FlatInverse(hook, trajectory)


@pytest.mark.parametrize("fmi", [2, 3])
def test_fmpy_finds_nothing(hook_fmus, fmi: int) -> None:
    assert faults(hook_fmus[fmi][0]) == []


@pytest.mark.parametrize("name", RIGS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_outputs_are_those_of_python(hook_fmus, kind: str, name: str) -> None:
    expected = inverse(name)
    stop = expected.trajectory.duration
    rows = simulate_fmu(
        str(hook_fmus[2][0]), fmi_type=kind, stop_time=stop, step_size=stop / 50,
        output_interval=stop / 50, start_values=values(name), output=[*NAMES, "plan.duration"],
    )
    assert rows["plan.duration"][0] == pytest.approx(stop, rel=1e-12)
    times = rows["time"]
    found = expected.evaluate(times)
    columns = expected.model.columns
    table = np.hstack([found, found[:, columns.velocity]])
    kept = [i for i, v in enumerate(
        v for f in HookFeedforward.FIELDS.values() for v in f.variables) if v]
    for column, variable in zip(kept, NAMES, strict=True):
        scale = max(1.0, np.abs(table[:, column]).max())
        assert rows[variable] == pytest.approx(table[:, column], abs=2e-9 * scale), variable


def missed(hook_fmus, fmi: int, name: str, step: float) -> float:
    """Largest distance [m] of the load from its plan with ideal force drives and no feedback."""
    source, sink = hook_fmus[fmi]
    given = values(name)
    own = {n: v for n, v in given.items() if n.startswith(("crane.", "hook."))}
    start = {"start.on_reference": True, "feedback.enabled": False}
    rows = simulate(
        source, sink, stop_time=inverse(name).trajectory.duration, step=step,
        source_values=by_array(given, fmi), sink_values=own | start,
    )
    assert np.abs(rows["reference.sling.x.angle"]).max() > 0.005
    return float(rows["error.load.norm"].max())


@pytest.mark.parametrize("name", RIGS)
def test_hook_crane_keeps_the_load_on_its_plan(hook_fmus, name: str) -> None:
    """Hook and sling swing, the load does not leave its path."""
    assert missed(hook_fmus, 2, name, 1e-3) <= 1e-9


def test_values_alone_converge_to_the_plan(hook_fmus) -> None:
    """In FMI 3 the master has values, no derivatives: half the step, a quarter of the error."""
    errors = [missed(hook_fmus, 3, "lab", step) for step in (1e-3, 5e-4)]
    assert errors[0] <= 2e-6
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)


def by_array(given: dict[str, float], fmi: int) -> dict[str, object]:
    """In FMI 3 waypoints are arrays."""
    if fmi == 2:
        return dict(given)
    rest: dict[str, object] = {n: v for n, v in given.items() if "waypoint[" not in n}
    for quantity in ("position", "velocity", "acceleration"):
        rest[f"waypoint.{quantity}"] = [
            given[f"waypoint[{i}].{quantity}.{a}"] for i in (1, 2) for a in "xyz"
        ]
    return rest


@pytest.mark.parametrize(("changed", "text"), [
    ({"waypoint[2].position.z": -0.3}, "height z of the rope's end passes the trolley's height"),
    ({"crane.rope_max": 0.55}, r"rope length passes rope_max, 0\.55 m"),
    ({"drive.bridge.force_max": 0.5}, r"drive\.bridge\.force_max is 0\.5 N"),
    ({"obstacle.count": 1}, r"obstacle\[1\]: the rope above a sling"),
    ({"planner.smoothness": 4}, r"planner\.smoothness"),
])
def test_what_cannot_be_is_told(hook_fmus, changed: dict[str, float], text: str) -> None:
    messages: list[str] = []
    with pytest.raises(Exception, match="fmi2"):
        simulate_fmu(
            str(hook_fmus[2][0]), stop_time=1.0, start_values=values("lab", **changed),
            debug_logging=True, logger=lambda *m: messages.append(str(m[-1])),
        )
    assert any(re.search(text, m) for m in messages), messages


def test_plans_slow_down_within_bounds_of_the_drives(hook_fmus) -> None:
    """Uses of the bounds are those of the hook's own demands."""
    bounded = values("lab", **{"planner.slows_down": True, "drive.bridge.force_max": 1.0})
    rows = simulate_fmu(
        str(hook_fmus[2][0]), stop_time=8.0, step_size=0.01, output_interval=0.01,
        start_values=bounded, output=["force.bridge", "plan.use.bridge.force", "plan.pace"],
    )
    assert rows["plan.pace"][0] < 0.999
    assert rows["plan.use.bridge.force"][0] == pytest.approx(1.0, abs=1e-5)
    assert 0.99 < np.abs(rows["force.bridge"]).max() <= 1.0 + 1e-9


def test_limits_are_found_within_bounds_of_the_drives(hook_fmus) -> None:
    quantities = ("velocity", "acceleration", "jerk", "snap")
    free = {f"limits.{a}.{q}": 0.0 for a in "xyz" for q in quantities}
    force = {f"drive.{d}.force_max": f for d, f in zip(DRIVES, (3.0, 2.0, 12.5), strict=True)}
    velocity = {f"drive.{d}.velocity_max": 0.8 for d in DRIVES}
    given = values("lab", **free, **force, **velocity, **{"planner.finds_limits": True})
    rows = simulate_fmu(
        str(hook_fmus[2][0]), stop_time=6.0, step_size=0.002, output_interval=0.002,
        start_values=given, output=[*(f"force.{d}" for d in DRIVES), "plan.duration"],
    )
    for name, most in force.items():
        drive = name.split(".")[1]
        assert np.abs(rows[f"force.{drive}"]).max() <= most * (1.0 + 1e-9)
    assert rows["plan.duration"][0] < 4.0


def test_friction_is_added_to_the_forces(hook_fmus) -> None:
    rubbing = Friction(viscous=(3.0, 2.0, 0.0), coulomb=(0.4, 0.2, 0.0))
    plain = inverse("lab")
    expected = FlatInverse(plain.crane, plain.trajectory, rubbing)
    known = {"friction.bridge.viscous": 3.0, "friction.trolley.viscous": 2.0,
             "friction.bridge.coulomb": 0.4, "friction.trolley.coulomb": 0.2}
    rows = simulate_fmu(
        str(hook_fmus[2][0]), stop_time=1.5, step_size=0.05, output_interval=0.05,
        start_values=values("lab", **known), output=["force.bridge", "force.trolley"],
    )
    for i, drive in enumerate(("bridge", "trolley")):
        found = expected.force(rows["time"])[:, i]
        assert rows[f"force.{drive}"] == pytest.approx(found, abs=1e-7)
    assert np.abs(expected.force(0.7) - plain.force(0.7)).max() > 0.5
