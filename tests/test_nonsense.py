"""Every argument of the public face with values of every kind: one InputError, or a result."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from functools import cache, partial
from inspect import signature
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import segfmu
from segfmu.crane import Rig
from segfmu.crane.disturbance import Wind
from tests.validation.report.test_report import campaign

MISSION = Path(__file__).parents[1] / "models" / "inteco.toml"
class Table:
    """As those of other packages: with axes, and of many lines."""

    axes = (range(3), range(2))

    def __repr__(self) -> str:
        return "\n".join(f"{i}  {i}.0" for i in range(100))


NONSENSE = (
    "x", "", "\0", None, [], {}, 10**400, -(10**400), float("nan"), float("inf"), -1, 0, True, 1j,
    b"1", [1, 2], [1, 2, 3], [1, "a"], [None, None, None], [[1]], [[1, [2]]], np.array(3.0),
    np.array([]),
    np.array(["a"]), np.ma.array([1.0, 2.0, 3.0], mask=[1, 0, 0]), np.datetime64("now"), object(),
    Decimal(1), Fraction(1, 2), Path(), range(3), {1, 2}, len, segfmu.Waypoint, Table(),
)
POINTS = [segfmu.Waypoint([0.0, 0.0, -1.0]), segfmu.Waypoint([1.0, 1.0, -1.0])]
LIMITS = segfmu.Limits(1.0, 1.0, 2.0, 20.0)
PLAN = segfmu.plan(POINTS, LIMITS)
CRANE = segfmu.Crane(2.0, 1.0, 1.0)
OPERATOR = segfmu.Operator(CRANE, LIMITS, [0.0, 0.0, -0.5])
BOUNDS = segfmu.ActuatorBounds(force=[20.0, 20.0, 30.0])

RESULT = campaign(20)


@cache
def finished() -> segfmu.Run:
    """A run whose methods are called."""
    return segfmu.simulate(MISSION, step=0.05)


def signal(name: Any) -> None:
    """A signal, and whether there is one."""
    assert (name in finished()) == (name in [*finished()] if isinstance(name, str) else False)
    finished()[name]


def picture(what: Any) -> None:
    finished().plot(what)


def report(path: Any) -> None:
    finished().report(path)


def table(path: Any) -> None:
    finished().to_csv(path)


CALLS: dict[str, tuple[Callable[..., Any], dict[str, Any]]] = {
    "Waypoint": (segfmu.Waypoint, {"position": [0.0, 0.0, 0.0]}),
    "Limits": (segfmu.Limits, {"velocity": 1.0, "acceleration": 1.0, "jerk": 2.0}),
    "plan": (segfmu.plan, {"waypoints": POINTS, "limits": LIMITS}),
    "state": (PLAN.state, {"t": 0.5}),
    "replan": (segfmu.replan, {"trajectory": PLAN, "time": 0.1, "targets": POINTS[1]}),
    "stop": (segfmu.stop, {"start": PLAN, "time": 0.1}),
    "reach_velocity": (
        segfmu.reach_velocity, {"start": PLAN, "velocity": [0.1, 0.1, 0.0], "time": 0.1}
    ),
    "verify": (segfmu.verify, {"trajectory": PLAN}),
    "excursions": (segfmu.excursions, {"trajectory": PLAN}),
    "Obstacle": (
        segfmu.Obstacle, {"name": "box", "minimum": [0.0, 0.0, 0.0], "maximum": [1.0, 1.0, 1.0]}
    ),
    "Clearance": (segfmu.Clearance, {}),
    "lower": (LIMITS.lower, {"axes": 3}),
    "limits_table": (LIMITS.table, {"axes": 3, "smoothness": 4}),
    **{f"{kind.__name__}.of": (kind.of, {"value": len}) for kind in (
        segfmu.Crane, segfmu.HookCrane, Rig, Wind,
    )},
    "Crane": (segfmu.Crane, {"bridge_mass": 2.0, "trolley_mass": 1.0, "payload_mass": 1.0}),
    "FlatInverse": (segfmu.FlatInverse, {"crane": CRANE, "trajectory": PLAN}),
    "ActuatorBounds": (segfmu.ActuatorBounds, {}),
    "plan_actuated": (
        segfmu.plan_actuated,
        {"crane": CRANE, "waypoints": POINTS, "limits": LIMITS, "bounds": BOUNDS},
    ),
    "Operator": (
        segfmu.Operator, {"crane": CRANE, "limits": LIMITS, "start": [0.0, 0.0, -0.5]}
    ),
    "command": (OPERATOR.command, {"mode": "stop"}),
    "step": (OPERATOR.step, {"duration": 0.01}),
    "simulate": (segfmu.simulate, {"mission": MISSION, "step": 0.05}),
    "signal": (signal, {"name": "time"}),
    "plot": (picture, {"what": "plan"}),
    "report": (report, {"path": "report.html"}),
    "to_csv": (table, {"path": "run.csv"}),
    "build": (segfmu.build, {"mission": MISSION, "output": "fmus"}),
    "load_mission": (segfmu.load_mission, {"source": MISSION}),
    "load_result": (segfmu.load_result, {"folder": "out"}),
    "column": (RESULT.column, {"name": "run"}),
    "worst": (RESULT.worst, {"criterion": "near its plan"}),
    "values": (RESULT.values, {"run": 0}),
    "command_of_run": (RESULT.command, {"run": RESULT.worst_runs[0]}),
    "against": (RESULT.against, {"other": RESULT}),
    "report_of_campaign": (RESULT.report, {"path": "report.html", "worst": None}),
    "validate": (segfmu.validate, {"scenarios": [MISSION]}),
}


def cases() -> list[Any]:
    """Each argument of each call."""
    return [
        pytest.param(partial(call, **{n: v for n, v in usual.items() if n != name}), name,
                     id=f"{which}-{name}")
        for which, (call, usual) in CALLS.items()
        for name in signature(call).parameters
        # a truth value is taken of anything
        if name not in ("progress", "modelica", "ssp", "references")
    ]


@pytest.mark.parametrize(("call", "name"), cases())
def test_nonsense_is_one_error(
    call: Callable[..., Any], name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for value in NONSENSE:
        try:
            call(**{name: value})
        except segfmu.SegfmuError as error:
            assert str(error) and "\n" not in str(error), value
            assert len(str(error)) < 400, value


@pytest.mark.parametrize("call", [
    partial(segfmu.plan, POINTS, LIMITS),
    partial(segfmu.plan_actuated, CRANE, POINTS, LIMITS, BOUNDS),
    segfmu.load_mission(MISSION).plan, partial(segfmu.build, MISSION),
    partial(segfmu.simulate, MISSION), partial(segfmu.validate, MISSION),
    partial(segfmu.campaign, MISSION), partial(segfmu.identify, "log.csv", MISSION),
    partial(segfmu.live, MISSION),
])
def test_progress_is_told_to_a_function(call: Callable[..., Any]) -> None:
    with pytest.raises(segfmu.InputError, match=r"^progress must be a function, got 'bar'$"):
        call(progress="bar")
