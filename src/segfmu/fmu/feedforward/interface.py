"""Interface of planner and flat inverse, whatever the load hangs on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from segfmu.fmu.gantry import SETPOINTS
from segfmu.fmu.standard.spec import (
    Array,
    Enumeration,
    Spec,
    Variable,
    beginning,
    calculated,
    choice,
    output,
    parameter,
    time,
    triple,
    triple_parameter,
)
from segfmu.kernels.clearance.records import SpaceLimits
from segfmu.kernels.crane.records import AXES, DRIVES, BoundUses
from segfmu.kernels.limits.records import PlanLimits
from segfmu.kernels.numerics.numbers import FARTHEST_PLACE

# waypoints: largest number in a plan, and default of an FMU
MOST_WAYPOINTS = 256
WAYPOINTS = 16

SHAPES = Enumeration("Shape", ("smoothstep", "plateau"), "shape of the acceleration ramps")
SYNCHRONIZATIONS = Enumeration(
    "Synchronization", ("none", "waypoints", "total"), "where the axes meet in time"
)

# The paper's mission (24) at constant height.
POINTS = (
    ((0.0, 0.0, -0.5), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
    ((0.07, 0.055, -0.5), (0.2, 0.17, 0.0), (0.34, 0.27, 0.0)),
    ((1.0, 0.8, -0.5), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
)
LIMITS = {
    "x": (1.0, 1.0, 1.0, 10.0),
    "y": (0.4, 0.5, 0.5, 5.0),
    "z": (0.3, 0.5, 0.5, 5.0),
}
# of the load at a waypoint; positions are as near as targets of commands
STATES = (
    ("position", "m", FARTHEST_PLACE), ("velocity", "m/s", None), ("acceleration", "m/s2", None),
)
# an end of the workspace, or an end stop [m], that is none
FAR = 1e9
# what of the load has limits
LIMIT_UNITS = {"velocity": "m/s", "acceleration": "m/s2", "jerk": "m/s3", "snap": "m/s4"}
# what a drive may have a bound of
DRIVE_BOUNDS = {"force": "N", "velocity": "m/s", "acceleration": "m/s2", "power": "W"}


def outputs(smoothness: int, angles: Mapping[str, str]) -> list[Variable]:
    """Setpoints, reference and events, where the forces are continuous from a smoothness on.

    angles: names of what hangs at two angles, and their symbols.
    """
    force = "feedforward force setpoint"
    rows = [
        output("force.bridge", "N", f"{force} of the bridge drive"),
        output("force.trolley", "N", f"{force} of the trolley drive"),
        output("force.hoist", "N", f"{force} of the winch; negative is rope tension"),
        output("velocity.bridge", "m/s", "velocity setpoint of the bridge drive"),
        output("velocity.trolley", "m/s", "velocity setpoint of the trolley drive"),
        output("velocity.hoist", "m/s", "rope velocity setpoint; positive pays rope out"),
    ]
    for name, unit in (
        ("position", "m"), ("velocity", "m/s"), ("acceleration", "m/s2"),
        ("jerk", "m/s3"), ("snap", "m/s4"),
    ):
        rows += triple(f"reference.load.{name}", unit, f"planned {name} of the load")
    for part, quantity in (("bridge", "position"), ("trolley", "position"), ("rope", "length")):
        for name, unit in ((quantity, "m"), ("velocity", "m/s"), ("acceleration", "m/s2")):
            rows.append(output(f"reference.{part}.{name}", unit, f"planned {part} {name}"))
    for part, symbol in angles.items():
        for axis in "xy":
            name = f"reference.{part}.{axis}"
            rows.append(output(f"{name}.angle", "rad", f"planned {part} angle {symbol}_{axis}"))
            rows.append(output(f"{name}.rate", "rad/s", f"planned rate of {symbol}_{axis}"))
    rows.append(output("plan.interval", None, "active waypoint interval, from 1", kind="Integer"))
    rows.append(output("plan.done", None, "the planned motion has ended", kind="Boolean"))
    rows.append(
        Variable(
            "plan.next_event", "Real", "output", "discrete",
            "time of the next event: arrival at a waypoint, end of the motion, or jump of a "
            f"derivative of the forces (the first at smoothness {smoothness}), and while friction "
            "changes its sign; behind the last, its time",
            unit="s",
        )
    )
    return rows


def limits() -> list[Variable]:
    """Limits of the load, those of the plan included."""
    rows = []
    for axis, values in LIMITS.items():
        for (name, unit), value in zip(LIMIT_UNITS.items(), values, strict=True):
            own = name in ("velocity", "acceleration")
            free = "; 0: none, if they are found" if own else "; 0: no limit"
            rows.append(
                parameter(
                    f"limits.{axis}.{name}", value, unit,
                    f"limit of the load's {name} in {axis}{free}", minimum=0.0,
                )
            )
        for name, unit in (("velocity", "m/s"), ("acceleration", "m/s2")):
            rows.append(
                parameter(
                    f"limits.{axis}.{name}_min", 0.0, unit,
                    f"limit of the load's {name} in the negative direction of {axis}, below 0; "
                    "0: as in the positive one", maximum=0.0,
                )
            )
    for name in (n for field in PlanLimits.FIELDS.values() for n in field.variables):
        _, _, axis, quantity = name.split(".")
        unit = LIMIT_UNITS[quantity.removesuffix("_min")]
        rows.append(calculated(name, unit, f"limit of the plan: {quantity} in {axis}; 0: none"))
    return rows


def waypoints(count: int) -> list[Variable]:
    """Waypoints, with room for so many."""
    rows = [
        parameter(
            "waypoint.count", len(POINTS), None, "number of waypoints in use", kind="Integer",
            minimum=2, maximum=count,
        )
    ]
    for i in range(1, count + 1):
        point = POINTS[min(i, len(POINTS)) - 1]
        for (name, unit, most), values in zip(STATES, point, strict=True):
            for axis, value in zip("xyz", values, strict=True):
                rows.append(
                    parameter(
                        f"waypoint[{i}].{name}.{axis}", value, unit,
                        f"{name} of the load at waypoint {i} in {axis}",
                        minimum=None if most is None else -most, maximum=most,
                    )
                )
        for name in ("velocity", "acceleration"):
            rows += [
                parameter(
                    f"waypoint[{i}].{name}_free.{a}", False, None, f"{name} at waypoint {i} in {a} "
                    "is chosen for the shortest plan, not given", kind="Boolean",
                )
                for a in "xyz"
            ]
        rows.append(
            parameter(f"waypoint[{i}].dwell", 0.0, "s", f"rest at waypoint {i}", minimum=0.0)
        )
    return rows


def planner(smoothness: int, least: int, meaning: str, shape: str) -> list[Variable]:
    """Parameters of the plan; smoothness by default, at least, what it means, and usual shape."""
    return [
        parameter(
            "planner.smoothness", smoothness, None, meaning, kind="Integer", minimum=least,
            maximum=6,
        ),
        choice("planner.shape", SHAPES, shape, "shape of the acceleration ramps"),
        choice("planner.synchronization", SYNCHRONIZATIONS, "waypoints", "where the axes meet"),
        parameter(
            "planner.sample_time", 0.0, "s",
            "waypoint intervals and dwells become multiples of it; 0: any duration", minimum=0.0,
        ),
        parameter(
            "planner.duration", 0.0, "s", "duration to take; 0: the shortest one", minimum=0.0
        ),
        parameter(
            "planner.finds_limits", False, None, "where the plan with the limits of the load "
            "exceeds bounds of the drives, limits up to these are found with which the motion is "
            "short and keeps the bounds; false: it is refused, or slows down", kind="Boolean",
        ),
        parameter(
            "planner.slows_down", False, None, "where the plan exceeds bounds of the drives, the "
            "whole motion becomes as slow as they need, waypoint velocities included; false: it is "
            "refused", kind="Boolean",
        ),
        beginning("planner.start_time", "time at which the motion starts"),
        parameter(
            "setpoint.lead", 0.0, "s",
            "all outputs are those of so much later, from the end of initialisation on: the "
            "communication step of importers that couple in parallel", minimum=0.0,
        ),
    ]


def drives() -> list[Variable]:
    """What is known of the drives, for which setpoints are compensated."""
    rows = []
    for drive in DRIVES:
        rows += [
            parameter(
                f"drive.{drive}.lag", 0.0, "s", f"time constant of the {drive} drive, for which "
                "its velocity setpoint is compensated; 0: none", minimum=0.0,
            ),
            parameter(
                f"drive.{drive}.dead_time", 0.0, "s", f"time by which the {drive} drive acts late, "
                "for which its setpoints are early; the load starts the longest of them late",
                minimum=0.0,
            ),
        ]
    return rows


def bounds() -> list[Variable]:
    """Bounds of the drives and of the sway, end stops, and what the plan uses of them."""
    kept = "the plan keeps it, or initialisation fails"
    rows = []
    for drive in DRIVES:
        for name, unit in DRIVE_BOUNDS.items():
            rows.append(
                parameter(
                    f"drive.{drive}.{name}_max", 0.0, unit,
                    f"largest {name} of the {drive} drive; {kept}; 0: no bound", minimum=0.0,
                )
            )
            if name != "power":
                rows.append(
                    parameter(
                        f"drive.{drive}.{name}_min", 0.0, unit, f"least {name} of the {drive} "
                        "drive, below 0; 0: minus the largest one", maximum=0.0,
                    )
                )
    for axis in "xy":
        rows.append(
            parameter(
                f"sway.{axis}.angle_max", 0.0, "rad",
                f"largest sway angle phi_{axis}; {kept}; 0: no bound", minimum=0.0,
            )
        )
    for axis in AXES:
        place = "length of the rope" if axis == "rope" else f"position of the {axis}"
        rows += [
            parameter(f"travel.{axis}.min", -FAR, "m", f"least {place}; {kept}"),
            parameter(f"travel.{axis}.max", FAR, "m", f"greatest {place}; {kept}"),
        ]
    for name, when in zip(BoundUses.FIELDS["USE"].variables, BoundUses.FIELDS["TIME"].variables,
                          strict=True):
        bounded = name.removeprefix("plan.use.").replace(".", " ")
        rows.append(
            calculated(name, None, f"largest use of the bound of {bounded}; 1: all; 0: no bound")
        )
        rows.append(calculated(when, "s", "when it is reached, since the start of the plan"))
    return rows


def space() -> list[Variable]:
    """Workspace and obstacles."""
    rows = []
    for axis in "xyz":
        rows += [
            parameter(f"workspace.{axis}.min", -FAR, "m", f"least position of the load in {axis}"),
            parameter(f"workspace.{axis}.max", FAR, "m", f"greatest one in {axis}"),
        ]
    rows += triple_parameter(
        "load.size", 0.0, "m", "edge of the load's box, 0 for a point", minimum=0.0
    )
    rows += triple_parameter(
        "load.centre", 0.0, "m", "centre of the load's box from its position, the rope's end"
    )
    rows.append(
        parameter(
            "obstacle.count", 0, None, "number of obstacles in use", kind="Integer", minimum=0,
            maximum=SpaceLimits.OBSTACLES,
        )
    )
    for i in range(1, SpaceLimits.OBSTACLES + 1):
        name = f"obstacle[{i}]"
        for corner, start in (("minimum", 0.0), ("maximum", 1.0)):
            rows += triple_parameter(
                f"{name}.{corner}", start, "m", f"{corner} corner of obstacle {i}"
            )
        rows += [
            parameter(
                f"{name}.margin", 0.0, "m", f"distance that load and rope keep from obstacle {i} "
                "along each axis", minimum=0.0,
            ),
            parameter(
                f"{name}.rope", True, None, f"the rope keeps off obstacle {i} as well",
                kind="Boolean",
            ),
        ]
    return rows


def arrays(most: int) -> tuple[Array, ...]:
    """States, what of them is free, and dwells of so many waypoints, as arrays."""
    rows = range(1, most + 1)
    texts = {
        n: f"{n} of the load at the waypoints" for n in ("position", "velocity", "acceleration")
    }
    texts |= {
        f"{n}_free": f"{n} at the waypoints that is chosen for the shortest plan, not given"
        for n in ("velocity", "acceleration")
    }
    vectors = [
        Array(
            f"waypoint.{name}", tuple(f"waypoint[{i}].{name}.{a}" for i in rows for a in "xyz"),
            "waypoint.count", 3, text,
        )
        for name, text in texts.items()
    ]
    dwells = tuple(f"waypoint[{i}].dwell" for i in rows)
    return (
        *vectors, Array("waypoint.dwell", dwells, "waypoint.count", 1, "rest at the waypoints")
    )


def _obstacles() -> list[Array]:
    """Corners and margins of obstacles, and whether the rope keeps off them."""
    rows, count = range(1, SpaceLimits.OBSTACLES + 1), "obstacle.count"
    corners = [
        Array(
            f"obstacle.{corner}", tuple(f"obstacle[{i}].{corner}.{a}" for i in rows for a in "xyz"),
            count, 3, f"{corner} corners of the obstacles", fixed=True,
        )
        for corner in ("minimum", "maximum")
    ]
    texts = {
        "margin": "distances that load and rope keep from the obstacles along each axis",
        "rope": "whether the rope keeps off the obstacles as well",
    }
    return corners + [
        Array(
            f"obstacle.{name}", tuple(f"obstacle[{i}].{name}" for i in rows), count, 1, text,
            fixed=True,
        )
        for name, text in texts.items()
    ]


def nativized(own: Spec) -> Spec:
    """The interface of a native FMU, which also names time."""
    names = own.where("output")
    return replace(
        own,
        variables=(*own.variables, time()),
        arrays=(
            *arrays(sum(v.name.endswith("].dwell") for v in own.variables)), *_obstacles()
        ),
        dependencies=tuple((v.name, ("time",)) for v in names),
        orders=3,
        terminals=(SETPOINTS,),
    )
