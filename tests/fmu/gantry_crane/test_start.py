"""Where the crane starts: on its reference, as its start values say, or with a message."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from segfmu.cosim import simulate
from segfmu.errors import SimulationError
from segfmu.fmu.gantry_crane.interface import STATE
from tests.cosim.pair import SIGNALS
from tests.fmu.native.importer import Importer

MOVED: dict[str, Any] = {
    # for forces that are held over steps
    "planner.smoothness": 5,
    "waypoint.count": 2, "waypoint[1].position.x": 1.0, "waypoint[1].position.y": 0.4,
    "waypoint[1].position.z": -0.9, "waypoint[2].position.x": 1.5, "waypoint[2].position.z": -0.6,
    **{f"waypoint[2].{q}.{a}": 0.0 for q in ("velocity", "acceleration") for a in "xyz"},
}
PLACES = {"bridge.position": 1.0, "trolley.position": 0.4, "rope.length": 0.9}
BACKENDS = ("python", 2, 3)


def flat(values: dict[str, Any]) -> dict[str, Any]:
    """Waypoints as the arrays of FMI 3.0."""
    found = {n: v for n, v in values.items() if not n.startswith("waypoint[")}
    for quantity in ("position", "velocity", "acceleration"):
        found[f"waypoint.{quantity}"] = [
            [values.get(f"waypoint[{i}].{quantity}.{a}", 0.0) for a in "xyz"]
            for i in range(1, 17)
        ]
    return found


@pytest.fixture(params=BACKENDS)
def pair(request, fmus, native_fmus) -> tuple[Path, Path]:
    """Archives of both FMUs."""
    return fmus if request.param == "python" else native_fmus[request.param]


def moved(paths: tuple[Path, Path], by: float = 0.0) -> dict[str, Any]:
    """MOVED, with both waypoints farther along x [m]."""
    names = [f"waypoint[{i}].position.x" for i in (1, 2)]
    values = MOVED | {n: MOVED[n] + by for n in names}
    with Importer(paths[0]) as fmu:
        return flat(values) if fmu.three else values


def test_a_moved_first_waypoint_needs_no_second_change(pair) -> None:
    rows = simulate(*pair, stop_time=3.0, step=0.005, source_values=moved(pair))
    assert [rows[n][0] for n in PLACES] == pytest.approx(list(PLACES.values()), abs=1e-12)
    assert rows["error.load.norm"].max() < 1e-4


def test_models_that_move_both_stay_right(pair) -> None:
    for values in (PLACES, PLACES | {"start.on_reference": False}):
        rows = simulate(*pair, stop_time=0.05, step=0.01, source_values=moved(pair),
                        sink_values=values)
        assert [rows[n][0] for n in PLACES] == list(PLACES.values())


def test_start_values_are_deviations(pair) -> None:
    deviations = {"sway.x.angle": 0.05, "bridge.position": 0.02, "rope.length": 0.5 + 0.01}
    rows = simulate(*pair, stop_time=0.05, step=0.01, source_values=moved(pair),
                    sink_values=deviations)
    found = [rows[n][0] for n in ("sway.x.angle", "bridge.position", "rope.length")]
    assert found == pytest.approx([0.05, 1.02, 0.91], abs=1e-12)


def test_a_plan_in_motion_has_a_crane_in_motion(pair) -> None:
    values = {"planner.start_time": -1.0}
    rows = simulate(*pair, stop_time=2.0, step=0.001, source_values=values)
    assert abs(rows["bridge.velocity"][0]) > 0.1
    for name in STATE:
        assert rows[name][0] == pytest.approx(rows[f"reference.{name}"][0], abs=1e-12)
    assert rows["error.load.norm"].max() < 1e-5


def test_the_crane_alone_starts_as_its_start_values_say(pair) -> None:
    for values in ({}, {"rope.length": 0.7, "bridge.position": 0.3, "sway.y.rate": 0.1}):
        for inputs in ({}, {f"reference.{n}": 0.0 for n in STATE}):
            with Importer(pair[1]) as crane:
                crane.set(values | inputs | {"feedback.enabled": False})
                crane.initialise()
                expected = [values.get(n, 0.5 if n == "rope.length" else 0.0) for n in STATE]
                assert crane.get(*STATE).tolist() == expected
                assert crane.messages == []


def test_a_reference_that_comes_after_initialisation_counts(pair) -> None:
    """Some loops set inputs only between steps."""
    with Importer(pair[0]) as plan, Importer(pair[1]) as crane:
        plan.set(moved(pair))
        for fmu in (plan, crane):
            fmu.initialise()
        for i in range(400):
            plan.step(i * 0.005, 0.005)
            crane.write(tuple(SIGNALS), plan.get(*SIGNALS))
            crane.step(i * 0.005, 0.005)
            assert crane.get("error.load.norm")[0] < 1e-4


@pytest.mark.parametrize("fmi", (2, 3))
def test_initialisation_can_be_read_and_set_again_and_again(native_fmus, fmi: int) -> None:
    """Outputs that show the state are not taken for start values."""
    with Importer(native_fmus[fmi][1]) as crane:
        crane.set({"sway.x.angle": 0.05})
        crane.begin()
        for x in (1.0, 2.0, 0.0, 3.0):
            crane.set({"reference.bridge.position": x, "reference.sway.x.angle": 0.01 * x})
            found = crane.get("bridge.position", "sway.x.angle")
            assert found == pytest.approx([x, 0.05 + 0.01 * x], abs=1e-15)
        crane.set({"bridge.position": 0.25})
        assert crane.get("bridge.position")[0] == 3.25


@pytest.mark.parametrize("fmi", (2, 3))
def test_model_exchange_starts_on_its_reference(native_fmus, fmi: int) -> None:
    with Importer(native_fmus[fmi][1], "ModelExchange") as crane:
        crane.begin()
        crane.set({"reference.bridge.position": 1.0, "reference.rope.length": 0.8})
        crane.fmu.exitInitializationMode()
        assert crane.state()[[0, 2]].tolist() == [1.0, 0.8]


def test_a_start_that_does_not_fit_is_said(pair) -> None:
    words = "bridge.position started at 0, its reference at 9; set start.on_reference to true"
    with pytest.raises(SimulationError, match=words) as raised:
        simulate(*pair, stop_time=1.0, step=0.005, source_values=moved(pair, 8.0),
                 sink_values={"start.on_reference": False})
    assert "slack" not in str(raised.value)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"rope.length": -0.5}, "the start value of rope.length must be above 0 m, got -0.1; its "
         "reference starts at 0.9 m"),
        ({"sway.y.angle": 1.6}, "sway.y.angle must start within 90 degrees, got 1.6 rad"),
    ],
)
def test_a_start_that_cannot_be_is_refused(pair, values: dict[str, Any], words: str) -> None:
    with pytest.raises(SimulationError, match=words):
        simulate(*pair, stop_time=1.0, step=0.01, source_values=moved(pair), sink_values=values)


def test_a_rope_outside_its_range_is_said(native_fmus, caplog) -> None:
    simulate(*native_fmus[2], stop_time=0.02, step=0.01, sink_values={"crane.rope_max": 0.45})
    assert "rope.length starts at 0.5 m, outside crane.rope_min and crane.rope_max" in caplog.text
