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
        plan_actuated,
    )
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
        replan,
        stop,
    )
    from segfmu.planning.verify import Verification, verify

    __version__: str

__all__ = [
    "ActuatedPlan",
    "ActuatorBounds",
    "BoundUse",
    "BuildError",
    "Clearance",
    "Crane",
    "Excursion",
    "FlatInverse",
    "InfeasibleError",
    "InputError",
    "Limits",
    "Obstacle",
    "SegfmuError",
    "SimulationError",
    "Trajectory",
    "Verification",
    "Waypoint",
    "__version__",
    "excursions",
    "plan",
    "plan_actuated",
    "reach_velocity",
    "replan",
    "stop",
    "verify",
]

_HOMES = {
    "segfmu.crane": (
        "ActuatedPlan", "ActuatorBounds", "BoundUse", "Crane", "FlatInverse", "plan_actuated",
    ),
    "segfmu.errors": (
        "BuildError", "InfeasibleError", "InputError", "SegfmuError", "SimulationError",
    ),
    "segfmu.planning": (
        "Clearance", "Excursion", "Limits", "Obstacle", "Trajectory", "Waypoint", "excursions",
        "plan", "reach_velocity", "replan", "stop",
    ),
    "segfmu.planning.verify": ("Verification", "verify"),
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
    return sorted({*globals(), *__all__})
