"""Plans that a crane's drives can follow: limits scaled until all bounds of the drives hold.

Scaling the limit c_i of the i-th derivative by lambda^i scales time by 1 / lambda (section 3.2), so
one number slows a plan down. The result is the largest lambda up to 1 at which drive forces,
velocities, accelerations and sway angles of the flat inverse keep their bounds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from segfmu.crane.inverse import ANGLE, DRIVE_ACCELERATION, FORCE, VELOCITY, FlatInverse
from segfmu.crane.parameters import Crane
from segfmu.errors import InfeasibleError, InputError
from segfmu.planning.arrays import FloatArray, limit_values
from segfmu.planning.limits import NAMES, Limits
from segfmu.planning.planner import plan
from segfmu.planning.trajectory import Trajectory
from segfmu.planning.waypoint import Waypoint

DRIVES = ("bridge", "trolley", "hoist")
QUANTITIES = ("force", "velocity", "acceleration", "sway_angle")
UNITS = ("N", "m/s", "m/s2", "rad")
# index of the first sway angle among the bounds
ANGLES = 3 * len(DRIVES)
SAMPLES = 1501
SLOWEST = 1e-3
RESOLUTION = 1e-4
TOLERANCE = 1e-9


@dataclass(frozen=True, eq=False)
class ActuatorBounds:
    """Bounds of a crane's drives, the same in both directions.

    Parameters
    ----------
    force, velocity, acceleration : array_like, scalar or shape (3,), optional
        Of bridge, trolley and hoist [N], [m/s], [m/s2]; None or infinity for no bound.
    sway_angle : array_like, scalar or shape (2,), optional
        Of the rope about both axes [rad].

    Raises
    ------
    InputError
        For values that are not positive and for other shapes.
    """

    force: FloatArray
    velocity: FloatArray
    acceleration: FloatArray
    sway_angle: FloatArray

    def __init__(
        self,
        force: ArrayLike | None = None,
        velocity: ArrayLike | None = None,
        acceleration: ArrayLike | None = None,
        sway_angle: ArrayLike | None = None,
    ) -> None:
        given = (force, velocity, acceleration, sway_angle)
        for name, value in zip(QUANTITIES, given, strict=True):
            size = 2 if name == "sway_angle" else 3
            values = limit_values(name, value, required=False)
            if values.ndim == 1 and values.size not in (1, size):
                raise InputError(f"{name} has {values.size} values; give one, or {size}")
            bounds = np.where(values > 0.0, values, np.inf)
            object.__setattr__(self, name, np.broadcast_to(bounds, (size,)))

    @property
    def vector(self) -> FloatArray:
        """All bounds, shape (11,)."""
        return np.concatenate([getattr(self, name) for name in QUANTITIES])


@dataclass(frozen=True, eq=False)
class ActuatedPlan:
    """A trajectory within the bounds, and its active bound.

    Attributes
    ----------
    trajectory : Trajectory
    scale : float
        lambda; the plan's limits are lambda^i c_i.
    active : str or None
        The active bound, such as "trolley force"; None if only the limits are active.
    usage : ndarray, shape (11,)
        Peaks over bounds of forces, velocities, accelerations (bridge, trolley, hoist) and of the
        two sway angles.
    """

    trajectory: Trajectory
    scale: float
    active: str | None
    usage: FloatArray


def plan_actuated(
    crane: Crane,
    waypoints: Sequence[Waypoint],
    limits: Limits,
    bounds: ActuatorBounds,
    **options: Any,
) -> ActuatedPlan:
    """Plan the load's trajectory within limits and within the bounds of the crane's drives.

    Parameters
    ----------
    crane : Crane
    waypoints, limits
        As for `plan`, of the axes x, y, z.
    bounds : ActuatorBounds
    **options
        Those of `plan`.

    Raises
    ------
    InputError, InfeasibleError
        As `plan` and `FlatInverse`; InfeasibleError also if no slower plan keeps the bounds. It
        names the bound, the value that the slowest plan needs, and the time.
    """
    if not isinstance(bounds, ActuatorBounds):
        raise InputError(f"bounds must be an ActuatorBounds, got {type(bounds).__name__}")
    fastest = _attempt(crane, waypoints, limits, bounds, 1.0, options)
    if fastest.usage.max() <= 1.0 + TOLERANCE:
        return fastest
    found = _slower(crane, waypoints, limits, bounds, options, fastest)
    inside, outside = found.scale, found.scale / 0.9
    while outside - inside > RESOLUTION * inside:
        scale = 0.5 * (inside + outside)
        try:
            attempt = _attempt(crane, waypoints, limits, bounds, scale, options)
        except InfeasibleError:
            break
        if attempt.usage.max() <= 1.0 + TOLERANCE:
            found, inside = attempt, scale
        else:
            outside = scale
    worst = int(found.usage.argmax())
    return ActuatedPlan(found.trajectory, found.scale, _name(worst), found.usage)


def _slower(
    crane: Crane,
    waypoints: Sequence[Waypoint],
    limits: Limits,
    bounds: ActuatorBounds,
    options: dict[str, Any],
    fastest: ActuatedPlan,
) -> ActuatedPlan:
    """The first plan within the bounds, slowed down by 10 % at a time."""
    last, scale = fastest, 1.0
    while scale > SLOWEST:
        scale *= 0.9
        try:
            last = _attempt(crane, waypoints, limits, bounds, scale, options)
        except InfeasibleError as error:
            raise _unmet(crane, bounds, last, f"slower plans are infeasible: {error}") from None
        if last.usage.max() <= 1.0 + TOLERANCE:
            return last
    raise _unmet(crane, bounds, last, "no slower plan needs less")


def _attempt(
    crane: Crane,
    waypoints: Sequence[Waypoint],
    limits: Limits,
    bounds: ActuatorBounds,
    scale: float,
    options: dict[str, Any],
) -> ActuatedPlan:
    trajectory = plan(waypoints, scaled(limits, scale), **options)
    peaks, _ = _peaks(FlatInverse(crane, trajectory), bounds.vector)
    return ActuatedPlan(trajectory, scale, None, peaks / bounds.vector)


def scaled(limits: Limits, scale: float) -> Limits:
    """Limits lambda^i c_i."""
    values = (getattr(limits, name) for name in NAMES)
    return Limits(
        *(np.where(c > 0.0, c * scale ** (i + 1), np.inf) for i, c in enumerate(values))
    )


def _quantities(inverse: FlatInverse, times: FloatArray) -> FloatArray:
    """Magnitudes in the order of `ActuatorBounds.vector`, shape (times, 11)."""
    values = inverse.evaluate(times)
    columns = [values[:, places] for places in (FORCE, VELOCITY, DRIVE_ACCELERATION, ANGLE)]
    return np.abs(np.concatenate(columns, axis=1))


def _peaks(inverse: FlatInverse, bounds: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Peak of every quantity and its time; refined if it is near its bound."""
    end = inverse.trajectory.duration
    times = np.linspace(0.0, end, SAMPLES)
    # imported late: it loads SciPy's _uarray, which frees memory twice when an embedded interpreter
    # ends, as that of an FMU on PythonFMU does
    from scipy.optimize import minimize_scalar

    values = _quantities(inverse, times)
    at = values.argmax(axis=0)
    peaks, moments = values[at, np.arange(at.size)], times[at]
    for i in np.flatnonzero(peaks > 0.8 * bounds):
        low, high = times[max(at[i] - 1, 0)], times[min(at[i] + 1, SAMPLES - 1)]
        if high > low:
            best = minimize_scalar(
                lambda t, i=i: -float(_quantities(inverse, np.array([t]))[0, i]),
                bounds=(low, high), method="bounded", options={"xatol": 1e-7 * max(end, 1.0)},
            )
            if -best.fun > peaks[i]:
                peaks[i], moments[i] = -best.fun, best.x
    return peaks, moments


def _name(index: int) -> str:
    angle = index - ANGLES
    if angle >= 0:
        return f"sway angle {'xy'[angle]}"
    return f"{DRIVES[index % 3]} {QUANTITIES[index // 3]}"


def _unmet(
    crane: Crane, bounds: ActuatorBounds, last: ActuatedPlan, reason: str
) -> InfeasibleError:
    peaks, moments = _peaks(FlatInverse(crane, last.trajectory), bounds.vector)
    worst = int((peaks / bounds.vector).argmax())
    value, bound = float(peaks[worst]), float(bounds.vector[worst])
    unit = UNITS[min(worst // 3, 3)]
    return InfeasibleError(
        f"{_name(worst)} needs {value:.6g} {unit} at {float(moments[worst]):.3f} s, the bound is "
        f"{bound:.6g} {unit}; {reason}; raise the bound or lower the waypoints' velocities",
        limit=_name(worst), value=value, bound=bound, time=float(moments[worst]),
    )
