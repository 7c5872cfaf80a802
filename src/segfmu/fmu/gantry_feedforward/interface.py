"""Interface of GantryFeedforward: planner and flat inverse."""

from __future__ import annotations

from functools import cache

from segfmu.fmu.feedforward.interface import (
    FAR,
    LIMITS,
    MOST_WAYPOINTS,
    POINTS,
    SHAPES,
    SYNCHRONIZATIONS,
    WAYPOINTS,
    arrays,
    bounds,
    drives,
    limits,
    nativized,
    outputs,
    planner,
    space,
    waypoints,
)
from segfmu.fmu.gantry import crane_parameters, friction_parameters
from segfmu.fmu.standard.spec import (
    LARGEST,
    Enumeration,
    Spec,
    Variable,
    calculated,
    command,
    output,
    parameter,
    triple_parameter,
)
from segfmu.kernels.crane.records import DRIVES
from segfmu.kernels.numerics.numbers import FARTHEST_PLACE
from segfmu.kernels.operation.records import MEASURED, Tries

__all__ = [
    "FAR", "LIMITS", "MODES", "MOST_WAYPOINTS", "POINTS", "SHAPES", "SYNCHRONIZATIONS",
    "WAYPOINTS", "arrays", "native_spec", "spec",
]

MODES = Enumeration(
    "Mode", ("mission", "target", "velocity", "stop", "inching", "emergency"), "what the load does"
)


def _answers() -> list[Variable]:
    """What became of commands."""
    rows = []
    for name, meaning in (
        ("status", "what became of the last command"),
        ("refused", "what the last plan for a command that was not taken does not keep"),
    ):
        rows.append(
            output(
                f"plan.{name}", None, f"{meaning}; 0: taken, 1: reduced, 2: limits, 3: rope, 4: "
                "workspace, 5: obstacle, 6: drives, 7: pending, 8: travel", kind="Integer",
            )
        )
    for name, unit, meaning in (
        ("duration", "s", "time until the carriages stand"),
        ("sway", "rad", "largest angle between rope and vertical from then on"),
    ):
        rows.append(
            Variable(
                f"plan.emergency.{name}",
                "Real",
                "output",
                "discrete",
                f"what an emergency stop would come to, with command.foresees: {meaning}; -1: "
                "there is none",
                unit=unit,
            )
        )
    return rows


def _measured() -> list[Variable]:
    """The state of the crane that a motion can begin in."""
    rows = [
        command(
            "command.take_over",
            False,
            None,
            "begin in the measured state and bring the load to "
            "rest, or to the target; each time that it becomes true, and at the start",
            kind="Boolean",
        )
    ]
    units = {"position": "m", "length": "m", "angle": "rad", "velocity": "m/s", "rate": "rad/s"}
    for name in MEASURED:
        unit = units[name.rpartition(".")[2]]
        rows.append(
            command(
                f"measured.{name}",
                1.0 if name == "rope.length" else 0.0,
                unit,
                f"measured {name}, for command.take_over",
                minimum=-LARGEST,
                maximum=LARGEST,
            )
        )
    return rows


def _commands() -> list[Variable]:
    """What an operator commands, between steps."""
    rows = [
        parameter(
            "command.enabled", False, None, "commands can be followed; takes 2 MB, and drives "
            "without dead time", kind="Boolean",
        ),
        command(
            "command.mode", 1, None, "what the load does; mission: the plan that it has",
            kind="Enumeration", enumeration=MODES,
        ),
    ]
    rows += [
        command(
            f"command.velocity.{a}", 0.0, "m/s",
            f"velocity of the load; in the mode inching its sign is a push, {a}",
        )
        for a in "xyz"
    ]
    rows += [
        command(
            f"command.target.{a}", 0.0, "m", f"target of the load, {a}",
            minimum=-FARTHEST_PLACE, maximum=FARTHEST_PLACE,
        )
        for a in "xyz"
    ]
    rows += [
        command(
            "command.go", True, None, "in the mode target: go there; false: stop", kind="Boolean",
        ),
        command(
            "limits.scale", 1.0, None, "share of the velocity limits that commands are followed "
            "with; 0: stop", minimum=0.0, maximum=1.0,
        ),
        parameter(
            "command.hold", 0.1, "s", "how long a commanded velocity is held beyond a step, if "
            "nothing renews it", minimum=1e-3,
        ),
        parameter(
            "command.tries", Tries.USUAL, None, "plans that are tried in a step at most; the next "
            "one tries others", kind="Integer", minimum=1, maximum=Tries.MOST,
        ),
    ]
    rows.append(
        parameter(
            "command.foresees", False, None, "each step tells what an emergency stop would come "
            "to", kind="Boolean",
        )
    )
    for drive in DRIVES:
        rows += [
            command(
                f"command.tripped.{drive}", False, None, f"the {drive} drive has tripped: its "
                "brake stops it, the others stop as fast as they can; while it is true, no other "
                "command is followed", kind="Boolean",
            ),
            parameter(
                f"drive.{drive}.brake_deceleration", 0.0, "m/s2", f"deceleration of the brake of "
                f"the {drive} drive, when it trips; 0: the drive's greatest one", minimum=0.0,
            ),
        ]
    return rows + triple_parameter(
        "command.distance", 0.01, "m", "way of a push in the mode inching", minimum=0.0,
        maximum=FARTHEST_PLACE,
    )


@cache
def spec(most: int = WAYPOINTS) -> Spec:
    """The interface of GantryFeedforward, with room for so many waypoints; they come last."""
    return Spec(
        "GantryFeedforward",
        "Plans the motion of a crane's load through waypoints within limits on velocity, "
        "acceleration, jerk and snap, and inverts the crane exactly: force and velocity "
        "setpoints and the reference of load and state",
        (
            *outputs(4, {"sway": "phi"}),
            *_answers(),
            calculated("plan.duration", "s", "duration of the planned motion"),
            calculated("plan.pace", None, "pace of the motion; 1 unless it was slowed down"),
            *crane_parameters("nominal crane"),
            *limits(),
            *planner(4, 4, "n: the load's position is n times differentiable", "plateau"),
            *drives(),
            *bounds(),
            *space(),
            *_commands(),
            *_measured(),
            *friction_parameters(),
            *waypoints(most),
        ),
        stop_time=8.0,
        step_size=0.001,
    )


def native_spec(own: Spec | None = None) -> Spec:
    """The interface of the native GantryFeedforward, which also names time.

    It is that of `spec`, or of one with other start values.
    """
    return nativized(own or spec())
