"""A crane whose load hangs by a sling on a hook: a double pendulum."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from segfmu.arrays import FloatArray, sized
from segfmu.crane.checks import require_positive, require_quantity
from segfmu.crane.parameters import CRANE, Crane
from segfmu.crane.variables import Value, build, fed, of_values, values
from segfmu.errors import InputError
from segfmu.kernels import backend
from segfmu.kernels.hook.records import (
    HookFrequencies,
    HookLinks,
    HookMasses,
    HookModel,
    HookMotion,
    HookState,
    HookTension,
)


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

    @property
    def suspension(self) -> int:
        """The kernels' code of a hook between rope and load."""
        return HookModel.CODE

    @property
    def tackle(self) -> tuple[float, float]:
        """Mass of the hook [kg] and length of its sling [m], between rope and load."""
        return self.hook_mass, self.sling

    @property
    def gravity(self) -> float:
        """[m/s2], as of a `Crane`."""
        return self.crane.gravity

    @property
    def weight(self) -> float:
        """Of hook and load [N]."""
        return self.crane.weight + self.hook_mass * self.gravity

    def frequencies(self, rope: float) -> FloatArray:
        """Both natural frequencies [rad/s] of small swings, the slower one first, shape (2,).

        The carriages rest, and `rope` [m] leads from trolley to hook.

        Raises
        ------
        InputError
            For a length that is not positive.
        """
        require_positive("rope", rope)
        found = np.zeros(HookFrequencies.SIZE)
        backend.hook_frequencies(float(rope), np.array(self.masses), found)
        return found

    def load_motion(self, state: ArrayLike, tension: ArrayLike) -> FloatArray:
        """Position of the load and three derivatives in a state, shape (4, 3).

        The inverse of `FlatInverse`, as far as a state determines the load's path: higher
        derivatives depend on what the drives do next.

        Parameters
        ----------
        state : array_like, shape (14,)
            x_t, y_t, l, both angles of the rope and of the sling, then their rates.
        tension : array_like, shape (2,)
            Force F_l of the hoist [N], below 0, and its derivative by time [N/s].

        Raises
        ------
        InputError
            For other numbers of values, and for a rope without length.
        """
        start = sized("state", state, HookState.SIZE)
        if start[HookState.POSITION + 2] <= 0.0:
            raise InputError(
                f"state: rope length must be > 0 m, got {start[HookState.POSITION + 2]} m"
            )
        load = np.zeros((HookMotion.SIZE, HookMotion.COLUMNS))
        backend.hook_load_motion(
            start, sized("tension", tension, HookTension.SIZE), np.array(self.masses),
            np.zeros((HookLinks.SIZE, HookLinks.COLUMNS)), load,
        )
        return load

    def values(self) -> dict[str, float]:
        """As FMU variables; a rope bound of 0 means none."""
        return values(self.crane, CRANE) | values(self, HOOK)

    @classmethod
    @of_values
    def of(cls, value: Value) -> HookCrane:
        """The crane that variables of an FMU describe; `value` gives them by name."""
        return cls(Crane.of(value), **build(dict, HOOK, value))


# variables of the fields
HOOK = {"hook_mass": fed(HookMasses, "HOOK_MASS"), "sling": fed(HookMasses, "SLING")}
