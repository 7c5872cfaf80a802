"""The exceptions of segfmu.

    SegfmuError
    ├── InputError        an invalid value (type, range, shape, key)
    ├── InfeasibleError   a plan that breaks limits of the load, the crane or the rope
    ├── BuildError        an FMU that cannot be built (compiler, template, archive)
    └── SimulationError   a co-simulation that an FMU or the master stopped

Every message is one line: what is wrong, where (axis, waypoint interval), the value, the
limit, and the way out.
"""

from __future__ import annotations

from collections.abc import Collection
from difflib import get_close_matches


class SegfmuError(Exception):
    """Base of all errors of segfmu that its users can act on."""


class InputError(SegfmuError, ValueError):
    """An invalid value: wrong type, shape, range or key."""


class InfeasibleError(SegfmuError):
    """A plan that breaks limits of the load, the crane or the rope.

    Attributes
    ----------
    axis : int or None
        Index of the axis, from 0.
    interval : int or None
        Waypoint interval, from 1 (1 lies between waypoints 1 and 2).
    limit : str or None
        Name of the limit, for example ``"velocity"``.
    value, bound : float or None
        Required and allowed value, SI units.
    time : float or None
        Time of the violation [s], if there is one.
    """

    def __init__(
        self,
        message: str,
        *,
        axis: int | None = None,
        interval: int | None = None,
        limit: str | None = None,
        value: float | None = None,
        bound: float | None = None,
        time: float | None = None,
    ) -> None:
        super().__init__(message)
        self.axis = axis
        self.interval = interval
        self.limit = limit
        self.value = value
        self.bound = bound
        self.time = time


class BuildError(SegfmuError):
    """An FMU that cannot be built."""


class SimulationError(SegfmuError):
    """A co-simulation that an FMU or the master stopped."""


def first_line(error: BaseException) -> str:
    """What an error of another package says, in one line; its type where it says nothing."""
    return next(iter(str(error).splitlines()), type(error).__name__)


def meant(name: object, known: Collection[str]) -> str:
    """The end of a message on a name that is unknown: one that may be meant; empty if none is."""
    near = get_close_matches(str(name), list(known), n=1)
    return f"; did you mean {near[0]}?" if near else ""


def no_variable(name: str, known: Collection[str]) -> InputError:
    """The error of a variable that a run does not have, with one that may be meant."""
    return InputError(f"no variable {name} in the run{meant(name, known)}")
