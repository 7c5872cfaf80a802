"""The exceptions of segfmu.

    SegfmuError
    ├── InputError        a value that no computation can accept (type, range, shape, key)
    ├── InfeasibleError   a plan that the limits, the crane or the rope do not admit
    ├── BuildError        an FMU that cannot be built (compiler, template, archive)
    └── SimulationError   a co-simulation that an FMU or the master had to stop

Every message is one line: what is wrong, where (axis, waypoint interval), the value, the
limit, and the way out.
"""

from __future__ import annotations


class SegfmuError(Exception):
    """Base of every error that segfmu raises for a reason its user can act on."""


class InputError(SegfmuError, ValueError):
    """A value that no computation can accept: wrong type, shape, range or key."""


class InfeasibleError(SegfmuError):
    """A plan that the limits, the crane or the rope do not admit.

    Attributes
    ----------
    axis : int or None
        Index of the axis, from 0.
    interval : int or None
        Waypoint interval, from 1 (1 lies between waypoints 1 and 2).
    limit : str or None
        Name of the limit, for example ``"velocity"``.
    value, bound : float or None
        What would be needed and what is allowed, SI units.
    time : float or None
        Time of the violation [s], where one exists.
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
    """A co-simulation that an FMU or the master had to stop."""
