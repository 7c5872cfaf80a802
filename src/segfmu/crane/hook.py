"""A crane whose load hangs by a sling on a hook: a double pendulum."""

from __future__ import annotations

from dataclasses import dataclass

from segfmu.crane.checks import require_quantity
from segfmu.crane.parameters import CRANE, Crane
from segfmu.crane.variables import Value, build, fed, values
from segfmu.errors import InputError
from segfmu.kernels.hook.records import HookMasses


@dataclass(frozen=True)
class HookCrane:
    """A gantry crane with a hook on its rope, from which the load hangs by a sling.

    Hook and load are points; rope and sling have no mass. The angles of the sling have the
    convention of those of the rope, both against the vertical.

    Parameters
    ----------
    crane : Crane
        Carriages, load, gravity, and range of the rope from trolley to hook.
    hook_mass : float
        Mass of the hook [kg], positive.
    sling : float
        Length of the sling, from hook to load [m], positive.

    Raises
    ------
    InputError
        For a mass and a length that are not from 1e-9 to 1e9.
    """

    crane: Crane
    hook_mass: float
    sling: float

    def __post_init__(self) -> None:
        if not isinstance(self.crane, Crane):
            raise InputError(f"crane must be a segfmu.Crane, got {type(self.crane).__name__}")
        for name in HOOK:
            require_quantity(name, getattr(self, name))
            object.__setattr__(self, name, float(getattr(self, name)))

    @property
    def masses(self) -> tuple[float, ...]:
        """The kernels' `HookMasses`: masses [kg], gravity [m/s2], the sling's length [m]."""
        return *self.crane.masses, self.hook_mass, self.sling

    def values(self) -> dict[str, float]:
        """As FMU variables; a rope bound of 0 means none."""
        return values(self.crane, CRANE) | values(self, HOOK)

    @classmethod
    def of(cls, value: Value) -> HookCrane:
        """The crane that variables of an FMU describe; `value` gives them by name."""
        return cls(Crane.of(value), **build(dict, HOOK, value))


# variables of the fields
HOOK = {"hook_mass": fed(HookMasses, "HOOK_MASS"), "sling": fed(HookMasses, "SLING")}
