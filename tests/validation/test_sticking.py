"""What is said of static friction that leads force drives off a plan."""

from __future__ import annotations

from typing import Any

import pytest

from segfmu import Limits, Waypoint, load_mission, simulate
from segfmu.validation.files.mission import Mission
from segfmu.validation.sticking import sticking

LIMITS = Limits(0.5, 0.5, 1.0, 10.0)
ACROSS = [Waypoint([0.0, 0.0, -0.5]), Waypoint([1.0, 0.8, -0.4])]
# the hoist passes through rest
ON = [Waypoint([0.0, 0.0, -0.6]), Waypoint([0.5, 0.2, -0.5]), Waypoint([1.0, 0.4, -0.4])]
LEVEL = [Waypoint([0.0, 0.0, -0.5]), Waypoint([1.0, 0.4, -0.5])]


def mission(
    points: list[Waypoint], friction: dict[str, Any], limits: Limits = LIMITS
) -> Mission:
    crane = {
        "bridge_mass": 2.2, "trolley_mass": 1.155, "payload_mass": 1.0, "friction": friction,
    }
    return load_mission(
        {"crane": crane, "limits": limits, "waypoints": points, "simulation": {"feedback": False}}
    )


def still(static: float) -> dict[str, float]:
    return {"coulomb": 3.0, "static": static}


def test_an_axis_that_may_stick_as_it_moves_off_is_told() -> None:
    """A hoist of 1 kg that loses 1 N over 1 mm/s; bridge and trolley are heavier and faster."""
    both = {"bridge": still(4.0), "trolley": still(4.0)}
    task = mission(ACROSS, both)
    assert sticking(task, task.plan()) == ""
    task = mission(ACROSS, both | {"hoist": still(4.0)})
    told = sticking(task, task.plan())
    assert told.startswith("the hoist may stick where it moves off at 0.") and "\n" not in told
    driven = load_mission(task, {"crane": {"drive": "velocity"}})
    assert sticking(driven, task.plan()) == ""


def test_an_axis_that_passes_through_rest_slowly_is_told() -> None:
    """It has no contact that begins there, and was not looked at; both ways of the pass count."""
    task = mission(ON, {"hoist": still(3.1)})
    told = sticking(task, task.plan())
    assert told.startswith("the hoist may stick where it turns or passes through rest at 2.667 s")
    assert simulate(task).criteria.tracking_error > 1e-3
    task = mission(ON, {"hoist": still(3.04)})
    assert sticking(task, task.plan()) == ""
    assert simulate(task).criteria.tracking_error < 2e-4


@pytest.mark.parametrize("static", [3.002, 3.02, 3.05])
def test_a_stop_that_is_early_is_told_by_how_much(static: float) -> None:
    friction = {"trolley": still(static), "width": 5e-3}
    task = mission(LEVEL, friction, Limits(0.5, 0.1, 0.1, 1.0))
    told = sticking(task, task.plan())
    run = simulate(task)
    early = 0.4 - run.rows["trolley.position"][-1]
    assert (told != "") == (early > 0.5e-3)
    assert run.notes == ((told,) if told else ())
    if told:
        words = told.split()
        assert " ".join(words[:4]) == "the trolley may stop" and words[5:8] == ["mm", "early", "at"]
        assert float(words[4]) == pytest.approx(1e3 * early, rel=0.2)


@pytest.mark.parametrize("presliding", [1e-4, 1e-3])
def test_axes_that_spring_back_are_told(presliding: float) -> None:
    """What holds a contact deflected is let go at rest."""
    task = mission(ACROSS, {"hoist": {"coulomb": 3.0}, "presliding": presliding})
    run = simulate(task)
    told = [note for note in run.notes if "springs back by friction.presliding, 1 mm" in note]
    assert (len(told) == 1) == (run.criteria.tracking_error > 5e-4) == (presliding == 1e-3)
