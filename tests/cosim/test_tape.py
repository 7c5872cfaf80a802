"""Planners that are heard from a tape: rows of runs in which they run themselves, bit for bit."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from segfmu.cosim import Change, System
from segfmu.errors import InputError, SimulationError
from tests.compiler import needs_loop
from tests.cosim.test_native import CASES, CHANGES, SINK, SOURCE, STEP, UNKIND

pytestmark = needs_loop

STOP = 0.6
SWAYS = (0.1, -0.05, 0.0, 0.02)


def refuse(*_: Any) -> None:
    raise AssertionError("the planner runs")


def compared(
    fmus: Any, runs: list[dict[str, Any]], repeatable: tuple[str, ...] = (SOURCE,), **options: Any
) -> None:
    """Make runs in a system with a tape, and each in a new one without."""
    options = {"step": STEP, **options}
    with System(fmus, repeatable=repeatable, engine="c", **options) as system:
        for number, run in enumerate(runs):
            rows = system.run(**run)
            with System(fmus, **options) as other:
                assert rows.tobytes() == other.run(**run).tobytes(), number


def disturbed(sway: float, **plan: float) -> dict[str, dict[str, float]]:
    return {SINK: UNKIND | {"sway.x.angle": sway}, SOURCE: plan}


@pytest.mark.soak
@pytest.mark.parametrize(("fmi", "coupling", "events", "lead"), CASES)
def test_rows_are_those_of_the_planner(native_fmus, fmi, coupling, events, lead) -> None:
    """Changes of the crane at times of their own, a plan that changes, and another end."""
    times = {"stop_time": STOP, "changes": [c for c in CHANGES if c.time < STOP]}
    runs = [{"values": disturbed(s, **{"setpoint.lead": lead}), **times} for s in SWAYS]
    other = disturbed(0.1, **{"planner.duration": 6.0, "setpoint.lead": lead})
    runs += [{"values": other, **times}] * 3 + [runs[0]]
    runs += [{**runs[0], "stop_time": 0.5, "changes": ()}] * 3
    compared(native_fmus[fmi], runs, coupling=coupling, events=events)


@pytest.mark.parametrize("fmi", [2, 3])
def test_the_third_run_leaves_the_planner_out(native_fmus, monkeypatch, fmi: int) -> None:
    with System(native_fmus[fmi], step=STEP, repeatable=[SOURCE], engine="c") as system:
        for _ in range(2):
            system.run(stop_time=STOP)
        planner = system._units[SOURCE]
        for name in ("set", "enter_initialization", "exit_initialization", "reset"):
            monkeypatch.setattr(planner, name, refuse if name != "reset" else planner.reset)
        system.run({SINK: {"sway.y.angle": 0.1}}, stop_time=STOP)
        with pytest.raises(AssertionError, match="the planner runs"):
            system.run({SOURCE: {"planner.duration": 6.0}}, stop_time=STOP)


def test_values_that_are_arrays(native_fmus) -> None:
    def run(end: float) -> dict[str, Any]:
        positions = np.array([[0.0, 0.0, -0.5], [end, 0.2, -0.4]])
        return {"values": {SOURCE: {
            "waypoint.count": 2, "waypoint.position": positions, "planner.duration": 0.0,
        }}, "stop_time": STOP}

    compared(native_fmus[3], [run(x) for x in (0.3, 0.3, 0.3, 0.2, 0.2, 0.2)])


def test_a_planner_that_hears_of_changes_runs(native_fmus) -> None:
    changes = [Change(0.2, SOURCE, {"command.mode": "stop"})]
    run = {"values": disturbed(0.1) | {SOURCE: {"command.enabled": True}}, "stop_time": STOP}
    compared(native_fmus[2], [run | {"changes": changes}] * 3 + [run] * 3)


def test_steps_that_end_elsewhere(native_fmus) -> None:
    """Another planner, whose events the steps meet too, has another plan."""
    source, sink = native_fmus[2]
    fmus = {"first": source, "second": source, SINK: sink}
    runs = [
        {"values": {"second": {"planner.duration": x}}, "stop_time": STOP}
        for x in (6.0, 6.0, 6.0, 7.0, 7.0, 7.0, 8.0)
    ]
    links = [("first", n, SINK, n) for n in ("force.bridge", "reference.bridge.position")]
    compared(fmus, runs, ("first",), connections=links, coupling="sequential")


def test_a_run_that_fails_leaves_no_tape(native_fmus) -> None:
    tight = {SINK: {"feedback.enabled": False, "travel.bridge.max": 0.005}}
    with System(native_fmus[2], step=STEP, repeatable=[SOURCE], engine="c") as system:
        whole = system.run(stop_time=STOP)
        for _ in range(2):
            with pytest.raises(SimulationError, match="travel"):
                system.run(tight, stop_time=STOP)
        for _ in range(3):
            assert system.run(stop_time=STOP).tobytes() == whole.tobytes()


def test_inputs_that_are_connected_are_heard(native_fmus, pendulums) -> None:
    fmus = {"pendulum": pendulums[2], "crane": native_fmus[2][1]}
    links = [("crane", "sway.x.rate", "pendulum", "reference.bridge.acceleration")]
    runs = [
        {"values": {"crane": {"sway.x.angle": s}, "pendulum": {"sway.angle": 0.1}},
         "stop_time": STOP} for s in SWAYS
    ]
    compared(fmus, runs, ("pendulum",), connections=links)


def test_names_that_there_are_not(native_fmus) -> None:
    with pytest.raises(InputError, match="no FMU Planner in the system"):
        System(native_fmus[2], step=STEP, repeatable=["Planner"])


def test_python_makes_the_same_runs(native_fmus) -> None:
    with System(native_fmus[2], step=STEP, repeatable=[SOURCE], engine="python") as system:
        rows = [system.run(stop_time=0.1) for _ in range(3)]
    assert np.all(rows[2] == rows[0])
