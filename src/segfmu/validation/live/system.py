"""Both FMUs of a page: WebAssembly of their sources, start values, variables, and the coupling."""

from __future__ import annotations

import re
import zlib
from base64 import b64encode
from typing import Any

import numpy as np

from segfmu.arrays import FloatArray
from segfmu.crane.variables import filled
from segfmu.errors import InputError
from segfmu.fmu.gantry_crane.rig_parameters import FAR
from segfmu.fmu.models import named
from segfmu.fmu.native.archive import sources, start_values
from segfmu.fmu.native.binaries import binary
from segfmu.fmu.native.compilers import BROWSER
from segfmu.fmu.standard.identity import guid
from segfmu.fmu.standard.references import entries
from segfmu.fmu.standard.spec import Spec, started
from segfmu.kernels import backend
from segfmu.kernels.crane.records import AXES as CRANE_AXES
from segfmu.kernels.crane.records import Compensation, Resistance
from segfmu.kernels.messages import READY
from segfmu.kernels.operation.records import ReadyFault, ReadyStatus
from segfmu.planning import Limits, Trajectory
from segfmu.validation.files.keys import AXES
from segfmu.validation.files.mission import Mission
from segfmu.validation.scenario import feedforward_values, limit_values, specs

FMI = 2
# a table of the page has no row that a page sets or shows beyond the first two waypoints
HIDDEN = re.compile(r"waypoint\[(?!1\]|2\])|obstacle\[|payload\[|feedback\.table\[")
KINDS = {"Real": "Real", "Boolean": "Boolean", "Integer": "Integer", "Enumeration": "Integer"}


def interfaces(
    mission: Mission, trajectory: Trajectory, room: FloatArray, limits: Limits
) -> tuple[Spec, Spec]:
    """Native interfaces of both FMUs, for commands to a mission's load within `room`, (3, 2) [m].

    Drives follow velocities, as a joystick commands them. GantryFeedforward has limits of the load,
    so it does not search for them when the page begins anew.

    Raises
    ------
    InputError
        For a crane for which no command can be followed.
    """
    changed = {"drive": "velocity"}
    driven = mission.model_copy(
        update={"simulation": mission.simulation.model_copy(update=changed)}
    )
    feedforward, crane = specs(driven, trajectory)
    values = feedforward_values(driven, trajectory) | limit_values(limits)
    values |= {"command.enabled": True, "planner.finds_limits": False}
    for axis, (low, high) in zip(AXES, room.tolist(), strict=True):
        values |= {f"workspace.{axis}.min": low, f"workspace.{axis}.max": high}
    # the feedback's gains stay those of the mission's load when the page changes it
    fixed = {"feedback.payload_mass": mission.crane.payload_mass, **_unstopped(crane)}
    # the load is at rest whenever the page begins
    fixed |= {f"sway.{axis}.angle": 0.0 for axis in "xy"}
    own = started(feedforward, values), started(crane, fixed)
    _require_ready(own[0], int(trajectory.offsets[-1]))
    first, second = (named(spec.name).native_spec(spec) for spec in own)
    return first, second


def _unstopped(crane: Spec) -> dict[str, float]:
    """No end stops without buffers: wind and feedback would end the run at them again and again.

    The load's room is within them.
    """
    ends = (("min", -FAR), ("max", FAR))
    return {
        f"travel.{axis}.{end}": place
        for axis in CRANE_AXES if not crane.variable(f"travel.{axis}.stiffness").start
        for end, place in ends
    }


def _require_ready(feedforward: Spec, pieces: int) -> None:
    """Refuse, before the page does, a crane whose setpoints need more than its present state."""
    def value(name: str) -> Any:
        return feedforward.variable(name).start

    fault = np.zeros(ReadyFault.SIZE)
    status = backend.check_ready(
        filled(Compensation, value), filled(Resistance, value), pieces, fault
    )
    if status != ReadyStatus.READY:
        reason, _, _ = READY.text(status, fault.tolist()).partition(";")
        raise InputError(f"{reason}; for a page, leave it out")


def system(feedforward: Spec, crane: Spec, step: float) -> dict[str, Any]:
    """What system.js needs of both FMUs, as they are coupled by `segfmu.cosim.System`."""
    outputs = [v.name for v in feedforward.where("output")]
    inputs = {v.name for v in crane.where("input")}
    return {
        "step": step,
        "fmus": [_fmu(feedforward), _fmu(crane)],
        "links": [name for name in outputs if name in inputs],
        "orders": feedforward.orders,
    }


def _fmu(spec: Spec) -> dict[str, Any]:
    """One FMU: what its archive has, and value reference and type of every variable."""
    return {
        "name": spec.name,
        "guid": guid(spec),
        "start": packed(start_values(spec, FMI)),
        "code": packed(binary(spec.name, sources(spec.name, FMI), BROWSER.name)),
        "variables": {
            entry.name: [spec.references[entry.name], KINDS[entry.variable.kind]]
            for entry in entries(spec, FMI) if not HIDDEN.match(entry.name)
        },
    }


def packed(content: bytes) -> str:
    """Bytes for a page: deflated, in letters."""
    return b64encode(zlib.compress(content, 9)).decode()
