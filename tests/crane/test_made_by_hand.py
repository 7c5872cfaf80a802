"""Objects of the crane that are made by hand, and methods: what is of another kind is one error."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from segfmu import ActuatorBounds, Crane, Limits, Waypoint, plan
from segfmu import crane as cranes
from segfmu.crane import hook
from segfmu.errors import InputError

CRANE = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
HOOK = hook.HookCrane(crane=CRANE, hook_mass=0.3, sling=0.2)
ENDS: dict[str, Any] = {"sample_time": 0.01, "shortest": 0.5, "longest": 0.9, "rows": 2}
GAINS = cranes.design_lqr(CRANE, **ENDS)
OBSERVER = cranes.design_observer(CRANE, **ENDS)
LOAD = hook.design_hook(HOOK, **ENDS)
STATE = [0.0, 0.0, 0.5, *[0.0] * 7]
OTHERS: dict[str, Any] = {
    "class": list, "text": "one", "texts": ["a"], "nested": [1.0, [2.0]], "object": object(),
    "function": lambda: 0, "nothing": [None], "complex": 1j, "masked": np.ma.array([1.0], mask=[1]),
    "nan": float("nan"), "huge": 10**400,
}
# classes and functions, and arguments that are right
MADE: dict[str, tuple[Callable[..., Any], dict[str, Any]]] = {
    "SwayFeedback": (cranes.SwayFeedback, {
        "sample_time": 0.01, "lengths": GAINS.lengths, "gains": GAINS.gains, "payload": 1.0,
    }),
    "PayloadSchedule": (cranes.PayloadSchedule, {"payloads": [1.0, 2.0], "tables": [GAINS, GAINS]}),
    "Observer": (cranes.Observer, {
        name: getattr(OBSERVER, name) for name in OBSERVER.__dataclass_fields__
    }),
    "HookFeedback": (hook.HookFeedback, {"sample_time": 0.01, "table": LOAD.table}),
    "HookController": (hook.HookController, {
        "feedback": LOAD, "lower": -1.0, "upper": [1.0, 1.0, 1.0], "velocity_min": -1.0,
        "velocity_max": 1.0,
    }),
    "Shaped": (cranes.Shaped, {
        "motion": cranes.Trapezoid(1.0, 1.0, 1.0), "shaper": cranes.zv(3.0),
    }),
    "Plant": (cranes.Plant, {
        "crane": CRANE, "state": STATE, "setpoints": cranes.Setpoints(), "controller": GAINS,
        "driven": False, "enabled": True, "start_time": 0.0,
    }),
    "parameters": (cranes.Rig().parameters, {"crane": CRANE, "driven": False}),
    "bound_uses": (cranes.bound_uses, {
        "crane": CRANE, "bounds": ActuatorBounds(),
        "trajectory": plan([Waypoint([0, 0, -1]), Waypoint([1, 0, -1])], Limits(1.0, 1.0, 9.0)),
    }),
    "lqr": (cranes.design_lqr, {"crane": CRANE, "driven": False, **ENDS}),
    "schedule": (cranes.design_schedule, {
        "crane": CRANE, "payloads": [1.0], "driven": True,
        **{name: value for name, value in ENDS.items() if name != "rows"},
    }),
    "observer": (cranes.design_observer, {
        "crane": CRANE, "driven": False, "delayed": True, "dead_time": [0.0, 0.0, 0.0], **ENDS,
    }),
    "TrackingController": (cranes.TrackingController, {
        "observer": OBSERVER, "feedback": GAINS, "rope_offset": False, "enabled": True,
        "offset_cause": "wind",
    }),
    "tick": (cranes.TrackingController(OBSERVER, GAINS).sample, {
        "time": 0.0, "measured": STATE[:5], "reference": STATE, "feedforward": [0.0, 0.0, 0.0],
    }),
    "hook's tick": (hook.HookController(LOAD).sample, {
        "time": 0.0, "measured": STATE[:5], "reference": STATE, "feedforward": [0.0, 0.0, 0.0],
    }),
    "residual": (cranes.zv(3.0).residual, {"frequency": 3.0, "damping": 0.1}),
    "then": (cranes.zv(3.0).then, {"other": cranes.zv(2.0)}),
    "trapezoid": (cranes.Trapezoid(1.0, 1.0, 1.0), {"t": 0.5, "derivative": 1}),
    "at": (cranes.PayloadSchedule([1.0], [GAINS]).at, {"payload": 1.0}),
    "step": (cranes.Plant(CRANE, np.array(STATE), cranes.Setpoints(), GAINS).step, {
        "duration": 0.01, "setpoints": cranes.Setpoints(),
    }),
    "follow": (cranes.Plant(CRANE, np.array(STATE), cranes.Setpoints(), GAINS).follow, {
        "durations": [0.01], "setpoints": [cranes.Setpoints().vector], "most": 1e6,
    }),
    "outputs": (cranes.Plant(CRANE, np.array(STATE), cranes.Setpoints(), GAINS).outputs, {
        "target": [0.0, 0.0, 0.0],
    }),
    "of": (cranes.Setpoints.of, {"vector": np.zeros(19)}),
    "bound": (Limits([1.0, 1.0], 2.0, velocity_min=[-0.5, -1.0]).bound, {
        "name": "velocity", "axis": 0, "value": -1.0,
    }),
    "named": (Limits(1.0, 2.0, [3.0, 3.0]).named, {"name": "jerk", "axis": 1, "value": 1.0}),
}
# "time" is for controllers that need it
UNUSED = {("tick", "time"), ("hook's tick", "time")}
KINDS = [(own, name) for own, (_, given) in MADE.items() for name in given]


@pytest.mark.parametrize("own", MADE)
def test_what_is_right_is_taken(own: str) -> None:
    call, given = MADE[own]
    call(**given)


@pytest.mark.parametrize(("own", "name"), [k for k in KINDS if k not in UNUSED])
def test_what_is_of_another_kind_is_one_error(own: str, name: str) -> None:
    call, given = MADE[own]
    for what, other in OTHERS.items():
        # steps that are not finite are tested with the plant
        if (own, name, what) == ("step", "duration", "nan"):
            continue
        with pytest.raises(InputError) as caught:
            call(**given | {name: other})
        told = str(caught.value)
        assert "\n" not in told and len(told) < 250, what


@pytest.mark.parametrize(("changed", "told"), [
    ({"lengths": [0.9, 0.5]}, "lengths must be positive and ascending"),
    ({"lengths": [0.0, 0.5]}, "lengths must be positive and ascending"),
    ({"gains": np.zeros((2, 3, 9))}, "gains must be by 10 or 11 errors, got 9"),
    ({"gains": np.zeros((3, 3, 11))}, r"gains must have shape \(2, 3, any\), got \(3, 3, 11\)"),
    ({"payload": 0.0}, "payload must be a finite number > 0"),
    ({"sample_time": -1.0}, "sample_time must be a finite number > 0"),
])
def test_a_table_of_gains_is_one(changed: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError, match=told):
        cranes.SwayFeedback(**MADE["SwayFeedback"][1] | changed)


def test_lists_make_a_table_of_gains() -> None:
    made = cranes.SwayFeedback(0.01, GAINS.lengths.tolist(), GAINS.gains.tolist(), 1.0)
    np.testing.assert_array_equal(made.table, GAINS.table)


def test_tables_of_a_schedule_fit_each_other() -> None:
    other = cranes.design_lqr(CRANE, **ENDS | {"sample_time": 0.02})
    for tables in ([GAINS], [GAINS, other], []):
        with pytest.raises(InputError, match="tables must be one for each of 2 payloads"):
            cranes.PayloadSchedule([1.0, 2.0], tables)


def test_empty_lists_are_no_weights() -> None:
    designs: dict[str, Callable[..., Any]] = {
        "weights": cranes.design_lqr, "uncertainty": cranes.design_observer,
    }
    for name, call in designs.items():
        with pytest.raises(InputError, match=f"{name} must be of class"):
            call(CRANE, **ENDS, **{name: []})
    with pytest.raises(InputError, match="weights must be of class"):
        hook.design_hook(HOOK, **ENDS, weights={})  # type: ignore[arg-type]


def test_a_limit_is_of_an_axis_that_there_is() -> None:
    limits = Limits([1.0, 2.0], 3.0, velocity_min=[-0.5, -2.0])
    assert limits.named("velocity", 0, -1.0) == "velocity_min"
    assert limits.bound("velocity", 0, -1.0) == 0.5
    assert limits.named("velocity", 1, -1.0) == "velocity"
    assert limits.bound("acceleration", 7, 1.0) == 3.0
    with pytest.raises(InputError, match="axis must be from 0 to 1, got 2"):
        limits.bound("velocity", 2, 1.0)
    with pytest.raises(InputError, match="name must be one of velocity, acceleration, jerk"):
        limits.named("velocity_min", 0, 1.0)


def test_numbers_too_large_for_a_loop_are_told() -> None:
    controller = cranes.TrackingController(OBSERVER, GAINS)
    with pytest.raises(InputError, match=r"no finite numbers at 0\.7 m of rope with 1e\+300 kg"):
        cranes.largest_eigenvalue(controller, 0.7, 1e300)
