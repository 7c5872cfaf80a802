"""A mission as a co-simulation: parameters of both FMUs, and the run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from math import inf, radians
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from segfmu.cosim import Change, simulate
from segfmu.cosim.change import require_changeable
from segfmu.cosim.domain import Domain
from segfmu.crane.bounds import ActuatorBounds
from segfmu.errors import InputError
from segfmu.fmu.feedforward.interface import FAR, WAYPOINTS
from segfmu.fmu.gantry_crane.pair import GANTRY
from segfmu.fmu.pair import ModelPair
from segfmu.fmu.standard.spec import Spec, Variable, started
from segfmu.kernels.clearance.records import SpaceLimits
from segfmu.kernels.crane.records import DriveBounds
from segfmu.planning import Trajectory
from segfmu.planning.clearance import Clearance
from segfmu.planning.limits import LOWER, Limits
from segfmu.validation.files import crane_parameters
from segfmu.validation.files.crane_models import model_of, table_of
from segfmu.validation.files.keys import AXES
from segfmu.validation.files.mission import Mission
from segfmu.validation.files.objects import LIMITS
from segfmu.validation.files.recording import COMMANDS, Recording

QUANTITIES = ("position", "velocity", "acceleration")
# of which these may be free
FREE = QUANTITIES[1:]
# parameters that the archive of a native FMU no longer has
AT_BUILD = "feedback.weight."
KINDS: dict[str, type] = {"Real": float, "Integer": int, "Enumeration": int, "Boolean": bool}


def sized(waypoints: int | None = None, models: ModelPair = GANTRY) -> tuple[Spec, Spec]:
    """Interfaces of both FMUs; the planner with room for so many waypoints, 16 by default."""
    return models.planner(waypoints or WAYPOINTS), models.plant()


def specs(
    mission: Mission, trajectory: Trajectory, waypoints: int | None = None
) -> tuple[Spec, Spec]:
    """Interfaces of both FMUs whose start values are those of a mission.

    There is room for so many waypoints, 16 by default, or for those of the mission if they are
    more.
    """
    if waypoints is not None and waypoints < len(mission.waypoints):
        raise InputError(
            f"waypoints: room for {waypoints} is less than the {len(mission.waypoints)} of the "
            "mission; ask for more, or omit it"
        )
    models = crane_parameters.models(mission.crane)
    feedforward, crane = sized(max(waypoints or WAYPOINTS, len(mission.waypoints)), models)
    changes = {
        "stop_time": ending(mission, trajectory) + mission.simulation.settle,
        "step_size": mission.simulation.step,
    }
    return (
        started(
            feedforward, feedforward_values(mission, trajectory) | limits_to_find(mission),
            **changes,
        ),
        models.held(started(crane, crane_values(mission), **changes)),
    )


def ending(mission: Mission, trajectory: Trajectory) -> float:
    """Time at which the motion ends [s]: it begins when the longest dead time has passed."""
    drives = (mission.crane.bridge, mission.crane.trolley, mission.crane.hoist)
    return trajectory.duration + max(drive.dead_time or 0.0 for drive in drives)


def arrival(
    mission: Mission, trajectory: Trajectory, recording: Recording | None = None
) -> float:
    """Time from which on the load is to be at rest [s]: not before the last row of a recording."""
    return max(ending(mission, trajectory), 0.0 if recording is None else recording.end)


def feedforward_values(mission: Mission, trajectory: Trajectory) -> dict[str, float | str]:
    """Parameters of the planner: the arguments of the mission's trajectory.

    Free waypoint states, and limits scaled for the actuators, come from the trajectory. What the
    crane file says of the drives as well is that of the crane that is planned for; their bounds
    are those that the mission tightens.
    """
    known = crane_parameters.models(mission.crane).planner(WAYPOINTS).references
    own = crane_parameters.parameters(mission.crane) | crane_parameters.brakes(mission.crane)
    values = {n: v for n, v in own.items() if n in known}
    values |= limit_values(trajectory.limits)
    bounds = (mission.build_bounds() or ActuatorBounds()).record.tolist()
    values |= {name: bounds[place] for place, name, _ in DriveBounds.feeds()}
    values |= space_values(mission.build_clearance())
    values["waypoint.count"] = len(trajectory.waypoints)
    for i, point in enumerate(trajectory.waypoints, 1):
        for quantity in QUANTITIES:
            for axis, number in zip(AXES, getattr(point, quantity), strict=True):
                values[f"waypoint[{i}].{quantity}.{axis}"] = float(number)
        values |= {f"waypoint[{i}].{state}_free.{axis}": False for state in FREE for axis in AXES}
        values[f"waypoint[{i}].dwell"] = point.dwell
    values["planner.smoothness"] = mission.smoothness
    values["planner.shape"] = mission.shape
    values["planner.synchronization"] = mission.synchronization
    values["planner.sample_time"] = mission.sample_time or 0.0
    values["planner.duration"] = mission.duration or 0.0
    return values


def limits_to_find(mission: Mission) -> dict[str, float | str]:
    """Parameters of a planner that finds the limits of the load by itself.

    So it plans what `segfmu plan` does, also after a change; what is free stays free. Without
    bounds of the drives the limits are those given.
    """
    bounds, limits = mission.build_bounds(), mission.build_limits()
    free = free_values(mission)
    if bounds is None or not bounds.known:
        return free
    none = {f"limits.{axis}.{name}": 0.0 for axis in AXES for name in (*LIMITS, *LOWER)}
    given = none if limits is None else limit_values(limits)
    return {**given, **free, "planner.finds_limits": True}


def free_values(mission: Mission) -> dict[str, float | str]:
    """Parameters of the planner for free velocities and accelerations; empty without any."""
    values: dict[str, float | str] = {}
    for i, point in enumerate(mission.build_waypoints(), 1):
        for state in FREE:
            for axis, number in zip(AXES, getattr(point, state), strict=True):
                if np.isnan(number):
                    values[f"waypoint[{i}].{state}.{axis}"] = 0.0
                    values[f"waypoint[{i}].{state}_free.{axis}"] = True
    return values


def limit_values(limits: Limits) -> dict[str, float]:
    """Parameters of the planner for limits of the load, 0 where there are none."""
    table = limits.table(len(AXES), len(LIMITS))
    lower = limits.lower(len(AXES))
    least = np.where(lower == table[:, :2], 0.0, -lower)
    rows = zip(AXES, np.hstack([table[:, : len(LIMITS)], least]).tolist(), strict=True)
    return {
        f"limits.{axis}.{name}": value
        for axis, row in rows for name, value in zip((*LIMITS, *LOWER), row, strict=True)
    }


def space_values(clearance: Clearance) -> dict[str, float]:
    """Parameters of the planner for workspace, obstacles and the size of the load.

    Raises
    ------
    InputError
        For more obstacles than there is room for.
    """
    most, obstacles = SpaceLimits.OBSTACLES, clearance.obstacles
    if len(obstacles) > most:
        raise InputError(
            f"obstacles: the planner's FMU has room for {most}, the mission has {len(obstacles)}; "
            "join those that are close to each other, or drop those out of reach"
        )
    vectors = {
        "workspace.{}.min": np.maximum(clearance.minimum, -FAR),
        "workspace.{}.max": np.minimum(clearance.maximum, FAR),
        "load.size.{}": clearance.load_size, "load.centre.{}": clearance.load_centre,
    }
    values: dict[str, float] = {"obstacle.count": len(obstacles)}
    for i, box in enumerate(obstacles, 1):
        name = f"obstacle[{i}]"
        vectors |= {f"{name}.minimum.{{}}": box.minimum, f"{name}.maximum.{{}}": box.maximum}
        values |= {f"{name}.margin": box.margin, f"{name}.rope": box.rope}
    for name, vector in vectors.items():
        values |= {name.format(a): v for a, v in zip(AXES, vector.tolist(), strict=True)}
    return values


def crane_values(mission: Mission) -> dict[str, float | str]:
    """Parameters and start values of the crane's FMU: the load hangs at the first waypoint.

    The crane is the true one; the feedback is designed for load and sling of the nominal one. The
    rope is as planned, so on another sling the load hangs higher or lower. An initial sway leaves
    rope and sling in one line.
    """
    values, model = crane_parameters.parameters(mission.simulated), model_of(mission.crane)
    if mission.true_crane is not None:
        values["feedback.payload_mass"] = mission.crane.payload_mass
        values |= model.designed(table_of(model, mission.crane))
    x, y, z = mission.waypoints[0].position
    sway = dict(zip("xy", map(radians, mission.simulation.initial_sway), strict=True))
    values |= {
        "bridge.position": x,
        "trolley.position": y,
        "rope.length": -z - mission.build_crane().tackle[1],
    }
    for name in ("sway", *model.links):
        values |= {f"{name}.{axis}.angle": angle for axis, angle in sway.items()}
    chosen = {
        "drive.mode": mission.simulation.drive,
        "feedback.enabled": mission.simulation.feedback,
        "feedback.source": mission.simulation.feedback_source,
    }
    return values | {n: v for n, v in chosen.items() if v is not None}


def recorded(mission: Mission, recording: Recording) -> list[Change]:
    """What a recording changes in the FMUs of a mission, which there need not be yet.

    Raises
    ------
    InputError
        For a column that is no variable of theirs, or one that cannot change during a run, and a
        value that its variable does not take.
    """
    models = crane_parameters.models(mission.crane)
    interfaces = sized(max(WAYPOINTS, len(mission.waypoints)), models)
    variables = {spec.name: {v.name: v for v in spec.variables} for spec in interfaces}
    connected = {(models.crane, name) for name in models.shared}
    changes = list(recording.changes(variables))
    for change in changes:
        own = variables[change.fmu]
        try:
            require_changeable(change, own, connected)
            for name, value in change.values.items():
                told, domain = f"{change.fmu}: {name}", _domain(own[name])
                domain.number(told, value)
                domain.require_within(told, value)
        except InputError as error:
            raise InputError(f"{change.origin}: {error}") from None
    return changes


@cache
def _domain(variable: Variable) -> Domain:
    items = () if variable.enumeration is None else variable.enumeration.items
    least = variable.minimum if variable.minimum is not None else 1 if items else -inf
    most = variable.maximum if variable.maximum is not None else len(items) or inf
    return Domain(KINDS[variable.kind], least, most, {n: i for i, n in enumerate(items, 1)})


def run(
    mission: Mission,
    feedforward: Path,
    crane: Path,
    trajectory: Trajectory,
    until: float,
    progress: Callable[[float], None] = lambda _: None,
    changes: Sequence[Change] = (),
) -> NDArray[np.void]:
    """Co-simulate a mission until a time [s] and its settling time.

    Where changes are commands, the planner follows them.
    """
    commanded = any(name.startswith(COMMANDS) for c in changes for name in c.values)
    enabled = {"command.enabled": True} if commanded else {}
    return simulate(
        feedforward,
        crane,
        stop_time=until + mission.simulation.settle,
        step=mission.simulation.step,
        source_values=feedforward_values(mission, trajectory) | enabled,
        # weights are those of the build
        sink_values={
            n: v for n, v in crane_values(mission).items() if not n.startswith(AT_BUILD)
        },
        changes=changes,
        progress=progress,
    )
