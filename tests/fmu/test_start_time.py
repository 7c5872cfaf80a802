"""Simulations that start late or early: by default the motion starts with them."""

from __future__ import annotations

from pathlib import Path

import fmpy
import numpy as np
import pytest

from segfmu.cosim import simulate
from tests.fmu.native.importer import Importer

KINDS = [("native", 2), ("native", 3), ("python", 2)]
EACH = [(b, v, "CoSimulation") for b, v in KINDS] + [("native", v, "ModelExchange") for v in (2, 3)]
STARTS = (100.0, -7.25, 1e6)
OUTPUTS = (
    "reference.load.position.x", "reference.load.position.y", "reference.load.velocity.x",
    "reference.load.acceleration.y", "reference.bridge.position", "reference.sway.x.angle",
    "force.bridge", "velocity.trolley", "force.hoist",
)
STEP, ROWS = 0.25, 25
LATE = {
    "drive.bridge.dead_time": 0.05, "drive.hoist.dead_time": 0.11, "drive.trolley.lag": 0.2,
    "setpoint.lead": 0.03,
}


def archive_of(kind, native_fmus, fmus) -> Path:
    return native_fmus[kind[1]][0] if kind[0] == "native" else fmus[0]


@pytest.fixture(params=EACH, ids=lambda kind: f"{kind[0]} {kind[1]} {kind[2]}")
def feedforward(request, native_fmus, fmus):
    """An archive and the interface to run it with."""
    return archive_of(request.param, native_fmus, fmus), request.param[2]


def discrete(fmu: Importer) -> list[int]:
    interval, done = (fmu.variables[n].valueReference for n in ("plan.interval", "plan.done"))
    integers = fmu.fmu.getInt32 if fmu.three else fmu.fmu.getInteger
    return [int(integers([interval])[0]), int(fmu.fmu.getBoolean([done])[0])]


def rows(
    path: Path, interface: str, start: float, values: dict[str, float] | None = None
) -> np.ndarray:
    """Outputs, time of the next event since the start, interval and end, a row each step."""
    found = []
    with Importer(path, interface) as fmu:
        fmu.set(values or {})
        fmu.initialise(start)
        for i in range(ROWS):
            time = start + i * STEP
            if i > 0 and interface == "CoSimulation":
                fmu.step(time - STEP, STEP)
            elif i > 0:
                fmu.fmu.setTime(time)
                fmu.fmu.enterEventMode()
                fmu.event()
            ahead = fmu.get("plan.next_event") - start
            found.append(np.array([*fmu.get(*OUTPUTS), *ahead, *discrete(fmu)]))
    return np.array(found)


@pytest.mark.parametrize("values", [{}, LATE], ids=("plain", "drives and lead"))
@pytest.mark.parametrize("start", STARTS)
def test_the_motion_starts_with_the_simulation(feedforward, start, values) -> None:
    expected = rows(*feedforward, 0.0, values)
    found = rows(*feedforward, start, values)
    # times of 1e6 s are known to 1e-10 s
    assert found == pytest.approx(expected, abs=1e-9 + 1e-14 * abs(start))
    assert expected[0, -2:].tolist() == [1, 0] and expected[-1, -2:].tolist() == [2, 1]
    assert np.ptp(expected[:, 0]) > 0.9


def test_a_start_time_that_is_set_is_that_of_the_clock(feedforward) -> None:
    usual = rows(*feedforward, 0.0)
    delay = 8
    late = rows(*feedforward, 100.0, {"planner.start_time": 100.0 + delay * STEP})
    assert late[delay:, :-3] == pytest.approx(usual[:-delay, :-3], abs=1e-9)
    assert late[:delay, -2:].tolist() == [[1, 0]] * delay and np.ptp(late[:delay, 0]) == 0.0
    # as before: zero is a time like any other, and what is past is past
    early = rows(*feedforward, -2.0, {"planner.start_time": 0.0})
    assert early[delay:, :-3] == pytest.approx(usual[:-delay, :-3], abs=1e-9)
    under_way = rows(*feedforward, 0.0, {"planner.start_time": -delay * STEP})
    assert under_way[:-delay, :-3] == pytest.approx(usual[delay:, :-3], abs=1e-9)
    over = rows(*feedforward, 100.0, {"planner.start_time": 0.0})
    assert over[:, -1].tolist() == [1.0] * ROWS


def test_from_zero_it_is_the_start_time_zero_bit_for_bit(feedforward) -> None:
    assert np.array_equal(
        rows(*feedforward, 0.0), rows(*feedforward, 0.0, {"planner.start_time": 0.0})
    )


