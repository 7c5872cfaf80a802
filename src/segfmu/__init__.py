"""segfmu: plan a crane load's trajectory analytically, invert the crane exactly, ship both as FMUs.

See README.md for a tour. Importing this package loads neither SymPy, fmpy, pythonfmu nor
Matplotlib.
"""

from importlib.metadata import version

from segfmu.crane import ActuatedPlan, ActuatorBounds, Crane, FlatInverse, plan_actuated
from segfmu.errors import (
    BuildError,
    InfeasibleError,
    InputError,
    SegfmuError,
    SimulationError,
)
from segfmu.planning import Limits, Trajectory, Waypoint, plan
from segfmu.planning.verify import Verification, verify

__all__ = [
    "ActuatedPlan",
    "ActuatorBounds",
    "BuildError",
    "Crane",
    "FlatInverse",
    "InfeasibleError",
    "InputError",
    "Limits",
    "SegfmuError",
    "SimulationError",
    "Trajectory",
    "Verification",
    "Waypoint",
    "__version__",
    "plan",
    "plan_actuated",
    "verify",
]

__version__ = version("segfmu")
