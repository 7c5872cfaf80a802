"""The FMUs as an importer sees them, through fmpy's own simulation."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from fmpy import simulate_fmu

from segfmu import Crane, FlatInverse, Limits, Waypoint, plan
from segfmu.cosim.load import load
from segfmu.errors import SimulationError

LIMITS = Limits([1.0, 0.4, 0.3], [1.0, 0.5, 0.5], [1.0, 0.5, 0.5], [10.0, 5.0, 5.0])
POINTS = [
    Waypoint([0.0, 0.0, -0.5]),
    Waypoint([0.07, 0.055, -0.5], [0.2, 0.17, 0.0], [0.34, 0.27, 0.0]),
    Waypoint([1.0, 0.8, -0.5]),
]


def test_feedforward_is_the_plan_at_any_step(fmus: tuple[Path, Path]) -> None:
    trajectory = plan(POINTS, LIMITS)
    inverse = FlatInverse(Crane(2.2, 1.155, 1.0), trajectory)
    outputs = ["force.bridge", "force.hoist", "velocity.trolley", "reference.load.jerk.x"]
    for step in (0.05, 0.173):
        rows = simulate_fmu(
            str(fmus[0]), stop_time=3.46, step_size=step, output_interval=step, output=outputs
        )
        time = rows["time"]
        assert rows["force.bridge"] == pytest.approx(inverse.force(time)[:, 0], abs=1e-9)
        assert rows["force.hoist"] == pytest.approx(inverse.force(time)[:, 2], abs=1e-9)
        assert rows["velocity.trolley"] == pytest.approx(inverse.velocity(time)[:, 1], abs=1e-9)
        assert rows["reference.load.jerk.x"] == pytest.approx(trajectory(time, 3)[:, 0], abs=1e-9)


def test_plan_follows_the_parameters(fmus: tuple[Path, Path]) -> None:
    with load(fmus[0]) as unit:
        unit.set({"waypoint[3].position.x": 2.0, "crane.payload_mass": 3.0})
        unit.enter_initialization(0.0, 1.0)
        unit.exit_initialization()
        names = ["plan.duration", "force.hoist"]
        channel = unit.channel(names)
        channel.read()
        longer = plan([*POINTS[:2], Waypoint([2.0, 0.8, -0.5])], LIMITS)
        assert channel.values == pytest.approx([longer.duration, -3.0 * 9.81], rel=1e-12)


def test_outputs_are_there_in_initialisation_mode(fmus: tuple[Path, Path]) -> None:
    with load(fmus[0]) as unit:
        unit.enter_initialization(0.0, 1.0)
        channel = unit.channel(["reference.rope.length"])
        channel.read()
        assert channel.values[0] == pytest.approx(0.5)
        unit.exit_initialization()


@pytest.mark.parametrize(("name", "value"), [
    ("planner.shape", 0), ("limits.x.jerk", -5.0), ("waypoint.count", 100), ("waypoint.count", 0),
    ("planner.synchronization", 7),
])
def test_ranges_hold_in_initialisation_mode_too(
    fmus: tuple[Path, Path], name: str, value: float
) -> None:
    with load(fmus[0]) as unit:
        unit.set({name: value})
        unit.enter_initialization(0.0, 1.0)
        with pytest.raises(SimulationError, match=rf"{re.escape(name)} must be"):
            unit.channel(["reference.rope.length"]).read()


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"waypoint[2].velocity.y": 0.5}, "axis y, waypoint 2: velocity 0.5 m/s exceeds the limit"),
        (
            {"waypoint[2].velocity.x": 0.99, "limits.x.jerk": 0.1},
            "axis x, waypoints 2 -> 3: braking the first",
        ),
        ({"crane.rope_max": 0.3}, "rope_max"),
        ({"limits.x.velocity": 0.0}, "limits.velocity"),
        ({"waypoint[3].position.z": 0.4}, "trolley's height"),
        ({"waypoint[1].position.x": float("nan")}, "finite"),
        ({"waypoint.count": 17}, "waypoint.count"),
        ({"crane.payload_mass": -1.0}, "payload_mass"),
        ({"limits.y.acceleration_min": 0.5}, "y.acceleration_min must be at most 0, got 0.5"),
    ],
)
def test_bad_parameters_end_initialisation_with_the_reason(
    fmus: tuple[Path, Path], values: dict[str, float], words: str
) -> None:
    with load(fmus[0]) as unit:
        unit.set(values)
        unit.enter_initialization(0.0, 1.0)
        with pytest.raises(SimulationError, match="could not be initialised") as caught:
            unit.exit_initialization()
        assert words in str(caught.value)


def test_a_start_beyond_the_last_time_is_refused(fmus: tuple[Path, Path]) -> None:
    for path in fmus:
        with load(path) as unit:
            unit.enter_initialization(2e9, 3e9)
            with pytest.raises(SimulationError, match="the start time must be within"):
                unit.exit_initialization()


def test_a_least_bound_of_a_drive_is_not_above_zero(fmus: tuple[Path, Path]) -> None:
    with load(fmus[1]) as unit:
        unit.set({"drive.hoist.velocity_min": 0.5})
        unit.enter_initialization(0.0, 1.0)
        with pytest.raises(SimulationError, match="velocity_min must be at most 0"):
            unit.exit_initialization()


def test_crane_stays_at_rest_and_swings_when_pushed(fmus: tuple[Path, Path]) -> None:
    outputs = ["sway.x.angle", "load.position.z", "energy.kinetic", "energy.work"]
    settings = {
        "stop_time": 1.0, "step_size": 0.01, "output_interval": 0.01, "output": outputs,
    }
    start = {"feedback.enabled": False, "force.hoist": -9.81}
    still = simulate_fmu(str(fmus[1]), start_values=start, **settings)
    assert np.abs(still["sway.x.angle"]).max() < 1e-12
    assert still["load.position.z"] == pytest.approx(-0.5, abs=1e-12)
    pushed = simulate_fmu(str(fmus[1]), start_values={**start, "wind.x": 0.1}, **settings)
    assert pushed["sway.x.angle"].max() > 1e-3
    assert pushed["energy.work"].max() > 0.0


def test_crane_that_leaves_its_range_reports_it(fmus: tuple[Path, Path], caplog) -> None:
    with load(fmus[1]) as unit:
        unit.set({"feedback.enabled": False, "force.hoist": -100.0})
        unit.enter_initialization(0.0, 1.0)
        unit.exit_initialization()
        with pytest.raises(SimulationError, match=r"rope length reached zero"):
            for i in range(100):
                unit.step(0.01 * i, 0.01 * (i + 1))
        # it is somewhere within the step that failed
        unit.set({"force.hoist": -9.81})
        with pytest.raises(SimulationError):
            unit.step(0.01 * i, 0.01 * i + 0.001)
    assert caplog.messages[-1] == "GantryCrane: no step is possible after one that failed"


@pytest.mark.parametrize("which", [0, 1])
def test_steps_that_are_none_are_refused(fmus: tuple[Path, Path], which: int) -> None:
    for steps, words in (
        ([(0.0, 0.1), (0.1, 0.05)], "longer than 0 s"), ([(0.0, 0.0)], "longer than 0 s"),
        ([(0.0, 0.1), (0.7, 0.8)], r"the next step begins at 0\.1 s, not at 0\.7 s"),
        ([(0.0, float("nan"))], "got nan s"),
        ([(0.0, 1e300)], r"the step's end must be within 1e\+09 s of 0, got 1e\+300 s"),
        ([(0.0, 0.1), (0.1, 0.1 + 1e-15)], "at 0.1 s a step must be longer than 1.1e-14 s"),
    ):
        with load(fmus[which]) as unit:
            unit.set({"force.hoist": -9.81} if which else {})
            unit.enter_initialization(0.0, 1.0)
            unit.exit_initialization()
            for step in steps[:-1]:
                unit.step(*step)
            with pytest.raises(SimulationError, match=words):
                unit.step(*steps[-1])


@pytest.mark.parametrize("which", [0, 1])
def test_a_step_late_in_a_simulation_is_not_done_twice(
    fmus: tuple[Path, Path], which: int
) -> None:
    with load(fmus[which]) as unit:
        unit.set({"force.hoist": -9.81} if which else {})
        unit.enter_initialization(1e6, 2e6)
        unit.exit_initialization()
        unit.step(1e6, 1e6 + 1e-3)
        with pytest.raises(SimulationError, match=r"begins at 1000000\.001 s, not at 1000000 s"):
            unit.step(1e6, 1e6 + 1e-3)


@pytest.mark.parametrize(("which", "name", "late", "words"), [
    (0, "reference.load.position.x", False, "reference.load.position.x cannot be set at all"),
    (0, "crane.payload_mass", True, "crane.payload_mass cannot be set now"),
    (1, "rope.length", True, "rope.length cannot be set now"),
])
def test_a_variable_that_cannot_be_set_keeps_its_value_and_refuses_the_next_step(
    fmus: tuple[Path, Path], which: int, name: str, late: bool, words: str
) -> None:
    with load(fmus[which]) as unit:
        channel = unit.channel([name])
        if not late:
            unit.set({name: 2.0})
        unit.enter_initialization(0.0, 1.0)
        unit.exit_initialization()
        channel.read()
        before = channel.values[0]
        if late:
            unit.set({name: 2.0})
        channel.read()
        assert channel.values[0] == before != 2.0
        with pytest.raises(SimulationError, match=words):
            unit.step(0.0, 0.1)


def test_instances_can_follow_each_other(fmus: tuple[Path, Path]) -> None:
    for path in fmus:
        for _ in range(40):
            load(path).close()
    for _ in range(2):
        with load(fmus[0]) as a, load(fmus[0]) as b, load(fmus[1]) as c:
            for unit in (a, b, c):
                unit.enter_initialization(0.0, 1.0)
                unit.exit_initialization()
                unit.step(0.0, 0.01)
