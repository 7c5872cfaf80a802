"""Arguments of designs, controllers and maps that are of another kind are one clear error."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from segfmu import ActuatorBounds, Crane
from segfmu import crane as cranes
from segfmu.crane import hook
from segfmu.errors import InputError

CRANE = Crane(bridge_mass=2.2, trolley_mass=1.155, payload_mass=1.0)
ENDS = {"sample_time": 0.01, "shortest": 0.5, "longest": 0.9}
OTHERS: tuple[Any, ...] = (1.0, "one", [1.0, [2.0]], object())
# the same in each process
NAMES = ("number", "text", "nested list", "object")
DESIGNS = {
    "lqr": cranes.design_lqr, "flat": cranes.design_flat, "observer": cranes.design_observer,
    "hook": hook.design_hook,
}


@pytest.mark.parametrize("other", OTHERS, ids=NAMES)
@pytest.mark.parametrize("design", DESIGNS)
def test_a_design_takes_a_crane_between_two_lengths(design: str, other: Any) -> None:
    own: Any = CRANE
    if design == "hook":
        own = hook.HookCrane(crane=CRANE, hook_mass=0.3, sling=0.2)
    call: Callable[..., Any] = DESIGNS[design]
    with pytest.raises(InputError, match=r"crane must be of class (Hook)?Crane, got"):
        call(other, **ENDS)
    for name in ("shortest", "longest") if other != 1.0 else ():
        with pytest.raises(InputError, match="rope lengths must be "):
            call(own, **ENDS | {name: other})
    for rows in (0, 10**9, other):
        with pytest.raises(InputError, match="rows must be "):
            call(own, **ENDS, rows=rows)
    for name in ("weights",) if design in ("lqr", "hook") else ():
        with pytest.raises(InputError, match=rf"{name} must be of class \w+, got"):
            call(own, **ENDS, **{name: other})


@pytest.mark.parametrize("other", OTHERS, ids=NAMES)
def test_controllers_and_maps_take_what_was_designed(other: Any) -> None:
    observer = cranes.design_observer(CRANE, **ENDS)
    feedback = cranes.design_lqr(CRANE, **ENDS)
    for name, call in {
        "observer": lambda: cranes.TrackingController(other, feedback),
        "feedback": lambda: cranes.TrackingController(observer, other),
        "controller": lambda: cranes.largest_eigenvalue(other, 0.7, 1.0),
        "trajectory": lambda: cranes.bound_uses(CRANE, other, ActuatorBounds()),
    }.items():
        with pytest.raises(InputError, match=rf"{name} must be of class \w+, got"):
            call()
    with pytest.raises(InputError, match="feedback must be of class HookFeedback, got"):
        hook.HookController(other)
    controller = cranes.TrackingController(observer, feedback)
    for lengths, payloads in ((other, [1.0]), ([0.7], other)):
        with pytest.raises(InputError, match=r"must be (a sequence|a finite number)"):
            cranes.stability_map(controller, lengths, payloads)
    for shaper in (cranes.zv, cranes.zvd) if other != 1.0 else ():
        with pytest.raises(InputError, match="damping must be a finite number"):
            shaper(1.0, other)