@pytest.mark.parametrize("fmi", (2, 3))
def test_times_before_any_simulation_are_refused(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][0]) as fmu:
        fmu.set({"planner.start_time": -2e9})
        fmu.begin()
        with pytest.raises(Exception, match="ExitInitialization"):
            fmu.fmu.exitInitializationMode()
        assert "planner.start_time must be at least -1e+09, got -2000000000" in fmu.messages[-1]


@pytest.mark.parametrize("fmi", (2, 3))
def test_a_reset_forgets_the_start(native_fmus, fmi: int) -> None:
    path = native_fmus[fmi][0]
    with Importer(path) as fmu:
        fmu.initialise(100.0)
        fmu.step(100.0, 1.0)
        first = fmu.get(*OUTPUTS)
        fmu.fmu.reset()
        fmu.initialise(3.0)
        fmu.step(3.0, 1.0)
        assert fmu.get(*OUTPUTS) == pytest.approx(first, abs=1e-9)


@pytest.mark.parametrize("fmi", (2, 3))
def test_a_saved_state_has_its_start(native_fmus, fmi: int) -> None:
    """An instance that was started at another time goes on as the one that was saved."""
    path = native_fmus[fmi][0]
    name = "FMUState" if fmi == 3 else "FMUstate"
    with Importer(path) as one, Importer(path) as other:
        one.initialise(100.0)
        one.step(100.0, 1.0)
        state = getattr(one.fmu, f"get{name}")()
        data = getattr(one.fmu, "serializeFMUState" if fmi == 3 else "serializeFMUstate")(state)
        one.step(101.0, 1.0)
        expected = one.get(*OUTPUTS)
        other.initialise(0.0)
        restore = "deserializeFMUState" if fmi == 3 else "deSerializeFMUstate"
        copy = getattr(other.fmu, restore)(data)
        getattr(other.fmu, f"set{name}")(copy)
        other.step(101.0, 1.0)
        assert np.array_equal(other.get(*OUTPUTS), expected)


@pytest.mark.parametrize("interface", ("CoSimulation", "ModelExchange"))
@pytest.mark.parametrize("fmi", (2, 3))
def test_fmpy_starts_late(native_fmus, fmi: int, interface: str) -> None:
    def run(start: float) -> np.ndarray:
        return fmpy.simulate_fmu(
            str(native_fmus[fmi][0]), start_time=start, stop_time=start + 5.0, output_interval=0.05,
            fmi_type=interface, output=["reference.load.position.x"], record_events=False,
        )

    usual, late = run(0.0), run(100.0)
    assert late["time"] - 100.0 == pytest.approx(usual["time"], abs=1e-9)
    found, expected = (r["reference.load.position.x"] for r in (late, usual))
    assert found == pytest.approx(expected, abs=1e-9)
    assert expected[0] == 0.0 and expected[-1] == pytest.approx(1.0)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def test_both_fmus_start_late(native_fmus, fmus, kind) -> None:
    archives = native_fmus[kind[1]] if kind[0] == "native" else fmus
    usual = simulate(*archives, stop_time=5.0, step=0.01)
    late = simulate(*archives, start_time=100.0, stop_time=105.0, step=0.01)
    for axis in "xyz":
        name = f"load.position.{axis}"
        assert late[name] == pytest.approx(usual[name], abs=1e-6), name
    assert late["error.load.norm"].max() < 2.0 * usual["error.load.norm"].max() + 1e-6


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: f"{kind[0]} {kind[1]}")
def test_a_gust_blows_from_the_start_on(native_fmus, fmus, kind) -> None:
    path = (native_fmus[kind[1]] if kind[0] == "native" else fmus)[1]
    gust = {"wind.gust.duration": 1.0, "wind.gust.force.x": 0.5, "feedback.enabled": False}

    def moved(start: float, values: dict[str, float]) -> np.ndarray:
        with Importer(path) as fmu:
            fmu.set(gust | values)
            fmu.begin(start)
            fmu.set({"force.hoist": -9.81})
            fmu.fmu.exitInitializationMode()
            found = []
            for i in range(30):
                fmu.step(start + 0.1 * i, 0.1)
                found.append(fmu.get("load.position.x")[0])
        return np.array(found)

    usual = moved(0.0, {})
    assert np.array_equal(usual, moved(0.0, {"wind.gust.start": 0.0}))
    assert np.abs(usual).max() > 0.05
    assert moved(100.0, {}) == pytest.approx(usual, abs=1e-8)
    assert np.ptp(moved(100.0, {"wind.gust.start": 0.0})) < 1e-9
    assert moved(100.0, {"wind.gust.start": 101.0})[10:] == pytest.approx(usual[:20], abs=1e-8)
