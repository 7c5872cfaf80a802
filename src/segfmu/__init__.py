"""segfmu: plan a crane load's trajectory analytically, invert the crane exactly, ship both as FMUs.

See README.md for a tour. Importing this package loads nothing else; a public name loads what it
needs at its first use, which is neither SymPy, fmpy, pythonfmu nor Matplotlib.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from segfmu.crane import (
        ActuatedPlan,
        ActuatorBounds,
        BoundUse,
        Crane,
        FlatInverse,
        Operator,
        plan_actuated,
    )
    from segfmu.crane.hook import HookCrane
    from segfmu.errors import (
        BuildError,
        InfeasibleError,
        InputError,
        SegfmuError,
        SimulationError,
    )
    from segfmu.planning import (
        Clearance,
        Excursion,
        Limits,
        Obstacle,
        Trajectory,
        Waypoint,
        excursions,
        plan,
        reach_velocity,
        read_waypoints,
        replan,
        stop,
    )
    from segfmu.planning.verify import Verification, verify
    from segfmu.validation.archives import Archives, build
    from segfmu.validation.campaigns.call import campaign
    from segfmu.validation.campaigns.result import CampaignResult, load_result
    from segfmu.validation.files.mission import Mission
    from segfmu.validation.files.mission_file import load_mission
    from segfmu.validation.identification.identify import identify
    from segfmu.validation.identification.result import Identification
    from segfmu.validation.live.page import live
    from segfmu.validation.runs import Run, simulate
    from segfmu.validation.suites import Suite, validate

    __version__: str

__all__ = [
    "ActuatedPlan",
    "ActuatorBounds",
    "Archives",
    "BoundUse",
    "BuildError",
    "CampaignResult",
    "Clearance",
    "Crane",
    "Excursion",
    "FlatInverse",
    "HookCrane",
    "Identification",
    "InfeasibleError",
    "InputError",
    "Limits",
    "Mission",
    "Obstacle",
    "Operator",
    "Run",
    "SegfmuError",
    "SimulationError",
    "Suite",
    "Trajectory",
    "Verification",
    "Waypoint",
    "__version__",
    "build",
    "campaign",
    "excursions",
    "identify",
    "live",
    "load_mission",
    "load_result",
    "plan",
    "plan_actuated",
    "reach_velocity",
    "read_waypoints",
    "replan",
    "simulate",
    "stop",
    "validate",
    "verify",
]

_HOMES = {
    "segfmu.crane": (
        "ActuatedPlan", "ActuatorBounds", "BoundUse", "Crane", "FlatInverse", "Operator",
        "plan_actuated",
    ),
    "segfmu.crane.hook": ("HookCrane",),
    "segfmu.errors": (
        "BuildError", "InfeasibleError", "InputError", "SegfmuError", "SimulationError",
    ),
    "segfmu.planning": (
        "Clearance", "Excursion", "Limits", "Obstacle", "Trajectory", "Waypoint", "excursions",
        "plan", "reach_velocity", "read_waypoints", "replan", "stop",
    ),
    "segfmu.planning.verify": ("Verification", "verify"),
    "segfmu.validation.archives": ("Archives", "build"),
    "segfmu.validation.campaigns.call": ("campaign",),
    "segfmu.validation.campaigns.result": ("CampaignResult", "load_result"),
    "segfmu.validation.files.mission": ("Mission",),
    "segfmu.validation.files.mission_file": ("load_mission",),
    "segfmu.validation.identification.identify": ("identify",),
    "segfmu.validation.identification.result": ("Identification",),
    "segfmu.validation.live.page": ("live",),
    "segfmu.validation.runs": ("Run", "simulate"),
    "segfmu.validation.suites": ("Suite", "validate"),
}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        value: Any = import_module("importlib.metadata").version("segfmu")
    else:
        home = next((h for h, names in _HOMES.items() if name in names), None)
        if home is None:
            raise AttributeError(f"module 'segfmu' has no attribute {name!r}")
        value = getattr(import_module(home), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return list(__all__)
